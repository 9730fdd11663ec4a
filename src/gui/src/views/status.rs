//! Line at the bottom: progress with a cancel button, or the last message.

use crate::session::Session;
use crate::session::tasks::Kind;
use crate::views::View;
use eframe::egui::{self, Ui};

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
        match &session.message {
            Some(message) if message.wrong => {
                let text =
                    egui::RichText::new(format!("⚠ {}", format.say(&message.text))).color(ui.visuals().error_fg_color);
                ui.add(egui::Label::new(text).wrap());
            }
            Some(message) => {
                ui.label(format.say(&message.text));
            }
            None => {}
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
