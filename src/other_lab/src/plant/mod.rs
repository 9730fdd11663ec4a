//! Dampers without a hidden effect. None of them is the model that is fitted to them: each carries friction with memory,
//! and the physical ones several small mismatches more.

mod ablation;
pub mod flow;
mod lumped;
pub(crate) mod monotube;
mod mount;
mod seal;
pub mod solenoid_valve;
mod twin_tube;

pub use ablation::Part;
pub use mount::Mount;
pub use seal::Seal;

use crate::draw::Draw;
use flow::Valves;
use monotube::Fluid;
use serde::{Deserialize, Serialize};

/// The kinds of damper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Input, series spring and damper, mass, a smooth force-velocity law; friction and gas parallel to the whole.
    ThesisLike,
    /// Piston between two chambers, gas behind a floating piston.
    Monotube,
    /// Piston, compression chamber, base valve, reserve with gas.
    TwinTube,
}

impl Kind {
    /// All.
    pub const ALL: [Kind; 3] = [Kind::ThesisLike, Kind::Monotube, Kind::TwinTube];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Kind::ThesisLike => "thesis_like",
            Kind::Monotube => "monotube",
            Kind::TwinTube => "twin_tube",
        }
    }
}

/// Effects on the oil other than those of the valves.
#[derive(Debug, Clone, Copy)]
pub struct OilContext {
    /// Velocity that passages beside the valves, or voids, take from the piston's, m/s.
    pub taken: f64,
    /// Compliance beside that of the oil, m/N.
    pub compliance: f64,
    /// What the valves pass, relative to what they are made for.
    pub gain: f64,
    /// Viscosity of the oil relative to that at the reference.
    pub viscosity: f64,
}

/// The part of a damper that the oil is in. Its states come after those of mount, mass and seal.
pub trait Oil: Send + Sync {
    /// Number of states.
    fn states(&self) -> usize;
    /// States at rest at a displacement.
    fn rest(&self, x: f64, states: &mut [f64]);
    /// Tolerances of the states.
    fn tolerances(&self, tolerances: &mut [f64]);
    /// Hydraulic force, N: what the pressures' differences make, without the gas.
    fn hydraulic(&self, states: &[f64]) -> f64;
    /// All that the oil does to the rod, N.
    fn force(&self, states: &[f64]) -> f64;
    /// Rates at displacement x and velocity v of the rod.
    fn rates(&self, x: f64, v: f64, beside: &OilContext, states: &[f64], rates: &mut [f64]);
    /// Removes a part of the oil's or the gas's physics; other parts leave it unchanged.
    fn remove(&mut self, part: Part);
}

/// What a damper is like, for effects that have to suit it.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Scale {
    /// Hydraulic force at 0.5 m/s in rebound, N.
    pub rebound_n: f64,
    /// Force in compression, as a positive number.
    pub compression_n: f64,
    /// Stiffness of what is in line with the damper, N/m.
    pub series_n_m: f64,
    /// Friction, N.
    pub friction_n: f64,
    /// Push of the gas at mid-stroke, N.
    pub gas_n: f64,
}

/// Small things that are never quite right.
#[derive(Debug, Clone, Copy)]
pub struct Slight {
    /// Rig mass on the damper's side of the load cell, kg.
    pub laden_kg: f64,
    /// Change of what the valves pass over the stroke, 1/m.
    pub position: f64,
    /// Share of the viscosity's exponent that the valves feel.
    pub warmth: f64,
    /// Stiffness of a gas column parallel to the damper, N/m, and its length, m.
    pub gas: [f64; 2],
}

/// How a physical damper is built: what a drawing of it would say.
#[derive(Debug, Clone)]
pub struct Built {
    /// Inner diameter of the tube in which the piston runs, m.
    pub bore_m: f64,
    /// Diameter of the rod, m.
    pub rod_m: f64,
    /// Length of the rebound chamber and of the oil below the piston at mid-stroke, m.
    pub lengths_m: [f64; 2],
    /// Absolute pressure of the gas at mid-stroke, bar.
    pub gas_bar: f64,
    /// Volume of the gas at mid-stroke, m³.
    pub gas_m3: f64,
    /// Bulk modulus of the oil without air, bar.
    pub oil_bar: f64,
    /// Volume of the air at 1 bar over that of the oil.
    pub air: f64,
    /// Valves of rebound and compression.
    pub valves: [Valves; 2],
    /// Areas on which they act, m².
    pub areas_m2: [f64; 2],
}

impl Built {
    /// Modulus of the oil with its air under the pressure of the gas, bar.
    pub fn modulus_bar(&self) -> f64 {
        1.0 / Fluid { oil: 1.0 / self.oil_bar, air: self.air, air_is_felt: true, void_is_felt: true }
            .compliance(self.gas_bar)
    }
}

/// A damper.
pub struct Plant {
    /// Which kind.
    pub kind: Kind,
    /// What is in line with it.
    pub mount: Mount,
    /// Mass behind the mount, kg.
    pub mass: f64,
    /// Friction.
    pub seal: Seal,
    /// Whether friction and gas act beside mount and oil together, as in the thesis, or behind the mount.
    pub seal_is_outside: bool,
    /// The oil.
    pub oil: Box<dyn Oil>,
    /// How it is built; `None` for a damper without chambers.
    pub built: Option<Built>,
    /// Small mismatches.
    pub slight: Slight,
    /// What it is like.
    pub scale: Scale,
}

impl Plant {
    /// The damper of a seed.
    pub fn new(kind: Kind, seed: u64) -> Plant {
        let mut d = Draw::new(seed, kind.name());
        match kind {
            Kind::ThesisLike => lumped::plant(&mut d),
            Kind::Monotube => monotube::plant(&mut d),
            Kind::TwinTube => twin_tube::plant(&mut d),
        }
    }
}

/// Rebound and compression force at 0.5 m/s: rebound is usually 1.3 to 3.5 times as firm.
fn forces(d: &mut Draw) -> (f64, f64) {
    let rebound = d.scale(450.0, 1900.0);
    (rebound, rebound / d.between(1.3, 3.5))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Air is felt above one atmosphere, a void below: what is removed of either leaves the other.
    #[test]
    fn oil_without_air_keeps_its_void() {
        let whole = monotube::Fluid { oil: 1e-4, air: 1e-3, air_is_felt: true, void_is_felt: true };
        let without = |part| {
            let mut fluid = whole;
            fluid.remove(part);
            fluid
        };
        let (aeration, cavitation) = (without(Part::Aeration), without(Part::Cavitation));
        assert!(aeration.compliance(5.0) < whole.compliance(5.0) && aeration.compliance(0.2) > 10.0 * whole.oil);
        assert!((cavitation.compliance(5.0) - whole.compliance(5.0)).abs() < 1e-15);
        // Vapor rounds the pressure by half a percent at 1 bar.
        assert!((cavitation.compliance(0.2) / cavitation.compliance(1.0) - 1.0).abs() < 0.02);
        assert!(without(Part::OilCompressibility).compliance(5.0) < 0.05 * whole.compliance(5.0));
    }
}
