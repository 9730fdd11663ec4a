//! The report of an adjustable damper: curves, errors and loops, in this order. The sections of the ordinary validation report follow,
//! collapsed.
//!
//! | module | contents |
//! |---|---|
//! | [`curves`] | FV curves by setting, force over velocity and setting, ratio of two settings |
//! | [`numbers`] | parameters over the setting with their intervals |
//! | [`errors`] | errors at each setting |
//! | [`responses`] | responses to steps of the setting, the actuator, hysteresis over the setting |
//! | [`loops`] | loops of selected tests |

mod curves;
pub mod errors;
mod loops;
mod numbers;
mod responses;

use crate::blocks::{Block, Figure, Section};
use crate::words::Words;
use dashpot_core::family::Definition;
use dashpot_identification::family::FamilyFit;
use dashpot_identification::model_file::ModelFile;
use dashpot_identification::validation::{Compared, SettingSummary, Validation};
use dashpot_records::setting_in_words;

/// Input of the report of an adjustable damper, in addition to its validation.
#[derive(Debug, Clone, Copy)]
pub struct FamilyReport<'a> {
    /// The model file.
    pub model: &'a ModelFile,
    /// The fit of the damper over the setting, if this run included a fit.
    pub fit: Option<&'a FamilyFit>,
}

impl FamilyReport<'_> {
    /// Builds warnings about tests whose forces contradict their settings. They belong to the answer, because such tests bias the model.
    ///
    /// Warnings of a fit replace those of the validation. The fitted model is biased toward the forces of such tests, so its errors show
    /// them less clearly.
    pub fn doubts(self, validation: &Validation, words: &Words) -> Vec<Block> {
        let unit = self.model.axis.unit();
        let of_fit: Vec<String> =
            self.fit.iter().flat_map(|fit| &fit.label_doubts).map(|note| words.say(note)).collect();
        let of_validation = validation.setting_doubts.iter().map(|doubt| words.say(&doubt.sentence(unit)));
        let doubts = if of_fit.is_empty() { of_validation.collect() } else { of_fit };
        doubts.into_iter().map(Block::Warning).collect()
    }

    /// Builds the sections with which the report of an adjustable damper begins.
    pub fn sections(self, validation: &Validation, tests: &[Compared<'_>], words: &Words) -> Vec<Section> {
        let damper = self.model.definition();
        let mut first: Vec<Block> =
            curves::by_setting(&damper, validation, words).map(Block::Wide).into_iter().collect();
        first.push(Block::Paragraph(words.family_about.to_owned()));
        first.extend(self.fit.map(|fit| Block::Paragraph(errors::between(fit, words))));
        let mut second: Vec<Figure> = curves::over_both(&damper, validation, words).into_iter().collect();
        second.extend(curves::over_setting(&damper, validation, words));
        second.extend(numbers::figures(self.model, words));
        if !second.is_empty() {
            first.push(Block::Figures(second));
        }
        let mut sections = vec![Section::new("setting", words.family_section, first)];
        sections.extend(responses::section(self, &damper, validation, words));
        let mut tables: Vec<Block> = vec![Block::Table(errors::validated(&damper, validation, words))];
        tables.extend(self.fit.map(|fit| Block::Table(errors::left_out(&damper, fit, words))));
        sections.push(Section::new("setting-errors", words.family_errors_section, tables));
        sections.extend(loops::section(&damper, validation, tests, words));
        sections
    }

    /// Builds the tables of parameters with intervals, of their dependence on the setting, and of the force of every effect. Returns `None`
    /// if all tables are empty.
    pub fn tables(self, words: &Words) -> Option<Section> {
        let mut blocks: Vec<Block> = numbers::table(self.model, words).map(Block::Table).into_iter().collect();
        blocks.extend(self.fit.map(|fit| Block::Table(numbers::dependences(fit, words))));
        blocks.extend(self.fit.and_then(|fit| numbers::effects(self.model, fit, words)).map(Block::Table));
        (!blocks.is_empty()).then(|| Section::new("setting-numbers", words.family_numbers_section, blocks))
    }
}

/// Returns the name of the setting, or a generic word if the model file contains no name.
fn axis_name<'a>(damper: &'a Definition, words: &'a Words) -> &'a str {
    let name = damper.axis.name();
    if name.is_empty() { words.col_setting } else { words.word(name) }
}

/// Formats the title of a plot axis that shows the setting, with its unit.
fn axis_title(damper: &Definition, words: &Words) -> String {
    let unit = damper.axis.unit();
    format!("{}, {}", axis_name(damper, words), if unit.is_empty() { "-" } else { unit })
}

/// Formats a value of the setting with its unit.
fn named(damper: &Definition, setting: f64, words: &Words) -> String {
    words.number(&setting_in_words(setting, damper.axis.unit()))
}

/// Formats a setting of the tests. A note marks a setting that is not in the model file's grid.
fn named_summary(damper: &Definition, of: &SettingSummary, words: &Words) -> String {
    let name = named(damper, of.setting, words);
    let (low, high) = damper.axis.range();
    match of.is_of_grid {
        true => name,
        false if of.setting < low || of.setting > high => words.fill(words.family_clamped, &[("setting", &name)]),
        false => words.fill(words.family_interpolated, &[("setting", &name)]),
    }
}
