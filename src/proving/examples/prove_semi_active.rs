//! Identifies semi-active dampers of the second laboratory as functions of their current.
//!
//! `cargo run --release -p dashpot-proving --example prove_semi_active -- COUNT FIRST_SEED [OUT.jsonl]`.
//!
//! `split=calibrate`, `split=check` or `split=locked="what for"` may replace the first seed. The locked split issues
//! unused seeds, which are never issued again.

use dashpot_proving::semi_active::{Lag, SemiActiveOutcome, evaluate};
use dashpot_proving::split::first_seed;

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize, or: u64| args.get(place).and_then(|a| a.parse().ok()).unwrap_or(or);
    let first = match first_seed(&args) {
        Ok(first) => first.unwrap_or_else(|| number(1, 1)),
        Err(error) => {
            eprintln!("{error}");
            return;
        }
    };
    let mut outcomes: Vec<SemiActiveOutcome> = Vec::new();
    for seed in first..first + number(0, 1) {
        match evaluate(seed) {
            Ok(outcome) => {
                eprintln!("seed {seed}: {} ({:.0} s)", outcome.actuator, outcome.seconds);
                outcomes.push(outcome);
            }
            Err(error) => eprintln!("seed {seed}: {error}"),
        }
    }
    if let Some(path) = args.iter().find(|a| a.ends_with(".jsonl")) {
        let lines: Vec<String> = outcomes.iter().filter_map(|o| serde_json::to_string(o).ok()).collect();
        if let Err(error) = std::fs::write(path, lines.join("\n") + "\n") {
            eprintln!("{path}: {error}");
        }
    }
    outcomes.sort_by(|a, b| b.worst_lag().total_cmp(&a.worst_lag()));
    println!(
        "{:>8} {:>7} {:>11} {:>9}  ratios by current; t63 of the valve and of the force, plant and model, ms",
        "seed", "ratio", "left out %", "random %"
    );
    for of in &outcomes {
        let ratios: Vec<String> = of.ratios.iter().map(|ratio| format!("{ratio:.2}")).collect();
        println!(
            "{:>8} {:>7.2} {:>11.2} {:>9.2}  {}",
            of.seed,
            of.worst_ratio,
            of.left_out_percent,
            100.0 * of.random_error,
            ratios.join(" ")
        );
        for (name, lags) in [("valve", &of.valve), ("force", &of.force)] {
            let one = |lag: &Lag| {
                let [from, to] = lag.step_a;
                format!(
                    "{from}-{to} A {:.1} {:.1} ({:+.0} %)",
                    1e3 * lag.plant_s,
                    1e3 * lag.model_s,
                    100.0 * lag.error()
                )
            };
            println!("{:>16}  {}", name, lags.iter().map(one).collect::<Vec<_>>().join(", "));
        }
    }
}
