//! Injected effect of presliding friction: contacts that deflect before they slide.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect = Effect {
    name: "presliding_friction",
    laws: &[("iwan", iwan as Make), ("asymmetric_bouc_wen", asymmetric_bouc_wen)],
};

const SLIDERS: usize = 5;

/// Elastic, perfectly plastic elements in parallel. Their slip forces are a power law of their slip lengths.
///
/// (Iwan, J. Appl. Mech. 33, 1966; Segalman, J. Appl. Mech. 72, 2005.) The state of such a contact depends on all past
/// reversals.
struct Iwan {
    force: f64,
    lengths: [f64; SLIDERS],
    shares: [f64; SLIDERS],
}

impl EffectModel for Iwan {
    fn tolerances(&self) -> &[f64] {
        &[2e-3; SLIDERS]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        for ((rate, z), length) in r.iter_mut().zip(s).zip(self.lengths) {
            // Slip begins above about four fifths of the slip force of an element, and only in the direction of
            // loading.
            let slips = if here.v * z > 0.0 { z.abs().powi(9) } else { 0.0 };
            *rate = here.v * (1.0 - slips) / length;
        }
    }
    fn parallel(&self, _: &Here, s: &[f64]) -> f64 {
        self.force * s.iter().zip(self.shares).map(|(z, share)| z * share).sum::<f64>()
    }
}

fn iwan(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let (shortest, longest) = (d.scale(6e-5, 1.5e-4), d.scale(0.8e-3, 2.5e-3));
    let chi = d.between(-0.4, 0.2);
    let lengths = std::array::from_fn(|i| shortest * libm::pow(longest / shortest, i as f64 / (SLIDERS - 1) as f64));
    let raw = lengths.map(|l: f64| libm::pow(l / shortest, chi));
    let sum: f64 = raw.iter().sum();
    let force = strength * scale.friction_n.max(25.0) * d.between(1.0, 2.2);
    Box::new(Iwan { force, lengths, shares: raw.map(|r| r / sum) })
}

/// Bouc and Wen's friction loop with different force levels in extension and compression (Song & Der Kiureghian, J.
/// Eng. Mech. 132, 2006).
///
/// The rate of slip depends separately on the signs of velocity and of force.
struct AsymmetricBoucWen {
    force: f64,
    length: f64,
    power: f64,
    /// Coefficient of sgn(v z) in the slip, with the velocity v and the relative friction force z. `lean` is the
    /// coefficient of sgn(v).
    beta: f64,
    lean: f64,
}

impl EffectModel for AsymmetricBoucWen {
    fn tolerances(&self) -> &[f64] {
        &[1e-3]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        let (v, z) = (here.v, s[0]);
        let size = libm::pow(z.abs(), self.power);
        let psi = self.beta * (v * z).signum() + (1.0 - self.beta) + self.lean * v.signum();
        r[0] = v * (1.0 - size * psi) / self.length;
    }
    fn parallel(&self, _: &Here, s: &[f64]) -> f64 {
        self.force * s[0]
    }
}

fn asymmetric_bouc_wen(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(AsymmetricBoucWen {
        force: strength * scale.friction_n.max(25.0) * d.between(1.0, 2.2),
        length: d.scale(1.5e-4, 8e-4),
        power: d.between(1.2, 2.2),
        beta: d.between(0.6, 0.85),
        lean: d.sign() * d.between(0.15, 0.35),
    })
}
