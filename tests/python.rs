//! A Python interpreter with the packages of host programs, in a virtual environment below cargo's target directory.

use dashpot_test_support::{skipped, target_folder};
use std::path::PathBuf;
use std::process::Command;
use std::sync::OnceLock;

/// Python packages of the hosts that the tests run: FMPy, which runs FMUs, and MuJoCo.
const PACKAGES: [&str; 2] = ["fmpy==0.3.32", "mujoco==4.0.0"];

/// Arguments of pip for an installation. Python compiles a module when it is first imported, so compiling all
/// modules of all packages would take twice the time.
const INSTALL: [&str; 3] = ["install", "--quiet", "--no-compile"];

/// Returns whether the Python environment exists or can be installed. If not, reports the calling test as skipped, with
/// the reason.
pub fn has_python() -> bool {
    match made() {
        Ok(_) => true,
        Err(missing) => {
            skipped(missing);
            false
        }
    }
}

/// Returns the path of the Python interpreter in an environment that is created on first use and stays for later runs.
///
/// # Panics
/// If the environment cannot be created, with the reason. A test that calls [`has_python`] first is skipped instead.
pub fn python() -> PathBuf {
    made().as_ref().unwrap_or_else(|missing| panic!("this test {missing}")).clone()
}

/// Creates the Python environment, so that later tests do not wait for it. A failure is reported by the first of them.
pub fn prepare() {
    let _ = made();
}

fn made() -> &'static Result<PathBuf, String> {
    static PYTHON: OnceLock<Result<PathBuf, String>> = OnceLock::new();
    PYTHON.get_or_init(|| {
        let environment = target_folder().join("hosts-venv");
        let python = environment.join("bin/python");
        let done = environment.join(PACKAGES.join("_"));
        if !done.exists() {
            let run = |command: &mut Command, needs: &str| {
                let ran = command.output();
                let told = match &ran {
                    Ok(out) if out.status.success() => return Ok(()),
                    Ok(out) => String::from_utf8_lossy(&out.stderr).trim().replace('\n', " "),
                    Err(error) => error.to_string(),
                };
                Err(format!("needs {needs}: {told}"))
            };
            run(
                Command::new("python3").args(["-m", "venv"]).arg(&environment),
                "python3 with venv (Debian: apt-get install python3-venv)",
            )?;
            run(
                Command::new(&python).args(["-m", "pip"]).args(INSTALL).args(PACKAGES),
                &format!("{} from PyPI", PACKAGES.join(" and ")),
            )?;
            std::fs::write(&done, "").expect("a mark");
        }
        Ok(python)
    })
}

/// Returns the path of a Python interpreter with `packages` (separated by blanks), in an environment named after the
/// first package.
///
/// Returns `None` and reports the test as skipped if the packages cannot be installed.
pub fn python_with(packages: &str) -> Option<PathBuf> {
    let environment = target_folder().join(format!("{}-venv", packages.split('=').next().unwrap_or(packages)));
    let (python, done) = (environment.join("bin/python"), environment.join(packages));
    let runs = |command: &mut Command| command.output().is_ok_and(|out| out.status.success());
    // The pip of the environment of `made` installs the packages. Installing pip in a further environment takes 4 s.
    let install = || {
        let Ok(pip) = made() else { return false };
        let mut command = Command::new(pip);
        command.args(["-m", "pip", "--python"]).arg(&python).args(INSTALL);
        runs(command.args(packages.split(' ')))
    };
    let made = done.exists()
        || runs(Command::new("python3").args(["-m", "venv", "--without-pip"]).arg(&environment))
            && install()
            && std::fs::write(&done, "").is_ok();
    if !made {
        skipped(format!("{packages} does not install here"));
    }
    made.then_some(python)
}
