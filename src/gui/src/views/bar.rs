//! Menus, and the buttons that fit, validate and diagnose, at the top, with their keyboard shortcuts.

use crate::dialogs::Ask;
use crate::session::Session;
use crate::session::exports::Host;
use crate::session::papers::Paper;
use crate::units::{Force, Units, Velocity};
use crate::views::{Side, View, fit, named_list};
use crate::words::{self, Language};
use eframe::egui::{self, Key, KeyboardShortcut, Modifiers, Ui};

const OPEN: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::O);
const SAVE: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::S);
const UNDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Z);
const REDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Y);
const REDO_TOO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z);
const FIT: KeyboardShortcut = KeyboardShortcut::new(Modifiers::NONE, Key::F5);
const VALIDATE: KeyboardShortcut = KeyboardShortcut::new(Modifiers::NONE, Key::F6);
const DIAGNOSE: KeyboardShortcut = KeyboardShortcut::new(Modifiers::NONE, Key::F7);

/// Saves the model to its path, or asks for a path.
pub fn save(session: &mut Session, view: &mut View) {
    match session.model.as_ref().map(|m| m.path.clone()) {
        Some(Some(path)) => {
            session.save(&path);
        }
        Some(None) => view.asks.push(Ask::SaveModel),
        None => {}
    }
}

/// Handles the keyboard shortcuts. While a dialog is open, they have no effect, because an undo could change the model to which the dialog
/// refers.
pub fn keys(ui: &Ui, session: &mut Session, view: &mut View) {
    if session.pending.is_some() || view.closing || view.choosing.is_some() {
        return;
    }
    let pressed = |keys: &KeyboardShortcut| ui.ctx().input_mut(|i| i.consume_shortcut(keys));
    if pressed(&OPEN) {
        view.asks.push(Ask::Folder);
    }
    if pressed(&SAVE) {
        save(session, view);
    }
    // Test the longer shortcut first, because it contains the shorter one.
    if pressed(&REDO_TOO) || pressed(&REDO) {
        session.redo();
    }
    if pressed(&UNDO) {
        session.undo();
    }
    let (records, model) = (session.has_records(), session.model.is_some());
    if pressed(&FIT) && records {
        fit::begin(session);
    }
    if pressed(&VALIDATE) && records && model {
        validate(session, view);
    }
    if pressed(&DIAGNOSE) && records && model && !session.diagnosed().is_empty() {
        diagnose(session, view);
    }
}

fn validate(session: &mut Session, view: &mut View) {
    view.side = Side::Result;
    session.validate();
}

fn diagnose(session: &mut Session, view: &mut View) {
    view.side = Side::Result;
    session.diagnose();
}

/// Draws the bar at the top of the window.
pub fn show(ui: &mut Ui, session: &mut Session, view: &mut View) {
    egui::MenuBar::new().ui(ui, |ui| {
        let w = view.words();
        ui.menu_button(w.file, |ui| files(ui, session, view));
        ui.separator();
        let (undo, redo) = session.can_undo();
        let tuned = session.model.as_ref().is_some_and(crate::session::model::Tuned::is_tuned);
        let can = |ui: &mut Ui, on: bool, text: &str, hint: &str| {
            ui.add_enabled(on, egui::Button::new(text)).on_hover_text(hint).clicked()
        };
        if can(ui, undo, w.undo, "Ctrl+Z") {
            session.undo();
        }
        if can(ui, redo, w.redo, "Ctrl+Y") {
            session.redo();
        }
        if can(ui, tuned, w.reset, w.reset_hint) {
            session.tune(crate::session::model::Tuned::reset);
        }
        if can(ui, session.is_unsaved(), w.save, "Ctrl+S") {
            save(session, view);
        }
        ui.separator();
        let free = session.task.is_none();
        let (records, model) = (session.has_records() && free, session.model.is_some());
        fit::button(ui, session, records, w);
        if can(ui, records && model, w.validate, w.validate_hint) {
            validate(session, view);
        }
        let is_elsewhere = model && records && !session.ticked().is_empty() && session.diagnosed().is_empty();
        let diagnose_hint = if is_elsewhere { w.diagnose_elsewhere } else { w.diagnose_hint };
        let diagnose_button = ui.add_enabled(records && model && !is_elsewhere, egui::Button::new(w.diagnose));
        if diagnose_button.on_hover_text(diagnose_hint).on_disabled_hover_text(diagnose_hint).clicked() {
            diagnose(session, view);
        }
        ui.separator();
        ui.add_enabled_ui(model && free, |ui| {
            ui.menu_button(w.export, |ui| {
                let hosts = [
                    (Host::Fmu, w.export_fmu),
                    (Host::Fmu3, w.export_fmu3),
                    (Host::Vehicle, w.export_vehicle),
                    (Host::Adams, w.export_adams),
                    (Host::Property, w.export_property),
                ];
                for (host, text) in hosts {
                    if ui.button(text).clicked() {
                        view.asks.push(Ask::Export(host));
                        ui.close();
                    }
                }
            });
        });
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let dark = ui.visuals().dark_mode;
            if ui.button(if dark { w.light } else { w.dark }).clicked() {
                ui.ctx().set_theme(if dark { egui::Theme::Light } else { egui::Theme::Dark });
            }
            let list = egui::ComboBox::from_id_salt("language")
                .selected_text(words::name(view.language))
                .width(80.0)
                .show_ui(ui, |ui| {
                    for (_, language) in Language::ALL {
                        ui.selectable_value(&mut view.language, language, words::name(language));
                    }
                });
            named_list(list, w.language);
            for velocity in [false, true] {
                let Units { velocity: v, force: f } = &mut view.units;
                let symbol = if velocity {
                    Units { velocity: *v, force: *f }.velocity()
                } else {
                    Units { velocity: *v, force: *f }.force()
                };
                let list = egui::ComboBox::from_id_salt(("units", velocity))
                    .selected_text(symbol.symbol)
                    .width(48.0)
                    .show_ui(ui, |ui| {
                        if velocity {
                            for one in Velocity::ALL {
                                ui.selectable_value(
                                    v,
                                    one,
                                    Units { velocity: one, ..Units::default() }.velocity().symbol,
                                );
                            }
                        } else {
                            for one in Force::ALL {
                                ui.selectable_value(f, one, Units { force: one, ..Units::default() }.force().symbol);
                            }
                        }
                    });
                named_list(list, if velocity { w.unit_of_velocity } else { w.unit_of_force });
            }
        });
    });
}

fn files(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let w = view.words();
    let mut ask = |ui: &mut Ui, on: bool, text: &str, ask: Ask| {
        if ui.add_enabled(on, egui::Button::new(text)).clicked() {
            view.asks.push(ask);
            ui.close();
        }
    };
    let free = session.task.is_none();
    ask(ui, free, w.open_folder, Ask::Folder);
    ask(ui, free, w.open_files, Ask::Files);
    ask(ui, true, w.open_model, Ask::Model);
    ask(ui, true, w.open_dimensions, Ask::Dimensions);
    ask(ui, free && session.has_records(), w.compare_campaign, Ask::Reference);
    if session.reference.is_some() && ui.button(w.compare_no_more).clicked() {
        session.reference = None;
        session.generation += 1;
        ui.close();
    }
    let recent = session.recent.paths.clone();
    ui.add_enabled_ui(free && !recent.is_empty(), |ui| {
        ui.menu_button(w.recent, |ui| {
            for path in recent {
                if ui.button(path.display().to_string()).clicked() {
                    session.open(&[path]);
                    ui.close();
                }
            }
        });
    });
    ui.separator();
    let model = session.model.is_some();
    ask(ui, model, w.save_as, Ask::SaveModel);
    let compared = model && session.has_records() && free;
    ask(ui, compared, w.write_report, Ask::Paper(Paper::ValidationReport));
}
