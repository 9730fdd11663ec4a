//! Which row or element is meant: types that code hands on in place of names.
//!
//! A name in code is looked up when the code is compiled, by [`crate::number!`], [`crate::list!`] and
//! [`crate::element!`]; a name that the table does not have, or that holds something else, does not compile. A name from
//! outside (a model file, C, a command line) is looked up by `find`, which gives the same types.

use core::fmt;
use core::hash::{Hash, Hasher};
use core::marker::PhantomData;

use crate::fault::{Fault, NO_PARAMETER, Reason};
use crate::parameter::groups::{ELEMENTS, GROUPS};
use crate::parameter::row::{Row, find};
use crate::schema::kind::{Kind, Many, OTHER_KIND, One, same};
use crate::schema::{Group, Parameter};

/// A row of the table that holds what `K` says.
#[derive(Clone, Copy)]
pub struct Id<K> {
    row: Row,
    kind: PhantomData<K>,
}

/// A number or a choice of the table.
pub type Number = Id<One>;

/// A list of the table.
pub type List = Id<Many>;

impl<K: Kind> Id<K> {
    /// The row called `name`. For constants, which is what [`crate::number!`] and [`crate::list!`] make of it: where there is no
    /// such row, there is no program.
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

    /// The row of a name that comes from outside.
    ///
    /// # Errors
    /// No row has that name, or it holds something else.
    pub fn find(name: &str) -> Result<Id<K>, Fault> {
        find(name).ok_or(UNKNOWN)?.try_into()
    }

    /// Its name.
    pub const fn name(self) -> &'static str {
        self.row.parameter.name
    }

    /// Unit, bounds, default and meaning.
    pub const fn parameter(self) -> &'static Parameter {
        self.row.parameter
    }

    /// Smallest and largest allowed value.
    pub const fn bounds(self) -> (f64, f64) {
        (self.row.parameter.low, self.row.parameter.high)
    }

    /// Its row.
    pub const fn row(&self) -> &Row {
        &self.row
    }

    /// A fault that names it.
    pub const fn fault(self, reason: Reason) -> Fault {
        self.row.fault(reason)
    }
}

impl Number {
    /// A value held inside the bounds; no number stays none.
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

    /// Its default.
    pub fn default(self) -> f64 {
        self.row.parameter.default.first().copied().unwrap_or(f64::NAN)
    }
}

/// A name that is none of the table's.
const UNKNOWN: Fault = Fault { parameter: NO_PARAMETER, reason: Reason::UnknownName };

/// Refuses a row that holds something else.
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

/// Its name in quotes.
impl<K> fmt::Debug for Id<K> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        fmt::Debug::fmt(self.row.parameter.name, f)
    }
}

/// Its name.
impl<K> fmt::Display for Id<K> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.pad(self.row.parameter.name)
    }
}

/// An element of the model.
#[derive(Clone, Copy)]
pub struct Element {
    place: usize,
    group: &'static Group,
}

impl Element {
    /// The element called `name`. For constants, as [`Id::named`].
    // Inline, so that nothing is compiled of it but what is called while the program runs, which is nothing: its panic is none of the library's.
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

    /// The element of a name that comes from outside.
    ///
    /// # Errors
    /// No element has that name.
    pub fn find(name: &str) -> Result<Element, Fault> {
        Element::all().find(|element| element.name() == name).ok_or(UNKNOWN)
    }

    /// All elements, in the order of the list.
    pub fn all() -> impl Iterator<Item = Element> {
        GROUPS.iter().take(ELEMENTS).enumerate().map(|(place, group)| Element { place, group })
    }

    /// The element whose rows stand in group `place`; `None` for the settings.
    pub fn of_group(place: usize) -> Option<Element> {
        Element::all().nth(place)
    }

    /// Place of its group in [`GROUPS`].
    pub const fn place(self) -> usize {
        self.place
    }

    /// Its name.
    pub const fn name(self) -> &'static str {
        self.group.name
    }

    /// What it is, and its rows.
    pub const fn group(self) -> &'static Group {
        self.group
    }

    pub(crate) const fn bit(self) -> u64 {
        1 << self.place
    }
}

impl Row {
    /// The element it belongs to; `None` for the settings.
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

/// Its name in quotes.
impl fmt::Debug for Element {
    // Inline for the same reason as above: the formatting that it calls can panic.
    #[inline]
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        fmt::Debug::fmt(self.name(), f)
    }
}

/// Its name.
impl fmt::Display for Element {
    #[inline]
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The [`Number`](crate::parameter::Number) of a name, looked up when the code is compiled.
///
/// ```
/// # use dashpot_core::{Params, number};
/// let mut params = Params::new();
/// params.set(number!("series_stiffness"), 3e6).unwrap();
/// assert_eq!(params.number(number!("series_stiffness")), 3e6);
/// ```
///
/// A name that no parameter has does not compile:
///
/// ```compile_fail,E0080
/// # use dashpot_core::number;
/// let k = number!("series_stifness");
/// ```
///
/// nor does that of a list:
///
/// ```compile_fail,E0080
/// # use dashpot_core::number;
/// let force = number!("fv_force");
/// ```
#[macro_export]
macro_rules! number {
    ($name:literal) => {{
        // A constant of its own, not `const { }`: `cargo check` looks at it too.
        const ID: $crate::parameter::Number = $crate::parameter::Number::named($name);
        ID
    }};
}

/// The [`List`](crate::parameter::List) of a name, looked up when the code is compiled.
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
/// nor does that of a number:
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

/// The [`Element`](crate::parameter::Element) of a name, looked up when the code is compiled.
///
/// ```
/// # use dashpot_core::{Params, element};
/// let mut params = Params::new();
/// params.enable(element!("bushing"), true);
/// assert!(params.is_on(element!("bushing")));
/// ```
///
/// A name that no element has does not compile:
///
/// ```compile_fail,E0080
/// # use dashpot_core::element;
/// let element = element!("bushings");
/// ```
///
/// nor does that of the settings, which are always on:
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
