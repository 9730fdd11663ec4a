//! Figures of the whole campaign: the error of every test, and the error by amplitude and peak velocity.

use super::axes::{LABEL, Mark, TICK, heading, text_width};
use super::palette::{Role, heat};
use super::svg::{Anchor, Svg, TextStyle};
use super::ticks::{Ticks, number};
use crate::words::Words;
use dashpot_identification::validation::{Errors, Validation};

/// Length of the longest test name that is not shortened, characters.
const NAME: usize = 28;

/// Draws the relative errors of model and force–velocity curve for every test, on a logarithmic scale. Keeps the given order of tests.
pub fn error_of_tests(validation: &Validation, words: &Words) -> String {
    let tests = &validation.tests;
    let pitch = (880.0 / tests.len() as f64).clamp(14.0, 60.0);
    let names: Vec<String> = tests.iter().map(|test| shorten(&test.name)).collect();
    let longest = names.iter().map(|name| text_width(name, TICK)).fold(0.0, f64::max);
    let (left, top, tall) = (66.0, 50.0, 240.0);
    let right = left + pitch * tests.len() as f64;
    let bottom = top + tall;
    let title = words.plot_error_of_tests;
    let mut svg = Svg::new(right.max(380.0) + 14.0, bottom + longest + 20.0, title);
    heading(&mut svg, title, left, &[(Role::Model, words.model, Mark::Dot), (Role::FvOnly, words.fv_curve, Mark::Dot)]);

    // A zero error has no logarithm, so the plot shows it at this lower bound, percent.
    const FLOOR: f64 = 0.01;
    let percents = tests.iter().flat_map(|t| [t.errors.model.error_percent, t.errors.fv_only.error_percent]);
    let (low, high) = percents.map(|p| p.max(FLOOR)).fold((f64::MAX, f64::MIN), |(l, h), p| (l.min(p), h.max(p)));
    let (low, high) = (low / 1.3, high * 1.3);
    let at_y = |percent: f64| bottom - libm::log(percent.max(FLOOR) / low) / libm::log(high / low) * tall;
    let ticks = Ticks::logarithmic(low, high).localized(words);
    svg.grid(&ticks.at.iter().map(|(value, _)| [[left, at_y(*value)], [right, at_y(*value)]]).collect::<Vec<_>>());
    svg.frame(&[[[left, bottom], [right, bottom]], [[left, top], [left, bottom]]], 1.0);
    for (value, label) in &ticks.at {
        svg.text([left - 6.0, at_y(*value) + 4.0], label, TextStyle::faint(TICK, Anchor::End));
    }
    let turned = TextStyle { turn: -90.0, ..TextStyle::plain(LABEL, Anchor::Middle) };
    svg.text([15.0, 0.5 * (top + bottom)], words.axis_error_percent, turned);
    for (i, (test, name)) in tests.iter().zip(&names).enumerate() {
        let x = left + (i as f64 + 0.5) * pitch;
        let (model, curve) = (at_y(test.errors.model.error_percent), at_y(test.errors.fv_only.error_percent));
        svg.grid(&[[[x, model], [x, curve]]]);
        let says = |of: &str, value: f64| format!("{}: {of} {} %", test.name, words.number(&percent(value)));
        let (of_curve, of_model) = (test.errors.fv_only.error_percent, test.errors.model.error_percent);
        svg.dot_saying(Role::FvOnly, [x, curve], 3.4, &says(words.fv_curve, of_curve));
        svg.dot_saying(Role::Model, [x, model], 3.4, &says(words.model, of_model));
        let style = TextStyle { turn: -90.0, ..TextStyle::faint(TICK, Anchor::End) };
        svg.text([x + 4.0, bottom + 8.0], name, style);
    }
    svg.finish()
}

/// Draws the relative error by amplitude (rows) and peak velocity (columns). In each cell, the error of the FV curve stands below the
/// model's error. Returns `None` if the campaign has no periodic tests.
pub fn error_map(validation: &Validation, words: &Words) -> Option<String> {
    let note = words.fill(words.plot_error_map_note, &[("model", words.model), ("curve", words.fv_curve)]);
    let both = |errors: &Errors| (errors.model.error_percent, Some(errors.fv_only.error_percent));
    map(validation, [words.plot_error_map, &note], words, both)
}

/// Draws the map of the error, percent, that `of` selects, by amplitude and peak velocity. Returns `None` if the campaign has no periodic
/// tests.
pub fn error_map_of(
    validation: &Validation,
    title: &str,
    words: &Words,
    of: impl Fn(&Errors) -> f64,
) -> Option<String> {
    map(validation, [title, ""], words, |errors| (of(errors), None))
}

fn map(
    validation: &Validation,
    [title, note]: [&str; 2],
    words: &Words,
    of: impl Fn(&Errors) -> (f64, Option<f64>),
) -> Option<String> {
    let matrix = &validation.matrix;
    if matrix.cells.is_empty() {
        return None;
    }
    let (rows, columns) = (matrix.by_amplitude.len() as f64, matrix.by_peak_velocity.len() as f64);
    let (left, size) = (90.0, [62.0, 38.0]);
    let top = if note.is_empty() { 36.0 } else { 66.0 };
    let (right, bottom) = (left + columns * size[0], top + rows * size[1]);
    let mut svg = Svg::new((right + 14.0).max(470.0), bottom + 50.0, title);
    let bold = TextStyle { bold: true, ..TextStyle::plain(super::axes::TITLE, Anchor::Start) };
    svg.text([20.0, 17.0], title, bold);
    svg.text([20.0, 36.0], note, TextStyle::faint(TICK, Anchor::Start));
    for (i, row) in matrix.by_amplitude.iter().enumerate() {
        let y = top + (i as f64 + 0.5) * size[1] + 4.0;
        svg.text([left - 8.0, y], &words.number(&millimetres(row.value)), TextStyle::faint(TICK, Anchor::End));
    }
    for (i, column) in matrix.by_peak_velocity.iter().enumerate() {
        let x = left + (i as f64 + 0.5) * size[0];
        svg.text([x, bottom + 15.0], &words.number(&millimetres(column.value)), TextStyle::faint(TICK, Anchor::Middle));
    }
    svg.text([0.5 * (left + right), bottom + 34.0], words.axis_peak_velocity, TextStyle::plain(LABEL, Anchor::Middle));
    let turned = TextStyle { turn: -90.0, ..TextStyle::plain(LABEL, Anchor::Middle) };
    svg.text([30.0, 0.5 * (top + bottom)], words.axis_amplitude, turned);
    for cell in &matrix.cells {
        let corner = [left + cell.peak_velocity_row as f64 * size[0], top + cell.amplitude_row as f64 * size[1]];
        let (value, beside) = of(&cell.errors);
        let (fill, dark_text) = heat(value);
        svg.cell([corner[0] + 1.0, corner[1] + 1.0], [size[0] - 2.0, size[1] - 2.0], &fill);
        let middle = corner[0] + 0.5 * size[0];
        let large = TextStyle { bold: true, ..TextStyle::plain(13.0, Anchor::Middle) };
        let drop = if beside.is_some() { 18.0 } else { 24.0 };
        svg.cell_text([middle, corner[1] + drop], &words.number(&percent(value)), large, dark_text);
        if let Some(beside) = beside {
            let small = TextStyle::plain(10.0, Anchor::Middle);
            svg.cell_text([middle, corner[1] + 31.0], &words.number(&percent(beside)), small, dark_text);
        }
    }
    Some(svg.finish())
}

/// Formats a length, m, in mm, or a velocity, m/s, in mm/s, with three digits and at most two decimals.
fn millimetres(si: f64) -> String {
    let value = 1e3 * si;
    number(value, (2.0 - libm::log10(value.abs().max(0.01)).floor()).clamp(0.0, 2.0) as usize)
}

/// Formats a percentage with two decimals below 1, one decimal below 100, and none above.
fn percent(value: f64) -> String {
    number(
        value,
        if value < 1.0 {
            2
        } else if value < 100.0 {
            1
        } else {
            0
        },
    )
}

/// Shortens a name to fit below the axis. Omits the middle, because the end distinguishes tests.
pub fn shorten(name: &str) -> String {
    let letters: Vec<char> = name.chars().collect();
    if letters.len() <= NAME {
        return name.to_owned();
    }
    let keep = (NAME - 1) / 2;
    letters[..keep].iter().chain(&['…']).chain(&letters[letters.len() - keep..]).collect()
}

#[cfg(test)]
mod tests {
    use super::super::of_test::tests::{compared, record};
    use super::*;
    use crate::words::EN;
    use dashpot_identification::validation::validate;

    #[test]
    fn every_test_has_a_dot_for_the_model_and_one_for_the_curve() {
        let records = [record(2, true), record(3, true)];
        let mut tests: Vec<_> = records.iter().map(compared).collect();
        tests[0].model = records[0].force.clone();
        let text = error_of_tests(&validate(&tests).unwrap(), &EN);
        assert_eq!(text.matches("<circle").count(), 2 + 4, "legend and tests");
        assert!(!text.contains("NaN") && !text.contains("inf"));
    }

    #[test]
    fn the_map_needs_periodic_tests() {
        let road = record(2, false);
        assert!(error_map(&validate(&[compared(&road)]).unwrap(), &EN).is_none());
        let sine = record(2, true);
        let map = error_map(&validate(&[compared(&sine)]).unwrap(), &EN).unwrap();
        assert!(map.contains(">50.0<") && map.contains(">314<"), "{map}");
    }

    #[test]
    fn long_names_keep_both_ends() {
        let short = shorten("campaign_2024_left_front_damper_50mm_1571");
        assert!(short.chars().count() <= NAME && short.starts_with("campaign") && short.ends_with("1571"));
    }
}
