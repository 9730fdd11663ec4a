//! Dampers with an effect hidden in them, measured by the virtual rig whose laws are not the model's.
//!
//! A fixed handful of the benchmark (`cargo run --release -p dashpot-proving --example prove -- full` runs all of
//! it).

use dashpot_diagnosis::{Options, Verdict};
use dashpot_proving::outcome::{Outcome, judged, run};
use dashpot_proving::score;
use dashpot_severity::case::Case;

/// Cases by block, at the strengths that make their severities; seeds are used for nothing else.
fn outcomes(block: &'static str, cases: Vec<Case>) -> Vec<Outcome> {
    cases.iter().map(|case| run(block, case).map(|(outcome, _, _)| outcome).unwrap()).collect()
}

/// Cases by block, at strengths that are known: a typical strong case is 1.
fn outcomes_at(block: &'static str, strength: f64, cases: Vec<Case>) -> Vec<Outcome> {
    let one = |case: &Case| {
        let measured = case.measure_at(vec![strength; case.effects.len()], &[]).unwrap();
        judged(block, case.options.seed, &case.effects, &measured, &Options::default()).unwrap().0
    };
    cases.iter().map(one).collect()
}

#[test]
fn known_effects_are_named() {
    let hidden = ["presliding_friction", "gas_spring", "channel_delay"];
    let cases = hidden.iter().zip(90_001..).map(|(name, seed)| Case::nothing(seed).hiding(name, 1.0)).collect();
    let all = outcomes_at("single", 1.0, cases);
    println!("{}\n{}", score::table(&all), score::confusion(&all));
    let right = all.iter().filter(|o| o.named.first().is_some_and(|(n, _)| Some(n.as_str()) == o.truth())).count();
    assert!(right + 1 >= all.len(), "{right} of {}", all.len());
    for o in &all {
        for (name, confidence) in &o.named {
            assert!(o.is_injected(name) || *confidence < 0.9, "{name} given as sure: {o:?}");
        }
        assert!(o.clean_after < 1.02 * o.clean_before, "left-out tests got worse: {o:?}");
    }
}

#[test]
fn nothing_is_named_where_nothing_is_hidden() {
    let mut coloured = Case::nothing(90_102);
    coloured.options.noise_colour = 0.9;
    coloured.options.hum_n = 2.0;
    coloured.options.bits = Some(14);
    for o in outcomes("null_white", vec![coloured]) {
        assert!(o.named.is_empty() && o.verdict != Verdict::Named, "{o:?}");
    }
}

#[test]
fn what_is_in_no_catalogue_gets_no_name() {
    for o in outcomes_at("unknown", 1.0, vec![Case::nothing(90_203).hiding("unknown_crosshead_tilt", 1.0)]) {
        assert!(o.named.is_empty(), "{o:?}");
    }
}

/// Neither explains half of the disagreement by itself.
#[test]
#[ignore = "half a minute on two cores; the benchmark has it too"]
fn two_effects_are_found_together() {
    let case = Case::nothing(90_301).hiding("free_play", 2.0).hiding("bump_stop:rubber", 2.0);
    for o in outcomes("pair", vec![case]) {
        let mut names: Vec<&str> = o.named.iter().map(|(name, _)| name.as_str()).collect();
        names.sort_unstable();
        assert_eq!(names, ["bump_stop", "free_play"], "{o:?}");
    }
}
