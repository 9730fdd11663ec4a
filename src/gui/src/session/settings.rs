//! Corrections of the settings of tests by hand, with undo.
//!
//! A correction is a rule for the name of the test, as in `campaign.toml`. The records are read again with it, so that every check and every
//! note of the reading uses the corrected setting.

use crate::session::Session;
use crate::session::history::History;
use dashpot_records::{Options, SettingRules, correct_setting};

/// A change of the rules, which is complete once the records were read with them.
pub(super) enum Change {
    /// A correction by the user.
    Correct(SettingRules),
    /// Undo of the last correction.
    Undo,
    /// Redo of the last undone correction.
    Redo,
}

/// The rules for the settings of the tests, with undo.
pub(super) struct Corrections {
    rules: History<SettingRules, ()>,
    /// The change for which the records are being read.
    pending: Option<Change>,
}

impl Default for Corrections {
    fn default() -> Corrections {
        Corrections { rules: History::new(SettingRules::default()), pending: None }
    }
}

impl Corrections {
    /// Returns the rules with which the open records were read.
    pub(super) fn rules(&self) -> &SettingRules {
        self.rules.now()
    }

    /// Returns the serial numbers of the corrections that undo and redo would change.
    pub(super) fn steps(&self) -> (Option<u64>, Option<u64>) {
        self.rules.steps()
    }

    /// Discards the corrections that redo would restore.
    pub(super) fn forget_future(&mut self) {
        self.rules.forget_future();
    }

    /// Removes and returns the change for which records were being read.
    pub(super) fn take_pending(&mut self) -> Option<Change> {
        self.pending.take()
    }

    /// Completes a change.
    pub(super) fn complete(&mut self, change: Change) {
        match change {
            Change::Correct(rules) => {
                self.rules.change((), rules);
                self.rules.seal();
            }
            Change::Undo => {
                self.rules.undo();
            }
            Change::Redo => {
                self.rules.redo();
            }
        }
    }

    /// Begins again with the rules of other records. Records that were read again with equal settings keep their undo steps.
    pub(super) fn restart(&mut self, rules: &SettingRules, is_again: bool) {
        if !is_again || rules.values != self.rules().values {
            self.rules = History::new(rules.clone());
        }
    }
}

impl Session {
    /// Corrects the setting of a test as the user typed it. An empty text means that the test has no setting. Reads the records again.
    pub fn correct_setting(&mut self, test: usize, typed: &str) {
        let (Some(loaded), Some(record)) = (&self.campaign, self.record(test)) else { return };
        let of_model = self.model.as_ref().and_then(|model| model.over_setting());
        let of_model = of_model.map(|(axis, _)| (axis.name(), axis.unit()));
        match correct_setting(self.corrections.rules(), &loaded.campaign.records, record, typed, of_model) {
            Ok(rules) => self.read_with(Change::Correct(rules)),
            Err(error) => self.complain(error),
        }
    }

    /// Returns whether a rule states the setting of this test alone.
    pub fn is_setting_corrected(&self, test: usize) -> bool {
        self.record(test).is_some_and(|record| self.corrections.rules().values.contains_key(&record.name))
    }

    /// Removes the correction of a test's setting, so that the setting comes from the record's channel or name again. Reads the records
    /// again.
    pub fn remove_correction(&mut self, test: usize) {
        let Some(record) = self.record(test) else { return };
        let mut rules = self.corrections.rules().clone();
        rules.values.remove(&record.name);
        self.read_with(Change::Correct(rules));
    }

    /// Undoes or redoes a correction. Reads the records again.
    pub(super) fn step_correction(&mut self, is_undo: bool) {
        self.read_with(if is_undo { Change::Undo } else { Change::Redo });
    }

    /// Reads the records again with the rules after a change. Does nothing while a task is running, and if the rules stay equal.
    fn read_with(&mut self, change: Change) {
        let history = &self.corrections.rules;
        let rules = match &change {
            Change::Correct(rules) => Some(rules),
            Change::Undo => history.before(),
            Change::Redo => history.after(),
        };
        let (Some(rules), Some(loaded)) = (rules.filter(|rules| *rules != history.now()), &self.campaign) else {
            return;
        };
        // Without a name of the setting, `campaign.toml` would supply the rules. That file may contain the correction that is being undone.
        let name = rules.name.clone().or_else(|| history.now().name.clone());
        let settings = SettingRules { name, ..rules.clone() };
        let options = Options { settings, ..loaded.options.clone() };
        if self.open_records(loaded.paths.clone(), options) {
            self.corrections.pending = Some(change);
        }
    }
}
