//! Spencer's modified Bouc-Wen model.
//!
//! B. F. Spencer, S. J. Dyke, M. K. Sain, J. D. Carlson, *Phenomenological model for magnetorheological dampers*, J. Eng. Mech. ASCE 123,
//! 1997. A Bouc-Wen element is in parallel with spring k₀ and dashpot c₀. A dashpot c₁ in series with these three rounds the force-velocity
//! loop at low speed. The accumulator, a spring k₁, is in parallel with the whole path: `(c₀ + c₁) ẏ = F_z z + c₀ ẋ + k₀ (x − y)`, `F = c₁
//! ẏ + k₁ x + f₀`. The displacement of the damper is x, and y is that of the point between dashpot c₁ and the other three. The relative
//! hysteretic force z follows from x − y ([`super::bouc_wen`]), and F_z is its amplitude. The paper has `k₁ (x − x₀)` with the free
//! position x₀ of the accumulator. Here a constant force f₀ = −k₁ x₀ replaces it, which avoids a division if k₁ is nearly zero.

use super::bouc_wen::BoucWen;
use super::bristle::{Shape, phi};
use super::law::{self, Law, Number};
use super::observation::{Observation, SampledMotion, Scales};
use serde::{Deserialize, Serialize};

/// Parameters of Spencer's model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Spencer {
    /// Amplitude F_z of the hysteretic force, N: the force α z of the paper at sliding.
    pub level_n: f64,
    /// Travel δ over which the hysteretic force builds up, m.
    pub stick_distance_m: f64,
    /// Sharpness n of the transition to sliding.
    pub sharpness: f64,
    /// Coefficient β of the hysteresis; the coefficient γ is 1 − β.
    pub beta: f64,
    /// Damping c₀ in parallel with the hysteresis, N s/m.
    pub inner_damping_n_s_m: f64,
    /// Stiffness k₀ in parallel with the hysteresis, N/m.
    pub inner_stiffness_n_m: f64,
    /// Damping c₁ in series with hysteresis, c₀ and k₀, N s/m.
    pub series_damping_n_s_m: f64,
    /// Stiffness k₁ of the accumulator, N/m.
    pub stiffness_n_m: f64,
    /// Constant force f₀, N.
    pub offset_n: f64,
}

/// Largest travel of one step, in units of the distance δ over which the hysteretic force builds up.
const STEP: f64 = 0.25;
/// Largest relative decay of the hysteresis deflection x − y in one step.
const DECAY: f64 = 0.5;
/// Largest number of steps between two samples. Only a start of the fit far from the solution needs as many.
const MOST: f64 = 24.0;

/// Series damping, relative to the largest force divided by the highest velocity of the tests, at which the series dashpot is practically
/// rigid.
const RIGID: f64 = 3e3;

/// Identifies the model from tests. Returns `None` if no start gives finite forces.
///
/// The Bouc-Wen model is a special case of this model, and the Bouc-Wen fit is one of the starts. Therefore, the least-squares cost is
/// practically never larger than that of the Bouc-Wen fit.
pub fn fit(tests: &[Observation]) -> Option<Spencer> {
    let s = Scales::from_tests(tests);
    let plain = law::fit::<BoucWen>(tests).map(|b| {
        vec![
            b.level_n,
            b.stick_distance_m,
            b.sharpness,
            b.beta,
            b.damping_n_s_m,
            0.0,
            RIGID * s.force / s.velocity,
            b.stiffness_n_m,
            b.offset_n,
        ]
    });
    law::fit_from(tests, &plain.into_iter().collect::<Vec<_>>())
}

#[derive(Clone, Copy)]
struct Memory {
    /// Normalized hysteresis z, −1..1.
    z: f64,
    /// Deflection x − y of the hysteresis, m.
    deflection: f64,
}

impl Law for Spencer {
    fn numbers(s: &Scales) -> Vec<Number> {
        let (stiff, damp) = (s.force / s.displacement, s.force / s.velocity);
        vec![
            Number::Log { low: 1e-3 * s.force, high: 10.0 * s.force },
            Number::Log { low: 1e-5 * s.displacement, high: 3.0 * s.displacement },
            Number::Log { low: 1.0, high: 20.0 },
            // With β below 0.5, the element would produce energy (Ikhouane & Rodellar, Systems with Hysteresis, 2007).
            Number::Plain { typical: 1.0, low: 0.5, high: 5.0 },
            Number::Plain { typical: damp, low: 0.0, high: 10.0 * damp },
            Number::Plain { typical: stiff, low: -2.0 * stiff, high: 10.0 * stiff },
            Number::Log { low: 1e-2 * damp, high: 1e4 * damp },
            Number::Plain { typical: stiff, low: -2.0 * stiff, high: 10.0 * stiff },
            Number::Plain { typical: s.force, low: -10.0 * s.force, high: 10.0 * s.force },
        ]
    }

    fn starts(s: &Scales) -> Vec<Vec<f64>> {
        let (stiff, damp) = (s.force / s.displacement, s.force / s.velocity);
        let mut starts = Vec::new();
        for stick in [0.005, 0.05] {
            for inner in [0.1, 0.5] {
                for series in [1.0, 10.0, 100.0] {
                    let (level, middle) = (0.5, 0.1 * stiff);
                    starts.push(vec![
                        level * s.force,
                        stick * s.displacement,
                        1.5,
                        0.5,
                        inner * damp,
                        0.02 * stiff,
                        series * damp,
                        middle,
                        -middle * s.middle,
                    ]);
                }
            }
        }
        starts
    }

    fn from_numbers(n: &[f64], _: &Scales) -> Self {
        Spencer {
            level_n: n[0],
            stick_distance_m: n[1],
            sharpness: n[2],
            beta: n[3],
            inner_damping_n_s_m: n[4],
            inner_stiffness_n_m: n[5],
            series_damping_n_s_m: n[6],
            stiffness_n_m: n[7],
            offset_n: n[8],
        }
    }

    fn forces(&self, motion: &SampledMotion) -> Vec<f64> {
        let (x, v) = (&motion.displacement, &motion.velocity);
        let shape = Shape { sharpness: self.sharpness, turning: self.beta };
        let sum = self.inner_damping_n_s_m + self.series_damping_n_s_m;
        // Returns the velocity ẏ of the point between the series dashpot and the Bouc-Wen element.
        let inner = |m: &Memory, v: f64| {
            (self.level_n * m.z + self.inner_damping_n_s_m * v + self.inner_stiffness_n_m * m.deflection) / sum
        };
        motion.run(Memory { z: 0.0, deflection: 0.0 }, |m, i| {
            if i > 0 && motion.dt[i] > 0.0 {
                let dt = motion.dt[i];
                let travel = (v[i].abs().max(v[i - 1].abs())) * dt / self.stick_distance_m;
                let decay = self.inner_stiffness_n_m.abs() / sum * dt;
                let steps = (travel / STEP).max(decay / DECAY).ceil().clamp(1.0, MOST);
                let h = dt / steps;
                // The mean velocity between two samples is the difference of the displacements divided by the time. Thus, the travels of
                // the steps add up to the measured travel.
                let mean = (x[i] - x[i - 1]) / dt;
                for k in 0..steps as usize {
                    let part = (k as f64 + 0.5) / steps;
                    let tilt = v[i] - v[i - 1];
                    let speed = mean + tilt * (part - 0.5);
                    let rate = (speed - inner(m, speed)) / self.stick_distance_m;
                    let direction = rate.signum();
                    let (bend, slope) = shape.rate(direction * m.z);
                    let slope = rate.abs() * slope - self.level_n / sum / self.stick_distance_m * bend;
                    m.z += h * rate * bend * phi(slope * h);
                    let relative = speed - inner(m, speed);
                    m.deflection += h * relative * phi(-self.inner_stiffness_n_m / sum * h);
                }
            }
            self.series_damping_n_s_m * inner(m, v[i]) + self.stiffness_n_m * x[i] + self.offset_n
        })
    }
}
