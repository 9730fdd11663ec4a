//! Another model in the place of the one on screen.
//!
//! Asked for first where values set by hand would be lost, and undone like any change.

use crate::session::Session;
use crate::session::model::Tuned;
use crate::session::results::{Finding, Fitted};
use dashpot_core::Params;
use dashpot_identification::family::FamilyFit;
use dashpot_identification::model_file;
use dashpot_messages::Sentence;
use std::path::PathBuf;

/// What takes the place of the model.
pub enum Replacement {
    /// A model file.
    File(PathBuf),
    /// What a fit will find.
    Fit,
    /// The damper over a setting that a fit will find, by the name of the setting.
    FitOver(String),
    /// What a fit has found, while the model was tuned.
    Fitted(Fitted),
    /// The damper over a setting that a fit has found, while the model was tuned.
    FittedFamily(Box<FamilyFit>),
    /// The improved model of the diagnosis.
    Improved,
}

/// Models that can be gone back to; each holds its own steps.
const DEPTH: usize = 20;

/// Models before and after the one on screen.
#[derive(Default)]
pub struct Others {
    past: Vec<Tuned>,
    future: Vec<Tuned>,
    /// Values that may be lost: the user was asked.
    allowed: Option<Params>,
}

impl Session {
    /// Whether values set by hand are in no file.
    pub fn has_unsaved_tuning(&self) -> bool {
        self.model.as_ref().is_some_and(|m| m.is_tuned() && m.is_unsaved())
    }

    /// Replaces the model, or waits for the user where values set by hand would be lost.
    pub fn replace(&mut self, replacement: Replacement) {
        if self.has_unsaved_tuning() {
            self.pending = Some(replacement);
        } else {
            self.carry_out(replacement);
        }
    }

    /// Replaces the model as it was waiting for.
    pub fn replace_pending(&mut self) {
        if let Some(replacement) = self.pending.take() {
            self.carry_out(replacement);
        }
    }

    fn carry_out(&mut self, replacement: Replacement) {
        match replacement {
            Replacement::File(path) => self.open_model(&path),
            Replacement::Fit => {
                self.others.allowed = self.model.as_ref().map(|m| *m.params());
                self.fit();
            }
            Replacement::FitOver(setting) => {
                self.others.allowed = self.model.as_ref().map(|m| *m.params());
                self.fit_over(setting);
            }
            Replacement::Fitted(fit) => self.take_fit(fit),
            Replacement::FittedFamily(fit) => self.take_family_fit(fit),
            Replacement::Improved => self.take_improved(),
        }
    }

    /// A fit is done: its model takes the place of the one on screen, unless that was tuned meanwhile.
    pub(super) fn fit_is_done(&mut self, fit: Replacement) {
        let now = self.model.as_ref().map(|m| *m.params());
        if self.has_unsaved_tuning() && self.others.allowed != now {
            self.pending = Some(fit);
        } else {
            self.carry_out(fit);
        }
    }

    fn take_fit(&mut self, fit: Fitted) {
        match Tuned::identified(model_file::write(&fit.fit)) {
            Ok(model) => self.take_model(model),
            Err(error) => return self.complain(Sentence::as_it_is(error)),
        }
        self.results.family_fit = None;
        self.results.fit = self.basis_of_fit().map(|basis| Finding::of_fit(fit, basis));
    }

    fn take_family_fit(&mut self, fit: Box<FamilyFit>) {
        match Tuned::identified(dashpot_identification::family::model_file::write(&fit)) {
            Ok(model) => self.take_model(model),
            Err(error) => return self.complain(Sentence::as_it_is(error)),
        }
        self.own_settings = true;
        self.results.fit = None;
        self.results.family_fit = self.basis_of_fit().map(|basis| Finding::of_fit(fit, basis));
    }

    /// The model takes the place of the one on screen, which can be gone back to.
    pub(super) fn take_model(&mut self, model: Tuned) {
        if let Some(mut before) = self.model.take() {
            before.forget_future();
            self.others.past.push(before);
            if self.others.past.len() > DEPTH {
                self.others.past.remove(0);
            }
        }
        self.others.future.clear();
        self.show_model(model);
    }

    /// What was taken back is forgotten: something else was done.
    pub(super) fn forget_future(&mut self) {
        self.others.future.clear();
    }

    /// Takes the last change back; where there is none, the model before this one.
    pub fn undo(&mut self) {
        if self.model.as_ref().is_some_and(|m| m.can().0) {
            self.step(Tuned::undo);
        } else if let Some(before) = self.others.past.pop() {
            self.others.future.extend(self.model.take());
            self.show_model(before);
        }
    }

    /// Does again what was taken back last.
    pub fn redo(&mut self) {
        if self.model.as_ref().is_some_and(|m| m.can().1) {
            self.step(Tuned::redo);
        } else if let Some(after) = self.others.future.pop() {
            self.others.past.extend(self.model.take());
            self.show_model(after);
        }
    }

    /// Whether there is something to take back, and to do again.
    pub fn can_undo(&self) -> (bool, bool) {
        let (back, forth) = self.model.as_ref().map_or((false, false), Tuned::can);
        (back || !self.others.past.is_empty(), forth || !self.others.future.is_empty())
    }
}
