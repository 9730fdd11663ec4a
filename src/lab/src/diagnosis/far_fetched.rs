//! Whether the numbers of an effect are such as dampers and rigs show.

use super::deviations::by_noise;
use super::hypothesis::Hypothesis;
use super::refit::Refit;
use super::search::physical;
use super::vocabulary::Candidate;

/// Standard deviations by which the records must demand a number that no damper shows.
const DEMANDED: f64 = 2.0;

/// What the numbers of an effect say for it.
#[derive(Debug, Clone, Copy)]
pub struct Plausibility {
    /// Share of them that are inside what dampers and rigs show, or would be if the records did not leave them open.
    pub share: f64,
    /// Whether one of the others tells that it is another effect.
    pub contrary: bool,
}

/// Looks at an effect's numbers, which are those of the explanation from `first` on.
pub fn plausibility(candidate: &Candidate, first: usize, hypothesis: &Hypothesis, refit: &Refit) -> Plausibility {
    let deviations = by_noise(hypothesis, refit);
    let fine = |k: usize, (least, most): (f64, f64)| {
        let place = first + k;
        let (number, value, fresh) = (&hypothesis.numbers[place], refit.theta[place], &candidate.fresh[k]);
        let (low, high) = number.bounds;
        let margin = 1e-3 * (high - low).min(number.step);
        let open = DEMANDED * deviations[place];
        let at = |value: f64| physical(&fresh.free, value);
        let shown = at(value + open) >= least && at(value - open) <= most;
        // What may be however small may be as small as it goes; any other number would go on beyond its bound: it stands
        // for something else, where the records press it there.
        let outward = if value <= low + margin && least != 0.0 {
            -1.0
        } else if value >= high - margin && most.is_finite() {
            1.0
        } else {
            0.0
        };
        let slope = outward * refit.jacobian.column(place).dot(&refit.residual);
        let pressed = slope * deviations[place] > DEMANDED;
        !pressed && shown
    };
    let all = candidate.fresh.iter().enumerate();
    Plausibility {
        share: all.clone().filter(|(k, fresh)| fine(*k, fresh.plausible)).count() as f64
            / candidate.fresh.len().max(1) as f64,
        contrary: all.clone().any(|(k, fresh)| fresh.telling.is_some_and(|range| !fine(k, range))),
    }
}
