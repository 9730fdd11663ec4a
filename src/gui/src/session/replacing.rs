//! Replacement of the model on screen.
//!
//! The user must confirm a loss of manually tuned values. The replacement can be undone.

use crate::session::Session;
use crate::session::model::Tuned;
use crate::session::results::{Finding, Fitted};
use crate::session::tasks::Kind;
use dashpot_core::Params;
use dashpot_identification::family::FamilyFit;
use dashpot_identification::model_file;
use dashpot_messages::Sentence;
use std::path::PathBuf;

/// Source of the model that replaces the model on screen.
pub enum Replacement {
    /// A model file.
    File(PathBuf),
    /// The result of a fit that is not started yet.
    Fit,
    /// The adjustable damper from a fit that is not started yet, with the name of the setting.
    FitOver(String),
    /// The result of a complete fit.
    Fitted(Fitted),
    /// The adjustable damper from a complete fit.
    FittedFamily(Box<FamilyFit>),
    /// The improved model of the diagnosis.
    Improved,
}

/// Largest number of models that undo can restore. Each model has its own undo steps.
const DEPTH: usize = 20;

/// Models that were on screen before and after the present one, for undo and redo.
#[derive(Default)]
pub struct Others {
    past: Vec<Tuned>,
    future: Vec<Tuned>,
    /// Unsaved parameter values whose loss the user has confirmed.
    allowed: Option<Params>,
}

impl Session {
    /// Returns whether there are manually tuned values that are not saved.
    pub fn has_unsaved_tuning(&self) -> bool {
        self.model.as_ref().is_some_and(|m| m.is_tuned() && m.is_unsaved())
    }

    /// Replaces the model, or waits for the user's confirmation if manually tuned values would be lost.
    pub fn replace(&mut self, replacement: Replacement) {
        if self.has_unsaved_tuning() {
            self.pending = Some(replacement);
        } else {
            self.carry_out(replacement);
        }
    }

    /// Carries out the pending replacement.
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

    /// Replaces the model after a fit. If the user tuned the model during the fit, waits for the user's confirmation.
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
        self.arrived = Some(Kind::Fit);
    }

    fn take_family_fit(&mut self, fit: Box<FamilyFit>) {
        match Tuned::identified(dashpot_identification::family::model_file::write(&fit)) {
            Ok(model) => self.take_model(model),
            Err(error) => return self.complain(Sentence::as_it_is(error)),
        }
        self.own_settings = true;
        self.results.fit = None;
        self.results.family_fit = self.basis_of_fit().map(|basis| Finding::of_fit(fit, basis));
        self.arrived = Some(Kind::Fit);
    }

    /// Replaces the model on screen. Undo restores the previous model.
    pub(super) fn take_model(&mut self, model: Tuned) {
        if let Some(before) = self.model.take() {
            self.keep(before);
        }
        self.others.future.clear();
        self.show_model(model);
    }

    /// Keeps a model for undo, without its redo steps.
    pub(super) fn keep(&mut self, mut before: Tuned) {
        before.forget_future();
        self.others.past.push(before);
        if self.others.past.len() > DEPTH {
            self.others.past.remove(0);
        }
    }

    /// Discards the models that redo would restore, after another change.
    pub(super) fn forget_future(&mut self) {
        self.others.future.clear();
    }

    /// Undoes the last change of the model. If there is none, restores the previous model.
    pub fn undo(&mut self) {
        if self.model.as_ref().is_some_and(|m| m.can().0) {
            self.step(Tuned::undo);
        } else if let Some(before) = self.others.past.pop() {
            self.others.future.extend(self.model.take());
            self.show_model(before);
        }
    }

    /// Redoes the last undone change. If there is none, restores the model before the last undo.
    pub fn redo(&mut self) {
        if self.model.as_ref().is_some_and(|m| m.can().1) {
            self.step(Tuned::redo);
        } else if let Some(after) = self.others.future.pop() {
            self.others.past.extend(self.model.take());
            self.show_model(after);
        }
    }

    /// Returns whether undo and redo are possible.
    pub fn can_undo(&self) -> (bool, bool) {
        let (back, forth) = self.model.as_ref().map_or((false, false), Tuned::can);
        (back || !self.others.past.is_empty(), forth || !self.others.future.is_empty())
    }
}
