//! Injected unknown effect: cogging of an electric actuator. Its magnets add a force with the period of the poles, a
//! part of which reaches the load cell.

use super::{Draw, Effect, EffectModel, Here, Make, Scale};

pub(super) const EFFECT: Effect = Effect { name: "cogging", laws: &[("poles", poles as Make)] };

/// A sine wave of force over the stroke, with an amplitude proportional to the motor's current and thus to the damper
/// force.
struct Poles {
    share: f64,
    pitch: f64,
    phase: f64,
}

impl EffectModel for Poles {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        let wave = libm::sin(std::f64::consts::TAU * here.input.x / self.pitch + self.phase);
        self.share * wave * here.hydraulic.abs()
    }
}

fn poles(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(Poles {
        share: strength * d.between(0.06, 0.14),
        pitch: d.between(0.006, 0.016),
        phase: std::f64::consts::TAU * d.fraction(),
    })
}
