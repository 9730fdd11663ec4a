//! Tables: the column headings, their channels and units, and the rows below them. All file formats use this module.

pub(crate) mod cell;
pub(crate) mod channel_headings;
pub(crate) mod crank;
pub mod delimiter;
pub(crate) mod heading;
pub(crate) mod layout;
pub(crate) mod non_data_lines;
pub(crate) mod table;
