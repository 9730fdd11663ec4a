//! Cells of tables: the text that a page shows and the full number that a workbook stores.

use super::numbers::{self, digits};
use crate::words::Words;
use dashpot_records::{Reading, reading_unit};

/// A cell of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// Text on the page.
    pub text: String,
    /// Value in the workbook.
    pub value: Value,
}

/// Value that a workbook stores for a cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// No value: the cell has only its text.
    Words,
    /// A number in the unit that the heading of the column states.
    Number(f64),
    /// A number with its own unit, in a column whose rows have different units.
    Measured(f64, String),
    /// Lower and upper end of an interval, and their unit. An empty unit means the unit of the column heading.
    Between([f64; 2], String),
}

impl Cell {
    /// Creates a cell from a number, formatted by `write`.
    pub fn number(value: f64, write: impl Fn(f64) -> String) -> Self {
        Self { text: write(value), value: Value::Number(value) }
    }

    /// Creates a cell from a number with `significant` digits.
    pub fn digits(value: f64, significant: i32) -> Self {
        Self::number(value, |v| digits(v, significant))
    }

    /// Creates a cell from a count.
    pub fn count(value: usize) -> Self {
        Self { text: value.to_string(), value: Value::Number(value as f64) }
    }

    /// Creates a cell from a displacement, m, or a velocity, m/s. The cell shows mm or mm/s.
    pub fn milli(si: f64) -> Self {
        Self { text: numbers::milli(si), value: Value::Number(1e3 * si) }
    }

    /// Creates a cell from a fraction. The cell shows percent.
    pub fn fraction(value: f64) -> Self {
        Self { text: numbers::fraction(value), value: Value::Measured(100.0 * value, "%".into()) }
    }

    /// Creates a cell from a value in the SI unit `unit`. The cell shows the unit that engineers use for the quantity,
    /// such as mm.
    pub fn measured(value: f64, unit: &str) -> Self {
        let (factor, usual) = reading_unit(value, unit);
        Self { text: numbers::with_unit(value, unit), value: Value::Measured(factor * value, usual) }
    }

    /// Creates two cells from a value and the ends of its interval in the SI unit `unit`. Both cells show one unit.
    pub fn with_interval(value: f64, low: f64, high: f64, unit: &str, words: &Words) -> [Self; 2] {
        let (factor, _) = reading_unit(value, unit);
        let numbers = [value, low, high].map(|number| factor * number);
        Self::of_reading(numbers, &Reading::new(value, low, high, unit), words)
    }

    /// Creates two cells from a reading: its value, and the ends of its interval. The first argument contains the unrounded value and ends
    /// in the unit of the reading.
    pub fn of_reading([value, low, high]: [f64; 3], reading: &Reading, words: &Words) -> [Self; 2] {
        let (text, ends) = numbers::reading(reading, words);
        [
            Self { text, value: Value::Measured(value, reading.unit.clone()) },
            Self { text: ends, value: Value::Between([low, high], reading.unit.clone()) },
        ]
    }

    /// Creates a cell from the ends of an interval, in the unit of the column heading.
    pub fn span(ends: [f64; 2], write: impl Fn(f64) -> String) -> Self {
        let text = format!("{} … {}", write(ends[0]), write(ends[1]));
        Self { text, value: Value::Between(ends, String::new()) }
    }

    /// Creates the placeholder for a missing number.
    pub fn none() -> Self {
        Self::from("–")
    }

    /// Creates a cell from a number, or the placeholder if the number is missing.
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
