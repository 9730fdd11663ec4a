//! Parts of a report for single tests: errors, plots, and notes on the cleaning of the record.

use super::blocks::{Block, Figure, Section};
use super::numbers::{digits, error, force, frequency, milli, percent};
use crate::plot::{in_space, of_test};
use crate::words::Words;
use dashpot_identification::validation::{Compared, TestValidation, Validation};

/// Largest number of tests with plots. A test adds about 70 kB, so a browser opens a page of this size without delay.
const MOST_SHOWN: usize = 120;

/// Builds one alternative part for each of the [`MOST_SHOWN`] tests with the largest relative errors, in decreasing
/// order.
pub fn section(validation: &Validation, tests: &[Compared<'_>], words: &Words) -> Section {
    let cycles = of_test::CYCLES_SHOWN.to_string();
    let mut blocks = vec![Block::Paragraph(words.fill(words.single_about, &[("cycles", &cycles)]))];
    let shown = by_error(validation);
    if shown.len() < tests.len() {
        let [all, shown] = [tests.len(), shown.len()].map(|n| n.to_string());
        blocks.push(Block::Paragraph(words.fill(words.single_most, &[("tests", &all), ("shown", &shown)])));
    }
    let choices = shown.iter().map(|i| one(*i, &validation.tests[*i], &tests[*i], words)).collect();
    Section { choices, ..Section::new("single-tests", words.single_section, blocks) }
}

/// Builds the plots and the sentence on the errors of the worst test, which has the index `index`.
pub fn worst(validation: &Validation, tests: &[Compared<'_>], index: usize, words: &Words) -> Section {
    let (figures, compared) = (&validation.tests[index], &tests[index]);
    let title = words.fill(words.worst_section, &[("test", &figures.name)]);
    let plots = vec![
        Figure::new("worst-force-velocity", of_test::force_velocity(compared, words)),
        Figure::new("worst-force-displacement", of_test::force_displacement(compared, words)),
        Figure::new("worst-error-velocity", of_test::error_velocity(compared, words)),
        Figure::new("worst-force-time", of_test::force_time(compared, words)),
    ];
    let about = format!("{} {}", words.worst_caption, in_words(figures, compared, words));
    Section::new("worst", title, vec![Block::Figures(plots), Block::Paragraph(about)])
}

/// Returns the indices of at most [`MOST_SHOWN`] tests to plot, in the order of decreasing relative error of the model.
fn by_error(validation: &Validation) -> Vec<usize> {
    let mut places: Vec<usize> = (0..validation.tests.len()).collect();
    let percent = |i: &usize| validation.tests[*i].errors.model.error_percent;
    places.sort_by(|a, b| percent(b).total_cmp(&percent(a)));
    places.truncate(MOST_SHOWN);
    places
}

fn one(index: usize, figures: &TestValidation, compared: &Compared<'_>, words: &Words) -> Section {
    let number = index + 1;
    let stem = format!("{number:03}-{}", file_name(&figures.name));
    let figure = |kind: &str, svg: String| Figure::new(format!("{stem}-{kind}"), svg);
    let mut plots = vec![
        figure("force-velocity", of_test::force_velocity(compared, words)),
        figure("force-displacement", of_test::force_displacement(compared, words)),
        figure("force-in-space", in_space::force(compared, words)),
        figure("error-velocity", of_test::error_velocity(compared, words)),
        figure("error-displacement", of_test::error_displacement(compared, words)),
        figure("error-in-space", in_space::error(compared, words)),
        figure("force-time", of_test::force_time(compared, words)),
    ];
    let gap = figures.hysteresis.as_ref().filter(|hysteresis| hysteresis.gap.len() > 1);
    plots.extend(gap.map(|hysteresis| figure("hysteresis-gap", of_test::hysteresis_gap(hysteresis, words))));
    let mut blocks = vec![Block::Paragraph(in_words(figures, compared, words)), Block::Figures(plots)];
    let notes = &compared.record.notes;
    if !notes.is_empty() {
        blocks.push(Block::Paragraph(words.notes_of_test.into()));
        blocks.push(Block::List(notes.iter().map(|note| words.say(&note.text)).collect()));
    }
    Section::new(format!("test-{number}"), figures.name.clone(), blocks)
}

/// Formats motion, errors, noise and temperature of one test as sentences.
fn in_words(figures: &TestValidation, compared: &Compared<'_>, words: &Words) -> String {
    let (amplitude, velocity) = (milli(figures.amplitude_m), milli(figures.peak_velocity_m_s));
    let motion = if figures.frequency_hz > 0.0 {
        let (frequency, cycles) = (frequency(figures.frequency_hz), figures.cycles.to_string());
        let figures = [
            ("amplitude", amplitude.as_str()),
            ("frequency", &frequency),
            ("velocity", &velocity),
            ("cycles", &cycles),
        ];
        words.fill(words.motion_periodic, &figures)
    } else {
        words.fill(words.motion_other, &[("velocity", &velocity)])
    };
    let mut sentences = vec![motion];
    sentences.push(if figures.used_in_fit { words.test_used.into() } else { words.test_left_out.into() });
    let errors = &figures.errors;
    sentences.push(words.fill(
        words.test_sentence,
        &[
            ("force", &force(figures.max_force_n)),
            ("error", &error(errors.model.mean_error_n)),
            ("percent", &percent(errors.model.error_percent)),
            ("curve_error", &error(errors.fv_only.mean_error_n)),
            ("curve_percent", &percent(errors.fv_only.error_percent)),
        ],
    ));
    if figures.noise_rms_n > 0.0 {
        sentences.push(words.fill(words.force_noise, &[("noise", &digits(figures.noise_rms_n, 2))]));
    }
    sentences.extend(compared.record.temperature.as_ref().and_then(|channel| {
        let (first, last) = (digits(*channel.first()?, 3), digits(*channel.last()?, 3));
        Some(words.fill(words.temperature, &[("first", &first), ("last", &last)]))
    }));
    sentences.join(" ")
}

/// Converts a test's name to at most 60 characters of a portable file name. A number before this text keeps the file
/// name unique.
fn file_name(name: &str) -> String {
    let safe = |c: char| {
        if c.is_ascii_alphanumeric() || c == '-' || c == '_' || c == '.' { c } else { '_' }
    };
    name.chars().map(safe).take(60).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn file_names_are_tame() {
        assert_eq!(file_name("../50 mm: 5 Hz?"), ".._50_mm__5_Hz_");
        assert_eq!(file_name("ä").len(), 1);
    }
}
