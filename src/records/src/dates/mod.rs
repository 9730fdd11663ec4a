//! Dates and times of day in the files.

pub mod clock;
pub(crate) mod date_order;
pub(crate) mod file_dates;
