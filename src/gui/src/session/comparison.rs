//! Comparison of the ticked tests with the forces of the model and of the FV curve alone, for a validation and its report.

use crate::session::campaign::Loaded;
use crate::session::dampers::{Dampers, TestDamper};
use crate::session::{Session, progress};
use dashpot_core::{Model, Params};
use dashpot_identification::model_file::ModelFile;
use dashpot_identification::validation::{Compared, Validation, validate};
use dashpot_identification::{Family, FitOptions, fit};
use dashpot_messages::Sentence;
use dashpot_records::{Campaign, Record};
use dashpot_simulation::comparison::{compare_family, summarize_settings};
use dashpot_simulation::prediction::predict;
use rayon::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Snapshot of the model on screen and the ticked tests, for a task in the background.
pub struct Comparison {
    /// The model on screen as the contents of a model file.
    pub file: ModelFile,
    /// The adjustable damper and the setting on screen, if each test has its own setting.
    family: Option<(ModelFile, f64)>,
    dampers: Dampers,
    loaded: Arc<Loaded>,
    ticked: Vec<usize>,
}

impl Session {
    /// Takes a snapshot of the model and the ticked tests. Returns `None` without a model or without records.
    pub fn comparison(&self) -> Option<Comparison> {
        let (loaded, model) = (self.campaign.clone()?, self.model.as_ref()?);
        let at = model.over_setting().filter(|_| self.own_settings).map(|(_, at)| at);
        Some(Comparison {
            file: model.file(),
            family: model.whole_file().zip(at),
            dampers: model.dampers(model.params(), self.own_settings),
            loaded,
            ticked: self.ticked(),
        })
    }
}

impl Comparison {
    /// Returns the adjustable damper if each test was simulated at its own setting with values that nobody tuned. Returns `None` otherwise.
    pub fn family(&self) -> Option<&ModelFile> {
        let (whole, at) = self.family.as_ref()?;
        (whole.definition().params_at(*at) == self.file.params).then_some(whole)
    }

    /// Returns the ticked tests as a campaign.
    fn ticked_campaign(&self) -> Campaign {
        let all = &self.loaded.campaign;
        Campaign {
            records: self.ticked.iter().map(|k| all.records[*k].clone()).collect(),
            sign: all.sign.clone(),
            delay: None,
            notes: Vec::new(),
            unusable: Vec::new(),
            files: Vec::new(),
        }
    }

    /// Simulates the ticked tests with the model and with the FV curve.
    ///
    /// # Errors
    /// A model cannot run, or no FV curve can be fitted.
    pub fn run(&self, report: progress::Report<'_>) -> Result<Vec<Compared<'_>>, Sentence> {
        match &self.family {
            Some((whole, at)) => self.run_family(whole, *at, report),
            None => self.run_shown(report),
        }
    }

    /// Simulates each test at its own setting. Tuned values apply only to tests at the setting at which they were tuned.
    fn run_family(
        &self,
        whole: &ModelFile,
        at: f64,
        report: progress::Report<'_>,
    ) -> Result<Vec<Compared<'_>>, Sentence> {
        let campaign = self.ticked_campaign();
        let done = |done: usize, total: usize| report(done as f64 / total.max(1) as f64, None);
        let found = compare_family(whole, &campaign, Some(at), &done).map_err(Sentence::as_it_is)?;
        let shown = Model::new(&self.file.params).map_err(|fault| Sentence::as_it_is(fault.reason.text()))?;
        let of_test = |(k, of): (&usize, Compared<'_>)| {
            let (record, seen) = (&self.loaded.campaign.records[*k], &self.loaded.tests[*k]);
            let is_shown = self.dampers.of_test(record) == TestDamper::Shown;
            let rise = || self.loaded.warm.rise(&self.file.params, *k);
            let model = if is_shown { predict(&shown, record, &seen.motion, rise()) } else { of.model };
            Compared { record, model, fv_only: of.fv_only, used_in_fit: of.used_in_fit }
        };
        Ok(self.ticked.par_iter().zip(found).map(of_test).collect())
    }

    /// Simulates the ticked tests with the parameter values on screen.
    fn run_shown(&self, report: progress::Report<'_>) -> Result<Vec<Compared<'_>>, Sentence> {
        let made = |params: &Params| Model::new(params).map_err(|fault| Sentence::as_it_is(fault.reason.text()));
        let (loaded, file) = (&self.loaded, &self.file);
        let records: Vec<&Record> = self.ticked.iter().map(|k| &loaded.campaign.records[*k]).collect();
        // If the model file contains no plain FV curve of a fit, a curve is fitted to the ticked tests, as in the command.
        let fv_only = match &file.identification.fv_only {
            Some(curve) => curve.params().map_err(Sentence::as_it_is)?,
            None => {
                let options = FitOptions { family: Family::Fv, ..FitOptions::default() };
                fit(&records, &options, |_| ()).map_err(|e| e.sentence())?.params
            }
        };
        let (model, fv_only) = (made(&file.params)?, made(&fv_only)?);
        let done = AtomicUsize::new(0);
        let of_test = |k: &usize| {
            let (record, seen) = (&loaded.campaign.records[*k], &loaded.tests[*k]);
            let compared = Compared {
                record,
                model: predict(&model, record, &seen.motion, loaded.warm.rise(&file.params, *k)),
                fv_only: predict(&fv_only, record, &seen.motion, 0.0),
                used_in_fit: file.identification.used(record),
            };
            report((1 + done.fetch_add(1, Ordering::Relaxed)) as f64 / self.ticked.len() as f64, None);
            compared
        };
        Ok(self.ticked.par_iter().map(of_test).collect())
    }

    /// Computes the errors of the simulated tests. If each test has its own setting, also computes the errors at each setting.
    ///
    /// # Errors
    /// No test is comparable.
    pub fn validate(&self, compared: &[Compared<'_>]) -> Result<Validation, Sentence> {
        let mut found = validate(compared).map_err(Sentence::as_it_is)?;
        if let Some((whole, at)) = &self.family {
            let campaign = self.ticked_campaign();
            summarize_settings(&mut found, whole, (&campaign, compared), Some(*at)).map_err(Sentence::as_it_is)?;
        }
        found.unusable.clone_from(&self.loaded.campaign.unusable);
        Ok(found)
    }

    /// Returns the opened records.
    pub fn loaded(&self) -> &Arc<Loaded> {
        &self.loaded
    }
}
