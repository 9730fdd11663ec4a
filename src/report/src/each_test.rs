//! The single tests: figures, plots and what cleaning noticed.

use super::blocks::{Block, Figure, Section};
use super::numbers::{digits, error, force, frequency, milli, percent};
use crate::plot::{in_space, of_test};
use dashpot_identification::validation::{Compared, TestValidation, Validation};

/// Tests whose plots still make a page that a browser opens at once (about 70 kB each).
const MOST_SHOWN: usize = 120;

/// One choice per test.
pub fn section(validation: &Validation, tests: &[Compared<'_>]) -> Section {
    let about = format!(
        "Loops show the last {} whole cycles of a test; a test without whole cycles is shown whole. Errors are \
         simulated minus measured. The hysteresis gap is averaged over all whole cycles.",
        of_test::CYCLES_SHOWN
    );
    let shown = worst(validation);
    let choices = validation
        .tests
        .iter()
        .zip(tests)
        .enumerate()
        .filter(|(i, _)| shown.contains(i))
        .map(|(i, (figures, compared))| one(i, figures, compared))
        .collect();
    let mut blocks = vec![Block::Paragraph(about)];
    if shown.len() < tests.len() {
        blocks.push(Block::Paragraph(format!(
            "Of {} tests the {} with the largest errors are shown.",
            tests.len(),
            shown.len()
        )));
    }
    Section { choices, ..Section::new("single-tests", "Single tests", blocks) }
}

/// Places of the tests to plot: all, or the worst where they would be too many for a page.
fn worst(validation: &Validation) -> Vec<usize> {
    let mut places: Vec<usize> = (0..validation.tests.len()).collect();
    let percent = |i: &usize| validation.tests[*i].errors.model.error_percent;
    places.sort_by(|a, b| percent(b).total_cmp(&percent(a)));
    places.truncate(MOST_SHOWN);
    places
}

fn one(index: usize, figures: &TestValidation, compared: &Compared<'_>) -> Section {
    let number = index + 1;
    let mut blocks = vec![Block::Paragraph(in_words(figures, compared))];
    let notes = &compared.record.notes;
    if !notes.is_empty() {
        blocks.push(Block::Paragraph("What reading and cleaning did or noticed:".into()));
        blocks.push(Block::List(notes.iter().map(|note| note.text.clone()).collect()));
    }
    let stem = format!("{number:03}-{}", file_name(&figures.name));
    let figure = |kind: &str, svg: String| Figure::new(format!("{stem}-{kind}"), svg);
    let mut plots = vec![
        figure("force-velocity", of_test::force_velocity(compared)),
        figure("force-displacement", of_test::force_displacement(compared)),
        figure("force-in-space", in_space::force(compared)),
        figure("error-velocity", of_test::error_velocity(compared)),
        figure("error-displacement", of_test::error_displacement(compared)),
        figure("error-in-space", in_space::error(compared)),
        figure("force-time", of_test::force_time(compared)),
    ];
    let gap = figures.hysteresis.as_ref().filter(|hysteresis| hysteresis.gap.len() > 1);
    plots.extend(gap.map(|hysteresis| figure("hysteresis-gap", of_test::hysteresis_gap(hysteresis))));
    blocks.push(Block::Figures(plots));
    Section::new(format!("test-{number}"), figures.name.clone(), blocks)
}

/// The test's own figures as sentences.
fn in_words(figures: &TestValidation, compared: &Compared<'_>) -> String {
    let motion = if figures.frequency_hz > 0.0 {
        format!(
            "{} mm amplitude at {} Hz, peak velocity {} mm/s, {} whole cycles.",
            milli(figures.amplitude_m),
            frequency(figures.frequency_hz),
            milli(figures.peak_velocity_m_s),
            figures.cycles,
        )
    } else {
        format!("Not periodic, peak velocity {} mm/s.", milli(figures.peak_velocity_m_s))
    };
    let temperature = compared.record.temperature.as_ref().and_then(|channel| {
        let (first, last) = (channel.first()?, channel.last()?);
        Some(format!(" Temperature {} °C at the start, {} °C at the end.", digits(*first, 3), digits(*last, 3)))
    });
    let noise = if figures.noise_rms_n > 0.0 {
        format!(" Force noise {} N rms.", digits(figures.noise_rms_n, 2))
    } else {
        String::new()
    };
    format!(
        "{motion} {} Largest force {} N. Mean error of the model {} N, {} %; of the force–velocity curve alone {} N, \
         {} %.{noise}{}",
        if figures.used_in_fit { "Used in the fit." } else { "Left out of the fit." },
        force(figures.max_force_n),
        error(figures.errors.model.mean_error_n),
        percent(figures.errors.model.error_percent),
        error(figures.errors.fv_only.mean_error_n),
        percent(figures.errors.fv_only.error_percent),
        temperature.unwrap_or_default(),
    )
}

/// A test's name as part of a file name: what no file system minds. The running number keeps it unique.
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
