//! The error matrix as colored cells; a click shows the tests of a cell.

use crate::session::Session;
use crate::session::matrix::{Across, Grid};
use crate::views::{View, colour, explain_provisional, percent};
use crate::words::Words;
use dashpot_report::plot::palette::heat;
use eframe::egui::{self, Color32, RichText, Ui, Vec2};

/// Space between two cells, px.
const SPACE: f32 = 2.0;
/// Space on either side of a heading, px. Without it, the headings of neighboring columns touch.
const PAD: f32 = 2.0;

/// Draws the heading of a row or column.
fn heading(ui: &mut Ui, text: RichText) {
    egui::Frame::new().inner_margin(egui::Margin::symmetric(PAD as i8, 0)).show(ui, |ui| ui.label(text));
}

/// Draws the error matrix.
pub fn show(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let w = view.words();
    let Some(loaded) = session.campaign.clone() else { return };
    ui.horizontal_wrapped(|ui| {
        ui.strong(w.error_matrix);
        let is_provisional = session.are_errors_provisional();
        // The mark of the unit applies to all cells.
        ui.weak(if is_provisional { "≈\u{a0}%" } else { "%" }).on_hover_text(w.error_hint);
        ui.selectable_value(&mut view.across, Across::Velocity, w.peak_velocity);
        ui.selectable_value(&mut view.across, Across::Frequency, w.frequency);
        if let Some(simulated) = &session.simulated {
            let mean = simulated.tests.iter().map(|t| t.percent).sum::<f64>() / simulated.tests.len().max(1) as f64;
            let mean = ui.label(format!("{}\u{a0}{}", w.mean, percent(mean, is_provisional, w)));
            explain_provisional(mean, is_provisional, w);
        }
    });
    let grid = Grid::new(&loaded.campaign.records, view.across);
    let simulated = session.simulated.clone();
    let error = |tests: &[usize]| {
        let of: Vec<f64> = tests.iter().filter_map(|k| Some(simulated.as_ref()?.tests.get(*k)?.percent)).collect();
        (!of.is_empty()).then(|| of.iter().sum::<f64>() / of.len() as f64)
    };
    let (length, velocity) = (view.units.length(), view.units.velocity());
    let (of, across) = match view.across {
        Across::Velocity => (format!("{} \\ {}", length.symbol, velocity.symbol), velocity.factor),
        Across::Frequency => (format!("{} \\ Hz", length.symbol), 1.0),
    };
    let columns = grid.columns.len().max(1) as f32;
    let font = egui::TextStyle::Small.resolve(ui.style());
    let first = ui.painter().layout_no_wrap(of.clone(), font, Color32::WHITE).size().x + 2.0 * PAD;
    let width = ((ui.available_width() - first) / columns - SPACE).clamp(30.0, 64.0);
    let mut chosen: Option<Vec<usize>> = None;
    egui::ScrollArea::both().id_salt("matrix").auto_shrink([false, false]).show(ui, |ui| {
        // Wider buttons would not fit into a window of 1280 px.
        ui.spacing_mut().button_padding.x = 1.0;
        egui::Grid::new("matrix").spacing([SPACE, 2.0]).min_col_width(30.0).show(ui, |ui| {
            heading(ui, RichText::new(of).small().weak());
            for column in &grid.columns {
                heading(ui, RichText::new(short(across * column, w)).small());
            }
            ui.end_row();
            for (r, amplitude) in grid.rows.iter().enumerate().rev() {
                heading(ui, RichText::new(short(length.factor * amplitude, w)).small());
                for c in 0..grid.columns.len() {
                    let tests = grid.cell(r, c);
                    if tests.is_empty() {
                        ui.label("");
                        continue;
                    }
                    let shown = tests.iter().any(|k| session.selected.contains(k));
                    if cell(ui, error(tests), shown, width, w).clicked() {
                        chosen = Some(tests.to_vec());
                    }
                }
                ui.end_row();
            }
        });
        for (name, tests) in [(w.slow_tests, &grid.slow), (w.not_periodic, &grid.elsewhere)] {
            if tests.is_empty() {
                continue;
            }
            ui.horizontal(|ui| {
                let shown = tests.iter().any(|k| session.selected.contains(k));
                if cell(ui, error(tests), shown, width, w).clicked() {
                    chosen = Some(tests.clone());
                }
                ui.label(RichText::new(format!("{name} ({})", tests.len())).small());
            });
        }
    });
    if let Some(tests) = chosen {
        let more = ui.input(|i| i.modifiers.command);
        if !more {
            session.selected.clear();
        }
        session.selected.extend(tests);
    }
}

/// Formats an amplitude, a velocity or a frequency as the heading of a row or column, with three digits.
fn short(value: f64, w: &Words) -> String {
    w.of.words().number(&dashpot_report::numbers::digits(value, 3))
}

fn cell(ui: &mut Ui, percent: Option<f64>, shown: bool, width: f32, w: &Words) -> egui::Response {
    let (text, fill, ink) = match percent {
        Some(percent) => {
            let (fill, dark_ink) = heat(percent);
            let text = w.fixed(percent, if percent < 9.995 { 2 } else { 1 });
            (text, colour(&fill), if dark_ink { Color32::BLACK } else { Color32::WHITE })
        }
        None => ("·".to_owned(), ui.visuals().faint_bg_color, ui.visuals().text_color()),
    };
    let stroke = if shown { egui::Stroke::new(2.0, ui.visuals().strong_text_color()) } else { egui::Stroke::NONE };
    let text = RichText::new(text).color(ink).size(11.0);
    let button = egui::Button::new(text).fill(fill).stroke(stroke).min_size(Vec2::new(width, 18.0)).corner_radius(1.0);
    ui.add(button).on_hover_text(percent.map_or_else(String::new, |p| format!("{} %", w.digits(p))))
}
