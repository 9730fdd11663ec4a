//! The records of a campaign: which files and options belong to it, how they are loaded, and groups of campaigns.

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
