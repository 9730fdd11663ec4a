//! A monotube damper: a piston between two chambers of oil with air, and gas behind a floating piston.

use super::ablation::STIFFER;
use super::{Built, Kind, Mount, Oil, OilContext, Part, Plant, Scale, Seal, Slight, flow::Valves, forces};
use crate::draw::Draw;

/// Oil with some free and dissolved air: `1/β = 1/β_o + α p_0/(n p²)` (Merritt 1967) at the absolute pressure p, bar.
///
/// β is the bulk modulus, bar, β_o that of the oil alone, and α the ratio of air to oil volume at p_0 = 1 bar. The
/// polytropic exponent n of the air is 1.3.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fluid {
    /// Compressibility 1/β_o of the oil alone, 1/bar.
    pub oil: f64,
    /// Ratio of the air volume at 1 bar to the oil volume.
    pub air: f64,
    /// Whether air adds compliance above 1 bar.
    pub air_is_felt: bool,
    /// Whether air and vapor add more compliance below 1 bar.
    pub void_is_felt: bool,
}

/// Pressure, bar, below which vapor maintains the pressure, so that the compliance is that of a void.
const VAPOUR: f64 = 0.15;

impl Fluid {
    /// Computes the compressibility 1/β of oil and air, 1/bar, at the absolute pressure `p`, bar.
    pub fn compliance(&self, p: f64) -> f64 {
        let p = 0.5 * (p + (p * p + VAPOUR * VAPOUR).sqrt());
        let at = |p: f64| self.air / (1.3 * p * p);
        let air = at(p.max(1.0));
        self.oil + f64::from(self.air_is_felt) * air + f64::from(self.void_is_felt) * (at(p) - air)
    }

    /// Removes the compressibility of a part of the physics. The part is oil with its air, the air above 1 bar, or the
    /// voids below 1 bar.
    pub fn remove(&mut self, part: Part) {
        match part {
            Part::OilCompressibility => {
                self.oil /= STIFFER;
                self.air_is_felt = false;
            }
            Part::Aeration => self.air_is_felt = false,
            Part::Cavitation => self.void_is_felt = false,
            _ => {}
        }
    }

    pub fn new(d: &mut Draw) -> Fluid {
        Fluid {
            oil: 1.0 / d.between(9_000.0, 14_000.0),
            air: d.scale(2e-4, 1.5e-3),
            air_is_felt: true,
            void_is_felt: true,
        }
    }
}

/// Factor from bar to Pa.
pub(crate) const BAR: f64 = 1e5;
/// Polytropic exponent of the gas behind the floating piston in motion.
pub(crate) const GAS: f64 = 1.3;

struct Monotube {
    rebound: Valves,
    compression: Valves,
    fluid: Fluid,
    piston: f64,
    rod: f64,
    /// Lengths of the rebound chamber and of the oil column below the piston at mid-stroke, m.
    lengths: [f64; 2],
    /// Absolute pressure (bar) and volume (m³) of the gas at mid-stroke.
    gas: [f64; 2],
}

impl Monotube {
    fn annulus(&self) -> f64 {
        self.piston - self.rod
    }
}

impl Oil for Monotube {
    fn states(&self) -> usize {
        2
    }

    fn rest(&self, x: f64, states: &mut [f64]) {
        let p = self.gas[0] * libm::pow(self.gas[1] / (self.gas[1] + self.rod * x), GAS);
        states.fill(p);
    }

    fn tolerances(&self, tolerances: &mut [f64]) {
        tolerances.fill(5e-4);
    }

    fn hydraulic(&self, p: &[f64]) -> f64 {
        (p[0] - p[1]) * BAR * self.annulus()
    }

    fn force(&self, p: &[f64]) -> f64 {
        (p[0] * self.annulus() - p[1] * self.piston + self.rod) * BAR
    }

    fn rates(&self, x: f64, v: f64, beside: &OilContext, p: &[f64], rates: &mut [f64]) {
        let area = self.annulus();
        let h = self.hydraulic(p);
        let valves = if h >= 0.0 { &self.rebound } else { &self.compression };
        let q = area * (beside.gain * valves.velocity(h.abs(), beside.viscosity).copysign(h) + beside.taken);
        let above = area * (self.lengths[0] - x).max(0.01);
        let below = self.piston * (self.lengths[1] + x).max(0.01);
        let gas = self.gas[1] * libm::pow(self.gas[0] / p[1].max(0.2), 1.0 / GAS) / (GAS * p[1].max(0.2));
        let extra = beside.compliance * area * area * BAR;
        rates[0] = (area * v - q) / (above * self.fluid.compliance(p[0]) + extra);
        rates[1] = (q - self.piston * v) / (below * self.fluid.compliance(p[1]) + gas);
    }

    fn remove(&mut self, part: Part) {
        self.fluid.remove(part);
        if part == Part::GasSpring {
            // With 100 times the gas volume, the gas pressure is nearly constant.
            self.gas[1] *= STIFFER;
        }
    }
}

/// Draws a monotube damper: piston diameter 36 to 46 mm, rod diameter 11 to 14 mm, gas at 18 to 30 bar or more.
pub(super) fn plant(d: &mut Draw) -> Plant {
    let (rebound_n, compression_n) = forces(d);
    let area = |diameter: f64| std::f64::consts::FRAC_PI_4 * diameter * diameter;
    let (piston, rod) = (area(d.between(0.036, 0.046)), area(d.between(0.011, 0.014)));
    // The gas pressure must keep the rebound chamber pressurized at the compression force of this damper.
    let needed = 2.6 * compression_n / ((piston - rod) * BAR);
    let pressure = d.between(18.0, 30.0).max(needed);
    let oil = Monotube {
        rebound: Valves::orifice_and_shim(d, rebound_n),
        compression: Valves::orifice_and_shim(d, compression_n),
        fluid: Fluid::new(d),
        piston,
        rod,
        lengths: [d.between(0.11, 0.16), d.between(0.12, 0.18)],
        gas: [pressure, d.between(6e-5, 1.2e-4)],
    };
    let diameter = |area: f64| (area / std::f64::consts::FRAC_PI_4).sqrt();
    let built = Built {
        bore_m: diameter(piston),
        rod_m: diameter(rod),
        lengths_m: oil.lengths,
        gas_bar: oil.gas[0],
        gas_m3: oil.gas[1],
        oil_bar: 1.0 / oil.fluid.oil,
        air: oil.fluid.air,
        valves: [oil.rebound.clone(), oil.compression.clone()],
        areas_m2: [piston - rod; 2],
    };
    let mount = Mount::new(d, (8e5, 5e6), (500.0, 2500.0));
    let seal = Seal::new(d, (20.0, 60.0));
    let gas_n = pressure * BAR * rod;
    let scale = Scale { rebound_n, compression_n, series_n_m: mount.stiffness, friction_n: seal.sliding, gas_n };
    let slight = Slight {
        laden_kg: d.between(0.2, 1.2),
        position: d.sign() * d.between(0.2, 1.0),
        warmth: d.between(0.1, 0.4),
        gas: [0.0, 1.0],
    };
    Plant {
        kind: Kind::Monotube,
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
