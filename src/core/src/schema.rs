//! Definition of a parameter, and of each element's description of its parameters.
//!
//! This module is the lowest layer. It depends neither on the elements nor on the table of all parameters
//! ([`crate::parameter`]).

pub mod kind;
pub mod own;

pub use own::{Own, View};

/// Kind of a parameter's value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// One number.
    Scalar,
    /// One of several words; the value is the index of the word in this list.
    Choice(&'static [&'static str]),
    /// A list of numbers; the content is the largest allowed count.
    List(usize),
}

/// Size of the smallest and the largest allowed damper, as the ratio of its forces to those of a car damper.
///
/// The sizes range from instrument dampers of some newtons to struts of airplanes or canal locks of some hundred
/// kilonewtons. Wider bounds would detect fewer errors of units.
pub const SIZES: (f64, f64) = (1e-3, 100.0);

/// One row of the parameter table.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// Name of the parameter in model files, in C and in reports.
    pub name: &'static str,
    /// SI unit as text; "-" for a pure number.
    pub unit: &'static str,
    /// Kind of the value.
    pub shape: Shape,
    /// Default value or values.
    pub default: &'static [f64],
    /// Smallest allowed value.
    pub low: f64,
    /// Largest allowed value.
    pub high: f64,
    /// Smallest and largest value in a damper of a passenger car's size. A number with a force in its unit may be
    /// smaller or larger ([`SIZES`]) if the whole parameter set is in proportion ([`crate::proportion`]).
    pub of_a_car: (f64, f64),
    /// A choice of the same element, and the words of that choice for which the parameter has an effect. `None` if the
    /// parameter always has an effect.
    pub form: Option<(&'static str, &'static [&'static str])>,
    /// Whether the value must be in proportion to the size of the damper, because its unit contains a force.
    pub grows: bool,
    /// Meaning of the parameter in one sentence, for the reader of a report.
    pub meaning: &'static str,
}

impl Parameter {
    /// Makes a row with one number. `bounds` are the smallest and the largest value in a damper of a passenger car. If
    /// `unit` contains a force, the bounds of the row are wider, for a damper of any size ([`SIZES`]).
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

    /// Restricts the parameter to some words of a choice of its element. With other words, the parameter has no effect.
    pub const fn in_form(mut self, choice: &'static str, words: &'static [&'static str]) -> Parameter {
        self.form = Some((choice, words));
        self
    }

    /// Marks a parameter that has no effect at its largest value, in a damper of any size. Such a parameter need not be
    /// in proportion to the others.
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

    /// Makes a row with a list of numbers. `bounds` must allow a damper of any size, because they are not widened.
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

    /// Returns the number of values that a parameter set stores for this row: the capacity of a list, otherwise 1.
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

/// Returns whether a unit contains a force, as the units of force, stiffness, damping, mass (kg is N s²/m) and heat do.
pub const fn has_force(unit: &str) -> bool {
    matches!(unit.as_bytes(), [b'N' | b'J' | b'W', ..] | [b'k', b'g', ..])
}

/// Widens the bounds for car dampers to dampers of any size ([`SIZES`]), for a number that is proportional to the size.
const fn of_any_size((low, high): (f64, f64)) -> (f64, f64) {
    (if low > 0.0 { low * SIZES.0 } else { low * SIZES.1 }, high * SIZES.1)
}

/// Rows of the parameter table that belong together: those of an element of the model, or the settings of the
/// integration.
#[derive(Clone, Copy, Debug)]
pub struct Group {
    /// Name of the element in model files.
    pub name: &'static str,
    /// Meaning of the group in one line, for the documentation.
    pub meaning: &'static str,
    /// Rows of the parameter table that belong to the group.
    pub parameters: &'static [Parameter],
}

/// Description of an element for the parameter table.
pub trait Describe {
    /// Meaning of the element in one line.
    const MEANING: &'static str;
    /// Rows of the parameter table that belong to the element.
    const PARAMETERS: &'static [Parameter];
}
