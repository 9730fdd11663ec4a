//! Diagnoses the same records from four starting models: `cargo run --release -p dashpot-proving --example start_invariance -- FOLDER...`.
//!
//! The starts are the plain fit; FV curve with series spring and gas; these three elements with presliding friction;
//! and the plain FV curve. The example prints the effects of each improved model and the ratio of the largest to the
//! smallest root mean square residual.

use dashpot_diagnosis::{Options, Status, choose_left_out, diagnose};
use dashpot_identification::{Family, FitOptions, fit};
use dashpot_records::{self as records, Record};
use std::time::Instant;

fn main() {
    let few = |elements: &[&str]| FitOptions {
        elements: Some(elements.iter().map(|e| (*e).to_owned()).collect()),
        ..FitOptions::default()
    };
    let starts = [
        ("fit", FitOptions::default()),
        ("bare", few(&["fv_curve", "series_compliance", "gas_preload"])),
        ("presliding", few(&["fv_curve", "series_compliance", "gas_preload", "presliding_friction"])),
        ("fv", FitOptions { family: Family::Fv, ..FitOptions::default() }),
    ];
    let (mut same, mut count) = (0, 0);
    for folder in std::env::args().skip(1) {
        let loaded = match records::load(&[folder.clone().into()], &records::Options::default(), &|_| ()) {
            Ok(loaded) => loaded.records,
            Err(error) => {
                eprintln!("{folder}: {error}");
                continue;
            }
        };
        let all: Vec<&Record> = loaded.iter().collect();
        let held_out = choose_left_out(&all, 0);
        let seen: Vec<&Record> = all.iter().zip(&held_out).filter(|(_, out)| !**out).map(|(r, _)| *r).collect();
        let mut answers: Vec<(Vec<&str>, f64)> = Vec::new();
        for (name, options) in &starts {
            let begun = Instant::now();
            let Ok(model) = fit(&seen, options, |_| ()) else { continue };
            let fitted = begun.elapsed().as_secs_f64();
            let Ok(found) = diagnose(&all, &held_out, &model.params, &Options::default(), &|_, _| ()) else { continue };
            let is_in = |status: Status| matches!(status, Status::Kept | Status::Added);
            let mut effects: Vec<&str> = found.inventory.iter().filter(|i| is_in(i.status)).map(|i| i.effect).collect();
            effects.sort_unstable();
            println!(
                "{folder} {name:10} {:6.1} N {:4.1} s {:4.1} s {effects:?}",
                found.after.rmse_n,
                fitted,
                begun.elapsed().as_secs_f64() - fitted
            );
            answers.push((effects, found.after.rmse_n));
        }
        let best = answers.iter().map(|a| a.1).fold(f64::INFINITY, f64::min);
        let worst = answers.iter().map(|a| a.1).fold(0.0, f64::max);
        let is_same = answers.windows(2).all(|pair| pair[0].0 == pair[1].0);
        (same, count) = (same + usize::from(is_same), count + 1);
        println!("{folder} {} worst over best {:.2}", if is_same { "same" } else { "differs" }, worst / best);
    }
    println!("same effects from all starts: {same} of {count}");
}
