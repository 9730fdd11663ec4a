//! Tables of peak force over peak velocity.

mod clicks;
pub(crate) mod columns;
pub(crate) mod table;
