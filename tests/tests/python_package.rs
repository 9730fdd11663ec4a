//! Tests the Python package as its users install it.
//!
//! The test builds a wheel, installs it without the source tree on the path, and tests the installed package.
//!
//! Building the wheel compiles the workspace again, with unwinding on panics, and the required packages have half a
//! gigabyte. Therefore `cargo test --profile tests` excludes this test. Run it with `cargo test --profile tests -p dashpot-tests
//! --test python_package -- --ignored --nocapture`.

use dashpot_test_support::{skipped, target_folder};
use dashpot_tests::cli::program;
use dashpot_tests::fmu::runtimes;
use dashpot_tests::library::{root, shared, static_library};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Python package of the tool that builds the wheel. [`PACKAGES`] are the packages for the wheel's tests.
const BUILD: &str = "maturin>=1.9,<2";
const PACKAGES: [&str; 13] = [
    "numpy",
    "pytest",
    "mypy",
    "pyright",
    "pandas",
    "matplotlib",
    "pyarrow",
    "dask",
    "distributed",
    "dask-jobqueue",
    "nbclient",
    "ipykernel",
    "xarray",
];

fn runs(command: &mut Command) -> Result<(), String> {
    match command.output() {
        Ok(out) if out.status.success() => Ok(()),
        Ok(out) => Err(String::from_utf8_lossy(&[out.stdout, out.stderr].concat()).trim().to_owned()),
        Err(error) => Err(error.to_string()),
    }
}

/// Creates a Python environment with all required packages, and returns its folder of programs. Returns `None` and
/// reports a skipped test if that is impossible.
fn environment(target: &Path) -> Option<PathBuf> {
    let folder = target.join("python-venv");
    let (bin, done) = (folder.join("bin"), folder.join("packages.txt"));
    let wanted = [&[BUILD], &PACKAGES[..]].concat();
    if std::fs::read_to_string(&done).is_ok_and(|had| had == wanted.join("\n")) {
        return Some(bin);
    }
    let made = runs(Command::new("python3").args(["-m", "venv"]).arg(&folder))
        .and_then(|()| runs(Command::new(bin.join("python")).args(["-m", "pip", "install", "--quiet"]).args(&wanted)));
    if let Err(told) = made {
        skipped(format!("Python with {} does not install here: {told}", wanted.join(", ")));
        return None;
    }
    std::fs::write(&done, wanted.join("\n")).expect("a mark");
    Some(bin)
}

#[test]
#[ignore = "builds the workspace once more for the wheel and installs half a gigabyte: run it with -- --ignored"]
fn the_wheel_does_what_the_command_does() {
    let Some(bin) = environment(&target_folder()) else { return };
    // The program `dashpot` and the wheel export equal bytes only if both contain the same compiled runtimes. A program
    // without runtimes compiles one at export.
    runtimes();
    let sources = root().join("src/python");
    let wheels = tempfile::tempdir().expect("a directory");
    let mut build = Command::new(bin.join("maturin"));
    build.args(["build", "--release", "--quiet", "--interpreter"]).arg(bin.join("python"));
    build.arg("--out").arg(wheels.path()).current_dir(&sources);
    runs(&mut build).unwrap_or_else(|told| panic!("maturin: {told}"));
    let wheel = std::fs::read_dir(wheels.path()).expect("a folder").next().expect("a wheel").expect("an entry").path();
    let mut install = Command::new(bin.join("python"));
    install.args(["-m", "pip", "install", "--quiet", "--force-reinstall", "--no-deps"]).arg(&wheel);
    runs(&mut install).unwrap_or_else(|told| panic!("pip: {told}"));
    let mut pytest = Command::new(bin.join("python"));
    pytest.args(["-m", "pytest", "-q", "-rs", "-p", "no:cacheprovider"]).arg(sources.join("tests"));
    pytest.current_dir(wheels.path()).env("PYTHONDONTWRITEBYTECODE", "1").env("DASHPOT_COMMAND", program());
    // The tests of the documentation's Python examples load the shared library from the folder of the static library.
    let library = wheels.path().join("libdashpot.a");
    std::fs::copy(static_library(), &library).expect("the static library");
    std::fs::copy(shared(), library.with_extension("so")).expect("the shared library");
    pytest.env("DASHPOT_LIBRARY", library);
    let ran = pytest.output().expect("pytest");
    let said = String::from_utf8_lossy(&ran.stdout);
    println!("{said}");
    assert!(ran.status.success(), "{said}{}", String::from_utf8_lossy(&ran.stderr));
}
