//! Whether the numbers of an effect are such as dampers and rigs show.

use super::hypothesis::Hypothesis;
use super::refit::Refit;
use super::search::physical;
use super::vocabulary::Candidate;
use nalgebra::DMatrix;

/// Standard deviations by which the records must demand a number that no damper shows.
const DEMANDED: f64 = 2.0;

/// Standard deviations of the numbers of a refit, widened where more than noise is left.
pub fn deviations(hypothesis: &Hypothesis, refit: &Refit) -> Vec<f64> {
    let excess = (refit.chi2 / refit.residual.len().max(1) as f64).max(1.0).sqrt();
    by_noise(hypothesis, refit).into_iter().map(|d| excess * d).collect()
}

/// Standard deviations by noise alone.
fn by_noise(hypothesis: &Hypothesis, refit: &Refit) -> Vec<f64> {
    let mut normal = refit.jacobian.tr_mul(&refit.jacobian);
    let n = normal.nrows();
    for (i, number) in hypothesis.numbers.iter().enumerate() {
        normal[(i, i)] += 1e-12 / (number.step * number.step);
        if let Some((_, deviation)) = number.prior {
            normal[(i, i)] += 1.0 / (deviation * deviation);
        }
    }
    let scale: Vec<f64> = (0..n).map(|i| normal[(i, i)].sqrt().max(1e-150)).collect();
    let scaled = DMatrix::from_fn(n, n, |i, j| normal[(i, j)] / (scale[i] * scale[j]));
    match scaled.try_inverse() {
        Some(inverse) => (0..n).map(|i| inverse[(i, i)].max(0.0).sqrt() / scale[i]).collect(),
        None => vec![f64::INFINITY; n],
    }
}

/// Share of an effect's numbers that are inside what dampers and rigs show, or would be if the records did not leave them
/// open. Its numbers are the last of the explanation.
pub fn plausible(candidate: &Candidate, hypothesis: &Hypothesis, refit: &Refit) -> f64 {
    let first = hypothesis.numbers.len() - candidate.fresh.len();
    let deviations = by_noise(hypothesis, refit);
    let fine = candidate
        .fresh
        .iter()
        .enumerate()
        .filter(|(k, fresh)| {
            let place = first + k;
            let (number, value) = (&hypothesis.numbers[place], refit.theta[place]);
            let (low, high) = number.bounds;
            let margin = 1e-3 * (high - low).min(number.step);
            let (least, most) = fresh.plausible;
            let open = DEMANDED * deviations[place];
            let at = |value: f64| physical(&fresh.free, value);
            let shown = at(value + open) >= least && at(value - open) <= most;
            // What may be however small may be as small as it goes; any other number would go on beyond its bound: it stands
            // for something else, where the records press it there.
            let outward = if value <= low + margin && least != 0.0 {
                -1.0
            } else if value >= high - margin {
                1.0
            } else {
                0.0
            };
            let slope = outward * refit.jacobian.column(place).dot(&refit.residual);
            let pressed = slope * deviations[place] > DEMANDED;
            !pressed && shown
        })
        .count();
    fine as f64 / candidate.fresh.len().max(1) as f64
}
