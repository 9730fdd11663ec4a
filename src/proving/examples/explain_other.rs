//! Measures how often the intervals of `dashpot explain` contain the truth, on dampers of the second laboratory.
//!
//! `cargo run --release -p dashpot-proving --example explain_other -- COUNT FIRST_SEED [dimensions] [eyes]`. With
//! `dimensions` the fit has priors from bore, rod, chambers and oil. With `eyes`, the drawing also states the stiffness
//! of the mounting eyes. `split=calibrate` or `split=check` may replace the first seed.

use dashpot_core::list;
use dashpot_dimensions::{Entry, explain, forward};
use dashpot_identification::{FitOptions, fit, model_file};
use dashpot_other_lab::{Case, Kind, LEFT_OUT_PREFIX};
use dashpot_proving::drawing::Drawing;
use dashpot_proving::laboratory::read;
use dashpot_proving::split::first_seed;
use dashpot_records::Record;
use std::collections::BTreeMap;
use std::path::Path;

/// Statistics of the intervals of one quantity.
#[derive(Default)]
struct Score {
    reported: usize,
    held: usize,
    bounds: usize,
    /// Ratio of the true value to the reported value.
    ratios: Vec<f64>,
    /// Ratio of the upper to the lower end of the interval.
    widths: Vec<f64>,
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize, or: u64| args.get(place).and_then(|a| a.parse().ok()).unwrap_or(or);
    let asked = |what: &str| args.iter().any(|a| a == what);
    let first = first_seed(&args)?.unwrap_or_else(|| number(1, 1000));
    let mut frame = vec![Entry::Bore, Entry::Rod, Entry::ReboundChamber, Entry::CompressionChamber, Entry::OilModulus];
    if asked("eyes") {
        frame.push(Entry::EyeStiffness);
    }
    let all = [&frame[..], &[Entry::GasPressure]].concat();
    let mut scores: BTreeMap<(&str, &str), Score> = BTreeMap::new();
    let mut contradictions = 0;
    for k in 0..number(0, 4) {
        let kind = [Kind::Monotube, Kind::TwinTube][(k % 2) as usize];
        let seed = first + k;
        let Some(drawing) = Drawing::new(kind, seed) else { continue };
        let records = read(&Case::new(kind, seed).run()?)?;
        let seen: Vec<&Record> = records.iter().filter(|r| !r.name.starts_with(LEFT_OUT_PREFIX)).collect();
        let priors = if asked("dimensions") { forward::priors(&drawing.with(&frame)) } else { Default::default() };
        let found = fit(&seen, &FitOptions { priors, ..FitOptions::default() }, |_| ())?;
        let model = model_file::of_text(&model_file::write(&found), Path::new("model.toml"))?;
        let (v, f) = (model.params.list(list!("fv_velocity")), model.params.list(list!("fv_force")));
        let still = v.iter().zip(f).find(|(v, _)| **v == 0.0).map_or(0.0, |(_, f)| *f);
        // The computation of the gas pressure does not use the gas pressure of the drawing, so the drawing may state
        // it.
        let explanation = explain(&model, &drawing.with(&all));
        contradictions += explanation.contradictions.len();
        for found in &explanation.contradictions {
            eprintln!("{} {seed}: {}", kind.name(), found.text);
        }
        for quantity in &explanation.quantities {
            let end = if quantity.name.starts_with("compression") { f[0] } else { f[f.len() - 1] };
            let Some(truth) = drawing.truth(quantity.name, (end - still).abs()) else { continue };
            let score = scores.entry((kind.name(), quantity.name)).or_default();
            score.reported += 1;
            let is_held = quantity.low.is_none_or(|low| low <= truth) && quantity.high.is_none_or(|high| truth <= high);
            score.held += usize::from(is_held);
            match (quantity.value, quantity.low, quantity.high) {
                (Some(value), Some(low), Some(high)) => {
                    score.ratios.push(truth / value);
                    score.widths.push(high / low);
                }
                _ => score.bounds += 1,
            }
            eprintln!(
                "{} {seed} {}: truth {truth:.4} value {:.4} interval {:.4} {:.4}{}",
                kind.name(),
                quantity.name,
                quantity.value.unwrap_or(f64::NAN),
                quantity.low.unwrap_or(f64::NAN),
                quantity.high.unwrap_or(f64::NAN),
                if is_held { "" } else { " MISSED" }
            );
        }
    }
    let (mut reported, mut held) = (0, 0);
    println!("| damper | quantity | reported | truth inside | bounds | truth over value: low, median, high | width |");
    println!("|---|---|---|---|---|---|---|");
    for ((kind, name), score) in &scores {
        reported += score.reported;
        held += score.held;
        let (low, high) = score.ratios.iter().fold((f64::INFINITY, 0.0f64), |(l, h), r| (l.min(*r), h.max(*r)));
        println!(
            "| {kind} | {name} | {} | {} | {} | {low:.2}, {:.2}, {high:.2} | ×{:.2} |",
            score.reported,
            score.held,
            score.bounds,
            median(&score.ratios),
            median(&score.widths)
        );
    }
    println!("intervals that hold the truth: {held} of {reported}; contradictions: {contradictions}");
    Ok(())
}
