//! Free play (backlash) in an eye or mount, in series with the series spring.

use crate::dual::Real;
use crate::element::Prepare;
use crate::elements::soft_gap::SoftGap;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Free play with the deflection d(F) = F/k_s + g [(F − F_1)/(|F − F_1| + F_0) + F_1/(|F_1| + F_0)].
///
/// F is the force, N, and d the deflection, m. Between its contacts the eye moves freely by 2 g, m. k_s is the series
/// stiffness, N/m, and F_1 the force at the center of the gap. F_0 is the deviation from F_1 at which the gap is half
/// closed. d(0) is 0. The series damping is proportional to the current stiffness, so it vanishes in the gap.
#[derive(Clone, Copy, Debug)]
pub struct FreePlay {
    gap: SoftGap,
    /// Force F_1 at the center of the gap, N.
    load: f64,
    /// Deflection of the gap alone at the force `load`, without the deflection of the series spring, m.
    middle: f64,
}

impl FreePlay {
    /// Computes the force, N, and its derivative, N/m, at a deflection, m, of the gap in series with a spring of
    /// `stiffness`, N/m.
    #[inline(always)]
    pub(crate) fn force<R: Real>(&self, stiffness: R, deflection: R) -> (R, R) {
        if self.load == 0.0 {
            return self.gap.force(stiffness, deflection);
        }
        let middle = (stiffness.inverse() * self.load).plus(self.middle);
        let (force, derivative) = self.gap.force(stiffness, deflection - middle);
        (force.plus(self.load), derivative)
    }

    /// Returns an upper bound, m, of the deflection that the gap adds to that of the series spring.
    pub(crate) fn furthest(&self) -> f64 {
        self.gap.gap + self.middle.abs()
    }
}

impl Describe for FreePlay {
    const MEANING: &'static str = "free play in an eye or mount; needs series_compliance";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("free_play_gap", "m", &[2e-4], (0.0, 5e-3), "total free play from contact to contact, 2 g"),
        Parameter::scalar(
            "free_play_force",
            "N",
            &[20.0],
            (0.1, 1e4),
            "softness of the contact: force, beyond F_1, that closes half of the gap, F_0",
        ),
        Parameter::scalar(
            "free_play_load",
            "N",
            &[0.0],
            (-1e4, 1e4),
            "load at the middle of the gap, F_1: weight on the eye, gas force, clamping",
        ),
    ];
}

impl Prepare for FreePlay {
    const OFF: Self = FreePlay { gap: SoftGap::CLOSED, load: 0.0, middle: 0.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let (gap, softness) = (0.5 * p.number(own!("free_play_gap")), p.number(own!("free_play_force")));
        let load = p.number(own!("free_play_load"));
        Ok(FreePlay { gap: SoftGap { gap, softness }, load, middle: gap * load / (load.abs() + softness) })
    }
}
