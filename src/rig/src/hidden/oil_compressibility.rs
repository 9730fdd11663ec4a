//! Injected effect of compressibility: oil and tube deform under pressure, so a part of the displaced oil does not flow
//! through the valves.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["rebound_chamber", "two_chambers"];

struct Compressibility {
    form: usize,
    /// Compliance of oil and tube at mid-stroke without pressure, m/N.
    compliance_m_n: f64,
    /// Length of the rebound chamber at mid-stroke, m. `compression_m` is that of the compression chamber.
    rebound_m: f64,
    compression_m: f64,
    /// Pressure force on the piston at which the bulk modulus has doubled, N.
    stiffening_n: f64,
    /// Fraction of the compliance that is due to the tube wall and does not depend on pressure.
    wall: f64,
}

impl DamperEffect for Compressibility {
    fn compliance_m_n(&self, here: &Here, _states: &[f64]) -> f64 {
        let rebound = (1.0 - here.position_m / self.rebound_m).max(0.1);
        let space = if self.form == 0 {
            rebound
        } else {
            let compression = (1.0 + here.position_m / self.compression_m).max(0.1);
            // The compliances of both chambers are combined, weighted toward the chamber under pressure.
            let working = 0.5 * (1.0 + here.oil_n / libm::hypot(here.oil_n, 50.0));
            working * rebound + (1.0 - working) * compression
        };
        let oil = (1.0 - self.wall) / (1.0 + here.oil_n.abs() / self.stiffening_n);
        self.compliance_m_n * space * (oil + self.wall)
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let draw = &mut recipe.draw;
    Box::new(Compressibility {
        form,
        compliance_m_n: recipe.strength / draw.ratio("stiffness_n_m", 0.6e6, 1.2e6),
        rebound_m: draw.between("rebound_m", 0.10, 0.14),
        compression_m: draw.between("compression_m", 0.10, 0.14),
        stiffening_n: draw.between("stiffening_n", 8e3, 20e3),
        wall: draw.between("wall_share", 0.05, 0.2),
    })
}
