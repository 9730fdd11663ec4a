//! Confirmation before another model replaces a manually tuned model.

use crate::session::Session;
use crate::views::View;
use crate::views::bar::save;
use eframe::egui::{Id, Modal, Ui};

/// Asks for confirmation if a replacement is pending and tuned values are not saved.
pub fn show(ui: &Ui, session: &mut Session, view: &mut View) {
    if session.pending.is_none() {
        return;
    }
    // If the user has saved or restored the values in the meantime, no value would be lost, so no confirmation is
    // needed.
    if !session.has_unsaved_tuning() {
        session.replace_pending();
        return;
    }
    let w = view.words();
    let asked = Modal::new(Id::unique("replacing")).show(ui.ctx(), |ui| {
        ui.heading(w.replacing);
        ui.label(w.replacing_unsaved);
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            if ui.button(w.stay).clicked() {
                session.pending = None;
            }
            if ui.button(w.save_first).clicked() {
                save(session, view);
            }
            if ui.button(w.replace_anyway).clicked() {
                session.replace_pending();
            }
        });
    });
    if asked.should_close() {
        session.pending = None;
    }
}
