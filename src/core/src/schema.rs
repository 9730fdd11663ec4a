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

/// Strength of the smallest and the largest damper whose parameters are allowed, as a multiple of a passenger car's.
///
/// They go from a damper of an instrument, of some newtons, to the strut of an airplane or a lock, of some hundred
/// kilonewtons. Wider bounds would allow no damper that is not the same in proportion. They would only move the point
/// at which an error of units is rejected.
pub const SIZES: (f64, f64) = (1e-3, 100.0);

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
    /// Smallest and largest value in a damper of the size of a passenger car's. With a force in its unit a number may be smaller and
    /// larger ([`SIZES`]), if all others of the set go with it ([`crate::proportion`]).
    pub of_a_car: (f64, f64),
    /// The choice of the same element, and its words, with which alone the number counts; `None`: with all.
    pub form: Option<(&'static str, &'static [&'static str])>,
    /// Whether it has to go with the size of the damper: it has a force in its unit.
    pub grows: bool,
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
        let grows = has_force(unit);
        let (low, high) = if grows { of_any_size(bounds) } else { bounds };
        Parameter { name, unit, shape: Shape::Scalar, default, low, high, of_a_car: bounds, form: None, grows, meaning }
    }

    /// Restricts the parameter to some words of a choice of its element: it has no effect with others.
    pub const fn in_form(mut self, choice: &'static str, words: &'static [&'static str]) -> Parameter {
        self.form = Some((choice, words));
        self
    }

    /// Marks a parameter whose largest value stands for none, in a damper of any size: it need not be in proportion
    /// to the others.
    pub const fn none_at_most(mut self) -> Parameter {
        self.high = self.of_a_car.1;
        self.grows = false;
        self
    }

    /// A row with one of several words; the first is the default.
    pub const fn choice(name: &'static str, words: &'static [&'static str], meaning: &'static str) -> Parameter {
        let high = words.len() as f64 - 1.0;
        Parameter {
            name,
            unit: "-",
            shape: Shape::Choice(words),
            default: &[0.0],
            low: 0.0,
            high,
            of_a_car: (0.0, high),
            form: None,
            grows: false,
            meaning,
        }
    }

    /// A row with a list of numbers. Its bounds are wide enough for a damper of any size.
    pub const fn list(
        name: &'static str,
        unit: &'static str,
        capacity: usize,
        default: &'static [f64],
        bounds: (f64, f64),
        meaning: &'static str,
    ) -> Parameter {
        Parameter {
            name,
            unit,
            shape: Shape::List(capacity),
            default,
            low: bounds.0,
            high: bounds.1,
            of_a_car: bounds,
            form: None,
            grows: has_force(unit),
            meaning,
        }
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

/// Whether a unit is one of force, or holds one: stiffness, damping, mass (kg is N s²/m), heat.
pub const fn has_force(unit: &str) -> bool {
    matches!(unit.as_bytes(), [b'N' | b'J' | b'W', ..] | [b'k', b'g', ..])
}

/// Bounds of a number that grows with the damper, of those in a car.
const fn of_any_size((low, high): (f64, f64)) -> (f64, f64) {
    (if low > 0.0 { low * SIZES.0 } else { low * SIZES.1 }, high * SIZES.1)
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
