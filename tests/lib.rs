//! Code that the tests of the whole system share.

pub mod adams;
pub mod bridge;
pub mod cli;
pub mod dataset;
pub mod expression;
pub mod fmu;
pub mod header;
pub mod hostile;
pub mod kernel_campaign;
pub mod library;
pub mod measured;
pub mod python;
