//! Code shared by the tests of all crates.
//!
//! The crate covers the Rust sources, seeds of property tests, random numbers from a seed, skipped tests, and locations
//! of cargo's build output. It also locates the inputs of problems that users reported.

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
