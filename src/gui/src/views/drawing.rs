//! Panel of the physical quantities of gas, oil and valves from the dimensions of the damper: values, undetermined
//! quantities, contradictions.

use crate::dialogs::Ask;
use crate::session::Session;
use crate::views::View;
use crate::words::Words;
use dashpot_dimensions::inverse::{Gap, Quantity};
use dashpot_report::numbers::with_interval;
use eframe::egui::{self, RichText, Ui};

/// Draws the panel.
pub fn show(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let w = view.words();
    ui.horizontal_wrapped(|ui| {
        let name = session.drawing.as_ref().and_then(|drawing| drawing.path.file_name());
        ui.heading(name.map(|name| name.to_string_lossy().into_owned()).unwrap_or_default());
        if ui.button(w.open_dimensions).clicked() {
            view.asks.push(Ask::Dimensions);
        }
    });
    let Some(explanation) = session.explain() else {
        wrapped(ui, RichText::new(w.no_explained).weak());
        return;
    };
    egui::ScrollArea::vertical().id_salt("drawing").auto_shrink([false, false]).show(ui, |ui| {
        if !explanation.contradictions.is_empty() {
            ui.strong(w.contradictions);
            for found in &explanation.contradictions {
                let text =
                    RichText::new(format!("⚠ {}", view.format().say(&found.text))).color(ui.visuals().warn_fg_color);
                ui.add(egui::Label::new(text).wrap()).on_hover_text(found.parameter);
            }
            ui.separator();
        }
        if explanation.quantities.is_empty() && explanation.unknown.is_empty() {
            wrapped(ui, RichText::new(w.nothing_explained).weak());
        }
        if !explanation.quantities.is_empty() {
            ui.strong(w.quantities);
        }
        for of in &explanation.quantities {
            quantity(ui, of, w);
        }
        if !explanation.unknown.is_empty() {
            ui.separator();
            ui.strong(w.unknown_quantities);
        }
        for of in &explanation.unknown {
            gap(ui, of, w);
        }
    });
}

fn wrapped(ui: &mut Ui, text: RichText) -> egui::Response {
    ui.add(egui::Label::new(text).wrap())
}

/// Draws a quantity with its interval. A tooltip shows the derivation of the quantity.
fn quantity(ui: &mut Ui, of: &Quantity, w: &Words) {
    let said = w.of.words();
    let unit = said.word(of.unit);
    let range = match (of.value, of.low, of.high) {
        (Some(value), Some(low), Some(high)) => {
            // The unit may contain words. It is translated here, because `with_interval` does not translate units.
            let (value, interval) = with_interval(value, low, high, "", said);
            said.number(&format!("{value} {unit}  ({interval})"))
        }
        (_, Some(low), Some(high)) => format!("{} – {} {unit}", w.digits(low), w.digits(high)),
        (_, Some(low), None) => format!("{} {} {unit}", w.at_least, w.digits(low)),
        (_, None, Some(high)) => format!("{} {} {unit}", w.at_most, w.digits(high)),
        (_, None, None) => w.no_bound.to_owned(),
    };
    let hint = format!(
        "{}: {} {}\n{} {}",
        of.name,
        w.follows_from,
        of.from.join(", "),
        w.form_error,
        w.digits(of.model_error)
    );
    wrapped(ui, RichText::new(said.word(of.noun()))).on_hover_text(&hint);
    ui.indent(of.name, |ui| {
        wrapped(ui, RichText::new(range).strong()).on_hover_text(&hint);
        if let Some(note) = &of.note {
            wrapped(ui, RichText::new(said.say(note)).small().weak());
        }
    });
}

/// Draws an undetermined quantity with the reason and its missing inputs.
fn gap(ui: &mut Ui, of: &Gap, w: &Words) {
    let said = w.of.words();
    wrapped(ui, RichText::new(said.word(of.noun()))).on_hover_text(of.name);
    let mut lines = vec![said.say(&of.why)];
    if !of.entries.is_empty() {
        lines.push(format!("{} {}", w.drawing_lacks, of.entries.join(", ")));
    }
    if !of.parameters.is_empty() {
        let missing: Vec<&str> = of.parameters.iter().map(|name| said.word(name)).collect();
        lines.push(format!("{} {}", w.model_lacks, missing.join(", ")));
    }
    ui.indent(of.name, |ui| {
        wrapped(ui, RichText::new(lines.join("; ")).small().weak());
    });
}
