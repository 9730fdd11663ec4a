//! Series spring and damper between the moving end and the internal mass: the compressibility of gas, oil and mount.
//!
//! Source: Jonnalagadda & Vyas, KTH 2020, chapter 3, F_s and m.

use crate::element::Prepare;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Series spring and damper with the force F_s = k_s (x_in − x_m) + c_s (v_in − v_m), and the internal mass m.
///
/// The mass moves by m dv_m/dt = F_s − F_p(x_m) − F_d(v_m), with the forces F_p of the parallel spring and F_d of the
/// FV curve. x is a displacement, m, and v a velocity, m/s; the index `in` means the moving end, the index m the
/// internal mass. k_s is the stiffness, N/m, and c_s the damping, N s/m.
///
/// In the source, friction and gas are parallel to the whole damper and move with the moving end. The compliance of an
/// eye or a mount, however, carries the whole force. Friction and gas then act on the mass, and F_s is the total force.
#[derive(Clone, Copy, Debug)]
pub struct SeriesCompliance {
    /// Stiffness k_s of the series spring, N/m.
    pub stiffness: f64,
    /// Damping c_s of the series damper, N s/m.
    pub damping: f64,
    /// Internal mass m, kg.
    pub mass: f64,
    /// Whether friction and gas act on the mass, so that the compliance also carries their force.
    pub carries_whole: bool,
}

impl Describe for SeriesCompliance {
    const MEANING: &'static str = "series spring and damper with the internal mass: compliance of gas, oil and mounts";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("series_stiffness", "N/m", &[3.0e6], (1e4, 1e8), "stiffness of the series spring, k_s"),
        Parameter::scalar(
            "series_damping",
            "N s/m",
            &[200.0],
            (0.0, 1e5),
            "damping coefficient parallel to the series spring, c_s",
        ),
        Parameter::scalar("internal_mass", "kg", &[0.5], (0.005, 20.0), "internal moving mass of rod, oil and gas, m"),
        Parameter::choice(
            "series_load",
            &["hydraulic", "whole"],
            "forces that the series spring carries: hydraulic and parallel spring force, or friction and gas force as well (eye or mount)",
        ),
    ];
}

impl Prepare for SeriesCompliance {
    const OFF: Self = SeriesCompliance { stiffness: 0.0, damping: 0.0, mass: 0.0, carries_whole: false };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(SeriesCompliance {
            stiffness: p.number(own!("series_stiffness")),
            damping: p.number(own!("series_damping")),
            mass: p.number(own!("internal_mass")),
            carries_whole: p.number(own!("series_load")) == 1.0,
        })
    }
}
