//! A damper over a setting: its FV curves, and the errors at each setting.

use crate::blocks::{Block, Column, Figure, Section, Table};
use crate::cells::Cell;
use crate::errors::three;
use crate::plot::axes::{Axis, Marks, Plane, Series};
use crate::plot::palette::Role;
use crate::words::Words;
use dashpot_core::Model;
use dashpot_core::family::Definition;
use dashpot_identification::validation::{SettingSummary, Validation};
use dashpot_simulation::comparison::at_constant_velocity;

/// Size of the figure, px: it is printed across the page.
const SIZE: [f64; 2] = [880.0, 400.0];

/// The section; `None` where the damper depends on no setting.
pub fn section(damper: &Definition, validation: &Validation, words: &Words) -> Option<Section> {
    if !damper.axis.is_some() {
        return None;
    }
    let mut blocks = vec![Block::Paragraph(words.family_about.to_owned())];
    blocks.extend(curves(damper, validation, words).map(Block::Wide));
    blocks.push(Block::Table(table(damper, &validation.settings, words)));
    Some(Section::new("setting", words.family_section, blocks))
}

/// A value of the setting with its unit.
fn named(damper: &Definition, setting: f64, words: &Words) -> String {
    words.number(format!("{setting} {}", damper.axis.unit()).trim_end())
}

/// Force at constant velocity at each setting, with the measured peaks.
fn curves(damper: &Definition, validation: &Validation, words: &Words) -> Option<Figure> {
    let line = |setting: f64| -> Option<Vec<[f64; 2]>> {
        let model = Model::new(&damper.params_at(setting)).ok()?;
        Some(at_constant_velocity(&model, validation).into_iter().map(|[v, f]| [1e3 * v, f]).collect())
    };
    let (mut series, mut names) = (Vec::new(), Vec::new());
    let mut add = |role: Role, name: String, points: Option<Vec<[f64; 2]>>, marks: Marks| {
        if let Some(points) = points.filter(|points| !points.is_empty()) {
            series.push(Series { role, label: "", lines: vec![points], marks });
            names.push(name);
        }
    };
    let peaks = validation.tests.iter().flat_map(|test| &test.peaks);
    let measured = peaks.map(|peak| [1e3 * peak.velocity_m_s, peak.force_n.measured]).collect();
    add(Role::Shadow, words.measured_peaks.to_owned(), Some(measured), Marks::Dots);
    for (k, setting) in damper.axis.grid().iter().enumerate() {
        add(Role::Group(k as u8), named(damper, *setting, words), line(*setting), Marks::Line);
    }
    for of in validation.settings.iter().filter(|of| !of.is_of_grid) {
        let name = words.fill(words.family_interpolated, &[("setting", &named(damper, of.setting, words))]);
        add(Role::Before, name, line(of.setting), Marks::Line);
    }
    if series.is_empty() {
        return None;
    }
    let all = || series.iter().flat_map(|s: &Series| &s.lines).flatten().copied();
    let plane = Plane {
        title: words.plot_family.into(),
        x: Axis::around(words.axis_velocity, all().map(|p| p[0])),
        y: Axis::around(words.axis_force, all().map(|p| p[1])),
        series,
    };
    Some(Figure::new("curves-by-setting", plane.draw_named(&names, SIZE, words)).saying(words.family_caption))
}

/// Errors of the model and of the plain curve at each setting.
fn table(damper: &Definition, settings: &[SettingSummary], words: &Words) -> Table {
    let row = |of: &SettingSummary| {
        let name = named(damper, of.setting, words);
        let name = match of.is_of_grid {
            true => name,
            false => words.fill(words.family_interpolated, &[("setting", &name)]),
        };
        let mut row: Vec<Cell> = vec![name.into(), of.summary.tests.to_string().into()];
        row.extend(three(&of.summary.errors.model));
        row.extend(three(&of.summary.errors.fv_only));
        row
    };
    let figures = |group: &'static str| {
        [words.col_mean_error, words.col_error_percent, words.col_rms]
            .map(|heading| Column { group, ..Column::figures(heading) })
    };
    let mut columns = vec![Column::words(words.col_setting), Column::figures(words.col_number)];
    columns.extend(figures(words.model));
    columns.extend(figures(words.group_curve));
    Table { caption: words.family_table.to_owned(), columns, rows: settings.iter().map(row).collect(), sortable: false }
}
