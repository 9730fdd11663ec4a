//! Force loops of selected tests: one motion at all settings, and the test with the largest relative error at each setting.

use super::{named, named_summary};
use crate::blocks::{Block, Figure, Section};
use crate::numbers::{error, milli, percent};
use crate::plot::axes::{Axis, Marks, Plane, SIZE, Series};
use crate::plot::of_test;
use crate::plot::palette::Role;
use crate::words::Words;
use dashpot_core::family::Definition;
use dashpot_identification::validation::{Compared, Validation};

/// Largest relative difference of amplitude and peak velocity between tests with the same motion.
const SAME_MOTION: f64 = 0.1;

/// Builds the section of loops. Returns `None` without settings.
pub fn section(damper: &Definition, validation: &Validation, tests: &[Compared<'_>], words: &Words) -> Option<Section> {
    let common = common_motion(validation)?;
    let mut blocks = Vec::new();
    if let Some(first) = common.iter().flatten().next() {
        let test = &validation.tests[*first];
        let figures = [("amplitude", milli(test.amplitude_m)), ("velocity", milli(test.peak_velocity_m_s))];
        let figures = figures.each_ref().map(|(name, value)| (*name, value.as_str()));
        blocks.push(Block::Paragraph(words.fill(words.family_loops_about, &figures)));
        let over = |title, axis, file, of: for<'c> fn(&'c Compared<'_>) -> &'c [f64]| {
            Figure::new(file, together(damper, validation, (&common, tests), [title, axis], of, words))
        };
        blocks.push(Block::Figures(vec![
            over(words.plot_force_velocity, words.axis_velocity, "loops-force-velocity", |c| &c.record.velocity),
            over(words.plot_force_displacement, words.axis_displacement, "loops-force-displacement", |c| {
                &c.record.displacement
            }),
        ]));
    }
    blocks.push(Block::Paragraph(words.family_worst_about.to_owned()));
    let worst = validation.settings.iter().enumerate().filter_map(|(k, of)| {
        let errors = |place: &&usize| validation.tests[**place].errors.model.error_percent;
        let place = *of.places.iter().max_by(|a, b| errors(a).total_cmp(&errors(b)))?;
        let (test, compared) = (&validation.tests[place], tests.get(place)?);
        let caption = words.fill(
            words.family_worst_caption,
            &[
                ("setting", &named_summary(damper, of, words)),
                ("test", &test.name),
                ("error", &error(test.errors.model.mean_error_n)),
                ("percent", &percent(test.errors.model.error_percent)),
            ],
        );
        let svg = of_test::force_velocity(compared, words);
        Some(Figure::new(format!("worst-of-setting-{}", k + 1), svg).saying(caption))
    });
    blocks.push(Block::Figures(worst.collect()));
    Some(Section::new("setting-loops", words.family_loops_section, blocks))
}

/// Selects the motion that was tested at most settings, and returns the index of its test at each setting. If several motions were tested
/// equally often, selects the fastest. Returns `None` without settings.
fn common_motion(validation: &Validation) -> Option<Vec<Option<usize>>> {
    let alike = |a: usize, b: usize| {
        let near = |a: f64, b: f64| (a - b).abs() <= SAME_MOTION * a.abs().max(b.abs());
        let (a, b) = (&validation.tests[a], &validation.tests[b]);
        near(a.amplitude_m, b.amplitude_m) && near(a.peak_velocity_m_s, b.peak_velocity_m_s)
    };
    let of_each = |first: usize| -> Vec<Option<usize>> {
        let own = |places: &[usize]| places.iter().copied().find(|place| alike(first, *place));
        validation.settings.iter().map(|of| own(&of.places)).collect()
    };
    let places = validation.settings.iter().flat_map(|of| of.places.iter().copied());
    let speed = |place: usize| validation.tests[place].peak_velocity_m_s;
    let key = |all: &Vec<Option<usize>>| all.iter().flatten().count();
    places
        .map(|place| (of_each(place), speed(place)))
        .max_by(|(a, v), (b, w)| key(a).cmp(&key(b)).then(v.total_cmp(w)))
        .map(|(all, _)| all)
}

/// Draws the loops of one motion at all settings, with the model on top of the measurement.
fn together(
    damper: &Definition,
    validation: &Validation,
    (common, tests): (&[Option<usize>], &[Compared<'_>]),
    [title, axis]: [&str; 2],
    over: for<'c> fn(&'c Compared<'_>) -> &'c [f64],
    words: &Words,
) -> String {
    let (mut series, mut names) = (Vec::new(), Vec::new());
    let chosen: Vec<(usize, &Compared<'_>)> =
        common.iter().enumerate().filter_map(|(k, place)| Some((k, tests.get((*place)?)?))).collect();
    let lines = |compared: &Compared<'_>, force: &[f64]| -> Vec<Vec<[f64; 2]>> {
        let x = over(compared);
        // The cycles of one test coincide, so the figure shows only the last one.
        let last = of_test::shown(compared).pop();
        last.into_iter().map(|range| range.map(|i| [1e3 * x[i], force[i]]).collect()).collect()
    };
    for (place, (_, compared)) in chosen.iter().enumerate() {
        series.push(Series {
            role: Role::Before,
            label: "",
            lines: lines(compared, &compared.record.force),
            marks: Marks::Line,
        });
        names.push(if place == 0 { words.measured.to_owned() } else { String::new() });
    }
    for (k, compared) in &chosen {
        let setting = validation.settings[*k].setting;
        let grid = damper.axis.grid();
        let place = grid.iter().position(|value| dashpot_records::is_same_setting(*value, setting));
        let role = place.map_or(Role::Before, |k| Role::Group(k as u8));
        series.push(Series { role, label: "", lines: lines(compared, &compared.model), marks: Marks::Line });
        names.push(named(damper, setting, words));
    }
    let all = || series.iter().flat_map(|series: &Series| &series.lines).flatten().copied();
    let plane = Plane {
        title: title.to_owned(),
        x: Axis::around(axis, all().map(|p| p[0])),
        y: Axis::around(words.axis_force, all().map(|p| p[1])),
        series: series.clone(),
    };
    plane.draw_named(&names, SIZE, words)
}
