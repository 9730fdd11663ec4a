//! The report of a diagnosis: the answer, where model and records disagree, what is missing, and what is left.
//!
//! | file | section |
//! |---|---|
//! | [`answer`] | the verdict, the error before and after, test by test |
//! | [`inventory`](crate::inventory) | every effect of the model with its force |
//! | [`both_curves`] | FV curves of the damper and of the reference |
//! | [`findings`] | what was added, with numbers, intervals and rivals |
//! | [`loops`] | loops of the tests with the largest disagreement |
//! | [`limits`] | what these records cannot show, and the tests that would; what was noticed |
//! | [`places`] | where they disagree, in words, figures and maps |
//! | [`matrix`] | errors by amplitude and peak velocity, before and after |
//! | [`tried`] | everything that was tried, round by round |
//! | [`over_settings`] | one damper diagnosed at several settings |
//!
//! The first five, with the worst test's loops alone, are what is printed in short.

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

/// Everything the report of a diagnosis tells.
#[derive(Debug, Clone)]
pub struct DiagnosisReport<'a> {
    /// Name of the model file diagnosed.
    pub model_file: String,
    /// Name of the data.
    pub data: String,
    /// What was found.
    pub found: &'a Diagnosis,
    /// The records, which say how each test moved.
    pub records: &'a [&'a Record],
    /// Remarks on reading: the sign that was worked out, what cleaning noticed.
    pub reading: Vec<String>,
    /// What `dashpot validate` says of the models in it.
    pub over_whole_records: OfDiagnosis,
    /// Parameters of the improved model.
    pub parameters: Vec<ParameterRow>,
    /// What it was made from.
    pub made: Made,
    /// What a printer puts on paper.
    pub print: Print,
    /// The language.
    pub words: &'static Words,
}

impl DiagnosisReport<'_> {
    /// The report as one HTML document; the same input gives the same bytes.
    pub fn render(&self) -> String {
        let [title, subtitle] = self.titles();
        page::page(&title, &subtitle, &self.sections(), self.words, self.print)
    }

    /// The tables of the report as a workbook.
    pub fn workbook(&self) -> Workbook<'_> {
        let [title, subtitle] = self.titles();
        Workbook { title, subtitle, sections: self.sections(), made: self.made.clone(), words: self.words }
    }

    fn titles(&self) -> [String; 2] {
        let subtitle =
            self.words.fill(self.words.subtitle_validation, &[("model", &self.model_file), ("data", &self.data)]);
        [self.words.diagnosis_title.to_owned(), subtitle]
    }

    /// Writes the report, replacing an older one only when the new one is complete.
    ///
    /// # Errors
    /// When the folder does not exist or cannot be written; the older report then stays.
    pub fn write(&self, path: &Path) -> anyhow::Result<()> {
        write_page(&self.render(), path)
    }

    /// Writes every figure as a file of its own into a folder, which is made if missing.
    ///
    /// # Errors
    /// When the folder or a file cannot be written.
    pub fn write_svgs(&self, folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
        write_figures(&self.sections(), folder)
    }

    fn sections(&self) -> Vec<Section> {
        let (found, words) = (self.found, self.words);
        let mut sections = vec![answer::section(found, words)];
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

/// A text that begins a sentence. A parameter stays as the model file writes it.
fn capital(text: &str) -> String {
    if text.split_whitespace().next().is_some_and(|first| first.contains('_')) {
        return text.to_owned();
    }
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
