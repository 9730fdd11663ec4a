//! Runs the benchmark: `cargo run --release -p dashpot-proving --example prove -- full|medium|short|NAME=SEVERITY [SEED] [OUT.jsonl]`.
//!
//! `split=calibrate`, `split=check` or `split=locked="what for"` replaces the seed (see [`dashpot_proving::split`]).
//! `only=BLOCK,...` runs some blocks, with the seeds that they have in the whole suite. `alone` runs one case after the
//! other, to measure the duration for a user. `whole` starts a named case from a fit with all elements. For a named
//! case, a third argument `COUNT` runs this number of successive seeds.

use dashpot_core::list;
use dashpot_proving::suite::{Entry, Size, suite};
use dashpot_proving::{outcome, score, split};
use dashpot_severity::case::Case;
use rayon::prelude::*;

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let what = args.first().map_or("short", String::as_str);
    let seed: u64 = match split::first_seed(&args) {
        Ok(first) => first.or_else(|| args.get(1).and_then(|s| s.parse().ok())).unwrap_or(1000),
        Err(error) => {
            eprintln!("{error}");
            return;
        }
    };
    let mut entries: Vec<Entry> = match what {
        "full" => suite(Size::FULL, seed),
        "medium" => suite(Size::MEDIUM, seed),
        "short" => suite(Size::SHORT, seed),
        _ => {
            let count: u64 = args.get(2).and_then(|s| s.parse().ok()).unwrap_or(1);
            (0..count)
                .map(|k| {
                    let case =
                        what.split(',').filter(|w| *w != "nothing").fold(Case::nothing(seed + k), |case, word| {
                            let (name, severity) = word.split_once('=').unwrap_or((word, "1.5"));
                            case.hiding(name, severity.parse().unwrap_or(1.5))
                        });
                    let case = Case { whole_fit: args.iter().any(|a| a == "whole"), ..case };
                    Entry { block: if what == "nothing" { "null_white" } else { "single" }, case }
                })
                .collect()
        }
    };
    let only: Option<&str> = args.iter().find_map(|a| a.strip_prefix("only="));
    entries.retain(|e| only.is_none_or(|blocks| blocks.split(',').any(|block| block == e.block)));
    let run = |entry: &Entry| match outcome::run(entry.block, &entry.case) {
        Ok((o, measured, found)) => {
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
            if what.contains("nothing") || args.iter().any(|a| a == "-v") {
                eprintln!("   hidden {:?} in {:?}", measured.truth.effects, measured.truth.damper);
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
                    eprintln!(
                        "FV {:?} {:?}",
                        found.base.list(list!("fv_velocity")),
                        found.base.list(list!("fv_force"))
                    );
                }
                for s in &found.shifts {
                    eprintln!("   {s:?}");
                }
            }
            for round in &found.iterations {
                let words: Vec<String> = round
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
            Some(o)
        }
        Err(error) => {
            eprintln!("{} {:?} seed {}: {error}", entry.block, entry.case.effects, entry.case.options.seed);
            None
        }
    };
    let outcomes: Vec<outcome::Outcome> = if args.iter().any(|a| a == "alone") {
        entries.iter().filter_map(run).collect()
    } else {
        entries.par_iter().filter_map(run).collect()
    };
    if let Some(path) = args.iter().find(|a| a.ends_with(".jsonl")) {
        let lines: Vec<String> = outcomes.iter().filter_map(|o| serde_json::to_string(o).ok()).collect();
        if let Err(error) = std::fs::write(path, lines.join("\n") + "\n") {
            eprintln!("{path}: {error}");
        }
    }
    println!("{}\n{}", score::table(&outcomes), score::confusion(&outcomes));
}
