//! Injected effect of air in the oil: large compliance at low pressure, small compliance at high pressure.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["entrained", "dissolving_foam"];

struct Aeration {
    form: usize,
    /// Compliance of the air at the static pressure of the damper, m/N.
    soft_m_n: f64,
    /// Force of the damper's static pressure on the piston, N.
    rest_n: f64,
    /// Polytropic exponent of the air bubbles.
    exponent: f64,
    /// Length of each of the two oil chambers at mid-stroke, m. `compression_share` is the ratio of air in the
    /// compression chamber to air in the rebound chamber.
    chamber_m: f64,
    compression_share: f64,
    /// Hydraulic force at which all air is dissolved, N.
    dissolved_n: f64,
    /// Travel over which foam builds up (m), and time constant of its decay (s).
    churning_m: f64,
    settling_s: f64,
}

impl DamperEffect for Aeration {
    fn tolerances(&self) -> &[f64] {
        if self.form == 1 { &[1e-5] } else { &[] }
    }

    /// Keeps the foam state of the preceding test, because foam does not vanish between tests. `pause` computes its
    /// decay.
    fn begin(&self, _rest: &crate::neutral::Rest, _states: &mut [f64]) {}

    fn pause(&self, seconds: f64, states: &mut [f64]) {
        if let Some(foam) = states.first_mut() {
            *foam *= libm::exp(-seconds / self.settling_s);
        }
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        if self.form == 1 {
            let travel = here.line.velocity_m_s.abs() / self.churning_m;
            rates[0] = travel * (1.0 - states[0]) - states[0] / self.settling_s;
        }
    }

    fn compliance_m_n(&self, here: &Here, states: &[f64]) -> f64 {
        if self.form == 0 {
            // Merritt's mixture law (compliance of air bubbles under pressure) applies in both chambers. The chamber
            // under pressure has the larger weight.
            let working = 0.5 * (1.0 + here.oil_n / libm::hypot(here.oil_n, 0.2 * self.rest_n));
            let rebound = (1.0 - here.position_m / self.chamber_m).max(0.1);
            let compression = self.compression_share * (1.0 + here.position_m / self.chamber_m).max(0.1);
            let space = working * rebound + (1.0 - working) * compression;
            self.soft_m_n * space * libm::pow(1.0 + here.oil_n.abs() / self.rest_n, -1.0 - 1.0 / self.exponent)
        } else {
            let share = (1.0 - here.oil_n.abs() / self.dissolved_n).max(0.0);
            let foam = 0.4 + 0.6 * states[0];
            self.soft_m_n * foam * share * share * libm::pow(1.0 + here.oil_n.abs() / self.rest_n, -1.0 / self.exponent)
        }
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let draw = &mut recipe.draw;
    let rest_n = draw.ratio("rest_n", 120.0, 350.0);
    let stroke = draw.between("soft_stroke_m", 0.6e-3, 1.2e-3);
    Box::new(Aeration {
        form,
        soft_m_n: recipe.strength * stroke / rest_n,
        rest_n,
        exponent: draw.between("exponent", 1.1, 1.4),
        chamber_m: draw.between("chamber_m", 0.10, 0.14),
        compression_share: draw.between("compression_share", 0.3, 0.8),
        dissolved_n: rest_n * draw.between("dissolved_at_rest_pressures", 3.0, 5.0),
        churning_m: draw.ratio("churning_m", 1.0, 4.0),
        settling_s: draw.ratio("settling_s", 100.0, 600.0),
    })
}
