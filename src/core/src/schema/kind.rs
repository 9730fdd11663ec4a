//! Types for the kind of a parameter row: number or list.

/// Kind of the value of a parameter row: one number or a list.
pub trait Kind: Copy + 'static {
    /// Whether the row contains a list.
    const IS_LIST: bool;
}

/// Kind of the rows that contain one number, or the index of a choice.
#[derive(Clone, Copy, Debug)]
pub struct One;

/// Kind of the rows that contain a list of numbers.
#[derive(Clone, Copy, Debug)]
pub struct Many;

impl Kind for One {
    const IS_LIST: bool = false;
}

impl Kind for Many {
    const IS_LIST: bool = true;
}

/// Compiler message if code names a list where it requires a number, or the reverse.
pub(crate) const OTHER_KIND: &str = "this parameter is a list where a number is meant, or the reverse";

/// Returns whether two names are equal. For constant expressions, where `==` is not available.
pub(crate) const fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    if a.len() != b.len() {
        return false;
    }
    let mut i = 0;
    while i < a.len() {
        if a[i] != b[i] {
            return false;
        }
        i += 1;
    }
    true
}
