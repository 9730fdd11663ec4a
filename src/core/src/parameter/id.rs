//! Typed identifiers of rows and elements, which code uses instead of names.
//!
//! The compiler looks up names in code through [`crate::number!`], [`crate::list!`] and [`crate::element!`]. A name
//! that is not in the table, or that has another kind of value, is a compile error. `find` looks up a name at run time
//! (from a model file, C, a command line) and returns the same identifier types.

use core::fmt;
use core::hash::{Hash, Hasher};
use core::marker::PhantomData;

use crate::fault::{Fault, NO_PARAMETER, Reason};
use crate::parameter::groups::{ELEMENTS, GROUPS};
use crate::parameter::row::{Row, find};
use crate::schema::kind::{Kind, Many, OTHER_KIND, One, same};
use crate::schema::{Group, Parameter};

/// Identifier of a row of the parameter table whose value has the kind `K`: a number or a list.
#[derive(Clone, Copy)]
pub struct Id<K> {
    row: Row,
    kind: PhantomData<K>,
}

/// Identifier of a row that contains one number or a choice.
pub type Number = Id<One>;

/// Identifier of a row that contains a list.
pub type List = Id<Many>;

impl<K: Kind> Id<K> {
    /// Finds the row called `name`. [`crate::number!`] and [`crate::list!`] call it at compile time; a name without a
    /// row is a compile error.
    pub const fn named(name: &str) -> Id<K> {
        let (mut index, mut slot, mut group) = (0, 0, 0);
        while group < GROUPS.len() {
            let rows = GROUPS[group].parameters;
            let mut local = 0;
            while local < rows.len() {
                let parameter = &rows[local];
                if same(parameter.name, name) {
                    assert!(K::IS_LIST == parameter.holds_list(), "{}", OTHER_KIND);
                    return Id { row: Row { index, group, slot, parameter }, kind: PhantomData };
                }
                (index, slot, local) = (index + 1, slot + parameter.slots(), local + 1);
            }
            group += 1;
        }
        panic!("no parameter has this name")
    }

    /// Finds the row of a name that is known only at run time.
    ///
    /// # Errors
    /// Returns an error if no row has that name, or if the row is a list where a number is meant, or the reverse.
    pub fn find(name: &str) -> Result<Id<K>, Fault> {
        find(name).ok_or(UNKNOWN)?.try_into()
    }

    /// Returns the name.
    pub const fn name(self) -> &'static str {
        self.row.parameter.name
    }

    /// Returns the parameter of the row: unit, bounds, default and meaning.
    pub const fn parameter(self) -> &'static Parameter {
        self.row.parameter
    }

    /// Returns the smallest and the largest allowed value of the parameter.
    pub const fn bounds(self) -> (f64, f64) {
        (self.row.parameter.low, self.row.parameter.high)
    }

    /// Returns the row.
    pub const fn row(&self) -> &Row {
        &self.row
    }

    /// Makes a fault that names this row.
    pub const fn fault(self, reason: Reason) -> Fault {
        self.row.fault(reason)
    }
}

impl Number {
    /// Clamps a value to the bounds of the parameter; NaN stays NaN.
    pub fn inside(self, value: f64) -> f64 {
        let (low, high) = self.bounds();
        if value < low {
            low
        } else if value > high {
            high
        } else {
            value
        }
    }

    /// Returns the default value.
    pub fn default(self) -> f64 {
        self.row.parameter.default.first().copied().unwrap_or(f64::NAN)
    }
}

/// Error for a name that is not in the parameter table.
const UNKNOWN: Fault = Fault { parameter: NO_PARAMETER, reason: Reason::UnknownName };

/// Conversion of a row to an identifier; rejects a list where a number is meant, and the reverse.
impl<K: Kind> TryFrom<Row> for Id<K> {
    type Error = Fault;

    fn try_from(row: Row) -> Result<Id<K>, Fault> {
        if K::IS_LIST == row.parameter.holds_list() {
            Ok(Id { row, kind: PhantomData })
        } else {
            Err(row.fault(Reason::WrongShape))
        }
    }
}

impl<K> PartialEq for Id<K> {
    fn eq(&self, other: &Id<K>) -> bool {
        self.row == other.row
    }
}

impl<K> Eq for Id<K> {}

impl<K> Hash for Id<K> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.row.index.hash(state);
    }
}

/// Formats the name in quotes.
impl<K> fmt::Debug for Id<K> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        fmt::Debug::fmt(self.row.parameter.name, f)
    }
}

/// Formats the name.
impl<K> fmt::Display for Id<K> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.pad(self.row.parameter.name)
    }
}

/// Identifier of an element of the model.
#[derive(Clone, Copy)]
pub struct Element {
    place: usize,
    group: &'static Group,
}

impl Element {
    /// Finds the element called `name`. Like [`Id::named`], the function is called at compile time.
    // An inline function is compiled only where code calls it at run time. No code does so, and thus the library does
    // not contain the function's panic.
    #[inline]
    pub const fn named(name: &str) -> Element {
        let mut place = 0;
        while place < ELEMENTS {
            let group = &GROUPS[place];
            if same(group.name, name) {
                return Element { place, group };
            }
            place += 1;
        }
        panic!("no element has this name")
    }

    /// Finds the element of a name that is known only at run time.
    ///
    /// # Errors
    /// Returns an error if no element has that name.
    pub fn find(name: &str) -> Result<Element, Fault> {
        Element::all().find(|element| element.name() == name).ok_or(UNKNOWN)
    }

    /// Returns all elements, in the order of the element list ([`mod@crate::list`]).
    pub fn all() -> impl Iterator<Item = Element> {
        GROUPS.iter().take(ELEMENTS).enumerate().map(|(place, group)| Element { place, group })
    }

    /// Returns the element of the group with index `place`. `None` for the group of the integration's settings and
    /// beyond.
    pub fn of_group(place: usize) -> Option<Element> {
        Element::all().nth(place)
    }

    /// Returns the index of the element's group in [`GROUPS`].
    pub const fn place(self) -> usize {
        self.place
    }

    /// Returns the name.
    pub const fn name(self) -> &'static str {
        self.group.name
    }

    /// Returns the element's group, with its meaning and its rows.
    pub const fn group(self) -> &'static Group {
        self.group
    }

    pub(crate) const fn bit(self) -> u64 {
        1 << self.place
    }
}

impl Row {
    /// Returns the element of this row; `None` for a row of the integration's settings.
    pub fn element(&self) -> Option<Element> {
        Element::of_group(self.group)
    }
}

impl PartialEq for Element {
    fn eq(&self, other: &Element) -> bool {
        self.place == other.place
    }
}

impl Eq for Element {}

impl Hash for Element {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.place.hash(state);
    }
}

/// Formats the name in quotes.
impl fmt::Debug for Element {
    // The formatting can panic. An inline function is compiled only where code calls it, so the library does not
    // contain this panic.
    #[inline]
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        fmt::Debug::fmt(self.name(), f)
    }
}

/// Formats the name.
impl fmt::Display for Element {
    #[inline]
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The [`Number`] of a name, looked up when the code is compiled.
///
/// ```
/// # use dashpot_core::{Params, number};
/// let mut params = Params::new();
/// params.set(number!("series_stiffness"), 3e6).unwrap();
/// assert_eq!(params.number(number!("series_stiffness")), 3e6);
/// ```
///
/// A name that no parameter has is a compile error:
///
/// ```compile_fail,E0080
/// # use dashpot_core::number;
/// let k = number!("series_stifness");
/// ```
///
/// The name of a list is also a compile error:
///
/// ```compile_fail,E0080
/// # use dashpot_core::number;
/// let force = number!("fv_force");
/// ```
#[macro_export]
macro_rules! number {
    ($name:literal) => {{
        // A named constant, not `const { }`, so that `cargo check` evaluates it too.
        const ID: $crate::parameter::Number = $crate::parameter::Number::named($name);
        ID
    }};
}

/// The [`List`] of a name, looked up when the code is compiled.
///
/// ```
/// # use dashpot_core::{Params, list};
/// let force = Params::new().list(list!("fv_force")).to_vec();
/// assert!(force.is_sorted());
/// ```
///
/// A name that no parameter has does not compile:
///
/// ```compile_fail,E0080
/// # use dashpot_core::list;
/// let force = list!("fv_forces");
/// ```
///
/// The name of a number is also a compile error:
///
/// ```compile_fail,E0080
/// # use dashpot_core::list;
/// let k = list!("series_stiffness");
/// ```
#[macro_export]
macro_rules! list {
    ($name:literal) => {{
        const ID: $crate::parameter::List = $crate::parameter::List::named($name);
        ID
    }};
}

/// The [`Element`] of a name, looked up when the code is compiled.
///
/// ```
/// # use dashpot_core::{Params, element};
/// let mut params = Params::new();
/// params.enable(element!("bushing"), true);
/// assert!(params.is_on(element!("bushing")));
/// ```
///
/// A name that no element has is a compile error:
///
/// ```compile_fail,E0080
/// # use dashpot_core::element;
/// let element = element!("bushings");
/// ```
///
/// The name of the integration's settings, which are always on, is also a compile error:
///
/// ```compile_fail,E0080
/// # use dashpot_core::element;
/// let element = element!("integration");
/// ```
#[macro_export]
macro_rules! element {
    ($name:literal) => {{
        const ID: $crate::parameter::Element = $crate::parameter::Element::named($name);
        ID
    }};
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameter::row::table;
    use crate::schema::Shape;
    use std::format;

    #[test]
    fn a_name_gives_the_same_row_when_compiled_and_when_run() {
        for row in table() {
            let name = row.parameter.name;
            let found = match row.parameter.shape {
                Shape::List(_) => *List::named(name).row(),
                _ => *Number::named(name).row(),
            };
            assert_eq!((found.index, found.group, found.slot), (row.index, row.group, row.slot), "{name}");
            assert_eq!(found.parameter.name, name);
        }
        for (place, element) in Element::all().enumerate() {
            assert_eq!(Element::named(element.name()), element);
            assert_eq!(Element::find(element.name()), Ok(element));
            assert_eq!((element.place(), Element::of_group(place)), (place, Some(element)));
        }
        assert_eq!(Element::of_group(ELEMENTS), None);
    }

    #[test]
    fn names_from_outside_are_refused_with_the_reason() {
        let number = Number::named("series_stiffness");
        assert_eq!(Number::find("series_stiffness"), Ok(number));
        assert_eq!(Number::find("no_such"), Err(UNKNOWN));
        assert_eq!(List::find("series_stiffness"), Err(number.fault(Reason::WrongShape)));
        assert_eq!(Number::find("fv_force"), Err(List::named("fv_force").fault(Reason::WrongShape)));
        assert_eq!(Element::find("integration"), Err(UNKNOWN));
        assert_eq!(format!("{number} {number:?}"), "series_stiffness \"series_stiffness\"");
    }
}
