//! Differential equations of a damper with its mount and injected effects.

use crate::effects::{EffectModel, Here};
use crate::integrator::Equations;
use crate::jet::Jet;
use crate::plant::{OilContext, Plant};
use crate::protocol::waveform::Ready;

const MOUNT: usize = 0;
const X: usize = 1;
const V: usize = 2;
const BRISTLE: usize = 3;
const OIL: usize = 4;
/// Oil temperature at which the valves have their nominal flow, °C.
const REFERENCE_C: f64 = 25.0;
/// Approximate relative decrease of the oil's viscosity per kelvin.
const THINS: f64 = 0.022;

/// Velocity range of a reversal of friction, m/s, which the steps of the simulation must resolve.
const TURNS: f64 = 1.5e-3;

/// Time, side force and oil temperature of a test.
#[derive(Debug, Clone, Copy)]
pub struct Around {
    /// Time from the start of the campaign to the start of the record, s.
    pub clock: f64,
    /// Duration of the campaign, s.
    pub campaign: f64,
    /// Side force on the rod, N.
    pub side: f64,
    /// Temperature of the oil, °C.
    pub oil_c: f64,
}

/// A damper with its injected effects in one test.
pub struct Machine<'a> {
    plant: &'a Plant,
    hidden: &'a [Box<dyn EffectModel>],
    motion: &'a Ready,
    around: Around,
    tolerances: Vec<f64>,
    /// Index of the first state of each effect.
    begins: Vec<usize>,
}

/// Time and motion at an instant.
#[derive(Debug, Clone, Copy)]
pub struct Instant {
    /// Time since the start of the record, s.
    pub t: f64,
    /// Motion of the moving end.
    pub input: Jet,
}

impl<'a> Machine<'a> {
    /// Makes the equations of a damper with the injected effects `hidden` in a test.
    pub fn new(plant: &'a Plant, hidden: &'a [Box<dyn EffectModel>], motion: &'a Ready, around: Around) -> Machine<'a> {
        let mut tolerances = vec![0.1, 5e-7, 2e-5, 2e-3 * plant.seal.length()];
        tolerances.resize(OIL + plant.oil.states(), 0.0);
        plant.oil.tolerances(&mut tolerances[OIL..]);
        let mut begins = Vec::new();
        for effect in hidden {
            begins.push(tolerances.len());
            tolerances.extend(effect.tolerances());
        }
        Machine { plant, hidden, motion, around, tolerances, begins }
    }

    /// Returns the states of the damper in equilibrium at the start of the test.
    pub fn rest(&self) -> Vec<f64> {
        let mut y = vec![0.0; self.tolerances.len()];
        let at = self.drive(0.0);
        y[X] = at.input.x;
        let oil = OIL..OIL + self.plant.oil.states();
        self.plant.oil.rest(at.input.x, &mut y[oil.clone()]);
        let held = self.plant.oil.force(&y[oil]);
        y[MOUNT] = held;
        if !self.plant.seal_is_outside {
            let here = self.here(&at, &y);
            y[MOUNT] += self.parallel(&here, &y);
        }
        y
    }

    fn states<'y>(&self, effect: usize, y: &'y [f64]) -> &'y [f64] {
        let begin = self.begins[effect];
        &y[begin..begin + self.hidden[effect].tolerances().len()]
    }

    fn here(&self, at: &Instant, y: &[f64]) -> Here {
        let outside = self.plant.seal_is_outside;
        let oil = &y[OIL..OIL + self.plant.oil.states()];
        let clock = self.around.clock + at.t;
        Here {
            t: at.t,
            clock,
            progress: clock / self.around.campaign,
            input: at.input,
            x: if outside { at.input.x } else { y[X] },
            v: if outside { at.input.v } else { y[V] },
            hydraulic: self.plant.oil.hydraulic(oil),
            mount: y[MOUNT],
            mount_rate: 0.0,
            side: self.around.side,
            oil_c: self.around.oil_c,
        }
    }

    /// Computes the sum of friction, gas and injected forces, N. It acts in parallel with the oil, or with the whole
    /// damper if `seal_is_outside` is set.
    fn parallel(&self, here: &Here, y: &[f64]) -> f64 {
        let plant = self.plant;
        let mut force = plant.seal.force(here.v, y[BRISTLE]) + plant.slight.gas[0] * gas(here.x, plant.slight.gas[1]);
        if plant.seal_is_outside {
            force -= plant.scale.gas_n;
        }
        for (i, effect) in self.hidden.iter().enumerate() {
            force += effect.parallel(here, self.states(i, y));
        }
        force
    }

    /// Computes the rate of the mount's force, N/s, and the forces in parallel with the mount, N. Stores the deflection
    /// rate of the mount in `here`.
    fn series(&self, here: &mut Here, at: &Instant, y: &[f64]) -> (f64, f64) {
        let mount = &self.plant.mount;
        let own = mount.compliance(y[MOUNT]);
        let mut all = own;
        for (i, effect) in self.hidden.iter().enumerate() {
            all += effect.series(here, self.states(i, y));
        }
        let rate = (at.input.v - y[V]) / all;
        here.mount_rate = rate * own;
        let mut beside = mount.damping * here.mount_rate;
        for (i, effect) in self.hidden.iter().enumerate() {
            beside += effect.parallel_to_mount(here, self.states(i, y));
        }
        (rate, beside)
    }

    /// Computes the force at the load cell, N.
    pub fn force(&self, at: &Instant, y: &[f64]) -> f64 {
        let mut here = self.here(at, y);
        let (_, beside) = self.series(&mut here, at, y);
        let mut force = y[MOUNT] + beside + self.plant.slight.laden_kg * at.input.a;
        if self.plant.seal_is_outside {
            force += self.parallel(&here, y);
        }
        force
    }
}

/// Computes the change of the force of a gas column with the displacement `x`, m, divided by the stiffness of the
/// column, m. `length` is the length of the gas column at mid-stroke, m. The column is softer in extension.
fn gas(x: f64, length: f64) -> f64 {
    x / (1.0 + x / length).max(0.2)
}

impl Equations for Machine<'_> {
    type Drive = Instant;

    fn drive(&self, t: f64) -> Instant {
        Instant { t, input: self.motion.evaluate(t) }
    }

    fn tolerances(&self) -> &[f64] {
        &self.tolerances
    }

    /// Returns the longest step, s, which is short near a reversal, because friction reverses within about 1 mm/s. If
    /// friction acts in parallel with the mount, the error control of the states does not resolve this reversal.
    fn longest(&self, at: &Instant) -> f64 {
        0.4 * (at.input.v.abs() + TURNS) / at.input.a.abs().max(1e-9)
    }

    fn rates(&self, at: &Instant, y: &[f64], r: &mut [f64]) {
        let plant = self.plant;
        let mut here = self.here(at, y);
        let (mount_rate, beside) = self.series(&mut here, at, y);
        r[MOUNT] = mount_rate;
        r[X] = y[V];
        r[BRISTLE] = plant.seal.rate(here.v, y[BRISTLE]);

        let warmth = libm::exp(-plant.slight.warmth * THINS * (self.around.oil_c - REFERENCE_C));
        let mut around =
            OilContext { taken: 0.0, compliance: 0.0, gain: 1.0 + plant.slight.position * y[X], viscosity: warmth };
        for (i, effect) in self.hidden.iter().enumerate() {
            let states = self.states(i, y);
            around.taken += effect.taken(&here, states);
            around.compliance += effect.column(&here, states);
            around.gain *= effect.gain(&here, states);
            around.viscosity *= effect.viscosity(&here, states);
            let begin = self.begins[i];
            effect.rates(&here, states, &mut r[begin..begin + states.len()]);
        }
        let oil = OIL..OIL + plant.oil.states();
        let mut held = plant.oil.force(&y[oil.clone()]);
        plant.oil.rates(y[X], y[V], &around, &y[oil.clone()], &mut r[oil]);
        if !plant.seal_is_outside {
            held += self.parallel(&here, y);
        }
        r[V] = (y[MOUNT] + beside - held) / plant.mass;
    }
}
