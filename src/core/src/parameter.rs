//! The one parameter table.
//!
//! Every element brings its rows (name, unit, default, bounds, meaning); the table is their sequence, in the order of the one list
//! ([`crate::list`]). It drives the C setter, the model file, the bounds of the identification and the documentation.
//!
//! | module | what |
//! |---|---|
//! | [`groups`] | the rows by element, and where each element acts |
//! | [`row`] | the rows one after the other, and how one is found by its name |
//! | [`id`] | which row or element is meant, checked when the code is compiled |
//! | [`values`] | the values a user fills in |

pub mod groups;
pub mod id;
pub mod row;
pub mod values;

pub use crate::schema::{Group, Parameter, Shape};
pub use groups::{Acts, ELEMENTS, GROUPS, acts, names};
pub use id::{Element, Id, List, Number};
pub use row::{COUNT, Row, SLOTS, find, table};
pub use values::Params;
