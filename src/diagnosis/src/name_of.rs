//! Names of free parameters in reports.

use dashpot_core::number;
use dashpot_estimation::hypothesis::Free;
use dashpot_estimation::unknowns::Unknown;

/// Returns name and unit of a free parameter.
pub(super) fn name_of(free: &Free) -> (&'static str, &'static str) {
    match free {
        Free::Model(Unknown::Log(number) | Unknown::Linear(number) | Unknown::Above(number, _))
        | Free::Shift(Unknown::Log(number) | Unknown::Linear(number) | Unknown::Above(number, _)) => {
            (number.name(), number.parameter().unit)
        }
        Free::Model(Unknown::Entry(list, _)) | Free::Shift(Unknown::Entry(list, _)) => {
            (list.name(), list.parameter().unit)
        }
        Free::Model(Unknown::Rise { curve, .. }) | Free::Shift(Unknown::Rise { curve, .. }) => {
            (curve.forces().name(), "N")
        }
        Free::Curve(part) => (part.name(), "-"),
        Free::Rig(artefact) => (artefact.parameter(), artefact.unit()),
        Free::Cooling => ("cooling_rate", "1/s"),
        Free::HeatCapacity => {
            let number = number!("heat_capacity");
            (number.name(), number.parameter().unit)
        }
    }
}
