//! Definition of a parameter, and of the description that each element gives of its parameters.
//!
//! This is the lowest layer: it depends on no element and not on the table of all rows ([`crate::parameter`]).

pub mod kind;
pub mod own;

pub use own::{Own, View};

/// Kind of a parameter's value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// One number.
    Scalar,
    /// One of these words; its number is its index.
    Choice(&'static [&'static str]),
    /// A list of up to this many numbers.
    List(usize),
}

/// Strength of the smallest and the largest damper whose parameters are allowed, as a multiple of a passenger car's.
///
/// They range from a damper of an instrument, of some newtons, to the strut of an airplane or a lock, of some hundred
/// kilonewtons. Wider bounds would only allow dampers that are scaled copies of these. An error of units would then be
/// rejected later.
pub const SIZES: (f64, f64) = (1e-3, 100.0);

/// One row of the parameter table.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// Name in model files, in C and in reports.
    pub name: &'static str,
    /// SI unit as text; "-" for a pure number.
    pub unit: &'static str,
    /// Kind of its value.
    pub shape: Shape,
    /// Default value or values.
    pub default: &'static [f64],
    /// Smallest allowed value.
    pub low: f64,
    /// Largest allowed value.
    pub high: f64,
    /// Smallest and largest value in a damper of the size of a passenger car's. A number with a force in its unit may
    /// be smaller or larger ([`SIZES`]), if all others of the set are in proportion ([`crate::proportion`]).
    pub of_a_car: (f64, f64),
    /// A choice of the same element and those of its words with which the parameter has an effect; `None`: always.
    pub form: Option<(&'static str, &'static [&'static str])>,
    /// Whether it must be in proportion to the size of the damper: its unit contains a force.
    pub grows: bool,
    /// Meaning in one sentence, for the reader of a report.
    pub meaning: &'static str,
}

impl Parameter {
    /// Makes a row with one number.
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

    /// Marks a parameter whose largest value means that it has no effect, in a damper of any size. It need not be in
    /// proportion to the others.
    pub const fn none_at_most(mut self) -> Parameter {
        self.high = self.of_a_car.1;
        self.grows = false;
        self
    }

    /// Makes a row with one of several words; the first is the default.
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

    /// Makes a row with a list of numbers. Its bounds are wide enough for a damper of any size.
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

    /// Returns the number of its values.
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

/// Returns whether a unit is one of force or contains one: stiffness, damping, mass (kg is N s²/m), heat.
pub const fn has_force(unit: &str) -> bool {
    matches!(unit.as_bytes(), [b'N' | b'J' | b'W', ..] | [b'k', b'g', ..])
}

/// Widens the bounds in a car to dampers of any size, for a number in proportion to the size.
const fn of_any_size((low, high): (f64, f64)) -> (f64, f64) {
    (if low > 0.0 { low * SIZES.0 } else { low * SIZES.1 }, high * SIZES.1)
}

/// Rows that belong together: an element of the model, or a set of settings.
#[derive(Clone, Copy, Debug)]
pub struct Group {
    /// Name of the element in model files.
    pub name: &'static str,
    /// Meaning of the group, for the documentation.
    pub meaning: &'static str,
    /// Its rows.
    pub parameters: &'static [Parameter],
}

/// Description of an element for the parameter table.
pub trait Describe {
    /// Meaning in one line.
    const MEANING: &'static str;
    /// Its rows.
    const PARAMETERS: &'static [Parameter];
}
