//! Injected effect of side force on guide friction, in addition to the proportional term of the neutral damper.

use super::{DamperEffect, Recipe};
use crate::neutral::Here;

const FORMS: &[&str] = &["saturating", "two_bushes"];

enum SideFriction {
    /// Friction `mu (sqrt(Fs² + F0²) - F0) / (1 + Fs / Fl)`, N, at the side force Fs, N. The coefficient mu is `share`.
    /// F0 is the onset force `onset_n`, N, and Fl the force `level_n` of saturation, N.
    Saturating { share: f64, onset_n: f64, level_n: f64 },
    /// Friction of the reaction forces in rod guide and piston band. Their distance, at mid-stroke `overlap_m`,
    /// decreases with extension.
    TwoBushes { share: f64, overhang_m: f64, overlap_m: f64 },
}

impl DamperEffect for SideFriction {
    fn friction_n(&self, here: &Here, _states: &[f64]) -> f64 {
        let side = here.line.side_force_n.abs();
        match self {
            Self::Saturating { share, onset_n, level_n } => {
                let pressed = share * (libm::hypot(side, *onset_n) - onset_n);
                // The saturation force `level_n` does not depend on the strength, so that the friction over side force
                // has one shape at any strength.
                pressed / (1.0 + side / level_n)
            }
            Self::TwoBushes { share, overhang_m, overlap_m } => {
                let x = here.line.displacement_m;
                let overlap = (overlap_m - x).max(0.02);
                let overhang = (overhang_m + x).max(0.0);
                share * side * (1.0 + 2.0 * overhang / overlap)
            }
        }
    }
}

pub(super) fn draw(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    let form = recipe.form(FORMS);
    let strength = recipe.strength;
    let draw = &mut recipe.draw;
    Box::new(if form == 0 {
        SideFriction::Saturating {
            share: strength * draw.between("share", 0.10, 0.18),
            onset_n: draw.between("onset_n", 100.0, 300.0),
            level_n: draw.between("level_n", 800.0, 2000.0),
        }
    } else {
        SideFriction::TwoBushes {
            share: strength * draw.between("share", 0.02, 0.04),
            overhang_m: draw.between("overhang_m", 0.06, 0.10),
            overlap_m: draw.between("overlap_m", 0.12, 0.18),
        }
    })
}
