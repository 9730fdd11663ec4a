//! What the rig adds to a record that the damper did not do: skew between channels, load-cell zero, drift.
//!
//! These belong to the measurement. They are taken out of the comparison and never put into the model.

use super::samples::Test;

/// An artefact of the measurement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Artefact {
    /// The force channel lags the motion channels, s.
    Delay,
    /// The load cell does not read zero without load, N.
    Offset,
    /// Its zero was set anew after this time on the campaign's clock, s: a step, N.
    Step(u32),
    /// The zero of the load cell moves with the campaign's clock, N/s.
    Drift,
    /// It settles while the rig warms up, within this time on the campaign's clock, s: the whole way, N.
    WarmUp(u32),
    /// Friction as a share of the force, as of a tilted cross-head that loads the guides.
    Guide,
    /// The growth of that share with displacement, 1/m.
    GuideAlong,
    /// A loop over force, whatever the speed, as a share of the force: that of a load cell which turns over within so much
    /// force, N.
    Loop(u32),
}

impl Artefact {
    /// Name in the vocabulary.
    pub fn name(self) -> &'static str {
        match self {
            Artefact::Delay => "channel_delay",
            Artefact::Offset | Artefact::Step(_) => "force_offset",
            Artefact::Drift | Artefact::WarmUp(_) => "force_drift",
            Artefact::Guide | Artefact::GuideAlong => "load_dependent_friction",
            Artefact::Loop(_) => "load_cell_hysteresis",
        }
    }

    /// Name of its one number.
    pub fn parameter(self) -> &'static str {
        match self {
            Artefact::Delay => "delay",
            Artefact::Offset | Artefact::Step(_) => "offset",
            Artefact::Drift => "drift",
            Artefact::WarmUp(_) => "whole_drift",
            Artefact::Guide | Artefact::Loop(_) => "share",
            Artefact::GuideAlong => "share_growth",
        }
    }

    /// Unit of its number.
    pub fn unit(self) -> &'static str {
        match self {
            Artefact::Delay => "s",
            Artefact::Offset | Artefact::Step(_) | Artefact::WarmUp(_) => "N",
            Artefact::Drift => "N/s",
            Artefact::Guide | Artefact::Loop(_) => "-",
            Artefact::GuideAlong => "1/m",
        }
    }

    /// Largest size that a rig shows.
    pub fn limit(self) -> f64 {
        match self {
            Artefact::Delay => 5e-3,
            Artefact::Offset | Artefact::Step(_) | Artefact::WarmUp(_) => 500.0,
            Artefact::Drift => 1.0,
            Artefact::Guide | Artefact::Loop(_) => 0.5,
            Artefact::GuideAlong => 10.0,
        }
    }

    /// What the force at the samples of a test becomes.
    pub fn apply(self, value: f64, test: &Test, forces: &mut [f64]) {
        match self {
            Artefact::Delay => delay(value, &test.segment.dt, forces),
            Artefact::Guide | Artefact::GuideAlong => {
                for (force, input) in forces.iter_mut().zip(&test.segment.input) {
                    let along = if self == Artefact::Guide { 1.0 } else { input.displacement.unwrap_or(0.0) };
                    *force += value * along * force.abs() * (input.velocity / TURNS).tanh();
                }
            }
            Artefact::Loop(width) => loop_over_force(value, f64::from(width), forces),
            Artefact::Offset | Artefact::Step(_) | Artefact::Drift | Artefact::WarmUp(_) => {
                let added = value * self.per_value(test).unwrap_or(0.0);
                forces.iter_mut().for_each(|f| *f += added);
            }
        }
    }

    /// Force that one unit of its number adds all through a test; `None` where it is no constant.
    pub fn per_value(self, test: &Test) -> Option<f64> {
        match self {
            Artefact::Delay | Artefact::Guide | Artefact::GuideAlong | Artefact::Loop(_) => None,
            Artefact::Offset => Some(1.0),
            Artefact::Step(after) => Some(f64::from(u8::from(test.clock > f64::from(after)))),
            Artefact::Drift => Some(test.clock),
            Artefact::WarmUp(time) => Some(1.0 - (-test.clock / f64::from(time)).exp()),
        }
    }
}

/// Speed within which friction in the guides turns over, m/s.
const TURNS: f64 = 2e-3;

/// Adds the share of the force, up while it rises and down while it falls; it turns over exponentially within `width`.
fn loop_over_force(share: f64, width: f64, forces: &mut [f64]) {
    let (mut way, mut last) = (0.0, forces.first().copied().unwrap_or(0.0));
    for force in forces {
        let rise = *force - last;
        last = *force;
        let stays = (-rise.abs() / width).exp();
        way = way * stays + rise.signum() * (1.0 - stays);
        *force += share * force.abs() * way;
    }
}

/// F(t) becomes F(t − τ), by cubic interpolation with slopes from neighbouring samples.
fn delay(tau: f64, dt: &[f64], forces: &mut [f64]) {
    let n = forces.len();
    if n < 3 || tau == 0.0 {
        return;
    }
    let before = forces.to_vec();
    let mut time = vec![0.0; n];
    for i in 1..n {
        time[i] = time[i - 1] + dt[i];
    }
    let slope = |i: usize| {
        let (a, b) = (i.saturating_sub(1), (i + 1).min(n - 1));
        (before[b] - before[a]) / (time[b] - time[a])
    };
    let mut right = 1;
    for i in 0..n {
        let t = (time[i] - tau).clamp(time[0], time[n - 1]);
        while right + 1 < n && time[right] < t {
            right += 1;
        }
        while right > 1 && time[right - 1] > t {
            right -= 1;
        }
        let left = right - 1;
        let h = time[right] - time[left];
        let s = (t - time[left]) / h;
        let (s2, s3) = (s * s, s * s * s);
        forces[i] = before[left] * (2.0 * s3 - 3.0 * s2 + 1.0)
            + before[right] * (3.0 * s2 - 2.0 * s3)
            + h * (slope(left) * (s3 - 2.0 * s2 + s) + slope(right) * (s3 - s2));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_over_force_does_not_know_the_speed_and_takes_energy_from_its_load() {
        let run = |per_cycle: usize| {
            let pure: Vec<f64> = (0..=2 * per_cycle)
                .map(|i| 1000.0 * (std::f64::consts::TAU * i as f64 / per_cycle as f64).sin())
                .collect();
            let mut read = pure.clone();
            loop_over_force(0.03, 100.0, &mut read);
            pure.iter().zip(&read).map(|(p, r)| (*p, r - p)).collect::<Vec<_>>()
        };
        let (slow, fast) = (run(4000), run(400));
        for (k, (_, added)) in fast.iter().enumerate().skip(400) {
            assert!((added - slow[10 * k].1).abs() < 0.5, "{k}");
        }
        // More while the force rises.
        let area: f64 = slow[4000..].windows(2).map(|w| 0.5 * (w[0].1 + w[1].1) * (w[1].0 - w[0].0)).sum();
        assert!(area > 0.5 * 0.03 * 2.0 * 1000.0 * 1000.0, "{area}");
    }

    #[test]
    fn a_delayed_sine_is_the_sine_of_an_earlier_time() {
        let dt = vec![1e-3; 400];
        let wave = |t: f64| 1000.0 * (30.0 * t).sin();
        for tau in [0.4e-3, -0.7e-3, 2.3e-3] {
            let mut forces: Vec<f64> = (0..400).map(|i| wave(f64::from(i) * 1e-3)).collect();
            delay(tau, &dt, &mut forces);
            for i in 5..395 {
                assert!((forces[i] - wave(i as f64 * 1e-3 - tau)).abs() < 0.02, "{i}");
            }
        }
    }
}
