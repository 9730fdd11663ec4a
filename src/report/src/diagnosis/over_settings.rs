//! The report of one damper diagnosed at several settings: tables over the settings, then a collapsed part for each setting.

use super::DiagnosisReport;
use crate::blocks::{Block, Column, Figure, Section, Table};
use crate::inventory::probability;
use crate::numbers::error;
use crate::page::{self, Print};
use crate::words::Words;
use crate::{Cell, Made, Workbook, made};
use dashpot_diagnosis::settings::{
    ChangeAtSetting, ChangeOverSettings, EffectAtSetting, EffectOverSettings, OverSettings, is_shown,
};
use dashpot_records::setting_in_words;

/// Contents of the report of a diagnosis at several settings.
#[derive(Debug, Clone)]
pub struct SettingsReport<'a> {
    /// Name of the diagnosed model file.
    pub model_file: String,
    /// Files or folders of the records, as named in the subtitle.
    pub data: String,
    /// Unit of the setting, such as A.
    pub unit: String,
    /// Effects and changed parameters at each setting, combined over all settings.
    pub over: &'a OverSettings,
    /// Value and report of each setting.
    pub settings: Vec<(f64, DiagnosisReport<'a>)>,
    /// Origin of the report.
    pub made: Made,
    /// Extent of the printed report.
    pub print: Print,
    /// Texts in the language of the report.
    pub words: &'static Words,
}

impl SettingsReport<'_> {
    /// Renders the report as one HTML document. Equal input gives equal bytes.
    pub fn render(&self) -> String {
        page::page(self.words.diagnosis_title, &self.subtitle(), &self.sections(), self.words, self.print)
    }

    /// Returns the tables of the report as a workbook.
    pub fn workbook(&self) -> Workbook<'_> {
        Workbook {
            title: self.words.diagnosis_title.to_owned(),
            subtitle: self.subtitle(),
            sections: self.sections(),
            made: self.made.clone(),
            words: self.words,
        }
    }

    fn subtitle(&self) -> String {
        let figures = [("model", self.model_file.as_str()), ("data", &self.data)];
        self.words.fill(self.words.subtitle_validation, &figures)
    }

    fn named(&self, setting: f64) -> String {
        self.words.number(&setting_in_words(setting, &self.unit))
    }

    fn sections(&self) -> Vec<Section> {
        let words = self.words;
        let mut first: Vec<Block> =
            self.over.summary.iter().map(|said| Block::Lead(super::answer::sentence(said, words))).collect();
        if !self.over.changes.is_empty() {
            first.push(Block::Table(self.changes()));
        }
        if !self.over.effects.is_empty() {
            first.push(Block::Table(self.table()));
        }
        first.push(Block::Table(self.answers()));
        let mut sections = vec![Section::new("settings", words.settings_section, first)];
        for (k, (setting, report)) in self.settings.iter().enumerate() {
            sections.push(merged(&format!("setting-{}", k + 1), self.named(*setting), report.sections()).folded());
        }
        sections.push(made::section(&self.made, words));
        sections
    }

    /// Joins pairs of a setting and a text, one pair per setting, to the text of one table cell.
    fn each(&self, all: impl Iterator<Item = (f64, String)>) -> String {
        let all: Vec<String> = all.map(|(setting, text)| format!("{}: {text}", self.named(setting))).collect();
        all.join(self.words.comma)
    }

    /// Builds a table with one row per effect.
    fn table(&self) -> Table {
        let words = self.words;
        let each = |of: &EffectOverSettings, write: &dyn Fn(&EffectAtSetting) -> String| {
            self.each(of.settings.iter().map(|at| (at.setting, write(at))))
        };
        let row = |of: &EffectOverSettings| -> Vec<Cell> {
            let at = of.settings.iter().filter(|at| is_shown(at.status)).map(|at| self.named(at.setting));
            let at = match of.at_all_settings {
                true => words.settings_all.to_owned(),
                false => at.collect::<Vec<_>>().join(words.comma),
            };
            vec![
                words.named(of.effect).into(),
                match () {
                    () if of.is_found => words.status_added.into(),
                    () if of.is_added() => words.status_added_unnamed.into(),
                    () if at.is_empty() => words.status_removed.into(),
                    () => words.status_kept.into(),
                },
                if at.is_empty() { Cell::none() } else { at.into() },
                each(of, &|at| words.number(&probability(at.probability))).into(),
                each(of, &|at| words.number(&error(at.force_n_rms))).into(),
            ]
        };
        Table {
            caption: words.settings_caption.to_owned(),
            columns: vec![
                Column::words(words.col_effect),
                Column::words(words.col_status),
                Column::sentences(words.col_setting),
                Column::sentences(words.col_probability),
                Column::sentences(words.col_force_rms),
            ],
            rows: self.over.effects.iter().map(row).collect(),
            sortable: true,
        }
    }

    /// Builds a table with one row for each parameter that differs from the reference model.
    fn changes(&self) -> Table {
        let words = self.words;
        let each = |of: &ChangeOverSettings, write: &dyn Fn(&ChangeAtSetting) -> String| {
            self.each(of.settings.iter().map(|at| (at.setting, write(at))))
        };
        let row = |of: &ChangeOverSettings| -> Vec<Cell> {
            vec![
                words.named(of.name).into(),
                each(of, &|at| words.say(&at.change.sentence())).into(),
                each(of, &|at| words.number(&probability(at.change.probability))).into(),
                each(of, &|at| words.number(&error(at.change.force_n_rms))).into(),
            ]
        };
        Table {
            caption: words.settings_changes.to_owned(),
            columns: vec![
                Column::words(words.col_change),
                Column::sentences(words.col_setting),
                Column::sentences(words.col_probability),
                Column::sentences(words.col_force_rms),
            ],
            rows: self.over.changes.iter().map(row).collect(),
            sortable: true,
        }
    }

    /// Builds a table with the verdict at each setting.
    fn answers(&self) -> Table {
        let words = self.words;
        let row = |(setting, report): &(f64, DiagnosisReport<'_>)| -> Vec<Cell> {
            let found = report.found;
            vec![
                self.named(*setting).into(),
                Cell::count(report.records.len()),
                super::headline(found, words).into(),
                Cell::digits(found.before.rmse_n, 3),
                Cell::digits(found.after.rmse_n, 3),
                Cell::digits(found.before.noise_n, 3),
            ]
        };
        Table {
            caption: words.settings_answers.to_owned(),
            columns: vec![
                Column::words(words.col_setting),
                Column::figures(words.col_tests),
                Column::sentences(words.col_answer),
                Column::figures(words.col_before_n),
                Column::figures(words.col_after_n),
                Column::figures(words.col_group_noise),
            ],
            rows: self.settings.iter().map(row).collect(),
            sortable: false,
        }
    }
}

/// Merges the sections of the report of one setting into one section, and prefixes the file names of its figures with `id`.
fn merged(id: &str, title: String, sections: Vec<Section>) -> Section {
    let renamed = |figure: Figure| Figure { file: format!("{id}-{}", figure.file), ..figure };
    let own = |block: Block| match block {
        Block::Figures(figures) => Block::Figures(figures.into_iter().map(renamed).collect()),
        Block::Wide(figure) => Block::Wide(renamed(figure)),
        other => other,
    };
    let mut blocks = Vec::new();
    // The section on the origin appears only once in the whole report.
    for section in sections.into_iter().filter(|section| section.id != made::ID) {
        blocks.push(Block::Heading(section.title));
        blocks.extend(section.blocks.into_iter().map(own));
        for choice in section.choices {
            blocks.push(Block::Heading(choice.title));
            blocks.extend(choice.blocks.into_iter().map(own));
        }
    }
    Section::new(id, title, blocks)
}
