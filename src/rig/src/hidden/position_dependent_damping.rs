//! Injected effect of position-dependent damping: over a part of the stroke, oil flows past the piston through grooves
//! in the tube.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["groove", "one_sided_groove", "bell"];

struct Groove {
    form: usize,
    /// Flow past the piston, as a piston velocity, m/s, at the oil force `scale_n`, N, and the largest groove area.
    flow_m_s: f64,
    scale_n: f64,
    centre_m: f64,
    half_m: f64,
    taper_m: f64,
}

impl Groove {
    /// Computes the area of the groove at a piston position, m, relative to its largest value.
    fn area(&self, position_m: f64) -> f64 {
        let from_centre = position_m - self.centre_m;
        match self.form {
            0 => {
                let share = ((self.half_m + self.taper_m - from_centre.abs()) / self.taper_m).clamp(0.0, 1.0);
                share * share * (3.0 - 2.0 * share)
            }
            // The one-sided groove opens gradually from the center into the compressed side of the stroke.
            1 => {
                let share = (-from_centre / (self.half_m + self.taper_m)).clamp(0.0, 1.0);
                share * share * (3.0 - 2.0 * share)
            }
            _ => libm::exp(-0.5 * (from_centre / self.half_m).powi(2)),
        }
    }
}

impl DamperEffect for Groove {
    fn bypass_m_s(&self, here: &Here, _states: &[f64]) -> f64 {
        let force = here.oil_n / self.scale_n;
        // The flow follows the square-root law of an orifice, linearized below a fiftieth of the reference force
        // `scale_n`.
        self.flow_m_s * self.area(here.position_m) * force / libm::pow(force * force + 4e-4, 0.25)
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let scale_n = recipe.neutral.valves.force_n(0.5);
    let draw = &mut recipe.draw;
    Box::new(Groove {
        form,
        flow_m_s: recipe.strength * draw.between("flow_m_s", 0.12, 0.25),
        scale_n,
        centre_m: draw.between("centre_m", -8e-3, 8e-3),
        half_m: draw.between("half_m", 8e-3, 18e-3),
        taper_m: draw.between("taper_m", 3e-3, 10e-3),
    })
}
