//! Unnamed measurement errors, for which the vocabulary contains no effect.

use super::{Candidate, Start, Unnamed, fresh, of_the_rig};
use crate::hypothesis::Free;
use crate::measurement::{Artefact, Load};

/// Possible resonance frequencies of the force path, Hz.
const RESONATES: [u32; 5] = [10, 15, 22, 33, 50];
/// Changes of force after a reversal over which the hysteresis of a load cell changes its sign, N.
const TURNS_OVER: [u32; 3] = [50, 150, 400];

/// Makes the candidate for an unnamed measurement error. `artefacts` are its parameters, and `start` contains their
/// start values.
fn looks_like(unnamed: Unnamed, artefacts: &[Artefact], start: &[f64]) -> Candidate {
    let numbers = artefacts.iter().map(|a| fresh(Free::Rig(*a), a.bounds())).collect();
    Candidate { unnamed: Some(unnamed), ..of_the_rig(artefacts[0], numbers, vec![Start::at(start)]) }
}

/// Adds the unnamed errors.
pub(super) fn unnamed(all: &mut Vec<Candidate>) {
    all.extend(
        [Load::Whole, Load::BeyondRest].map(|load| {
            looks_like(Unnamed::Guides, &[Artefact::Guide(load), Artefact::GuideAlong(load)], &[0.03, 0.1])
        }),
    );
    all.extend(TURNS_OVER.map(|width| looks_like(Unnamed::LoadCell, &[Artefact::Loop(width)], &[0.02])));
    all.extend(
        RESONATES
            .map(|hz| looks_like(Unnamed::Resonance, &[Artefact::Ring(hz), Artefact::RingAcross(hz)], &[0.01, 0.01])),
    );
}
