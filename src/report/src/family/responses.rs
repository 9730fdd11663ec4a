//! Force responses to steps of the setting up and down, their response times, actuator parameters, and hysteresis of
//! the setting.

use super::{FamilyReport, axis_title, named};
use crate::blocks::{Block, Column, Figure, Section, Table};
use crate::cells::Cell;
use crate::numbers::digits;
use crate::plot::axes::{Axis, Marks, Plane, SIZE, Series};
use crate::plot::palette::Role;
use crate::words::Words;
use dashpot_core::Model;
use dashpot_core::family::Definition;
use dashpot_core::family::actuator::Actuator;
use dashpot_identification::family::{ActuatorDecision, actuator_numbers};
use dashpot_identification::model_file::ModelFile;
use dashpot_identification::validation::{ResponseTimes, StepResponse, TimeUncertainty, Validation};
use dashpot_simulation::prediction::at_velocities;

/// Overshoot, percent of the step, below which the table shows 0, because a smaller overshoot is a rounding error.
const NO_OVERSHOOT: f64 = 0.05;
/// Number of points of the hysteresis loop over the setting while the setting increases, and again while it decreases.
const POINTS: usize = 61;
/// Velocity at which the force hysteresis over the setting is drawn, as a fraction of the tests' largest peak velocity.
const VELOCITY: f64 = 0.5;

/// Builds the section of step responses. Returns `None` if the damper has no actuator and no test contains a step.
pub fn section(
    report: FamilyReport<'_>,
    damper: &Definition,
    validation: &Validation,
    words: &Words,
) -> Option<Section> {
    let responses = &validation.step_responses;
    let numbers = actuator(report.model, words);
    let parts = report.fit.and_then(|fit| fit.actuator.as_ref()).map(|fit| parts(&fit.parts, words));
    if responses.is_empty() && numbers.is_none() && parts.is_none() {
        return None;
    }
    let mut blocks = Vec::new();
    if !responses.is_empty() {
        blocks.push(Block::Paragraph(words.responses_about.to_owned()));
    }
    let mut figures: Vec<Figure> = Vec::new();
    for (is_up, title, file) in [(true, words.plot_step_up, "step-up"), (false, words.plot_step_down, "step-down")] {
        let own = responses.iter().filter(|of| of.is_up() == is_up && of.measured.is_some());
        let size = |of: &&StepResponse| (of.to - of.from).abs();
        figures.extend(own.max_by(|a, b| size(a).total_cmp(&size(b))).map(|of| step(damper, of, title, file, words)));
    }
    figures.extend(hysteresis(damper, validation, words));
    if !figures.is_empty() {
        blocks.push(Block::Figures(figures));
    }
    if !responses.is_empty() {
        blocks.push(Block::Table(table(damper, responses, words)));
        blocks.extend(delays(damper, responses, words).map(Block::Paragraph));
    }
    blocks.extend(numbers.map(Block::Table));
    blocks.extend(parts.map(Block::Table));
    Some(Section::new("setting-responses", words.responses_section, blocks))
}

fn step_name(damper: &Definition, of: &StepResponse, words: &Words) -> String {
    format!("{} → {}", named(damper, of.from, words), named(damper, of.to, words))
}

/// Draws the force response to a step from one setting to another, with the model on top of the measurement.
fn step(damper: &Definition, of: &StepResponse, title: &str, file: &str, words: &Words) -> Figure {
    let line = |response: &[f64]| -> Vec<[f64; 2]> {
        of.time.iter().zip(response).map(|(t, r)| [1e3 * t, *r]).filter(|p| p[1].is_finite()).collect()
    };
    let series =
        |role, label, response: &[f64]| Series { role, label, lines: vec![line(response)], marks: Marks::Line };
    let all = [
        series(Role::Measured, words.measured, &of.measured_response),
        series(Role::Model, words.model, &of.model_response),
    ];
    let points = || all.iter().flat_map(|series| &series.lines).flatten().copied();
    let plane = Plane {
        title: title.to_owned(),
        x: Axis::around(words.axis_since_step, points().map(|p| p[0])),
        y: Axis::around(words.axis_way, points().map(|p| p[1])),
        series: all.to_vec(),
    };
    let names = [words.measured.to_owned(), words.model.to_owned()];
    Figure::new(file, plane.draw_named(&names, SIZE, words)).saying(step_name(damper, of, words))
}

/// Builds the table of measured and computed response times, with one row for each pair of start and end setting.
fn table(damper: &Definition, responses: &[StepResponse], words: &Words) -> Table {
    let five = |times: Option<&ResponseTimes>, uncertainty: Option<TimeUncertainty>| -> [Cell; 5] {
        let milli = |s: f64, known: Option<f64>| {
            Cell::number(1e3 * s, |v| match TimeUncertainty::if_coarse(known, s) {
                Some(known) => format!("{} ± {}", digits(v, 3), digits(1e3 * known, 1)),
                None => digits(v, 3),
            })
        };
        match times {
            Some(t) => [
                milli(t.t63_s, uncertainty.map(|of| of.t63_s)),
                milli(t.t90_s, uncertainty.map(|of| of.t90_s)),
                milli(t.t63_s - t.t10_s, None),
                milli(t.t90_s - t.t10_s, uncertainty.map(|of| of.rise_s)),
                Cell::number(100.0 * t.overshoot, |v| if v < NO_OVERSHOOT { "0".to_owned() } else { digits(v, 2) }),
            ],
            None => [(); 5].map(|()| Cell::none()),
        }
    };
    let row = |of: &StepResponse| {
        let mut row: Vec<Cell> = vec![step_name(damper, of, words).into(), Cell::count(of.steps)];
        row.extend(five(of.measured.as_ref(), of.uncertainty));
        row.extend(five(of.model.as_ref(), None));
        row
    };
    let mut columns = vec![Column::words(words.col_step), Column::figures(words.col_steps)];
    for group in [words.measured, words.model] {
        let headings =
            [words.col_t63, words.col_t90, words.col_t63_from_10, words.col_t90_from_10, words.col_overshoot];
        columns.extend(headings.map(|heading| Column::figures(heading).in_group(group)));
    }
    Table {
        caption: words.responses_table.to_owned(),
        columns,
        rows: responses.iter().map(row).collect(),
        sortable: false,
    }
}

/// Names the steps of the setting at which the force of the model is later or earlier than measured. Returns `None`
/// without such steps.
fn delays(damper: &Definition, responses: &[StepResponse], words: &Words) -> Option<String> {
    let step = |of: &StepResponse| {
        let delay = 1e3 * of.delay_of_model()?;
        let sign = if delay > 0.0 { "+" } else { "\u{2212}" };
        Some(format!("{}: {sign}{} ms", step_name(damper, of, words), digits(delay.abs(), 2)))
    };
    let steps: Vec<String> = responses.iter().filter_map(step).collect();
    (!steps.is_empty()).then(|| words.fill(words.responses_late, &[("steps", &steps.join(words.comma))]))
}

/// Builds the table of actuator parameters. Returns `None` for a damper without actuator.
fn actuator(model: &ModelFile, words: &Words) -> Option<Table> {
    let rows: Vec<Vec<Cell>> = actuator_numbers(&model.axis, &model.identification)
        .into_iter()
        .map(|number| {
            // Times are in ms, as in the table of response times.
            let (unit, factor) = if number.unit == "s" { ("ms".to_owned(), 1e3) } else { (number.unit, 1.0) };
            let known =
                |end: usize| number.interval.map_or_else(Cell::none, |ends| Cell::digits(factor * ends[end], 3));
            vec![number.name.into(), Cell::digits(factor * number.value, 3), unit.into(), known(0), known(1)]
        })
        .collect();
    let columns = vec![
        Column::words(words.col_name),
        Column::figures(words.col_value),
        Column::words(words.col_unit),
        Column::figures(words.col_low),
        Column::figures(words.col_high),
    ];
    let caption = words.actuator_table.to_owned();
    (!rows.is_empty()).then_some(Table { caption, columns, rows, sortable: false })
}

/// Builds the table of the actuator's components with their probabilities.
fn parts(parts: &[ActuatorDecision], words: &Words) -> Table {
    let row = |of: &ActuatorDecision| -> Vec<Cell> {
        let how = if of.is_present { words.yes } else { words.no };
        let how = if of.is_undecided() { format!("{how} ({})", words.undecided) } else { how.to_owned() };
        vec![of.name.into(), how.into(), Cell::digits(of.probability, 2)]
    };
    let columns =
        vec![Column::words(words.col_name), Column::words(words.col_has_it), Column::figures(words.col_probability)];
    Table { caption: words.actuator_parts.to_owned(), columns, rows: parts.iter().map(row).collect(), sortable: false }
}

/// Draws the force over a slowly increasing and decreasing setting. Returns `None` without hysteresis.
fn hysteresis(damper: &Definition, validation: &Validation, words: &Words) -> Option<Figure> {
    let actuator = damper.axis.actuator();
    if !actuator.has_hysteresis() {
        return None;
    }
    let peaks = validation.tests.iter().map(|test| test.peak_velocity_m_s);
    let velocity = VELOCITY * peaks.fold(0.0, f64::max);
    let (low, high) = damper.axis.range();
    // The command changes slowly, so the valve is in equilibrium at each command. Thus, the dead time and lag of the
    // actuator are omitted.
    let still = Actuator { hysteresis: actuator.hysteresis, rest: actuator.rest, ..Actuator::NONE };
    let mut stand = still.still(low);
    let mut way = |is_up: bool| -> Vec<[f64; 2]> {
        let mut points = Vec::new();
        for k in 0..POINTS {
            let part = k as f64 / (POINTS - 1) as f64;
            let command = low + (high - low) * if is_up { part } else { 1.0 - part };
            stand = still.at_rest(&stand, command);
            let Ok(model) = Model::new(&damper.params_at(still.setting(&stand))) else { continue };
            points.extend(at_velocities(&model, &[velocity]).iter().map(|[_, force]| [command, *force]));
        }
        points
    };
    // This cycle brings the hysteresis to its steady state before the drawn cycle.
    let _ = (way(true), way(false));
    let lines = [way(true), way(false)];
    let names = [words.way_up.to_owned(), words.way_down.to_owned()];
    let series: Vec<Series> = lines
        .into_iter()
        .enumerate()
        .map(|(k, line)| Series { role: Role::Group(k as u8), label: "", lines: vec![line], marks: Marks::Line })
        .collect();
    let points = || series.iter().flat_map(|series| &series.lines).flatten().copied();
    let plane = Plane {
        title: words.plot_hysteresis_setting.to_owned(),
        x: Axis::around(axis_title(damper, words), points().map(|p| p[0])),
        y: Axis::around(words.axis_force, points().map(|p| p[1])),
        series: series.clone(),
    };
    let speed = digits(1e3 * velocity, 3);
    let behind = named(damper, (1e3 * actuator.hysteresis).round() / 1e3, words);
    let caption = words.fill(words.hysteresis_setting_caption, &[("velocity", &speed), ("hysteresis", &behind)]);
    Some(Figure::new("hysteresis-over-setting", plane.draw_named(&names, SIZE, words)).saying(caption))
}
