//! The parameter table.
//!
//! Every element of the damper model defines its rows (name, unit, default, bounds, meaning). The table contains the
//! rows of all elements, in the order of the element list ([`mod@crate::list`]). The C setter, the model file, the
//! bounds of the identification and the documentation follow from the table.
//!
//! | module | content |
//! |---|---|
//! | [`groups`] | the rows by element, and the position of each element |
//! | [`row`] | the rows in sequence, and the search by name |
//! | [`id`] | typed identifiers of rows and elements, checked by the compiler |
//! | [`values`] | the values that a user supplies |

pub mod groups;
pub mod id;
pub mod row;
pub mod values;

pub use crate::schema::{Group, Parameter, Shape};
pub use groups::{Acts, ELEMENTS, GROUPS, acts, names};
pub use id::{Element, Id, List, Number};
pub use row::{COUNT, Row, SLOTS, find, table};
pub use values::Params;
