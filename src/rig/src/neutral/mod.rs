//! The neutral damper, into which effects are injected: the topology of the thesis (Jonnalagadda & Vyas 2020) with
//! other force laws.
//!
//! From the moving end inward, it has a series spring and damper, a small mass, and the valves in parallel with a weak
//! linear spring. Friction and a constant gas preload act in parallel with this series path. Without an injected
//! effect, the thesis's model represents the damper except for the shape of its force laws.

mod hidden;
mod instant;
mod motion;
mod valve_law;

pub(crate) use hidden::DamperEffect;
pub(crate) use instant::{Here, Line, Rest};
pub(crate) use motion::{OWN, System};
pub(crate) use valve_law::ValveLaw;

use crate::draw::Draw;

/// A damper with the topology of the thesis (Jonnalagadda & Vyas 2020).
#[derive(Debug, Clone)]
pub(crate) struct Neutral {
    pub valves: ValveLaw,
    /// Series spring and damper at the moving end.
    pub mount: Mount,
    /// Mass between series spring and valves, kg.
    pub mass_kg: f64,
    /// Stiffness of the weak spring in parallel with the valves, N/m.
    pub spring_n_m: f64,
    pub friction: Friction,
    /// Constant gas force, N.
    pub gas_n: f64,
}

/// Series spring and damper.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Mount {
    pub stiffness_n_m: f64,
    pub damping_n_s_m: f64,
}

/// Friction with a smooth sign of the velocity v, `v / sqrt(v² + eps²)`; eps is `smooth_m_s`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Friction {
    pub sliding_n: f64,
    /// Velocity scale eps of the sign change, m/s.
    pub smooth_m_s: f64,
    /// Ratio of the additional friction to the magnitude of the side force.
    pub side_force_ratio: f64,
}

impl Neutral {
    /// Computes the static force on the rod, N, at a displacement, m: the weak spring in series with the series spring,
    /// minus the gas force.
    pub fn rest_n(&self, displacement_m: f64) -> f64 {
        let series = self.mount.stiffness_n_m;
        series * self.spring_n_m / (series + self.spring_n_m) * displacement_m - self.gas_n
    }

    /// Draws the parameters of a damper at random, within the ranges of car dampers.
    pub fn draw(draw: &mut Draw) -> Self {
        let stiffness_n_m = draw.ratio("series_stiffness_n_m", 0.5e6, 5e6);
        let mass_kg = draw.ratio("mass_kg", 0.05, 0.5);
        let ratio = draw.between("series_damping_ratio", 0.1, 0.5);
        Self {
            mount: Mount { stiffness_n_m, damping_n_s_m: 2.0 * ratio * (stiffness_n_m * mass_kg).sqrt() },
            mass_kg,
            spring_n_m: draw.between("parallel_spring_n_m", 0.0, 1500.0),
            friction: Friction {
                sliding_n: draw.between("friction_n", 20.0, 60.0),
                smooth_m_s: draw.between("friction_smooth_m_s", 0.2e-3, 1.0e-3),
                side_force_ratio: draw.between("friction_side_share", 0.01, 0.04),
            },
            gas_n: draw.between("gas_n", 80.0, 300.0),
            valves: ValveLaw::draw(draw),
        }
    }
}
