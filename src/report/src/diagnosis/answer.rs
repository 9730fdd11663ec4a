//! The verdict in a sentence, and the error of every test before and after the diagnosis.

use crate::blocks::{Block, Column, Figure, Section, Table};
use crate::cells::Cell;
use crate::numbers::{closed_gap, digits, fraction, percent};
use crate::plot::before_after;
use crate::plot::svg::{Anchor, Svg, TextStyle};
use crate::quality::grade;
use crate::words::Words;
use dashpot_diagnosis::{Diagnosis, TestOutcome, Verdict};
use dashpot_messages::Sentence;

/// Builds the first section of a diagnosis report: the verdict, the error of every test, and a table of the key
/// figures.
pub fn section(found: &Diagnosis, words: &Words) -> Section {
    let mut blocks = vec![Block::Lead(headline(found, words))];
    blocks.extend(gap(found, words).map(Block::Paragraph));
    blocks.extend(rating(found, words).map(Block::Paragraph));
    blocks.extend(worse(found, words).map(Block::Warning));
    // The remark on the reference model restricts the meaning of the findings. This first section contains it, so that
    // the brief print includes it.
    blocks.extend(found.about_the_reference.as_ref().map(|about| Block::Paragraph(sentence(about, words))));
    let errors = Figure::new("error-of-tests", before_after::errors(&found.tests, words));
    blocks.push(Block::Wide(errors.saying(words.errors_caption)));
    blocks.push(Block::Table(key_table(found, words)));
    Section::new("answer", words.answer, blocks)
}

/// Formats the result as one sentence.
pub fn headline(found: &Diagnosis, words: &Words) -> String {
    sentence(&found.summary, words)
}

/// Formats a text with a capital first letter and a full stop.
pub(super) fn sentence(text: &Sentence, words: &Words) -> String {
    let said = words.say(text);
    words.fill(words.sentence_end, &[("sentence", &super::capital(said.trim().trim_end_matches('.')))])
}

/// Explains the verdict. For a named effect, the text states the rms errors before and after its addition, N. It also states which fraction
/// of the gap between error and noise the effect closes.
fn gap(found: &Diagnosis, words: &Words) -> Option<String> {
    let left_out = found.tests.iter().filter(|t| t.left_out).count();
    let (text, before, after) = match (left_out, found.before.left_out_rmse_n, found.after.left_out_rmse_n) {
        (1.., Some(before), Some(after)) => (words.error_unseen, before, after),
        _ => (words.error_fitted, found.before.rmse_n, found.after.rmse_n),
    };
    let (tests, before, after) = (left_out.to_string(), digits(before, 3), digits(after, 3));
    let error = words.fill(text, &[("tests", &tests), ("before", &before), ("after", &after)]);
    Some(match found.verdict {
        Verdict::Named => match found.gap_closed {
            Some(gap) => {
                let (gap, is_closed) = closed_gap(gap);
                let text = if is_closed { words.gap_is_closed } else { words.gap_grows };
                words.fill(text, &[("error", &error), ("gap", &gap)])
            }
            None => words.fill(words.sentence_end, &[("sentence", &error)]),
        },
        Verdict::NothingMissing => words.nothing_stays.to_owned(),
        Verdict::Changed => words.changed_stays.to_owned(),
        Verdict::Ambiguous => words.nothing_added_rivals.to_owned(),
        Verdict::UnknownEffect => words.nothing_added_unknown.to_owned(),
    })
}

/// Rates the model after the diagnosis by the ratio of its rms error to the noise. Uses the left-out tests, or all tests if none was left
/// out. Returns `None` if the noise or the error is unknown.
fn rating(found: &Diagnosis, words: &Words) -> Option<String> {
    let after = &found.after;
    let (text, error, noise) = match (after.left_out_rmse_n, after.left_out_noise_n) {
        (Some(error), Some(noise)) => (words.rating_left_out, error, noise),
        _ => (words.rating_fitted, after.rmse_n, after.noise_n),
    };
    let ratio = error / noise;
    // The mean error of all tests can be small even if the error of one test is more than twice its expected error. Noise does not explain
    // the error of such a test, so the ratio is infinite.
    let by_noise = if found.tests.iter().any(TestOutcome::is_missed) { f64::INFINITY } else { ratio };
    let grade = ratio.is_finite().then(|| grade(by_noise, after.error_percent, true, words))?;
    let values = [("grade", grade), ("error", &digits(error, 3)), ("ratio", &digits(ratio, 2))];
    Some(words.fill(text, &values))
}

/// Reports left-out tests whose rms error increased by more than 10 % of their noise. Returns `None` without such tests
/// or without added effects.
fn worse(found: &Diagnosis, words: &Words) -> Option<String> {
    if found.findings.is_empty() {
        return None;
    }
    let is_worse = |t: &&TestOutcome| t.left_out && t.after_rmse_n > t.before_rmse_n + 0.1 * t.noise_n;
    let names: Vec<&str> = found.tests.iter().filter(is_worse).map(|t| t.test.as_str()).collect();
    let (first, count) = (names.first()?, names.len().to_string());
    let all = found.tests.iter().filter(|t| t.left_out).count().to_string();
    Some(words.fill(words.worse_tests, &[("count", &count), ("all", &all), ("test", first)]))
}

fn key_table(found: &Diagnosis, words: &Words) -> Table {
    let held_out = |value: Option<f64>| Cell::known(value, |v| Cell::digits(v, 4));
    let rows = [(words.row_before, &found.before), (words.after, &found.after)]
        .into_iter()
        .take(if found.findings.is_empty() { 1 } else { 2 })
        .map(|(name, f)| {
            vec![
                name.into(),
                Cell::digits(f.rmse_n, 4),
                Cell::digits(f.noise_n, 4),
                held_out(f.left_out_rmse_n),
                held_out(f.left_out_noise_n),
                Cell::number(f.error_percent, percent),
            ]
        })
        .collect();
    let columns = vec![
        Column::words(words.col_model),
        Column::figures(words.col_fitted_rms),
        Column::figures(words.col_their_noise),
        Column::figures(words.col_left_out_rms),
        Column::figures(words.col_their_noise),
        Column::figures(words.col_error_percent),
    ];
    Table { caption: words.mean_cycles_caption.to_owned(), columns, rows, sortable: false }
}

/// Draws the loops of the left-out test on which model and measurement differ most. Below them, draws the error of
/// every test before and after the diagnosis. Without left-out tests, shows a fitted test.
pub fn picture(found: &Diagnosis, words: &Words) -> Option<String> {
    let shown = super::loops::largest(&found.tests, true).or_else(|| super::loops::largest(&found.tests, false))?;
    let [wide, tall] = crate::plot::axes::SIZE;
    let errors = before_after::errors(&found.tests, words);
    let size = |name: &str| -> f64 {
        errors.split(&format!(" {name}=\"")).nth(1).and_then(|t| t.split('"').next()?.parse().ok()).unwrap_or(0.0)
    };
    let name = |f: &dashpot_diagnosis::Finding| {
        words.fill(words.name_and_sure, &[("name", f.effect), ("sure", &fraction(f.confidence))])
    };
    let named: Vec<String> = found.findings.iter().map(name).collect();
    let title = match found.verdict {
        Verdict::Named => words.fill(words.picture_named, &[("names", &named.join(words.comma))]),
        Verdict::NothingMissing | Verdict::Changed => words.picture_nothing.to_owned(),
        Verdict::Ambiguous => words.picture_cannot_tell.to_owned(),
        Verdict::UnknownEffect => words.picture_unknown.to_owned(),
    };
    let kind = if shown.left_out { words.kind_left_out } else { words.kind_fitted };
    let top = 48.0;
    let mut svg = Svg::new((2.0 * wide).max(size("width")), top + tall + size("height"), &title);
    svg.text([20.0, 20.0], &title, TextStyle { bold: true, ..TextStyle::plain(15.0, Anchor::Start) });
    let below = words.fill(words.picture_below, &[("kind", kind), ("test", &shown.test)]);
    svg.text([20.0, 38.0], &below, TextStyle::faint(12.0, Anchor::Start));
    svg.inside([0.0, top], &before_after::force_velocity(shown, words));
    svg.inside([wide, top], &before_after::residual_velocity(shown, words));
    svg.inside([0.0, top + tall], &errors);
    Some(svg.finish())
}
