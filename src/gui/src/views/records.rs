//! Panel of the options of reading, which the user corrects and stores with the records.

use crate::session::Session;
use crate::units::read;
use crate::views::{View, named_list};
use crate::words::Words;
use dashpot_records::{Channel, DateOrder, Positive, Unit};
use eframe::egui::{self, ComboBox, Role, Ui, WidgetInfo};
use std::collections::BTreeMap;

/// Draws the panel.
pub fn show(ui: &mut Ui, session: &mut Session, view: &View) {
    let (w, format) = (view.words(), view.format());
    if !session.has_records() {
        ui.label(w.welcome_hint);
        return;
    }
    ui.heading(w.how_read);
    ui.add(egui::Label::new(egui::RichText::new(w.how_read_hint).weak()).wrap());
    let reading = &mut session.reading;
    // The limit of the column width keeps both columns within the panel, even if a word is long.
    let column = 0.5 * (ui.available_width() - 8.0);
    egui::Grid::new("reading").num_columns(2).spacing([8.0, 6.0]).max_col_width(column).show(ui, |ui| {
        let direction = |p: Option<Positive>| match p {
            None => w.from_data,
            Some(Positive::Rebound) => w.rebound,
            Some(Positive::Compression) => w.compression,
        };
        let directions = [None, Some(Positive::Rebound), Some(Positive::Compression)];
        choice(ui, w.positive, &mut reading.positive, &directions, direction);
        let order = |o: Option<DateOrder>| match o {
            None => w.from_data,
            Some(DateOrder::DayFirst) => w.day_first,
            Some(DateOrder::MonthFirst) => w.month_first,
        };
        let orders = [None, Some(DateOrder::DayFirst), Some(DateOrder::MonthFirst)];
        choice(ui, w.dates, &mut reading.dates, &orders, order);
        choose_units(ui, &mut reading.units, w);
        let mut field = |name: &str, value: &mut f64, factor: f64, unit: &str, speed: f64| {
            ui.add(egui::Label::new(name).wrap());
            ui.horizontal(|ui| {
                let mut shown = *value * factor;
                let field = ui.add(
                    egui::DragValue::new(&mut shown)
                        .speed(speed)
                        .custom_formatter(|v, _| w.typed(v))
                        .custom_parser(read),
                );
                field.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
                if field.changed() {
                    *value = shown / factor;
                }
                ui.label(unit);
            });
            ui.end_row();
        };
        field(w.delay, &mut reading.delay_s, 1e3, "ms", 0.05);
        // The steps of the fields are 0.5 N and 0.05 mm in every unit.
        let (force, length) = (view.units.force(), view.units.length());
        field(w.force_zero, &mut reading.force_zero_n, force.factor, &force.symbol, 0.5 * force.factor);
        let zero = &mut reading.displacement_zero_m;
        field(w.displacement_zero, zero, length.factor, &length.symbol, 5e-5 * length.factor);
        field(w.gain, &mut reading.gain, 1.0, "", 0.001);
        field(w.rig_mass, &mut reading.rig_mass_kg, 1.0, "kg", 0.01);
        // The field shows a rate of zero if no rate is set, because files with a time column need none.
        let mut rate = reading.sample_rate_hz.unwrap_or(0.0);
        field(w.sample_rate, &mut rate, 1.0, "Hz", 1.0);
        reading.sample_rate_hz = (rate != 0.0).then_some(rate);
    });
    ui.checkbox(&mut reading.flip_force, w.flip_force);
    ui.checkbox(&mut reading.flip_motion, w.flip_motion);
    ui.checkbox(&mut reading.subfolders, w.subfolders);
    show_excluded(ui, &mut reading.exclude, w);
    let wrong = reading.check().err();
    if let Some(wrong) = &wrong {
        ui.colored_label(ui.visuals().error_fg_color, wrong);
    }
    ui.horizontal_wrapped(|ui| {
        let can = session.task.is_none() && wrong.is_none();
        if ui.add_enabled(can, egui::Button::new(w.read_again)).on_hover_text(w.read_again_hint).clicked() {
            session.read_again();
        }
        if ui.add_enabled(can, egui::Button::new(w.keep_reading)).on_hover_text(w.keep_reading_hint).clicked() {
            session.keep_reading();
        }
    });
    ui.separator();
    let notes = session.campaign.as_ref().map_or_else(Vec::new, |c| c.campaign.notes.clone());
    let reasons = session.campaign.as_ref().map_or_else(Vec::new, |c| c.campaign.sign.reasons.clone());
    egui::ScrollArea::vertical().id_salt("notes").auto_shrink([false, false]).show(ui, |ui| {
        for text in reasons.iter().chain(notes.iter().map(|n| &n.text)) {
            ui.add(egui::Label::new(egui::RichText::new(format!("• {}", format.say(text))).weak()).wrap());
        }
    });
}

/// Draws the rows of the form in which the user chooses the unit of each channel.
fn choose_units(ui: &mut Ui, units: &mut BTreeMap<Channel, Unit>, w: &'static Words) {
    for channel in [Channel::Time, Channel::Displacement, Channel::Velocity, Channel::Force] {
        let now = units.get(&channel).copied();
        let mut chosen = now;
        let name = |u: Option<Unit>| u.map_or(w.as_file_says, Unit::name);
        let all = Unit::ALL.iter().filter(|u| u.dimension() == channel.dimension()).map(|u| Some(*u));
        let all: Vec<Option<Unit>> = std::iter::once(None).chain(all).collect();
        choice(ui, &format!("{} {}", w.unit_of, w.channel(channel)), &mut chosen, &all, name);
        if chosen != now {
            match chosen {
                Some(unit) => units.insert(channel, unit),
                None => units.remove(&channel),
            };
        }
    }
}

/// Draws the list of the excluded tests, each with a button that includes it again.
fn show_excluded(ui: &mut Ui, exclude: &mut Vec<String>, w: &Words) {
    if !exclude.is_empty() {
        ui.label(w.excluded);
    }
    let mut back = None;
    for (k, name) in exclude.iter().enumerate() {
        ui.horizontal(|ui| {
            ui.label(name);
            if ui.small_button("✖").on_hover_text(w.take_back).clicked() {
                back = Some(k);
            }
        });
    }
    if let Some(k) = back {
        exclude.remove(k);
    }
}

/// Draws a row of the form: a label, and a drop-down list with the names of all values.
fn choice<T: Copy + PartialEq>(ui: &mut Ui, label: &str, value: &mut T, all: &[T], name: impl Fn(T) -> &'static str) {
    ui.add(egui::Label::new(label).wrap());
    let width = ui.available_width().clamp(60.0, 150.0);
    let list = ComboBox::from_id_salt(label).width(width).truncate().selected_text(name(*value)).show_ui(ui, |ui| {
        for one in all {
            ui.selectable_value(value, *one, name(*one));
        }
    });
    named_list(list, label);
    ui.end_row();
}
