//! Injected effect of cavitation: the pressure cannot fall below vapor pressure, so a void opens and limits the force.
//! The force returns only after the void has closed.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["monotube_compression", "foot_valve_rebound"];
/// Compliance of a chamber with vapor, m/N. It corresponds to a stiffness of 10 N/mm.
const VAPOUR_M_N: f64 = 1e-4;
/// Length of a fully developed void, m.
const VOID_M: f64 = 0.2e-3;

enum Cavitation {
    /// In compression, the pressure in the rebound chamber falls to vapor pressure. The force stays at the limit
    /// `cap_n`, N, until the void has closed.
    Monotube { cap_n: f64, knee_n: f64 },
    /// In rebound, the foot valve does not refill the compression chamber, so compression begins with a stroke without
    /// force.
    FootValve { share: f64, free_m_s: f64, knee_m_s: f64, edge_m: f64 },
}

impl DamperEffect for Cavitation {
    fn tolerances(&self) -> &[f64] {
        match self {
            Self::Monotube { .. } => &[],
            // The state is the length of the void, m.
            Self::FootValve { .. } => &[1e-8],
        }
    }

    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        if let Self::FootValve { share, free_m_s, knee_m_s, edge_m } = self {
            let softplus = |x: f64| if x > 30.0 { x } else { libm::log1p(libm::exp(x)) };
            let v = here.velocity_m_s;
            let offset = softplus(-free_m_s / knee_m_s);
            let opens = if v > 0.0 { share * knee_m_s * (softplus((v - free_m_s) / knee_m_s) - offset) } else { 0.0 };
            // While the void is open, the compression of the piston closes it. Over the last `edge_m` of the void, the
            // closing is gradual.
            let closes = v.min(0.0) * states[0] / (states[0] + edge_m);
            rates[0] = opens + closes;
        }
    }

    fn compliance_m_n(&self, here: &Here, states: &[f64]) -> f64 {
        match self {
            Self::Monotube { cap_n, knee_n } => {
                let beyond = (-here.oil_n - cap_n) / knee_n;
                VAPOUR_M_N / (1.0 + libm::exp(-beyond))
            }
            Self::FootValve { .. } => {
                let void = states[0].max(0.0);
                let open = (void / (void + VOID_M)).powi(2);
                // The void acts only while the compression chamber is under pressure.
                let compression = 1.0 / (1.0 + libm::exp(here.oil_n / 10.0));
                VAPOUR_M_N * open * compression
            }
        }
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let strength = recipe.strength;
    let at_top = -recipe.neutral.valves.force_n(-1.5);
    let draw = &mut recipe.draw;
    Box::new(if form == 0 {
        // The force limit varies only with the inverse root of the strength. At a small strength, a limit above all
        // forces would have no effect.
        let cap_n = at_top * draw.between("cap_share", 0.65, 0.85) / strength.sqrt();
        Cavitation::Monotube { cap_n, knee_n: cap_n * draw.between("knee", 0.03, 0.06) }
    } else {
        Cavitation::FootValve {
            share: strength * draw.between("share", 0.05, 0.10),
            free_m_s: draw.between("free_m_s", 0.15, 0.4),
            knee_m_s: 0.05,
            edge_m: 20e-6,
        }
    })
}
