//! Panel of an adjustable damper's valve: responses to a step up and a step down, and the parameters of the actuator.

use crate::session::Session;
use crate::views::legend::{self, Entry, Mark};
use crate::views::{View, grid};
use crate::words::Words;
use dashpot_identification::validation::{ResponseTimes, StepResponse};
use eframe::egui::{self, Color32, RichText, Ui, Vec2};
use egui_plot::{Line, Plot, PlotPoints};

/// Height of the plot of a response, px. With it, two responses and their times fit into a window of 800 px.
const HEIGHT: f32 = 146.0;
/// Color of the model's response.
const MODEL: Color32 = Color32::from_rgb(213, 94, 0);

/// Draws the panel.
pub fn show(ui: &mut Ui, session: &Session, view: &View) {
    let (w, said) = (view.words(), view.language.words());
    egui::ScrollArea::vertical().id_salt("valve").auto_shrink([false, false]).show(ui, |ui| {
        if session.responses.is_waiting() {
            wrapped(ui, RichText::new(w.awaiting).weak());
        }
        for (is_up, title) in [(true, said.plot_step_up), (false, said.plot_step_down)] {
            let Some(of) = session.step_response(is_up) else { continue };
            ui.strong(format!("{title}: {}", step_name(session, &of, w)));
            let about = if of.measured.is_some() { format!("{} {}", w.of_force, of.steps) } else { w.of_valve.into() };
            wrapped(ui, RichText::new(about).small().weak());
            plot(ui, if is_up { "step up" } else { "step down" }, &of, view);
            times(ui, is_up, &of, view);
            ui.add_space(6.0);
        }
        all_steps(ui, session, view);
        numbers(ui, session, view);
    });
}

fn wrapped(ui: &mut Ui, text: RichText) {
    ui.add(egui::Label::new(text).wrap());
}

/// Formats the settings before and after the step.
fn step_name(session: &Session, of: &StepResponse, w: &Words) -> String {
    let unit = session.model.as_ref().and_then(|model| Some(model.over_setting()?.0.unit())).unwrap_or_default();
    format!("{} → {} {unit}", w.typed(of.from), w.typed(of.to)).trim_end().to_owned()
}

fn plot(ui: &mut Ui, id: &'static str, of: &StepResponse, view: &View) {
    let (w, said) = (view.words(), view.language.words());
    let line = |response: &[f64]| -> PlotPoints<'static> {
        of.time.iter().zip(response).map(|(t, r)| [1e3 * t, *r]).filter(|point| point[1].is_finite()).collect()
    };
    let weak = ui.visuals().weak_text_color();
    let measured = (!of.measured_response.is_empty()).then(|| Entry::new(weak, Mark::Line, w.measured));
    let entries: Vec<Entry> = measured.into_iter().chain([Entry::new(MODEL, Mark::Line, w.model)]).collect();
    legend::show(ui, &entries, entries.len());
    // The last number of the lower axis extends beyond the plot, so the plot ends before the edge of the panel.
    let width = ui.available_width() - 14.0;
    let plot = Plot::new(id).height(HEIGHT).width(width).set_margin_fraction(Vec2::splat(0.04));
    // The suffix ", -" of a dimensionless quantity is removed, because the label would be longer than the axis.
    let way = said.axis_way.trim_end_matches(", -").to_owned();
    grid::with_axes(plot, said.axis_since_step.to_owned(), way, w).show(ui, |plot| {
        if !of.measured_response.is_empty() {
            plot.line(Line::new(w.measured, line(&of.measured_response)).color(weak).width(3.5));
        }
        plot.line(Line::new(w.model, line(&of.model_response)).color(MODEL).width(1.5));
    });
}

/// Draws the times of one response, in ms, and its overshoot.
fn times(ui: &mut Ui, is_up: bool, of: &StepResponse, view: &View) {
    let (w, said) = (view.words(), view.language.words());
    egui::Grid::new(("times", is_up)).num_columns(3).striped(true).show(ui, |ui| {
        ui.label("");
        for heading in [w.measured, w.model] {
            ui.label(RichText::new(heading).small().strong());
        }
        ui.end_row();
        let rows: [(&str, fn(&ResponseTimes) -> f64); 3] = [
            (said.col_t63, |times| 1e3 * times.t63_s),
            (said.col_t90, |times| 1e3 * times.t90_s),
            (said.col_overshoot, |times| 100.0 * times.overshoot),
        ];
        for (name, value) in rows {
            ui.label(RichText::new(name).small());
            for times in [&of.measured, &of.model] {
                ui.label(RichText::new(known(times.as_ref().map(value), w)).small());
            }
            ui.end_row();
        }
    });
}

/// Formats a time or a percentage with one decimal, or a dash without a value.
fn known(value: Option<f64>, w: &Words) -> String {
    // A value that rounds to zero is replaced by zero, because a negative one would get a minus sign.
    value.map_or_else(|| "–".to_owned(), |value| w.fixed(if value.abs() < 0.05 { 0.0 } else { value }, 1))
}

/// Draws the response times of all kinds of steps in the open tests, if there are at least three kinds.
fn all_steps(ui: &mut Ui, session: &Session, view: &View) {
    let (w, said) = (view.words(), view.language.words());
    let all = &session.responses.of_force;
    if all.len() < 3 {
        return;
    }
    egui::CollapsingHeader::new(RichText::new(w.all_steps).small()).id_salt("all steps").show(ui, |ui| {
        egui::Grid::new("all steps").num_columns(3).striped(true).show(ui, |ui| {
            ui.label("");
            for heading in [said.col_t63, said.col_t90] {
                ui.label(RichText::new(heading).small().strong());
            }
            ui.end_row();
            for of in all {
                ui.label(RichText::new(step_name(session, of, w)).small());
                let rows: [fn(&ResponseTimes) -> f64; 2] = [|times| 1e3 * times.t63_s, |times| 1e3 * times.t90_s];
                for value in rows {
                    let [measured, model] = [&of.measured, &of.model].map(|times| known(times.as_ref().map(value), w));
                    ui.label(RichText::new(format!("{measured} ({model})")).small());
                }
                ui.end_row();
            }
        });
    });
}

/// Draws the parameters of the actuator with their intervals.
fn numbers(ui: &mut Ui, session: &Session, view: &View) {
    let said = view.language.words();
    wrapped(ui, RichText::new(said.actuator_table).small().weak());
    egui::Grid::new("actuator").num_columns(2).striped(true).show(ui, |ui| {
        for number in session.valve_numbers() {
            ui.label(RichText::new(number.name).small());
            let text = match number.interval {
                Some([low, high]) => view.format().with_interval(number.value, low, high, &number.unit),
                None => format!("{} {}", view.words().digits(number.value), number.unit),
            };
            ui.label(RichText::new(text).small());
            ui.end_row();
        }
    });
}
