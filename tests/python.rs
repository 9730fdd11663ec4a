//! A Python with the packages that some hosts come in, in a virtual environment below the target directory.

use std::path::PathBuf;
use std::process::Command;
use std::sync::OnceLock;

/// What the hosts are made of.
const PACKAGES: [&str; 2] = ["fmpy==0.3.32", "mujoco==4.0.0"];

/// The interpreter; makes the environment on first use and keeps it.
///
/// # Panics
/// In one line that says what is missing, where the environment cannot be made.
pub fn python() -> PathBuf {
    static PYTHON: OnceLock<PathBuf> = OnceLock::new();
    PYTHON
        .get_or_init(|| {
            let test = std::env::current_exe().expect("the path of this test");
            let target = test.ancestors().nth(3).expect("a target directory").to_path_buf();
            let environment = target.join("hosts-venv");
            let python = environment.join("bin/python");
            let done = environment.join(PACKAGES.join("_"));
            if !done.exists() {
                let run = |command: &mut Command, needs: &str| {
                    let ran = command.output();
                    let told = match &ran {
                        Ok(out) if out.status.success() => return,
                        Ok(out) => String::from_utf8_lossy(&out.stderr).trim().replace('\n', " "),
                        Err(error) => error.to_string(),
                    };
                    panic!("this test needs {needs}: {told}");
                };
                run(
                    Command::new("python3").args(["-m", "venv"]).arg(&environment),
                    "python3 with venv (Debian: apt-get install python3-venv)",
                );
                run(
                    Command::new(&python).args(["-m", "pip", "install", "--quiet"]).args(PACKAGES),
                    &format!("{} from PyPI", PACKAGES.join(" and ")),
                );
                std::fs::write(&done, "").expect("a mark");
            }
            python
        })
        .clone()
}

/// An interpreter with packages, parted by blanks, in an environment of their own named after the first; or none, after a line that says so,
/// where they cannot be installed here.
pub fn python_with(packages: &str) -> Option<PathBuf> {
    let test = std::env::current_exe().expect("the path of this test");
    let target = test.ancestors().nth(3).expect("a target directory");
    let environment = target.join(format!("{}-venv", packages.split('=').next().unwrap_or(packages)));
    let (python, done) = (environment.join("bin/python"), environment.join(packages));
    let runs = |command: &mut Command| command.output().is_ok_and(|out| out.status.success());
    let made = done.exists()
        || runs(Command::new("python3").args(["-m", "venv"]).arg(&environment))
            && runs(Command::new(&python).args(["-m", "pip", "install", "--quiet"]).args(packages.split(' ')))
            && std::fs::write(&done, "").is_ok();
    if !made {
        println!("skipped: {packages} does not install here");
    }
    made.then_some(python)
}
