//! Locations of cargo's build output.

use std::path::PathBuf;

/// Returns the folder of the build profile of this test, such as `target/release`.
///
/// # Panics
/// If the test does not run from cargo's folder.
pub fn profile_folder() -> PathBuf {
    // The path of the test is target/<profile>/deps/<test>.
    let test = std::env::current_exe().expect("the path of this test");
    test.ancestors().nth(2).expect("a target directory").to_owned()
}

/// Returns cargo's target directory.
///
/// # Panics
/// If the test does not run from cargo's folder, see [`profile_folder`].
pub fn target_folder() -> PathBuf {
    profile_folder().parent().expect("a target directory").to_owned()
}
