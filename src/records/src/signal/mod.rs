//! Signal processing of the channels: derivative, smoothing, noise, delay, and correction of measurement errors.

pub(crate) mod consistency;
pub(crate) mod delay;
pub(crate) mod delayed_motion;
pub(crate) mod derivative;
pub mod measurement_correction;
pub(crate) mod noise;
pub mod smoothing;
pub(crate) mod unit_slip;
