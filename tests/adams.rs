//! Builds the dashpot library for Adams as it ships, and runs it in a stand-in solver (`tests/adams/solver.c`) that
//! loads the library as Adams does.

use crate::library::{root, static_library, succeed};
use dashpot_core::{Input, Model, Params, model_file, step};
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// Returns the temporary folder in which this process builds libraries and programs.
fn folder() -> &'static Path {
    static FOLDER: OnceLock<tempfile::TempDir> = OnceLock::new();
    FOLDER.get_or_init(|| tempfile::tempdir().expect("a directory")).path()
}

/// Returns the path of the Adams library. The first call builds the library with `adams-usersub/Makefile`.
pub fn library() -> &'static Path {
    static LIBRARY: OnceLock<PathBuf> = OnceLock::new();
    LIBRARY.get_or_init(|| built("dashpot_adams.so", "-std=c99 -O2 -Wall -Wextra -Wpedantic -Werror"))
}

fn built(name: &str, flags: &str) -> PathBuf {
    let target = folder().join(name);
    let mut make = Command::new("make");
    make.arg("-s").arg("-C").arg(root().join("adams-usersub"));
    make.arg(format!("LIBRARY={}", static_library().display()));
    make.arg(format!("OUTPUT={}", target.display())).arg(format!("CFLAGS={flags}"));
    succeed(&mut make);
    target
}

/// Compiles the sources of the stand-in solver with further compiler `flags`, and returns the paths of the object
/// files.
fn objects(flags: &[&str]) -> Vec<PathBuf> {
    ["solver", "dataset", "expression"]
        .iter()
        .map(|name| {
            let object = folder().join(format!("{name}{}.o", flags.concat()));
            // Tests run in parallel. Each test compiles in its own folder and then moves the object file, so that no
            // other test reads an incomplete file.
            let build = tempfile::Builder::new().tempdir_in(folder()).expect("a directory");
            let built = build.path().join("object.o");
            let mut compiler = compiler();
            compiler.args(["-std=gnu99", "-Wall", "-Wextra", "-Werror", "-O2", "-c"]).args(flags);
            compiler.arg("-I").arg(root().join("include")).arg(root().join(format!("tests/adams/{name}.c")));
            succeed(compiler.arg("-o").arg(&built));
            std::fs::rename(&built, &object).expect("the object file");
            object
        })
        .collect()
}

fn compiler() -> Command {
    Command::new(std::env::var_os("CC").unwrap_or("gcc".into()))
}

fn linked(name: &str, flags: &[&str], objects: &[PathBuf], arguments: &[String]) -> PathBuf {
    let program = folder().join(name);
    let build = tempfile::Builder::new().tempdir_in(folder()).expect("a directory");
    let built = build.path().join("solver");
    let mut linker = compiler();
    linker.args(flags).args(objects).args(arguments).arg("-o").arg(&built).args(["-ldl", "-lm", "-lpthread"]);
    succeed(&mut linker);
    std::fs::rename(&built, &program).expect("the program");
    program
}

/// Returns the path of the stand-in solver, which exports all utility functions (`c_...`) that the library may call.
pub fn solver() -> PathBuf {
    static SOLVER: OnceLock<PathBuf> = OnceLock::new();
    SOLVER.get_or_init(|| linked("solver", &[], plain_objects(), &["-rdynamic".into()])).clone()
}

fn plain_objects() -> &'static [PathBuf] {
    static OBJECTS: OnceLock<Vec<PathBuf>> = OnceLock::new();
    OBJECTS.get_or_init(|| objects(&[]))
}

/// Returns the paths of the stand-in solver and the library, both built with the compiler's race detector. Returns
/// `None` if the compiler has no working race detector.
pub fn watched_for_races() -> Option<(PathBuf, PathBuf)> {
    let flag = "-fsanitize=thread";
    let probe = folder().join("probe.c");
    std::fs::write(&probe, "int main(void) { return 0; }\n").expect("a file");
    let program = folder().join("probe");
    let works = compiler().arg(flag).arg(&probe).arg("-o").arg(&program).output().is_ok_and(|o| o.status.success())
        && Command::new(&program).status().is_ok_and(|s| s.success());
    if !works {
        return None;
    }
    let solver = linked("solver-races", &[flag], &objects(&[flag, "-g"]), &["-rdynamic".into()]);
    Some((solver, built("dashpot_adams_races.so", &format!("-std=c99 -O1 -g {flag}"))))
}

/// Lists the names of the utility functions (`c_...`) that the stand-in solver exports.
pub fn utilities() -> Vec<String> {
    let listed = succeed(Command::new("nm").args(["--defined-only", "-g"]).arg(&plain_objects()[0]));
    let names = listed.lines().filter_map(|l| l.split(' ').nth(2));
    names.filter(|n| n.starts_with("c_")).map(String::from).collect()
}

/// Builds a stand-in for a release of Adams that lacks the utility function `utility`. Returns the path of the program.
pub fn solver_without(utility: &str) -> PathBuf {
    let others: String = utilities().iter().filter(|n| *n != utility).map(|n| format!("{n};")).collect();
    let list = folder().join(format!("without-{utility}"));
    std::fs::write(&list, format!("{{{others}}};")).expect("a file");
    let export = format!("-Wl,--dynamic-list={}", list.display());
    linked(&format!("solver-without-{utility}"), &[], plain_objects(), &[export])
}

/// Time point that the stand-in solver has accepted, in the units s, mm and N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accepted {
    /// Time, s.
    pub t: f64,
    /// Displacement, mm, extension positive.
    pub x: f64,
    /// Velocity, mm/s, extension positive.
    pub v: f64,
    /// Value of the SFORCE (Adams's single-component force), N, negative if the damper is in tension.
    pub sforce: f64,
}

/// Output of a run of the stand-in solver.
#[derive(Debug, Clone)]
pub struct Run {
    /// Exit code: 0, or 3 if a user subroutine of the library stopped the run.
    pub code: Option<i32>,
    /// All lines of the standard output, then those of the standard error.
    pub text: String,
}

impl Run {
    /// Parses the numbers in all lines of the output that begin with `word`.
    fn lines_of(&self, word: &str) -> Vec<Vec<f64>> {
        let lines = self.text.lines().filter_map(|l| l.strip_prefix(word)?.strip_prefix(' '));
        lines.map(|l| l.split(' ').map(|n| n.parse().expect("a number")).collect()).collect()
    }

    /// Returns the accepted time points of the run.
    pub fn accepted(&self) -> Vec<Accepted> {
        self.lines_of("at").iter().map(|n| Accepted { t: n[0], x: n[1], v: n[2], sforce: n[3] }).collect()
    }

    /// Returns the eight results of the library's REQUEST subroutine at the last accepted time point.
    pub fn request(&self) -> Vec<f64> {
        self.lines_of("request")[0].clone()
    }

    /// Returns the displacement, mm, and the value of the SFORCE, N, in the static equilibrium.
    pub fn statics(&self) -> (f64, f64) {
        let n = &self.lines_of("static")[0];
        (n[0], n[1])
    }

    /// Returns the largest difference between the partial derivatives that the library supplies and finite differences.
    /// The difference is relative to the largest entry in the row of the Jacobian, and 0 without the argument
    /// `partials=2`.
    pub fn partials_off(&self) -> f64 {
        self.lines_of("partials_off")[0][0]
    }

    /// Returns the last partial derivative of the force with respect to the Adams VARIABLE that contains the damper's
    /// setting, in units of the solver's model. Returns 0 without such a VARIABLE.
    pub fn by_variable(&self) -> f64 {
        self.lines_of("by_variable")[0][0]
    }

    /// Returns one row for each case of a GFORCE (Adams's general force) between two bodies in space.
    ///
    /// A row has the positions of both ends (6 numbers, mm), their velocities (6, mm/s) and the guide force (3, N).
    /// Then it has the force on marker I (3, N), the sum of the moment's absolute components, and the relative error of
    /// the partial derivatives.
    pub fn in_space(&self) -> Vec<Vec<f64>> {
        self.lines_of("space")
    }

    /// Returns the end time, s, and the accepted time points of each simulation in a command file.
    pub fn simulations(&self) -> Vec<(f64, Vec<Accepted>)> {
        let parts = self.text.split("simulation ").skip(1);
        let one = |part: &str| {
            let end = part.lines().next().expect("a line").parse().expect("a number");
            (end, Run { code: self.code, text: part.into() }.accepted())
        };
        parts.map(one).collect()
    }

    /// Returns two sums of forces and state derivatives for each thread. The first is computed by the thread alone, the
    /// second in parallel with the other threads.
    pub fn threads(&self) -> Vec<(f64, f64)> {
        self.lines_of("thread").iter().map(|n| (n[0], n[1])).collect()
    }

    /// Returns the counter `what` from the last line of the output: calls, differencing, iterations, rejected or
    /// threadsafe.
    pub fn count(&self, what: &str) -> u64 {
        let line =
            self.text.lines().find(|l| l.starts_with("calls ")).unwrap_or_else(|| panic!("no counts in {self:?}"));
        let words: Vec<&str> = line.split(' ').collect();
        let at = words.iter().position(|w| *w == what).unwrap_or_else(|| panic!("no count {what} in {self:?}"));
        words[at + 1].parse().expect("a count")
    }
}

/// Runs the Adams library in a stand-in solver: `routine` is one of [`ROUTINES`], and `settings` are further arguments
/// of the solver.
pub fn run(solver: &Path, routine: &str, settings: &[String]) -> Run {
    run_library(solver, library(), routine, settings)
}

/// Runs a given build of the library in a stand-in solver. Panics if the exit code is neither 0 nor 3.
pub fn run_library(solver: &Path, library: &Path, routine: &str, settings: &[String]) -> Run {
    let mut command = Command::new(solver);
    command.arg(library).arg(routine).args(settings);
    let output = command.output().expect("the solver runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(matches!(output.status.code(), Some(0 | 3)), "{command:?}: {}\n{errors}", output.status);
    Run { code: output.status.code(), text: String::from_utf8(output.stdout).expect("text") + &errors }
}

/// Model file with the elements of most dampers.
pub const PLAIN: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"stribeck_friction\", \
                     \"viscous_friction\", \"parallel_spring\", \"gas_preload\"]\n";
/// Model file with elements that have internal states and respond to side force.
pub const FULL: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"stribeck_friction\", \
                    \"side_force_friction\", \"gas_preload\", \"lagged_polynomial\"]\npolynomial = [3.0, 400.0, -25.0, 60.0]\n";
/// Number of states of [`PLAIN`].
pub const PLAIN_STATES: u32 = 2;
/// Number of states of [`FULL`].
pub const FULL_STATES: u32 = 3;

/// Arguments of the stand-in solver for the user subroutines that compute a force: GSESUB, SFOSUB and GFOSUB.
pub const ROUTINES: [&str; 3] = ["gse", "sfo", "gfo"];

/// Builds the kernel's model from the text of a model file.
pub fn model_of(text: &str) -> Model {
    let mut params = Params::new();
    model_file::read(text.as_bytes(), &mut params).unwrap();
    Model::new(&params).unwrap()
}

/// Writes the text of a model file into a folder as `damper.toml`, and returns its path.
pub fn written(folder: &Path, text: &str) -> PathBuf {
    let path = folder.join("damper.toml");
    std::fs::write(&path, text).unwrap();
    path
}

/// Lists the arguments of the stand-in solver for a run with the model file at `path`, followed by `more`.
pub fn with(path: &Path, more: &[&str]) -> Vec<String> {
    let mut settings = vec![format!("model={}", path.display())];
    settings.extend(more.iter().map(|s| s.to_string()));
    settings
}

/// Runs the Adams library in a stand-in solver and asserts that no user subroutine stops the run.
pub fn started(solver: &Path, routine: &str, settings: &[String]) -> Run {
    let run = run(solver, routine, settings);
    assert_eq!(run.code, Some(0), "{routine} {settings:?}: {}", run.text);
    run
}

/// Inputs of a damper in addition to its motion.
#[derive(Debug, Clone, Copy)]
pub struct Surroundings {
    /// Side force, N.
    pub side_force: f64,
    /// Temperature, degrees Celsius.
    pub temperature: f64,
}

impl Surroundings {
    /// No side force, at 20 °C.
    pub const NONE: Surroundings = Surroundings { side_force: 0.0, temperature: 20.0 };
}

/// Computes the expected SFORCE, N, with the kernel at the accepted time points of a rig simulation. The kernel's steps
/// are so short that the force has converged.
///
/// The displacement is a harmonic with `amplitude` in mm and `frequency` in Hz, and begins at its minimum.
pub fn kernel(model: &Model, accepted: &[Accepted], amplitude: f64, frequency: f64, around: Surroundings) -> Vec<f64> {
    let w = TAU * frequency;
    let longest = (0.05 / frequency / 1000.0).min(2e-5).max(2e-5 / frequency.min(1.0) / 10.0);
    let at = |t: f64| Input {
        side_force: around.side_force,
        temperature: around.temperature,
        ..Input::motion(-1e-3 * amplitude * (w * t).cos(), 1e-3 * amplitude * w * (w * t).sin())
    };
    let mut state = model.steady_state(&at(0.0));
    let mut t = 0.0;
    let mut forces = Vec::new();
    for point in accepted {
        let steps = ((point.t - t) / longest).ceil().max(1.0);
        let mut force = model.static_output(&at(0.0)).force;
        if point.t > t {
            for i in 1..=steps as usize {
                let to = at(t + (point.t - t) * i as f64 / steps);
                let (next, output) = step(model, &state, &to, (point.t - t) / steps);
                (state, force) = (next, output.force);
            }
        }
        t = point.t;
        forces.push(-force);
    }
    forces
}

/// Returns the largest deviation of the solver's SFORCE from the forces `want`, relative to the largest of these
/// forces.
pub fn deviation(got: &[Accepted], want: &[f64]) -> f64 {
    let largest = want.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    got.iter().zip(want).fold(0.0_f64, |m, (g, w)| m.max((g.sforce - w).abs())) / largest
}
