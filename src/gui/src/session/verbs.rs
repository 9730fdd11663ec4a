//! Fit, validate and diagnose, as the command does them, beside the window.

use crate::session::campaign::Loaded;
use crate::session::results::{Diagnosed, Fitted};
use crate::session::study::{Question, study};
use crate::session::tasks::{Kind, Outcome};
use crate::session::{Session, progress};
use dashpot_core::{Model, Params};
use dashpot_diagnosis::{Options as DiagnosisOptions, choose_left_out, diagnose};
use dashpot_identification::model_file::{self, ModelFile};
use dashpot_identification::validation::{Compared, validate};
use dashpot_identification::{Family, FitOptions, fit};
use dashpot_records::{Record, Sentence};
use dashpot_simulation::prediction::predict;
use dashpot_simulation::whole_records::{self, OfDiagnosis};
use rayon::prelude::*;
use std::sync::Arc;

impl Session {
    /// Fits a model to the ticked tests.
    pub fn fit(&mut self) {
        let Some(loaded) = self.campaign.clone() else { return };
        let ticked = self.ticked();
        self.begin(Kind::Fit, move |report| {
            let records: Vec<&Record> = ticked.iter().map(|k| &loaded.original().records[*k]).collect();
            // The progress of a fit comes from the thread that runs it alone.
            let found = fit(&records, &FitOptions::default(), |stage| report(stage.done, Some(stage.text)));
            let fit = Box::new(found.map_err(|e| e.sentence())?);
            let quality = whole_records::quality(&fit, &records).ok();
            Ok(Outcome::Fitted(Fitted { fit, quality }))
        });
    }

    /// Validates the model as it stands against the ticked tests.
    pub fn validate(&mut self) {
        let (Some(loaded), Some(model)) = (self.campaign.clone(), &self.model) else { return };
        let (file, ticked) = (model.file(), self.ticked());
        let Some(basis) = self.basis() else { return };
        self.begin(Kind::Validate, move |report| {
            let compared = compared(&file, &loaded, &ticked, report)?;
            let mut found = validate(&compared).map_err(Sentence::as_it_is)?;
            found.unusable.clone_from(&loaded.campaign.unusable);
            Ok(Outcome::Validated(Box::new(found), Box::new(basis)))
        });
    }

    /// Seeks the effect that is missing in the model, against the reference campaign where one is open.
    pub fn diagnose(&mut self) {
        let (Some(loaded), Some(model)) = (self.campaign.clone(), &self.model) else { return };
        let (params, ticked, reference) = (*model.params(), self.ticked(), self.reference.clone());
        let Some(basis) = self.basis() else { return };
        self.begin(Kind::Diagnose, move |report| {
            let records: Vec<&Record> = ticked.iter().map(|k| &loaded.campaign.records[*k]).collect();
            let left_out = choose_left_out(&records, 0);
            let good = reference.as_ref().map_or_else(Vec::new, |r| r.campaign.records.clone());
            let options = DiagnosisOptions { reference: good, ..DiagnosisOptions::default() };
            let found = diagnose(&records, &left_out, &params, &options, &|done, text| report(done, Some(text)))
                .map_err(|e| e.sentence())?;
            let over_whole_records =
                OfDiagnosis::evaluate(&params, &found.base, &found.improved, &found.measured, &records)
                    .map_err(Sentence::as_it_is)?;
            let diagnosed = Diagnosed { found: Box::new(found), left_out, over_whole_records, reference };
            Ok(Outcome::Diagnosed(diagnosed, Box::new(basis)))
        });
    }

    /// Computes a family of loops.
    pub fn study(&mut self, question: Question) {
        let (Some(loaded), Some(model)) = (self.campaign.clone(), &self.model) else { return };
        let params = *model.params();
        self.begin(Kind::Study, move |_| {
            study(&question, &params, &loaded).map(Outcome::Studied).ok_or_else(|| Sentence::as_it_is(question.number))
        });
    }

    /// The model that the diagnosis improved, as the text of its file.
    pub fn improved_text(&self) -> Option<String> {
        let Diagnosed { found, left_out, .. } = &self.results.diagnosis.as_ref()?.found;
        let model = self.model.as_ref()?;
        let loaded = self.campaign.as_ref()?;
        let ticked = self.ticked();
        let records: Vec<&Record> = ticked.iter().filter_map(|k| loaded.campaign.records.get(*k)).collect();
        Some(model_file::write(&found.as_fit(&records, left_out, &model.file())))
    }
}

/// The ticked tests with the forces of the model and of the plain FV curve.
pub fn compared<'a>(
    file: &ModelFile,
    loaded: &'a Arc<Loaded>,
    ticked: &[usize],
    report: progress::Report<'_>,
) -> Result<Vec<Compared<'a>>, Sentence> {
    let made = |params: &Params| Model::new(params).map_err(|fault| Sentence::as_it_is(fault.reason.text()));
    let records: Vec<&Record> = ticked.iter().map(|k| &loaded.campaign.records[*k]).collect();
    // Where the model file brings no plain curve, it is fitted to these tests, as the command does.
    let fv_only = match &file.identification.fv_only {
        Some(curve) => curve.params().map_err(Sentence::as_it_is)?,
        None => {
            let options = FitOptions { family: Family::Fv, ..FitOptions::default() };
            fit(&records, &options, |_| ()).map_err(|e| e.sentence())?.params
        }
    };
    let (model, fv_only) = (made(&file.params)?, made(&fv_only)?);
    let done = std::sync::atomic::AtomicUsize::new(0);
    Ok(ticked
        .par_iter()
        .map(|k| {
            let (record, seen) = (&loaded.campaign.records[*k], &loaded.tests[*k]);
            let compared = Compared {
                record,
                model: predict(&model, record, &seen.motion, loaded.warm.rise(&file.params, *k)),
                fv_only: predict(&fv_only, record, &seen.motion, 0.0),
                used_in_fit: file.identification.used(record),
            };
            let done = 1 + done.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            report(done as f64 / ticked.len() as f64, None);
            compared
        })
        .collect())
}
