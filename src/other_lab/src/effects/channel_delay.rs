//! Injected measurement error of a delayed force channel.

use super::{Effect, EffectModel, Make};
use crate::draw::Draw;
use crate::plant::Scale;
use crate::trace::interpolate;

pub(super) const EFFECT: Effect =
    Effect { name: "channel_delay", laws: &[("latency", latency as Make), ("boxcar", boxcar)] };

/// An analog-to-digital converter with a queue of samples after a first-order filter. The delay by the queue differs
/// from test to test.
struct Latency {
    queue: f64,
    varies: f64,
    filter: f64,
    seed: u64,
}

impl EffectModel for Latency {
    fn channel(&self, test: u64, time: &[f64], force: &mut Vec<f64>) {
        let late = self.queue * (1.0 + self.varies * Draw::new(self.seed ^ test, "queue").between(-1.0, 1.0));
        let mut filtered = force.clone();
        let mut state = force[0];
        for i in 1..time.len() {
            let h = time[i] - time[i - 1];
            // This step of the first-order filter is exact for a force that is linear between the sample times.
            let (e, slope) = (libm::exp(-h / self.filter), (force[i] - force[i - 1]) / h);
            state = force[i] - slope * self.filter + (state - force[i - 1] + slope * self.filter) * e;
            filtered[i] = state;
        }
        *force = time.iter().map(|t| interpolate(time, &filtered, t - late)).collect();
    }
}

fn latency(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let all = strength.max(1e-6) * d.between(1.2e-3, 2.5e-3);
    let filter = all * d.between(0.3, 0.6);
    Box::new(Latency { queue: all - filter, varies: d.between(0.1, 0.3), filter, seed: (d.fraction() * 1e9) as u64 })
}

/// An analog-to-digital converter that integrates over a time window and returns the mean at the end of the window
/// (dual-slope conversion; Horowitz & Hill).
struct Boxcar {
    window: f64,
}

impl EffectModel for Boxcar {
    fn channel(&self, _: u64, time: &[f64], force: &mut Vec<f64>) {
        const PARTS: usize = 16;
        let mean = |t: &f64| {
            (0..PARTS).map(|i| interpolate(time, force, t - self.window * (i as f64 + 0.5) / PARTS as f64)).sum::<f64>()
                / PARTS as f64
        };
        *force = time.iter().map(mean).collect();
    }
}

fn boxcar(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    Box::new(Boxcar { window: strength.max(1e-6) * d.between(2.4e-3, 5e-3) })
}
