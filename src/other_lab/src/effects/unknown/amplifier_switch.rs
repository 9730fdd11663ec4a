//! Injected unknown effect: an amplifier of the force channel that changes to a coarse range at a large force, and back
//! at a small force. The two ranges have different gains.

use super::{Draw, Effect, EffectModel, Make, Scale};

pub(super) const EFFECT: Effect = Effect { name: "amplifier_switch", laws: &[("auto_range", auto_range as Make)] };

/// A gain control with backlash and a gain error in its coarse range, with a gradual transition over a band of forces.
///
/// The backlash is the play operator (Krasnosel'skii & Pokrovskii, Systems with Hysteresis, 1989).
struct AutoRange {
    error: f64,
    /// Magnitude of the force at half of the transition while the force grows, N. `backlash` is the decrease of the
    /// force that reverses the transition, N.
    up: f64,
    backlash: f64,
    band: f64,
}

impl EffectModel for AutoRange {
    fn channel(&self, _: u64, _: &[f64], force: &mut Vec<f64>) {
        let mut stands = 0.0f64;
        for f in force {
            // The state of the play operator stays between the force and the force minus the backlash.
            stands = stands.max(f.abs() - self.backlash).min(f.abs());
            let beyond = (stands - (self.up - self.backlash)) / self.band;
            *f *= 1.0 + self.error * 0.5 * (1.0 + libm::tanh(beyond));
        }
    }
}

fn auto_range(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let up = d.between(0.35, 0.7) * scale.rebound_n;
    Box::new(AutoRange {
        error: strength * d.sign() * d.between(0.1, 0.25),
        up,
        backlash: d.between(0.3, 0.6) * up,
        band: 0.08 * up,
    })
}
