//! Injected effect of a rubber mount instead of the linear series spring: the mount is soft, stiffens with deflection,
//! and has losses.

use super::{DamperEffect, Recipe};
use crate::neutral::{Here, Mount};

const FORMS: &[&str] = &["friction_and_quintic", "two_relaxations_and_stop"];
/// Velocity, m/s, at which the rebound force of the valves defines the working deflection of the mount.
const WORKING_M_S: f64 = 0.5;

struct Bushing {
    form: usize,
    strength: f64,
    /// Deflection of the linear series spring under the rebound force at [`WORKING_M_S`], m.
    working_m: f64,
    /// Relative additional compliance at strength 1: the spring's stiffness is divided by `1 + strength * softer`.
    softer: f64,
    /// Deflection, relative to the working deflection, at which the quintic term doubles the force at strength 1, or
    /// the stop makes contact.
    hardens: f64,
    /// Friction in the rubber's filler (carbon black), N. `friction_m` is the deflection over which the friction builds
    /// up, m.
    friction_n: f64,
    friction_m: f64,
    /// Relaxing stiffnesses relative to the static stiffness, and their time constants, s.
    relaxing: [(f64, f64); 2],
    tolerances: Vec<f64>,
}

impl Bushing {
    fn static_n_m(&self, mount_n_m: f64) -> f64 {
        mount_n_m / (1.0 + self.strength * self.softer)
    }
}

impl DamperEffect for Bushing {
    fn tolerances(&self) -> &[f64] {
        &self.tolerances
    }

    fn rates(&self, here: &Here, states: &[f64], rates: &mut [f64]) {
        let rate = here.deflection_m_s;
        if self.form == 0 {
            // The friction of the rubber's filler is a Bouc-Wen model. Its state is the friction force relative to
            // `friction_n`, from -1 to 1.
            rates[0] = (rate - rate.abs() * states[0] * states[0].abs().sqrt()) / self.friction_m;
        } else {
            for (index, (_, time)) in self.relaxing.iter().enumerate() {
                rates[index] = rate - states[index] / time;
            }
        }
    }

    fn mount_n(&self, mount: &Mount, deflection_m: f64, _here: &Here, states: &[f64]) -> Option<f64> {
        let stiffness = self.static_n_m(mount.stiffness_n_m);
        let limit = self.hardens * self.working_m;
        Some(if self.form == 0 {
            // The quintic term saturates at large deflections, where the rubber would bulge out of the mount.
            let quartic = (deflection_m / limit).powi(4);
            let hardening = 1.0 + 2.0 * self.strength * quartic / (1.0 + quartic);
            stiffness * deflection_m * hardening + self.strength * self.friction_n * states[0]
        } else {
            let past = (deflection_m.abs() - limit).max(0.0).copysign(deflection_m);
            let relaxing: f64 = self.relaxing.iter().zip(states).map(|((share, _), d)| share * d).sum();
            // Beyond the contact, the stop restores the stiffness of the series spring.
            let stop = (mount.stiffness_n_m - stiffness) * past;
            stiffness * (deflection_m + self.strength * relaxing) + stop
        })
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let working_m = recipe.neutral.valves.force_n(WORKING_M_S) / recipe.neutral.mount.stiffness_n_m;
    // A proportional change of a stiff series spring would be invisible. Therefore, the relative compliance grows with
    // the stiffness. Every damper with a mount above 0.4e6 N/m thus has about equal mount stiffness.
    let softness = (recipe.neutral.mount.stiffness_n_m / 0.8e6).max(0.5);
    let draw = &mut recipe.draw;
    Box::new(Bushing {
        form,
        strength: recipe.strength,
        working_m,
        softer: softness * draw.between("softer", 0.5, 1.0),
        hardens: draw.between("hardens_at_working_deflections", 0.8, 1.6),
        friction_n: draw.between("friction_n", 40.0, 120.0),
        friction_m: draw.ratio("friction_m", 0.03e-3, 0.12e-3),
        relaxing: [
            (draw.between("relaxing_share_1", 0.15, 0.35), draw.ratio("relaxation_1_s", 3e-3, 10e-3)),
            (draw.between("relaxing_share_2", 0.15, 0.35), draw.ratio("relaxation_2_s", 30e-3, 150e-3)),
        ],
        tolerances: if form == 0 { vec![1e-4] } else { vec![1e-8; 2] },
    })
}
