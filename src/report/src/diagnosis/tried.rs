//! Everything that was tried: nothing is named behind the reader's back.

use crate::blocks::{Block, Column, Section, Table};
use crate::cells::Cell;
use dashpot_diagnosis::Diagnosis;

/// One table per round; `None` where nothing was tried.
pub fn section(found: &Diagnosis) -> Option<Section> {
    let rounds: Vec<_> = found.rounds.iter().filter(|round| !round.is_empty()).collect();
    if rounds.is_empty() {
        return None;
    }
    let mut blocks = vec![Block::Paragraph(
        "In each look every form of every effect is added to the model and all numbers are refitted with it, from several \
         starts. Explains: share of the mean square beyond the noise. Error left: mean over the tests, in units of what noise and \
         the form of curves leave. Log odds: how many more times the records are likely with it, as a natural logarithm, each test \
         counted as one independent sample and its numbers paid for. Strange numbers: what values that dampers hardly show cost it, \
         in the same units. Probability is that of the effect, over all its forms."
            .to_owned(),
    )];
    for (k, round) in rounds.iter().enumerate() {
        let rows = round
            .iter()
            .map(|t| {
                let e = &t.evidence;
                vec![
                    t.effect.into(),
                    t.form.into(),
                    Cell::share(t.confidence),
                    Cell::share(e.share),
                    Cell::digits(e.mean_square_after.sqrt(), 3),
                    Cell::digits(e.log_odds, 3),
                    Cell::digits(e.implausibility, 2),
                    Cell::share(e.tests_better),
                ]
            })
            .collect();
        let columns = vec![
            Column::words("effect"),
            Column::words("form"),
            Column::figures("probability"),
            Column::figures("explains"),
            Column::figures("error left"),
            Column::figures("log odds"),
            Column::figures("strange numbers"),
            Column::figures("tests better"),
        ];
        let caption = format!("Look {}.", k + 1);
        blocks.push(Block::Table(Table { caption, columns, rows, sortable: true }));
    }
    Some(Section::new("tried", "Everything that was tried", blocks))
}
