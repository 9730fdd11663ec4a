//! How far the form of the model makes each quantity wrong: factors that hold in 95 of 100 dampers.
//!
//! They are measured on dampers of the second laboratory. They are set by the calibration seeds of `cargo run --release -p dashpot-proving --example explain_other`, and checked on others
//! (docs/book/src/dimensions.md). A factor that is too small makes intervals that miss; one that is too large makes intervals that say
//! nothing.

/// Gas pressure: gas warms in the tests, and the zero of the load cell is a gas force.
pub(super) const GAS_PRESSURE: f64 = 1.15;
/// Gas volume, by a stiffness between slow and fast.
pub(super) const GAS_VOLUME: f64 = 1.6;
/// Modulus of oil and tube by the stiffness of the oil column.
pub(super) const MODULUS: f64 = 1.6;
/// Modulus by the series stiffness, which holds the eyes too.
pub(super) const SERIES_MODULUS: f64 = 1.6;
/// Stiffness of eyes under the forces of the tests: rubber hardens.
pub(super) const EYES: f64 = 2.0;
/// Air by its stroke.
pub(super) const AIR: f64 = 2.5;
/// Bleed passage by the part of the FV curve that grows with the square of the speed.
pub(super) const BLEED: f64 = 1.3;
/// Blow-off passage by what the bleed leaves of the flow at the largest force.
pub(super) const BLOW_OFF: f64 = 1.5;
/// Leak by the steepest part of the FV curve about standstill.
pub(super) const LEAK: f64 = 2.0;
