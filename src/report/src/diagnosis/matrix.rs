//! Errors by amplitude and peak velocity, before and after.

use crate::blocks::{Block, Figure, Section};
use crate::errors;
use crate::plot::overview;
use dashpot_diagnosis::{Diagnosis, TestOutcome};
use dashpot_identification::validation::{Compared, Validation, validate};
use dashpot_records::Record;

/// The error matrix; `None` where nothing can be compared.
pub fn section(found: &Diagnosis, records: &[&Record]) -> Option<Section> {
    let cycles = mean_cycles(&found.tests, records);
    let compared: Vec<Compared<'_>> = cycles
        .iter()
        .map(|(record, before, after, held_out)| Compared {
            record,
            model: after.clone(),
            fv_only: before.clone(),
            used_in_fit: !held_out,
        })
        .collect();
    let validation = validate(&compared).ok()?;
    let mut blocks = Vec::new();
    blocks.extend(figures(&validation, !found.findings.is_empty()));
    let matrix = &validation.matrix;
    let rule = "Each test has equal weight in its row; the percent is of the largest force of the row. Errors of mean cycles: \
                noise is smaller than in dashpot validate, which compares every sample.";
    let apart = matrix.slow.iter().chain(&matrix.not_periodic);
    let rows = matrix.by_amplitude.iter().chain(apart);
    blocks.push(Block::Table(errors::before_and_after(format!("Tests of one amplitude together. {rule}"), rows)));
    if !matrix.by_peak_velocity.is_empty() {
        let rows = matrix.by_peak_velocity.iter();
        let caption = "Tests of one peak velocity together.".to_owned();
        blocks.push(Block::Table(errors::before_and_after(caption, rows)));
    }
    Some(Section::new("matrix", "Errors by amplitude and peak velocity", blocks))
}

fn figures(validation: &Validation, changed: bool) -> Vec<Block> {
    let mut blocks = Vec::new();
    let before = overview::error_map_of(validation, "Error before, % of largest force", |e| e.fv_only.error_percent);
    blocks.extend(before.map(|svg| {
        Block::Wide(
            Figure::new("matrix-before", svg).saying("One cell per amplitude and peak velocity; dark is far off."),
        )
    }));
    let after = overview::error_map_of(validation, "Error after, % of largest force", |e| e.model.error_percent);
    blocks.extend(after.filter(|_| changed).map(|svg| {
        Block::Wide(Figure::new("matrix-after", svg).saying("The same with what was found, in the same colours."))
    }));
    blocks
}

/// One record per test, made of its mean cycles, with the force before and after and whether it was left out.
fn mean_cycles(tests: &[TestOutcome], records: &[&Record]) -> Vec<(Record, Vec<f64>, Vec<f64>, bool)> {
    let mut all: Vec<(Record, Vec<f64>, Vec<f64>, bool)> = Vec::new();
    for test in tests {
        let curves = &test.curves;
        let finite = curves.before.iter().chain(&curves.after).all(|f| f.is_finite());
        let Some(of) = records.iter().find(|r| r.name == test.test).filter(|_| finite) else { continue };
        let same = all.last().is_some_and(|(r, _, _, out)| r.name == test.test && *out == test.held_out);
        if !same {
            let record = Record {
                time: Vec::new(),
                displacement: Vec::new(),
                velocity: Vec::new(),
                force: Vec::new(),
                cycles: Vec::new(),
                side_force: None,
                temperature: None,
                ..(*of).clone()
            };
            all.push((record, Vec::new(), Vec::new(), test.held_out));
        }
        let Some((record, before, after, _)) = all.last_mut() else { continue };
        let start = record.force.len();
        record.time.extend((start..start + curves.measured.len()).map(|i| i as f64));
        record.displacement.extend(&curves.displacement);
        record.velocity.extend(&curves.velocity);
        record.force.extend(&curves.measured);
        if curves.frequency > 0.0 {
            record.cycles.push(start..record.force.len());
        }
        before.extend(&curves.before);
        after.extend(&curves.after);
    }
    all
}
