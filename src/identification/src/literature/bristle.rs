//! Hysteresis that the Dahl, Bouc-Wen and Spencer models share: a bristle deflects with travel and slides at ±1.
//!
//! Consider travel in one direction. The deflection in that direction is q. The travel u is in units of δ, the distance over which the
//! hysteretic force builds up. Then `dq/du = 1 − |q|ⁿ w`, where n is the sharpness of the transition to sliding. If the bristle is
//! deflected along the travel (q ≥ 0), `w = 1`. If it is still deflected against the travel, `w = 1 − 2b`, with a coefficient b of the
//! hysteresis. With β + γ = 1 in Wen's notation, b is β. Dahl's model has n = 1 and b = 1.

/// Shape of the hysteresis: the exponent n and the fraction b of the law for dq/du.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shape {
    /// Sharpness n of the transition from sticking to sliding.
    pub sharpness: f64,
    /// Fraction b of the term of the law that changes sign with the direction of travel.
    pub turning: f64,
}

/// Longest travel of one integration step, in units of the distance δ over which the hysteretic force builds up.
const STEP: f64 = 0.1;
/// Deflection above which the law of the bristle is nearly linear, and the travel of one integration step above it. The unit of the travel
/// is the distance δ over which the hysteretic force builds up. For a nearly linear law, steps of any length are nearly exact.
const NEARLY: (f64, f64) = (0.9, 0.4);
/// Travel above which the bristle counts as sliding, in units of the distance δ over which the hysteretic force builds up. The initial
/// deflection then contributes less than a millionth, for any coefficient b of at least 0.5.
const FORGOTTEN: f64 = 16.0;

/// Returns `(e^x − 1)/x`.
pub fn phi(x: f64) -> f64 {
    if x.abs() < 1e-8 { 1.0 + 0.5 * x } else { libm::expm1(x) / x }
}

impl Shape {
    /// Returns dq/du, the change of the deflection q per travel u in units of δ, and its derivative with respect to q.
    pub fn rate(self, q: f64) -> (f64, f64) {
        let weight = if q >= 0.0 { 1.0 } else { 1.0 - 2.0 * self.turning };
        let size = q.abs().max(1e-300);
        let power = libm::pow(size, self.sharpness);
        (1.0 - power * weight, -weight * self.sharpness * power / size * q.signum())
    }

    /// Returns the deflection after a signed travel from deflection `z`. The travel is in units of δ, the distance over which the force
    /// builds up.
    ///
    /// The steps are exponential Rosenbrock steps, which are exact for a linear law.
    pub fn after(self, z: f64, travel: f64) -> f64 {
        let direction = travel.signum();
        let mut left = travel.abs();
        if left > FORGOTTEN {
            return direction;
        }
        let mut q = direction * z;
        while left > 0.0 {
            let h = left.min(if q < NEARLY.0 { STEP } else { NEARLY.1 });
            let (rate, slope) = self.rate(q);
            q += h * rate * phi(slope * h);
            left -= h;
        }
        direction * q
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn with_dahls_numbers_the_closed_form_is_met() {
        let dahl = Shape { sharpness: 1.0, turning: 1.0 };
        for (z, travel) in [(0.0f64, 0.7f64), (-0.9, 2.0), (0.5, -1.3), (1.0, -9.0)] {
            let direction = travel.signum();
            let exact = direction + (z - direction) * libm::exp(-travel.abs());
            assert!((dahl.after(z, travel) - exact).abs() < 1e-9, "{z} {travel}");
        }
    }

    #[test]
    fn a_sharp_bristle_agrees_with_thousands_of_small_euler_steps_and_slides_at_one() {
        let shape = Shape { sharpness: 2.5, turning: 0.7 };
        for (z, travel) in [(0.0f64, 0.7f64), (-0.95, 1.5), (0.4, -2.0)] {
            let (direction, n) = (travel.signum(), 200_000);
            let mut q = direction * z;
            for _ in 0..n {
                q += travel.abs() / n as f64 * shape.rate(q).0;
            }
            assert!((shape.after(z, travel) - direction * q).abs() < 2e-3, "{z} {travel}");
        }
        assert!((shape.after(-1.0, 1e9) - 1.0).abs() < 1e-9);
    }
}
