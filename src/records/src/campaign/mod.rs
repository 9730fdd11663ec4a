//! Campaigns of records: their files and options, their loading, and groups of campaigns.

pub(crate) mod common_clock;
mod date_agreement;
mod file_search;
mod group_list;
pub mod groups;
pub mod hold_out;
pub(crate) mod imposed_motion;
pub(crate) mod loading;
pub(crate) mod motion_setting;
pub mod profile;
mod record_file;
pub(crate) mod rig_sign;
pub(crate) mod unusable;
