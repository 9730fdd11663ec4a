//! Everything that was tried: nothing is named behind the reader's back.

use crate::report::blocks::{Block, Column, Section, Table};
use crate::report::numbers::{digits, share};
use dashpot_lab::diagnosis::Diagnosis;

/// One table per round; `None` where nothing was tried.
pub fn section(found: &Diagnosis) -> Option<Section> {
    let rounds: Vec<_> = found.rounds.iter().filter(|round| !round.is_empty()).collect();
    if rounds.is_empty() {
        return None;
    }
    let mut blocks = vec![Block::Paragraph(
        "In each round every candidate is added to the model, all numbers are refitted with it, and the best is kept if it \
         deserves it. Explains: share of what is beyond the noise. χ² and its fall after the price of the candidate's numbers \
         are in squares of the noise. Left-out gain: mean fall of the logarithm of a test's error when that test is left out \
         of the refit."
            .to_owned(),
    )];
    for (k, round) in rounds.iter().enumerate() {
        let rows = round
            .iter()
            .map(|t| {
                let e = &t.evidence;
                vec![
                    t.effect.to_owned(),
                    t.form.to_owned(),
                    share(t.confidence),
                    share(e.share),
                    digits(e.chi2_fall, 3),
                    digits(e.bic_fall, 3),
                    digits(e.left_out_gain, 2),
                    share(e.tests_better),
                    if e.plausible < 1.0 { "no".into() } else { "yes".into() },
                ]
            })
            .collect();
        let columns = vec![
            Column::words("effect"),
            Column::words("form"),
            Column::figures("confidence"),
            Column::figures("explains"),
            Column::figures("χ² falls by"),
            Column::figures("after its price"),
            Column::figures("left-out gain"),
            Column::figures("tests better"),
            Column::words("plausible numbers"),
        ];
        let kept = found.findings.get(k).map_or("nothing was added", |f| f.effect);
        let caption = match found.findings.get(k) {
            Some(_) => format!("Round {}: {kept} was added.", k + 1),
            None => format!("Round {}: {kept}.", k + 1),
        };
        blocks.push(Block::Table(Table { caption, columns, rows, sortable: true }));
    }
    Some(Section::new("tried", "Everything that was tried", blocks))
}
