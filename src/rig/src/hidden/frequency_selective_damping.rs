//! Injected effect of a bypass that closes during each stroke. The damper is soft in short, fast strokes and firm in
//! long, slow strokes.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["filling_chamber", "cross_fade"];

struct FrequencySelective {
    form: usize,
    /// Flow of the open bypass, as a piston velocity, m/s, at the oil force `scale_n`, N.
    flow_m_s: f64,
    scale_n: f64,
    /// Time constant, s, with which the bypass closes. `opening_s` is the time constant with which it reopens, s.
    closing_s: f64,
    opening_s: f64,
    /// Velocity below which the form `cross_fade` detects a reversal, m/s.
    reversal_m_s: f64,
}

impl DamperEffect for FrequencySelective {
    fn tolerances(&self) -> &[f64] {
        match self.form {
            // The states are the filled fractions of the control chambers of rebound and compression.
            0 => &[1e-5, 1e-5],
            // The state is the closed fraction of the bypass.
            _ => &[1e-5],
        }
    }

    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        if self.form == 0 {
            for (index, force) in [here.oil_n, -here.oil_n].into_iter().enumerate() {
                // Each control chamber belongs to one direction of the oil force. A force in this direction fills the
                // chamber through a throttle. Without such a force, a check valve empties the chamber.
                let pressure = (force / self.scale_n).max(0.0);
                let fills = (pressure / (pressure + 0.3)).sqrt() * (1.0 - states[index]) / self.closing_s;
                let idle = 1.0 / (1.0 + libm::exp(force / (0.02 * self.scale_n)));
                rates[index] = fills - idle * states[index] / self.opening_s;
            }
        } else {
            let slow = libm::exp(-(here.velocity_m_s / self.reversal_m_s).powi(2));
            rates[0] = (1.0 - states[0]) / self.closing_s - slow * states[0] / self.opening_s;
        }
    }

    fn bypass_m_s(&self, here: &Here, states: &[f64]) -> f64 {
        let force = here.oil_n / self.scale_n;
        if self.form == 0 {
            let closed = if force > 0.0 { states[0] } else { states[1] };
            self.flow_m_s * (1.0 - closed) * force / libm::pow(force * force + 4e-4, 0.25)
        } else {
            // In the form `cross_fade`, the flow of the bypass is linear in the force.
            self.flow_m_s * (1.0 - states[0]) * force
        }
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let scale_n = recipe.neutral.valves.force_n(0.3);
    let draw = &mut recipe.draw;
    Box::new(FrequencySelective {
        form,
        flow_m_s: recipe.strength * draw.between("flow_m_s", 0.10, 0.2),
        scale_n,
        closing_s: draw.ratio("closing_s", 0.03, 0.10),
        opening_s: draw.ratio("opening_s", 1e-3, 3e-3),
        reversal_m_s: draw.between("reversal_m_s", 3e-3, 8e-3),
    })
}
