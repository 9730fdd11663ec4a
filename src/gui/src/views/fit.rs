//! The button that fits a model: an ordinary damper, or an adjustable damper.

use crate::session::Session;
use crate::session::replacing::Replacement;
use crate::views::setting_name;
use crate::words::Words;
use eframe::egui::{self, Ui};

/// Fits an adjustable damper if the tests have several values of a setting. Otherwise fits an ordinary damper.
pub fn begin(session: &mut Session) {
    let over = session.settings().into_iter().next();
    session.replace(over.map_or(Replacement::Fit, Replacement::FitOver));
}

/// Draws the button that fits a model. If the tests have several values of a setting, the button opens a menu. The menu offers a fit over
/// each such setting, and a fit of an ordinary damper.
pub fn button(ui: &mut Ui, session: &mut Session, can: bool, w: &Words) {
    let settings = session.settings();
    if settings.is_empty() {
        if ui.add_enabled(can, egui::Button::new(w.fit)).on_hover_text(w.fit_hint).clicked() {
            session.replace(Replacement::Fit);
        }
        return;
    }
    ui.add_enabled_ui(can, |ui| {
        ui.menu_button(w.fit, |ui| {
            let said = w.of.words();
            for setting in settings {
                let name = setting_name(&setting, said).to_owned();
                let text = w.fill(w.fit_over, &[("setting", &name)]);
                if ui.button(text).on_hover_text(w.fit_over_hint).clicked() {
                    session.replace(Replacement::FitOver(setting));
                    ui.close();
                }
            }
            if ui.button(w.fit_ordinary).on_hover_text(w.fit_ordinary_hint).clicked() {
                session.replace(Replacement::Fit);
                ui.close();
            }
        });
    });
}
