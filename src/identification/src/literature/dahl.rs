//! Dahl friction in parallel with a spring and a dashpot.
//!
//! P. R. Dahl, *A solid friction model*, The Aerospace Corporation, TOR-0158(3107-18)-1, 1968. F. Ikhouane and S. J. Dyke use it for
//! magnetorheological dampers (Smart Mater. Struct. 16, 2007).
//! `F = k x + c v + F_c z + f₀`, `dz/dx = (1 − z sgn v)/δ`. Here x is the displacement, v the velocity, and z the relative friction, which
//! slides at ±1. The spring has the stiffness k, the dashpot the damping c, and the friction the sliding force F_c. Friction builds up
//! over the travel δ, and f₀ is a constant force.

use super::law::{Law, Number};
use super::observation::{SampledMotion, Scales};
use serde::{Deserialize, Serialize};

/// Parameters of the Dahl model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Dahl {
    /// Friction force F_c at sliding, N.
    pub friction_n: f64,
    /// Travel δ over which friction builds up, m.
    pub stick_distance_m: f64,
    /// Stiffness k, N/m.
    pub stiffness_n_m: f64,
    /// Damping c, N s/m.
    pub damping_n_s_m: f64,
    /// Constant force f₀, N.
    pub offset_n: f64,
}

impl Law for Dahl {
    fn numbers(s: &Scales) -> Vec<Number> {
        vec![
            Number::positive(s.force),
            Number::Log { low: 1e-6 * s.displacement, high: 10.0 * s.displacement },
            Number::linear(s.force / s.displacement),
            Number::positive(s.force / s.velocity),
            Number::linear(s.force),
        ]
    }

    fn starts(s: &Scales) -> Vec<Vec<f64>> {
        [0.001, 0.003, 0.01, 0.03, 0.1, 0.3].map(|part| vec![0.0, part * s.displacement, 0.0, 0.0, 0.0]).to_vec()
    }

    fn from_numbers(n: &[f64], _: &Scales) -> Self {
        Dahl { friction_n: n[0], stick_distance_m: n[1], stiffness_n_m: n[2], damping_n_s_m: n[3], offset_n: n[4] }
    }

    fn forces(&self, motion: &SampledMotion) -> Vec<f64> {
        let (x, v) = (&motion.displacement, &motion.velocity);
        motion.run(0.0f64, |z, i| {
            if i > 0 {
                let travel = (x[i] - x[i - 1]) / self.stick_distance_m;
                let direction = travel.signum();
                *z = direction + (*z - direction) * libm::exp(-travel.abs());
            }
            self.stiffness_n_m * x[i] + self.damping_n_s_m * v[i] + self.friction_n * *z + self.offset_n
        })
    }
}
