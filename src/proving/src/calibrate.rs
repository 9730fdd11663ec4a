//! What the probabilities of the rule of evidence are worth, from cases whose truth is known.
//!
//! A logistic in the two probabilities of the rule (each test counted as two independent samples, and as one), by maximum likelihood with
//! a prior that keeps it near the rule itself where cases are few; and the most that is claimed, from the names that the rule is surest of.

use nalgebra::{Matrix3, Vector3};
use serde_json::Value;

/// A name that was given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Given {
    /// Its probabilities by the rule, at two samples a test and at one.
    pub rule: [f64; 2],
    /// Whether it was right.
    pub right: bool,
    /// Whether there was a reference campaign.
    pub against_reference: bool,
}

impl Given {
    /// The names given in a case, from a line that an example has written.
    pub fn of(case: &Value) -> Vec<Given> {
        let list = |key: &str| case[key].as_array().cloned().unwrap_or_default();
        let hidden: Vec<String> =
            list("hidden").iter().filter_map(|h| Some(h[0].as_str()?.split(':').next()?.to_owned())).collect();
        let own = list("own");
        let against_reference = case["against_reference"].as_bool().unwrap_or(false);
        let one = |(name, rule): (&Value, &Value)| {
            let name = name[0].as_str()?;
            let rule = [rule[0].as_f64()?, rule[1].as_f64()?];
            // Without a reference the question is what the model lacks, not what is new: what the damper has by itself is a right answer.
            let right = hidden.iter().any(|h| h == name) || !against_reference && own.iter().any(|o| o == name);
            Some(Given { rule, right, against_reference })
        };
        list("named").iter().zip(&list("rule")).filter_map(one).collect()
    }
}

/// The numbers of `calibration.toml`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Calibration {
    /// Constant, weight at two samples, weight at one.
    pub weights: [f64; 3],
    /// Most that is claimed against a reference, with the names it comes from: right, of.
    pub against_reference: (f64, usize, usize),
    /// The same without one.
    pub alone: (f64, usize, usize),
}

/// Where the weights stay without cases, and how far, one standard deviation, cases few as they are may take them.
const USUAL: [f64; 3] = [0.6, 0.5, 0.5];
const SPREAD: [f64; 3] = [1.0, 0.3, 0.3];
/// Logarithm of the odds beyond which more is no surer; the same in the diagnosis.
const MOST: f64 = 8.0;
/// From this probability at one sample a test on the rule is as sure as it gets.
const SUREST: f64 = 0.9;
/// Newton's steps: the likelihood of a logistic has one top. A step of that length is none.
const STEPS: usize = 50;
const SETTLED: f64 = 1e-10;

fn row(given: &Given) -> Vector3<f64> {
    let odds = |p: f64| libm::log(p.max(1e-12) / (1.0 - p).max(1e-12)).clamp(-MOST, MOST);
    Vector3::new(1.0, odds(given.rule[0]), odds(given.rule[1]))
}

/// Share of right names: the middle of what the cases leave open before anything is known (Jeffreys).
fn share(names: &[&Given]) -> (f64, usize, usize) {
    let right = names.iter().filter(|g| g.right).count();
    ((right as f64 + 0.5) / (names.len() as f64 + 1.0), right, names.len())
}

/// Fits the numbers; `None` where no name was given.
pub fn fit(given: &[Given]) -> Option<Calibration> {
    if given.is_empty() {
        return None;
    }
    let surest = |against: bool| -> Vec<&Given> {
        given.iter().filter(|g| g.against_reference == against && g.rule[1] >= SUREST).collect()
    };
    let (against_reference, alone) = (share(&surest(true)), share(&surest(false)));
    let mut w = Vector3::from(USUAL);
    for _ in 0..STEPS {
        let (gradient, hessian) = slopes(given, &w);
        let mut step = hessian.cholesky()?.solve(&gradient);
        // Odds of eight where nothing is certain any more are flat, and a whole step from there lands anywhere.
        let here = log_likelihood(given, &w);
        while log_likelihood(given, &(w + step)) < here && step.norm() > SETTLED {
            step *= 0.5;
        }
        w += step;
        if step.norm() < SETTLED {
            break;
        }
    }
    Some(Calibration { weights: [w[0], w[1], w[2]], against_reference, alone })
}

/// Logarithm of the likelihood of weights, with what is usual of them.
fn log_likelihood(given: &[Given], w: &Vector3<f64>) -> f64 {
    let usual: f64 = (0..3).map(|i| ((w[i] - USUAL[i]) / SPREAD[i]).powi(2)).sum();
    let of = |g: &Given| -libm::log1p(libm::exp(if g.right { -w.dot(&row(g)) } else { w.dot(&row(g)) }));
    given.iter().map(of).sum::<f64>() - 0.5 * usual
}

/// Its gradient, and the negative of its second derivatives.
fn slopes(given: &[Given], w: &Vector3<f64>) -> (Vector3<f64>, Matrix3<f64>) {
    let mut gradient = Vector3::zeros();
    let mut hessian = Matrix3::zeros();
    for i in 0..3 {
        gradient[i] = (USUAL[i] - w[i]) / (SPREAD[i] * SPREAD[i]);
        hessian[(i, i)] = 1.0 / (SPREAD[i] * SPREAD[i]);
    }
    for g in given {
        let x = row(g);
        let p = 1.0 / (1.0 + libm::exp(-w.dot(&x)));
        gradient += x * (f64::from(u8::from(g.right)) - p);
        hessian += x * x.transpose() * (p * (1.0 - p));
    }
    (gradient, hessian)
}

impl Calibration {
    /// As the file that the diagnosis reads.
    pub fn text(&self, from: &str) -> String {
        let [constant, suspected, sure] = self.weights;
        let ((a, a_right, a_of), (b, b_right, b_of)) = (self.against_reference, self.alone);
        format!(
            "# Written by the example calibrate of dashpot-proving, from: {from}\n\n\
             # Weights of the logistic that turns the two probabilities of the rule of evidence into the confidence of a name.\n\
             constant = {constant:.3}\nsuspected = {suspected:.3}\nsure = {sure:.3}\n\n\
             # Most that is claimed: so many were right of the names that the rule is surest of, {a_right} of {a_of} against a reference\n\
             # campaign and {b_right} of {b_of} without one; the middle of what so few cases leave open.\n\
             surest_against_reference = {a:.2}\nsurest_alone = {b:.2}\n"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Names that are right as often as a known logistic says, spread evenly over the odds.
    fn names(weights: [f64; 3]) -> Vec<Given> {
        let mut all = Vec::new();
        for k in 0..40 {
            for j in 0..40 {
                let of = |k: i32| 1.0 / (1.0 + libm::exp(-(f64::from(k) - 20.0) / 5.0));
                let rule = [of(k), of(j)];
                let given = Given { rule, right: false, against_reference: k % 2 == 0 };
                let p = 1.0 / (1.0 + libm::exp(-Vector3::from(weights).dot(&row(&given))));
                for n in 0..20 {
                    all.push(Given { right: (f64::from(n) + 0.5) / 20.0 < p, ..given });
                }
            }
        }
        all
    }

    #[test]
    fn the_logistic_that_made_the_names_comes_back() {
        let wanted = [-0.4, 0.8, 0.3];
        let found = fit(&names(wanted)).unwrap();
        for (got, wanted) in found.weights.iter().zip(wanted) {
            assert!((got - wanted).abs() < 0.05, "{:?}", found.weights);
        }
        assert_eq!(fit(&[]), None);
    }

    #[test]
    fn what_the_damper_has_by_itself_is_a_right_answer_where_no_reference_tells_it_from_what_is_new() {
        let case = |against: bool| {
            serde_json::json!({
                "hidden": [["bushing:fractional", 1.0]], "own": ["aeration"], "against_reference": against,
                "named": [["aeration", 0.6], ["bushing", 0.6], ["free_play", 0.6]], "rule": [[0.9, 0.8], [0.9, 0.8], [0.9, 0.8]],
            })
        };
        let right = |against| Given::of(&case(against)).iter().map(|g| g.right).collect::<Vec<_>>();
        assert_eq!(right(false), [true, true, false]);
        assert_eq!(right(true), [false, true, false]);
    }

    #[test]
    fn the_weights_are_those_of_the_top_where_surest_names_are_wrong() {
        // Whole steps of Newton's method swing to and fro between the flat ends of this one.
        let name = |rule, right| Given { rule, right, against_reference: false };
        let mut given = vec![name([1.0, 1.0], true); 7];
        given.extend([name([1.0, 1.0], false); 7]);
        given.extend([name([0.9, 0.4], false), name([0.99, 0.8], true), name([0.7, 0.6], false)]);
        let found = fit(&given).unwrap();
        assert!(slopes(&given, &Vector3::from(found.weights)).0.norm() < 1e-6, "{:?}", found.weights);
        for ((w, usual), spread) in found.weights.iter().zip(USUAL).zip(SPREAD) {
            assert!((w - usual).abs() < 4.0 * spread, "{:?}", found.weights);
        }
    }

    #[test]
    fn few_cases_leave_it_near_the_rule_and_the_most_claimed_below_one() {
        let right = Given { rule: [0.99, 0.95], right: true, against_reference: false };
        let found = fit(&[right; 3]).unwrap();
        assert!((found.alone.0 - 3.5 / 4.0).abs() < 1e-12 && found.against_reference.0 == 0.5);
        for (got, usual) in found.weights.iter().zip(USUAL) {
            assert!((got - usual).abs() < 0.3, "{:?}", found.weights);
        }
    }
}
