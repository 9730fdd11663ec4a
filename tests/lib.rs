//! What the whole-system tests share.

pub mod header;
pub mod library;
