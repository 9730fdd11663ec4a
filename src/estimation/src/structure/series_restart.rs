//! Restart of a series element with implausible parameters. Such an element is a spring and a damper between the moving
//! end and the valves. A fit produces such parameters to compensate for a missing effect, and they may remain after the
//! effect is added.
//!
//! A soft spring with a strong parallel damper acts as a damper in series. It shifts the FV curve by a velocity F/c_s,
//! with the force F and the damping c_s. The fitted curve compensates for the shift. The restart reverses both changes.

use super::evidence::{effective_count, noise_chi2};
use crate::hypothesis::{Free, Hypothesis};
use crate::refit::{Effort, Refit, refit};
use crate::samples::Test;
use crate::unknowns::{CurveName, Unknown, Unknowns};
use dashpot_core::curve::{Curve, Interpolation};
use dashpot_core::{element, list, number};
use dashpot_records::restrict;

/// Mean excess of χ² over that of noise, for each independent sample, below which the series element is not restarted.
const QUIET: f64 = 0.1;
/// Trial factors on the series stiffness.
const TIMES: [f64; 2] = [6.0, 1.0 / 6.0];
/// Deflection of a stiff series element under the largest force, as a fraction of the largest amplitude. An implausible
/// element is restarted with this deflection.
const STRAIGHT: f64 = 0.02;
/// Damping ratio of the internal mass on a restarted series element.
const RATIO: f64 = 0.2;
/// Largest excess of the cost over the best cost, after the first steps of a restart, at which the restart is
/// continued. It is a fraction of the excess of χ² over that of noise.
///
/// A restart replaces the best refit if its final cost is below the best cost by at least the fraction [`BETTER`] of
/// the same excess.
const NEAR: f64 = 0.5;
const BETTER: f64 = 0.02;

/// Damping ratio of the internal mass above which the series element no longer acts as a spring.
const DAMPED: f64 = 3.0;
/// Largest plausible deflection of the series element under the largest force, as a fraction of the largest
/// amplitude.
const YIELDS: f64 = 0.2;

/// Returns whether the series element is implausible for any damper.
///
/// In an implausible element, the damping carries the force instead of the spring, or the deflection is a large
/// fraction of the stroke.
pub fn has_implausible_series(hypothesis: &Hypothesis, tests: &[Test], theta: &[f64]) -> bool {
    let model = hypothesis.params(theta);
    if !model.is_on(element!("series_compliance")) {
        return false;
    }
    let stiffness = model.number(number!("series_stiffness"));
    let critical = 2.0 * (stiffness * model.number(number!("internal_mass"))).sqrt();
    let yields = most(tests, |t| t.segment.top) / stiffness;
    model.number(number!("series_damping")) > DAMPED * critical
        || yields > YIELDS * most(tests, |t| t.segment.amplitude)
}

fn most(tests: &[Test], of: fn(&Test) -> f64) -> f64 {
    tests.iter().map(of).fold(0.0, f64::max)
}

/// Restarts the refit from distant parameters of the series element and returns the best refit. A local search fails,
/// because the cost first increases on the way to the better parameters.
pub fn restart_series(hypothesis: &Hypothesis, tests: &[Test], refitted: Refit) -> Refit {
    let Some(stiffness) = place(hypothesis, Unknown::Log(number!("series_stiffness"))) else { return refitted };
    let (floor, quiet) = (noise_chi2(tests), QUIET * effective_count(tests));
    let mut best = refitted;
    let straight = has_implausible_series(hypothesis, tests, &best.theta).then_some(None);
    for times in straight.into_iter().chain(TIMES.map(Some)) {
        let excess = best.chi2 - floor;
        if excess < quiet {
            break;
        }
        let (start, first) = match times {
            None => (straightened(hypothesis, tests, &best.theta), Effort::COMPARE),
            Some(times) => {
                let mut start = best.theta.clone();
                start[stiffness] += libm::log(times);
                set_damping(hypothesis, &mut start);
                (start, Effort::SCREEN)
            }
        };
        let end = refit(hypothesis, tests, &start, None, first)
            .filter(|there| there.cost < best.cost + NEAR * excess)
            .and_then(|there| refit(hypothesis, tests, &there.theta, None, Effort::FINE))
            .filter(|there| there.cost < best.cost - BETTER * excess);
        if let Some(end) = end {
            best = end;
        }
    }
    best
}

fn place(hypothesis: &Hypothesis, unknown: Unknown) -> Option<usize> {
    hypothesis.position(&Free::Model(unknown))
}

/// Sets the series damping so that the internal mass has the damping ratio [`RATIO`].
fn set_damping(hypothesis: &Hypothesis, theta: &mut [f64]) {
    if let Some(damping) = place(hypothesis, Unknown::Linear(number!("series_damping"))) {
        let model = hypothesis.params(theta);
        theta[damping] =
            2.0 * RATIO * (model.number(number!("series_stiffness")) * model.number(number!("internal_mass"))).sqrt();
    }
}

/// Returns the parameters with a stiff series element. The FV curve then includes the velocity across the damper of the
/// old element.
fn straightened(hypothesis: &Hypothesis, tests: &[Test], theta: &[f64]) -> Vec<f64> {
    let mut model = hypothesis.params(theta);
    let mut start = theta.to_vec();
    if let Some(stiffness) = place(hypothesis, Unknown::Log(number!("series_stiffness"))) {
        let k = most(tests, |t| t.segment.top) / (STRAIGHT * most(tests, |t| t.segment.amplitude)).max(1e-9);
        let (low, high) = hypothesis.numbers[stiffness].bounds;
        start[stiffness] = restrict(libm::log(k), low, high);
    }
    set_damping(hypothesis, &mut start);
    let (velocity, force) = (model.list(list!("fv_velocity")).to_vec(), model.list(list!("fv_force")).to_vec());
    let per_force = 1.0 / model.number(number!("series_damping")).max(1e-9);
    let whole: Vec<f64> = velocity.iter().zip(&force).map(|(v, f)| v + f * per_force).collect();
    let Ok(curve) = Curve::new(&whole, &force, Interpolation::Linear) else { return start };
    let straight: Vec<f64> = velocity.iter().map(|v| curve.evaluate(*v).value).collect();
    // Interpolated forces stay within the range of the table. If the table rejected the list, the curve would stay
    // unchanged.
    let _ = model.set_list(list!("fv_force"), &straight);
    for (number, value) in hypothesis.numbers.iter().zip(&mut start) {
        if let Free::Model(rise @ Unknown::Rise { curve: CurveName::Fv, .. }) = &number.free {
            *value = Unknowns { base: model, list: vec![*rise] }.start()[0];
        }
    }
    start
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prior_set::PriorSet;
    use crate::sines::measured;
    use crate::vocabulary::base_numbers;
    use dashpot_core::Params;

    #[test]
    fn a_series_element_that_took_the_shape_of_something_else_is_found_again() {
        let base = Params::new();
        let truth = Hypothesis { base, numbers: base_numbers(&base), heating: None, priors: PriorSet::default() };
        let tests = measured(&truth, &[(0.001, 25.0), (0.01, 8.0), (0.03, 4.0), (0.03, 1.0)]);
        assert!(!has_implausible_series(&truth, &tests, &truth.start()));
        let place = |unknown| truth.position(&Free::Model(unknown)).unwrap();
        let (stiffness, damping) =
            (place(Unknown::Log(number!("series_stiffness"))), place(Unknown::Linear(number!("series_damping"))));
        let mut bent = truth.start();
        bent[stiffness] -= libm::log(40.0);
        bent[damping] = 2e4;
        assert!(has_implausible_series(&truth, &tests, &bent));
        let there = refit(&truth, &tests, &bent, None, Effort { steps: 0, ..Effort::SCREEN }).unwrap();
        let end = restart_series(&truth, &tests, there);
        assert!((end.theta[stiffness] - truth.start()[stiffness]).abs() < 0.02, "{}", end.theta[stiffness].exp());
    }

    #[test]
    fn put_straight_the_curve_takes_the_velocity_that_the_series_damper_took() {
        let base = Params::new();
        let of = Hypothesis { base, numbers: base_numbers(&base), heating: None, priors: PriorSet::default() };
        let tests = measured(&of, &[(0.03, 1.0)]);
        let damping = of.position(&Free::Model(Unknown::Linear(number!("series_damping")))).unwrap();
        let mut bent = of.start();
        bent[damping] = 8e3;
        let model = of.params(&straightened(&of, &tests, &bent));
        let valves =
            Curve::new(base.list(list!("fv_velocity")), base.list(list!("fv_force")), Interpolation::Linear).unwrap();
        for (v, force) in model.list(list!("fv_velocity")).iter().zip(model.list(list!("fv_force"))) {
            let left = valves.evaluate(v - force / 8e3).value;
            assert!((force - left).abs() < 1e-6 * left.abs().max(1.0), "{v}: {force}, the valves {left}");
        }
        let yields = tests[0].segment.top / model.number(number!("series_stiffness"));
        assert!((yields - STRAIGHT * 0.03).abs() < 1e-6, "{yields}");
    }
}
