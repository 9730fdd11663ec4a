//! Rubber bushing in line with the damper: it hardens, and gives back less than it took.

use crate::dual::{Dual, Real};
use crate::elements::{Describe, Prepare};
use crate::fault::Fault;
use crate::parameter::{Parameter, View};

/// F_s = φ (1 + (φ/(k_s d_h))²) + k_1 z with the straight series spring's force φ, and dz/dt = dd/dt − z/τ − |dd/dt| z/d_f:
/// beside the hardening spring a branch of stiffness k_1 that gives way in time (Maxwell) and with deflection, as friction in
/// the filler does (Berg, Veh. Syst. Dyn. 30, 1998).
#[derive(Clone, Copy, Debug)]
pub struct Bushing {
    /// 1/d_h.
    per_length: f64,
    /// k_1/k_s.
    pub(crate) share: f64,
    /// 1/τ.
    per_time: f64,
    /// 1/d_f.
    per_slip: f64,
}

/// Rate of the deflection over which the friction sets in, m/s.
const TURNING: f64 = 2e-3;

impl Describe for Bushing {
    const MEANING: &'static str =
        "rubber in line with the damper: the series spring hardens and loses energy; needs series_compliance";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "bushing_hardening",
            "m",
            &[2e-3],
            (2e-4, 1.0),
            "deflection at which the series spring has doubled its force, d_h",
        ),
        Parameter::scalar(
            "bushing_loss_stiffness",
            "-",
            &[0.3],
            (0.0, 3.0),
            "share of the series stiffness that fast motion adds, k_1/k_s",
        ),
        Parameter::scalar("bushing_loss_time", "s", &[0.01], (1e-4, 1e3), "time in which that share gives way, tau"),
        Parameter::scalar(
            "bushing_slip",
            "m",
            &[1e3],
            (1e-6, 1e3),
            "deflection in which that share gives way by friction, d_f; large: by time alone",
        ),
    ];
}

impl Prepare for Bushing {
    const OFF: Self = Bushing { per_length: 0.0, share: 0.0, per_time: 1.0, per_slip: 0.0 };

    fn prepare(p: &View) -> Result<Self, Fault> {
        Ok(Bushing {
            per_length: 1.0 / p.number(0),
            share: p.number(1),
            per_time: 1.0 / p.number(2),
            per_slip: 1.0 / p.number(3),
        })
    }
}

impl Bushing {
    /// 1/τ + |dd/dt|/d_f, with a friction that sets in softly.
    #[inline(always)]
    fn gives_way<R: Real>(&self, rate: R) -> R {
        (rate * rate * rate.abs().plus(TURNING).inverse() * self.per_slip).plus(self.per_time)
    }

    /// dz/dt at a rate of the deflection.
    #[inline(always)]
    pub(crate) fn rate<R: Real>(&self, rate: R, z: R) -> R {
        rate - z * self.gives_way(rate)
    }

    /// z after an implicit stage that is `known` at its start, with its slopes over the rate and over that.
    #[inline(always)]
    pub(crate) fn stage(&self, rate: f64, known: f64, g: f64) -> (f64, [f64; 2]) {
        let gives_way = self.gives_way(Dual::<1>::along(rate, 0));
        let divide = 1.0 / (1.0 + g * gives_way.value);
        let z = (known + rate * g) * divide;
        (z, [g * divide * (1.0 - z * gives_way.slope(0)), divide])
    }

    /// The hardened force and stiffness of a spring with `force` and `stiffness`; `k` is k_s.
    #[inline(always)]
    pub(crate) fn hardened<R: Real>(&self, k: R, force: R, stiffness: R) -> (R, R) {
        let depth = force * k.inverse() * self.per_length;
        let square = depth * depth;
        (force * square.plus(1.0), stiffness * (square * 3.0).plus(1.0))
    }
}
