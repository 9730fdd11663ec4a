//! Panel with a switch for every element and a slider for every parameter. Marks show prior, 95 % interval and
//! identified value.

use crate::format::Format;
use crate::session::Session;
use crate::session::model::{Reach, Tuned, prior_band};
use crate::units::{Units, read};
use crate::views::{View, explain_provisional, fit, named_list, percent, setting_name, translate_name};
use crate::words::Words;
use dashpot_core::list;
use dashpot_core::parameter::{self, Element, Row, Shape};
use dashpot_estimation::scale::Scale;
use dashpot_report::parameters::assumed;
use eframe::egui::collapsing_header::CollapsingState;
use eframe::egui::text::LayoutJob;
use eframe::egui::{
    self, Align, Color32, FontSelection, Id, Rect, RichText, Role, Slider, SliderClamping, Ui, WidgetInfo, pos2,
};

/// Draws the panel.
pub fn show(ui: &mut Ui, session: &mut Session, view: &View) {
    let w = view.words();
    let Some(model) = &session.model else {
        ui.label(w.no_model);
        let can = session.has_records() && session.task.is_none();
        fit::button(ui, session, can, w);
        return;
    };
    let name = Some(model.name()).filter(|n| !n.is_empty()).unwrap_or_else(|| w.unsaved_model.to_owned());
    ui.horizontal(|ui| {
        ui.heading(name);
        if model.is_unsaved() {
            ui.label("●").on_hover_text(w.not_saved);
        }
    });
    errors(ui, session, w);
    if let Some(refused) = session.model.as_ref().and_then(|m| m.rejected.clone()) {
        ui.colored_label(ui.visuals().error_fg_color, format!("{}: {refused}", w.rejected));
    }
    // The notes name parameters of disabled elements in the file, because they take effect once the element is enabled.
    for note in session.model.as_ref().map(Tuned::remarks).unwrap_or_default() {
        ui.add(egui::Label::new(egui::RichText::new(view.format().say(&note)).weak()).wrap());
    }
    setting(ui, session, w);
    let is_of_a_fit = session.model.as_ref().is_some_and(Tuned::is_of_a_fit);
    legend(ui, is_of_a_fit, w);
    ui.separator();
    let rows: Vec<Row> = parameter::table().filter(|r| r.element().is_some()).collect();
    egui::ScrollArea::vertical().id_salt("tune").auto_shrink([false, false]).show(ui, |ui| {
        let (on, off): (Vec<Element>, Vec<Element>) =
            Element::all().partition(|element| session.model.as_ref().is_some_and(|m| m.params().is_on(*element)));
        // Enabled elements come first. Elements that could be added follow.
        for one in on {
            element(ui, session, view, one, true, &rows);
        }
        if !off.is_empty() {
            ui.add_space(6.0);
            ui.weak(w.elements_off);
        }
        for one in off {
            element(ui, session, view, one, false, &rows);
        }
    });
}

/// Draws a slider over the setting of an adjustable damper, and the choice of own settings for the tests.
fn setting(ui: &mut Ui, session: &mut Session, w: &Words) {
    let Some(model) = &session.model else { return };
    let Some((axis, at)) = model.over_setting() else { return };
    let (low, high) = axis.range();
    let name = if axis.name().is_empty() { w.setting } else { setting_name(axis.name(), w.of.words()) };
    let name = format!("{name} {}", axis.unit()).trim_end().to_owned();
    let mut moved = at;
    let slider = Slider::new(&mut moved, low..=high)
        .clamping(SliderClamping::Always)
        .custom_formatter(|v, _| w.typed(v))
        .custom_parser(read)
        .text(&name);
    let is_tuned = model.is_tuned();
    let slider = ui.add_enabled(!is_tuned, slider);
    slider.widget_info(|| WidgetInfo::slider(!is_tuned, moved, &name));
    slider.on_hover_text(w.setting_hint).on_disabled_hover_text(w.setting_tuned);
    if moved != at {
        session.move_to(moved);
    }
    if session.has_own_settings() {
        let mut own = session.own_settings;
        ui.checkbox(&mut own, w.own_settings).on_hover_text(w.own_settings_hint);
        session.use_own_settings(own);
    }
}

/// Shows the mean error of the current model and of the model before tuning.
fn errors(ui: &mut Ui, session: &Session, w: &Words) {
    let mean = |s: &crate::session::simulation::Simulated| {
        s.tests.iter().map(|t| t.percent).sum::<f64>() / s.tests.len().max(1) as f64
    };
    if let Some(now) = &session.simulated {
        let name = before_tuning(session.model.as_ref().is_some_and(Tuned::is_of_a_fit), w);
        let before = session.identified.as_ref().map(|i| format!(" ({name} {})", percent(mean(i), false, w)));
        let is_provisional = session.are_errors_provisional();
        let error = percent(mean(now), is_provisional, w);
        let error = ui.label(format!("{} {error}{}", w.mean_error, before.unwrap_or_default()));
        explain_provisional(error, is_provisional, w);
    }
}

const USUAL: Color32 = Color32::from_rgb(150, 150, 150);
const INTERVAL: Color32 = Color32::from_rgb(0, 114, 178);
/// Color of the mark of an identified value.
pub const IDENTIFIED: Color32 = Color32::from_rgb(213, 94, 0);

/// Returns the name of the values before they were tuned. Only a fit identifies values.
fn before_tuning(is_of_a_fit: bool, w: &Words) -> &'static str {
    if is_of_a_fit { w.identified } else { w.as_opened }
}

fn legend(ui: &mut Ui, is_of_a_fit: bool, w: &Words) {
    let before = before_tuning(is_of_a_fit, w);
    ui.horizontal_wrapped(|ui| {
        for (colour, text) in [(USUAL, w.prior), (INTERVAL, w.interval), (IDENTIFIED, before)] {
            // A label with non-breaking spaces keeps a mark and its text on one line.
            let mut entry = LayoutJob::default();
            let style = ui.style().clone();
            RichText::new("▬\u{a0}").color(colour).append_to(&mut entry, &style, FontSelection::Default, Align::Center);
            let text = RichText::new(text.replace(' ', "\u{a0}")).small();
            text.append_to(&mut entry, &style, FontSelection::Default, Align::Center);
            ui.label(entry);
        }
    });
}

fn element(ui: &mut Ui, session: &mut Session, view: &View, element: Element, on: bool, rows: &[Row]) {
    let (w, units) = (view.words(), view.units);
    let group = element.group();
    let id = Id::unique(("element", element.place()));
    let mut switched = on;
    CollapsingState::load_with_default_open(ui.ctx(), id, on)
        .show_header(ui, |ui| {
            let label = translate_name(group.name, w.of.words());
            ui.checkbox(&mut switched, if on { RichText::new(label).strong() } else { RichText::new(label) })
                .on_hover_text(format!("{}\n{}", group.name, w.of.words().meaning_of_element(group.name)));
        })
        .body(|ui| {
            ui.add(egui::Label::new(RichText::new(w.of.words().meaning_of_element(group.name)).small().weak()).wrap());
            ui.add_enabled_ui(on, |ui| {
                let of_form = |session: &Session, row: &Row| {
                    session.model.as_ref().is_none_or(|model| model.params().is_of_form(row))
                };
                for row in rows.iter().filter(|row| row.element() == Some(element)) {
                    if !of_form(session, row) {
                        continue;
                    }
                    match row.parameter.shape {
                        Shape::Scalar => number(ui, session, w, units, row, 0),
                        Shape::Choice(words) => choice(ui, session, w, row, words),
                        Shape::List(_) => list(ui, session, w, units, row),
                    }
                }
            });
        });
    if switched != on {
        session.tune(|m| m.switch(element, switched));
    }
}

/// Width of a slider, px. It exceeds 100 px, so that one pixel changes the value by less than one percent of the slider's range.
const WIDTH: f32 = 140.0;

/// Draws one parameter: its name, a slider with marks, and a field.
fn number(ui: &mut Ui, session: &mut Session, w: &Words, units: Units, row: &Row, entry: usize) {
    let Some(model) = &session.model else { return };
    let p = row.parameter;
    let (Some(now), Some(identified)) = (
        model.params().get(row).get(entry).copied(),
        model.identified.get(row).get(entry).or(p.default.first()).copied(),
    ) else {
        return;
    };
    let interval = model.interval(p.name, entry);
    let scale = Scale::from_params(&model.identified);
    let reach = Reach::new(row, scale, identified, now, interval);
    let (unit, format) = (units.shown(p.unit), Format { language: w.of, units });
    let (identifier, name) = match p.shape {
        Shape::List(_) => {
            (format!("{}[{entry}]", p.name), format!("{} {}", translate_name(p.name, w.of.words()), entry + 1))
        }
        _ => (p.name.to_owned(), translate_name(p.name, w.of.words())),
    };
    let loose = model.is_loose(p.name, matches!(p.shape, Shape::List(_)).then_some(entry));
    let title = if loose {
        RichText::new(format!("{name} ({})", w.not_identified)).small().weak()
    } else {
        RichText::new(&name).small()
    };
    let mut hint = format!("{identifier}\n{}", w.of.words().meaning_of_parameter(p.name));
    if loose {
        hint += &format!("\n{}", format.restate(&assumed(p.name, identified, &model.identified, None, w.of.words())));
    }
    ui.add(egui::Label::new(title).wrap()).on_hover_text(hint);
    // A parameter that the fit did not identify gets no mark of an identified value.
    let mark = model.identified_value(row, entry);
    ui.horizontal(|ui| {
        ui.spacing_mut().slider_width = WIDTH;
        let mut value = now;
        let slider = Slider::from_get_set(reach.low..=reach.high, |set| {
            if let Some(set) = set {
                value = set;
            }
            value
        });
        let slider = slider.logarithmic(reach.factors).smallest_positive(reach.low.max(1e-300)).show_value(false);
        let slider = ui.add(slider.clamping(SliderClamping::Never));
        slider.widget_info(|| WidgetInfo::slider(true, unit.factor * value, format!("{name} {}", unit.symbol)));
        marks(ui, slider.rect, &reach, prior_band(row, scale), interval.filter(|_| !loose), mark);
        let mut in_unit = unit.factor * value;
        let speed = (in_unit.abs() * 0.005).max(1e-9);
        let field =
            egui::DragValue::new(&mut in_unit).speed(speed).custom_formatter(|v, _| w.typed(v)).custom_parser(read);
        let field = ui.add(field.update_while_editing(false));
        field.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, format!("{name} {}", unit.symbol)));
        if field.changed() {
            value = in_unit / unit.factor;
        }
        ui.label(RichText::new(&unit.symbol).small());
        if now != identified && ui.small_button("⟲").on_hover_text(w.back_to_identified).clicked() {
            value = identified;
        }
        let ended = |r: &egui::Response| r.drag_stopped() || r.lost_focus();
        if value != now {
            session.tune(|m| m.set(row, entry, value));
        }
        if (ended(&slider) || ended(&field))
            && let Some(model) = &mut session.model
        {
            model.seal();
        }
    });
}

/// Draws the marks under a slider: prior, 95 % interval, identified value.
fn marks(
    ui: &Ui,
    rect: Rect,
    reach: &Reach,
    usual: Option<[f64; 2]>,
    interval: Option<[f64; 2]>,
    identified: Option<f64>,
) {
    // The handle of the slider stops at this distance from the ends of the slider.
    let inside = rect.shrink2(egui::vec2(rect.height() / 2.5, 0.0));
    let x = |value: f64| inside.left() + inside.width() * reach.place(value) as f32;
    let painter = ui.painter();
    let band = |[low, high]: [f64; 2], top: f32, bottom: f32, colour: Color32| {
        let (from, to) = (x(low), x(high).max(x(low) + 1.5));
        let rect = Rect::from_min_max(pos2(from, rect.bottom() - top), pos2(to, rect.bottom() - bottom));
        painter.rect_filled(rect, 0.0, colour);
    };
    if let Some(usual) = usual {
        band(usual, 3.0, 1.0, USUAL);
    }
    if let Some(interval) = interval {
        band(interval, 4.0, 0.0, INTERVAL);
    }
    if let Some(identified) = identified {
        band([identified, identified], 6.0, 0.0, IDENTIFIED);
    }
}

fn choice(ui: &mut Ui, session: &mut Session, w: &Words, row: &Row, words: &[&str]) {
    let Some(model) = &session.model else { return };
    let now = model.params().get(row).first().copied().unwrap_or(0.0) as usize;
    let mut chosen = now;
    ui.horizontal(|ui| {
        let name = translate_name(row.parameter.name, w.of.words());
        let hint = format!("{}\n{}", row.parameter.name, w.of.words().meaning_of_parameter(row.parameter.name));
        ui.label(RichText::new(&name).small()).on_hover_text(hint);
        let shown = words.get(now).copied().unwrap_or("");
        let list = egui::ComboBox::from_id_salt(row.parameter.name).selected_text(w.of.words().choice(shown)).show_ui(
            ui,
            |ui| {
                for (k, word) in words.iter().enumerate() {
                    ui.selectable_value(&mut chosen, k, w.of.words().choice(word));
                }
            },
        );
        named_list(list, &name);
    });
    if chosen != now {
        session.tune(|m| {
            let changed = m.set(row, 0, chosen as f64);
            m.seal();
            changed
        });
    }
}

/// Draws the points of a curve: a slider for every entry of the list that is free. The user can also drag the points of
/// the FV curve in the plot.
fn list(ui: &mut Ui, session: &mut Session, w: &Words, units: Units, row: &Row) {
    let p = row.parameter;
    let count = session.model.as_ref().map_or(0, |m| m.params().get(row).len());
    if count == 0 {
        return;
    }
    // For a list of positions, a hint states that the user can drag the points in the plot.
    let places = [list!("fv_velocity"), list!("spring_displacement")].iter().any(|places| places.row() == row);
    egui::CollapsingHeader::new(RichText::new(format!("{} ({count})", translate_name(p.name, w.of.words()))).small())
        .id_salt(p.name)
        .default_open(false)
        .show(ui, |ui| {
            if places {
                ui.weak(w.drag_points);
            }
            for entry in 0..count {
                if is_free(session.model.as_ref(), row, entry) {
                    number(ui, session, w, units, row, entry);
                }
            }
        });
}

/// Returns whether an entry of a curve may change. The point of the FV curve at zero velocity has no force and is
/// fixed.
fn is_free(model: Option<&Tuned>, row: &Row, entry: usize) -> bool {
    let Some(model) = model else { return false };
    let velocity = list!("fv_velocity");
    if row != velocity.row() && row != list!("fv_force").row() {
        return true;
    }
    model.params().list(velocity).get(entry).is_some_and(|v| *v != 0.0)
}
