//! Injected unknown effect: a part of the oil flow goes through a hose to an accumulator. Oil mass and accumulator have
//! a resonance.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["helmholtz"];

struct Hose {
    /// Compliance of the accumulator, m/N: piston stroke per oil force.
    compliance_m_n: f64,
    omega: f64,
    damping: f64,
}

impl DamperEffect for Hose {
    fn tolerances(&self) -> &[f64] {
        // The states are the flow in the hose, as a piston velocity, m/s, and the accumulator's pressure, as a piston
        // force, N.
        &[1e-5, 1e-1]
    }

    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        // The effective mass m of the oil in the hose follows from the angular frequency omega and the compliance C: m
        // = 1 / (omega² C).
        let per_mass = self.omega * self.omega * self.compliance_m_n;
        rates[0] = per_mass * (here.oil_n - states[1]) - 2.0 * self.damping * self.omega * states[0];
        rates[1] = states[0] / self.compliance_m_n;
    }

    fn bypass_m_s(&self, _here: &Here, states: &[f64]) -> f64 {
        states[0]
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    recipe.form(FORMS);
    let strength = recipe.strength;
    let draw = &mut recipe.draw;
    Box::new(Hose {
        compliance_m_n: strength * draw.ratio("compliance_m_n", 0.3e-6, 1.0e-6),
        omega: std::f64::consts::TAU * draw.between("frequency_hz", 9.0, 22.0),
        damping: draw.between("damping", 0.1, 0.3),
    })
}
