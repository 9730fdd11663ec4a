//! The library for Adams as it is shipped, and a stand-in solver that loads it as Adams does.

use crate::library::{directory, root, succeed};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// Folder of this test run's builds; lives as long as the process.
fn folder() -> &'static Path {
    static FOLDER: OnceLock<tempfile::TempDir> = OnceLock::new();
    FOLDER.get_or_init(|| tempfile::tempdir().expect("a directory")).path()
}

/// The library, built by its own makefile.
pub fn library() -> &'static Path {
    static LIBRARY: OnceLock<PathBuf> = OnceLock::new();
    LIBRARY.get_or_init(|| {
        let target = folder().join("dashpot_adams.so");
        let mut make = Command::new("make");
        make.arg("-s").arg("-C").arg(root().join("adams-usersub"));
        make.arg(format!("LIBRARY={}", directory().join("libdashpot.a").display()));
        make.arg(format!("OUTPUT={}", target.display())).arg("CFLAGS=-std=c99 -O2 -Wall -Wextra -Wpedantic -Werror");
        succeed(&mut make);
        target
    })
}

/// The stand-in solver; `flags` for the compiler, such as one that leaves a utility function out.
pub fn solver(flags: &[&str]) -> PathBuf {
    let program = folder().join(format!("solver{}", flags.concat()));
    // Tests run side by side: each builds under a name of its own, then puts it in place.
    let build = tempfile::Builder::new().tempdir_in(folder()).expect("a directory");
    let built = build.path().join("solver");
    let mut compiler = Command::new(std::env::var_os("CC").unwrap_or("gcc".into()));
    compiler.args(["-std=gnu99", "-Wall", "-Wextra", "-Werror", "-O2", "-rdynamic"]).args(flags);
    compiler.arg("-I").arg(root().join("include")).arg(root().join("tests/adams/solver.c"));
    compiler.arg("-o").arg(&built).args(["-ldl", "-lm", "-lpthread"]);
    succeed(&mut compiler);
    std::fs::rename(&built, &program).expect("the program");
    program
}

/// An accepted instant, in model units: s, mm, mm/s, N as an SFORCE has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accepted {
    /// Time.
    pub t: f64,
    /// Displacement, extension positive.
    pub x: f64,
    /// Velocity.
    pub v: f64,
    /// SFORCE: negative where the damper is in tension.
    pub sforce: f64,
}

/// What a run printed.
#[derive(Debug, Clone)]
pub struct Run {
    /// Exit code: 0, or 3 where a routine stopped the run.
    pub code: Option<i32>,
    /// All lines.
    pub text: String,
}

impl Run {
    /// Numbers behind a word at the beginning of a line.
    fn lines_of(&self, word: &str) -> Vec<Vec<f64>> {
        let lines = self.text.lines().filter_map(|l| l.strip_prefix(word)?.strip_prefix(' '));
        lines.map(|l| l.split(' ').map(|n| n.parse().expect("a number")).collect()).collect()
    }

    /// Accepted instants.
    pub fn accepted(&self) -> Vec<Accepted> {
        self.lines_of("at").iter().map(|n| Accepted { t: n[0], x: n[1], v: n[2], sforce: n[3] }).collect()
    }

    /// The eight results of the request at the end.
    pub fn request(&self) -> Vec<f64> {
        self.lines_of("request")[0].clone()
    }

    /// Displacement and SFORCE of the static equilibrium.
    pub fn statics(&self) -> (f64, f64) {
        let n = &self.lines_of("static")[0];
        (n[0], n[1])
    }

    /// Sums of each thread, alone and together.
    pub fn threads(&self) -> Vec<(f64, f64)> {
        self.lines_of("thread").iter().map(|n| (n[0], n[1])).collect()
    }

    /// A count of the last line: calls, differencing, iterations, rejected, threadsafe.
    pub fn count(&self, what: &str) -> u64 {
        let words: Vec<&str> = self.text.lines().last().expect("a line").split(' ').collect();
        let at = words.iter().position(|w| *w == what).unwrap_or_else(|| panic!("no count {what} in {self:?}"));
        words[at + 1].parse().expect("a count")
    }
}

/// Runs the library in a solver.
pub fn run(solver: &Path, routine: &str, settings: &[String]) -> Run {
    let mut command = Command::new(solver);
    command.arg(library()).arg(routine).args(settings);
    let output = command.output().expect("the solver runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(matches!(output.status.code(), Some(0 | 3)), "{command:?}: {}\n{errors}", output.status);
    Run { code: output.status.code(), text: String::from_utf8(output.stdout).expect("text") }
}
