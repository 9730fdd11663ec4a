//! Force loops of the fitted and left-out tests on which model and measurement differ most.

use crate::blocks::{Block, Figure, Section};
use crate::numbers::{closed_gap, digits};
use crate::plot::before_after;
use crate::words::Words;
use dashpot_diagnosis::{Diagnosis, TestOutcome};

/// Largest number of fitted tests, and of left-out tests, whose loops are shown.
const SHOWN: usize = 3;

/// Builds two sections: the loops of the test with the largest gap between error and noise, and the loops of further tests. The brief print
/// includes only the first section. The first section shows a left-out test, or a fitted test if no test was left out.
pub fn sections(found: &Diagnosis, words: &Words) -> Vec<Section> {
    let names = before_after::names(&found.tests, words);
    let of = |held_out: bool| worst(&found.tests, held_out).into_iter().take(SHOWN);
    let mut places = of(true).chain(of(false));
    let blocks = |place: usize| {
        let test = &found.tests[place];
        let kind = if test.left_out { words.kind_left_out } else { words.kind_fitted };
        let figure = |kind: &str, svg: String| Figure::new(format!("{:03}-{kind}", place + 1), svg);
        let figures = vec![
            figure("force-velocity", before_after::force_velocity(test, words)),
            figure("force-displacement", before_after::force_displacement(test, words)),
            figure("residual-velocity", before_after::residual_velocity(test, words)),
        ];
        let heading = words.fill(words.loop_heading, &[("kind", kind), ("test", &names[place])]);
        [Block::Heading(heading), Block::Paragraph(in_words(test, words)), Block::Figures(figures)]
    };
    let Some(first) = places.next() else { return Vec::new() };
    let about = Block::Paragraph(words.loops_about.to_owned());
    let worst = std::iter::once(about).chain(blocks(first)).collect();
    let mut sections = vec![Section::new("loops", words.loops_section, worst)];
    let others: Vec<Block> = places.flat_map(blocks).collect();
    if !others.is_empty() {
        sections.push(Section::new("more-loops", words.more_loops_section, others).beyond());
    }
    sections
}

/// Finds the left-out (`held_out`) or fitted test with the largest gap between error and noise relative to its largest force. Prefers tests
/// with cycles.
pub fn largest(tests: &[TestOutcome], held_out: bool) -> Option<&TestOutcome> {
    worst(tests, held_out).first().map(|place| &tests[*place])
}

/// Sorts the indices of the left-out or fitted tests by the gap between error and noise, largest first. The gap is relative to the test's
/// largest force. Tests without cycles come last, because their loops are unreadable. Tests without finite errors are omitted.
fn worst(tests: &[TestOutcome], held_out: bool) -> Vec<usize> {
    let gap = |test: &TestOutcome| {
        let top = test.curves.measured.iter().fold(0.0_f64, |top, f| top.max(f.abs()));
        (test.before_rmse_n - test.noise_n) / top
    };
    let whole = |t: &TestOutcome| {
        t.before_rmse_n.is_finite() && t.after_rmse_n.is_finite() && t.curves.measured.len() > 1 && gap(t).is_finite()
    };
    let mut places: Vec<usize> =
        (0..tests.len()).filter(|k| tests[*k].left_out == held_out && whole(&tests[*k])).collect();
    let cyclic = |k: usize| tests[k].curves.frequency > 0.0;
    places.sort_by(|a, b| cyclic(*b).cmp(&cyclic(*a)).then(gap(&tests[*b]).total_cmp(&gap(&tests[*a]))).then(a.cmp(b)));
    places
}

fn in_words(test: &TestOutcome, words: &Words) -> String {
    let gap = test.before_rmse_n - test.noise_n;
    let closed = if gap > 0.0 {
        let (gap, is_closed) = closed_gap((test.before_rmse_n - test.after_rmse_n) / gap);
        words.fill(if is_closed { words.loop_closed } else { words.loop_grown }, &[("gap", &gap)])
    } else {
        String::new()
    };
    let [before, after, noise] = [test.before_rmse_n, test.after_rmse_n, test.noise_n].map(|n| digits(n, 3));
    words.fill(words.loop_errors, &[("before", &before), ("after", &after), ("noise", &noise), ("closed", &closed)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::before_after::tests::outcome;
    use crate::words::EN;

    #[test]
    fn the_largest_gap_comes_first_and_what_has_no_answer_is_passed_over() {
        let mut large = outcome("large", false);
        large.before_rmse_n = 40.0;
        let mut lost = outcome("lost", false);
        lost.after_rmse_n = f64::NAN;
        let mut road = large.clone();
        road.curves.frequency = 0.0;
        let tests = [outcome("a", false), lost, large, outcome("out", true), road];
        assert_eq!(worst(&tests, false), [2, 0, 4]);
        assert_eq!(largest(&tests, true).unwrap().test, "out");
        assert!(largest(&tests[..1], true).is_none());
        let told = in_words(&tests[0], &EN);
        assert!(told.contains("97\u{a0}% of the gap"), "{told}");
    }
}
