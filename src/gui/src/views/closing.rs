//! Confirmation before closing the window would lose data.

use crate::session::Session;
use crate::views::View;
use crate::views::bar::save;
use eframe::egui::{Id, Modal, Ui, ViewportCommand};

/// Handles a request to close, and asks for confirmation if data would be lost.
pub fn show(ui: &Ui, session: &mut Session, view: &mut View) {
    let ctx = ui.ctx().clone();
    if ctx.input(|i| i.viewport().close_requested()) && !view.may_close {
        if session.would_lose() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            view.closing = true;
        } else {
            view.may_close = true;
        }
    }
    if !view.closing {
        return;
    }
    let w = view.words();
    let close = |view: &mut View, session: &Session| {
        session.cancel();
        view.closing = false;
        view.may_close = true;
        ctx.send_viewport_cmd(ViewportCommand::Close);
    };
    let asked = Modal::new(Id::unique("closing")).show(&ctx, |ui| {
        ui.heading(w.closing);
        if session.task.is_some() {
            ui.label(w.closing_task);
        }
        if session.is_unsaved() {
            ui.label(w.closing_unsaved);
        }
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            if ui.button(w.stay).clicked() {
                view.closing = false;
            }
            if session.is_unsaved() && ui.button(w.save_first).clicked() {
                view.closing = false;
                save(session, view);
            }
            if ui.button(w.close_anyway).clicked() {
                close(view, session);
            }
        });
    });
    if asked.should_close() {
        view.closing = false;
    }
}
