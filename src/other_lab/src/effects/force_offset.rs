//! Injected measurement error of a force channel with a wrong zero.

use super::{Effect, EffectModel, Make, Reading};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const EFFECT: Effect =
    Effect { name: "force_offset", laws: &[("two_ranges", two_ranges as Make), ("warm_bridge", warm_bridge)] };

/// An amplifier with a fine and a coarse range that have different zeros. The largest force of a test selects the
/// range.
struct TwoRanges {
    fine: f64,
    coarse: f64,
    switches: f64,
}

impl EffectModel for TwoRanges {
    fn reads(&self, at: &Reading) -> f64 {
        if at.peak < self.switches { self.fine } else { self.coarse }
    }
}

fn two_ranges(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let coarse = strength * d.sign() * d.between(0.03, 0.08) * scale.rebound_n;
    Box::new(TwoRanges { fine: coarse * d.between(0.3, 0.7), coarse, switches: d.between(0.15, 0.4) * scale.rebound_n })
}

/// A strain-gauge bridge that was balanced at low temperature. Its zero depends on the temperature near the damper
/// (Hoffmann, An Introduction to Stress Analysis using Strain Gauges).
struct WarmBridge {
    constant: f64,
    per_kelvin: f64,
}

impl EffectModel for WarmBridge {
    fn reads(&self, at: &Reading) -> f64 {
        self.constant + self.per_kelvin * (at.oil_c - 20.0)
    }
}

fn warm_bridge(strength: f64, scale: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let constant = strength * d.sign() * d.between(0.02, 0.06) * scale.rebound_n;
    Box::new(WarmBridge { constant, per_kelvin: constant * d.between(0.01, 0.03) })
}
