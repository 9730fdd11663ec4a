//! Laws of the stops at the two ends of the stroke. The stop at each end is a separate effect.

use super::{EffectModel, Here};
use crate::draw::Draw;
use crate::plant::Scale;

/// Stop of microcellular polyurethane with a relaxing part (Zener).
///
/// The force has a plateau while the cells buckle, and increases steeply when they close (Gibson & Ashby, Cellular
/// Solids, 1997).
pub(super) struct Foam {
    /// +1 at the end of rebound, -1 at the end of compression.
    side: f64,
    clearance: f64,
    plateau: f64,
    buckles: f64,
    closes: f64,
    relaxing: f64,
    time: f64,
}

impl Foam {
    fn static_force(&self, depth: f64) -> f64 {
        let depth = depth.max(0.0);
        self.plateau * (libm::tanh(depth / self.buckles) + (depth / self.closes).powi(4))
    }
}

impl EffectModel for Foam {
    fn tolerances(&self) -> &[f64] {
        &[0.5]
    }
    fn rates(&self, here: &Here, s: &[f64], r: &mut [f64]) {
        // The state is a force, N, that follows the static force of the stop with a first-order lag.
        r[0] = (self.static_force(self.side * here.x - self.clearance) - s[0]) / self.time;
    }
    fn parallel(&self, here: &Here, s: &[f64]) -> f64 {
        let depth = self.side * here.x - self.clearance;
        if depth <= 0.0 {
            return 0.0;
        }
        let held = self.static_force(depth);
        self.side * (held + self.relaxing * (held - s[0])).max(0.0)
    }
}

pub(super) fn foam(strength: f64, scale: &Scale, d: &mut Draw, side: f64) -> Box<dyn EffectModel> {
    Box::new(Foam {
        side,
        clearance: d.between(0.022, 0.038),
        plateau: strength * d.between(0.3, 0.7) * scale.rebound_n,
        buckles: d.between(3e-3, 6e-3),
        closes: d.between(0.012, 0.02),
        relaxing: d.between(0.2, 0.5),
        time: d.scale(0.02, 0.2),
    })
}

const HOLES: usize = 4;

/// Hydraulic stop: a ring that covers successive rows of holes, in parallel with a preloaded coil spring.
///
/// The hydraulic force grows with the power 1.75 of velocity, and in steps over the stroke. The spring force jumps at
/// contact (Czop & Sławik, Mech. Syst. Signal Process. 25, 2011; Reimpell, The Automotive Chassis, 2001).
pub(super) struct Holes {
    side: f64,
    clearance: f64,
    pitch: f64,
    /// Hydraulic force at 1 m/s per covered row of holes, N.
    row: f64,
    preload: f64,
    rate: f64,
}

impl EffectModel for Holes {
    fn parallel(&self, here: &Here, _: &[f64]) -> f64 {
        let depth = self.side * here.x - self.clearance;
        if depth <= 0.0 {
            return 0.0;
        }
        let met = 1.0 - libm::exp(-(depth / 4e-4).powi(2));
        let coil = self.preload * met + self.rate * depth;
        let covered: f64 = (0..HOLES)
            .map(|i| {
                let u = ((depth - i as f64 * self.pitch) / (0.35 * self.pitch)).clamp(0.0, 1.0);
                u * u * (3.0 - 2.0 * u)
            })
            .sum();
        let inward = (self.side * here.v).max(0.0);
        self.side * (coil + self.row * covered * libm::pow(inward, 1.75))
    }
}

pub(super) fn holes(strength: f64, scale: &Scale, d: &mut Draw, side: f64) -> Box<dyn EffectModel> {
    Box::new(Holes {
        side,
        clearance: d.between(0.022, 0.036),
        pitch: d.between(3e-3, 6e-3),
        row: strength * d.between(0.8, 2.0) * scale.rebound_n,
        preload: strength * d.between(0.05, 0.15) * scale.rebound_n,
        rate: strength * d.between(4.0, 12.0) * scale.rebound_n,
    })
}
