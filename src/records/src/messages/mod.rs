//! The messages of this crate: their texts, and the insertion of values.

pub mod newtons;
pub(crate) mod phrases;
pub mod sentence;
