//! Panel of the tests: properties, errors of the model, notes, and whether fit, validation and diagnosis use a test.

use crate::session::Session;
use crate::units::{Shown, Units};
use crate::views::{View, explain_provisional, hue, percent, test_setting, text_width};
use dashpot_records::{Note, Positive, Record};
use eframe::egui::{self, Role, Ui, WidgetInfo};

/// Returns whether a note reports damage of a test. Frozen channels and gaps are included. The command does not mark them at a test,
/// because it reports them for the whole campaign.
fn is_of_damage(note: &Note) -> bool {
    note.is_of_damage() || ["frozen", "gap"].contains(&note.kind)
}

/// Returns whether a test has notes of damage.
fn is_damaged(record: &Record) -> bool {
    record.notes.iter().any(is_of_damage)
}

/// Draws the list of tests, the details of the last selected test, and the notes of the campaign.
pub fn show(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let w = view.words();
    let Some(loaded) = session.campaign.clone() else {
        welcome(ui, session, view);
        return;
    };
    let records = &loaded.campaign.records;
    ui.horizontal(|ui| {
        ui.heading(w.tests);
        ui.weak(format!("{}", records.len()));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if ui.small_button(w.all).on_hover_text(w.all_hint).clicked() {
                session.selected = (0..records.len()).collect();
            }
        });
    });
    let sign = &loaded.campaign.sign;
    let direction = match sign.positive {
        Positive::Rebound => w.rebound_positive,
        Positive::Compression => w.compression_positive,
    };
    let sure = if sign.is_stated { String::new() } else { format!(" ({} %)", w.fixed(100.0 * sign.confidence, 0)) };
    let format = view.format();
    let reasons: Vec<String> = sign.reasons.iter().map(|reason| format.say(reason)).collect();
    ui.weak(format!("{direction}{sure}")).on_hover_text(reasons.join("\n"));
    let filter = ui.add(egui::TextEdit::singleline(&mut view.filter).hint_text(w.filter).desired_width(f32::INFINITY));
    filter.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, w.filter));
    let wanted = view.filter.to_lowercase();
    let listed: Vec<usize> =
        (0..records.len()).filter(|k| wanted.is_empty() || records[*k].name.to_lowercase().contains(&wanted)).collect();
    let details = session.selected.iter().next_back().copied();
    let room = (ui.available_height() - if details.is_some() { 250.0 } else { 0.0 }).max(120.0);
    let height = ui.spacing().interact_size.y;
    egui::ScrollArea::vertical()
        .id_salt("tests")
        .max_height(room)
        .min_scrolled_height(room)
        .auto_shrink([false, false])
        .show_rows(ui, height, listed.len(), |ui, range| {
            for k in &listed[range] {
                row(ui, session, view, &records[*k], *k, &listed);
            }
        });
    ui.separator();
    test_setting::apply_pending(session, view, details);
    egui::ScrollArea::vertical().id_salt("details").auto_shrink([false, false]).show(ui, |ui| {
        if let Some(k) = details.filter(|k| *k < records.len()) {
            detail(ui, session, view, k);
        }
        let others = session.reference.clone();
        let of_others = others.iter().flat_map(|o| &o.campaign.notes).filter(|n| n.kind == "left_out");
        for note in loaded.campaign.notes.iter().chain(of_others) {
            ui.add(egui::Label::new(egui::RichText::new(format!("• {}", format.say(&note.text))).weak()).wrap());
        }
    });
}

fn row(ui: &mut Ui, session: &mut Session, view: &mut View, record: &Record, k: usize, listed: &[usize]) {
    let w = view.words();
    ui.horizontal(|ui| {
        let mut ticked = !session.unticked.contains(&k);
        let tick = ui.checkbox(&mut ticked, "").on_hover_text(w.tick_hint);
        tick.widget_info(|| {
            WidgetInfo::selected(Role::CheckBox, true, ticked, format!("{} {}", w.use_test, record.name))
        });
        if tick.changed() {
            if ticked {
                session.unticked.remove(&k);
            } else {
                session.unticked.insert(k);
            }
        }
        let place = session.selected.iter().position(|s| *s == k);
        let error = session.simulated.as_ref().and_then(|s| s.tests.get(k)).map(|t| t.percent);
        let is_provisional = session.are_errors_provisional();
        let figures = match error {
            Some(error) => percent(error, is_provisional, w),
            None => format!("{}\u{a0}Hz", w.digits(record.frequency)),
        };
        let warning = if is_damaged(record) { "⚠ " } else { "" };
        let text = format!("{warning}{}", record.name);
        let width = (ui.available_width() - 34.0 - 7.5 * figures.chars().count() as f32).max(60.0);
        let label = egui::Button::selectable(place.is_some(), text).truncate().min_size(egui::vec2(width, 0.0));
        let response = ui.scope(|ui| {
            ui.set_max_width(width);
            ui.add(label)
        });
        let response = response.inner.on_hover_text(describe(record, view.units, w));
        if let Some(place) = place {
            let rect = response.rect;
            let mark = egui::Rect::from_min_max(rect.left_top(), egui::pos2(rect.left() + 3.0, rect.bottom()));
            ui.painter().rect_filled(mark, 1.0, hue(place));
        }
        if response.clicked() {
            let keys = ui.input(|i| i.modifiers);
            choose(session, view, k, keys, listed);
        }
        explain_provisional(ui.weak(figures), is_provisional && error.is_some(), w);
    });
}

/// Selects tests as in common lists. A click selects one test, Ctrl adds or removes a test, and Shift adds a range.
pub fn choose(session: &mut Session, view: &mut View, k: usize, keys: egui::Modifiers, listed: &[usize]) {
    let place = |k: usize| listed.iter().position(|l| *l == k);
    match (keys.shift, view.anchor.and_then(place), place(k)) {
        (true, Some(from), Some(to)) => session.selected.extend(&listed[from.min(to)..=from.max(to)]),
        _ if keys.command => {
            if !session.selected.remove(&k) {
                session.selected.insert(k);
            }
            view.anchor = Some(k);
        }
        _ => {
            session.selected = [k].into();
            view.anchor = Some(k);
        }
    }
}

fn describe(record: &Record, units: Units, w: &crate::words::Words) -> String {
    let (length, velocity) = (units.length(), units.velocity());
    let setting = match test_setting::text(record, w) {
        text if text.is_empty() => text,
        text => format!("\n{} {text}", test_setting::name(record, w)),
    };
    format!(
        "{} {} {}\n{} {} Hz\n{} {} {}{setting}",
        w.amplitude,
        w.digits(length.factor * record.amplitude),
        length.symbol,
        w.frequency,
        w.digits(record.frequency),
        w.peak_velocity,
        w.digits(velocity.factor * record.peak_velocity),
        velocity.symbol
    )
}

fn detail(ui: &mut Ui, session: &mut Session, view: &mut View, k: usize) {
    let w = view.words();
    let Some(loaded) = session.campaign.clone() else { return };
    let (record, seen) = (&loaded.campaign.records[k], &loaded.tests[k]);
    ui.strong(&record.name);
    ui.add(egui::Label::new(egui::RichText::new(&record.source).weak()).wrap());
    let n = seen.cycle_samples;
    let area = crate::session::study::loop_area(&seen.cycle.displacement[..n], &seen.cycle.force[..n]);
    let (units, force) = (view.units, view.units.force());
    let in_unit = |unit: &Shown, value: f64| format!("{}\u{a0}{}", w.digits(unit.factor * value), unit.symbol);
    let setting = test_setting::name(record, w);
    let names =
        [setting, w.mean_error, w.amplitude, w.frequency, w.peak_velocity, w.largest_force, w.cycles, w.work, w.noise];
    let widest = names.into_iter().map(|name| text_width(ui, name, egui::TextStyle::Body)).fold(0.0, f32::max);
    let room = (ui.available_width() - widest - ui.spacing().item_spacing.x).max(60.0);
    egui::Grid::new("detail").num_columns(2).show(ui, |ui| {
        ui.label(setting);
        test_setting::show(ui, session, view, k, room);
        ui.end_row();
        let simulated = session.simulated.as_ref().and_then(|s| s.tests.get(k));
        let mut line = |name: &str, value: String| {
            ui.label(name);
            // A long value is wrapped, because the panel would cut it off.
            ui.scope(|ui| {
                ui.set_max_width(room);
                ui.add(egui::Label::new(value).wrap());
            });
            ui.end_row();
        };
        if let Some(of) = simulated {
            let mark = if session.are_errors_provisional() { "≈\u{a0}" } else { "" };
            line(w.mean_error, format!("{mark}{}, {}", in_unit(&force, of.mean_error), percent(of.percent, false, w)));
        }
        line(w.amplitude, in_unit(&units.length(), record.amplitude));
        line(w.frequency, format!("{}\u{a0}Hz", w.digits(record.frequency)));
        line(w.peak_velocity, in_unit(&units.velocity(), record.peak_velocity));
        line(w.largest_force, in_unit(&force, seen.max_force));
        if !record.cycles.is_empty() {
            line(w.cycles, record.cycles.len().to_string());
            line(w.work, in_unit(&units.energy(), area));
        }
        line(w.noise, in_unit(&force, record.noise.force_rms));
    });
    let format = view.format();
    for note in &record.notes {
        let text = egui::RichText::new(format!("• {}", format.say(&note.text)));
        let text = if is_of_damage(note) { text.color(ui.visuals().warn_fg_color) } else { text.weak() };
        ui.add(egui::Label::new(text).wrap());
    }
    if ui.add_enabled(session.task.is_none(), egui::Button::new(w.exclude)).on_hover_text(w.exclude_hint).clicked() {
        session.exclude(k);
    }
    ui.separator();
}

fn welcome(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let w = view.words();
    ui.heading(w.welcome);
    ui.label(w.welcome_hint);
    ui.add_space(8.0);
    let free = session.task.is_none();
    if ui.add_enabled(free, egui::Button::new(w.open_folder)).clicked() {
        view.asks.push(crate::dialogs::Ask::Folder);
    }
    if ui.button(w.open_model).clicked() {
        view.asks.push(crate::dialogs::Ask::Model);
    }
    let recent = session.recent.paths.clone();
    if !recent.is_empty() {
        ui.add_space(8.0);
        ui.label(w.recent);
    }
    for path in recent {
        if ui.add_enabled(free, egui::Button::new(path.display().to_string()).truncate()).clicked() {
            session.open(&[path]);
        }
    }
}
