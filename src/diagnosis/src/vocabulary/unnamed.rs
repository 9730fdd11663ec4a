//! What a rig may add that the vocabulary has no name for.

use super::{Candidate, Start, candidate, fresh};
use dashpot_estimation::hypothesis::Free;
use dashpot_estimation::measurement::{Artefact, Load};

/// Frequencies at which something in the path of the force may resonate, Hz.
const RESONATES: [u32; 5] = [10, 15, 22, 33, 50];
/// Forces within which a load cell may turn over, N.
const TURNS_OVER: [u32; 3] = [50, 150, 400];

/// Something that looks like `words`, made of these artefacts.
fn looks_like(words: &'static str, artefacts: &[Artefact], start: &[f64]) -> Candidate {
    let numbers = artefacts.iter().map(|a| fresh(Free::Rig(*a), a.bounds())).collect();
    Candidate { unnamed: Some(words), ..candidate(artefacts[0].name(), &[], numbers, vec![Start::at(start)]) }
}

/// What a rig may add that the vocabulary has no name for.
pub(super) fn unnamed(all: &mut Vec<Candidate>) {
    let guides = "friction that grows with the force, as a tilted cross-head or eye makes in the guides";
    all.extend(
        [Load::Whole, Load::BeyondRest]
            .map(|load| looks_like(guides, &[Artefact::Guide(load), Artefact::GuideAlong(load)], &[0.03, 0.1])),
    );
    let cell = "a loop over force whatever the speed, as a load cell with hysteresis draws";
    all.extend(TURNS_OVER.map(|width| looks_like(cell, &[Artefact::Loop(width)], &[0.02])));
    let resonance = "a resonance in the path of the force, as of a frame or of oil in a hose";
    all.extend(
        RESONATES.map(|hz| looks_like(resonance, &[Artefact::Ring(hz), Artefact::RingAcross(hz)], &[0.01, 0.01])),
    );
}
