//! Field for the setting of a test, which the user can correct.

use crate::session::Session;
use crate::views::{View, setting_name, text_width};
use crate::words::Words;
use dashpot_records::Record;
use eframe::egui::{self, Key, Role, TextEdit, Ui, WidgetInfo};

/// Returns the name of a test's setting in the language of the window.
pub fn name<'a>(record: &'a Record, w: &'a Words) -> &'a str {
    let constant = record.setting.as_ref().map(|of| of.name.as_str());
    let name = constant.or_else(|| record.setting_signal.as_ref().map(|of| of.name.as_str()));
    name.map_or(w.setting, |name| setting_name(name, w.of.words()))
}

/// Formats the setting of a test with its unit: a value, or the range of a changing setting. A test without a setting gives an empty text.
pub fn text(record: &Record, w: &Words) -> String {
    let with_unit = |text: String, unit: &str| format!("{text} {unit}").trim_end().to_owned();
    match (&record.setting, &record.setting_signal) {
        (Some(of), _) => with_unit(w.typed(of.value), &of.unit),
        (None, Some(of)) => with_unit(format!("{} … {}", w.typed(of.range[0]), w.typed(of.range[1])), &of.unit),
        (None, None) => String::new(),
    }
}

/// Draws the field for the setting of a test within a width of `room`, px. Enter or a click elsewhere applies the text, and Escape discards
/// it.
pub fn show(ui: &mut Ui, session: &mut Session, view: &mut View, k: usize, room: f32) {
    let w = view.words();
    let Some(record) = session.record(k) else { return };
    let (label, own) = (name(record, w), text(record, w));
    let is_corrected = session.is_setting_corrected(k);
    let is_free = session.task.is_none();
    let typing = view.typed_setting.take();
    let mut typed = typing.as_ref().filter(|(of, _)| *of == k).map_or_else(|| own.clone(), |(_, text)| text.clone());
    let mut is_removed = false;
    let field = ui.horizontal(|ui| {
        /// Width of both margins of a field, px.
        const MARGINS: f32 = 8.0;
        let button = text_width(ui, "⟲", egui::TextStyle::Body)
            + 2.0 * ui.spacing().button_padding.x
            + ui.spacing().item_spacing.x;
        let width = room - MARGINS - if is_corrected { button } else { 0.0 };
        let edit = TextEdit::singleline(&mut typed).id_salt("test setting").hint_text(w.none).desired_width(width);
        let field = ui.add_enabled(is_free, edit).on_hover_text(w.test_setting_hint);
        field.widget_info(|| WidgetInfo::labeled(Role::TextInput, is_free, label));
        if is_corrected {
            let button = ui.add_enabled(is_free, egui::Button::new("⟲").small()).on_hover_text(w.setting_as_read);
            button.widget_info(|| WidgetInfo::labeled(Role::Button, is_free, w.setting_as_read));
            is_removed = button.clicked();
        }
        field
    });
    let is_done = field.inner.lost_focus();
    if is_removed {
        session.remove_correction(k);
    } else if is_done && !ui.input(|i| i.key_pressed(Key::Escape)) {
        apply(session, k, &typed, w);
    } else if !is_done && typed != own {
        view.typed_setting = Some((k, typed));
    }
}

/// Applies a text that the user typed for another test than the shown one `k`. A click on a test in the list removes the field before the
/// field reports the loss of the focus.
pub fn apply_pending(session: &mut Session, view: &mut View, k: Option<usize>) {
    let Some((of, typed)) = view.typed_setting.take_if(|(of, _)| Some(*of) != k) else { return };
    apply(session, of, &typed, view.words());
}

/// Corrects the setting of a test, unless the text is that of its present setting.
fn apply(session: &mut Session, k: usize, typed: &str, w: &Words) {
    let is_new = session.record(k).is_some_and(|record| text(record, w) != typed.trim());
    if is_new {
        session.correct_setting(k, typed);
    }
}
