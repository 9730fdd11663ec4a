//! Sets the numbers of `src/diagnosis/src/calibration.toml` from cases of the calibrating split:
//! `cargo run --release -p dashpot-proving --example calibrate -- OUTCOMES.jsonl...`, with what
//! `prove_other ROUNDS split=calibrate [reference] OUTCOMES.jsonl` has written. Prints the file; `--write` replaces it.

use dashpot_proving::calibrate::{Given, fit};
use dashpot_proving::split::Split;
use serde_json::Value;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let mut given = Vec::new();
    for path in args.iter().filter(|a| !a.starts_with("--")) {
        for (number, line) in std::fs::read_to_string(path)?.lines().enumerate() {
            let case: Value = serde_json::from_str(line).map_err(|e| format!("{path}: line {}: {e}", number + 1))?;
            let seed = case["seed"].as_u64().unwrap_or(0);
            if !(Split::Calibrate.first_seed()..Split::Check.first_seed()).contains(&seed) {
                return Err(format!("{path}: line {}: seed {seed} is not of the calibrating split", number + 1).into());
            }
            given.extend(Given::of(&case));
        }
    }
    let found = fit(&given).ok_or("no name was given in these cases: nothing can be calibrated")?;
    let text = found.text(&args.join(" "));
    if args.iter().any(|a| a == "--write") {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../diagnosis/src/calibration.toml");
        std::fs::write(path, &text)?;
    }
    print!("{text}");
    Ok(())
}
