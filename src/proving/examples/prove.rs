//! Runs the benchmark: `cargo run --release -p dashpot-proving --example prove -- full|medium|short|NAME=SEVERITY [SEED] [OUT.jsonl]`.
//!
//! `split=calibrate`, `split=check` or `split=locked="what for"` replaces the seed (see [`dashpot_proving::split`]).
//! `only=BLOCK,...` runs some blocks, with the seeds that they have in the whole suite. `alone` runs one case after the
//! other, to measure the duration for a user. `whole` starts a named case from a fit with all elements. For a named
//! case, a third argument `COUNT` runs this number of successive seeds.

use dashpot_core::list;
use dashpot_diagnosis::Diagnosis;
use dashpot_proving::outcome::Outcome;
use dashpot_proving::suite::{Entry, Size, suite};
use dashpot_proving::{outcome, score, split};
use dashpot_severity::case::Case;
use rayon::prelude::*;

/// Arguments of the command.
struct Arguments(Vec<String>);

impl Arguments {
    /// Returns the first argument: a size of the suite, or the effects to inject.
    fn what(&self) -> &str {
        self.0.first().map_or("short", String::as_str)
    }

    fn has(&self, word: &str) -> bool {
        self.0.iter().any(|argument| argument == word)
    }

    fn number(&self, position: usize) -> Option<u64> {
        self.0.get(position).and_then(|text| text.parse().ok())
    }

    /// Returns the cases to run, with seeds from `seed`.
    fn entries(&self, seed: u64) -> Vec<Entry> {
        let mut entries = match self.what() {
            "full" => suite(Size::FULL, seed),
            "medium" => suite(Size::MEDIUM, seed),
            "short" => suite(Size::SHORT, seed),
            _ => (0..self.number(2).unwrap_or(1)).map(|k| self.named_entry(seed + k)).collect(),
        };
        let only: Option<&str> = self.0.iter().find_map(|a| a.strip_prefix("only="));
        entries.retain(|e| only.is_none_or(|blocks| blocks.split(',').any(|block| block == e.block)));
        entries
    }

    /// Makes the case with the effects that the first argument names.
    fn named_entry(&self, seed: u64) -> Entry {
        let what = self.what();
        let case = what.split(',').filter(|w| *w != "nothing").fold(Case::nothing(seed), |case, word| {
            let (name, severity) = word.split_once('=').unwrap_or((word, "1.5"));
            case.hiding(name, severity.parse().unwrap_or(1.5))
        });
        let case = Case { whole_fit: self.has("whole"), ..case };
        Entry { block: if what == "nothing" { "null_white" } else { "single" }, case }
    }

    /// Returns whether each case is printed with its parameters and tests.
    fn is_verbose(&self) -> bool {
        self.what().contains("nothing") || self.has("-v")
    }
}

fn main() {
    let args = Arguments(std::env::args().skip(1).collect());
    let seed: u64 = match split::first_seed(&args.0) {
        Ok(first) => first.or_else(|| args.number(1)).unwrap_or(1000),
        Err(error) => {
            eprintln!("{error}");
            return;
        }
    };
    let entries = args.entries(seed);
    let run = |entry: &Entry| run(entry, args.is_verbose());
    let outcomes: Vec<Outcome> = if args.has("alone") {
        entries.iter().filter_map(run).collect()
    } else {
        entries.par_iter().filter_map(run).collect()
    };
    if let Some(path) = args.0.iter().find(|a| a.ends_with(".jsonl")) {
        let lines: Vec<String> = outcomes.iter().filter_map(|o| serde_json::to_string(o).ok()).collect();
        if let Err(error) = std::fs::write(path, lines.join("\n") + "\n") {
            eprintln!("{path}: {error}");
        }
    }
    println!("{}\n{}", score::table(&outcomes), score::confusion(&outcomes));
}

/// Runs a case and prints its outcome.
fn run(entry: &Entry, is_verbose: bool) -> Option<Outcome> {
    let (o, measured, found) = match outcome::run(entry.block, &entry.case) {
        Ok(all) => all,
        Err(error) => {
            eprintln!("{} {:?} seed {}: {error}", entry.block, entry.case.effects, entry.case.options.seed);
            return None;
        }
    };
    eprintln!(
        "{} {:?} {:?} seed {} -> {:?} {:?} {:?} gap {:?} clean {:.2} -> {:.2} {:.1}s",
        o.block,
        o.injected,
        o.forms,
        o.seed,
        o.verdict,
        o.named,
        o.suspects,
        o.gap_closed,
        o.clean_before,
        o.clean_after,
        o.seconds
    );
    if is_verbose {
        eprintln!("   hidden {:?} in {:?}", measured.truth.effects, measured.truth.damper);
        print_details(&found);
    }
    print_trials(&found);
    Some(o)
}

/// Prints findings, errors of the tests and shifted parameters. Writes the curves to the file that `CURVES` names.
fn print_details(found: &Diagnosis) {
    for f in &found.findings {
        eprintln!("   {} {:?}", f.effect, f.parameters);
    }
    for t in &found.tests {
        eprintln!(
            "   {} {:.3} Hz: {:.2} -> {:.2}, noise {:.2}",
            t.test, t.curves.frequency, t.before_rmse_n, t.after_rmse_n, t.noise_n
        );
    }
    if let Ok(path) = std::env::var("CURVES") {
        let mut text = String::new();
        for t in &found.tests {
            for i in 0..t.curves.measured.len() {
                text += &format!(
                    "{},{},{},{},{},{}\n",
                    t.test,
                    t.curves.displacement[i],
                    t.curves.velocity[i],
                    t.curves.measured[i],
                    t.curves.before[i],
                    t.curves.after[i]
                );
            }
        }
        let _ = std::fs::write(path, text);
        eprintln!("FV {:?} {:?}", found.base.list(list!("fv_velocity")), found.base.list(list!("fv_force")));
    }
    for s in &found.shifts {
        eprintln!("   {s:?}");
    }
}

/// Prints the most probable trials of each iteration.
fn print_trials(found: &Diagnosis) {
    for trials in &found.iterations {
        let words: Vec<String> = trials
            .iter()
            .take(4)
            .map(|t| {
                format!(
                    "{} {} p {:.2} odds {:.1} share {:.2} strange {:.1}",
                    t.effect,
                    t.form,
                    t.confidence,
                    t.evidence.log_odds,
                    t.evidence.fraction,
                    t.evidence.negative_log_prior
                )
            })
            .collect();
        eprintln!("    {}", words.join("; "));
    }
}
