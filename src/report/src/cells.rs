//! Cells of tables: the text that a page shows, with the number behind it, which a workbook takes in full.

use super::numbers::{self, digits};
use crate::words::Words;
use dashpot_records::reading_unit;

/// A cell of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// What the page shows.
    pub text: String,
    /// What a workbook counts with.
    pub value: Value,
}

/// What stands behind the text of a cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// Nothing but the text.
    Words,
    /// A number in the unit of the heading.
    Number(f64),
    /// A number in a unit of its own, where the rows of a column have different ones.
    Measured(f64, String),
    /// The ends of an interval, in the unit of the heading or in one of their own.
    Between([f64; 2], String),
}

impl Cell {
    /// A number, written as `write` does.
    pub fn number(value: f64, write: impl Fn(f64) -> String) -> Self {
        Self { text: write(value), value: Value::Number(value) }
    }

    /// A number to so many significant digits.
    pub fn digits(value: f64, significant: i32) -> Self {
        Self::number(value, |v| digits(v, significant))
    }

    /// A count.
    pub fn count(value: usize) -> Self {
        Self { text: value.to_string(), value: Value::Number(value as f64) }
    }

    /// A displacement in mm or a velocity in mm/s from SI.
    pub fn milli(si: f64) -> Self {
        Self { text: numbers::milli(si), value: Value::Number(1e3 * si) }
    }

    /// A fraction, in percent.
    pub fn fraction(value: f64) -> Self {
        Self { text: numbers::fraction(value), value: Value::Measured(100.0 * value, "%".into()) }
    }

    /// A value in the unit that engineers use for it.
    pub fn measured(value: f64, unit: &str) -> Self {
        let (factor, usual) = reading_unit(value, unit);
        Self { text: numbers::with_unit(value, unit), value: Value::Measured(factor * value, usual) }
    }

    /// A value and the ends of its interval, in one unit.
    pub fn with_interval(value: f64, low: f64, high: f64, unit: &str, words: &Words) -> [Self; 2] {
        let (factor, usual) = reading_unit(value, unit);
        let (text, ends) = numbers::with_interval(value, low, high, unit, words);
        [
            Self { text, value: Value::Measured(factor * value, usual.clone()) },
            Self { text: ends, value: Value::Between([factor * low, factor * high], usual) },
        ]
    }

    /// The ends of a span in the unit of the heading.
    pub fn span(ends: [f64; 2], write: impl Fn(f64) -> String) -> Self {
        let text = format!("{} … {}", write(ends[0]), write(ends[1]));
        Self { text, value: Value::Between(ends, String::new()) }
    }

    /// What stands where there is no number.
    pub fn none() -> Self {
        Self::from("–")
    }

    /// A number where there is one.
    pub fn known(value: Option<f64>, cell: impl Fn(f64) -> Cell) -> Self {
        value.map_or_else(Self::none, cell)
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self { text, value: Value::Words }
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}
