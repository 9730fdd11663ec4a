//! Fit, validation and diagnosis in the background, with the functions of the command.

use crate::session::Session;
use crate::session::results::{Diagnosed, Fitted};
use crate::session::study::{Question, study};
use crate::session::tasks::{Kind, Outcome};
use dashpot_core::Params;
use dashpot_diagnosis::{Options as DiagnosisOptions, choose_left_out, diagnose};
use dashpot_identification::family::fit_family;
use dashpot_identification::model_file;
use dashpot_identification::{FitOptions, Stage, fit};
use dashpot_messages::Sentence;
use dashpot_records::{Record, agree_on_sign, is_same_setting, setting_in_words};
use dashpot_simulation::whole_records::{self, OfDiagnosis};
use std::borrow::Cow;

impl Session {
    /// Fits a model of an ordinary damper to the ticked tests.
    pub fn fit(&mut self) {
        let Some(loaded) = self.campaign.clone() else { return };
        let ticked = self.ticked();
        self.begin(Kind::Fit, move |report| {
            let records: Vec<&Record> = ticked.iter().map(|k| &loaded.original().records[*k]).collect();
            // The fit calls the progress callback only from its own thread.
            let found = fit(&records, &FitOptions::default(), |stage| report(stage.done, Some(stage.text)));
            let fit = Box::new(found.map_err(|e| e.sentence())?);
            let quality = whole_records::quality(&fit, &records).ok();
            Ok(Outcome::Fitted(Fitted { fit, quality }))
        });
    }

    /// Returns the names of settings that have several values in the ticked tests.
    pub fn settings(&self) -> Vec<String> {
        let mut first: Vec<(&str, f64, bool)> = Vec::new();
        for own in self.ticked().into_iter().filter_map(|k| self.record(k)?.setting.as_ref()) {
            match first.iter_mut().find(|(name, ..)| *name == own.name) {
                Some((_, value, several)) => *several |= !is_same_setting(*value, own.value),
                None => first.push((&own.name, own.value, false)),
            }
        }
        first.into_iter().filter(|(.., several)| *several).map(|(name, ..)| name.to_owned()).collect()
    }

    /// Fits one adjustable damper over a setting to the ticked tests.
    pub fn fit_over(&mut self, setting: String) {
        let Some(loaded) = self.campaign.clone() else { return };
        let ticked = self.ticked();
        self.begin(Kind::Fit, move |report| {
            let records: Vec<&Record> = ticked.iter().map(|k| &loaded.original().records[*k]).collect();
            let progress = |stage: Stage| report(stage.done, Some(stage.text));
            let found = fit_family(&records, &setting, &FitOptions::default(), progress);
            Ok(Outcome::FittedFamily(Box::new(found.map_err(|e| e.sentence())?)))
        });
    }

    /// Validates the current model with the ticked tests.
    pub fn validate(&mut self) {
        let (Some(comparison), Some(basis)) = (self.comparison(), self.basis()) else { return };
        self.begin(Kind::Validate, move |report| {
            let found = comparison.validate(&comparison.run(report)?)?;
            Ok(Outcome::Validated(Box::new(found), Box::new(basis)))
        });
    }

    /// Searches for the effect that the model lacks. If a reference campaign is open, compares with it.
    pub fn diagnose(&mut self) {
        let (Some(loaded), Some(model)) = (self.campaign.clone(), &self.model) else { return };
        let (params, ticked, reference) = (*model.params(), self.diagnosed(), self.reference.clone());
        let Some(basis) = self.basis_of_diagnosis() else { return };
        let at = model.over_setting().filter(|_| ticked.len() < self.ticked().len());
        let only_at = at.map(|(axis, setting)| setting_in_words(setting, axis.unit()));
        self.begin(Kind::Diagnose, move |report| {
            let mut own = Cow::Borrowed(&loaded.campaign);
            let mut good = reference.as_ref().map(|reference| reference.campaign.clone());
            if let Some(good) = &mut good {
                agree_on_sign(&mut [own.to_mut(), good]);
            }
            let records: Vec<&Record> = ticked.iter().map(|k| &own.records[*k]).collect();
            let left_out = choose_left_out(&records, 0);
            let good = good.map_or_else(Vec::new, |good| good.records);
            let options = DiagnosisOptions { reference: good, ..DiagnosisOptions::default() };
            let found = diagnose(&records, &left_out, &params, &options, &|done, text| report(done, Some(text)))
                .map_err(|e| e.sentence())?;
            let over_whole_records =
                OfDiagnosis::evaluate(&params, &found.base, &found.improved, &found.measured, &records)
                    .map_err(Sentence::as_it_is)?;
            let diagnosed = Diagnosed { found: Box::new(found), left_out, over_whole_records, only_at, reference };
            Ok(Outcome::Diagnosed(diagnosed, Box::new(basis)))
        });
    }

    /// Returns the ticked tests that a diagnosis uses: those to which the parameter values on screen apply.
    pub fn diagnosed(&self) -> Vec<usize> {
        let Some(dampers) = self.dampers() else { return Vec::new() };
        let is_used = |k: &usize| self.record(*k).is_some_and(|record| dampers.is_at_shown(record));
        self.ticked().into_iter().filter(is_used).collect()
    }

    /// Computes the loops of one test for several values of a parameter. The other parameters are those at the test's own setting. If the
    /// test states no setting, or if its setting changes, the other parameters have the values on screen.
    pub fn study(&mut self, question: Question) {
        let (Some(loaded), Some(params)) = (self.campaign.clone(), self.params_of_study(question.test)) else { return };
        self.begin(Kind::Study, move |_| {
            study(&question, &params, &loaded).map(Outcome::Studied).ok_or_else(|| Sentence::as_it_is(question.number))
        });
    }

    /// Returns the values of the damper that a study of a test varies, or `None` without a model.
    pub(super) fn params_of_study(&self, test: usize) -> Option<Params> {
        let dampers = self.dampers()?;
        let own = self.record(test).and_then(|record| dampers.params_of(record));
        own.or_else(|| Some(*self.model.as_ref()?.params()))
    }

    /// Returns the improved model of the last diagnosis as the text of a model file, or `None` without a diagnosis.
    pub fn improved_text(&self) -> Option<String> {
        let Diagnosed { found, left_out, .. } = &self.results.diagnosis.as_ref()?.found;
        let model = self.model.as_ref()?;
        let loaded = self.campaign.as_ref()?;
        let used = self.diagnosed();
        let records: Vec<&Record> = used.iter().filter_map(|k| loaded.campaign.records.get(*k)).collect();
        Some(model_file::write(&found.as_fit(&records, left_out, &model.file())))
    }
}
