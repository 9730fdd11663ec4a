//! All tested hypotheses, so that the reader can verify each finding.

use crate::blocks::{Block, Column, Section, Table};
use crate::cells::Cell;
use crate::words::Words;
use dashpot_diagnosis::Diagnosis;

/// Builds one table per iteration of the diagnosis. Returns `None` if no hypothesis was tested.
pub fn section(found: &Diagnosis, words: &Words) -> Option<Section> {
    let rounds: Vec<_> = found.iterations.iter().filter(|round| !round.is_empty()).collect();
    if rounds.is_empty() {
        return None;
    }
    let mut blocks = vec![Block::Paragraph(words.tried_about.to_owned())];
    for (k, round) in rounds.iter().enumerate() {
        // The first table begins with the findings, the effects that the diagnosis added. The other hypotheses were tested on the model
        // with the findings.
        let named = if k == 0 { found.findings.as_slice() } else { &[] };
        let named = named.iter().map(|f| (f.effect, f.form, f.confidence, &f.evidence));
        let rows = named
            .chain(round.iter().map(|t| (t.effect, t.form, t.confidence, &t.evidence)))
            .map(|(effect, form, confidence, e)| {
                vec![
                    words.named(effect).into(),
                    words.word(form).into(),
                    Cell::fraction(confidence),
                    Cell::fraction(e.fraction),
                    Cell::digits(e.mean_square_after.sqrt(), 3),
                    Cell::digits(e.log_odds, 3),
                    Cell::digits(e.negative_log_prior, 2),
                    Cell::fraction(e.tests_better),
                ]
            })
            .collect();
        let columns = vec![
            Column::words(words.col_effect),
            Column::words(words.col_form),
            Column::figures(words.col_probability),
            Column::figures(words.col_explains),
            Column::figures(words.col_error_left),
            Column::figures(words.col_log_odds),
            Column::figures(words.col_strange),
            Column::figures(words.col_tests_better),
        ];
        let caption = words.fill(words.look, &[("number", &(k + 1).to_string())]);
        blocks.push(Block::Table(Table { caption, columns, rows, sortable: true }));
    }
    Some(Section::new("tried", words.tried_section, blocks))
}
