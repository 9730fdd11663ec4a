//! Writing of the reports and workbooks of fit, validation and diagnosis in the language of the window.

use crate::session::Session;
use crate::session::campaign::Loaded;
use crate::session::guarded::checked;
use crate::session::model::Tuned;
use crate::session::outputs::error_sentence;
use crate::session::results::Diagnosed;
use crate::session::tasks::{Kind as Work, Outcome};
use dashpot_messages::Sentence;
use dashpot_output::Kind;
use dashpot_records::Record;
use dashpot_report::diagnosis::DiagnosisReport;
use dashpot_report::words::Words;
use dashpot_report::{FamilyReport, Made, Print, ReportInput, parameters, reading, write_workbook};
use dashpot_simulation::whole_records;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Kind of report or workbook.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Paper {
    /// The tables of the fit.
    FitTables,
    /// The report of the validation.
    ValidationReport,
    /// The tables of the validation.
    ValidationTables,
    /// The report of the diagnosis.
    DiagnosisReport,
    /// The tables of the diagnosis.
    DiagnosisTables,
}

impl Paper {
    /// Returns the proposed name and the accepted extensions.
    pub fn proposed(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Paper::FitTables => ("fit.xlsx", &["xlsx"]),
            Paper::ValidationReport => ("report.html", &["html"]),
            Paper::ValidationTables => ("validation.xlsx", &["xlsx"]),
            Paper::DiagnosisReport => ("diagnosis.html", &["html"]),
            Paper::DiagnosisTables => ("diagnosis.xlsx", &["xlsx"]),
        }
    }

    fn kind(self) -> Kind {
        match self {
            Paper::ValidationReport | Paper::DiagnosisReport => Kind::Report,
            Paper::FitTables | Paper::ValidationTables | Paper::DiagnosisTables => Kind::Workbook,
        }
    }
}

/// Returns the path of the model's file if that file contains the current values.
fn file_of(model: &Tuned) -> Option<PathBuf> {
    model.path.clone().filter(|_| !model.is_unsaved())
}

/// Describes the origin of a report. The function rereads every file, so it runs in the background.
fn made<'a>(model: Option<&PathBuf>, campaigns: impl IntoIterator<Item = &'a Arc<Loaded>>) -> Made {
    let files: Vec<&PathBuf> = model.into_iter().chain(campaigns.into_iter().flat_map(|c| &c.campaign.files)).collect();
    Made::from_files(files.into_iter().map(PathBuf::as_path))
}

impl Session {
    /// Writes a report or a workbook of the results.
    pub fn write_paper(&mut self, paper: Paper, path: PathBuf, words: &'static Words) {
        match paper {
            Paper::FitTables => self.write_fit(path, words),
            Paper::ValidationReport | Paper::ValidationTables => self.write_validation(paper, path, words),
            Paper::DiagnosisReport | Paper::DiagnosisTables => self.write_diagnosis(paper, path, words),
        }
    }

    fn write_fit(&mut self, path: PathBuf, words: &'static Words) {
        let (Some(loaded), Some(fit), Some(model)) =
            (self.campaign.clone(), self.results.fit.as_ref().map(|a| a.found.fit.clone()), &self.model)
        else {
            return;
        };
        let (name, model_path) = (model.name(), file_of(model));
        self.begin(Work::Write, move |_| {
            let records: Vec<&Record> =
                loaded.original().records.iter().filter(|r| fit.tests.contains(&r.name)).collect();
            let error = whole_records::of_fit(&fit, &records).map_err(Sentence::as_it_is)?;
            let made = made(model_path.as_ref(), [&loaded]);
            let tables = dashpot_report::fit::workbook(
                (&fit, &error),
                &loaded.campaign.unusable,
                [&name, &loaded.named()],
                made,
                words,
            );
            write(path, Kind::Workbook, |path| write_workbook(&tables, path))
        });
    }

    fn write_validation(&mut self, paper: Paper, path: PathBuf, words: &'static Words) {
        let (Some(comparison), Some(model)) = (self.comparison(), &self.model) else { return };
        let (name, model_path) = (model.name(), file_of(model));
        let family_fit = self.results.family_fit.as_ref().filter(|of| !of.is_old(self)).map(|of| of.found.clone());
        self.begin(Work::Write, move |report| {
            let loaded = comparison.loaded();
            let compared = comparison.run(report)?;
            let validation = comparison.validate(&compared)?;
            let family = comparison.family();
            let file = family.unwrap_or(&comparison.file);
            let mut input = ReportInput {
                print: Print::Brief,
                made: made(model_path.as_ref(), [loaded]),
                model_file: name,
                data: loaded.named(),
                ..ReportInput::from_validation(file, &loaded.campaign, &compared, &validation, words)
                    .map_err(|e| error_sentence(&e))?
            };
            if let Some(model) = family {
                // The figure of peak forces gets no curve, because the curve at one setting does not represent the
                // other settings.
                input.curve.clear();
                input.family = Some(FamilyReport { model, fit: family_fit.as_deref() });
            }
            write(path, paper.kind(), |path| match paper.kind() {
                Kind::Workbook => write_workbook(&dashpot_report::workbook(&input), path),
                _ => dashpot_report::write_atomic(&input, path),
            })
        });
    }

    fn write_diagnosis(&mut self, paper: Paper, path: PathBuf, words: &'static Words) {
        let (Some(loaded), Some(Diagnosed { found, over_whole_records, reference, .. }), Some(model)) =
            (self.campaign.clone(), self.results.diagnosis.as_ref().map(|a| &a.found), &self.model)
        else {
            return;
        };
        let (model_file, model_path) = (model.name(), file_of(model));
        let (found, over_whole_records, ticked) = (found.clone(), *over_whole_records, self.diagnosed());
        let mut said = reading::sentences(&loaded.campaign, words);
        let reference = reference.clone();
        let others = reference.iter().flat_map(|other| &other.campaign.unusable);
        said.extend(others.map(|one| words.say(&one.why)));
        self.begin(Work::Write, move |_| {
            let records: Vec<&Record> = ticked.iter().filter_map(|k| loaded.campaign.records.get(*k)).collect();
            let report = DiagnosisReport {
                model_file,
                data: loaded.named(),
                parameters: parameters::of_diagnosis(&found, words),
                found: &found,
                records: &records,
                reading: said,
                over_whole_records,
                made: made(model_path.as_ref(), std::iter::once(&loaded).chain(&reference)),
                print: Print::Brief,
                words,
            };
            write(path, paper.kind(), |path| match paper.kind() {
                Kind::Workbook => write_workbook(&report.workbook(), path),
                _ => report.write(path),
            })
        });
    }
}

/// Writes a file with `write`, unless a file of another kind exists at the path.
fn write(path: PathBuf, kind: Kind, write: impl FnOnce(&Path) -> anyhow::Result<()>) -> Result<Outcome, Sentence> {
    checked(&path, kind).and_then(|()| write(&path)).map_err(|e| error_sentence(&e))?;
    Ok(Outcome::Written(path, Vec::new()))
}
