//! Piecewise-linear force-velocity curve.
//!
//! Jonnalagadda & Vyas compare this model with their own (*Modelling of Automotive Suspension Damper*, KTH 2020, chapter 2). The model has
//! rebound slopes Cr1 to Cr3 with two knees, compression slopes Cc1 and Cc2 with one knee, and a constant gas force. Without the gas force,
//! the curve passes through the origin.

use super::law::{Law, Number};
use super::observation::{SampledMotion, Scales};
use dashpot_core::{Params, element, number, parameter};
use serde::{Deserialize, Serialize};

/// Kernel parameters of the piecewise-linear form of the FV curve: slopes, N s/m, and knees, m/s.
pub const COEFFICIENTS_AND_KNEES: [parameter::Number; 8] = [
    number!("fv_rebound_c1"),
    number!("fv_rebound_c2"),
    number!("fv_rebound_c3"),
    number!("fv_rebound_v1"),
    number!("fv_rebound_v2"),
    number!("fv_compression_c1"),
    number!("fv_compression_c2"),
    number!("fv_compression_v1"),
];

/// Parameters of the piecewise-linear curve.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PiecewiseLinear {
    /// Rebound slopes Cr1, Cr2 and Cr3, N s/m.
    pub rebound_coefficients_n_s_m: [f64; 3],
    /// First and second rebound knee, m/s.
    pub rebound_knees_m_s: [f64; 2],
    /// Compression slopes Cc1 and Cc2, N s/m.
    pub compression_coefficients_n_s_m: [f64; 2],
    /// Speed of the compression knee, m/s, positive.
    pub compression_knee_m_s: f64,
    /// Gas force, which pushes the rod out, N.
    pub gas_force_n: f64,
}

impl PiecewiseLinear {
    fn at(&self, v: f64) -> f64 {
        let [c1, c2, c3] = self.rebound_coefficients_n_s_m;
        let [v1, v2] = self.rebound_knees_m_s;
        let [b1, b2] = self.compression_coefficients_n_s_m;
        let knee = self.compression_knee_m_s;
        let curve = if v >= 0.0 {
            c1 * v.min(v1) + c2 * (v.min(v2) - v1).max(0.0) + c3 * (v - v2).max(0.0)
        } else {
            -(b1 * (-v).min(knee) + b2 * (-v - knee).max(0.0))
        };
        curve - self.gas_force_n
    }

    /// Converts the curve to a parameter set of the kernel, which has a piecewise-linear form of the FV curve.
    pub fn params(&self) -> Params {
        let mut params = Params::new();
        params.disable_all();
        params.enable(element!("fv_curve"), true);
        params.enable(element!("gas_preload"), true);
        let _ = params.set(number!("fv_form"), 1.0);
        let [c1, c2, c3] = self.rebound_coefficients_n_s_m;
        let [v1, v2] = self.rebound_knees_m_s;
        let [b1, b2] = self.compression_coefficients_n_s_m;
        let curve = COEFFICIENTS_AND_KNEES.into_iter().zip([c1, c2, c3, v1, v2, b1, b2, self.compression_knee_m_s]);
        for (number, value) in curve.chain([(number!("gas_force"), self.gas_force_n)]) {
            let _ = params.set(number, number.inside(value));
        }
        params
    }
}

impl Law for PiecewiseLinear {
    fn numbers(s: &Scales) -> Vec<Number> {
        let slope = Number::Linear { typical: s.force / s.velocity, low: 0.0, high: 1e6 };
        let knee = Number::Log { low: (1e-3 * s.velocity).max(1e-4), high: s.velocity.min(9.0) };
        // The unknown of the second rebound knee is its distance from the first knee, so the knees keep their order.
        vec![slope, slope, slope, knee, knee, slope, slope, knee, Number::linear(s.force)]
    }

    fn starts(s: &Scales) -> Vec<Vec<f64>> {
        let mut starts = Vec::new();
        for first in [0.01, 0.03, 0.1, 0.3] {
            for second in [0.1, 0.4] {
                for knee in [0.01, 0.05, 0.2] {
                    let (a, b, c) = (first * s.velocity, second * s.velocity, knee * s.velocity);
                    starts.push(vec![0.0, 0.0, 0.0, a, b, 0.0, 0.0, c, 0.0]);
                }
            }
        }
        starts
    }

    fn from_numbers(n: &[f64], _: &Scales) -> Self {
        PiecewiseLinear {
            rebound_coefficients_n_s_m: [n[0], n[1], n[2]],
            rebound_knees_m_s: [n[3], n[3] + n[4]],
            compression_coefficients_n_s_m: [n[5], n[6]],
            compression_knee_m_s: n[7],
            gas_force_n: n[8],
        }
    }

    fn forces(&self, motion: &SampledMotion) -> Vec<f64> {
        motion.velocity.iter().map(|v| self.at(*v)).collect()
    }
}
