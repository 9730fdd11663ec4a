//! Tests of the diagnosis on synthetic records from the kernel. The effect that the diagnosed model lacks is known
//! exactly, and no other effect is missing.

use dashpot_core::list;
use dashpot_core::parameter::{Element, Number};
use dashpot_core::{Model, Params};
use dashpot_diagnosis::{Change, Diagnosis, Options, Status, Verdict, choose_left_out, diagnose};
use dashpot_identification::model_file;
use dashpot_records::Record;
use dashpot_tests::kernel_campaign::{Sine, base, campaign, strokes_and_speeds};
use std::f64::consts::TAU;
use std::path::Path;

/// Returns the tests of a whole campaign: amplitudes and peak velocities, mean displacements, side forces, and slow
/// tests.
fn tests() -> Vec<Sine> {
    with_others(strokes_and_speeds())
}

/// Returns every second combination of amplitude and peak velocity of [`tests`], and all its other tests. They take
/// less time, and suffice where the magnitude of an effect is not checked.
fn fewer_tests() -> Vec<Sine> {
    with_others(strokes_and_speeds().into_iter().skip(1).step_by(2).collect())
}

fn with_others(mut tests: Vec<Sine>) -> Vec<Sine> {
    tests.iter_mut().for_each(|test| test.side_force = Some(0.0));
    for (mean, side) in [(-0.03, 0.0), (-0.015, 0.0), (0.015, 0.0), (0.03, 0.0), (0.0, 500.0), (0.0, 1000.0)] {
        for (amplitude, peak) in [(0.01, 0.2), (0.02, 0.6)] {
            tests.push(Sine { mean, side_force: Some(side), ..Sine::new(amplitude, peak / (TAU * amplitude)) });
        }
    }
    for frequency in [0.008, 0.03, 0.1] {
        tests.push(Sine { side_force: Some(0.0), ..Sine::new(0.01, frequency) });
    }
    tests
}

fn diagnosed(truth: &Params, model: &Params, seed: u64) -> Diagnosis {
    let records = campaign(truth, &tests(), seed, 0.02);
    of(&records, model)
}

fn of(records: &[Record], model: &Params) -> Diagnosis {
    let refs: Vec<&Record> = records.iter().collect();
    let found = diagnose(&refs, &choose_left_out(&refs, 0), model, &Options::default(), &|_, _| ()).unwrap();
    // If the diagnosis names no effect, the refit must not increase the residual by more than 2 %.
    assert!(!found.findings.is_empty() || found.after.rmse_n <= 1.02 * found.before.rmse_n, "{}", describe(&found));
    found
}

fn describe(d: &Diagnosis) -> String {
    let rounds: Vec<String> = d
        .iterations
        .iter()
        .map(|r| {
            r.iter()
                .take(5)
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
                .collect::<Vec<_>>()
                .join("; ")
        })
        .collect();
    let notes: Vec<String> = d.notes.iter().map(ToString::to_string).collect();
    let inventory: Vec<String> = d
        .inventory
        .iter()
        .map(|i| format!("{} [{}] {:?} {:.1} N {:.2}", i.effect, i.form, i.status, i.force_n_rms, i.probability))
        .collect();
    println!("{}", inventory.join("; "));
    format!("{:?} {} | {}\n{}", d.verdict, d.summary, notes.join("; "), rounds.join("\n"))
}

#[test]
fn nothing_is_missing_where_nothing_is() {
    find_nothing(1..=1);
}

#[test]
#[ignore = "more seeds of the test before; half a minute on two cores"]
fn nothing_is_missing_with_more_seeds() {
    find_nothing(2..=5);
}

fn find_nothing(seeds: std::ops::RangeInclusive<u64>) {
    for seed in seeds {
        let found = of(&campaign(&base(), &fewer_tests(), seed, 0.02), &base());
        println!("{}", describe(&found));
        assert_eq!(found.verdict, Verdict::NothingMissing, "{}", describe(&found));
    }
}

/// Diagnoses records of a damper with one additional effect, and asserts that the diagnosis names this effect alone.
/// Returns the fraction of the gap between residual and noise that the improved model closes.
fn names(effect: &str, set: &[(&str, f64)]) -> f64 {
    let mut truth = base();
    truth.enable(Element::find(effect).unwrap(), true);
    for (name, value) in set {
        truth.set(Number::find(name).unwrap(), *value).unwrap();
    }
    let found = diagnosed(&truth, &base(), 11);
    println!("{effect}: {}", describe(&found));
    assert_eq!(found.verdict, Verdict::Named, "{}", describe(&found));
    assert_eq!(found.findings[0].effect, effect, "{}", describe(&found));
    assert_eq!(found.findings.len(), 1, "{}", describe(&found));
    let gap = found.gap_closed.unwrap();
    assert!(gap > 0.75, "{gap}");
    for (name, value) in set {
        if let Some(v) = found.findings[0].parameters.get(name) {
            assert!((v.value / value - 1.0).abs() < 0.3, "{name} {v:?} for {value}");
        }
    }
    gap
}

#[test]
fn friction_under_side_force_is_named() {
    names("side_force_friction", &[("side_force_coefficient", 0.05)]);
}

#[test]
#[ignore = "20 s, for the night; every run names it in a damper of another form"]
fn a_bristle_before_sliding_is_named() {
    names("presliding_friction", &[("presliding_force", 25.0), ("presliding_length", 4e-4)]);
}

#[test]
#[ignore = "half a minute, for the night; every run finds the stop from four starts"]
fn a_bump_stop_is_named() {
    names("bump_stop", &[("bump_stop_clearance", 0.03), ("bump_stop_stiffness", 3e4)]);
}

/// Checks the diagnosis of a gas spring whose thermal state changes more slowly than a cycle. A simulation that is
/// compared with a mean cycle must therefore start from the thermal state on the rig.
#[test]
#[ignore = "20 s, for the night; every run finds this gas with half of the tests"]
fn a_gas_that_takes_seconds_to_cool_is_found_whole() {
    let gap = names("gas_spring", &[("gas_stiffness", 2500.0), ("gas_length", 0.12), ("gas_thermal_time", 3.0)]);
    assert!(gap > 0.95, "{gap}");
}

/// Numbers of a gas column with their true values.
const GAS_COLUMN: [(&str, f64); 3] = [("gas_stiffness", 2500.0), ("gas_length", 0.12), ("gas_thermal_time", 3.0)];

/// Diagnoses few tests of a damper with a gas column and a parallel spring. The given model has the spring alone, and
/// the records make the gas column alone ten times as probable as both.
fn diagnose_gas_column(seed: u64) -> Diagnosis {
    let mut truth = base();
    truth.enable(Element::find("gas_spring").unwrap(), true);
    for (name, value) in GAS_COLUMN {
        truth.set(Number::find(name).unwrap(), value).unwrap();
    }
    let found = of(&campaign(&truth, &fewer_tests(), seed, 0.02), &base());
    assert_eq!(found.findings[0].effect, "gas_spring", "{seed}: {}", describe(&found));
    assert!(found.gap_closed.unwrap() > 0.9, "{seed}: {}", describe(&found));
    found
}

/// Returns the numbers of the gas column whose 95 % interval does not contain the true value.
fn missed(found: &Diagnosis) -> Vec<String> {
    let parameters = &found.findings[0].parameters;
    let is_outside = |(name, value): &(&str, f64)| !(parameters[*name].low..parameters[*name].high).contains(value);
    GAS_COLUMN
        .iter()
        .filter(|row| is_outside(row))
        .map(|(name, _)| format!("{name}: {:?}", parameters[*name]))
        .collect()
}

#[test]
fn an_interval_holds_what_a_less_probable_structure_says() {
    let found = diagnose_gas_column(12);
    assert!(found.gap_closed.unwrap() > 0.95, "{}", describe(&found));
    let missed = missed(&found);
    // The thermal time is below the truth: see the next test.
    assert!(missed.iter().all(|text| text.starts_with("gas_thermal_time")), "{missed:?}");
}

#[test]
#[ignore = "fails: the thermal time of the gas is below the truth in four of four campaigns, by 1 to 11 % beyond its interval"]
fn every_interval_holds_what_a_less_probable_structure_says() {
    let missed: Vec<String> = (12..16).flat_map(|seed| missed(&diagnose_gas_column(seed))).collect();
    assert!(missed.len() <= 1, "{missed:#?}");
}

#[test]
#[ignore = "17 s, for the night; every run finds a mass on the load cell in a fit"]
fn a_mass_between_load_cell_and_damper_is_named() {
    names("moving_mass", &[("moving_mass", 2.0)]);
}

#[test]
fn a_worn_valve_is_told_against_the_damper_as_it_was() {
    let mut worn = base();
    let forces: Vec<f64> = worn.list(list!("fv_force")).iter().map(|f| if *f > 0.0 { 0.8 * f } else { *f }).collect();
    worn.set_list(list!("fv_force"), &forces).unwrap();
    let reference = campaign(&base(), &tests(), 7, 0.01);
    let against = |truth: &Params| {
        let records = campaign(truth, &tests(), 5, 0.01);
        let refs: Vec<&Record> = records.iter().collect();
        let options = Options { reference: reference.clone(), ..Options::default() };
        diagnose(&refs, &choose_left_out(&refs, 0), &base(), &options, &|_, _| ()).unwrap()
    };
    let found = against(&worn);
    assert_eq!(found.verdict, Verdict::Changed, "{}", describe(&found));
    // The forces of the worn damper differ by one factor on the rebound curve, so the diagnosis reports this factor as
    // the first change.
    let change = &found.changes[0];
    assert_eq!(change.name, "rebound_curve", "{}", describe(&found));
    let rest: Vec<&Change> =
        found.changes.iter().skip(1).filter(|c| c.force_n_rms > 0.01 * change.force_n_rms).collect();
    assert!(rest.is_empty(), "{rest:?}");
    assert!((change.value / change.reference - 0.8).abs() < 0.02 && change.probability > 0.5, "{change:?}");
    assert!(change.low < change.value && change.value < change.high, "{change:?}");
    assert!(found.summary.to_string().ends_with("nothing else changed"), "{}", found.summary);
    let same = against(&base());
    assert_eq!(same.verdict, Verdict::NothingMissing, "{}", describe(&same));
    assert!(same.changes.is_empty(), "{:?}", same.changes);
}

/// Delays the force channel of a record in steady motion by `delay`, s.
fn late(record: &Record, delay: f64) -> Record {
    let (first, period) = (record.time[0], record.cycles.len() as f64 / record.frequency);
    let dt = record.time[1] - first;
    let at = |time: f64| {
        let place = (time - first).rem_euclid(period) / dt;
        let (k, share) = ((place as usize).min(record.force.len() - 2), place.fract());
        record.force[k] + share * (record.force[k + 1] - record.force[k])
    };
    Record { force: record.time.iter().map(|t| at(t - delay)).collect(), ..record.clone() }
}

/// Checks that the file of the improved model states the measurement errors of the rig, but that its damper does not
/// contain them.
///
/// If the file did not state the measurement errors, the next evaluation of these records would attribute the errors to
/// the damper.
#[test]
fn what_a_diagnosis_finds_of_the_rig_is_taken_out_again_with_the_improved_model() {
    let model = base();
    let mut records: Vec<Record> = campaign(&model, &fewer_tests(), 11, 0.01).iter().map(|r| late(r, 2e-3)).collect();
    let refs: Vec<&Record> = records.iter().collect();
    let held_out = choose_left_out(&refs, 0);
    let found = diagnose(&refs, &held_out, &model, &Options::default(), &|_, _| ()).unwrap();
    let names: Vec<&str> = found.findings.iter().map(|f| f.effect).collect();
    assert_eq!(names, ["channel_delay"], "{}", describe(&found));
    let before = model_file::of_text(&model_file::flat(&model, |_| String::new()), Path::new("model.toml")).unwrap();
    let text = model_file::write(&found.as_fit(&refs, &held_out, &before));
    let improved = model_file::of_text(&text, Path::new("improved.toml")).unwrap();
    assert!(!improved.was_changed(), "what a diagnosis writes is as it was found");
    // The FV curve alone, fitted to these records, includes the friction. In the model, friction is a separate element.
    let at = |params: &Params, v: f64| Model::new(params).unwrap().elements().paths.fv_curve.evaluate(v).value;
    for v in [-0.02, 0.02] {
        let (plain, own) = (at(&improved.plain(), v), at(&improved.params, v));
        assert!(v.signum() * (plain - own) > 20.0, "at {v} m/s {plain} N, the model's own {own} N");
    }
    let delay = improved.identification.measured().into_iter().find(|m| m.name == "delay").expect("a delay");
    assert!((delay.value - 2e-3).abs() < 1e-4 && delay.low < delay.value && delay.value < delay.high, "{delay:?}");
    let note = improved.identification.right(&mut records).expect("a note");
    assert!(note.text.to_string().contains("taken out of the records"), "{note:?}");
    let again = of(&records, &improved.params);
    assert_eq!(again.verdict, Verdict::NothingMissing, "{}", describe(&again));
}

/// Checks that the effects and the residual that a diagnosis finds do not depend on the initial model of the search.
#[test]
fn the_answer_does_not_depend_on_the_model_that_one_starts_from() {
    let mut truth = base();
    truth.enable(Element::find("bump_stop").unwrap(), true);
    truth.set(Number::find("bump_stop_clearance").unwrap(), 0.03).unwrap();
    truth.set(Number::find("bump_stop_stiffness").unwrap(), 3e4).unwrap();
    let few: Vec<Sine> = fewer_tests().into_iter().step_by(3).collect();
    let records = campaign(&truth, &few, 23, 0.02);
    let without = |elements: &[&str]| {
        let mut model = base();
        elements.iter().for_each(|name| model.enable(Element::find(name).unwrap(), false));
        model
    };
    let mut with_a_wrong_one = base();
    with_a_wrong_one.enable(Element::find("gas_spring").unwrap(), true);
    let starts =
        [base(), without(&["coulomb_friction"]), without(&["series_compliance", "coulomb_friction"]), with_a_wrong_one];
    let answers: Vec<(Vec<&str>, f64)> = starts
        .iter()
        .map(|model| {
            let found = of(&records, model);
            let is_in = |status: Status| matches!(status, Status::Kept | Status::Added);
            let mut effects: Vec<&str> = found.inventory.iter().filter(|i| is_in(i.status)).map(|i| i.effect).collect();
            effects.sort_unstable();
            (effects, found.after.rmse_n)
        })
        .collect();
    let best = answers.iter().map(|a| a.1).fold(f64::INFINITY, f64::min);
    for (effects, rms) in &answers {
        assert_eq!(*effects, answers[0].0, "{answers:?}");
        assert!(*rms <= 1.03 * best, "{answers:?}");
    }
    assert!(answers[0].0.contains(&"bump_stop"), "{answers:?}");
}

/// Checks that the diagnosis reports the status of each effect. In this case, a stop replaces a spring that
/// approximated the stop.
#[test]
fn a_spring_that_stood_for_a_stop_is_replaced() {
    let mut truth = base();
    truth.enable(Element::find("parallel_spring").unwrap(), false);
    truth.enable(Element::find("bump_stop").unwrap(), true);
    truth.set(Number::find("bump_stop_clearance").unwrap(), 0.03).unwrap();
    truth.set(Number::find("bump_stop_stiffness").unwrap(), 3e4).unwrap();
    let mut model = truth;
    model.enable(Element::find("bump_stop").unwrap(), false);
    model.enable(Element::find("parallel_spring").unwrap(), true);
    for name in ["spring_linear", "spring_quadratic"] {
        model.set(Number::find(name).unwrap(), if name == "spring_linear" { 300.0 } else { 2e4 }).unwrap();
    }
    let found = of(&campaign(&truth, &fewer_tests(), 31, 0.02), &model);
    let item = |effect: &str| found.inventory.iter().find(|i| i.effect == effect);
    assert_eq!(item("bump_stop").map(|i| i.status), Some(Status::Added), "{}", describe(&found));
    let spring = item("parallel_spring").map(|i| i.status);
    assert!(matches!(spring, Some(Status::Replaced | Status::Removed)), "{spring:?} {}", describe(&found));
}
