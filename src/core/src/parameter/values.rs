//! The parameter values that a user supplies.

use crate::fault::{Fault, Reason};
use crate::parameter::groups::{DEFAULT_ON, GROUPS};
use crate::parameter::id::{Element, List, Number};
use crate::parameter::row::{COUNT, Row, SLOTS, table};
use crate::schema::{Describe, Shape, View};

/// A full set of parameter values, and the set of elements that are on.
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
    /// A set without values, which the caller must fill completely.
    pub(crate) const BLANK: Params = Params { elements: 0, lengths: [0; COUNT], values: [0.0; SLOTS] };

    /// Returns the defaults of the parameter table, with the elements of the default model on (Jonnalagadda & Vyas, KTH
    /// 2020).
    pub fn new() -> Params {
        let mut params = Params::BLANK;
        params.set_defaults();
        params
    }

    /// Sets every parameter to its default, and switches the elements of the default model on and all others off.
    pub(crate) fn set_defaults(&mut self) {
        self.elements = DEFAULT_ON;
        for row in table() {
            self.store(&row, row.parameter.default);
        }
    }

    fn store(&mut self, row: &Row, values: &[f64]) {
        if let Some(length) = self.lengths.get_mut(row.index) {
            *length = values.len() as u32;
        }
        for (to, from) in self.values.iter_mut().skip(row.slot).zip(values) {
            *to = *from;
        }
    }

    /// Returns the values of a row.
    pub fn get(&self, row: &Row) -> &[f64] {
        let length = self.lengths.get(row.index).map_or(0, |l| *l as usize);
        let tail = self.values.get(row.slot..).unwrap_or(&[]);
        tail.get(..length.min(row.parameter.slots())).unwrap_or(&[])
    }

    /// Returns the value of a number or a choice.
    pub fn number(&self, number: Number) -> f64 {
        self.get(number.row()).first().copied().unwrap_or(f64::NAN)
    }

    /// Returns the values of a list.
    pub fn list(&self, list: List) -> &[f64] {
        self.get(list.row())
    }

    /// Returns the parameters of the element `E`, whose rows form the group `group`.
    pub(crate) fn view<E: Describe>(&self, group: usize) -> View<'_, E> {
        let before = GROUPS.iter().take(group).flat_map(|group| group.parameters);
        let (first, slot) = before.fold((0, 0), |(index, slot), row| (index + 1, slot + row.slots()));
        View::new(first, self.lengths.get(first..).unwrap_or(&[]), self.values.get(slot..).unwrap_or(&[]))
    }

    /// Returns `count` values of the set from slot `from` on; a slot is the index of a value.
    pub(crate) fn slots(&self, from: usize, count: usize) -> &[f64] {
        self.values.get(from..).and_then(|tail| tail.get(..count)).unwrap_or(&[])
    }

    /// Returns the numbers of values of the rows from the table index `first` on.
    pub(crate) fn lengths(&self, first: usize) -> &[u32] {
        self.lengths.get(first..).unwrap_or(&[])
    }

    /// Sets one number or choice.
    ///
    /// # Errors
    /// Returns an error for a value that is not finite, out of bounds, or not the index of a choice. Nothing changes
    /// then.
    pub fn set(&mut self, number: Number, value: f64) -> Result<(), Fault> {
        self.set_row(number.row(), &[value])
    }

    /// Sets a list.
    ///
    /// # Errors
    /// Returns an error for too many numbers and for a non-finite or out-of-bounds number. Nothing changes then.
    pub fn set_list(&mut self, list: List, values: &[f64]) -> Result<(), Fault> {
        self.set_row(list.row(), values)
    }

    fn set_row(&mut self, row: &Row, values: &[f64]) -> Result<(), Fault> {
        check(row, values)?;
        self.store(row, values);
        Ok(())
    }

    /// Checks every value against the table. A parameter set that [`Params::set`] and [`Params::set_list`] filled needs
    /// no check.
    ///
    /// # Errors
    /// Returns the first parameter with a value that the table does not allow.
    pub fn check(&self) -> Result<(), Fault> {
        for row in table() {
            if self.lengths.get(row.index).is_none_or(|l| *l as usize > row.parameter.slots()) {
                return Err(row.fault(Reason::PointCount));
            }
            check(&row, self.get(&row))?;
        }
        Ok(())
    }

    /// Switches an element on or off.
    pub fn enable(&mut self, element: Element, on: bool) {
        if on {
            self.elements |= element.bit();
        } else {
            self.elements &= !element.bit();
        }
    }

    /// Switches every element off.
    pub fn disable_all(&mut self) {
        self.elements = 0;
    }

    /// Returns whether an element is on.
    pub fn is_on(&self, element: Element) -> bool {
        self.elements & element.bit() != 0
    }

    /// Returns whether a parameter affects the damper. It must belong to the settings of the integration or to an
    /// element that is on. A parameter of some forms of its element also requires that such a form is chosen.
    pub fn counts(&self, row: &Row) -> bool {
        row.element().is_none_or(|element| self.is_on(element)) && self.is_of_form(row)
    }

    /// Returns whether a parameter belongs to the chosen form of its element, even if the element is off. A parameter
    /// that is restricted to no form belongs to all.
    pub fn is_of_form(&self, row: &Row) -> bool {
        row.parameter.form.is_none_or(|(choice, words)| {
            let chosen = table().find(|other| other.group == row.group && other.parameter.name == choice);
            let word = chosen.and_then(|chosen| {
                let Shape::Choice(all) = chosen.parameter.shape else { return None };
                let place = self.get(&chosen).first().map_or(0.0, |place| *place);
                all.iter().zip(0u32..).find(|(_, at)| f64::from(*at) == place).map(|(word, _)| *word)
            });
            word.is_some_and(|word| words.contains(&word))
        })
    }

    /// Returns the elements that are on, one bit each in the order of the parameter table's groups.
    pub(crate) fn elements(&self) -> u64 {
        self.elements
    }
}

/// Checks values for a row against the bounds of the parameter table.
pub(crate) fn check(row: &Row, values: &[f64]) -> Result<(), Fault> {
    let p = row.parameter;
    let fault = |reason| Err(row.fault(reason));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameter::row::find;
    use crate::{list, number};

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
    fn every_form_is_one_of_a_choice_of_the_same_element() {
        for row in table() {
            let Some((choice, words)) = row.parameter.form else { continue };
            let chosen = find(choice).unwrap();
            assert_eq!(chosen.group, row.group, "{}", row.parameter.name);
            let Shape::Choice(all) = chosen.parameter.shape else { panic!("{choice} is no choice") };
            assert!(words.iter().all(|word| all.contains(word)) && words.len() < all.len(), "{}", row.parameter.name);
        }
    }

    #[test]
    fn setting_one_row_leaves_all_others() {
        let before = Params::new();
        for row in table() {
            let mut after = before;
            let p = row.parameter;
            match p.shape {
                Shape::List(_) => after.set_list(List::find(p.name).unwrap(), &[p.low]).unwrap(),
                _ => after.set(Number::find(p.name).unwrap(), p.high).unwrap(),
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
        let stiffness = number!("series_stiffness");
        for (value, reason) in
            [(f64::NAN, Reason::NotFinite), (-1.0, Reason::OutOfBounds), (f64::INFINITY, Reason::NotFinite)]
        {
            assert_eq!(params.set(stiffness, value), Err(stiffness.fault(reason)));
        }
        assert_eq!(params.set(number!("fv_interpolation"), 0.5).unwrap_err().reason, Reason::NotAChoice);
        assert_eq!(params.set_list(list!("fv_force"), &[0.0; 64]).unwrap_err().reason, Reason::PointCount);
        assert_eq!(params, before);
    }
}
