//! What a parameter is, and what those who bring some tell of them.
//!
//! The ground floor: nothing here knows an element, or the table that all rows together make ([`crate::parameter`]).

pub mod kind;
pub mod own;

pub use own::{Own, View};

/// What a parameter holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// One number.
    Scalar,
    /// One of these words; its number is its place.
    Choice(&'static [&'static str]),
    /// A list of up to so many numbers.
    List(usize),
}

/// One row of the table.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// Name in model files, in C and in reports.
    pub name: &'static str,
    /// SI unit as text; "-" for a pure number.
    pub unit: &'static str,
    /// What it holds.
    pub shape: Shape,
    /// Default value or values.
    pub default: &'static [f64],
    /// Smallest allowed value.
    pub low: f64,
    /// Largest allowed value.
    pub high: f64,
    /// One sentence for the reader of a report.
    pub meaning: &'static str,
}

impl Parameter {
    /// A row with one number.
    pub const fn scalar(
        name: &'static str,
        unit: &'static str,
        default: &'static [f64; 1],
        bounds: (f64, f64),
        meaning: &'static str,
    ) -> Parameter {
        Parameter { name, unit, shape: Shape::Scalar, default, low: bounds.0, high: bounds.1, meaning }
    }

    /// A row with one of several words; the first is the default.
    pub const fn choice(name: &'static str, words: &'static [&'static str], meaning: &'static str) -> Parameter {
        let high = words.len() as f64 - 1.0;
        Parameter { name, unit: "-", shape: Shape::Choice(words), default: &[0.0], low: 0.0, high, meaning }
    }

    /// A row with a list of numbers.
    pub const fn list(
        name: &'static str,
        unit: &'static str,
        capacity: usize,
        default: &'static [f64],
        bounds: (f64, f64),
        meaning: &'static str,
    ) -> Parameter {
        Parameter { name, unit, shape: Shape::List(capacity), default, low: bounds.0, high: bounds.1, meaning }
    }

    /// Room for its values.
    pub(crate) const fn slots(&self) -> usize {
        match self.shape {
            Shape::List(capacity) => capacity,
            _ => 1,
        }
    }

    pub(crate) const fn holds_list(&self) -> bool {
        matches!(self.shape, Shape::List(_))
    }
}

/// The rows that belong together: an element of the model, or a set of settings.
#[derive(Clone, Copy, Debug)]
pub struct Group {
    /// Name of the element in model files.
    pub name: &'static str,
    /// What it is, for the documentation.
    pub meaning: &'static str,
    /// Its rows.
    pub parameters: &'static [Parameter],
}

/// What an element tells the parameter table.
pub trait Describe {
    /// What it is, in one line.
    const MEANING: &'static str;
    /// Its rows.
    const PARAMETERS: &'static [Parameter];
}
