//! What is usual of the shape of a force–velocity curve: it bends, but it does not jump from steep to level and back.
//!
//! Bleed, shims and blow-off each take the force over gradually: beside a curve of half a power, the rise of the force from one point
//! to the next changes by a factor of two or so, not by ten. Where tests are dense that says nothing beside them; where they are few, at the
//! fast end above all, it keeps a curve from ending in a plateau that one test's noise made, and near standstill from taking what is dry
//! friction.

use crate::unknowns::{CurveName, Unknown, Unknowns, anchor, towards_zero};
use nalgebra::DMatrix;

/// How the force of a usual curve goes with the velocity: an orifice would have 2, a spring valve 1 to 0, so that half a power
/// lies between (Dixon 2007, chapter 6).
const POWER: f64 = 0.5;
/// Standard deviation of the logarithm of the ratio of two neighbouring rises, beside that power: a knee from bleed to
/// blow-off brings 1 to 1.5, most neighbours much less. Smaller values round real knees off where tests are few.
const SPREAD: f64 = 0.8;

/// Two neighbouring rises on one side of the curve, with what each is divided by.
#[derive(Debug, Clone, Copy)]
struct Pair {
    inner: (usize, f64),
    outer: (usize, f64),
}

/// Every pair of neighbouring rises of the curve.
#[derive(Debug, Clone)]
pub struct SmoothCurve(Vec<Pair>);

impl SmoothCurve {
    /// Of the unknowns of a fit.
    pub fn new(unknowns: &Unknowns) -> SmoothCurve {
        let velocity = unknowns.base.list(CurveName::Fv.abscissae());
        let zero = anchor(velocity);
        let place_of =
            |point: usize| unknowns.list.iter().position(|u| *u == Unknown::Rise { curve: CurveName::Fv, point });
        // What a curve of that power would rise by there: from standstill too, where a steeper one would be dry friction.
        let of = |point: usize| {
            let inner = towards_zero(point, zero);
            let near = if inner == zero { 0.0 } else { velocity[inner].abs() };
            let usual = libm::pow(velocity[point].abs(), POWER) - libm::pow(near, POWER);
            (usual > 0.0).then(|| Some((place_of(point)?, usual)))?
        };
        let pairs = (0..velocity.len()).filter(|point| *point != zero).filter_map(|point| {
            let inner = towards_zero(point, zero);
            (inner != zero).then(|| Some(Pair { inner: of(inner)?, outer: of(point)? }))?
        });
        SmoothCurve(pairs.collect())
    }

    /// Number of rows.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// One row a pair: what is like the logarithm of the ratio near 1 and stays finite where a rise is none, over its spread.
    pub fn rows(&self, theta: &[f64]) -> Vec<f64> {
        self.0.iter().map(|pair| pair.ratio(theta).0).collect()
    }

    /// Their derivatives.
    pub fn jacobian(&self, theta: &[f64]) -> DMatrix<f64> {
        let mut jacobian = DMatrix::zeros(self.0.len(), theta.len());
        for (row, pair) in self.0.iter().enumerate() {
            let (_, [by_inner, by_outer]) = pair.ratio(theta);
            jacobian[(row, pair.inner.0)] += by_inner;
            jacobian[(row, pair.outer.0)] += by_outer;
        }
        jacobian
    }
}

impl Pair {
    /// 2 (b − a)/(b + a) of the rises a, b over what is usual, over the spread, with its slopes over both unknowns.
    fn ratio(&self, theta: &[f64]) -> (f64, [f64; 2]) {
        let (a, b) = (theta[self.inner.0] / self.inner.1, theta[self.outer.0] / self.outer.1);
        let sum = a + b;
        if sum <= 0.0 {
            // A level curve is even.
            return (0.0, [0.0; 2]);
        }
        let scale = 2.0 / SPREAD;
        let per = scale * 2.0 / (sum * sum);
        (scale * (b - a) / sum, [-per * b / self.inner.1, per * a / self.outer.1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::Params;
    use dashpot_core::list;

    fn unknowns(force: impl Fn(f64) -> f64) -> Unknowns {
        let mut base = Params::new();
        let v = [-1.0, -0.4, -0.1, -0.03, 0.0, 0.03, 0.1, 0.4, 1.0];
        base.set_list(list!("fv_velocity"), &v).unwrap();
        base.set_list(list!("fv_force"), &v.map(force)).unwrap();
        let list = Unknowns::rises(&base, CurveName::Fv);
        Unknowns { base, list, rig: Vec::new() }
    }

    #[test]
    fn a_usual_curve_costs_little_and_a_plateau_between_rises_much() {
        let cost = |unknowns: &Unknowns| -> f64 {
            SmoothCurve::new(unknowns).rows(&unknowns.start()).iter().map(|r| 0.5 * r * r).sum()
        };
        let usual = unknowns(|v| 2e3 * v.signum() * v.abs().sqrt());
        assert_eq!(SmoothCurve::new(&usual).count(), 6);
        assert!(cost(&usual) < 0.05, "{}", cost(&usual));
        let straight = unknowns(|v| 2e3 * v);
        assert!(cost(&straight) < 3.0, "{}", cost(&straight));
        let plateau = unknowns(|v| {
            if v.abs() > 0.2 && v.abs() < 0.9 {
                300.0 * v.signum()
            } else {
                3e3 * v.abs().min(0.1) * v.signum() + 700.0 * (v.abs() - 0.4).max(0.0) * v.signum()
            }
        });
        assert!(cost(&plateau) > 5.0, "{}", cost(&plateau));
    }

    #[test]
    fn its_slopes_are_derivatives() {
        let unknowns = unknowns(|v| 1e3 * v + 200.0 * v.signum() * v.abs().sqrt());
        let smooth = SmoothCurve::new(&unknowns);
        let theta = unknowns.start();
        let jacobian = smooth.jacobian(&theta);
        for i in 0..theta.len() {
            let at = |d: f64| {
                let mut moved = theta.clone();
                moved[i] += d;
                smooth.rows(&moved)
            };
            for (row, (up, down)) in at(1e-3).iter().zip(at(-1e-3)).enumerate() {
                assert!((jacobian[(row, i)] - (up - down) / 2e-3).abs() < 1e-6);
            }
        }
    }
}
