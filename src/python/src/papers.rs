//! Writing of reports, workbooks, certificates and figures. The functions of the command make their contents, so Python and the command
//! write equal bytes for equal input.

use crate::campaign::Campaign;
use crate::compare::{compared, figures};
use crate::errors::{OutputError, raise};
use crate::examine::Diagnosed;
use crate::groups::Grouped;
use crate::identify::Fitted;
use crate::limits;
use crate::model::Model;
use crate::work;
use dashpot_output::{FolderLock, Kind, as_a_run};
use dashpot_records::Record;
use dashpot_report::against::{Rival, section};
use dashpot_report::certificate::{self, CertificateInput};
use dashpot_report::diagnosis::DiagnosisReport;
use dashpot_report::words::{Language, Words};
use dashpot_report::{Made, MadeFrom, Print, ReportInput, groups, made, parameters, reading, write_workbook};
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// Language, format and stated inputs of a report, workbook or figure that is written.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Page {
    /// `en`, `de`, `fr` or `zh`.
    language: String,
    date: Option<String>,
    /// Whether the printed report is complete instead of brief.
    full: bool,
    /// Whether the output may replace other files.
    force: bool,
    /// Name or path of the model file.
    model: String,
    /// Whether the model is stored in a file.
    is_file: bool,
    /// Files or folders of the records, as named in the subtitle.
    data: String,
    /// Words of the equivalent command, or empty if there is none.
    command: Vec<String>,
    /// Files that were read in addition to model and records.
    files: Vec<PathBuf>,
}

impl Page {
    fn words(&self) -> PyResult<&'static Words> {
        self.language.parse::<Language>().map(Language::words).map_err(PyValueError::new_err)
    }

    fn print(&self) -> Print {
        if self.full { Print::Whole } else { Print::Brief }
    }

    /// Returns the name of the model file without its folder.
    fn model_file(&self) -> String {
        Path::new(&self.model).file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned())
    }

    /// Returns the inputs of a report.
    ///
    /// The first input is the content that the model's file had when it was read or written. The other files are read again.
    fn made<'a>(&'a self, model: Option<&Model>, files: impl IntoIterator<Item = &'a PathBuf>) -> PyResult<Made> {
        let date = made::date(self.date.as_deref()).map_err(raise::<PyValueError>)?;
        let model = model
            .filter(|_| self.is_file)
            .map(|model| MadeFrom::of_content(&self.model, model.text_of_file().as_bytes()));
        let files = self.files.iter().chain(files);
        let known = model.into_iter().chain(files.filter_map(|path| MadeFrom::read(path))).collect();
        Ok(Made { date, command: made::command_line(self.command.iter().cloned()), ..Made::of_known(known) })
    }

    /// Runs `work`, which writes a file of this kind to `path`. Without a kind, `path` is a folder.
    ///
    /// The output may not replace an input of the report.
    fn write<T: Send>(
        &self,
        py: Python<'_>,
        (path, kind): (&Path, Option<Kind>),
        made: &Made,
        work: impl FnOnce() -> anyhow::Result<T> + Send,
    ) -> PyResult<T> {
        let done = work::run(py, None, |_| {
            as_a_run(self.force, made.files.iter().map(|file| Path::new(&file.name)), || {
                let _held = match kind {
                    Some(kind) => {
                        dashpot_output::check_kinds([(Some(path), kind)])?;
                        None
                    }
                    None => Some(FolderLock::take(path)?),
                };
                work()
            })
        })?;
        done.map_err(raise::<OutputError>)
    }
}

/// Forces of the model and of the FV curve alone at the samples of one test, N.
type Forces<'py> = (PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>);

/// Writes a validation as `report`, `certificate`, `workbook` or `figures`. Figures are written into a folder. Returns the written files.
///
/// The error figures are computed again from the given forces. `campaign` contains the compared records, which were corrected for
/// measurement errors.
#[pyfunction]
#[allow(clippy::too_many_arguments, clippy::needless_pass_by_value)]
pub fn write_validation(
    py: Python<'_>,
    what: &str,
    path: PathBuf,
    page: Page,
    model: &Model,
    campaign: &Campaign,
    forces: Vec<Forces<'_>>,
    windows: Option<Vec<limits::Row>>,
    rivals: Vec<(String, Vec<PyReadonlyArray1<'_, f64>>)>,
) -> PyResult<Vec<PathBuf>> {
    let words = page.words()?;
    let windows = windows.map(limits::of_rows).transpose()?;
    let made = page.made(Some(model), &campaign.read.files)?;
    let values = |array: &PyReadonlyArray1<'_, f64>| array.as_array().to_vec();
    let forces = forces.iter().map(|(model, fv_only)| (values(model), values(fv_only))).collect();
    let rivals: Vec<(String, Vec<Vec<f64>>)> =
        rivals.iter().map(|(name, forces)| (name.clone(), forces.iter().map(values).collect())).collect();
    let kind = match what {
        "figures" => None,
        "workbook" => Some(Kind::Workbook),
        _ => Some(Kind::Report),
    };
    let limits_file = page.files.first().map_or_else(String::new, |path| path.display().to_string());
    page.write(py, (&path, kind), &made, || {
        let compared = compared(&model.file, &campaign.read, forces);
        let validation = figures(&campaign.read, &compared, windows.as_deref(), &rivals)?;
        let mut input = ReportInput {
            print: page.print(),
            made: made.clone(),
            model_file: page.model_file(),
            data: page.data.clone(),
            ..ReportInput::from_validation(&model.file, &campaign.read, &compared, &validation, words)?
        };
        let drawn = rivals.into_iter().filter_map(|(name, forces)| Rival::named(&name, forces)).collect::<Vec<_>>();
        input.extra.extend(section(&validation, &compared, &drawn, words));
        match (what, &validation.limits) {
            ("figures", _) => return dashpot_report::svgs(&input, &path),
            ("workbook", _) => write_workbook(&dashpot_report::workbook(&input), &path)?,
            ("certificate", Some(found)) => {
                let records: Vec<&Record> = campaign.records();
                let page = certificate::render(&CertificateInput {
                    certificate: found,
                    records: &records,
                    data: input.data.clone(),
                    limits: limits_file,
                    curve: &input.curve,
                    made: &input.made,
                    words,
                });
                dashpot_output::write(&path, page)?;
            }
            _ => dashpot_report::write_atomic(&input, &path)?,
        }
        Ok(vec![path.clone()])
    })
}

/// Writes a diagnosis as `report`, `workbook` or `figures`. Figures are written into a folder. Returns the written files.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn write_diagnosis(
    py: Python<'_>,
    what: &str,
    path: PathBuf,
    page: Page,
    found: &Diagnosed,
) -> PyResult<Vec<PathBuf>> {
    let words = page.words()?;
    let model = found.model.get();
    let reference = found.reference.iter().flat_map(|reference| &reference.get().read.files);
    let made = page.made(Some(model), found.campaign.get().read.files.iter().chain(reference))?;
    let kind = match what {
        "figures" => None,
        "workbook" => Some(Kind::Workbook),
        _ => Some(Kind::Report),
    };
    page.write(py, (&path, kind), &made, || {
        let mut records = found.campaign.get().read.records.clone();
        model.file.identification.right(&mut records);
        let report = DiagnosisReport {
            model_file: page.model_file(),
            data: page.data.clone(),
            found: &found.found,
            records: &records.iter().collect::<Vec<_>>(),
            reading: reading::sentences(&found.about, words),
            over_whole_records: found.over_whole_records,
            parameters: parameters::of_diagnosis(&found.found, words),
            made: made.clone(),
            print: page.print(),
            words,
        };
        match what {
            "figures" => return report.write_svgs(&path),
            "workbook" => write_workbook(&report.workbook(), &path)?,
            _ => report.write(&path)?,
        }
        Ok(vec![path.clone()])
    })
}

/// Writes the diagnoses of groups as `report` or `workbook`.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn write_groups(py: Python<'_>, what: &str, path: PathBuf, page: Page, found: &Grouped) -> PyResult<()> {
    let words = page.words()?;
    let made = page.made(Some(found.model.get()), &found.files)?;
    let is_workbook = what == "workbook";
    let kind = if is_workbook { Kind::Workbook } else { Kind::Report };
    page.write(py, (&path, Some(kind)), &made, || {
        let report = groups::page(&found.results, Path::new(&page.model), made.clone(), words);
        if is_workbook {
            write_workbook(&report.workbook(), &path)
        } else {
            dashpot_output::write(&path, report.render())
        }
    })
}

/// Writes the tests that a diagnosis proposes as a test matrix.
///
/// Returns the number of rows. If no proposed test is for a rig, returns 0 and writes nothing.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn write_next_tests(path: PathBuf, found: &Diagnosed, force: bool) -> PyResult<usize> {
    let Some((matrix, _)) = found.found.next_matrix() else { return Ok(0) };
    let files = found.campaign.get().read.files.iter().map(PathBuf::as_path);
    let written = as_a_run(force, files, || {
        dashpot_output::check([path.as_path()])?;
        dashpot_output::write(&path, &matrix)
    });
    written.map_err(raise::<OutputError>)?;
    Ok(matrix.lines().count() - 1)
}

/// Writes the tables of a fit as a workbook.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn write_fit(py: Python<'_>, path: PathBuf, page: Page, found: &Fitted) -> PyResult<()> {
    let words = page.words()?;
    let made = page.made(None, &found.about.files)?;
    page.write(py, (&path, Some(Kind::Workbook)), &made, || {
        let tables = dashpot_report::fit::workbook(
            (&found.fit, &found.over_whole_records),
            &found.about.unusable,
            [&page.model_file(), &page.data],
            made.clone(),
            words,
        );
        write_workbook(&tables, &path)
    })
}
