//! What the tests of all crates share: seeds of property tests, and tests that cannot run on a machine.

mod seeds;
mod skips;

pub use seeds::{drawn, held};
pub use skips::{counted, skipped};
