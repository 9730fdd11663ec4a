//! Replacement of the model on screen.
//!
//! The user must confirm a loss of manually tuned values. The replacement can be undone.

use crate::session::Session;
use crate::session::history::next_serial;
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

/// Kind of a change that undo and redo restore.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Subject {
    /// A value of the model on screen.
    Value,
    /// The model on screen.
    Model,
    /// The setting of a test.
    Setting,
}

/// Models that were on screen before and after the present one, for undo and redo.
#[derive(Default)]
pub struct Others {
    /// Previous models, with the serial number of each replacement.
    past: Vec<(u64, Tuned)>,
    /// Models that redo restores, with the serial number of each replacement.
    future: Vec<(u64, Tuned)>,
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
        self.forget_future();
        self.show_model(model);
    }

    /// Keeps a model for undo, without its redo steps.
    pub(super) fn keep(&mut self, mut before: Tuned) {
        before.forget_future();
        self.others.past.push((next_serial(), before));
        if self.others.past.len() > DEPTH {
            self.others.past.remove(0);
        }
    }

    /// Discards the models and the corrections of settings that redo would restore, after another change.
    pub(super) fn forget_future(&mut self) {
        self.others.future.clear();
        self.corrections.forget_future();
    }

    /// Undoes the last change: of a value, of the model, or of a test's setting.
    pub fn undo(&mut self) {
        match self.next_undo() {
            Some(Subject::Value) => {
                self.step(Tuned::undo);
            }
            Some(Subject::Model) => {
                let Some((serial, before)) = self.others.past.pop() else { return };
                self.others.future.extend(self.model.take().map(|model| (serial, model)));
                self.show_model(before);
            }
            Some(Subject::Setting) => self.step_correction(true),
            None => {}
        }
    }

    /// Redoes the last undone change.
    pub fn redo(&mut self) {
        match self.next_redo() {
            Some(Subject::Value) => {
                self.step(Tuned::redo);
            }
            Some(Subject::Model) => {
                let Some((serial, after)) = self.others.future.pop() else { return };
                self.others.past.extend(self.model.take().map(|model| (serial, model)));
                self.show_model(after);
            }
            Some(Subject::Setting) => self.step_correction(false),
            None => {}
        }
    }

    /// Returns the subject of the newest change that can be undone.
    fn next_undo(&self) -> Option<Subject> {
        let value = self.model.as_ref().and_then(|model| model.steps().0);
        let model = self.others.past.last().map(|(serial, _)| *serial);
        let setting = self.corrections.steps().0;
        let all = [(value, Subject::Value), (model, Subject::Model), (setting, Subject::Setting)];
        let newest = all.into_iter().filter_map(|(serial, subject)| Some((serial?, subject)));
        newest.max_by_key(|(serial, _)| *serial).map(|(_, subject)| subject)
    }

    /// Returns the subject of the oldest undone change.
    fn next_redo(&self) -> Option<Subject> {
        let value = self.model.as_ref().and_then(|model| model.steps().1);
        let model = self.others.future.last().map(|(serial, _)| *serial);
        let setting = self.corrections.steps().1;
        let all = [(value, Subject::Value), (model, Subject::Model), (setting, Subject::Setting)];
        let oldest = all.into_iter().filter_map(|(serial, subject)| Some((serial?, subject)));
        oldest.min_by_key(|(serial, _)| *serial).map(|(_, subject)| subject)
    }

    /// Returns whether undo and redo are possible. A setting of a test is not changed while a task is running, because the records are read
    /// again.
    pub fn can_undo(&self) -> (bool, bool) {
        let is_free = self.task.is_none();
        let can = |subject: Option<Subject>| subject.is_some_and(|of| of != Subject::Setting || is_free);
        (can(self.next_undo()), can(self.next_redo()))
    }
}
