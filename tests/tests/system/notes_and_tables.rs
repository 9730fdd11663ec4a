//! Notes of a fit and its tables: a note never states another number, unit or interval than the table of the same number.

use dashpot_core::number;
use dashpot_core::parameter::Number;
use dashpot_estimation::prior_set::{DamperPrior, PriorSet};
use dashpot_estimation::priors::Distribution;
use dashpot_identification::validation::Deviation;
use dashpot_identification::{Fit, FitOptions, Standing, fit};
use dashpot_records::Record;
use dashpot_records::measurement_correction::{MeasurementError, correct_record};
use dashpot_report::Block;
use dashpot_report::Made;
use dashpot_report::fit::workbook;
use dashpot_report::words::EN;
use dashpot_tests::kernel_campaign::{Sine, base, campaign, strokes_and_speeds};
use std::collections::BTreeMap;

/// Returns tests of several strokes and speeds, with slow ones that show friction and gas.
fn tests() -> Vec<Sine> {
    let mut tests = strokes_and_speeds();
    tests.extend([0.041, 0.01].map(|frequency| Sine::new(0.01, frequency)));
    tests
}

fn fitted(records: &[Record], elements: &[&str], priors: Vec<DamperPrior>) -> Fit {
    let elements = elements.iter().map(|name| (*name).to_owned()).collect();
    let options = FitOptions { elements: Some(elements), priors: PriorSet::new(priors), ..FitOptions::default() };
    fit(&records.iter().collect::<Vec<_>>(), &options, |_| ()).unwrap()
}

fn prior(number: Number, center: f64, deviation: f64) -> DamperPrior {
    let source = "gas_pressure_bar, rod_mm: Dixon 2007, chapter 5".to_owned();
    DamperPrior { number, expected: Distribution::Place(center, deviation), source }
}

/// Rows of the tables of a fit: the name of a number, and the texts of its other cells.
fn rows(fit: &Fit) -> BTreeMap<String, Vec<String>> {
    let book = workbook((fit, &Deviation::default()), &[], ["m", "d"], Made::default(), &EN);
    let tables = book.sections.iter().flat_map(|section| &section.blocks).filter_map(|block| match block {
        Block::Table(table) => Some(&table.rows),
        _ => None,
    });
    let text = |text: &str| text.replace('\u{a0}', " ").replace('\u{2212}', "-");
    tables
        .flatten()
        .filter(|row| row.len() >= 3)
        .map(|row| (row[0].text.clone(), row[1..].iter().map(|cell| text(&cell.text)).collect()))
        .collect()
}

/// Returns the text after one part of a sentence and before another.
fn between<'a>(text: &'a str, from: &str, to: &str) -> &'a str {
    let rest = text.split_once(from).unwrap_or_else(|| panic!("{text}: {from}")).1;
    rest.split_once(to).unwrap_or_else(|| panic!("{text}: {to}")).0
}

fn figure(text: &str) -> f64 {
    text.parse().unwrap_or_else(|_| panic!("{text} is no number"))
}

#[test]
fn a_note_states_the_numbers_of_its_table() {
    let mut truth = base();
    truth.set(number!("gas_force"), 140.0).unwrap();
    let plain = campaign(&truth, &tests(), 3, 0.01);
    let gas = truth.number(number!("gas_force"));
    let late = MeasurementError { delay_s: 3e-3, ..MeasurementError::NONE };
    let wrong = MeasurementError { delay_s: -late.delay_s, ..MeasurementError::NONE };
    let delayed: Vec<Record> = plain.iter().map(|record| correct_record(record, &wrong)).collect();
    let stiffness = truth.number(number!("series_stiffness"));
    // Without short and fast strokes, the records do not determine the mass between damper and mount.
    let long: Vec<Record> = plain.iter().filter(|record| record.frequency < 5.0).cloned().collect();
    let slow: Vec<Record> = plain.iter().filter(|record| record.peak_velocity < 0.4).cloned().collect();
    let known = ["fv_curve", "series_compliance", "parallel_spring", "coulomb_friction", "gas_preload"];
    let fits = [
        fitted(&plain, &known, vec![prior(number!("gas_force"), 2.5 * gas, 0.02 * gas)]),
        fitted(&plain, &known, vec![prior(number!("gas_force"), 1.01 * gas, 0.5 * gas)]),
        fitted(&plain, &known, vec![prior(number!("series_stiffness"), 1.5 * stiffness, 0.01 * stiffness)]),
        fitted(&long, &known, Vec::new()),
        fitted(&delayed, &known, Vec::new()),
        fitted(&slow, &known, Vec::new()),
        fitted(&slow, &known[..1], Vec::new()),
    ];
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    for fit in &fits {
        let rows = rows(fit);
        let row = |name: &str| {
            let found = rows.iter().find(|(known, _)| known.contains(name));
            found.unwrap_or_else(|| panic!("{name} has no row: {rows:?}")).1
        };
        for note in fit.notes.iter().map(ToString::to_string) {
            let name = note.split(' ').next().unwrap_or_default();
            if note.contains(" is held at ") || note.contains("ran into the bound") {
                let stated = note.rsplit_once(" at ").unwrap().1.split(':').next().unwrap();
                let row = row(name);
                if row[0] == "–" {
                    // A number that the records do not determine has no value in the table. Its remark states the assumed value.
                    assert!(row[5].contains(stated), "{note} {row:?}");
                } else {
                    assert_eq!(stated, format!("{} {}", row[0], row[1]).trim_end(), "{note}");
                }
                *seen.entry("held").or_default() += 1;
            } else if note.contains(" contradicts the dimensions ") {
                let stated = between(&note, "damper: ", " are ");
                let row = row(name);
                assert_eq!(stated, format!("{} {}", row[0], row[1]), "{note}");
                // The value expected from the dimensions lies outside the interval in the table.
                let expected = between(&note, "times the ", " that ").split(' ').next().map(figure).unwrap();
                assert!(expected < figure(&row[2]) || expected > figure(&row[3]), "{note} {row:?}");
                let ratio = figure(&row[0]) / expected;
                assert!((figure(between(&note, " are ", " times")) / ratio - 1.0).abs() < 0.01, "{note}");
                *seen.entry("contradicted").or_default() += 1;
            } else if note.contains(" was expected at ") {
                let [low, high] = [between(&note, "95 %: ", " to "), between(&note, " to ", ")")].map(figure);
                let row = row(name);
                let estimate = fit.estimates.iter().find(|estimate| estimate.name == name).unwrap();
                assert_eq!(between(&note, "expected at ", " (").split_once(' ').unwrap().1, row[1], "{note}");
                // If the records do not contradict the expected value, the interval of the expected value and the interval in the table
                // overlap.
                if estimate.standing == Standing::Identified {
                    assert!(figure(&row[2]) <= high && figure(&row[3]) >= low, "{note} {row:?}");
                }
                *seen.entry("expected").or_default() += 1;
            } else if note.contains("the force channel lags the motion by ") {
                let row = row("delay");
                assert_eq!(format!("{} ms", between(&note, "lags the motion by ", " ms")), row[0], "{note}");
                let interval = between(&note, "(95 %: ", ")");
                assert_eq!(format!("{interval} ms"), row[1], "{note}");
                *seen.entry("late").or_default() += 1;
            }
        }
    }
    for kind in ["held", "contradicted", "expected", "late"] {
        let notes: Vec<String> = fits.iter().flat_map(|fit| &fit.notes).map(ToString::to_string).collect();
        assert!(seen.contains_key(kind), "no fit has a note of the kind {kind}: {seen:?} {notes:#?}");
    }
}
