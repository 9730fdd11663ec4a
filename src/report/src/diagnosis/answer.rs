//! The verdict in a sentence, and the error of every test before and after.

use crate::blocks::{Block, Column, Figure, Section, Table};
use crate::cells::Cell;
use crate::numbers::{digits, percent, share};
use crate::plot::before_after;
use crate::plot::svg::{Anchor, Svg, TextStyle};
use dashpot_diagnosis::{Diagnosis, TestOutcome, Verdict};

/// The first section.
pub fn section(found: &Diagnosis) -> Section {
    let mut blocks = vec![Block::Lead(headline(found))];
    blocks.extend(gap(found).map(Block::Paragraph));
    blocks.extend(worse(found).map(Block::Warning));
    blocks.push(Block::Table(key_table(found)));
    blocks.push(Block::Wide(Figure::new("error-of-tests", before_after::errors(&found.tests)).saying(
        "Each column is one test: how far the computed force is from the measured one before (grey) and after (red). A red \
         dot on the bar means that nothing but noise is left. Left-out tests were seen by no refit: what closes there is real.",
    )));
    Section::new("answer", "Answer", blocks)
}

/// The answer as one sentence.
pub fn headline(found: &Diagnosis) -> String {
    let mut summary = found.summary.trim().trim_end_matches('.').to_owned();
    if let Some(first) = summary.get(..1).map(str::to_uppercase) {
        summary.replace_range(..1, &first);
    }
    summary + "."
}

/// What the verdict means and how much of the gap is closed.
fn gap(found: &Diagnosis) -> Option<String> {
    let left_out = found.tests.iter().filter(|t| t.held_out).count();
    let where_from = match (left_out, found.before.held_out_rmse_n, found.after.held_out_rmse_n) {
        (1.., Some(before), Some(after)) => format!(
            "On the {left_out} tests that no refit has seen, the error goes from {} to {} N rms",
            digits(before, 3),
            digits(after, 3)
        ),
        _ => format!(
            "No test was left out (too few, or none named), so these figures show how well the model fits, not how well it \
             predicts: the error goes from {} to {} N rms",
            digits(found.before.rmse_n, 3),
            digits(found.after.rmse_n, 3)
        ),
    };
    match found.verdict {
        Verdict::Named => Some(match found.gap_closed {
            Some(gap) => format!("{where_from}; {} of the gap between model and noise is closed, each test counted in units of its own noise.", share(gap)),
            None => format!("{where_from}."),
        }),
        Verdict::NothingMissing => Some("The model stays as it is; only its numbers were refitted.".to_owned()),
        Verdict::CannotTell => Some(
            "Nothing was added: a guess between names that explain the records equally well would be worth nothing. The \
             suspects are below, and the tests that would decide."
                .to_owned(),
        ),
        Verdict::UnknownEffect => Some(
            "Nothing was added: the disagreement is described below without a name. Its shape over velocity, displacement \
             and time says what to look for at the damper or at the rig."
                .to_owned(),
        ),
    }
}

/// Left-out tests that got worse.
fn worse(found: &Diagnosis) -> Option<String> {
    if found.findings.is_empty() {
        return None;
    }
    let is_worse = |t: &&TestOutcome| t.held_out && t.after_rmse_n > t.before_rmse_n + 0.1 * t.noise_n;
    let names: Vec<&str> = found.tests.iter().filter(is_worse).map(|t| t.test.as_str()).collect();
    let (first, count) = (names.first()?, names.len());
    let all = found.tests.iter().filter(|t| t.held_out).count();
    Some(format!("{count} of {all} left-out tests are further off than before, the first is {first}."))
}

fn key_table(found: &Diagnosis) -> Table {
    let held_out = |value: Option<f64>| Cell::known(value, |v| Cell::digits(v, 4));
    let rows = [("before (the model as it came, refitted)", &found.before), ("after", &found.after)]
        .into_iter()
        .take(if found.findings.is_empty() { 1 } else { 2 })
        .map(|(name, f)| {
            vec![
                name.into(),
                Cell::digits(f.rmse_n, 4),
                Cell::digits(f.noise_n, 4),
                held_out(f.held_out_rmse_n),
                held_out(f.held_out_noise_n),
                Cell::number(f.error_percent, percent),
            ]
        })
        .collect();
    let columns = vec![
        Column::words("model"),
        Column::figures("fitted tests,\u{a0}N\u{a0}rms"),
        Column::figures("noise of these,\u{a0}N\u{a0}rms"),
        Column::figures("left-out tests,\u{a0}N\u{a0}rms"),
        Column::figures("noise of these,\u{a0}N\u{a0}rms"),
        Column::figures("error,\u{a0}%"),
    ];
    let caption =
        "On mean cycles, which have less noise than single ones. Error in percent: mean |computed − measured| of a \
                   test over its largest force, mean over all tests."
            .to_owned();
    Table { caption, columns, rows, sortable: false }
}

/// The before/after picture by itself: the loop of the left-out test with the largest gap beside its rest, above the error
/// of every test.
pub fn picture(found: &Diagnosis) -> Option<String> {
    let shown = super::loops::largest(&found.tests, true).or_else(|| super::loops::largest(&found.tests, false))?;
    let [wide, tall] = crate::plot::axes::SIZE;
    let errors = before_after::errors(&found.tests);
    let size = |name: &str| -> f64 {
        errors.split(&format!(" {name}=\"")).nth(1).and_then(|t| t.split('"').next()?.parse().ok()).unwrap_or(0.0)
    };
    let named: Vec<String> =
        found.findings.iter().map(|f| format!("{} ({} sure)", f.effect, share(f.confidence))).collect();
    let title = match found.verdict {
        Verdict::Named => format!("Missing: {}", named.join(", ")),
        Verdict::NothingMissing => "Nothing is missing".to_owned(),
        Verdict::CannotTell => "Something is missing, and these records cannot tell what".to_owned(),
        Verdict::UnknownEffect => "Something is missing that no known effect explains".to_owned(),
    };
    let kind = if shown.held_out { "left out of every refit" } else { "fitted" };
    let top = 48.0;
    let mut svg = Svg::new((2.0 * wide).max(size("width")), top + tall + size("height"), &title);
    svg.text([20.0, 20.0], &title, TextStyle { bold: true, ..TextStyle::plain(15.0, Anchor::Start) });
    let below = format!("Above: test {}, {kind}. Below: every test.", shown.test);
    svg.text([20.0, 38.0], &below, TextStyle::faint(12.0, Anchor::Start));
    svg.inside([0.0, top], &before_after::force_velocity(shown));
    svg.inside([wide, top], &before_after::residual_velocity(shown));
    svg.inside([0.0, top + tall], &errors);
    Some(svg.finish())
}
