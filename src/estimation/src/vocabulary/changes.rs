//! Changes relative to a reference damper: each parameter of the reference's model, and each part of its FV curve, is a
//! separate candidate.

use super::{Candidate, Start, fresh, of_the_rig};
use crate::curve_part::CurvePart;
use crate::hypothesis::{Free, Hypothesis};
use crate::measurement::Artefact;
use crate::unknowns::Unknown;

/// Starts of a refit: relative changes of a part of the curve. [`STEPS`] contains changes of a parameter, in steps of
/// the parameter.
const RELATIVE: [f64; 2] = [0.15, -0.15];
const STEPS: [f64; 2] = [1.0, -1.0];

/// Returns all possible changes of a reference model that was fitted to its own records.
pub fn changes(reference: &Hypothesis) -> Vec<Candidate> {
    let plain = |effect: &'static str, free: Free, values: &[f64]| Candidate {
        effect,
        form: "changed",
        ..of_the_rig(
            Artefact::Offset,
            vec![fresh(free, (f64::NEG_INFINITY, f64::INFINITY))],
            values.iter().map(|v| Start::at(&[*v])).collect(),
        )
    };
    let mut all: Vec<Candidate> =
        CurvePart::ALL.iter().map(|part| plain(part.name(), Free::Curve(*part), &RELATIVE)).collect();
    for number in &reference.numbers {
        let Free::Model(unknown @ (Unknown::Log(own) | Unknown::Linear(own) | Unknown::Above(own, _))) = number.free
        else {
            continue;
        };
        all.push(plain(own.name(), Free::Shift(unknown), &STEPS.map(|step| step * number.step)));
    }
    all
}
