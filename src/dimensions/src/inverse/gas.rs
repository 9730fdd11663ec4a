//! Pressure and volume of the gas, from its force and stiffness.

use super::errors;
use super::model::{Identified, Standing};
use super::report::{Explanation, Gap, Quantity};
use crate::dimensions::Dimensions;
use crate::entry::Entry;
use crate::gas;
use crate::phrases;
use crate::uncertain::{Interval, Uncertain, through};
use dashpot_core::number;
use dashpot_messages::{Sentence, Template};

/// Pascals per bar. [`CM3`] is cubic meters per cm³.
const BAR: f64 = 1e5;
const CM3: f64 = 1e-6;

/// Adds pressure and volume of the gas to the explanation.
pub(super) fn explain(model: &Identified, drawing: &Dimensions, to: &mut Explanation) {
    let pressure = pressure(model, drawing, to);
    volume(model, drawing, pressure, to);
}

/// Adds the gas pressure, computed from the gas force, to the explanation and returns it, Pa. Returns `None` if an end
/// of its interval is unbounded. If the pressure cannot be determined, adds a [`Gap`] instead and returns `None`.
fn pressure(model: &Identified, drawing: &Dimensions, to: &mut Explanation) -> Option<Uncertain> {
    const NAME: &str = "gas_pressure";
    let gap = |why: Template, parameters: Vec<&'static str>| Gap {
        name: NAME,
        why: why.into(),
        entries: drawing.missing(&[Entry::Rod]),
        parameters,
    };
    let force = match model.number(number!("gas_force")) {
        Standing::Known(force) => force,
        Standing::Off => {
            to.unknown.push(gap(phrases::NO_GAS_FORCE, vec!["gas_force"]));
            return None;
        }
        Standing::Open => {
            to.unknown.push(gap(phrases::GAS_FORCE_OPEN, vec!["gas_force"]));
            return None;
        }
    };
    let Some(rod) = drawing.known(Entry::Rod) else {
        to.unknown.push(gap(phrases::GAS_ON_ROD, Vec::new()));
        return None;
    };
    let inputs = [force, rod, Uncertain::within_factor(1.0, errors::GAS_PRESSURE)];
    let found = through(&inputs, |x| gas::pressure(x[0], x[1]) * x[2]);
    let from = vec!["gas_force", Entry::Rod.key()];
    to.quantities.push(Quantity::new(NAME, "bar gauge", found.scaled(1.0 / BAR), from, errors::GAS_PRESSURE));
    match found {
        Interval { value: Some(value), low: Some(low), high: Some(high) } => Some(Uncertain { value, low, high }),
        _ => None,
    }
}

fn volume(model: &Identified, drawing: &Dimensions, pressure: Option<Uncertain>, to: &mut Explanation) {
    const NAME: &str = "gas_volume";
    let gap = |why: Template, parameters: Vec<&'static str>| Gap {
        name: NAME,
        why: why.into(),
        entries: drawing.missing(&[Entry::Rod]),
        parameters,
    };
    let (stiffness, source, note) = match model.number(number!("gas_stiffness")) {
        Standing::Known(stiffness) => (stiffness, "gas_stiffness", None),
        Standing::Off => match model.number(number!("spring_linear")) {
            // The gas is nearly always the only spring over the whole stroke of a damper, so the parallel spring counts
            // as the gas.
            Standing::Known(spring) if spring.low > 0.0 => (spring, "spring_linear", Some(phrases::IF_SPRING_IS_GAS)),
            _ => return to.unknown.push(gap(phrases::NO_GAS_SPRING, vec!["gas_stiffness"])),
        },
        Standing::Open => {
            let why = phrases::GAS_SPRING_OPEN;
            return to.unknown.push(gap(why, vec!["gas_stiffness"]));
        }
    };
    let stated = drawing.stated(Entry::GasPressure);
    let (Some(rod), Some(pressure)) = (drawing.known(Entry::Rod), stated.or(pressure)) else {
        return to.unknown.push(gap(phrases::VOLUME_FROM, Vec::new()));
    };
    let inputs = [pressure, stiffness, rod, Uncertain::within_factor(1.0, errors::GAS_VOLUME)];
    let found = through(&inputs, |x| if x[1] > 0.0 { gas::volume(x[0], x[1], x[2]) * x[3] } else { f64::INFINITY });
    let pressure = if stated.is_some() { Entry::GasPressure.key() } else { "gas_force" };
    let from = vec![source, pressure, Entry::Rod.key()];
    // If the drawing states a larger gas volume than the interval, the gas is softer than the parallel spring. The rest
    // of the stiffness then has another cause, which the note states. A smaller gas volume in the drawing is a
    // contradiction and is reported separately.
    let stated = drawing.stated(Entry::GasVolume).filter(|stated| found.high.is_some_and(|high| stated.low > high));
    let note = match (note, stated) {
        (Some(_), Some(stated)) => Some(
            Sentence::from(phrases::SPRING_IS_MORE_THAN_GAS).with("drawn", format!("{:.0}", stated.value / CM3)).with(
                "percent",
                found.value.map_or_else(String::new, |value| format!("{:.0}", 100.0 * value / stated.value)),
            ),
        ),
        (note, _) => note.map(Sentence::from),
    };
    let quantity = Quantity::new(NAME, "cm³", found.scaled(1.0 / CM3), from, errors::GAS_VOLUME);
    to.quantities.push(Quantity { note, ..quantity });
}
