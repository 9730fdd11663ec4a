//! Tests whether dimensions help to distinguish oil, air and mount, on dampers of the second laboratory.
//!
//! `cargo run --release -p dashpot-proving --example prove_dimensions -- COUNT FIRST_SEED [without=WAY] [only=DAMPER]`.
//!
//! Each damper is diagnosed without a drawing (`none`) and with a drawing of chambers, oil and gas (`chambers`). In the
//! third case, the drawing also contains the eyes (`eyes`). `without=WAY,...` omits some of these three cases.
//! `split=calibrate` or `split=check` may replace the first seed.

use dashpot_diagnosis::Options;
use dashpot_dimensions::{Entry, forward};
use dashpot_other_lab::{Case, Kind};
use dashpot_proving::drawing::Drawing;
use dashpot_proving::laboratory::measure;
use dashpot_proving::outcome::judged;
use dashpot_proving::split::first_seed;
use std::collections::BTreeMap;

/// Effects that can replace each other: oil, air and mount.
const NAMES: [&str; 3] = ["oil_compressibility", "aeration", "bushing"];
const CHAMBERS: [Entry; 7] = [
    Entry::Bore,
    Entry::Rod,
    Entry::ReboundChamber,
    Entry::CompressionChamber,
    Entry::OilModulus,
    Entry::GasPressure,
    Entry::GasVolume,
];

#[derive(Default)]
struct Score {
    cases: usize,
    /// Sum over all dampers of the probability of the injected effect. `wrong` is the corresponding sum for the more
    /// probable of the two other effects in [`NAMES`].
    right: f64,
    wrong: f64,
    named: usize,
    named_wrong: usize,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize, or: u64| args.get(place).and_then(|a| a.parse().ok()).unwrap_or(or);
    let first = first_seed(&args)?.unwrap_or_else(|| number(1, 1000));
    let mut scores: BTreeMap<(&str, &str, &str), Score> = BTreeMap::new();
    for k in 0..number(0, 2) {
        let kind = [Kind::Monotube, Kind::TwinTube][(k % 2) as usize];
        if args.iter().any(|a| a.strip_prefix("only=").is_some_and(|only| only != kind.name())) {
            continue;
        }
        for (place, effect) in NAMES.iter().enumerate() {
            let seed = first + 10 * k + place as u64;
            let Some(drawing) = Drawing::new(kind, seed) else { continue };
            let case = Case::new(kind, seed).hiding(effect, 1.0);
            let measured = match measure(&case, false) {
                Ok(measured) => measured,
                Err(error) => {
                    eprintln!("{} {effect} seed {seed}: {error}", kind.name());
                    continue;
                }
            };
            let with_eyes = [&CHAMBERS[..], &[Entry::EyeStiffness]].concat();
            for (way, entries) in [("none", &[][..]), ("chambers", &CHAMBERS[..]), ("eyes", &with_eyes[..])] {
                if args.iter().any(|a| a.strip_prefix("without=").is_some_and(|left| left.split(',').any(|l| l == way)))
                {
                    continue;
                }
                let priors =
                    if entries.is_empty() { Default::default() } else { forward::priors(&drawing.with(entries)) };
                let options = Options { priors, ..Options::default() };
                let (outcome, found) = judged("dimensions", seed, &case.effects, &measured, &options)?;
                let branches = found.tree.iter().flat_map(|path| &path.branches).flat_map(|family| &family.branches);
                let all: BTreeMap<&str, f64> = branches.map(|e| (e.name.as_str(), e.probability)).collect();
                let probability = |name: &str| all.get(name).copied().unwrap_or(0.0);
                let wrong: Vec<&str> = NAMES.into_iter().filter(|name| name != effect).collect();
                let score = scores.entry((kind.name(), effect, way)).or_default();
                score.cases += 1;
                score.right += probability(effect);
                score.wrong += wrong.iter().map(|name| probability(name)).fold(0.0, f64::max);
                let is_named = |name: &str| outcome.named.iter().any(|(named, _)| named == name);
                score.named += usize::from(is_named(effect));
                score.named_wrong += usize::from(wrong.iter().any(|name| is_named(name)));
                eprintln!(
                    "{} {effect} seed {seed} {way}: oil {:.2} air {:.2} mount {:.2}, named {:?}, k_o {:.3e} k_s {:.3e} {:.1}s",
                    kind.name(),
                    probability(NAMES[0]),
                    probability(NAMES[1]),
                    probability(NAMES[2]),
                    outcome.named.iter().map(|(name, p)| format!("{name} {p:.2}")).collect::<Vec<_>>(),
                    found.improved.number(dashpot_core::number!("oil_stiffness")),
                    found.improved.number(dashpot_core::number!("series_stiffness")),
                    outcome.seconds
                );
            }
        }
    }
    println!(
        "| damper | injected | drawing | cases | probability of it | largest of the other two | named | another named |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for ((kind, effect, way), s) in &scores {
        let mean = |sum: f64| sum / s.cases.max(1) as f64;
        println!(
            "| {kind} | {effect} | {way} | {} | {:.2} | {:.2} | {} | {} |",
            s.cases,
            mean(s.right),
            mean(s.wrong),
            s.named,
            s.named_wrong
        );
    }
    Ok(())
}
