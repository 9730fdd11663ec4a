//! Line at the bottom: progress with a cancel button, or the last message.

use crate::session::Session;
use crate::session::tasks::Kind;
use crate::views::View;
use eframe::egui::{self, TextStyle, Ui};

/// Height of the line with a message of one row, px.
const LINE: f32 = 30.0;
/// Width beside a message, px: the margins, and the duration of the simulation at the right.
const BESIDE: f32 = 180.0;

/// Formats the message about an error, or returns `None` if the line shows something else.
fn complaint(session: &Session, view: &View) -> Option<String> {
    let message = session.message.as_ref().filter(|message| message.wrong && session.task.is_none())?;
    Some(format!("⚠ {}", view.format().say(&message.text)))
}

/// Returns the height of the line, px. It grows with the rows of a message about an error, so that the message is visible as a whole.
pub fn height(ui: &Ui, session: &Session, view: &View) -> f32 {
    let Some(text) = complaint(session, view) else { return LINE };
    let font = TextStyle::Body.resolve(ui.style());
    let width = (ui.available_width() - BESIDE).max(BESIDE);
    let text = ui.painter().layout(text, font, ui.visuals().error_fg_color, width);
    (LINE + text.size().y - ui.text_style_height(&TextStyle::Body)).max(LINE)
}

/// Draws the line at the bottom.
pub fn show(ui: &mut Ui, session: &mut Session, view: &View) {
    let (w, format) = (view.words(), view.format());
    ui.horizontal(|ui| {
        if let Some(task) = &session.task {
            let doing = match task.kind {
                Kind::Read | Kind::ReadReference => w.reading,
                Kind::Fit => w.fitting,
                Kind::Validate => w.validating,
                Kind::Diagnose => w.diagnosing,
                Kind::Study | Kind::Respond => w.studying,
                Kind::Write => w.writing,
            };
            let progress = task.progress();
            let cancelled = task.is_cancelled();
            let seconds = task.began.elapsed().as_secs();
            ui.label(if cancelled { w.stopping } else { doing });
            let bar = egui::ProgressBar::new(progress.done as f32).desired_width(220.0).show_percentage();
            ui.add(bar);
            // The button stands before the text, because the width of the text changes. Behind the text, the button would move away from
            // the pointer.
            if ui.add_enabled(!cancelled, egui::Button::new(w.cancel)).clicked() {
                session.cancel();
            }
            let now = progress.text.map_or_else(String::new, |text| format.say(&text.into()));
            ui.label(format!("{now} · {seconds} s"));
            return;
        }
        match (complaint(session, view), &session.message) {
            (Some(text), _) => {
                ui.scope(|ui| {
                    ui.set_max_width((ui.available_width() - BESIDE).max(BESIDE));
                    let text = egui::RichText::new(text).color(ui.visuals().error_fg_color);
                    ui.add(egui::Label::new(text).wrap());
                });
            }
            (None, Some(message)) => {
                ui.label(format.say(&message.text));
            }
            (None, None) => {}
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if let Some(simulated) = &session.simulated {
                ui.weak(format!(
                    "{} {} {:.0} ms",
                    simulated.tests.len(),
                    w.tests_in,
                    1e3 * simulated.took.as_secs_f64()
                ))
                .on_hover_text(w.computed_in);
            }
        });
    });
}
