//! Order of day and month in a date.

use serde::{Deserialize, Serialize};
use std::str::FromStr;

/// Order of day and month in a date that ends with the year.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DateOrder {
    /// European order: 25/11/2026.
    DayFirst,
    /// American order: 11/25/2026.
    MonthFirst,
}

impl DateOrder {
    /// Returns the name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            DateOrder::DayFirst => "day-first",
            DateOrder::MonthFirst => "month-first",
        }
    }
}

impl FromStr for DateOrder {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim().to_ascii_lowercase().replace('_', "-").as_str() {
            "day-first" => Ok(DateOrder::DayFirst),
            "month-first" => Ok(DateOrder::MonthFirst),
            _ => Err(format!("'{text}' should be day-first or month-first")),
        }
    }
}
