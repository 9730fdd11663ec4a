//! Where cargo puts what it builds.

use std::path::PathBuf;

/// The folder of what is built as this test is.
///
/// # Panics
/// Where the test was not started by cargo's path.
pub fn profile_folder() -> PathBuf {
    // target/<profile>/deps/<this test>
    let test = std::env::current_exe().expect("the path of this test");
    test.ancestors().nth(2).expect("a target directory").to_owned()
}

/// The folder of all that is built.
///
/// # Panics
/// As [`profile_folder`].
pub fn target_folder() -> PathBuf {
    profile_folder().parent().expect("a target directory").to_owned()
}
