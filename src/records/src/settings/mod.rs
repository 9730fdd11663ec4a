//! Settings of an adjustable damper: those that the tests state, and those that their forces show.

pub(crate) mod assignment;
pub(crate) mod unstated_settings;
