//! Comparison of the model with models of the literature, separately for fitted tests and left-out tests.

use super::blocks::{Block, Column, Figure, Section, Table};
use crate::cells::Cell;
use crate::errors::three;
use crate::plot::of_test;
use crate::words::Words;
use dashpot_identification::literature::MODELS;
use dashpot_identification::validation::{Against, AgainstSummary, Compared, Validation};

/// A model of the literature and its force at the samples of every test.
#[derive(Debug, Clone)]
pub struct Rival {
    /// Name on the command line.
    pub name: &'static str,
    /// Force at every sample of every test, in the order of the tests, N.
    pub forces: Vec<Vec<f64>>,
}

impl Rival {
    /// Finds a model of the literature by its name. Returns `None` if no such model exists.
    pub fn named(name: &str, forces: Vec<Vec<f64>>) -> Option<Rival> {
        MODELS.iter().find(|model| model.0 == name).map(|model| Rival { name: model.0, forces })
    }
}

/// Builds the report section that compares the model with models of the literature. Returns `None` without models of
/// the literature.
pub fn section(validation: &Validation, tests: &[Compared<'_>], rivals: &[Rival], words: &Words) -> Option<Section> {
    if validation.against.is_empty() {
        return None;
    }
    let about = words.against_about.to_owned();
    let mut blocks = vec![Block::Paragraph(about), Block::Table(table(&validation.against, words))];
    for (left_out, heading) in [(true, words.left_out_of_fit), (false, words.used_in_fit)] {
        let Some(place) = hardest(validation, !left_out) else { continue };
        blocks.push(Block::Heading(format!("{}, {heading}", validation.tests[place].name)));
        let figure = |(k, rival): (usize, &Rival)| {
            let kind = if left_out { "left-out" } else { "fitted" };
            let svg = of_test::force_velocity_against(&tests[place], rival.name, &rival.forces[place], words);
            Figure::new(format!("against-{}-{}-{kind}", k + 1, rival.name), svg)
        };
        blocks.push(Block::Figures(rivals.iter().enumerate().map(figure).collect()));
    }
    Some(Section::new("against", words.against_section, blocks))
}

/// Finds the index of the test with the largest relative error of the validated model. Searches the fitted tests if
/// `used` is true, and the left-out tests otherwise. Returns `None` if there are no such tests.
fn hardest(validation: &Validation, used: bool) -> Option<usize> {
    let tests = &validation.tests;
    (0..tests.len())
        .filter(|k| tests[*k].used_in_fit == used)
        .max_by(|a, b| tests[*a].errors.model.error_percent.total_cmp(&tests[*b].errors.model.error_percent))
}

fn table(against: &[Against], words: &Words) -> Table {
    let figures = |summary: Option<&AgainstSummary>| match summary {
        Some(s) => three(&s.errors),
        None => ["", "", ""].map(Cell::from),
    };
    let row = |one: &Against| {
        let mut row = vec![Cell::from(one.model.as_str()), one.meaning.as_str().into()];
        row.extend(figures(one.used_in_fit.as_ref()));
        row.extend(figures(one.left_out.as_ref()));
        row
    };
    let columns_of = |group| {
        [words.col_mean_error, words.col_error_percent, words.col_rms]
            .map(|heading| Column::figures(heading).in_group(group))
    };
    let mut columns = vec![Column::words(words.col_model), Column::words(words.col_meaning)];
    columns.extend(columns_of(words.used_in_fit));
    columns.extend(columns_of(words.left_out_of_fit));
    Table {
        caption: words.against_caption.to_owned(),
        columns,
        rows: against.iter().map(row).collect(),
        sortable: true,
    }
}
