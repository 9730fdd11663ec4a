//! Operating conditions for the check of a damper: position in the stroke, side force and temperature.

use dashpot_core::element;
use dashpot_core::{Input, Model, Params};

/// Side force, N, for the check of a damper with side-force friction.
///
/// Such a side force occurs in a strut of a car during cornering or braking.
pub(super) const SIDE_FORCE: f64 = 2000.0;
/// Force of a stop, N, at which the damper is checked. It occurs at a front corner in a pothole.
pub(super) const STOP_FORCE: f64 = 1e4;
/// Temperature, °C, at which a damper with temperature-dependent oil is checked: a winter morning.
pub(super) const COLD: f64 = -20.0;
/// Positions in the stroke, m, at which a damper with position-dependent damping or compressible oil is checked.
pub(super) const PLACES: [f64; 8] = [-0.08, -0.06, -0.04, -0.02, 0.02, 0.04, 0.06, 0.08];
/// Largest displacement, m, at which a stop is searched.
const FURTHEST: f64 = 0.3;

/// Operating conditions of a damper: position in the stroke, side force and temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Situation {
    /// Displacement in the middle of the motion, m.
    pub place: f64,
    /// Side force, N.
    pub side_force: f64,
    /// Temperature, °C.
    pub temperature: f64,
}

impl Situation {
    /// Middle of the stroke, without side force, at the typical temperature of a rig.
    pub const REFERENCE: Situation = Situation { place: 0.0, side_force: 0.0, temperature: 20.0 };

    /// Returns the reference situation, and all other situations that change the derivatives of this damper.
    pub(super) fn all(params: &Params, model: &Model) -> Vec<Situation> {
        let mut all = vec![Situation::REFERENCE];
        if params.is_on(element!("side_force_friction")) {
            all.push(Situation { side_force: SIDE_FORCE, ..Situation::REFERENCE });
        }
        if params.is_on(element!("temperature_fade")) {
            all.push(Situation { temperature: COLD, ..Situation::REFERENCE });
        }
        let at = |place| Situation { place, ..Situation::REFERENCE };
        if [element!("position_dependent_damping"), element!("oil_compressibility")].iter().any(|e| params.is_on(*e)) {
            all.extend(PLACES.map(at));
        }
        let stops = [(element!("bump_stop"), -1.0), (element!("rebound_stop"), 1.0)];
        all.extend(stops.iter().filter(|(stop, _)| params.is_on(*stop)).map(|(_, side)| at(in_the_stop(model, *side))));
        all
    }

    pub(super) fn input(&self) -> Input {
        Input { side_force: self.side_force, temperature: self.temperature, ..Input::motion(self.place, 0.0) }
    }

    /// Describes how the situation differs from [`Situation::REFERENCE`].
    pub(super) fn describe(&self) -> String {
        let mut told = String::new();
        if self.place != 0.0 {
            told += &format!(
                ", {:.0} mm from the middle in {}",
                1e3 * self.place.abs(),
                if self.place > 0.0 { "rebound" } else { "compression" }
            );
        }
        if self.side_force != 0.0 {
            told += &format!(", under {:.0} N of side force", self.side_force);
        }
        if self.temperature != Situation::REFERENCE.temperature {
            told += &format!(", at {:.0} °C", self.temperature);
        }
        told
    }
}

/// Returns the displacement, m, at which the stop of one side reaches [`STOP_FORCE`], at most [`FURTHEST`] from the middle of the stroke.
/// `side` is 1 for rebound and −1 for compression.
fn in_the_stop(model: &Model, side: f64) -> f64 {
    let force = |depth: f64| model.static_output(&Input::motion(side * depth, 0.0)).stop_force.abs();
    let (mut low, mut high) = (0.0, FURTHEST);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if force(middle) < STOP_FORCE { low = middle } else { high = middle }
    }
    side * low
}
