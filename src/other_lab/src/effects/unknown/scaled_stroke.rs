//! Injected unknown effect: a displacement channel with a wrong scale and a nonlinear wire potentiometer. A separate
//! sensor measures velocity, so the two channels disagree.

use super::{Draw, Effect, EffectModel, Make, Scale};

pub(super) const EFFECT: Effect = Effect { name: "scaled_stroke", laws: &[("potentiometer", potentiometer as Make)] };

/// Displacement channel with a gain error and a sinusoidal error over the stroke.
struct Potentiometer {
    gain: f64,
    wave: f64,
    length: f64,
}

impl EffectModel for Potentiometer {
    fn displacement(&self, x: f64) -> f64 {
        x * (1.0 + self.gain) + self.wave * libm::sin(std::f64::consts::TAU * x / self.length)
    }
}

fn potentiometer(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(Potentiometer {
        gain: strength * d.sign() * d.between(0.04, 0.1),
        wave: strength * d.between(3e-4, 8e-4),
        length: d.between(0.015, 0.04),
    })
}
