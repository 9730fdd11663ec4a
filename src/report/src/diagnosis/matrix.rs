//! Errors by amplitude and peak velocity, before and after the diagnosis.

use crate::blocks::{Block, Figure, Section};
use crate::errors;
use crate::plot::overview;
use crate::words::Words;
use dashpot_diagnosis::{Diagnosis, TestOutcome};
use dashpot_identification::validation::{Compared, Validation, validate};
use dashpot_records::Record;

/// Builds the section of the errors by amplitude and peak velocity. Returns `None` if no test can be compared with the
/// model.
pub fn section(found: &Diagnosis, records: &[&Record], words: &Words) -> Option<Section> {
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
    blocks.extend(figures(&validation, !found.findings.is_empty(), words));
    blocks.extend(errors::before_and_after(&validation.matrix, words));
    Some(Section::new("matrix", words.matrix_section, blocks))
}

fn figures(validation: &Validation, changed: bool, words: &Words) -> Vec<Block> {
    let before = overview::error_map_of(validation, words.map_before, words, |e| e.fv_only.error_percent);
    let after = overview::error_map_of(validation, words.map_after, words, |e| e.model.error_percent);
    let wide = |name: &str, svg: String, caption: &str| Block::Wide(Figure::new(name, svg).saying(caption));
    let before = before.map(|svg| wide("matrix-before", svg, words.map_before_caption));
    let after = after.filter(|_| changed).map(|svg| wide("matrix-after", svg, words.map_after_caption));
    before.into_iter().chain(after).collect()
}

/// Makes one record per test from its mean cycles. Each entry also has the model's forces before and after the
/// diagnosis, and whether the test was left out.
fn mean_cycles(tests: &[TestOutcome], records: &[&Record]) -> Vec<(Record, Vec<f64>, Vec<f64>, bool)> {
    let mut all: Vec<(Record, Vec<f64>, Vec<f64>, bool)> = Vec::new();
    for test in tests {
        let curves = &test.curves;
        let finite = curves.before.iter().chain(&curves.after).all(|f| f.is_finite());
        let Some(of) = records.iter().find(|r| r.name == test.test).filter(|_| finite) else { continue };
        let same = all.last().is_some_and(|(r, _, _, out)| r.name == test.test && *out == test.left_out);
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
            all.push((record, Vec::new(), Vec::new(), test.left_out));
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
