//! What the whole-system tests share.

pub mod bridge;
pub mod cli;
pub mod header;
pub mod library;
pub mod python;
