//! Runs the benchmark cases of the second laboratory.
//!
//! `cargo run --release -p dashpot-proving --example prove_other -- ROUNDS FIRST_SEED [reference] [fitted] [only=BLOCK,EFFECT,...] [OUT.jsonl]`.
//!
//! The suite is repeated ROUNDS times. With `reference`, each damper is compared with itself without the injected effect. With `fitted`,
//! the model is that of `dashpot fit`. Otherwise, it has an FV curve, series spring, Coulomb friction, gas, side-force friction and a weak
//! spring. `split=calibrate`, `split=check` or `split=locked="what for"` may replace the first seed. The locked split issues unused seeds,
//! which are never issued again.

use dashpot_proving::laboratory::{Way, run, suite};
use dashpot_proving::outcome::Outcome;
use dashpot_proving::score;
use dashpot_proving::split::first_seed;

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize, or: u64| args.get(place).and_then(|a| a.parse().ok()).unwrap_or(or);
    let asked = |what: &str| args.iter().any(|a| a == what);
    let way = Way { reference: asked("reference"), whole_fit: asked("fitted") };
    let only: Option<&str> = args.iter().find_map(|a| a.strip_prefix("only="));
    let mut outcomes: Vec<Outcome> = Vec::new();
    let first = match first_seed(&args) {
        Ok(first) => first.unwrap_or_else(|| number(1, 1000)),
        Err(error) => {
            eprintln!("{error}");
            return;
        }
    };
    for (block, case) in suite(number(0, 1), first) {
        let hidden = case.effects.first().map_or("nothing", |(name, _)| name.as_str());
        if only.is_some_and(|names| !names.split(',').any(|name| name == hidden || name == block)) {
            continue;
        }
        match run(block, &case, way) {
            Ok((o, _)) => {
                eprintln!(
                    "{} {} {}{} {:?} seed {} -> {:?} {:?} {:?} gap {:?} {:.1}s",
                    o.block,
                    case.plant.name(),
                    hidden,
                    if o.in_the_model { " (in the model)" } else { "" },
                    o.forms,
                    o.seed,
                    o.verdict,
                    o.named,
                    o.suspects,
                    o.gap_closed,
                    o.seconds
                );
                outcomes.push(o);
            }
            Err(error) => eprintln!("{block} {hidden} seed {}: {error}", case.seed),
        }
    }
    if let Some(path) = args.iter().find(|a| a.ends_with(".jsonl")) {
        let lines: Vec<String> = outcomes.iter().filter_map(|o| serde_json::to_string(o).ok()).collect();
        if let Err(error) = std::fs::write(path, lines.join("\n") + "\n") {
            eprintln!("{path}: {error}");
        }
    }
    println!("{}\n{}", score::table(&outcomes), score::confusion(&outcomes));
}
