//! Settings of an adjustable damper: stated settings, and settings that only the forces show.

pub(crate) mod assignment;
pub(crate) mod correction;
pub(crate) mod unstated_settings;
