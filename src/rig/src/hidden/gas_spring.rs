//! Injected effect of the gas spring: the gas force increases as the rod moves in. The neutral damper has only a
//! constant gas preload.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["van_der_waals", "heat_exchange"];
/// Ratio of the specific heats of nitrogen.
const ADIABATIC: f64 = 1.4;

struct GasSpring {
    form: usize,
    /// Gas force at mid-stroke, N. The constant preload of the neutral damper already contains it, so the effect adds
    /// only the change with position.
    force_n: f64,
    /// Length of the gas column at mid-stroke, m.
    column_m: f64,
    /// Volume of the molecules (van der Waals' b), as a fraction of the gas volume at mid-stroke.
    covolume: f64,
    /// Attraction of the molecules (van der Waals' a/V²) at mid-stroke, as a fraction of the pressure at mid-stroke.
    attraction: f64,
    /// Time constant of heat exchange between gas and wall, s.
    settling_s: f64,
}

impl GasSpring {
    /// Computes the volume of the gas relative to that at mid-stroke, at a displacement, m. Extension increases the
    /// volume.
    fn volume(&self, displacement_m: f64) -> f64 {
        (1.0 + displacement_m / self.column_m).max(0.05)
    }
}

impl DamperEffect for GasSpring {
    fn tolerances(&self) -> &[f64] {
        // The state is T / T_wall - 1, with the absolute temperatures T of the gas and T_wall of the wall.
        if self.form == 1 { &[1e-6] } else { &[] }
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        if self.form == 1 {
            // First law of thermodynamics for an ideal gas, with heat exchange at one time constant.
            let rate = here.line.velocity_m_s / self.column_m / self.volume(here.line.displacement_m);
            rates[0] = -(ADIABATIC - 1.0) * (1.0 + states[0]) * rate - states[0] / self.settling_s;
        }
    }

    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }

    fn parallel_force_n(&self, here: &Here, states: &[f64]) -> f64 {
        let volume = self.volume(here.line.displacement_m);
        let pressure = if self.form == 1 {
            (1.0 + states[0]) / volume
        } else {
            // At constant temperature, (p + a/V²)(V - b) = (1 + a)(1 - b). Pressure p and volume V are relative to
            // mid-stroke, a is the attraction and b the covolume.
            (1.0 + self.attraction) * (1.0 - self.covolume) / (volume - self.covolume)
                - self.attraction / volume.powi(2)
        };
        -self.force_n * (pressure - 1.0)
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let draw = &mut recipe.draw;
    Box::new(GasSpring {
        form,
        force_n: recipe.strength * draw.between("force_n", 180.0, 350.0),
        column_m: draw.between("column_m", 0.13, 0.30),
        covolume: draw.between("covolume", 0.01, 0.03),
        attraction: draw.between("attraction", 0.01, 0.05),
        settling_s: draw.ratio("settling_s", 0.5, 5.0),
    })
}
