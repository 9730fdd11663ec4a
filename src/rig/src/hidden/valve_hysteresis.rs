//! Injected effect of valve hysteresis: the blow-off valve opens and closes with a delay.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest, ValveLaw};

const FORMS: &[&str] = &["spool", "opening_and_closing_pressure"];
/// Velocity, m/s, up to which all oil flows through the bleed, which is always open. Beyond it, the bleed follows the
/// law of an orifice.
const BLEED_M_S: f64 = 0.05;

struct ValveHysteresis {
    form: usize,
    /// Form `spool`: natural frequency (rad/s), damping ratio, and ratio of flow force to pressure force at full flow.
    omega: f64,
    damping: f64,
    flow_force: f64,
    /// Form `opening_and_closing_pressure`: play between pressure and valve position, expressed as a force, N, and time
    /// constant of the valve beyond the play, s.
    play_n: f64,
    follows_s: f64,
    /// Valve force at the velocity [`BLEED_M_S`] in rebound and compression, N.
    bleed_n: [f64; 2],
    tolerances: Vec<f64>,
}

impl DamperEffect for ValveHysteresis {
    fn tolerances(&self) -> &[f64] {
        &self.tolerances
    }

    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }

    /// Computes the rate of the valve position, N/s. The position is expressed as the oil force at which it would be in
    /// equilibrium. In the form `spool`, also computes the rate of the valve's velocity, N/s².
    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        let lag = here.oil_n - states[0];
        if self.form == 0 {
            rates[0] = states[1];
            // While oil flows, the flow force acts on the spool in the closing direction.
            let flow_force = 1.0 - self.flow_force * (here.oil_n / libm::hypot(here.oil_n, 500.0)).powi(2);
            rates[1] =
                self.omega * (self.omega * (flow_force * here.oil_n - states[0]) - 2.0 * self.damping * states[1]);
        } else {
            // The play approaches |F| at small oil forces F and `play_n` at large forces, so that the valve closes at
            // zero force.
            let play = self.play_n * here.oil_n.abs() / (here.oil_n.abs() + self.play_n);
            rates[0] = (lag.abs() - play).max(0.0).copysign(lag) / self.follows_s;
        }
    }

    fn valve_flow_m_s(&self, valves: &ValveLaw, force_n: f64, states: &[f64]) -> Option<f64> {
        let bleed = |force: f64| {
            let end_n = self.bleed_n[usize::from(force < 0.0)];
            if force.abs() <= end_n {
                valves.flow_m_s(force)
            } else {
                BLEED_M_S.copysign(force) * (force.abs() / end_n).sqrt()
            }
        };
        let standing = states[0];
        // The valve position may still belong to the opposite direction of the force. The blow-off valve of the current
        // direction is then closed.
        let ratio = if standing * force_n > 0.0 { (force_n / standing).min(4.0) } else { 0.0 };
        let opened = valves.flow_m_s(standing) - bleed(standing);
        Some(bleed(force_n) + opened * ratio.sqrt())
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let strength = recipe.strength;
    let at_knee = recipe.neutral.valves.force_n(0.1);
    let bleed_n = [BLEED_M_S, -BLEED_M_S].map(|flow| recipe.neutral.valves.force_n(flow).abs());
    let draw = &mut recipe.draw;
    Box::new(ValveHysteresis {
        form,
        omega: std::f64::consts::TAU * draw.ratio("spool_hz", 60.0, 150.0) / strength,
        damping: draw.between("spool_damping", 0.5, 0.9),
        flow_force: 0.1 * strength / (1.0 + strength),
        play_n: strength * at_knee * draw.between("play_share", 0.12, 0.25),
        follows_s: draw.ratio("follows_s", 0.3e-3, 1e-3) * strength,
        bleed_n,
        tolerances: if form == 0 { vec![1e-1, 1e2] } else { vec![1e-1] },
    })
}
