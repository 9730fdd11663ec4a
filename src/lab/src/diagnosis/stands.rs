//! Whether the names found stand.

use super::gap::{beyond_noise, errors, gap_closed, in_noise};
use super::hypothesis::Hypothesis;
use super::refit::Refit;
use super::samples::Test;
use super::search::Search;
use crate::records::Record;

/// Share of the excess that all names together must explain: names that leave more stand for something else.
const TOGETHER: f64 = 0.67;
/// The same of several names, of which one is there because of what another left.
const SEVERAL_TOGETHER: f64 = 0.8;
/// A smaller share will do where left-out tests are predicted so much better (mean fall of the logarithm of their error).
const LESS_TOGETHER: f64 = 0.5;
const PREDICTED: f64 = 1.0;
/// Free numbers from which an effect fits much by itself, and the share of the gap that it must close on left-out tests then.
const MANY: f64 = 3.0;
const MANY_CLOSED: f64 = 0.35;
/// Share of the gap there, where there is one, that names close at least.
const LEAST_CLOSED: f64 = 0.1;
/// Confidence below which a single name must close so much of the gap there.
const UNSURE: f64 = 0.8;
const UNSURE_CLOSED: f64 = 0.6;
/// Share of what the tests fitted show of the disagreement that left-out ones must show for that.
const SHOWN: f64 = 0.25;
/// Rise of the error on left-out tests at which names are taken back.
const HARM: f64 = 1.03;

/// Whether the names stand: together they explain enough, left-out tests do not suffer, and nothing without a name does as
/// well.
pub fn holds(found: &Search, records: &[&Record], fitted: &[Test], left: &[Test]) -> bool {
    if found.added.is_empty() {
        return true;
    }
    if found.may_have_no_name(fitted) {
        return false;
    }
    let tests = if left.is_empty() { fitted } else { left };
    let of = |(h, r): &(Hypothesis, Refit)| errors(h, &r.theta, records, tests);
    let (Some(before), Some(after)) = (of(&found.base), of(&found.last)) else { return false };
    if in_noise(tests, &after) > HARM * in_noise(tests, &before) {
        return false;
    }
    if let Some(closed) = if left.is_empty() { None } else { gap_closed(left, &before, &after) } {
        let Some(in_fitted) = errors(&found.base.0, &found.base.1.theta, records, fitted) else { return false };
        // Left-out tests that hardly show the disagreement say little of how much of it is closed: a stop that they do not
        // reach.
        let shown = beyond_noise(left, &before) >= SHOWN * beyond_noise(fitted, &in_fitted);
        let has_many = found.added.iter().any(|a| a.evidence.free >= MANY);
        let is_unsure = matches!(&found.added[..], [only] if only.confidence < UNSURE);
        let too_little =
            closed < LEAST_CLOSED || has_many && closed < MANY_CLOSED || is_unsure && closed < UNSURE_CLOSED;
        if shown && too_little {
            return false;
        }
    }
    let together = found.together(fitted);
    let needed = if found.added.len() > 1 { SEVERAL_TOGETHER } else { TOGETHER };
    let predicted = found.added.iter().map(|a| a.evidence.left_out_gain).sum::<f64>();
    together >= needed || (together >= LESS_TOGETHER && predicted >= PREDICTED)
}
