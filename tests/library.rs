//! Builds the C library `libdashpot` as it ships, and host programs that link it.

use dashpot_test_support::{profile_folder, target_folder};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// Language and compiler of a host program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// C99, by `$CC` or gcc.
    C,
    /// C++11, by `$CXX` or g++.
    Cxx,
}

/// Library that a host program links.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Linkage {
    /// `libdashpot.so`.
    Shared,
    /// `libdashpot.a`.
    Static,
}

/// Returns the root folder of the project.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the project's root").to_path_buf()
}

/// Returns the directory with the shared and the static library of a release build, built once per process.
pub fn directory() -> &'static Path {
    static DIRECTORY: OnceLock<PathBuf> = OnceLock::new();
    DIRECTORY.get_or_init(|| {
        let mut build = Command::new(env!("CARGO"));
        build.args(["build", "--release", "--quiet", "-p", "dashpot-dll"]).current_dir(root());
        succeed(&mut build);
        let release = target_folder().join("release");
        let packed = target_folder().join("lib");
        std::fs::create_dir_all(&packed).expect("a folder of the target");
        pack(&release.join("libdashpot.a"), &packed.join("libdashpot.a"), "");
        if release != profile_folder() {
            // The program `dashpot` uses the library in its own folder. Cargo's file of this name is a hard link, so
            // overwriting it would change another file of cargo. Therefore, a copy replaces the link.
            let mut copy = tempfile::NamedTempFile::new_in(profile_folder()).expect("room beside the command");
            let mut library = std::fs::File::open(static_library_in(&packed)).expect("the library");
            std::io::copy(&mut library, &mut copy).expect("room beside the command");
            copy.persist(profile_folder().join("libdashpot.a")).expect("the library beside the command");
        }
        release
    })
}

fn static_library_in(folder: &Path) -> PathBuf {
    folder.join("libdashpot.a")
}

/// Packs cargo's static library `from` to the file `to` as for shipping, with the binutils whose names begin with
/// `prefix`.
pub fn pack(from: &Path, to: &Path, prefix: &str) {
    succeed(Command::new("sh").arg(root().join("src/dll/static.sh")).args([from, to]).arg(prefix));
}

/// Returns the path of the static library, packed as for shipping.
pub fn static_library() -> PathBuf {
    directory();
    static_library_in(&target_folder().join("lib"))
}

/// Returns the path of the shared library.
pub fn shared() -> PathBuf {
    directory().join("libdashpot.so")
}

/// Runs a command that must succeed. Returns its standard output.
pub fn succeed(command: &mut Command) -> String {
    let Output { status, stdout, stderr } = command.output().unwrap_or_else(|error| {
        panic!(
            "{:?} cannot be run ({error}); these tests need gcc, g++ and binutils, or $CC and $CXX",
            command.get_program()
        )
    });
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert!(status.success(), "{command:?}: {status}\n{}{}", text(&stdout), text(&stderr));
    text(&stdout)
}

/// Returns a command that runs the compiler with strict flags, under which `include/dashpot.h` must compile without a
/// warning.
pub fn compiler(language: Language) -> Command {
    let (variable, default, standard) = match language {
        Language::C => ("CC", "gcc", "-std=c99"),
        Language::Cxx => ("CXX", "g++", "-std=c++11"),
    };
    let mut compiler = Command::new(std::env::var_os(variable).unwrap_or(default.into()));
    compiler.args([standard, "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-O1", "-g"]);
    compiler.arg("-I").arg(root().join("include"));
    compiler
}

/// Compiles the host program `tests/hosts/<source>` (or an absolute path) with further `flags` into the folder `to`,
/// linked with `libdashpot`. Returns the path of the program.
pub fn host(source: &str, language: Language, linkage: Linkage, flags: &[&str], to: &Path) -> PathBuf {
    let name = Path::new(source).file_stem().expect("a source file").to_string_lossy();
    let program = to.join(format!("{name}-{language:?}-{linkage:?}-{}", flags.len()));
    let mut compiler = compiler(language);
    compiler.args(flags).arg(root().join("tests/hosts").join(source)).arg("-o").arg(&program);
    match linkage {
        Linkage::Shared => {
            compiler.arg(shared()).arg(format!("-Wl,-rpath,{}", directory().display()));
        }
        Linkage::Static => {
            compiler.arg(static_library());
        }
    }
    compiler.arg("-lm");
    succeed(&mut compiler);
    program
}
