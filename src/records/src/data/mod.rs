//! The stages of a test's data: samples as read, the complete motion, and the cleaned record.

pub(crate) mod complete_test;
pub(crate) mod cycle;
pub(crate) mod measurement_error;
pub mod record;
pub(crate) mod rig_frame;
pub(crate) mod samples;
pub(crate) mod setting_signal;
pub(crate) mod test_metadata;
