//! The table: the rows of all groups one after the other.

use crate::fault::{Fault, Reason};
use crate::parameter::groups::GROUPS;
use crate::schema::Parameter;

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
    pub(crate) slot: usize,
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
