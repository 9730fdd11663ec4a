//! Text output of `dashpot diagnose --group`: many dampers, or one damper at many settings, each compared with a reference.

use crate::plural::count_tests;
use dashpot_diagnosis::groups::GroupResults;
use dashpot_diagnosis::{Change, Verdict};
use dashpot_messages::Sentence;
use dashpot_report::numbers::{fraction, with_interval, with_unit};
use dashpot_report::words::TERMINAL;

fn change(change: &Change) -> String {
    let (value, interval) = with_interval(change.value, change.low, change.high, change.unit, &TERMINAL);
    format!("{value} (95 %: {interval})")
}

fn count_more(count: usize) -> String {
    if count == 1 { "1 more number".to_owned() } else { format!("{count} more numbers") }
}

/// Largest number of changes that the text lists for a group.
const TOLD: usize = 3;

/// Returns at most [`TOLD`] changes with the largest force. `changed` is sorted by force, largest first. The report and --json contain all
/// changes.
fn foremost(changed: &[Change]) -> &[Change] {
    &changed[..TOLD.min(changed.len())]
}

/// Returns whether the diagnoses of all groups have a note.
fn is_of_all(answers: &GroupResults, note: &Sentence) -> bool {
    answers.groups.iter().all(|answer| answer.diagnosis.notes.contains(note))
}

/// Formats the result of each group, with the parameters that changed in it, and notes. A group has one line, and at most [`TOLD`] + 1
/// lines on parameters.
pub fn format_groups(answers: &GroupResults) -> Vec<String> {
    let is_chain = answers.groups.iter().any(|answer| answer.reference != answers.reference);
    let with = if is_chain { "the group before each, the first with " } else { "" };
    let mut lines = vec![format!("Compared with {with}{}:", answers.reference)];
    for answer in &answers.groups {
        let names: Vec<String> = answer
            .diagnosis
            .findings
            .iter()
            .map(|f| format!("{} ({} sure)", f.effect, fraction(f.confidence)))
            .collect();
        let names = if names.is_empty() { answer.diagnosis.summary.to_string() } else { names.join(", ") };
        lines.push(format!("  {}: {}; {names}", answer.group, count_tests(answer.tests)));
        for (name, of) in answer.diagnosis.findings.iter().flat_map(|finding| &finding.parameters) {
            let (value, interval) = with_interval(of.value, of.low, of.high, of.unit, &TERMINAL);
            lines.push(format!("    {name:<30} {value:>16}  95 %: {interval}"));
        }
        let own = answer.diagnosis.notes.iter().filter(|note| !is_of_all(answers, note));
        lines.extend(own.map(|note| format!("    note: {note}")));
        // If the parameters of a damper changed and no effect is missing, the summary already states the changes.
        if answer.diagnosis.verdict == Verdict::Changed {
            continue;
        }
        let all = answer.diagnosis.changes.len();
        let changed = foremost(&answer.diagnosis.changes);
        for one in changed {
            let before = with_unit(one.reference, one.unit);
            lines.push(format!("    {:<30} {before:>16} -> {}", one.label(), change(one)));
        }
        if all > changed.len() {
            lines.push(format!("    and {}: --report or --json has them", count_more(all - changed.len())));
        }
    }
    if is_chain {
        // Both values are estimates of one damper from different records, so they may differ.
        lines.push(
            "note: before an arrow is the value of a group's own fit, after it that of the comparison with the group before"
                .to_owned(),
        );
    }
    let first = answers.groups.first().map_or(&[][..], |answer| &answer.diagnosis.notes);
    lines.extend(first.iter().filter(|note| is_of_all(answers, note)).map(|note| format!("note: {note}")));
    lines.extend(answers.as_the_fit_saw.iter().map(|text| format!("note: {text}")));
    if !answers.left_aside.is_empty() {
        lines.push(format!(
            "note: {} in no group: {}",
            count_tests(answers.left_aside.len()),
            answers.left_aside.join(", ")
        ));
    }
    if !answers.without_test.is_empty() {
        lines.push(format!("note: the list names what is not in the data: {}", answers.without_test.join(", ")));
    }
    lines
}
