//! Injected measurement error of a force channel with a drifting zero.

use super::{Effect, EffectModel, Make, Reading};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "force_drift", laws: &[("diffusion", diffusion as Make), ("wander", wander)] };

/// Drift of the zero due to heat that diffuses into the load cell through its flange. The drift is initially
/// proportional to the root of time (Carslaw & Jaeger, half space).
struct Diffusion {
    force: f64,
    length: f64,
}

impl EffectModel for Diffusion {
    fn reads(&self, at: &Reading) -> f64 {
        let root = at.progress.max(0.0).sqrt();
        self.force * root / (1.0 + self.length * root)
    }
}

fn diffusion(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let force = strength * d.sign() * d.between(0.08, 0.16) * scale.rebound_n;
    Box::new(Diffusion { force, length: d.between(0.0, 0.6) })
}

const WAVES: usize = 3;

/// A slow random drift of the zero, for example due to drafts and a switching heater. It is a sum of three sine waves
/// with 0.4 to 2.6 periods per campaign.
struct Wander {
    waves: [[f64; 3]; WAVES],
}

impl EffectModel for Wander {
    fn reads(&self, at: &Reading) -> f64 {
        self.waves
            .iter()
            .map(|[size, turns, phase]| {
                size * (libm::sin(std::f64::consts::TAU * turns * at.progress + phase) - libm::sin(*phase))
            })
            .sum()
    }
}

fn wander(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let size = strength * d.between(0.03, 0.06) * scale.rebound_n;
    let waves = [0.5, 1.0, 2.2].map(|turns| {
        [size / f64::sqrt(2.0 * turns), turns * d.between(0.8, 1.2), std::f64::consts::TAU * d.fraction()]
    });
    Box::new(Wander { waves })
}
