//! Prints the force change due to every injected effect at one strength (default 1), for the dampers of the seeds 1 to
//! `SEEDS` (default 8). The seed also selects the physical form of the effect.
//!
//! `cargo run --release -p dashpot-rig --example effect_sizes [SEEDS] [STRENGTH]`

use std::time::Instant;

use dashpot_rig::{EFFECTS, InjectedCase, Options, RigError, UNKNOWN_EFFECTS};
use rayon::prelude::*;

fn main() -> Result<(), RigError> {
    let mut arguments = std::env::args().skip(1).filter_map(|text| text.parse::<f64>().ok());
    let seeds = arguments.next().unwrap_or(8.0) as u64;
    let strength = arguments.next().unwrap_or(1.0);
    let options = |seed| Options { seed, noise_percent: 0.0, ..Options::default() };
    let started = Instant::now();
    let neutral: Vec<_> = (1..=seeds)
        .into_par_iter()
        .map(|seed| InjectedCase { options: options(seed), ..InjectedCase::default() }.run())
        .collect::<Result<_, _>>()?;
    println!("{} neutral campaigns in {:.2?}", seeds, started.elapsed());
    println!("{:30} {:30} {:>7} {:>7} {:>7} {:>7}  seconds", "effect", "form", "N rms", "% rms", "N max", "in test");
    for name in EFFECTS.iter().chain(&UNKNOWN_EFFECTS) {
        let rows: Vec<(u64, String)> = (1..=seeds)
            .into_par_iter()
            .map(|seed| {
                let started = Instant::now();
                let case = InjectedCase { options: options(seed), ..InjectedCase::default() }.hiding(name, strength);
                let outcome = match case.run() {
                    Ok(outcome) => outcome,
                    Err(error) => return (seed, format!("{name:30} seed {seed}: {error}")),
                };
                let base = &neutral[seed as usize - 1].campaign.records;
                let (mut change, mut force, mut count, mut most, mut most_in) = (0.0, 0.0, 0.0, 0.0, "");
                let mut worst = 0.0;
                for (with, without) in outcome.campaign.records.iter().zip(base) {
                    let (mut own, mut own_force) = (0.0, 0.0);
                    for (a, b) in with.clean_force_n.iter().zip(&without.clean_force_n) {
                        own += (a - b) * (a - b);
                        own_force += b * b;
                        most = f64::max(most, (a - b).abs());
                    }
                    if own / own_force > worst {
                        (worst, most_in) = (own / own_force, &with.point.name);
                    }
                    (change, force, count) = (change + own, force + own_force, count + with.clean_force_n.len() as f64);
                }
                (
                    seed,
                    format!(
                        "{name:30} {:30} {:7.1} {:7.2} {most:7.0} {:6.1}% {:.2} {most_in}",
                        outcome.truth.effects[0].form,
                        f64::sqrt(change / count),
                        100.0 * f64::sqrt(change / force),
                        100.0 * f64::sqrt(worst),
                        started.elapsed().as_secs_f64(),
                    ),
                )
            })
            .collect();
        for (_, row) in rows {
            println!("{row}");
        }
    }
    Ok(())
}
