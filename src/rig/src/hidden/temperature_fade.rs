//! Injected effect of temperature fade: oil becomes thinner with temperature. The laminar part of the force is proportional to the
//! viscosity, the other part to the density.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["vogel", "walther"];
/// Temperature at which the force equals that of the neutral damper, °C.
const REFERENCE_C: f64 = 25.0;
const KELVIN: f64 = 273.15;
/// Thermal expansion of oil, 1/K.
const EXPANSION: f64 = 7e-4;
/// Smallest ratio of the viscosity to that at [`REFERENCE_C`]. [`MOST_VISCOSITY`] is the largest ratio.
const LEAST_VISCOSITY: f64 = 0.02;
const MOST_VISCOSITY: f64 = 50.0;

struct Fade {
    form: usize,
    strength: f64,
    /// B (in K) and C (in °C) of Vogel's law `ln mu = B / (T + C)`. The relative viscosity mu is that at the temperature T, °C.
    vogel: (f64, f64),
    /// A and M of Walther's law for the viscosity (ASTM D341).
    ///
    /// The law is `lg lg (nu + 0.7) = A - M lg T`, with the viscosity nu in mm²/s and the temperature T in K. A and M
    /// follow from the viscosities at 40 and 100 °C.
    walther: (f64, f64),
    /// Oil force at which half of the pressure drop is laminar, N.
    half_n: f64,
}

impl Fade {
    fn viscosity(&self, celsius: f64) -> f64 {
        if self.form == 0 {
            libm::exp(self.vogel.0 / (celsius + self.vogel.1))
        } else {
            let (a, m) = self.walther;
            libm::pow(10f64, libm::pow(10f64, a - m * libm::log10(celsius + KELVIN))) - 0.7
        }
    }
}

impl DamperEffect for Fade {
    fn resistance(&self, here: &Here, _states: &[f64]) -> f64 {
        // The strength is an exponent: twice the strength doubles the effect of temperature on the logarithm of the
        // viscosity.
        let viscosity = libm::pow(self.viscosity(here.line.oil_c) / self.viscosity(REFERENCE_C), self.strength);
        // The lower bound is a fiftieth of the viscosity at [`REFERENCE_C`]. At a smaller viscosity, the laminar flow would become
        // turbulent.
        let viscosity = LEAST_VISCOSITY + (1.0 - LEAST_VISCOSITY) * viscosity.min(MOST_VISCOSITY);
        let density = libm::exp(-self.strength * EXPANSION * (here.line.oil_c - REFERENCE_C));
        let laminar = 1.0 / (1.0 + here.oil_n.abs() / self.half_n);
        laminar * viscosity + (1.0 - laminar) * density
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let at_1_m_s = recipe.neutral.valves.force_n(1.0);
    let draw = &mut recipe.draw;
    let (at_40, at_100) =
        (draw.between("viscosity_40c_mm2_s", 10.0, 16.0), draw.between("viscosity_100c_mm2_s", 2.8, 4.0));
    let lglg = |nu: f64| libm::log10(libm::log10(nu + 0.7));
    let m = (lglg(at_40) - lglg(at_100)) / libm::log10((100.0 + KELVIN) / (40.0 + KELVIN));
    Box::new(Fade {
        form,
        strength: recipe.strength,
        vogel: (draw.between("vogel_k", 600.0, 900.0), draw.between("vogel_c", 90.0, 110.0)),
        walther: (lglg(at_40) + m * libm::log10(40.0 + KELVIN), m),
        half_n: at_1_m_s * draw.between("laminar_half_share", 0.4, 1.0),
    })
}
