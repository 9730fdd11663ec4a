//! The messages of this crate, and how forces are written in them.

pub mod newtons;
pub(crate) mod phrases;
