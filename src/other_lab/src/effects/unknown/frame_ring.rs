//! Injected unknown effect: the rig's frame vibrates in two modes after every sudden change of force.

use super::{Draw, Effect, EffectModel, Make, Scale};

pub(super) const EFFECT: Effect = Effect { name: "frame_ring", laws: &[("two_modes", two_modes as Make)] };

/// Two modes of the frame that the damper force excites. Their accelerations act on the load cell (Ewins, Modal
/// Testing, 2000).
struct TwoModes {
    share: f64,
    /// Angular frequency (rad/s) and damping ratio of each mode.
    modes: [[f64; 2]; 2],
}

impl EffectModel for TwoModes {
    fn channel(&self, _: u64, time: &[f64], force: &mut Vec<f64>) {
        let drives = force.clone();
        for [omega, damping] in self.modes {
            let (mut y, mut rate) = (drives[0], 0.0);
            for i in 1..time.len() {
                // The midpoint rule integrates each mode, with steps of at most 0.1 divided by the mode's angular
                // frequency.
                let parts = ((time[i] - time[i - 1]) * omega / 0.1).ceil().max(1.0) as usize;
                let h = (time[i] - time[i - 1]) / parts as f64;
                for part in 0..parts {
                    let drive = drives[i - 1] + (drives[i] - drives[i - 1]) * (part as f64 + 0.5) / parts as f64;
                    let pull = |y: f64, rate: f64| omega * omega * (drive - y) - 2.0 * damping * omega * rate;
                    let (half_y, half_rate) = (y + 0.5 * h * rate, rate + 0.5 * h * pull(y, rate));
                    y += h * half_rate;
                    rate += h * pull(half_y, half_rate);
                }
                force[i] += self.share * (y - drives[i]);
            }
        }
    }
}

fn two_modes(strength: f64, _: &Scale, d: &mut Draw) -> Box<dyn EffectModel> {
    let first = std::f64::consts::TAU * d.scale(18.0, 40.0);
    Box::new(TwoModes {
        share: strength * d.between(0.1, 0.25),
        modes: [[first, d.between(0.02, 0.08)], [first * d.between(1.5, 2.4), d.between(0.02, 0.08)]],
    })
}
