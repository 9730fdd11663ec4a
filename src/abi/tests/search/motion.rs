//! Random motions, ordinary and extreme.

use crate::case::{Case, Given};
use dashpot_test_support::Random;
use std::f64::consts::TAU;

/// Step sizes of hosts, s.
const STEPS: [f64; 6] = [1e-5, 1e-4, 2.5e-4, 1e-3, 2e-3, 1e-2];

impl Case {
    /// Adds a random motion of `count` steps.
    pub fn moved(mut self, r: &mut Random, count: usize) -> Case {
        if r.chance(0.1) {
            self.ordinary = false;
            self.motion = (0..count.min(60)).map(|_| wild(r)).collect();
            self.start = extreme(r, 1e3);
            return self;
        }
        let dt = STEPS[r.one_of(STEPS.len())];
        let knows = r.chance(0.7);
        let temperature = r.between(-40.0, 150.0);
        let side = if r.chance(0.3) { r.between(-5e3, 5e3) } else { 0.0 };
        let speed = r.decade(1e-3, 5.0);
        let stroke = r.decade(2e-4, 0.1);
        let kind = r.one_of(4);
        let (frequency, phase) = ((speed / (TAU * stroke)).min(100.0), r.between(0.0, TAU));
        let w = TAU * frequency;
        let at = |t: f64| (stroke * (w * t + phase).sin(), stroke * w * (w * t + phase).cos());
        let (mut x, mut v) = if kind == 0 { at(0.0) } else { (r.between(-stroke, stroke), 0.0) };
        self.start = x;
        for i in 0..count {
            let before = (x, v);
            match kind {
                // Draw a sine.
                0 => (x, v) = at((i + 1) as f64 * dt),
                // Draw a speed that reverses at random. The displacement is its integral.
                1 => v = if r.chance(0.2) { r.between(-speed, speed) } else { v },
                // Draw a velocity that alternates from step to step.
                2 => v = if i % 2 == 0 { speed } else { -speed },
                // Draw a random walk.
                _ => v = (v + 0.3 * r.between(-speed, speed)).clamp(-speed, speed),
            }
            if kind != 0 {
                // Reverse the motion at the ends of the stroke.
                if (before.0 > stroke && v > 0.0) || (before.0 < -stroke && v < 0.0) {
                    v = -v;
                }
                x = before.0 + 0.5 * dt * (before.1 + v);
            }
            self.motion.push(Given { x: knows.then_some(x), v, side, temperature, dt });
        }
        self
    }
}

fn extreme(r: &mut Random, top: f64) -> f64 {
    match r.one_of(6) {
        0 => 0.0,
        1 => -0.0,
        2 => r.between(-1.0, 1.0),
        _ => {
            let size = r.decade(1e-300, top * 1.5).min(top * 1.5);
            let size = if r.chance(0.5) { r.decade(1e-6, top * 1.5) } else { size };
            if r.chance(0.5) { size } else { -size }
        }
    }
}

/// Draws an arbitrary input of a faulty host.
fn wild(r: &mut Random) -> Given {
    Given {
        x: r.chance(0.6).then(|| extreme(r, 1e9)),
        v: extreme(r, 1e9),
        side: extreme(r, 1e9),
        temperature: extreme(r, 1e9),
        dt: if r.chance(0.3) { 0.0 } else { r.decade(1e-16, 2e9) },
    }
}
