//! The FV curve of the damper and the FV curve of the reference in one figure.

use crate::blocks::Figure;
use crate::plot::axes::{Axis, Marks, Plane, Series};
use crate::plot::palette::Role;
use crate::words::Words;
use dashpot_core::{Model, Params};
use dashpot_diagnosis::Diagnosis;
use dashpot_simulation::prediction::between_velocities;

/// Width and height of the figure, px. The width fills a printed page.
const SIZE: [f64; 2] = [880.0, 340.0];

/// Draws the FV curves of the reference and of the improved model, including friction and gas force, over the velocity
/// range of the tests.
///
/// Returns `None` without a reference, or if the parameters of one of the two models are invalid.
pub fn figure(found: &Diagnosis, words: &Words) -> Option<Figure> {
    let reference = found.reference.as_ref()?;
    let velocities = || found.tests.iter().flat_map(|test| test.curves.velocity.iter().copied());
    let (low, high) = velocities().fold((0.0f64, 0.0f64), |(low, high), v| (low.min(v), high.max(v)));
    let of = |params: &Params| {
        let model = Model::new(params).ok()?;
        Some(between_velocities(&model, low, high).into_iter().map(|[v, f]| [1e3 * v, f]).collect::<Vec<_>>())
    };
    let (there, here) = (of(reference)?, of(&found.improved)?);
    let all = || there.iter().chain(&here);
    let line =
        |role, label, points: &Vec<[f64; 2]>| Series { role, label, lines: vec![points.clone()], marks: Marks::Line };
    let plane = Plane {
        title: words.plot_both_curves.into(),
        x: Axis::around(words.axis_velocity, all().map(|p| p[0])),
        y: Axis::around(words.axis_force, all().map(|p| p[1])),
        series: vec![line(Role::FvOnly, words.col_reference, &there), line(Role::Model, words.col_this_damper, &here)],
    };
    Some(Figure::new("both-curves", plane.draw_sized(SIZE, words)))
}
