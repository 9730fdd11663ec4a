//! Valve force as a function of the mass's velocity in the plain step: the FV curve, possibly times a factor.

use crate::assembly::Elements;
use crate::curve::Value;
use crate::tables::{ForceLaw, Tables};

/// A valve force that does not decrease with the velocity of the internal mass.
pub(super) trait Primary: Copy {
    /// Prepares the force for the temperature from the host, °C.
    fn new(e: &Elements<impl Tables>, temperature: f64) -> Self;

    /// Returns whether the force is the FV curve without a factor.
    fn is_plain(&self) -> bool;

    /// Returns force, N, and derivative, N s/m, at the velocity `v`, m/s.
    fn evaluate(&self, e: &Elements<impl Tables>, v: f64) -> Value;

    /// Returns the velocity u, m/s, with a u + F(u) = r for this force F, with force and derivative there.
    fn solve(&self, e: &Elements<impl Tables>, a: f64, r: f64) -> (f64, Value);
}

/// Number of Householder steps inside a piece of the FV curve. The remaining error of the solution is below the error
/// of every integration method.
const STEPS: usize = 3;

/// The FV curve without a factor.
#[derive(Clone, Copy)]
pub(super) struct Plain;

impl Primary for Plain {
    #[inline(always)]
    fn new(_: &Elements<impl Tables>, _: f64) -> Plain {
        Plain
    }

    #[inline(always)]
    fn is_plain(&self) -> bool {
        true
    }

    #[inline(always)]
    fn evaluate(&self, e: &Elements<impl Tables>, v: f64) -> Value {
        e.paths.fv_curve.evaluate(v)
    }

    #[inline(always)]
    fn solve(&self, e: &Elements<impl Tables>, a: f64, r: f64) -> (f64, Value) {
        e.paths.fv_curve.solve::<STEPS>(a, r)
    }
}

/// FV curve of a damper whose force fades as a whole: F_d(0) + s (F_d(u) − F_d(0)), with the FV curve F_d and the fade
/// factor s.
#[derive(Clone, Copy)]
pub(super) struct Faded {
    /// Fade factor s at the host's temperature, and its reciprocal.
    factor: f64,
    per_factor: f64,
    /// Force of the FV curve at zero velocity, N.
    standing: f64,
}

impl Faded {
    #[inline(always)]
    fn of(&self, curve: Value) -> Value {
        Value {
            value: self.standing + self.factor * (curve.value - self.standing),
            derivative: self.factor * curve.derivative,
        }
    }
}

impl Primary for Faded {
    #[inline(always)]
    fn new(e: &Elements<impl Tables>, temperature: f64) -> Faded {
        let factor: f64 = e.paths.temperature_fade.factor(temperature, 0.0);
        Faded { factor, per_factor: 1.0 / factor, standing: e.paths.fv_curve.at_zero() }
    }

    #[inline(always)]
    fn is_plain(&self) -> bool {
        false
    }

    #[inline(always)]
    fn evaluate(&self, e: &Elements<impl Tables>, v: f64) -> Value {
        self.of(e.paths.fv_curve.evaluate(v))
    }

    #[inline(always)]
    fn solve(&self, e: &Elements<impl Tables>, a: f64, r: f64) -> (f64, Value) {
        let r = self.standing + (r - self.standing) * self.per_factor;
        let (u, curve) = e.paths.fv_curve.solve::<STEPS>(a * self.per_factor, r);
        (u, self.of(curve))
    }
}

/// Valve force of any damper in the plain step: the FV curve, or the faded curve.
#[derive(Clone, Copy)]
pub(super) struct Any(Option<Faded>);

impl Primary for Any {
    #[inline(always)]
    fn new(e: &Elements<impl Tables>, temperature: f64) -> Any {
        Any(e.has_paths().then(|| Faded::new(e, temperature)))
    }

    #[inline(always)]
    fn is_plain(&self) -> bool {
        self.0.is_none()
    }

    #[inline(always)]
    fn evaluate(&self, e: &Elements<impl Tables>, v: f64) -> Value {
        let curve = e.paths.fv_curve.evaluate(v);
        self.0.map_or(curve, |faded| faded.of(curve))
    }

    #[inline(always)]
    fn solve(&self, e: &Elements<impl Tables>, a: f64, r: f64) -> (f64, Value) {
        match &self.0 {
            None => Plain.solve(e, a, r),
            Some(faded) => faded.solve(e, a, r),
        }
    }
}
