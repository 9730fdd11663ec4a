//! Many dampers, or one at many settings, each against the same reference, in lines: `dashpot diagnose --group`.

use dashpot_diagnosis::Change;
use dashpot_diagnosis::groups::Answers;
use dashpot_report::numbers::{share, with_interval, with_unit};
use dashpot_report::words::TERMINAL;

fn change(change: &Change) -> String {
    let (value, interval) = with_interval(change.value, change.low, change.high, change.unit, &TERMINAL);
    format!("{value} (95 %: {interval})")
}

/// Changed numbers of a group that are told one by one.
const TOLD: usize = 3;

/// One line a group, and the numbers that changed in any of them.
pub fn told(answers: &Answers) -> Vec<String> {
    let mut lines = vec![format!("Compared with {}:", answers.reference)];
    for answer in &answers.groups {
        let names: Vec<String> =
            answer.diagnosis.findings.iter().map(|f| format!("{} ({} sure)", f.effect, share(f.confidence))).collect();
        let names = if names.is_empty() { answer.diagnosis.summary.to_string() } else { names.join(", ") };
        lines.push(format!("  {}: {} tests; {names}", answer.group, answer.tests));
        // Those that move the force most; the report and --json have all.
        let mut changed: Vec<&Change> = answer.diagnosis.changed.iter().collect();
        changed.sort_by(|a, b| b.force_share.total_cmp(&a.force_share));
        for one in changed.iter().take(TOLD) {
            let before = with_unit(one.reference, one.unit);
            lines.push(format!("    {:<30} {before:>16} -> {}", one.name(), change(one)));
        }
        if changed.len() > TOLD {
            lines.push(format!("    and {} more numbers: --report or --json has them", changed.len() - TOLD));
        }
    }
    lines.extend(answers.as_the_fit_saw.iter().map(|text| format!("note: {text}")));
    if !answers.left_aside.is_empty() {
        lines.push(format!(
            "note: {} tests belong to no group: {}",
            answers.left_aside.len(),
            answers.left_aside.join(", ")
        ));
    }
    if !answers.without_test.is_empty() {
        lines.push(format!("note: the list names what is not in the data: {}", answers.without_test.join(", ")));
    }
    lines
}
