//! Functions that run the command-line program `dashpot`, and that make campaigns as its input.

use crate::library::{root, succeed};
use dashpot_test_support::profile_folder;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// Returns the path of the program `dashpot`, built once per process with the cargo profile of these tests.
pub fn program() -> &'static Path {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    PROGRAM.get_or_init(|| {
        // The library and the Python environment take a minute on one core. Tests of hosts would wait for them.
        std::thread::spawn(|| {
            crate::library::directory();
            crate::python::prepare();
        });
        build_program();
        profile_folder().join("dashpot")
    })
}

/// Builds the program `dashpot` with the cargo profile of the tests, so that most crates are not compiled again.
///
/// A program built with the release profile therefore unwinds on a panic, like the tests, whereas the shipped program
/// aborts. The build names no package, so that the features are those of the whole workspace.
pub fn build_program() {
    let mut build = Command::new(env!("CARGO"));
    let profile = profile_folder().file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let profile = if profile == "debug" { "dev" } else { &profile };
    build
        .args(["build", "--profile", profile, "--quiet", "--bin", "dashpot"])
        .env("CARGO_PROFILE_RELEASE_PANIC", "unwind");
    succeed(build.current_dir(root()));
}

/// Result of a run of the program `dashpot`.
#[derive(Debug)]
pub struct Ran {
    /// Exit code.
    pub code: Option<i32>,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
}

/// Runs `dashpot` in `folder`. The program must not panic. It must exit with 0 or 2, or with 1 if `--limits` or
/// `--strict` is among the arguments.
///
/// Exit code 1 means that a damper violates its limits, or that it chatters in a subcommand that checks for chatter.
pub fn run(folder: &Path, args: &[&str]) -> Ran {
    run_with(folder, args, &[])
}

/// Runs `dashpot` with additional environment variables, and checks its exit code as [`run`] does.
pub fn run_with(folder: &Path, args: &[&str], environment: &[(&str, &str)]) -> Ran {
    let mut command = Command::new(program());
    command.args(args).current_dir(folder).envs(environment.iter().copied());
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    let ran = Ran {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).expect("standard output is UTF-8"),
        err: String::from_utf8_lossy(&output.stderr).into_owned(),
    };
    assert!(!ran.err.contains("panicked"), "{args:?}: {ran:?}");
    let judged = args.contains(&"--limits") || args.contains(&"--strict");
    assert!(matches!(ran.code, Some(0 | 2)) || judged && ran.code == Some(1), "{args:?}: {ran:?}");
    ran
}

/// Runs `dashpot` in `folder`. The program must succeed. Returns its standard output.
pub fn done(folder: &Path, args: &[&str]) -> String {
    let ran = run(folder, args);
    assert_eq!(ran.code, Some(0), "{args:?}: {}", ran.err);
    ran.out
}

/// Runs `dashpot` in `folder`. The program must reject its input with a message on standard error and change no file.
/// Returns the message.
pub fn refused(folder: &Path, args: &[&str]) -> String {
    let before = contents(folder);
    let ran = run(folder, args);
    assert_eq!(ran.code, Some(2), "{args:?}: {ran:?}");
    assert!(ran.out.is_empty(), "{args:?}: {ran:?}");
    assert!(!ran.err.trim().is_empty(), "{args:?}");
    assert!(contents(folder) == before, "{args:?} changed files");
    ran.err
}

/// Returns every file below a folder with its bytes.
pub fn contents(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(contents(&path));
        } else {
            let bytes = std::fs::read(&path).expect("a file");
            files.push((path, bytes));
        }
    }
    files.sort();
    files
}

/// Reads a JSON file.
pub fn json(path: &Path) -> Value {
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Returns the number under `key` of a JSON object.
pub fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("no number {key} in {value}"))
}

/// Makes the records of a small campaign on the virtual rig: amplitudes of 50, 15 and 1 mm, and slow tests. The records
/// are in `records` below `folder`.
pub fn small_campaign(folder: &Path) {
    done(folder, &["matrix", "--amplitudes", "50,15,1", "--peak-velocities", "52,262,1047", "-o", "small.csv"]);
    done(folder, &["rig", "-o", "records", "--matrix", "small.csv", "--seed", "3"]);
}

/// Writes three sine tests of 20 mm, with peak velocities of 0.05, 0.2 and 0.5 m/s, into a folder.
///
/// `law` returns the force, N, tension positive, at a velocity, m/s, extension positive. The files contain displacement and force
/// multiplied by `sign`.
pub fn write_sines(folder: &Path, sign: f64, mut law: impl FnMut(f64) -> f64) {
    std::fs::create_dir_all(folder).expect("a folder");
    for (name, speed) in [("slow", 0.05), ("medium", 0.2), ("fast", 0.5)] {
        let rate = speed / 0.02;
        let mut text = String::from("time_s,displacement_mm,force_N\n");
        for sample in 0..2000 {
            let time = f64::from(sample) * 4.0 * std::f64::consts::TAU / rate / 2000.0;
            let (displacement, velocity) = (20.0 * (rate * time).sin(), speed * (rate * time).cos());
            text += &format!("{time:.6},{:.5},{:.3}\n", sign * displacement, sign * law(velocity));
        }
        std::fs::write(folder.join(format!("{name}.csv")), text).expect("a file");
    }
}

/// Header of the records in [`campaign_folder`].
pub const HEADER: &str = "time_s,displacement_m,velocity_m_s,force_N";

/// Formats a row of a record in the columns of [`HEADER`].
pub fn row(r: [f64; 4]) -> String {
    r.map(|v| format!("{v:.9}")).join(",")
}

/// Makes a folder with the records of [`small_campaign`] in `records`. The campaign is simulated once per process, and
/// its records are copied.
pub fn campaign_folder() -> tempfile::TempDir {
    static RECORDS: OnceLock<tempfile::TempDir> = OnceLock::new();
    let measured = RECORDS.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a directory");
        small_campaign(folder.path());
        folder
    });
    let folder = tempfile::tempdir().expect("a directory");
    rewrite(&measured.path().join("records"), &folder.path().join("records"), HEADER, row);
    folder
}

/// Reads header and rows of a record or of a result in CSV.
pub fn table(path: &Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let mut reader = csv::Reader::from_path(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let header = reader.headers().expect("a header").iter().map(String::from).collect();
    let rows = reader.records().map(|row| row.expect("a row").iter().map(|c| c.parse().expect("a number")).collect());
    (header, rows.collect())
}

/// Copies every record of folder `from` to folder `to`, with the header line `header`. `row` formats each row from
/// time, displacement, velocity and force.
pub fn rewrite(from: &Path, to: &Path, header: &str, row: impl Fn([f64; 4]) -> String) {
    std::fs::create_dir_all(to).expect("a folder");
    for entry in std::fs::read_dir(from).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|e| e != "csv") {
            continue;
        }
        let mut text = format!("{header}\n");
        for r in table(&path).1 {
            text += &row([r[0], r[1], r[2], r[3]]);
            text.push('\n');
        }
        std::fs::write(to.join(path.file_name().expect("a name")), text).expect("a file");
    }
}
