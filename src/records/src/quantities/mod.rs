//! Channels, units, and the quantities of a rig.

pub(crate) mod channel;
pub mod load_cell;
pub(crate) mod motion_limit;
pub(crate) mod reading;
pub(crate) mod reading_unit;
pub(crate) mod setting_rules;
pub(crate) mod setting_value;
pub(crate) mod stated_setting;
pub(crate) mod unit;
