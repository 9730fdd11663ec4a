//! Seeds of property tests: the cases change with the code, and a given seed repeats a run.

use crate::sources::rust_files;
use proptest::test_runner::{Config, RngSeed};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::{fs, io};

/// Environment variable, named by the crate proptest, that sets the seed of property tests, to repeat a run or to
/// select other cases.
const VARIABLE: &str = "PROPTEST_RNG_SEED";

/// Folders of the sources whose hash is the default seed: all crates and tests.
const SOURCES: [&str; 2] = ["../../src", "../../tests"];

/// Returns the settings of a property test with `cases` cases. Its seed is a hash of the sources, unless [`VARIABLE`]
/// sets another seed. The seed is printed for reproduction.
///
/// Changed code thus gets new cases, and unchanged code always gets the same cases. A run with the variable set gets
/// other cases.
///
/// # Panics
/// If the variable is not a number, or the sources are not readable.
#[must_use]
pub fn drawn(cases: u32) -> Config {
    with(cases, asked().unwrap_or_else(of_the_code))
}

/// Returns the settings of a property test with `cases` cases that is known to fail for some seeds. The seed is `seed`,
/// unless [`VARIABLE`] sets another seed.
///
/// A comment at each call of this function states the results with other seeds.
///
/// # Panics
/// If the variable is not a number.
#[must_use]
pub fn held(cases: u32, seed: u64) -> Config {
    with(cases, asked().unwrap_or(seed))
}

fn asked() -> Option<u64> {
    let text = std::env::var(VARIABLE).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{VARIABLE}={text} is not a number")))
}

fn with(cases: u32, seed: u64) -> Config {
    println!("{VARIABLE}={seed} runs the same cases again");
    // Regression files of proptest are disabled, because the printed line contains the seed that repeats a failure.
    Config { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(seed), ..Config::default() }
}

/// Returns the hash of the sources as a seed, for a test without proptest that draws its own cases and prints its own
/// messages.
///
/// # Panics
/// If the sources are not readable.
#[must_use]
pub fn of_the_code() -> u64 {
    static SEED: OnceLock<u64> = OnceLock::new();
    *SEED.get_or_init(|| {
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        of_sources(&SOURCES.map(|folder| here.join(folder))).expect("the sources that these tests were built from")
    })
}

/// Hashes all Rust files in some folders, independent of the location of the folders.
fn of_sources(folders: &[PathBuf]) -> io::Result<u64> {
    let mut hasher = DefaultHasher::new();
    for folder in folders {
        for file in rust_files(folder)? {
            file.strip_prefix(folder).unwrap_or(&file).hash(&mut hasher);
            fs::read(&file)?.hash(&mut hasher);
        }
    }
    Ok(hasher.finish())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_code_draws_the_same_cases_and_any_change_draws_others() {
        let places = [(); 2].map(|()| tempfile::tempdir().unwrap());
        let seed = |place: &tempfile::TempDir| of_sources(&[place.path().to_owned()]).unwrap();
        for place in &places {
            fs::create_dir(place.path().join("elements")).unwrap();
            fs::write(place.path().join("elements/oil.rs"), "k").unwrap();
            fs::write(place.path().join("step.rs"), "c").unwrap();
        }
        assert_eq!(seed(&places[0]), seed(&places[1]));
        let before = seed(&places[0]);
        fs::write(places[0].path().join("elements/oil.rs"), "2 k").unwrap();
        assert_ne!(seed(&places[0]), before);
    }

    #[test]
    fn the_sources_of_this_build_are_found() {
        let mut files = Vec::new();
        for folder in SOURCES {
            files.extend(rust_files(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap());
        }
        for source in ["core/src/step.rs", "support/src/seeds.rs"] {
            assert!(files.iter().any(|file| file.ends_with(source)), "{source} among {} files", files.len());
        }
    }
}
