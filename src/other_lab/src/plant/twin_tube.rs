//! A twin-tube damper: rebound and compression chamber, a base valve with check valve, and a reserve with gas at low
//! pressure (Segel & Lang, Veh. Syst. Dyn. 10, 1981; Duym & Reybrouck, Eur. J. Mech. Eng. 43, 1998).

use super::ablation::STIFFER;
use super::monotube::{BAR, Fluid, GAS};
use super::{Built, Kind, Mount, Oil, OilContext, Part, Plant, Scale, Seal, Slight, forces};
use crate::draw::Draw;
use crate::plant::flow::{Valves, check_valve};

struct TwinTube {
    /// Piston valve in rebound: flow as a piston velocity over the force of its pressure drop on the annulus.
    rebound: Valves,
    /// Base valve in compression: flow as a rod velocity over the force of its pressure drop on the rod's area.
    base: Valves,
    /// Opening force and resistances a and b (N, N s/m, N s²/m²; see [`check_valve`]) of the piston's check valve,
    /// which acts on the annulus. `intake` contains these values for the intake valve in the base, which acts on the
    /// area of the rod.
    check: [f64; 3],
    intake: [f64; 3],
    fluid: Fluid,
    annulus: f64,
    rod: f64,
    lengths: [f64; 2],
    /// Absolute pressure (bar) and volume (m³) of the gas at mid-stroke.
    gas: [f64; 2],
}

impl TwinTube {
    /// Computes the forces across piston valve and base valve, N, positive in rebound.
    fn across(&self, p: &[f64]) -> [f64; 2] {
        [(p[0] - p[1]) * BAR * self.annulus, (p[2] - p[1]) * BAR * self.rod]
    }
}

impl Oil for TwinTube {
    fn states(&self) -> usize {
        3
    }

    fn rest(&self, x: f64, states: &mut [f64]) {
        let p = self.gas[0] * libm::pow(self.gas[1] / (self.gas[1] + self.rod * x), GAS);
        states.fill(p);
    }

    fn tolerances(&self, tolerances: &mut [f64]) {
        tolerances.fill(5e-4);
    }

    fn hydraulic(&self, p: &[f64]) -> f64 {
        let [piston, base] = self.across(p);
        piston + base
    }

    fn force(&self, p: &[f64]) -> f64 {
        (p[0] * self.annulus - p[1] * (self.annulus + self.rod) + self.rod) * BAR
    }

    fn rates(&self, x: f64, v: f64, beside: &OilContext, p: &[f64], rates: &mut [f64]) {
        let [piston, base] = self.across(p);
        let taken = beside.taken;
        let through_piston = if piston >= 0.0 {
            beside.gain * self.rebound.velocity(piston, beside.viscosity)
        } else {
            let [lifts, a, b] = self.check;
            -self.rebound.bleed(-piston, beside.viscosity) - check_valve(-piston, lifts, a, b)
        };
        // The flow is positive from the compression chamber into the reserve.
        let through_base = if base <= 0.0 {
            beside.gain * self.base.velocity(-base, beside.viscosity)
        } else {
            let [lifts, a, b] = self.intake;
            -self.base.bleed(base, beside.viscosity) - check_valve(base, lifts, a, b)
        };
        let q = self.annulus * (through_piston + taken);
        let out = self.rod * (through_base - taken.min(0.0));
        let above = self.annulus * (self.lengths[0] - x).max(0.01);
        let area = self.annulus + self.rod;
        let below = area * (self.lengths[1] + x).max(0.01);
        let extra = beside.compliance * BAR;
        let reserve = p[2].max(0.2);
        let gas = self.gas[1] * libm::pow(self.gas[0] / reserve, 1.0 / GAS) / (GAS * reserve);
        rates[0] = (self.annulus * v - q) / (above * self.fluid.compliance(p[0]) + extra * self.annulus * self.annulus);
        rates[1] = (q - out - area * v) / (below * self.fluid.compliance(p[1]) + extra * self.rod * self.rod);
        rates[2] = out / gas;
    }

    fn remove(&mut self, part: Part) {
        self.fluid.remove(part);
        if part == Part::GasSpring {
            self.gas[1] *= STIFFER;
        }
    }
}

/// Draws a twin-tube damper: piston diameter 27 to 32 mm, rod diameter 12.4 to 20 mm, gas at 3 to 8 bar.
pub(super) fn plant(d: &mut Draw) -> Plant {
    let (rebound_n, compression_n) = forces(d);
    let area = |diameter: f64| std::f64::consts::FRAC_PI_4 * diameter * diameter;
    let (piston, rod) = (area(d.between(0.027, 0.032)), area(d.between(0.0124, 0.020)));
    let annulus = piston - rod;
    let gas = [d.between(3.0, 8.0), d.between(8e-5, 1.6e-4)];
    // At 1 m/s, the pressure drop of the check valve causes 5 to 12 % of the compression force at 0.5 m/s. The drop of
    // the intake valve is below the gas pressure.
    let check = d.between(0.05, 0.12) * compression_n;
    let intake = d.between(0.1, 0.3) * gas[0] * BAR * rod;
    let oil = TwinTube {
        rebound: Valves::orifice_and_shim(d, rebound_n),
        base: Valves::orifice_and_shim(d, compression_n),
        check: [d.between(0.05, 0.15) * BAR * annulus, 0.4 * check, 0.6 * check],
        intake: [d.between(0.03, 0.08) * BAR * rod, 0.3 * intake, 0.3 * intake],
        fluid: Fluid::new(d),
        annulus,
        rod,
        lengths: [d.between(0.11, 0.16), d.between(0.13, 0.2)],
        gas,
    };
    let diameter = |area: f64| (area / std::f64::consts::FRAC_PI_4).sqrt();
    let built = Built {
        bore_m: diameter(piston),
        rod_m: diameter(rod),
        lengths_m: oil.lengths,
        gas_bar: gas[0],
        gas_m3: gas[1],
        oil_bar: 1.0 / oil.fluid.oil,
        air: oil.fluid.air,
        valves: [oil.rebound.clone(), oil.base.clone()],
        areas_m2: [annulus, rod],
    };
    let mount = Mount::new(d, (5e5, 2.5e6), (400.0, 2000.0));
    let seal = Seal::new(d, (20.0, 70.0));
    let gas_n = gas[0] * BAR * rod;
    let scale = Scale { rebound_n, compression_n, series_n_m: mount.stiffness, friction_n: seal.sliding, gas_n };
    let slight = Slight {
        laden_kg: d.between(0.3, 1.5),
        position: d.sign() * d.between(0.2, 1.0),
        warmth: d.between(0.1, 0.4),
        gas: [0.0, 1.0],
    };
    Plant {
        kind: Kind::TwinTube,
        mount,
        mass: d.between(0.3, 0.9),
        seal,
        seal_is_outside: false,
        oil: Box::new(oil),
        built: Some(built),
        slight,
        scale,
    }
}
