//! The messages of this crate: their texts, and how values are put into them.

pub mod newtons;
pub(crate) mod phrases;
pub mod sentence;
