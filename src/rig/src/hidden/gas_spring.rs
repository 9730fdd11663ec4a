//! The gas chamber pushes harder the further the rod is in: its force depends on position, not only on preload.

use super::{Hidden, Recipe};
use crate::neutral::{Here, Rest};

const FORMS: &[&str] = &["van_der_waals", "heat_exchange"];
/// Ratio of the specific heats of nitrogen.
const ADIABATIC: f64 = 1.4;

struct GasSpring {
    form: usize,
    /// Force at mid-stroke, N; the neutral damper has it as preload already.
    force_n: f64,
    /// Length of the gas column at mid-stroke, m.
    column_m: f64,
    /// Volume of the molecules themselves, as a share of the column.
    covolume: f64,
    /// Attraction, as a share of the pressure at mid-stroke.
    attraction: f64,
    /// Time in which the gas takes on the temperature of the wall, s.
    settling_s: f64,
}

impl GasSpring {
    /// Volume relative to mid-stroke; extension makes room.
    fn volume(&self, displacement_m: f64) -> f64 {
        (1.0 + displacement_m / self.column_m).max(0.05)
    }
}

impl Hidden for GasSpring {
    fn tolerances(&self) -> &[f64] {
        // Absolute temperature of the gas, relative to the wall.
        if self.form == 1 { &[1e-6] } else { &[] }
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        if self.form == 1 {
            // First law for a perfect gas, with a conduction that knows one time constant.
            let rate = here.line.velocity_m_s / self.column_m / self.volume(here.line.displacement_m);
            rates[0] = -(ADIABATIC - 1.0) * (1.0 + states[0]) * rate - states[0] / self.settling_s;
        }
    }

    fn begin(&self, _rest: &Rest, states: &mut [f64]) {
        states.fill(0.0);
    }

    fn beside_n(&self, here: &Here, states: &[f64]) -> f64 {
        let volume = self.volume(here.line.displacement_m);
        let pressure = if self.form == 1 {
            (1.0 + states[0]) / volume
        } else {
            // (p + a/V²)(V - b) = (1 + a)(1 - b) at constant temperature.
            (1.0 + self.attraction) * (1.0 - self.covolume) / (volume - self.covolume)
                - self.attraction / volume.powi(2)
        };
        -self.force_n * (pressure - 1.0)
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn Hidden> {
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
