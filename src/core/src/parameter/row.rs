//! The rows of the parameter table, group by group.

use crate::fault::{Fault, Reason};
use crate::parameter::groups::GROUPS;
use crate::schema::Parameter;

/// Number of rows of the parameter table.
pub const COUNT: usize = {
    let (mut n, mut g) = (0, 0);
    while g < GROUPS.len() {
        n += GROUPS[g].parameters.len();
        g += 1;
    }
    n
};

/// Number of values in a full parameter set, with every list at its capacity. A slot is an index of a value.
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

/// Returns the table index of the first row of a group, and the slot of its first value.
pub(crate) const fn start_of(group: usize) -> (usize, usize) {
    let (mut index, mut slot, mut g) = (0, 0, 0);
    while g < group {
        index += GROUPS[g].parameters.len();
        slot += slots_of(GROUPS[g].parameters);
        g += 1;
    }
    (index, slot)
}

/// Returns the number of values of these rows, with every list at its capacity.
pub(crate) const fn slots_of(rows: &[Parameter]) -> usize {
    let (mut slots, mut row) = (0, 0);
    while row < rows.len() {
        slots += rows[row].slots();
        row += 1;
    }
    slots
}

/// Returns all rows of the parameter table in order, each with its group and the slot of its first value.
pub fn table() -> impl Iterator<Item = Row> {
    Rows { index: 0, group: 0, local: 0, slot: 0 }
}

/// Iterator of [`table`]. The fields describe the next row: its index in the table, its group, its index in the group,
/// and the slot of its first value.
struct Rows {
    index: usize,
    group: usize,
    local: usize,
    slot: usize,
}

impl Iterator for Rows {
    type Item = Row;

    // Not inlined, because a dozen functions iterate over the table, and their speed is not critical.
    #[inline(never)]
    fn next(&mut self) -> Option<Row> {
        loop {
            let Some(parameter) = GROUPS.get(self.group)?.parameters.get(self.local) else {
                (self.group, self.local) = (self.group + 1, 0);
                continue;
            };
            let row = Row { index: self.index, group: self.group, slot: self.slot, parameter };
            (self.index, self.local, self.slot) = (self.index + 1, self.local + 1, self.slot + parameter.slots());
            return Some(row);
        }
    }
}

/// A row of [`table`].
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Index of the row in the parameter table.
    pub index: usize,
    /// Index of the row's group in [`GROUPS`].
    pub group: usize,
    pub(crate) slot: usize,
    /// Name, unit, bounds, default and meaning.
    pub parameter: &'static Parameter,
}

impl PartialEq for Row {
    fn eq(&self, other: &Row) -> bool {
        self.index == other.index
    }
}

impl Eq for Row {}

impl Row {
    /// Makes a fault that names this row.
    pub const fn fault(&self, reason: Reason) -> Fault {
        Fault { parameter: self.index as u16, reason }
    }
}

/// Finds the row with a name that is known only at run time; `None` if no row has the name. For a name known in code
/// use [`crate::number!`] or [`crate::list!`].
pub fn find(name: &str) -> Option<Row> {
    table().find(|row| row.parameter.name == name)
}
