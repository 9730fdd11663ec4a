//! Writes the simulated campaign of a semi-active damper of the second laboratory (this crate) into a folder.
//!
//! `cargo run --release -p dashpot-other-lab --example semi_active -- SEED FOLDER`

use dashpot_other_lab::semi_active::{SemiActivePlant, protocol};
use dashpot_other_lab::{Accuracy, Protocol};
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [seed, folder] = &args[..] else { return Err("semi_active needs SEED and FOLDER".to_owned()) };
    let seed: u64 = seed.parse().map_err(|_| format!("'{seed}' is no whole number"))?;
    let folder = PathBuf::from(folder);
    let plant = SemiActivePlant::new(seed);
    let as_measured = Protocol { noise_percent: 1.0, ..Protocol::default() };
    std::fs::create_dir_all(&folder).map_err(|error| format!("'{}': {error}", folder.display()))?;
    let tests = protocol(seed, plant.most);
    for test in &tests {
        let record = plant.run(test, &as_measured, &Accuracy::default(), seed).map_err(|error| error.to_string())?;
        let path = folder.join(format!("{}.csv", test.name));
        std::fs::write(&path, record.csv()).map_err(|error| format!("'{}': {error}", path.display()))?;
    }
    println!("{} tests in '{}'", tests.len(), folder.display());
    Ok(())
}
