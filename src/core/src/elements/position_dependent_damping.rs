//! Position-dependent damping: bypass grooves or a tapered needle over a part of the stroke.

use crate::dual::Real;
use crate::element::Prepare;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Damping that differs in a zone of the stroke, as a factor on the force or as a bypass groove.
///
/// The zone has the profile p(x) = ½ [tanh((x − c + w)/b) − tanh((x − c − w)/b)] over the moving end's displacement x,
/// m. c is the center of the zone, w half its length, and b the length over which it fades out.
///
/// *Factor*: the FV force F_d is multiplied by s(x) = 1 − a p(x), where a is the fraction that is missing in the zone.
///
/// *Groove*: oil bypasses the valves with the piston velocity q_b p(x) r(F_h)/√(1 kN), so q_b is that at 1 kN. Far
/// above 20 N it is nearly proportional to the root of the hydraulic force F_h; for the law r see
/// [`crate::paths::bypass`].
#[derive(Clone, Copy, Debug)]
pub struct PositionDependentDamping {
    pub(crate) is_groove: bool,
    share: f64,
    flow: f64,
    centre: f64,
    half_width: f64,
    per_blend: f64,
    /// Whether the zone acts in compression, and whether it acts in rebound.
    acts: [bool; 2],
}

impl Describe for PositionDependentDamping {
    const MEANING: &'static str = "position-dependent damping: lower (bypass) or higher over a part of the stroke";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "bypass_share",
            "-",
            &[0.3],
            (-4.0, 0.95),
            "fraction by which the FV force is reduced in the zone, a; negative: increased",
        )
        .in_form("bypass_form", &["factor"]),
        Parameter::scalar("bypass_centre", "m", &[0.0], (-1.0, 1.0), "displacement at the center of the zone, c"),
        Parameter::scalar("bypass_half_width", "m", &[0.02], (1e-3, 1.0), "half of the length of the zone, w"),
        Parameter::scalar("bypass_blend", "m", &[5e-3], (5e-4, 0.5), "transition length at either end of the zone, b"),
        Parameter::choice("bypass_strokes", &["both", "rebound", "compression"], "strokes on which the zone acts"),
        Parameter::choice(
            "bypass_form",
            &["factor", "groove"],
            "factor on the FV force, or bypass flow parallel to the valves",
        ),
        Parameter::scalar(
            "bypass_flow",
            "m/s",
            &[0.2],
            (0.0, 10.0),
            "groove: bypass flow in the zone at a hydraulic force of 1 kN, as a piston velocity, q_b",
        )
        .in_form("bypass_form", &["groove"]),
    ];
}

impl Prepare for PositionDependentDamping {
    const OFF: Self = PositionDependentDamping {
        is_groove: false,
        share: 0.0,
        flow: 0.0,
        centre: 0.0,
        half_width: 0.0,
        per_blend: 1.0,
        acts: [false; 2],
    };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let strokes = p.number(own!("bypass_strokes"));
        Ok(PositionDependentDamping {
            is_groove: p.number(own!("bypass_form")) == 1.0,
            share: p.number(own!("bypass_share")),
            flow: p.number(own!("bypass_flow")),
            centre: p.number(own!("bypass_centre")),
            half_width: p.number(own!("bypass_half_width")),
            per_blend: 1.0 / p.number(own!("bypass_blend")),
            acts: [strokes != 1.0, strokes != 2.0],
        })
    }
}

impl PositionDependentDamping {
    /// Computes the factor s(x) on the FV force in rebound or compression at displacement `x`, m. It is 1 on a stroke
    /// on which the zone does not act.
    #[inline(always)]
    pub(crate) fn factor<R: Real>(&self, x: R, rebound: bool) -> R {
        if self.acts[usize::from(rebound)] { self.window(x) } else { R::constant(1.0) }
    }

    /// Computes the factors s(x) on the FV force in compression and in rebound at displacement `x`, m. A factor is 1 on
    /// a stroke on which the zone does not act.
    #[inline(always)]
    pub(crate) fn factors<R: Real>(&self, x: R) -> [R; 2] {
        let window = self.window(x);
        self.acts.map(|acts| if acts { window } else { R::constant(1.0) })
    }

    /// Computes the flow through the groove at a hydraulic force of 1 kN, as a piston velocity in m/s. It is 0 on a
    /// stroke on which the zone does not act.
    #[inline(always)]
    pub(crate) fn groove<R: Real>(&self, x: R, rebound: bool) -> R {
        if self.acts[usize::from(rebound)] { self.zone(x) * self.flow } else { R::constant(0.0) }
    }

    /// Computes the factor s(x) on the FV force, on a stroke on which the zone acts.
    #[inline(always)]
    fn window<R: Real>(&self, x: R) -> R {
        (-(self.zone(x) * self.share)).plus(1.0)
    }

    /// Computes the profile p(x) of the zone, from 0 outside to 1 inside, at displacement `x`, m.
    #[inline(always)]
    fn zone<R: Real>(&self, x: R) -> R {
        let from = x.plus(-self.centre);
        let (rise, fall) = (from.plus(self.half_width) * self.per_blend, from.plus(-self.half_width) * self.per_blend);
        (rise.tanh() - fall.tanh()) * 0.5
    }
}
