//! What the tests of all crates share.
//!
//! The sources, seeds of property tests and numbers drawn from one, tests that cannot run on a machine, and where
//! cargo puts what it builds. Also the inputs of situations that users reported.

mod built;
mod random;
mod reports;
mod seeds;
mod skips;
mod sources;

pub use built::{profile_folder, target_folder};
pub use random::Random;
pub use reports::reported;
pub use seeds::{drawn, held, of_the_code};
pub use skips::{counted, skipped};
pub use sources::rust_files;
