//! Code shared by the tests of all crates.
//!
//! The crate lists the Rust sources, provides seeds of property tests and random numbers from a seed, and counts
//! skipped tests. It also finds cargo's build output and the input files of problems that users reported.

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
