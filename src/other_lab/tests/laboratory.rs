//! Tests of the second laboratory as a whole: dampers dissipate energy, the integrator converges, and the influence of every law grows with
//! its strength.

use dashpot_other_lab::{
    Accuracy, Campaign, Case, Kind, LEFT_OUT_PREFIX, LabError, Plan, Protocol, TRUTH_FILE, effects,
};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

/// Makes a case without noise on the plan [`Plan::Reduced`], which has few tests.
fn quiet(kind: Kind, seed: u64) -> Case {
    let protocol = Protocol { plan: Plan::Reduced, noise_percent: 0.0, ..Protocol::default() };
    Case { protocol, ..Case::new(kind, seed) }
}

fn laws() -> impl Iterator<Item = (&'static str, String)> {
    effects::KNOWN
        .iter()
        .chain(effects::UNKNOWN.iter().map(|u| &u.effect))
        .flat_map(|effect| effect.laws.iter().map(|(law, _)| (effect.name, format!("{}:{law}", effect.name))))
}

/// Computes the root mean square difference of two campaigns over all tests. It includes the difference of the force relative to the noise,
/// which is 2 % of the rms force plus 0.5 N. It also includes the difference of the displacement relative to 0.1 mm.
fn change(a: &Campaign, b: &Campaign) -> f64 {
    let of_test = a.tests.iter().zip(&b.tests).map(|(a, b)| {
        assert_eq!((&a.name, a.time_s.len()), (&b.name, b.time_s.len()));
        let count = b.clean_force_n.len() as f64;
        let noise = 0.02 * (b.clean_force_n.iter().map(|f| f * f).sum::<f64>() / count).sqrt() + 0.5;
        let force = a.clean_force_n.iter().zip(&b.clean_force_n).map(|(a, b)| ((a - b) / noise).powi(2)).sum::<f64>();
        // The difference of the displacement is relative to 0.1 mm.
        let place = a.displacement_m.iter().zip(&b.displacement_m).map(|(a, b)| ((a - b) / 1e-4).powi(2)).sum::<f64>();
        (force + place) / count
    });
    (of_test.sum::<f64>() / a.tests.len() as f64).sqrt()
}

#[test]
fn dampers_take_energy_over_closed_cycles() {
    for kind in Kind::ALL {
        for seed in 0..6 {
            let campaign = quiet(kind, seed).run().unwrap();
            for test in campaign.tests {
                // The work is the integral of the force over the displacement of the last of three cycles, by the trapezoidal rule.
                let frequency: f64 = test.name.split('_').find_map(|w| w.strip_suffix("Hz")).unwrap().parse().unwrap();
                let begin = test.time_s.last().unwrap() - 1.0 / frequency - 1e-9;
                let from = test.time_s.partition_point(|t| *t < begin);
                let (x, f) = (&test.displacement_m[from..], &test.clean_force_n[from..]);
                let work: f64 = (1..x.len()).map(|i| 0.5 * (f[i] + f[i - 1]) * (x[i] - x[i - 1])).sum();
                let swing = x.iter().fold(0.0f64, |m, x| m.max(x.abs()));
                // The smallest seal friction, 15 N, acts over four amplitudes per cycle. The work must be at least half of that of this
                // friction.
                assert!(work > 15.0 * 2.0 * swing, "{kind:?} {seed} {}: {work} J", test.name);
            }
        }
    }
}

#[test]
fn peak_forces_are_those_of_car_dampers() {
    for kind in Kind::ALL {
        for seed in 0..6 {
            let case =
                Case { protocol: Protocol { noise_percent: 0.0, ..Protocol::default() }, ..Case::new(kind, seed) };
            let campaign = case.run().unwrap();
            let all = || campaign.tests.iter().flat_map(|t| &t.clean_force_n);
            let (least, most) = (all().fold(0.0f64, |m, f| m.min(*f)), all().fold(0.0f64, |m, f| m.max(*f)));
            assert!((500.0..9000.0).contains(&most), "{kind:?} {seed}: {most}");
            assert!((-6000.0..-250.0).contains(&least), "{kind:?} {seed}: {least}");
        }
    }
}

/// An ordinary run tests one of this many laws, because a test of all laws takes longer.
///
/// `cargo test --profile tests -p dashpot-other-lab --test laboratory -- --include-ignored` tests all laws in two minutes.
const ONE_IN: usize = 8;

fn some(i: usize) -> bool {
    i.is_multiple_of(ONE_IN)
}

fn smaller_steps_change_little(is_tested: impl Fn(usize) -> bool) {
    let fine = Accuracy { relative: 1e-5, absolute: 0.02, longest: 0.4 };
    let mut coarse = Vec::new();
    for (i, (_, law)) in laws().enumerate().filter(|(i, _)| is_tested(*i)) {
        let case = quiet(Kind::ALL[i % 3], 40 + i as u64).hiding(&law, 1.0);
        let differ = change(&case.run().unwrap(), &case.run_with(&fine).unwrap());
        if differ >= 0.1 {
            coarse.push(format!("{law} on {:?}: {differ:.3}", case.plant));
        }
    }
    assert!(coarse.is_empty(), "{coarse:#?}");
}

#[test]
fn smaller_steps_change_the_force_by_less_than_a_tenth_of_the_noise() {
    smaller_steps_change_little(some);
}

#[test]
#[ignore = "the other laws: a minute, for a change of the laboratory"]
fn smaller_steps_change_little_with_the_other_laws() {
    smaller_steps_change_little(|i| !some(i));
}

fn laws_grow_from_nothing(is_tested: impl Fn(usize) -> bool) {
    let sines = |case: Case| Case { protocol: Protocol { plan: Plan::Sines, road_s: 3.0, ..case.protocol }, ..case };
    for (i, (_, law)) in laws().enumerate().filter(|(i, _)| is_tested(*i)) {
        let case = sines(quiet(Kind::ALL[i % 3], i as u64));
        let without = case.run().unwrap();
        let at = |strength: f64| change(&case.clone().hiding(&law, strength).run().unwrap(), &without);
        assert_eq!(at(0.0), 0.0, "{law}");
        let [tiny, small, whole] = [1e-4, 0.2, 1.0].map(at);
        assert!(tiny < 0.03, "{law} at 1e-4: {tiny}");
        assert!(tiny < small && small < whole, "{law}: {tiny} {small} {whole}");
        // At strength 1, the rms change of the force must be at least 0.8 times the noise of one sample.
        assert!(whole > 0.8, "{law} at 1: {whole}");
    }
}

#[test]
fn laws_grow_from_nothing_with_their_strength() {
    laws_grow_from_nothing(some);
}

#[test]
#[ignore = "the other laws: a minute, for a change of the laboratory"]
fn the_other_laws_grow_from_nothing_with_their_strength() {
    laws_grow_from_nothing(|i| !some(i));
}

#[test]
fn every_effect_has_two_laws_and_names_are_said_once() {
    let mut names = BTreeSet::new();
    for effect in effects::KNOWN {
        assert!(effect.laws.len() >= 2, "{}", effect.name);
    }
    for name in effects::names() {
        assert!(names.insert(name), "{name}");
    }
    assert!(effects::UNKNOWN.len() >= 6);
    assert!(effects::UNKNOWN.iter().any(|u| u.has_detector) && effects::UNKNOWN.iter().any(|u| !u.has_detector));
}

#[test]
fn same_seed_gives_the_same_bytes_and_a_reference_differs_in_noise_alone() {
    let protocol =
        Protocol { plan: Plan::Reduced, bits: Some(14), noise_colour: 0.7, hum_n: 2.0, ..Protocol::default() };
    let case = Case { protocol, ..Case::new(Kind::TwinTube, 5) }.hiding("aeration", 1.0);
    let folder = tempfile::tempdir().unwrap();
    let bytes = |name: &str, case: &Case| -> BTreeMap<String, Vec<u8>> {
        let path = folder.path().join(name);
        case.run().unwrap().write(&path).unwrap();
        std::fs::read_dir(&path)
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(path).unwrap()))
            .collect()
    };
    let first = bytes("first", &case);
    // Another thread simulates at the same time, so that a shared state would change the result.
    let again = std::thread::scope(|s| {
        let other = s.spawn(|| quiet(Kind::Monotube, 9).run().unwrap());
        let again = bytes("again", &case);
        other.join().unwrap();
        again
    });
    assert_eq!(first, again);
    assert_eq!(first.len(), 16);
    assert!(first.contains_key(TRUTH_FILE));

    let plain = Case { effects: Vec::new(), ..case.clone() }.run().unwrap();
    let reference = case.reference().run().unwrap();
    for (a, b) in plain.tests.iter().zip(&reference.tests) {
        assert_eq!((&a.name, &a.clean_force_n), (&b.name, &b.clean_force_n));
        assert_ne!(a.force_n, b.force_n);
    }
}

#[test]
fn delay_and_offsets_are_those_asked_for() {
    let case = quiet(Kind::ThesisLike, 3);
    let mut late = case.clone();
    late.protocol.force_delay_s = 0.005;
    late.protocol.displacement_offset_m = 0.003;
    late.protocol.force_offset_n = 25.0;
    let (plain, late) = (case.run().unwrap(), late.run().unwrap());
    let of = |c: &Campaign| c.tests.iter().find(|t| t.name == "sine_25mm_4Hz").unwrap().clone();
    let (plain, late) = (of(&plain), of(&late));
    // After decimation, the sample rate of this test is 1 kHz, so a delay of 5 ms gives the force five samples earlier.
    for i in 500..plain.force_n.len() {
        assert!((late.force_n[i] - 25.0 - plain.force_n[i - 5]).abs() < 0.02 * plain.force_n[i - 5].abs() + 8.0, "{i}");
        assert!((late.displacement_m[i] - plain.displacement_m[i] - 0.003).abs() < 1e-9);
    }
}

#[test]
fn records_have_the_motion_that_the_plan_states() {
    for plan in [Plan::Sines, Plan::Thesis, Plan::Ramps, Plan::Roads] {
        for seed in [1, 2] {
            let protocol = Protocol { noise_percent: 0.0, bits: None, ..Protocol::of_laboratory(plan, seed) };
            let cycles = protocol.cycles;
            let velocity = protocol.velocity_channel;
            let campaign = Case { protocol, ..Case::new(Kind::ThesisLike, seed) }.run().unwrap();
            assert!(campaign.tests.windows(2).all(|w| w[0].time_s.last() < w[1].time_s.first()), "one clock");
            for test in &campaign.tests {
                assert_eq!(test.left_out, test.name.starts_with(LEFT_OUT_PREFIX));
                assert_eq!(test.velocity_m_s.is_some(), velocity);
                let words: Vec<&str> = test.name.trim_start_matches(LEFT_OUT_PREFIX).split('_').collect();
                if words[0] != "sine" {
                    continue;
                }
                let number =
                    |unit: &str| -> f64 { words.iter().find_map(|w| w.strip_suffix(unit)).unwrap().parse().unwrap() };
                let (amplitude, frequency) = (1e-3 * number("mm"), number("Hz"));
                let mean = words
                    .iter()
                    .find_map(|w| w.strip_prefix("at"))
                    .map_or(0.0, |w| 1e-3 * w.trim_end_matches("mm").parse::<f64>().unwrap());
                let top = test.displacement_m.iter().fold(f64::MIN, |m, x| m.max(*x)) - mean;
                let samples = test.time_s.len() as f64 / f64::from(cycles + 1);
                assert!((top / amplitude - 1.0).abs() < 0.5 * (TAU / samples).powi(2) + 0.01, "{} {top}", test.name);
                let seconds = test.time_s.last().unwrap() - test.time_s[0];
                assert!(seconds > f64::from(cycles) / frequency * 0.99, "{}", test.name);
            }
        }
    }
}

#[test]
fn what_does_not_exist_is_refused_with_what_does() {
    let message = |case: Case| case.run().unwrap_err().to_string();
    let unknown = message(quiet(Kind::Monotube, 1).hiding("magic", 1.0));
    assert!(unknown.contains("'magic'") && unknown.contains("aeration"), "{unknown}");
    let law = message(quiet(Kind::Monotube, 1).hiding("aeration:foamy", 1.0));
    assert!(law.contains("foamy") && law.contains("henry"), "{law}");
    assert!(matches!(quiet(Kind::Monotube, 1).hiding("aeration", -1.0).run(), Err(LabError::Strength { .. })));
    let mut case = quiet(Kind::Monotube, 1);
    case.protocol.sample_rate_hz = 0.0;
    assert!(message(case).contains("sample_rate_hz"));
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("mine.csv"), "mine").unwrap();
    let refused = quiet(Kind::Monotube, 1).run().unwrap().write(folder.path()).unwrap_err().to_string();
    assert!(refused.contains("not an empty folder"), "{refused}");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}
