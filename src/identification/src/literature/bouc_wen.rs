//! Bouc-Wen hysteresis in parallel with a spring and a dashpot.
//!
//! R. Bouc, *Forced vibration of mechanical systems with hysteresis*, Prague 1967; Y.-K. Wen, *Method for random vibration of hysteretic
//! systems*, J. Eng. Mech. Div. ASCE 102, 1976. `F = k x + c v + F_z z + f₀`, `ż = (v − β |v| |z|ⁿ⁻¹ z − γ v |z|ⁿ)/δ`. With β + γ = 1, z
//! slides at ±1. Here x is the displacement, v the velocity, and z the relative hysteretic force. The spring has the stiffness k, the
//! dashpot the damping c, and the hysteretic force the amplitude F_z. The hysteretic force builds up over the travel δ, with the sharpness
//! n and the coefficients β and γ. f₀ is a constant force.

use super::bristle::Shape;
use super::law::{Law, Number};
use super::observation::{SampledMotion, Scales};
use serde::{Deserialize, Serialize};

/// Parameters of the Bouc-Wen model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BoucWen {
    /// Amplitude F_z of the hysteretic force, N.
    pub level_n: f64,
    /// Travel δ over which the hysteretic force builds up, m.
    pub stick_distance_m: f64,
    /// Sharpness n of the transition to sliding.
    pub sharpness: f64,
    /// Coefficient β of the hysteresis; the coefficient γ is 1 − β.
    pub beta: f64,
    /// Stiffness k, N/m.
    pub stiffness_n_m: f64,
    /// Damping c, N s/m.
    pub damping_n_s_m: f64,
    /// Constant force f₀, N.
    pub offset_n: f64,
}

impl Law for BoucWen {
    fn numbers(s: &Scales) -> Vec<Number> {
        vec![
            Number::positive(s.force),
            Number::Log { low: 1e-6 * s.displacement, high: 10.0 * s.displacement },
            Number::Log { low: 1.0, high: 20.0 },
            // With β below 0.5, the element would produce energy (Ikhouane & Rodellar, Systems with Hysteresis, 2007).
            Number::Plain { typical: 1.0, low: 0.5, high: 5.0 },
            Number::linear(s.force / s.displacement),
            Number::positive(s.force / s.velocity),
            Number::linear(s.force),
        ]
    }

    fn starts(s: &Scales) -> Vec<Vec<f64>> {
        let mut starts = Vec::new();
        for stick in [0.002, 0.01, 0.03, 0.1, 0.3] {
            for sharpness in [1.1, 2.0] {
                for beta in [0.5, 1.0] {
                    starts.push(vec![0.0, stick * s.displacement, sharpness, beta, 0.0, 0.0, 0.0]);
                }
            }
        }
        starts
    }

    fn from_numbers(n: &[f64], _: &Scales) -> Self {
        BoucWen {
            level_n: n[0],
            stick_distance_m: n[1],
            sharpness: n[2],
            beta: n[3],
            stiffness_n_m: n[4],
            damping_n_s_m: n[5],
            offset_n: n[6],
        }
    }

    fn forces(&self, motion: &SampledMotion) -> Vec<f64> {
        let (x, v) = (&motion.displacement, &motion.velocity);
        let shape = Shape { sharpness: self.sharpness, turning: self.beta };
        motion.run(0.0f64, |z, i| {
            if i > 0 {
                *z = shape.after(*z, (x[i] - x[i - 1]) / self.stick_distance_m);
            }
            self.stiffness_n_m * x[i] + self.damping_n_s_m * v[i] + self.level_n * *z + self.offset_n
        })
    }
}
