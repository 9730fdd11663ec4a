//! What a rig may add that the vocabulary has no name for.

use super::{Candidate, Start, candidate, fresh};
use crate::diagnosis::hypothesis::Free;
use crate::diagnosis::measurement::{Artefact, Load};

/// What a rig may add that the vocabulary has no name for.
pub(super) fn unnamed(all: &mut Vec<Candidate>) {
    let fresh = |artefact: Artefact| fresh(Free::Rig(artefact), artefact.bounds());
    for load in [Load::Whole, Load::BeyondRest] {
        all.push(Candidate {
            unnamed: Some("friction that grows with the force, as a tilted cross-head or eye makes in the guides"),
            ..candidate(
                Artefact::Guide(load).name(),
                &[],
                vec![fresh(Artefact::Guide(load)), fresh(Artefact::GuideAlong(load))],
                vec![Start::at(&[0.03, 0.1])],
            )
        });
    }
    for width in [50, 150, 400] {
        all.push(Candidate {
            unnamed: Some("a loop over force whatever the speed, as a load cell with hysteresis draws"),
            ..candidate(Artefact::Loop(width).name(), &[], vec![fresh(Artefact::Loop(width))], vec![Start::at(&[0.02])])
        });
    }
    for hz in [10, 15, 22, 33, 50] {
        all.push(Candidate {
            unnamed: Some("a resonance in the path of the force, as of a frame or of oil in a hose"),
            ..candidate(
                Artefact::Ring(hz).name(),
                &[],
                vec![fresh(Artefact::Ring(hz)), fresh(Artefact::RingAcross(hz))],
                vec![Start::at(&[0.01, 0.01])],
            )
        });
    }
}
