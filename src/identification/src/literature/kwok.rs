//! Kwok's hyperbolic tangent model.
//!
//! N. M. Kwok, Q. P. Ha, T. H. Nguyen, J. Li, B. Samali, *A novel hysteretic model for magnetorheological fluid dampers and parameter
//! identification using particle swarm optimization*, Sensors and Actuators A 132, 2006. `F = k x + c v + α tanh(β v + δ sgn x) + f₀` with
//! displacement x and velocity v. The spring has the stiffness k and the dashpot the damping c. The hyperbolic tangent has the amplitude α
//! and the steepness β, and δ is the width of the hysteresis loop. f₀ is a constant force. Here x in the sign function is relative to the
//! middle of each motion. The paper needs no such middle, because all motions on its rig have the same middle.

use super::law::{Law, Number};
use super::observation::{SampledMotion, Scales};
use serde::{Deserialize, Serialize};

/// Parameters of Kwok's model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Kwok {
    /// Amplitude α of the hyperbolic tangent, N.
    pub level_n: f64,
    /// Steepness β of the hyperbolic tangent, s/m.
    pub steepness_s_m: f64,
    /// Width δ of the hysteresis loop, dimensionless.
    pub width: f64,
    /// Stiffness k, N/m.
    pub stiffness_n_m: f64,
    /// Damping c, N s/m.
    pub damping_n_s_m: f64,
    /// Constant force f₀, N.
    pub offset_n: f64,
}

impl Law for Kwok {
    fn numbers(s: &Scales) -> Vec<Number> {
        vec![
            Number::positive(s.force),
            Number::Log { low: 0.01 / s.velocity, high: 1e4 / s.velocity },
            Number::Plain { typical: 1.0, low: -50.0, high: 50.0 },
            Number::linear(s.force / s.displacement),
            Number::positive(s.force / s.velocity),
            Number::linear(s.force),
        ]
    }

    fn starts(s: &Scales) -> Vec<Vec<f64>> {
        let mut starts = Vec::new();
        for steepness in [1.0, 3.0, 10.0, 30.0, 100.0, 300.0] {
            for width in [-2.0, -0.7, -0.2, 0.2, 0.7, 2.0] {
                starts.push(vec![0.0, steepness / s.velocity, width, 0.0, 0.0, 0.0]);
            }
        }
        starts
    }

    fn from_numbers(n: &[f64], _: &Scales) -> Self {
        Kwok {
            level_n: n[0],
            steepness_s_m: n[1],
            width: n[2],
            stiffness_n_m: n[3],
            damping_n_s_m: n[4],
            offset_n: n[5],
        }
    }

    fn forces(&self, motion: &SampledMotion) -> Vec<f64> {
        let middle = motion.middle();
        let sign = |x: f64| if x > middle { 1.0 } else { -1.0 };
        motion
            .displacement
            .iter()
            .zip(&motion.velocity)
            .map(|(x, v)| {
                let loop_force = self.level_n * libm::tanh(self.steepness_s_m * v + self.width * sign(*x));
                self.stiffness_n_m * x + self.damping_n_s_m * v + loop_force + self.offset_n
            })
            .collect()
    }
}
