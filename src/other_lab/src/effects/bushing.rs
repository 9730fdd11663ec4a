//! Injected effect of a rubber mount in series with the damper, with relaxation or internal slip.

use super::{Effect, EffectModel, Here, Make};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "bushing", laws: &[("fractional", fractional as Make), ("triboelastic", triboelastic)] };

const BRANCHES: usize = 5;

/// A force proportional to a fractional derivative of the mount's deflection, in parallel with a spring that is softer
/// than the mount.
///
/// Five Maxwell elements with time constants a factor of eight apart approximate the fractional derivative (Sjöberg &
/// Kari, Veh. Syst. Dyn. 37, 2002; Oustaloup's approximation).
struct Fractional {
    compliance: f64,
    stiffness: [f64; BRANCHES],
    times: [f64; BRANCHES],
}

impl EffectModel for Fractional {
    fn tolerances(&self) -> &[f64] {
        &[1e-7; BRANCHES]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        for ((rate, z), time) in r.iter_mut().zip(s).zip(self.times) {
            *rate = here.mount_rate - z / time;
        }
    }
    fn series(&self, _: &Here, _: &[f64]) -> f64 {
        self.compliance
    }
    fn parallel_to_mount(&self, _: &Here, s: &[f64]) -> f64 {
        s.iter().zip(self.stiffness).map(|(z, k)| z * k).sum()
    }
}

fn fractional(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let k = scale.series_n_m.min(1.5e6);
    let alpha = d.between(0.25, 0.45);
    let first = d.between(0.25, 0.5);
    let times = std::array::from_fn(|i| 1e-3 * 8f64.powi(i as i32));
    Box::new(Fractional {
        compliance: strength * d.between(1.5, 3.0) / k,
        stiffness: times.map(|t: f64| strength * first * scale.series_n_m * libm::pow(t / 1e-3, -alpha)),
        times,
    })
}

const SLIDERS: usize = 4;

/// Mount of filled rubber with friction in the filler (carbon black), so that it is stiffer for small motion than for
/// large motion.
///
/// The friction force grows with the root of the deflection since the last reversal (Coveney & Johnson, triboelastic
/// model, 1995; Fletcher & Gent 1953). The elastic part hardens like the hyperbolic sine.
struct Triboelastic {
    compliance: f64,
    hardens: f64,
    stiffness: [f64; SLIDERS],
    slips: [f64; SLIDERS],
}

impl EffectModel for Triboelastic {
    fn tolerances(&self) -> &[f64] {
        &[2e-3; SLIDERS]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        for ((rate, z), slip) in r.iter_mut().zip(s).zip(self.slips) {
            let d = here.mount_rate;
            *rate = if d * z > 0.0 { d * (1.0 - z.powi(4)) } else { d } / slip;
        }
    }
    fn series(&self, here: &Here, _: &[f64]) -> f64 {
        let r = here.mount / self.hardens;
        self.compliance / (1.0 + r * r).sqrt()
    }
    fn parallel_to_mount(&self, _: &Here, s: &[f64]) -> f64 {
        s.iter().zip(self.stiffness).zip(self.slips).map(|((z, k), slip)| k * slip * z).sum()
    }
}

fn triboelastic(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let k = scale.series_n_m.min(1.5e6);
    let first = d.between(0.4, 0.8);
    // The stiffness of each friction element is inversely proportional to the root of its slip length. The friction
    // force then grows with the root of the deflection.
    let slips: [f64; SLIDERS] = std::array::from_fn(|i| 2e-5 * 4f64.powi(i as i32));
    Box::new(Triboelastic {
        compliance: strength * d.between(1.5, 3.0) / k,
        hardens: d.between(0.3, 0.8) * scale.rebound_n,
        stiffness: slips.map(|s| strength * first * scale.series_n_m * (2e-5 / s).sqrt()),
        slips,
    })
}
