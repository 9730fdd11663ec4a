//! Prints the change of force due to every law (equation) of every injected effect, for the three kinds of damper.
//!
//! The change is the root mean square over all tests, without a fit of a model, at the strengths 0.1 and 1. It is
//! relative to the noise, which is 2 % of each test's root mean square force plus 0.5 N.
//!
//! `cargo run --release -p dashpot-other-lab --example sizes_of_effects [-- SEED]`

use dashpot_other_lab::{Campaign, Case, Kind, LabError, effects};
use std::time::Instant;

fn change(with: &Campaign, without: &Campaign) -> f64 {
    let (mut sum, mut count) = (0.0, 0usize);
    for (a, b) in with.tests.iter().zip(&without.tests) {
        let rms = (b.clean_force_n.iter().map(|f| f * f).sum::<f64>() / b.clean_force_n.len() as f64).sqrt();
        let noise = 0.02 * rms + 0.5;
        let differ: f64 = a.clean_force_n.iter().zip(&b.clean_force_n).map(|(a, b)| ((a - b) / noise).powi(2)).sum();
        sum += differ / a.clean_force_n.len() as f64;
        count += 1;
    }
    (sum / count as f64).sqrt()
}

fn main() -> Result<(), LabError> {
    let seed = std::env::args().nth(1).and_then(|s| s.parse().ok()).unwrap_or(1);
    println!("{:52} {:>26} {:>26} {:>26}", "", "thesis_like", "monotube", "twin_tube");
    let without: Vec<Campaign> = Kind::ALL.iter().map(|kind| Case::new(*kind, seed).run()).collect::<Result<_, _>>()?;
    let unknown = effects::UNKNOWN.iter().map(|u| &u.effect);
    for effect in effects::KNOWN.iter().chain(unknown) {
        for (law, _) in effect.laws {
            print!("{:52}", format!("{}:{law}", effect.name));
            for (kind, without) in Kind::ALL.iter().zip(&without) {
                let began = Instant::now();
                for strength in [0.1, 1.0] {
                    let case = Case::new(*kind, seed).hiding(&format!("{}:{law}", effect.name), strength);
                    match case.run() {
                        Ok(with) => print!(" {:9.3}", change(&with, without)),
                        Err(_) => print!("    failed"),
                    }
                }
                print!(" {:5.2}s", 0.5 * began.elapsed().as_secs_f64());
            }
            println!();
        }
    }
    Ok(())
}
