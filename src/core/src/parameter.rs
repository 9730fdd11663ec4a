//! The one parameter table.
//!
//! Every element brings its rows (name, unit, default, bounds, meaning); the table is their sequence. It drives the C
//! setter, the model file, the bounds of the identification and the documentation.
//!
//! | module | what |
//! |---|---|
//! | [`id`] | which row or element is meant, checked when the code is compiled |
//! | [`own`] | the same for an element's own rows, and what it sees of a parameter set |
//! | [`values`] | the values a user fills in |

pub mod id;
pub mod own;
pub mod values;

pub use id::{Element, Id, List, Number};
pub use own::{Own, View};
pub use values::Params;

use crate::elements::GROUPS;
use crate::fault::{Fault, Reason};

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

    const fn slots(&self) -> usize {
        match self.shape {
            Shape::List(capacity) => capacity,
            _ => 1,
        }
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

/// Number of rows of the table.
pub const COUNT: usize = {
    let (mut n, mut g) = (0, 0);
    while g < GROUPS.len() {
        n += GROUPS[g].parameters.len();
        g += 1;
    }
    n
};

/// Numbers that a full set of values takes.
pub const SLOTS: usize = {
    let (mut n, mut g) = (0, 0);
    while g < GROUPS.len() {
        let mut p = 0;
        while p < GROUPS[g].parameters.len() {
            n += GROUPS[g].parameters[p].slots();
            p += 1;
        }
        g += 1;
    }
    n
};

/// All rows in order, each with its group and the place of its first value.
pub fn table() -> impl Iterator<Item = Row> {
    let mut slot = 0;
    GROUPS.iter().enumerate().flat_map(|(g, group)| group.parameters.iter().map(move |p| (g, p))).enumerate().map(
        move |(index, (group, parameter))| {
            let row = Row { index, group, slot, parameter };
            slot += parameter.slots();
            row
        },
    )
}

/// A row of [`table`].
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Place in the table.
    pub index: usize,
    /// Place of its group in [`GROUPS`].
    pub group: usize,
    slot: usize,
    /// The row itself.
    pub parameter: &'static Parameter,
}

impl PartialEq for Row {
    fn eq(&self, other: &Row) -> bool {
        self.index == other.index
    }
}

impl Eq for Row {}

impl Row {
    /// The element it belongs to; `None` for the settings.
    pub fn element(&self) -> Option<Element> {
        Element::of_group(self.group)
    }

    /// A fault that names this row.
    pub const fn fault(&self, reason: Reason) -> Fault {
        Fault { parameter: self.index as u16, reason }
    }
}

/// Finds a row by a name that is known only when the program runs; code that knows the name takes [`crate::number!`] or
/// [`crate::list!`].
pub fn find(name: &str) -> Option<Row> {
    table().find(|row| row.parameter.name == name)
}
