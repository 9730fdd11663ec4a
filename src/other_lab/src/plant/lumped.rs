//! A damper with the topology of the thesis (Jonnalagadda & Vyas 2020) and smooth laws: one oil column, and one
//! force-velocity law per direction.

use super::ablation::STIFFER;
use super::{Kind, Mount, Oil, OilContext, Part, Plant, Scale, Seal, Slight, flow::Valves, forces};
use crate::draw::Draw;

struct Lumped {
    rebound: Valves,
    compression: Valves,
    /// Stiffness of the oil column, N/m, at least five times that of the mount.
    column: f64,
}

impl Oil for Lumped {
    fn states(&self) -> usize {
        1
    }

    fn rest(&self, _: f64, states: &mut [f64]) {
        states[0] = 0.0;
    }

    fn tolerances(&self, tolerances: &mut [f64]) {
        tolerances[0] = 0.05;
    }

    fn hydraulic(&self, states: &[f64]) -> f64 {
        states[0]
    }

    fn force(&self, states: &[f64]) -> f64 {
        states[0]
    }

    fn rates(&self, _: f64, v: f64, beside: &OilContext, states: &[f64], rates: &mut [f64]) {
        let h = states[0];
        let valves = if h >= 0.0 { &self.rebound } else { &self.compression };
        let w = beside.gain * valves.velocity(h.abs(), beside.viscosity).copysign(h);
        rates[0] = (v - beside.taken - w) / (1.0 / self.column + beside.compliance);
    }

    fn remove(&mut self, part: Part) {
        if part == Part::OilCompressibility {
            self.column *= STIFFER;
        }
    }
}

/// Draws a damper in the range of passenger cars, with one of two kinds of valve laws.
pub(super) fn plant(d: &mut Draw) -> Plant {
    let (rebound_n, compression_n) = forces(d);
    let make = if d.choice(2) == 0 { Valves::power_and_blow_off } else { Valves::sum };
    let (rebound, compression) = (make(d, rebound_n), make(d, compression_n));
    let mount = Mount::new(d, (6e5, 5e6), (800.0, 3000.0));
    let seal = Seal::new(d, (15.0, 55.0));
    let gas_n = d.scale(60.0, 350.0);
    let scale = Scale { rebound_n, compression_n, series_n_m: mount.stiffness, friction_n: seal.sliding, gas_n };
    let length = d.between(0.5, 1.2);
    let slight = Slight { laden_kg: 0.0, position: 0.0, warmth: 0.1 * d.fraction(), gas: [gas_n / length, length] };
    let column = 5.0 * mount.stiffness.max(4e6);
    Plant {
        kind: Kind::ThesisLike,
        mount,
        mass: d.between(0.3, 1.5),
        seal,
        seal_is_outside: true,
        oil: Box::new(Lumped { rebound, compression, column }),
        built: None,
        slight,
        scale,
    }
}
