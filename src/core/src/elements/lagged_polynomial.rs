//! Polynomial FV curve behind a first-order lag: one of the models the thesis compares itself with.

use crate::elements::{Describe, Memory, Motion, Prepare, Recall};
use crate::fault::{Fault, Reason};
use crate::parameter::{Parameter, View};

/// T(|v|) dy/dt + y = Σ a_k v^k, F = y.
///
/// The time constant ramps from `lag_slow` at and below speed `lag_v1` to `lag_fast` at and above `lag_v2`; the thesis
/// found that a jump instead of the ramp makes the model unstable.
#[derive(Clone, Copy, Debug)]
pub struct LaggedPolynomial {
    a: [f64; MAX_TERMS],
    slow: f64,
    per_speed: f64,
    v1: f64,
    v2: f64,
}

const MAX_TERMS: usize = 12;

impl Describe for LaggedPolynomial {
    const MEANING: &'static str = "polynomial FV curve with a first-order lag whose time constant ramps with speed";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::list(
            "polynomial",
            "N (s/m)^k",
            MAX_TERMS,
            &[0.0, 3000.0],
            (-1e9, 1e9),
            "coefficients of v^0, v^1, ...",
        ),
        Parameter::scalar("lag_slow", "s", &[0.004], (1e-5, 1.0), "time constant at low speed"),
        Parameter::scalar("lag_fast", "s", &[0.001], (1e-5, 1.0), "time constant at high speed"),
        Parameter::scalar("lag_v1", "m/s", &[0.05], (0.0, 10.0), "speed at which the time constant starts to change"),
        Parameter::scalar("lag_v2", "m/s", &[0.5], (1e-4, 20.0), "speed at which it has changed"),
    ];
}

impl Prepare for LaggedPolynomial {
    const OFF: Self = LaggedPolynomial { a: [0.0; MAX_TERMS], slow: 1.0, per_speed: 0.0, v1: 0.0, v2: 1.0 };

    fn prepare(p: &View) -> Result<Self, Fault> {
        let mut a = [0.0; MAX_TERMS];
        for (to, from) in a.iter_mut().zip(p.list(0)) {
            *to = *from;
        }
        let (slow, fast, v1, v2) = (p.number(1), p.number(2), p.number(3), p.number(4));
        if v2 <= v1 {
            return Err(p.fault(4, Reason::Order));
        }
        Ok(LaggedPolynomial { a, slow, per_speed: (fast - slow) / (v2 - v1), v1, v2 })
    }
}

impl LaggedPolynomial {
    /// Σ a_k v^k and its slope.
    fn polynomial(&self, v: f64) -> (f64, f64) {
        let (mut value, mut slope) = (0.0, 0.0);
        for a in self.a.iter().rev() {
            slope = slope * v + value;
            value = value * v + a;
        }
        (value, slope)
    }

    /// Time constant and its slope over velocity.
    fn time_constant(&self, v: f64) -> (f64, f64) {
        let speed = v.abs();
        if speed <= self.v1 {
            (self.slow, 0.0)
        } else if speed >= self.v2 {
            (self.slow + self.per_speed * (self.v2 - self.v1), 0.0)
        } else {
            (self.slow + self.per_speed * (speed - self.v1), self.per_speed.copysign(self.per_speed * v))
        }
    }
}

impl Memory for LaggedPolynomial {
    fn recall(&self, at: &Motion, y: f64) -> Recall {
        let (target, by_v) = self.polynomial(at.velocity);
        let (t, t_by_v) = self.time_constant(at.velocity);
        let rate = (target - y) / t;
        Recall {
            force: y,
            by_memory: 1.0,
            rate,
            rate_by_v: (by_v - rate * t_by_v) / t,
            rate_by_memory: -1.0 / t,
            ..Recall::NONE
        }
    }

    fn settled(&self, at: &Motion) -> f64 {
        self.polynomial(at.velocity).0
    }
}
