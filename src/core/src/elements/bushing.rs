//! Rubber bushing in line with the damper: it hardens, and gives back less than it took.

use crate::dual::Real;
use crate::elements::{Describe, Prepare};
use crate::fault::Fault;
use crate::parameter::{Parameter, View};

/// F_s = φ (1 + (φ/(k_s d_h))²) + k_1 z with the straight series spring's force φ, and dz/dt = dd/dt − z/τ: a Maxwell
/// branch of stiffness k_1 beside the hardening spring.
#[derive(Clone, Copy, Debug)]
pub struct Bushing {
    /// 1/d_h.
    per_length: f64,
    /// k_1/k_s.
    pub(crate) share: f64,
    /// 1/τ.
    pub(crate) per_time: f64,
}

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
        Parameter::scalar("bushing_loss_time", "s", &[0.01], (1e-4, 10.0), "time in which that share gives way, tau"),
    ];
}

impl Prepare for Bushing {
    const OFF: Self = Bushing { per_length: 0.0, share: 0.0, per_time: 1.0 };

    fn prepare(p: &View) -> Result<Self, Fault> {
        Ok(Bushing { per_length: 1.0 / p.number(0), share: p.number(1), per_time: 1.0 / p.number(2) })
    }
}

impl Bushing {
    /// The hardened force and stiffness of a spring with `force` and `stiffness`; `k` is k_s.
    #[inline(always)]
    pub(crate) fn hardened<R: Real>(&self, k: R, force: R, stiffness: R) -> (R, R) {
        let depth = force * k.inverse() * self.per_length;
        let square = depth * depth;
        (force * square.plus(1.0), stiffness * (square * 3.0).plus(1.0))
    }
}
