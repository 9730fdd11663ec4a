//! Equations of the neutral damper with its injected effects.
//!
//! The states are deflection of the series spring, velocity of the mass, and force of the oil on the mass. With the oil
//! force as a state, the valve flow is an explicit function of force. The oil column is 400 to 4000 times as stiff as
//! the series spring, so it reduces the series stiffness by 0.25 % at most.

use std::cell::RefCell;

use super::Neutral;
use super::hidden::DamperEffect;
use super::instant::{Here, Line, Rest};
use crate::solver::Tolerance;

/// Stiffness of the oil column of the neutral damper, N/m.
const COLUMN_N_M: f64 = 2e9;

const DEFLECTION: usize = 0;
const VELOCITY: usize = 1;
const OIL_FORCE: usize = 2;
/// Number of states of the neutral damper without effects.
pub(crate) const OWN: usize = 3;

/// The damper and its injected effects, as a system of `N` states.
pub(crate) struct System<'a, const N: usize> {
    pub neutral: &'a Neutral,
    pub effects: &'a [Box<dyn DamperEffect>],
    /// Index of the first state of each injected effect.
    pub first: Vec<usize>,
    /// Oil temperature, °C. The caller updates it after each sample; it is constant within a sample interval.
    pub oil_c: &'a RefCell<f64>,
}

impl<const N: usize> System<'_, N> {
    fn states<'s>(&self, index: usize, state: &'s [f64; N]) -> &'s [f64] {
        let first = self.first[index];
        &state[first..first + self.effects[index].tolerances().len()]
    }

    fn each<'s>(&'s self, state: &'s [f64; N]) -> impl Iterator<Item = (&'s dyn DamperEffect, &'s [f64])> {
        self.effects.iter().enumerate().map(|(index, hidden)| (hidden.as_ref(), self.states(index, state)))
    }

    /// Returns the error tolerance of each state per step.
    pub fn tolerance(&self) -> Tolerance<N> {
        let mut absolute = [1.0; N];
        absolute[DEFLECTION] = 1e-9;
        absolute[VELOCITY] = 1e-5;
        absolute[OIL_FORCE] = 1e-2;
        for (index, hidden) in self.effects.iter().enumerate() {
            let own = hidden.tolerances();
            absolute[self.first[index]..self.first[index] + own.len()].copy_from_slice(own);
        }
        Tolerance { absolute, relative: 3e-6 }
    }

    /// Returns the equilibrium state before a test; `carried` contains the states of the effects from the preceding
    /// test.
    pub fn at_rest(&self, rest: &Rest, carried: &[Vec<f64>]) -> [f64; N] {
        let mut state = [0.0; N];
        // The force of the series spring balances that of the weak spring in parallel with the valves.
        state[DEFLECTION] = self.neutral.spring_n_m * rest.displacement_m
            / (self.neutral.mount.stiffness_n_m + self.neutral.spring_n_m);
        for (index, hidden) in self.effects.iter().enumerate() {
            let first = self.first[index];
            let own = &mut state[first..first + hidden.tolerances().len()];
            own.copy_from_slice(&carried[index]);
            hidden.begin(rest, own);
        }
        state
    }

    /// Returns the quantities at one instant, and the force of the series spring and damper, N.
    fn here(&self, line: &Line, state: &[f64; N]) -> (Here, f64) {
        let mut here = Here {
            line: Line { oil_c: *self.oil_c.borrow(), ..*line },
            position_m: line.displacement_m - state[DEFLECTION],
            velocity_m_s: state[VELOCITY],
            deflection_m: state[DEFLECTION],
            deflection_m_s: line.velocity_m_s - state[VELOCITY],
            oil_n: state[OIL_FORCE],
            rod_n: 0.0,
        };
        let mount = self.mount_n(&here, state);
        let (friction, beside) = self.parallel_force_n(&here, state);
        here.rod_n = mount + friction + beside;
        (here, mount)
    }

    /// Computes the force of the series spring and damper, N.
    fn mount_n(&self, here: &Here, state: &[f64; N]) -> f64 {
        let mount = &self.neutral.mount;
        let (mut deflection, mut damped) = (here.deflection_m, 1.0);
        for (hidden, _) in self.each(state) {
            if let Some((past_gap, share)) = hidden.gap(deflection) {
                deflection = past_gap;
                damped *= share;
            }
        }
        let elastic = self
            .each(state)
            .find_map(|(hidden, own)| hidden.mount_n(mount, deflection, here, own))
            .unwrap_or(mount.stiffness_n_m * deflection);
        elastic + damped * mount.damping_n_s_m * here.deflection_m_s
    }

    /// Computes the friction, and the sum of the other forces in parallel with the damper, N.
    fn parallel_force_n(&self, here: &Here, state: &[f64; N]) -> (f64, f64) {
        let friction = &self.neutral.friction;
        let v = here.line.velocity_m_s;
        let mut level = friction.sliding_n + friction.side_force_ratio * here.line.side_force_n.abs();
        let mut direction = None;
        let mut beside = -self.neutral.gas_n;
        for (hidden, own) in self.each(state) {
            level += hidden.friction_n(here, own);
            direction = direction.or(hidden.friction_direction(here, own));
            beside += hidden.parallel_force_n(here, own);
        }
        let direction = direction.unwrap_or(v / libm::hypot(v, friction.smooth_m_s));
        (level * direction, beside)
    }

    /// Computes the flow past the piston, through valves and bypass, as a piston velocity, m/s.
    fn flow_m_s(&self, here: &Here, state: &[f64; N]) -> f64 {
        let (mut driving, mut bypass) = (here.oil_n, 0.0);
        for (hidden, own) in self.each(state) {
            driving /= hidden.resistance(here, own);
            bypass += hidden.bypass_m_s(here, own);
        }
        let valves = &self.neutral.valves;
        let through = self
            .each(state)
            .find_map(|(hidden, own)| hidden.valve_flow_m_s(valves, driving, own))
            .unwrap_or_else(|| valves.flow_m_s(driving));
        through + bypass
    }

    /// Computes the time derivatives of all states of damper and effects.
    pub fn rates(&self, line: &Line, state: &[f64; N]) -> [f64; N] {
        let (here, mount) = self.here(line, state);
        let (mut compliance, mut mass) = (1.0 / COLUMN_N_M, self.neutral.mass_kg);
        for (hidden, own) in self.each(state) {
            compliance += hidden.compliance_m_n(&here, own);
            mass += hidden.inertance_kg(&here);
        }
        let mut rates = [0.0; N];
        rates[DEFLECTION] = here.deflection_m_s;
        rates[VELOCITY] = (mount - here.oil_n - self.neutral.spring_n_m * here.position_m) / mass;
        rates[OIL_FORCE] = (here.velocity_m_s - self.flow_m_s(&here, state)) / compliance;
        for (index, hidden) in self.effects.iter().enumerate() {
            let first = self.first[index];
            let count = hidden.tolerances().len();
            if count > 0 {
                hidden.rates(&here, &state[first..first + count], &mut rates[first..first + count]);
            }
        }
        rates
    }

    /// Computes the force that the load cell shows, N.
    pub fn cell_n(&self, line: &Line, state: &[f64; N]) -> f64 {
        let (here, _) = self.here(line, state);
        self.each(state).fold(here.rod_n, |force, (hidden, own)| hidden.cell_n(force, &here, own))
    }

    /// Computes the power that valves and friction dissipate in the damper, W.
    pub fn heat_w(&self, line: &Line, state: &[f64; N]) -> f64 {
        let (here, _) = self.here(line, state);
        let (friction, _) = self.parallel_force_n(&here, state);
        (here.oil_n * self.flow_m_s(&here, state) + friction * line.velocity_m_s).max(0.0)
    }
}
