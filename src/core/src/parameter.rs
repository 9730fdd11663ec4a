//! The one parameter table, and the values a user fills in.
//!
//! Every element brings its rows (name, unit, default, bounds, meaning); the table is their sequence. It drives the C
//! setter, the model file, the bounds of the identification and the documentation.

use crate::elements::{self, GROUPS};
use crate::fault::{Fault, NO_PARAMETER, Reason};

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

/// Finds a row by name.
pub fn find(name: &str) -> Option<Row> {
    table().find(|row| row.parameter.name == name)
}

/// A full set of parameter values, and which elements are on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Params {
    elements: u64,
    lengths: [u32; COUNT],
    values: [f64; SLOTS],
}

impl Default for Params {
    fn default() -> Self {
        Params::new()
    }
}

impl Params {
    /// The defaults of the table, with the elements of the thesis's model on.
    pub fn new() -> Params {
        let mut params = Params { elements: elements::DEFAULT_ON, lengths: [0; COUNT], values: [0.0; SLOTS] };
        for row in table() {
            params.store(&row, row.parameter.default);
        }
        params
    }

    fn store(&mut self, row: &Row, values: &[f64]) {
        if let Some(length) = self.lengths.get_mut(row.index) {
            *length = values.len() as u32;
        }
        for (to, from) in self.values.iter_mut().skip(row.slot).zip(values) {
            *to = *from;
        }
    }

    /// The values of a row.
    pub fn get(&self, row: &Row) -> &[f64] {
        let length = self.lengths.get(row.index).map_or(0, |l| *l as usize);
        let tail = self.values.get(row.slot..).unwrap_or(&[]);
        tail.get(..length.min(row.parameter.slots())).unwrap_or(&[])
    }

    /// The value of the scalar called `name`; NaN when there is none.
    pub fn scalar(&self, name: &str) -> f64 {
        find(name).and_then(|row| self.get(&row).first().copied()).unwrap_or(f64::NAN)
    }

    /// The values of the list called `name`; empty when there is none.
    pub fn list(&self, name: &str) -> &[f64] {
        match find(name) {
            Some(row) => self.get(&row),
            None => &[],
        }
    }

    /// Sets one number or choice.
    ///
    /// # Errors
    /// Unknown name, a list parameter, a non-finite or out-of-bounds value. Nothing is changed then.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), Fault> {
        let row = find(name).ok_or(Fault { parameter: NO_PARAMETER, reason: Reason::UnknownName })?;
        if matches!(row.parameter.shape, Shape::List(_)) {
            return Err(Fault { parameter: row.index as u16, reason: Reason::WrongShape });
        }
        self.set_row(&row, &[value])
    }

    /// Sets a list.
    ///
    /// # Errors
    /// Unknown name, a scalar parameter, too many numbers, a non-finite or out-of-bounds number. Nothing is changed
    /// then.
    pub fn set_list(&mut self, name: &str, values: &[f64]) -> Result<(), Fault> {
        let row = find(name).ok_or(Fault { parameter: NO_PARAMETER, reason: Reason::UnknownName })?;
        if !matches!(row.parameter.shape, Shape::List(_)) {
            return Err(Fault { parameter: row.index as u16, reason: Reason::WrongShape });
        }
        self.set_row(&row, values)
    }

    fn set_row(&mut self, row: &Row, values: &[f64]) -> Result<(), Fault> {
        check(row, values)?;
        self.store(row, values);
        Ok(())
    }

    /// Checks every value against the table: for sets that did not come through the setters.
    ///
    /// # Errors
    /// The first parameter that the table does not allow.
    pub fn check(&self) -> Result<(), Fault> {
        for row in table() {
            if self.lengths.get(row.index).is_none_or(|l| *l as usize > row.parameter.slots()) {
                return Err(Fault { parameter: row.index as u16, reason: Reason::PointCount });
            }
            check(&row, self.get(&row))?;
        }
        Ok(())
    }

    /// Switches an element on or off.
    ///
    /// # Errors
    /// No element has that name.
    pub fn enable(&mut self, element: &str, on: bool) -> Result<(), Fault> {
        let bit = elements::bit(element).ok_or(Fault { parameter: NO_PARAMETER, reason: Reason::UnknownName })?;
        if on {
            self.elements |= bit;
        } else {
            self.elements &= !bit;
        }
        Ok(())
    }

    /// Switches every element off.
    pub fn disable_all(&mut self) {
        self.elements = 0;
    }

    /// Whether an element is on.
    pub fn is_on(&self, element: &str) -> bool {
        elements::bit(element).is_some_and(|bit| self.elements & bit != 0)
    }

    /// The elements that are on, one bit each in the order of the table's groups.
    pub(crate) fn elements(&self) -> u64 {
        self.elements
    }
}

fn check(row: &Row, values: &[f64]) -> Result<(), Fault> {
    let p = row.parameter;
    let fault = |reason| Err(Fault { parameter: row.index as u16, reason });
    if values.len() > p.slots() || (values.is_empty() && !matches!(p.shape, Shape::List(_))) {
        return fault(Reason::PointCount);
    }
    for value in values {
        if !value.is_finite() {
            return fault(Reason::NotFinite);
        }
        if matches!(p.shape, Shape::Choice(_)) {
            let whole = *value >= p.low && *value <= p.high && *value == (*value as i64) as f64;
            if !whole {
                return fault(Reason::NotAChoice);
            }
        } else if *value < p.low || *value > p.high {
            return fault(Reason::OutOfBounds);
        }
    }
    Ok(())
}

/// What an element sees of a parameter set when it prepares itself: its own rows, by their place among them.
#[derive(Clone, Copy)]
pub struct View<'a> {
    params: &'a Params,
    group: usize,
}

impl<'a> View<'a> {
    /// The rows of group `group`.
    pub fn new(params: &'a Params, group: usize) -> View<'a> {
        View { params, group }
    }

    fn row(&self, local: usize) -> Option<Row> {
        table().filter(|row| row.group == self.group).nth(local)
    }

    /// The number in row `local` of the element.
    pub fn number(&self, local: usize) -> f64 {
        self.row(local).and_then(|row| self.params.get(&row).first().copied()).unwrap_or(0.0)
    }

    /// The list in row `local` of the element.
    pub fn list(&self, local: usize) -> &'a [f64] {
        match self.row(local) {
            Some(row) => self.params.get(&row),
            None => &[],
        }
    }

    /// A fault that names row `local` of the element.
    pub fn fault(&self, local: usize, reason: Reason) -> Fault {
        Fault { parameter: self.row(local).map_or(NO_PARAMETER, |row| row.index as u16), reason }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_defaults_allowed() {
        for (i, row) in table().enumerate() {
            assert_eq!(find(row.parameter.name).unwrap().index, i, "{} appears twice", row.parameter.name);
            check(&row, row.parameter.default).unwrap_or_else(|_| panic!("default of {}", row.parameter.name));
            assert!(row.parameter.low <= row.parameter.high);
        }
        assert_eq!(table().count(), COUNT);
        Params::new().check().unwrap();
    }

    #[test]
    fn setting_one_row_leaves_all_others() {
        let before = Params::new();
        for row in table() {
            let mut after = before;
            let p = row.parameter;
            match p.shape {
                Shape::List(_) => after.set_list(p.name, &[p.low]).unwrap(),
                _ => after.set(p.name, p.high).unwrap(),
            }
            for other in table().filter(|o| o.index != row.index) {
                assert_eq!(before.get(&other), after.get(&other), "{} disturbed {}", p.name, other.parameter.name);
            }
        }
    }

    #[test]
    fn refusals_change_nothing_and_name_the_row() {
        let before = Params::new();
        let mut params = before;
        let row = find("series_stiffness").unwrap().index as u16;
        for (value, reason) in
            [(f64::NAN, Reason::NotFinite), (-1.0, Reason::OutOfBounds), (f64::INFINITY, Reason::NotFinite)]
        {
            assert_eq!(params.set("series_stiffness", value), Err(Fault { parameter: row, reason }));
        }
        assert_eq!(params.set("no_such", 1.0).unwrap_err().reason, Reason::UnknownName);
        assert_eq!(params.set("fv_interpolation", 0.5).unwrap_err().reason, Reason::NotAChoice);
        assert_eq!(params.set("fv_force", 0.5).unwrap_err().reason, Reason::WrongShape);
        assert_eq!(params.set_list("fv_force", &[0.0; 64]).unwrap_err().reason, Reason::PointCount);
        assert_eq!(params.enable("no_such", true).unwrap_err().reason, Reason::UnknownName);
        assert_eq!(params, before);
    }
}
