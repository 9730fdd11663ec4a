//! Seeds of property tests: other cases whenever the code has changed, and the same again on demand.

use crate::sources::rust_files;
use proptest::test_runner::{Config, RngSeed};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::{fs, io};

/// The variable that holds the seed of a run that is to be repeated, or of one with other cases; proptest's own name for it.
const VARIABLE: &str = "PROPTEST_RNG_SEED";

/// What is hashed into the seed: the sources of all crates, and of the tests.
const SOURCES: [&str; 2] = ["../../src", "../../tests"];

/// The settings of a property test of so many cases. Its seed is read off the sources, and printed, so that a failure shows how to get it
/// again.
///
/// Whoever changes the code gets cases that nobody has run; what passed once passes wherever the same code is tested again. Runs for the
/// night give the variable a number of their own.
///
/// # Panics
/// Where the variable holds no number, or the sources cannot be read.
#[must_use]
pub fn drawn(cases: u32) -> Config {
    with(cases, asked().unwrap_or_else(of_the_code))
}

/// The settings of a property that is known not to hold everywhere: the same cases in every run, and others where [`VARIABLE`] asks for them.
/// Where it is used stands what other seeds find.
///
/// # Panics
/// Where the variable holds no number.
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
    // Without the files that proptest leaves beside the sources: the line above says the same.
    Config { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(seed), ..Config::default() }
}

/// The seed that the sources give: for a search that draws and prints by itself.
///
/// # Panics
/// Where the sources cannot be read.
#[must_use]
pub fn of_the_code() -> u64 {
    static SEED: OnceLock<u64> = OnceLock::new();
    *SEED.get_or_init(|| {
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        of_sources(&SOURCES.map(|folder| here.join(folder))).expect("the sources that these tests were built from")
    })
}

/// One number for all Rust files in some folders, wherever the folders lie.
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
