//! The report of a diagnosis: verdict, missing effects, and residual forces of the model.
//!
//! | file | section |
//! |---|---|
//! | [`answer`] | the verdict, and the error of every test before and after the diagnosis |
//! | [`crate::inventory`] | every effect of the model with its force |
//! | [`both_curves`] | FV curves of the damper and the reference |
//! | [`findings`] | the added effects with parameters, intervals and alternatives |
//! | [`loops`] | force loops of the tests on which model and measurement differ most |
//! | [`limits`] | effects that the records cannot show, tests that would resolve open questions, and remarks |
//! | [`places`] | regions of velocity and displacement with large residuals, as text, figures and maps |
//! | [`matrix`] | errors by amplitude and peak velocity, before and after the diagnosis |
//! | [`tried`] | all tested hypotheses, by iteration |
//! | [`over_settings`] | one damper diagnosed at several settings |
//!
//! The brief print consists of the first six rows. From [`loops`], it includes only the worst test, and from
//! [`limits`], it omits the remarks.

mod answer;
mod both_curves;
mod findings;
mod limits;
mod loops;
mod matrix;
mod over_settings;
mod places;
mod tried;

pub use answer::{headline, picture};
pub use findings::changed_name;
pub use over_settings::SettingsReport;

use super::page::{self, Print};
use super::{Block, Made, ParameterRow, Section, Workbook, made, parameters, write_figures, write_page};
use crate::inventory;
use crate::whole_records;
use crate::words::Words;
use dashpot_diagnosis::Diagnosis;
use dashpot_records::Record;
use dashpot_simulation::whole_records::OfDiagnosis;
use std::path::{Path, PathBuf};

/// Contents of the report of a diagnosis.
#[derive(Debug, Clone)]
pub struct DiagnosisReport<'a> {
    /// Name of the diagnosed model file.
    pub model_file: String,
    /// Files or folders of the records, as named in the subtitle.
    pub data: String,
    /// Result of the diagnosis.
    pub found: &'a Diagnosis,
    /// The records, from which the error matrix uses the motion of each test.
    pub records: &'a [&'a Record],
    /// Remarks from reading the records: the detected sign convention, and notes of the cleaning.
    pub reading: Vec<String>,
    /// Errors of the given, the refitted and the improved model over whole records, as `dashpot validate` reports them.
    pub over_whole_records: OfDiagnosis,
    /// Parameters of the improved model.
    pub parameters: Vec<ParameterRow>,
    /// Origin of the report.
    pub made: Made,
    /// Extent of the printed report.
    pub print: Print,
    /// Texts in the language of the report.
    pub words: &'static Words,
}

impl DiagnosisReport<'_> {
    /// Renders the report as one HTML document. Equal input gives equal bytes.
    pub fn render(&self) -> String {
        let [title, subtitle] = self.titles();
        page::page(&title, &subtitle, &self.sections(), self.words, self.print)
    }

    /// Returns the tables of the report as a workbook.
    pub fn workbook(&self) -> Workbook<'_> {
        let [title, subtitle] = self.titles();
        Workbook { title, subtitle, sections: self.sections(), made: self.made.clone(), words: self.words }
    }

    fn titles(&self) -> [String; 2] {
        let subtitle =
            self.words.fill(self.words.subtitle_validation, &[("model", &self.model_file), ("data", &self.data)]);
        [self.words.diagnosis_title.to_owned(), subtitle]
    }

    /// Writes the report. An older report is replaced only when the new report is complete.
    ///
    /// # Errors
    /// The folder does not exist or is not writable. The older report then stays.
    pub fn write(&self, path: &Path) -> anyhow::Result<()> {
        write_page(&self.render(), path)
    }

    /// Writes every figure as a file into a folder, and creates the folder if it is missing.
    ///
    /// # Errors
    /// The folder or a file is not writable.
    pub fn write_svgs(&self, folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
        write_figures(&self.sections(), folder)
    }

    fn sections(&self) -> Vec<Section> {
        let (found, words) = (self.found, self.words);
        let mut sections = vec![answer::section(found, words)];
        let other = whole_records::of_another_damper(&self.over_whole_records, words);
        // After the headline, before the figures that follow from the refit.
        sections[0].blocks.splice(1..1, other.map(Block::Warning));
        sections[0].blocks.push(Block::Paragraph(whole_records::format_errors(&self.over_whole_records, words)));
        sections.extend(inventory::section(&found.inventory, &found.tests, words));
        sections.extend(findings::section(found, words));
        sections.extend(loops::sections(found, words));
        sections.push(limits::section(found, words));
        sections.extend(limits::remarks(found, &self.reading, words).map(Section::beyond));
        sections.push(places::section(found, words).beyond());
        sections.extend(matrix::section(found, self.records, words).map(Section::beyond));
        sections.extend(tried::section(found, words).map(Section::beyond));
        sections.extend(parameters::section(&self.parameters, words).map(Section::beyond));
        sections.push(made::section(&self.made, words).beyond());
        sections
    }
}

/// Capitalizes the first letter of a text. The name of a parameter stays unchanged.
fn capital(text: &str) -> String {
    if text.split_whitespace().next().is_some_and(|first| first.contains('_')) {
        return text.to_owned();
    }
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
