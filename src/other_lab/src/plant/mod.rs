//! Dampers without an injected effect. All these dampers differ from the identified model: each has friction with
//! internal states. The dampers with oil chambers have several further small deviations.

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

/// Kinds of simulated damper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// Series spring and damper, mass, and a smooth force-velocity law, in one force path. Friction and gas act in
    /// parallel with this path.
    ThesisLike,
    /// Piston between two chambers, gas behind a floating piston.
    Monotube,
    /// Piston between two chambers, a base valve, and a reserve with gas.
    TwinTube,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Kind; 3] = [Kind::ThesisLike, Kind::Monotube, Kind::TwinTube];

    /// Returns the name of this kind of damper, as in files.
    pub fn name(self) -> &'static str {
        match self {
            Kind::ThesisLike => "thesis_like",
            Kind::Monotube => "monotube",
            Kind::TwinTube => "twin_tube",
        }
    }
}

/// Influences on the flow of the oil, in addition to the valve laws.
#[derive(Debug, Clone, Copy)]
pub struct OilContext {
    /// Flow through bypasses or into voids, as a piston velocity, m/s.
    pub taken: f64,
    /// Compliance in addition to that of the oil, m/N.
    pub compliance: f64,
    /// Factor by which the flow through the valves is multiplied.
    pub gain: f64,
    /// Ratio of the oil's viscosity to that at 25 °C.
    pub viscosity: f64,
}

/// The hydraulic part of a damper. In the state vector of the damper, its states come after those of mount, mass and
/// seal.
pub trait Oil: Send + Sync {
    /// Returns the number of hydraulic states.
    fn states(&self) -> usize;
    /// Computes the hydraulic states in equilibrium at the displacement `x`, m.
    fn rest(&self, x: f64, states: &mut [f64]);
    /// Stores the error tolerances of the hydraulic states in `tolerances`.
    fn tolerances(&self, tolerances: &mut [f64]);
    /// Computes the hydraulic force from the pressure differences, without the gas, N.
    fn hydraulic(&self, states: &[f64]) -> f64;
    /// Computes the total force of the oil on the rod, N.
    fn force(&self, states: &[f64]) -> f64;
    /// Computes the time derivatives of the hydraulic states at the displacement `x`, m, and velocity `v`, m/s, of the
    /// rod.
    fn rates(&self, x: f64, v: f64, beside: &OilContext, states: &[f64], rates: &mut [f64]);
    /// Removes a part of the damper's physics if it belongs to oil or gas. For other parts, nothing changes.
    fn remove(&mut self, part: Part);
}

/// Characteristic values of a damper, for scaling the effects.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Scale {
    /// Hydraulic force at 0.5 m/s in rebound, N.
    pub rebound_n: f64,
    /// Hydraulic force at 0.5 m/s in compression, positive, N.
    pub compression_n: f64,
    /// Stiffness of the mount in series with the damper, N/m.
    pub series_n_m: f64,
    /// Sliding friction, N.
    pub friction_n: f64,
    /// Gas force at mid-stroke, N.
    pub gas_n: f64,
}

/// Small deviations from an ideal damper and rig.
#[derive(Debug, Clone, Copy)]
pub struct Slight {
    /// Rig mass on the damper's side of the load cell, kg.
    pub laden_kg: f64,
    /// Relative change of the valve flow per displacement, 1/m.
    pub position: f64,
    /// Fraction of the viscosity's temperature exponent that acts in the valves.
    pub warmth: f64,
    /// Stiffness at mid-stroke, N/m, and length, m, of a gas column that acts in parallel with the damper.
    pub gas: [f64; 2],
}

/// Dimensions of a physical damper.
#[derive(Debug, Clone)]
pub struct Built {
    /// Inner diameter of the tube in which the piston runs, m.
    pub bore_m: f64,
    /// Diameter of the rod, m.
    pub rod_m: f64,
    /// Length of the rebound chamber, and length of the oil column below the piston, at mid-stroke, m.
    pub lengths_m: [f64; 2],
    /// Absolute pressure of the gas at mid-stroke, bar.
    pub gas_bar: f64,
    /// Volume of the gas at mid-stroke, m³.
    pub gas_m3: f64,
    /// Bulk modulus of the oil without air, bar.
    pub oil_bar: f64,
    /// Ratio of the air's volume at 1 bar to the oil's volume.
    pub air: f64,
    /// Valves of rebound and compression.
    pub valves: [Valves; 2],
    /// Areas on which the pressure differences of rebound and compression valves act, m².
    pub areas_m2: [f64; 2],
}

impl Built {
    /// Computes the effective bulk modulus of the oil with its air at the gas pressure, bar.
    pub fn modulus_bar(&self) -> f64 {
        1.0 / Fluid { oil: 1.0 / self.oil_bar, air: self.air, air_is_felt: true, void_is_felt: true }
            .compliance(self.gas_bar)
    }
}

/// A damper: its mount, mass, friction and oil, with small deviations from an ideal damper.
pub struct Plant {
    /// Kind of damper.
    pub kind: Kind,
    /// Mount in series with the damper.
    pub mount: Mount,
    /// Mass between mount and oil, kg.
    pub mass: f64,
    /// Friction of rod seal and guides.
    pub seal: Seal,
    /// Whether friction and gas act in parallel with mount and oil together, as in the thesis (Jonnalagadda & Vyas
    /// 2020). Otherwise, they act in parallel with the oil alone, in series with the mount.
    pub seal_is_outside: bool,
    /// Hydraulic part of the damper: oil, valves and gas.
    pub oil: Box<dyn Oil>,
    /// Dimensions; `None` for a damper without chambers.
    pub built: Option<Built>,
    /// Small deviations from an ideal damper and rig.
    pub slight: Slight,
    /// Characteristic forces and stiffness, for scaling the effects.
    pub scale: Scale,
}

impl Plant {
    /// Draws the damper of a seed.
    pub fn new(kind: Kind, seed: u64) -> Plant {
        let mut d = Draw::new(seed, kind.name());
        match kind {
            Kind::ThesisLike => lumped::plant(&mut d),
            Kind::Monotube => monotube::plant(&mut d),
            Kind::TwinTube => twin_tube::plant(&mut d),
        }
    }
}

/// Draws the rebound and the compression force at 0.5 m/s, N. The rebound force is 1.3 to 3.5 times the compression
/// force.
fn forces(d: &mut Draw) -> (f64, f64) {
    let rebound = d.scale(450.0, 1900.0);
    (rebound, rebound / d.between(1.3, 3.5))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks that the removal of air does not change the compliance of the void. Also checks that the removal of the
    /// void does not change the compliance of the air. Air acts above 1 bar, and a void below.
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
        // The smoothing of the pressure at vapor pressure changes a pressure of 1 bar by half a percent, so the
        // compliances differ slightly.
        assert!((cavitation.compliance(0.2) / cavitation.compliance(1.0) - 1.0).abs() < 0.02);
        assert!(without(Part::OilCompressibility).compliance(5.0) < 0.05 * whole.compliance(5.0));
    }
}
