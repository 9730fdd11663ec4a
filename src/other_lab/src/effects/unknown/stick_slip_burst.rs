//! Injected unknown effect: the rod sticks and releases with bursts of vibration that are unrelated to the motion.

use super::{Draw, Effect, EffectModel, Make, Reading, Scale};

pub(super) const EFFECT: Effect = Effect { name: "stick_slip_burst", laws: &[("rattle", rattle as Make)] };

/// Length, s, of the intervals of the campaign, each of which contains at most one burst.
const SLOT: f64 = 0.4;

/// Decaying sawtooth waves of friction force, at random times of the campaign.
struct Rattle {
    size: f64,
    teeth: f64,
    decays: f64,
    likely: f64,
    seed: u64,
}

impl EffectModel for Rattle {
    fn reads(&self, at: &Reading) -> f64 {
        let slot = (at.clock / SLOT).floor();
        let mut d = Draw::new(self.seed ^ slot as u64, "burst");
        if d.fraction() > self.likely {
            return 0.0;
        }
        let since = at.clock - (slot + 0.5 * d.fraction()) * SLOT;
        if since < 0.0 {
            return 0.0;
        }
        let saw = 1.0 - (since * self.teeth).fract();
        self.size * d.between(0.5, 1.5) * saw * libm::exp(-since / self.decays) * libm::tanh(at.input.v / 0.05)
    }
}

fn rattle(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(Rattle {
        size: strength * d.between(0.25, 0.5) * scale.rebound_n,
        teeth: d.between(40.0, 90.0),
        decays: d.between(0.03, 0.08),
        likely: d.between(0.3, 0.6),
        seed: (d.fraction() * 1e15) as u64,
    })
}
