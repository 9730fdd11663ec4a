//! Gas spring: how the gas force changes as the rod moves in and out, between isothermal (slow) and adiabatic (fast).

use crate::element::{Memory, Motion, Prepare, Recall, Share};
use crate::fault::Fault;
use crate::input::Path;
use crate::math::{drawn, power_inlined};
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// F = k L (1 − p/p_0) with the gas volume V/V_0 = ξ = 1 + x/L. The constant part, −p_0 A_rod, is `gas_preload`.
///
/// The state is z = p V^γ/(p_0 V_0^γ) − 1, which adiabatic motion keeps. With the gas temperature θ = T/T_0 =
/// (1 + z) ξ^(1−γ), heat through the wall, dT/dt = (T_0 − T)/τ at constant volume, makes it
/// dz/dt = (ξ^(γ−1) − 1 − z)/τ.
#[derive(Clone, Copy, Debug)]
pub struct GasSpring {
    /// k L.
    push: f64,
    /// 1/L.
    per_length: f64,
    /// γ.
    index: f64,
    /// 1/τ.
    per_time: f64,
}

/// The gas is not compressed further than to this share of its volume; the powers run on straight from there.
const SMALLEST: f64 = 0.05;

impl Describe for GasSpring {
    const MEANING: &'static str = "growth of the gas force with the displacement of the rod, slow to fast";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("gas_stiffness", "N/m", &[500.0], (0.0, 1e6), "slow (isothermal) stiffness at x = 0, k"),
        Parameter::scalar(
            "gas_length",
            "m",
            &[0.4],
            (0.05, 10.0),
            "gas volume at x = 0 over the area of the rod, L: how soon it stiffens",
        ),
        Parameter::scalar("gas_adiabatic_index", "-", &[1.4], (1.0, 1.67), "ratio of fast to slow stiffness, gamma"),
        Parameter::scalar(
            "gas_thermal_time",
            "s",
            &[3.0],
            (0.01, 1e3),
            "time in which the gas takes the temperature of its wall, tau",
        ),
    ];
}

impl Prepare for GasSpring {
    const OFF: Self = GasSpring { push: 0.0, per_length: 0.0, index: 1.0, per_time: 0.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let (stiffness, length) = (p.number(own!("gas_stiffness")), p.number(own!("gas_length")));
        Ok(GasSpring {
            push: stiffness * length,
            per_length: 1.0 / length,
            index: p.number(own!("gas_adiabatic_index")),
            per_time: 1.0 / p.number(own!("gas_thermal_time")),
        })
    }
}

impl GasSpring {
    /// ξ held above the smallest, what it is below that, and ξ^(γ−1).
    #[inline(always)]
    fn compressed(&self, x: f64) -> (f64, f64, f64) {
        let ratio = 1.0 + x * self.per_length;
        let inside = if ratio > SMALLEST { ratio } else { SMALLEST };
        (inside, ratio - inside, power_inlined(inside, self.index - 1.0))
    }

    /// What z is drawn to at `x`, with its first and second slope.
    fn rests(&self, x: f64) -> [f64; 3] {
        let (inside, below, value) = self.compressed(x);
        let per_inside = 1.0 / inside;
        let (rest, by_x) = self.prolonged(self.index - 1.0, value, per_inside, below);
        let bends = if below < 0.0 { 0.0 } else { (self.index - 2.0) * by_x * per_inside * self.per_length };
        [rest - 1.0, by_x, bends]
    }

    /// A power of ξ, prolonged straight, and its slope over x, from its exponent and its value at `inside`.
    #[inline(always)]
    fn prolonged(&self, exponent: f64, value: f64, per_inside: f64, below: f64) -> (f64, f64) {
        let slope = exponent * value * per_inside;
        (value + slope * below, slope * self.per_length)
    }
}

impl Memory for GasSpring {
    fn share(&self) -> Share {
        Share::Gas
    }

    fn recall(&self, at: &Motion, z: f64) -> Recall {
        let (inside, below, value) = self.compressed(at.displacement);
        let per_inside = 1.0 / inside;
        let (isothermal, isothermal_by_x) = self.prolonged(self.index - 1.0, value, per_inside, below);
        // ξ^−γ = 1/(ξ ξ^(γ−1))
        let (pressure, pressure_by_x) = self.prolonged(-self.index, per_inside / value, per_inside, below);
        Recall {
            force: self.push * (1.0 - (1.0 + z) * pressure),
            by_x: -self.push * (1.0 + z) * pressure_by_x,
            by_memory: -self.push * pressure,
            rate: (isothermal - 1.0 - z) * self.per_time,
            rate_by_x: isothermal_by_x * self.per_time,
            rate_by_memory: -self.per_time,
            ..Recall::NONE
        }
    }

    fn settled(&self, at: &Motion) -> f64 {
        self.rests(at.displacement)[0]
    }

    /// Exact but for the terms beyond the cubic of what it is drawn to on the way.
    fn carried(&self, path: &Path, z: f64, slopes: bool) -> Option<(f64, [f64; 2])> {
        let h = path.length();
        let (kept, takes) = drawn(h * self.per_time);
        let ((x0, v0), (x1, v1)) = (path.start(), path.end());
        let ([from, from_by_x, _], [to, to_by_x, to_bends]) = (self.rests(x0), self.rests(x1));
        // From both ends' values and slopes, as the path itself.
        let after = |to: f64, start: f64, end: f64| {
            takes[1] * start + takes[2] * (3.0 * to - 2.0 * start - end) + takes[3] * (start + end - 2.0 * to)
        };
        let end = kept * z + takes[0] * from + after(to - from, h * v0 * from_by_x, h * v1 * to_by_x);
        if !slopes {
            return Some((end, [0.0; 2]));
        }
        Some((end, [after(to_by_x, 0.0, h * v1 * to_bends), after(0.0, 0.0, h * to_by_x)]))
    }
}
