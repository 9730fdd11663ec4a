//! Tests of campaigns that users reported, from the files to the result: the identified effects and measurement errors.
//!
//! Some campaigns are synthetic, so their tests run everywhere. The other campaigns are stored next to the checkout
//! (`../shared/data/reports`).

use dashpot_core::{Params, element, list, number};
use dashpot_diagnosis::{Diagnosis, Options as DiagnosisOptions, diagnose};
use dashpot_identification::{Fit, FitOptions, fit};
use dashpot_records::measurement_correction::{MeasurementError, correct_record};
use dashpot_records::{Campaign, Options, Record, load};
use dashpot_test_support::reported;
use dashpot_tests::kernel_campaign::{Sine, campaign};
use std::fmt::Write as _;
use std::path::Path;

fn read(path: &Path) -> Campaign {
    load(&[path.to_path_buf()], &Options::default(), &|_| ()).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn fitted(campaign: &Campaign) -> Fit {
    fit(&campaign.records.iter().collect::<Vec<_>>(), &FitOptions::default(), |_| ()).unwrap()
}

fn diagnosed(campaign: &Campaign, model: &Params) -> Diagnosis {
    let records: Vec<&Record> = campaign.records.iter().collect();
    diagnose(&records, &[], model, &DiagnosisOptions::default(), &|_, _| ()).unwrap()
}

/// Returns the measurement errors that a fit found: name and value in SI units.
fn errors(fit: &Fit) -> Vec<(&'static str, f64)> {
    fit.measured.iter().map(|m| (m.name, m.value)).collect()
}

fn is_delay(fit: &Fit, delay: f64, within: f64) {
    let found = errors(fit);
    assert!(matches!(found[..], [("delay", value)] if (value - delay).abs() < within), "{delay}: {found:?}");
}

/// Writes records in the form of a logger's files and reads them again.
fn through_files(records: &[Record]) -> Campaign {
    let folder = tempfile::tempdir().unwrap();
    for record in records {
        let mut text = String::from("time (s),displacement (mm),velocity (mm/s),force (N)\n");
        for i in 0..record.time.len() {
            let [x, v] = [record.displacement[i], record.velocity[i]].map(|value| 1e3 * value);
            writeln!(text, "{:.6},{x:.6},{v:.5},{:.4}", record.time[i], record.force[i]).unwrap();
        }
        std::fs::write(folder.path().join(format!("{}.csv", record.name)), text).unwrap();
    }
    read(folder.path())
}

/// Makes a damper that is six to seven times as strong in rebound as in compression, without gas.
fn asymmetric() -> Params {
    let mut params = Params::new();
    params.disable_all();
    params.enable(element!("fv_curve"), true);
    let velocity = [-1.5, -0.6, -0.2, 0.0, 0.2, 0.6, 1.5];
    params.set_list(list!("fv_velocity"), &velocity).unwrap();
    params.set_list(list!("fv_force"), &[-700.0, -330.0, -130.0, 0.0, 900.0, 2200.0, 4300.0]).unwrap();
    params
}

#[test]
fn a_long_delay_is_found_in_two_tests_of_a_very_asymmetric_damper() {
    for delay in [0.012, 0.043] {
        let right = campaign(&asymmetric(), &[Sine::new(0.02, 1.7), Sine::new(0.02, 6.6)], 3, 0.003);
        let late: Vec<Record> = right
            .iter()
            .map(|r| correct_record(r, &MeasurementError { delay_s: -delay, ..MeasurementError::NONE }))
            .collect();
        let campaign = through_files(&late);
        let fit = fitted(&campaign);
        is_delay(&fit, delay, 2e-4);
        assert!(fit.misfit < 1.5, "{delay}: {}", fit.misfit);
    }
}

#[test]
fn a_delay_of_two_or_three_milliseconds_is_a_delay_and_nothing_else() {
    for (name, delay) in [("force_late_l2", 2e-3), ("force_late_l3", 3e-3), ("force_43ms_late", 0.043)] {
        let Some(path) = reported(name) else { return };
        is_delay(&fitted(&read(&path)), delay, 5e-5);
    }
}

#[test]
fn a_force_on_time_has_no_delay() {
    let Some(path) = reported("on_time_but_called_late") else { return };
    let fit = fitted(&read(&path));
    assert!(errors(&fit).is_empty(), "{:?}", errors(&fit));
}

#[test]
fn a_stump_beside_a_gap_makes_no_bump_stop() {
    let Some(path) = reported("gap_in_one_test") else { return };
    let campaign = read(&path);
    assert_eq!(campaign.records.len(), 5);
    let fit = fitted(&campaign);
    for stop in [element!("bump_stop"), element!("rebound_stop")] {
        assert!(!fit.params.is_on(stop), "{:?}", fit.inventory);
    }
}

#[test]
fn a_chamber_that_is_not_refilled_is_named_with_its_length() {
    let Some(path) = reported("starved_chamber") else { return };
    let campaign = read(&path);
    let found = diagnosed(&campaign, &fitted(&campaign).params);
    let finding = &found.findings[0];
    assert_eq!(finding.effect, "cavitation", "{}", found.summary);
    let item = found.inventory.iter().find(|item| item.effect == "cavitation").unwrap();
    assert_eq!(item.form, "rebound begins with a lost stroke");
    let lost = &finding.parameters["lost_stroke"];
    assert!((lost.value - 0.028).abs() < 0.003 && lost.low <= lost.value && lost.unit == "m", "{}", lost.value);
    // The rebound force begins between two samples of the mean cycle, which are 2 mm of the stroke apart. The interval
    // must therefore not be too narrow.
    assert!(lost.low < 0.0283 && lost.high - lost.low > 2e-4, "{} to {}", lost.low, lost.high);
    // The part of the stroke without force is 28 mm of a stroke of 130 to 134 mm.
    let unfilled = finding.parameters["cavitation_unfilled"].value;
    let strokes = campaign.records.iter().map(|r| 2.0 * r.amplitude);
    assert!(strokes.into_iter().all(|stroke| (unfilled * stroke - 0.028).abs() < 0.003), "{unfilled}");
}

#[test]
fn friction_that_fell_is_told_from_a_leak_in_rebound_by_constant_speeds() {
    let Some(path) = reported("staircase_pair") else { return };
    let [good, worn] = ["a", "b"].map(|name| read(&path.join(name)));
    // Tests at constant velocity cannot separate friction from the FV curve, but a gas force that pulls the rod in is
    // impossible.
    let gas = fitted(&good).params.number(number!("gas_force"));
    assert!(gas > -60.0, "{gas}");
    let records: Vec<&Record> = worn.records.iter().collect();
    let options = DiagnosisOptions { reference: good.records.clone(), ..DiagnosisOptions::default() };
    let found = diagnose(&records, &[], &fitted(&good).params, &options, &|_, _| ()).unwrap();
    assert!(found.findings.is_empty(), "{}", found.summary);
    // The friction is 190 N before and 135 N after the change. With constant velocities, the split between friction and
    // bleed flow is uncertain by some newtons.
    let friction = found.changes.iter().find(|change| change.name.ends_with("_force")).unwrap();
    let (before, after) = (friction.reference, friction.value);
    assert!((before - 190.0).abs() < 6.0 && (after - 135.0).abs() < 6.0, "{before} {after}");
    assert!(friction.probability > 0.9);
    let others: Vec<&str> = found.changes.iter().map(|change| change.name).filter(|n| *n != friction.name).collect();
    assert!(!others.is_empty() && others.iter().all(|name| name.starts_with("rebound")), "{others:?}");
}

/// Checks the warning about an uncertain sign convention. For a test with constant velocities and no standstill at its
/// reversals, the sign convention is a guess.
#[test]
fn an_uncertain_sign_is_a_warning_with_the_option() {
    let Some(records) = dashpot_tests::measured::records("reports/staircase_pair/a") else { return };
    let folder = tempfile::tempdir().unwrap();
    let records = records.to_str().unwrap();
    let ran = dashpot_tests::cli::run(folder.path(), &["fit", records, "--model", "fv", "-o", "m.toml"]);
    let warning = ran.err.lines().find(|line| line.starts_with("warning:")).unwrap_or_else(|| panic!("{ran:?}"));
    assert!(warning.contains("50 % sure") && warning.contains("--positive rebound"), "{warning}");
    let stated = ["fit", records, "--model", "fv", "-o", "m.toml", "--positive", "compression"];
    let ran = dashpot_tests::cli::run(folder.path(), &stated);
    assert!(!ran.err.contains("warning: that the files count"), "{ran:?}");
}
