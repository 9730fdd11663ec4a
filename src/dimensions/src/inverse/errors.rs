//! Error factor of each quantity due to the form of the model. In 95 of 100 dampers, the error is within the factor.
//!
//! The factors were measured on dampers that follow laws of the literature (crate `other_lab`). The command was `cargo
//! run --release -p dashpot-proving --example explain_other` with its calibration seeds. Other seeds checked the
//! factors (docs/book/src/dimensions.md). If a factor is too small, intervals do not contain the true value. If it is
//! too large, the intervals are useless.

/// Error factor of the gas pressure. The gas becomes warmer in the tests, and a zero offset of the load cell acts like
/// a gas force.
pub(super) const GAS_PRESSURE: f64 = 1.15;
/// Error factor of the gas volume, because the fitted gas stiffness is between the slow and the fast stiffness.
pub(super) const GAS_VOLUME: f64 = 1.6;
/// Error factor of the modulus of oil and tube, computed from the stiffness of the oil column.
pub(super) const MODULUS: f64 = 1.6;
/// Error factor of the modulus, computed from the series stiffness, which includes the eyes.
pub(super) const SERIES_MODULUS: f64 = 1.6;
/// Error factor of the stiffness of eyes under the forces of the tests, because rubber hardens.
pub(super) const EYES: f64 = 2.0;
/// Error factor of the air content, computed from the stroke of the aeration element.
pub(super) const AIR: f64 = 2.5;
/// Error factor of the bleed passage, computed from the quadratic part of the FV curve.
pub(super) const BLEED: f64 = 1.3;
/// Error factor of the blow-off passage, computed from the flow at the largest force minus the flow through the bleed.
pub(super) const BLOW_OFF: f64 = 1.5;
/// Error factor of the leak, computed from the steepest part of the FV curve near zero velocity.
pub(super) const LEAK: f64 = 2.0;
