//! Polynomial FV curve with a first-order lag: a comparison model of Jonnalagadda & Vyas (KTH 2020).

use crate::dual::{Dual, Real};
use crate::element::{EndState, OperatingPoint, Prepare, Response, StateResponse, StatefulForce};
use crate::fault::{Fault, Reason};
use crate::input::Path;
use crate::math::relaxation;
use crate::schema::kind::One;
use crate::schema::own::own;
use crate::schema::{Describe, Own, Parameter, View};

/// Lagged polynomial with the force F = y, N, and the state equation T(|v|) dy/dt + y = Σ a_k v^k; v is the velocity,
/// m/s.
///
/// a_k are the coefficients of the list `polynomial`. The time constant T ramps from `lag_slow` at and below speed
/// `lag_v1` to `lag_fast` at and above `lag_v2`. According to Jonnalagadda & Vyas (KTH 2020), a jump instead of the
/// ramp makes the model unstable.
#[derive(Clone, Copy, Debug)]
pub struct LaggedPolynomial {
    a: [f64; MAX_TERMS],
    slow: f64,
    per_speed: f64,
    v1: f64,
    v2: f64,
}

const V2: Own<LaggedPolynomial, One> = Own::named("lag_v2");
const MAX_TERMS: usize = 12;
/// Number of parts into which a step is divided. In each part, the relaxation rate (one over the time constant) is
/// replaced by its mean over the part.
const PARTS: usize = 4;

impl Describe for LaggedPolynomial {
    const MEANING: &'static str =
        "polynomial FV curve with a first-order lag, whose time constant depends on the speed";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::list(
            "polynomial",
            "N (s/m)^k",
            MAX_TERMS,
            &[0.0, 3000.0],
            (-1e9, 1e9),
            "coefficients of the polynomial FV curve, of v^0, v^1, ...",
        ),
        Parameter::scalar("lag_slow", "s", &[0.004], (1e-5, 1.0), "time constant of the lag at low speed"),
        Parameter::scalar("lag_fast", "s", &[0.001], (1e-5, 1.0), "time constant of the lag at high speed"),
        Parameter::scalar(
            "lag_v1",
            "m/s",
            &[0.05],
            (0.0, 10.0),
            "speed below which the time constant is that of low speed",
        ),
        Parameter::scalar(
            "lag_v2",
            "m/s",
            &[0.5],
            (1e-4, 20.0),
            "speed above which the time constant is that of high speed",
        ),
    ];
}

impl Prepare for LaggedPolynomial {
    const OFF: Self = LaggedPolynomial { a: [0.0; MAX_TERMS], slow: 1.0, per_speed: 0.0, v1: 0.0, v2: 1.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let mut a = [0.0; MAX_TERMS];
        for (to, from) in a.iter_mut().zip(p.list(own!("polynomial"))) {
            *to = *from;
        }
        let (slow, fast, v1, v2) =
            (p.number(own!("lag_slow")), p.number(own!("lag_fast")), p.number(own!("lag_v1")), p.number(V2));
        if v2 <= v1 {
            return Err(p.fault(V2, Reason::Order));
        }
        Ok(LaggedPolynomial { a, slow, per_speed: (fast - slow) / (v2 - v1), v1, v2 })
    }
}

impl LaggedPolynomial {
    /// Computes the polynomial Σ a_k v^k, N, at velocity `v`, m/s, and its derivative, N s/m.
    fn polynomial(&self, v: f64) -> (f64, f64) {
        let (mut value, mut derivative) = (0.0, 0.0);
        for a in self.a.iter().rev() {
            derivative = derivative * v + value;
            value = value * v + a;
        }
        (value, derivative)
    }

    /// Computes the state, the lagged force, N, at the end of the path from its start value `y`. The path ends at
    /// displacement `x1`, m, with velocity `v1`, m/s.
    #[inline(always)]
    fn after<R: Real>(&self, path: &Path, x1: R, v1: R, y: f64) -> R {
        let [p0, p1, p2] = path.travel(x1, v1).velocity();
        let at = |theta: f64| {
            let v = p0 + (p1 + p2 * theta) * theta;
            let ((target, by_v), (time, time_by_v)) = (self.polynomial(v.value()), self.time_constant(v.value()));
            (v.chain(target, by_v), v.chain(1.0 / time, -time_by_v / (time * time)))
        };
        let part = 1.0 / PARTS as f64;
        let sixth = path.length() * part / 6.0;
        let mut y = R::constant(y);
        let mut first = at(0.0);
        for k in 0..PARTS {
            let from = k as f64 * part;
            let (middle, last) = (at(from + 0.5 * part), at(from + part));
            let rate = (first.1 + middle.1 * 4.0 + last.1) * sixth;
            let r = rate.value();
            let (kept, takes) = relaxation(r);
            // The derivative of the k-th relaxation moment M_k with respect to r, the rate times the part, is M_k/r −
            // M_k + M_{k+1}.
            let take = |k: usize| rate.chain(takes[k], takes[k] / r - takes[k] + takes[k + 1]);
            let rise = last.0 - first.0;
            let bend = (first.0 + last.0 - middle.0 * 2.0) * 2.0;
            y = y * rate.chain(kept, -kept) + take(0) * first.0 + take(1) * (rise - bend) + take(2) * bend;
            first = last;
        }
        y
    }

    /// Returns the time constant, s, at velocity `v`, m/s, and its derivative with respect to velocity, s²/m.
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

impl StatefulForce for LaggedPolynomial {
    fn evaluate(&self, at: &OperatingPoint, y: f64) -> StateResponse {
        let (target, by_v) = self.polynomial(at.velocity);
        let (t, t_by_v) = self.time_constant(at.velocity);
        let rate = (target - y) / t;
        StateResponse {
            force: y,
            d_force_d_z: 1.0,
            rate,
            d_rate_d_v: (by_v - rate * t_by_v) / t,
            d_rate_d_z: -1.0 / t,
            ..StateResponse::NONE
        }
    }

    fn equilibrium(&self, at: &OperatingPoint) -> f64 {
        self.polynomial(at.velocity).0
    }

    /// Computes state and force after the path, in [`PARTS`] parts. The solution is exact for the mean rate of each
    /// part and the parabola through its target values.
    ///
    /// However the time constant changes, the state y stays between its start value and its target values. (A
    /// Runge–Kutta method that is stable for every constant rate may be unstable for a rate that changes a
    /// thousandfold.)
    fn propagate(&self, path: &Path, y: f64, derivatives: bool) -> Option<EndState> {
        let (x1, v1) = path.end();
        let after = if derivatives {
            self.after(path, Dual::<2>::along(x1, 0), Dual::along(v1, 1), y)
        } else {
            Dual::constant(self.after(path, x1, v1, y))
        };
        let Dual { value, derivatives: [by_x, by_v] } = after;
        Some(EndState { z: value, response: Response { force: value, d_force_d_x: by_x, d_force_d_v: by_v } })
    }
}
