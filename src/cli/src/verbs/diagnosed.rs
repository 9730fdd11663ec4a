//! Result of a diagnosis with errors over whole records, and its output as JSON, text, model file and report.

use super::data::{DataArgs, name_of};
use crate::progress::Progress;
use dashpot_diagnosis::{Diagnosis, Figures, Finding, InventoryItem, Options, Status, diagnose};
use dashpot_identification::AS_THE_FIT_SAW;
use dashpot_identification::model_file::{self, ModelFile};
use dashpot_messages::Sentence;
use dashpot_records::{Campaign, Record, Unusable};
use dashpot_report::diagnosis::{DiagnosisReport, headline};
use dashpot_report::numbers::{closed_gap, digits, fraction, with_interval, with_unit};
use dashpot_report::whole_records;
use dashpot_report::words::{TERMINAL, Words};
use dashpot_report::{Made, Print, parameters, reading};
use dashpot_simulation::whole_records::OfDiagnosis;
use serde::Serialize;
use std::path::Path;

/// A diagnosis with its inputs.
pub struct Diagnosed {
    /// Result of the diagnosis.
    pub found: Diagnosis,
    /// For each record, whether it was held out from every refit.
    pub left_out: Vec<bool>,
    /// Errors of the given, the refitted and the improved model over whole records. `dashpot validate` reports the same
    /// errors.
    pub over_whole_records: OfDiagnosis,
    /// Note on the measurement errors that the model's fit found in its own records. It states whether the diagnosed
    /// records were corrected.
    pub as_the_fit_saw: Option<Sentence>,
    /// Files and tests that could not be used, including those of the reference.
    pub unusable: Vec<Unusable>,
}

/// JSON output: the findings and the errors over whole records.
#[derive(Serialize)]
pub struct Json<'a> {
    #[serde(flatten)]
    found: &'a Diagnosis,
    over_whole_records: OfDiagnosis,
    #[serde(skip_serializing_if = "Option::is_none")]
    as_the_fit_saw: Option<&'a Sentence>,
    unusable: &'a [Unusable],
}

/// Diagnoses a model against a campaign, and computes the errors over whole records.
pub fn examine(
    model: &ModelFile,
    campaign: &Campaign,
    left_out: Vec<bool>,
    options: &Options,
) -> anyhow::Result<Diagnosed> {
    let records: Vec<&Record> = campaign.records.iter().collect();
    let progress = Progress::new("diagnosing");
    let found =
        diagnose(&records, &left_out, &model.params, options, &|done, text| progress.say(done, text.english()))?;
    let over_whole_records =
        OfDiagnosis::evaluate(&model.params, &found.base, &found.improved, &found.measured, &records)?;
    let as_the_fit_saw = campaign.notes.iter().find(|n| n.kind == AS_THE_FIT_SAW).map(|n| n.text.clone());
    let unusable = campaign.unusable.clone();
    Ok(Diagnosed { found, left_out, over_whole_records, as_the_fit_saw, unusable })
}

impl Diagnosed {
    /// Returns the JSON output.
    pub fn json(&self) -> Json<'_> {
        Json {
            found: &self.found,
            over_whole_records: self.over_whole_records,
            as_the_fit_saw: self.as_the_fit_saw.as_ref(),
            unusable: &self.unusable,
        }
    }

    /// Formats the text output.
    pub fn lines(&self) -> Vec<String> {
        let mut lines = format_diagnosis(&self.found);
        lines.splice(1..1, whole_records::of_another_damper(&self.over_whole_records, &TERMINAL));
        lines.push(whole_records::format_errors(&self.over_whole_records, &TERMINAL));
        lines
    }

    /// Formats the improved model as a model file.
    pub fn model(&self, model: &ModelFile, campaign: &Campaign) -> String {
        let records: Vec<&Record> = campaign.records.iter().collect();
        model_file::write(&self.found.as_fit(&records, &self.left_out, model))
    }

    /// Passes the report to `write`, and returns the result of `write`.
    pub fn report<T>(
        &self,
        model: &Path,
        data: &DataArgs,
        campaign: &Campaign,
        made: Made,
        (words, print): (&'static Words, Print),
        write: impl FnOnce(&DiagnosisReport<'_>) -> anyhow::Result<T>,
    ) -> anyhow::Result<T> {
        let records: Vec<&Record> = campaign.records.iter().collect();
        write(&DiagnosisReport {
            model_file: name_of(model),
            data: data.named(),
            found: &self.found,
            records: &records,
            reading: reading::sentences(campaign, words),
            over_whole_records: self.over_whole_records,
            parameters: parameters::of_diagnosis(&self.found, words),
            made,
            print,
            words,
        })
    }
}

/// Largest number of regions of disagreement that the text lists. The report contains all of them.
const REGIONS: usize = 5;
/// Largest number of rejected alternatives to a finding that the text lists. The report contains all of them.
const RIVALS: usize = 2;
/// Largest number of proposed tests that the text lists. The report contains all of them.
const NEXT: usize = 3;

/// Formats the result of a diagnosis as lines of text.
pub fn format_diagnosis(found: &Diagnosis) -> Vec<String> {
    let mut lines = vec![headline(found, &TERMINAL)];
    if !found.inventory.is_empty() {
        lines.push(format!("  {:<28} {:>10} {:>6} {:>12}  {}", "inventory", "N rms", "force", "probability", "status"));
    }
    lines.extend(found.inventory.iter().map(inventory_line));
    if !found.regions.is_empty() {
        lines.push("Where the model disagrees, refitted to these tests:".to_owned());
        lines.extend(found.regions.iter().take(REGIONS).map(|region| format!("  {}", region.text)));
    }
    for finding in &found.findings {
        lines.extend(one(finding));
    }
    let of = if found.findings.is_empty() { "" } else { " of what is left" };
    for suspect in &found.suspects {
        lines.push(format!("Suspect{of}, {}: {}", suspect.effect, suspect.why));
    }
    lines.extend(errors(found));
    if !found.shifts.is_empty() {
        lines.push("Numbers of the model that moved:".to_owned());
    }
    for shift in &found.shifts {
        let (before, after) = (with_unit(shift.before, shift.unit), with_unit(shift.after, shift.unit));
        lines.push(format!("  {:<30} {before:>16} -> {after}", shift.parameter));
    }
    if !found.changes.is_empty() {
        lines.push("Numbers that are others than on the reference damper:".to_owned());
    }
    for change in &found.changes {
        let (value, interval) = with_interval(change.value, change.low, change.high, change.unit, &TERMINAL);
        let before = with_unit(change.reference, change.unit);
        lines.push(format!("  {:<30} {before:>16} -> {value}  95 %: {interval}", change.label()));
    }
    lines.extend(found.notes.iter().map(|note| format!("note: {note}")));
    lines.extend(found.next_tests.iter().take(NEXT).map(|test| format!("next test: {}", test.text)));
    lines.extend(found.could_not_test.iter().map(|c| format!("could not test {}: {}", c.effect, c.why)));
    lines
}

fn one(finding: &Finding) -> Vec<String> {
    let form = if finding.form.is_empty() { String::new() } else { format!(" ({})", finding.form) };
    let mut lines =
        vec![format!("Found {}{form}, {} sure: {}", finding.effect, fraction(finding.confidence), finding.meaning)];
    lines.push(format!(
        "  where: {}, family {} ({} sure)",
        finding.path,
        finding.family,
        fraction(finding.family_confidence)
    ));
    for (name, v) in &finding.parameters {
        let far = if v.plausible { "" } else { "; outside what dampers and rigs show" };
        let (value, interval) = with_interval(v.value, v.low, v.high, v.unit, &TERMINAL);
        lines.push(format!("  {name:<30} {value:>16}  95 %: {interval}{far}"));
    }
    // The error on left-out tests is stronger evidence than the error on fitted tests, so it is stated if it is known.
    lines.push(match finding.gap_closed {
        Some(gap) => format!("  without it {} of the gap opens again", fraction(gap)),
        None => format!("  without it {} of the disagreement opens again", fraction(finding.fraction)),
    });
    if finding.of_the_rig {
        lines.push("  of the rig: corrected in the comparison, not put into the model".to_owned());
    }
    lines.extend(finding.rivals.iter().take(RIVALS).map(|rival| format!("  not {}: {}", rival.effect, rival.why)));
    lines
}

/// Formats the rms errors and the noise, N, before and after the added effects as a table. The last line is the fraction of the gap between
/// error and noise that the effects close.
fn errors(found: &Diagnosis) -> Vec<String> {
    let row = |name: &str, f: &Figures| {
        let optional = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |v| digits(v, 3));
        let (left, left_noise) = (optional(f.left_out_rmse_n), optional(f.left_out_noise_n));
        format!("  {name:<10}{:>10}{:>10}{left:>10}{left_noise:>10}", digits(f.rmse_n, 3), digits(f.noise_n, 3))
    };
    let mut lines = vec![
        format!("  {:<10}{:>10}{:>10}{:>10}{:>10}", "N rms", "fitted", "noise", "left out", "noise"),
        row("before", &found.before),
    ];
    if !found.findings.is_empty() {
        lines.push(row("after", &found.after));
    }
    if let Some(gap) = found.gap_closed {
        let tests = if found.after.left_out_rmse_n.is_some() { "left-out" } else { "fitted" };
        let (part, is_closed) = closed_gap(gap);
        let change =
            if is_closed { format!("{part} of the gap is closed") } else { format!("the gap grows by {part}") };
        lines.push(format!("  {change} on {tests} tests, each counted in units of its own noise"));
    }
    lines
}

/// Formats one effect of the inventory: force, fraction of the measured force, probability and status.
fn inventory_line(item: &InventoryItem) -> String {
    let instead = item.or_instead.map(|of| format!(", or {} in its place ({})", of.effect, fraction(of.probability)));
    let status = match (item.status, item.replaces) {
        (_, Some(old)) => format!("added, in place of {old}"),
        (Status::Kept, None) => format!("kept{}", instead.unwrap_or_default()),
        (Status::Added, None) => "added".to_owned(),
        (Status::Replaced, None) => "replaced".to_owned(),
        (Status::Removed, None) => "removed".to_owned(),
    };
    let form = if item.form.is_empty() { String::new() } else { format!(" ({})", item.form) };
    let (force, part, probability) = (digits(item.force_n_rms, 3), fraction(item.fraction), fraction(item.probability));
    format!("  {:<28} {force:>10} {part:>6} {probability:>12}  {status}{form}", item.effect)
}
