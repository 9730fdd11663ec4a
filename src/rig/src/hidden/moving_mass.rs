//! Injected effect of a force proportional to acceleration: mass between load cell and damper, or oil in a long
//! passage.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["rig_mass", "fluid_inertance"];

enum MovingMass {
    /// Mass `kg` between load cell and damper, which moves with the actuator.
    Rig { kg: f64 },
    /// Oil in a passage, as an additional mass `kg` behind the mount. The mass changes linearly with position, by 100 %
    /// over `length_m`.
    Fluid { kg: f64, length_m: f64 },
}

impl DamperEffect for MovingMass {
    fn parallel_force_n(&self, here: &Here, _states: &[f64]) -> f64 {
        match self {
            Self::Rig { kg } => kg * here.line.acceleration_m_s2,
            Self::Fluid { .. } => 0.0,
        }
    }

    fn inertance_kg(&self, here: &Here) -> f64 {
        match self {
            Self::Rig { .. } => 0.0,
            Self::Fluid { kg, length_m } => kg * (1.0 + here.position_m / length_m).max(0.2),
        }
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let kg = recipe.strength * recipe.draw.between("mass_kg", 2.0, 5.0);
    Box::new(if form == 0 {
        MovingMass::Rig { kg }
    } else {
        MovingMass::Fluid { kg, length_m: recipe.draw.between("length_m", 0.2, 0.5) }
    })
}
