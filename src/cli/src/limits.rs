//! Text output of `dashpot validate --limits`. `dashpot_identification::limits` compares the damper with its limits.

use dashpot_identification::limits::{BETWEEN, Certificate, Checked, Limit, NEAR, Overall, Quantity, Verdict};
use dashpot_records::setting_in_words;
use dashpot_report::numbers::digits;

/// Formats the checked limits of a damper as text: a row for every limit, and the overall verdict.
pub fn table(found: &Certificate) -> String {
    let names: Vec<String> = found.limits.iter().map(|one| name_of(&one.limit)).collect();
    let width = names.iter().map(|name| name.chars().count()).fold(0, usize::max).max(LEAST);
    let mut out = format!(
        "{:<width$}{:>12}{:>12}{:>12}{:>12}{:>12}  {}\n",
        "limit", "at mm/s", "low", "high", "measured", "model", "verdict"
    );
    for (one, name) in found.limits.iter().zip(&names) {
        out += &format!("{name:<width$}{}\n", row(one));
    }
    let count = |verdict| found.limits.iter().filter(|l| l.verdict == verdict).count();
    let (failed, untested) = (count(Verdict::Fail), count(Verdict::NotTested));
    if found.limits.iter().any(|l| l.limit.quantity == Quantity::Force) {
        out += &format!(
            "forces: at peak velocity, of the longest stroke that reaches it; interpolated linearly between two tests whose velocities differ by a \
             factor of {BETWEEN} at most, else of a test within {:.0} %\n",
            100.0 * NEAR
        );
    }
    let limits = |count: usize| if count == 1 { "1 limit".to_owned() } else { format!("{count} limits") };
    let are = |count: usize| if count == 1 { "is" } else { "are" };
    let (all, tested) = (found.limits.len(), found.limits.len() - untested);
    out += &match found.overall {
        Overall::Pass if all == 1 => "PASS: the one limit is kept".to_owned(),
        Overall::Pass => format!("PASS: all {all} limits are kept"),
        Overall::Fail if untested == 0 => format!("FAIL: {failed} of {} {} not kept", limits(all), are(failed)),
        Overall::Fail => {
            format!(
                "FAIL: {failed} of the {} tested {} not kept; {untested} more could not be tested with these records",
                limits(tested),
                are(failed)
            )
        }
        Overall::Incomplete if all == 1 => {
            "INCOMPLETE: the one limit could not be tested with these records".to_owned()
        }
        Overall::Incomplete if tested == 0 => {
            format!("INCOMPLETE: none of the {all} limits could be tested with these records")
        }
        Overall::Incomplete => {
            format!(
                "INCOMPLETE: the {} tested {} kept; {untested} more could not be tested with these records",
                limits(tested),
                are(tested)
            )
        }
    };
    if found.passed && found.model_passed == Some(false) {
        out += "; the model does not keep them all, so a simulation shows another damper";
    }
    out
}

/// Smallest width of the column of the limits' names, characters. Longer names widen the column, so that the setting at
/// the end of a name is not truncated.
const LEAST: usize = 28;

/// Formats the name of a limit with its unit and its setting.
fn name_of(limit: &Limit) -> String {
    let (unit, _) = limit.quantity.display();
    let at = limit
        .setting
        .map_or_else(String::new, |value| format!(", at setting {}", setting_in_words(value, &limit.setting_unit)));
    format!("{}, {unit}{at}", limit.name)
}

/// Formats the bounds, the values and the verdict of a limit.
fn row(one: &Checked) -> String {
    let Limit { velocity_m_s, low, high, setting, .. } = &one.limit;
    let (_, factor) = one.limit.quantity.display();
    let known =
        |value: Option<f64>, decimals: usize| value.map_or_else(|| "-".to_owned(), |v| format!("{v:.decimals$}"));
    let verdict = match one.verdict {
        Verdict::Pass => "pass",
        Verdict::Fail => "FAIL",
        Verdict::NotTested if matches!(one.limit.quantity, Quantity::Force | Quantity::Hysteresis) => match setting {
            Some(_) => "NOT TESTED: no test at this speed and setting",
            None => "NOT TESTED: no test at this speed",
        },
        Verdict::NotTested if one.limit.quantity.is_time() => {
            "NOT TESTED: no such step of the setting (a step of the command; a measured coil current shows none)"
        }
        Verdict::NotTested if setting.is_some() => {
            "NOT TESTED: no slow test with whole cycles at this setting (below 6 mm/s; two cycles suffice)"
        }
        Verdict::NotTested => "NOT TESTED: no slow test with whole cycles (below 6 mm/s; two cycles suffice)",
    };
    let unsure = one.deciding_uncertainty().map_or_else(String::new, |uncertainty| {
        format!(", but not sure: the measured time is known to ± {} ms", digits(1e3 * uncertainty, 2))
    });
    let damping = one.damping_in_friction().map_or_else(String::new, |damping| {
        format!(", but {} N of it grow with velocity, so they are damping", digits(damping, 2))
    });
    // The limit applies to every such step, so only the slowest one is named.
    let step = one.measured.as_ref().and_then(|value| value.step);
    let at = |value: f64| setting_in_words(value, &one.limit.setting_unit);
    let step = step.map_or_else(String::new, |(from, to)| format!(" (slowest: from {} to {})", at(from), at(to)));
    format!(
        "{:>12}{:>12}{:>12}{:>12}{:>12}  {verdict}{step}{unsure}{damping}",
        known(velocity_m_s.map(|v| 1e3 * v), 1),
        known(low.map(|low| factor * low), 1),
        known(high.map(|high| factor * high), 1),
        known(one.measured.as_ref().map(|v| factor * v.value), 1),
        known(one.model.as_ref().map(|v| factor * v.value), 1),
    )
}
