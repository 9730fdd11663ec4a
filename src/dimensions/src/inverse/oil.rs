//! Moduli of the oil and its air content, from the stiffness of the oil column.

use super::errors;
use super::model::{Identified, Standing};
use super::report::{Explanation, Gap, Quantity};
use crate::dimensions::{Design, Dimensions};
use crate::entry::Entry;
use crate::oil;
use crate::phrases;
use crate::uncertain::{Interval, Uncertain, through};
use dashpot_core::number;
use dashpot_messages::Sentence;
use dashpot_messages::Template;

/// Pascals per GPa.
const GPA: f64 = 1e9;
/// Entries of the chamber that is compressed in rebound. [`BOTH_CHAMBERS`] contains those of both chambers, which are
/// compressed in compression of a twin tube.
const CHAMBER: &[Entry] = &[Entry::Bore, Entry::Rod, Entry::ReboundChamber];
const BOTH_CHAMBERS: &[Entry] = &[Entry::Bore, Entry::Rod, Entry::ReboundChamber, Entry::CompressionChamber];

fn by_rebound(stiffness: f64, x: &[f64]) -> f64 {
    oil::modulus_of_rebound(stiffness, x[0], x[1], x[2])
}

fn by_compression(stiffness: f64, x: &[f64]) -> f64 {
    let in_rebound = stiffness / oil::compression_ratio(Design::TwinTube, x[0], x[1], [x[2], x[3]]);
    oil::modulus_of_rebound(in_rebound, x[0], x[1], x[2])
}

/// Adds the moduli and the air content of the oil to the explanation.
pub(super) fn explain(model: &Identified, drawing: &Dimensions, to: &mut Explanation) {
    let effective = column(model, drawing, to);
    without_tube(drawing, effective, to);
    air(model, drawing, effective, to);
}

/// A column stiffness with its inputs and the error factor due to the form of the model.
struct Column {
    inputs: Vec<Uncertain>,
    /// Computes the stiffness of the column from the inputs.
    stiffness: fn(&[f64]) -> f64,
    from: Vec<&'static str>,
    /// Entries of the compressed chamber.
    chamber: &'static [Entry],
    /// Computes the modulus from a stiffness and the entries of the chamber.
    modulus: fn(f64, &[f64]) -> f64,
    error: f64,
    note: Option<Template>,
    /// Whether the result is only a lower bound.
    is_bound: bool,
}

/// Returns the stiffness of the oil column. It comes from the model's oil column, or from its series spring without the
/// compliance of the eyes. The whole series spring gives only a bound. If none is known, the error lists the missing
/// parameters.
fn stiffness(model: &Identified, drawing: &Dimensions) -> Result<Column, Vec<&'static str>> {
    // Without a series spring in the model, its oil column includes the compliance of the eyes.
    let has_series = model.number(number!("series_stiffness")) != Standing::Off;
    let eyes = drawing.stated(Entry::EyeStiffness);
    let included: Vec<Uncertain> = eyes
        .filter(|_| !has_series)
        .into_iter()
        .flat_map(|eyes| [eyes, Uncertain::within_factor(1.0, errors::EYES)])
        .collect();
    // If the drawing does not state the eyes either, the oil alone is at least as stiff as the model's oil column.
    let is_bound = !has_series && eyes.is_none();
    let note_of = |note: Option<Template>| match () {
        () if is_bound => Some(phrases::COLUMN_BOUND),
        () if included.is_empty() => note,
        () => Some(phrases::COLUMN_LESS_THE_EYES),
    };
    // The stiffness in compression comes first, because in compression, the column of a twin tube is the softest
    // element in series. In rebound, the eyes are softer than the column.
    if let (Some(Design::TwinTube), Standing::Known(own), Standing::Known(ratio)) =
        (drawing.design, model.number(number!("oil_stiffness")), model.number(number!("oil_compression")))
        && ratio.value != 1.0
        && drawing.missing(BOTH_CHAMBERS).is_empty()
    {
        return Ok(Column {
            inputs: [own, ratio].into_iter().chain(included.iter().copied()).collect(),
            stiffness: |x| in_line_with(x[0] * x[1], stiffness_of_eyes(&x[2..])),
            from: vec!["oil_stiffness", "oil_compression"],
            chamber: BOTH_CHAMBERS,
            modulus: by_compression,
            error: errors::MODULUS,
            note: note_of(Some(phrases::BY_COMPRESSION)),
            is_bound,
        });
    }
    if let Standing::Known(own) = model.number(number!("oil_stiffness")) {
        return Ok(Column {
            inputs: [own].into_iter().chain(included.iter().copied()).collect(),
            stiffness: |x| in_line_with(x[0], stiffness_of_eyes(&x[1..])),
            from: vec!["oil_stiffness"],
            chamber: CHAMBER,
            modulus: by_rebound,
            error: errors::MODULUS,
            note: note_of(None),
            is_bound,
        });
    }
    let Standing::Known(series) = model.number(number!("series_stiffness")) else {
        return Err(vec!["oil_stiffness", "series_stiffness"]);
    };
    let is_open = model.number(number!("oil_stiffness")) == Standing::Off;
    match eyes {
        Some(eyes) if is_open => Ok(Column {
            inputs: vec![series, eyes, Uncertain::within_factor(1.0, errors::EYES)],
            stiffness: |x| in_line_with(x[0], x[1] * x[2]),
            from: vec!["series_stiffness", Entry::EyeStiffness.key()],
            chamber: CHAMBER,
            modulus: by_rebound,
            error: errors::SERIES_MODULUS,
            note: Some(phrases::LESS_THE_EYES),
            is_bound: false,
        }),
        _ if is_open => Ok(Column {
            inputs: vec![series],
            stiffness: |x| x[0],
            from: vec!["series_stiffness"],
            chamber: CHAMBER,
            modulus: by_rebound,
            error: errors::SERIES_MODULUS,
            note: Some(phrases::A_BOUND),
            is_bound: true,
        }),
        _ => Err(vec!["oil_stiffness"]),
    }
}

/// Computes the stiffness of the eyes, N/m, from their stated stiffness and its error factor. Infinite if both are
/// missing.
fn stiffness_of_eyes(inputs: &[f64]) -> f64 {
    if inputs.is_empty() { f64::INFINITY } else { inputs.iter().product() }
}

/// Computes the stiffness of a series spring without one of its parts, N/m. Infinite if the part is softer than the
/// whole.
fn in_line_with(whole: f64, part: f64) -> f64 {
    if whole < part { 1.0 / (1.0 / whole - 1.0 / part) } else { f64::INFINITY }
}

fn column(model: &Identified, drawing: &Dimensions, to: &mut Explanation) -> Option<Uncertain> {
    const NAME: &str = "oil_modulus_effective";
    let found = stiffness(model, drawing);
    let missing = drawing.missing(found.as_ref().map_or(CHAMBER, |found| found.chamber));
    let found = match found {
        Ok(found) if missing.is_empty() => found,
        Ok(_) => {
            let why = phrases::COLUMN_FROM.into();
            to.unknown.push(Gap { name: NAME, why, entries: missing, parameters: Vec::new() });
            return None;
        }
        Err(parameters) => {
            let why = phrases::NO_COLUMN.into();
            to.unknown.push(Gap { name: NAME, why, entries: missing, parameters });
            return None;
        }
    };
    let mut inputs = drawing.all(found.chamber)?;
    let own = inputs.len();
    inputs.push(Uncertain::within_factor(1.0, found.error));
    inputs.extend(&found.inputs);
    let mut interval = through(&inputs, |x| (found.modulus)((found.stiffness)(&x[own + 1..]), &x[..own]) * x[own]);
    // Where the eyes alone may be softer than the whole, the upper end is open. The lower end comes from samples in
    // which they are a little stiffer. It then exceeds the modulus of every oil, so it is no bound.
    let exceeds_oil = || {
        let oil = drawing.known(Entry::OilModulus);
        oil.zip(interval.low).is_some_and(|(oil, low)| low > oil.high)
    };
    if !found.is_bound && interval.high.is_none() && (interval.value.is_none() || exceeds_oil()) {
        let why = phrases::EYES_TOO_SOFT.into();
        to.unknown.push(Gap { name: NAME, why, entries: Vec::new(), parameters: Vec::new() });
        return None;
    }
    if found.is_bound {
        (interval.value, interval.high) = (None, None);
    }
    let from = found.from.iter().copied().chain(found.chamber.iter().map(|entry| entry.key())).collect();
    let quantity = Quantity::new(NAME, "GPa", interval.scaled(1.0 / GPA), from, found.error);
    to.quantities.push(Quantity { note: found.note.map(Sentence::from), ..quantity });
    match interval {
        Interval { value: Some(value), low: Some(low), high: Some(high) } => Some(Uncertain { value, low, high }),
        _ => None,
    }
}

/// Adds the modulus of the oil with its air, without the tube's compliance, to the explanation. If the modulus cannot
/// be determined, adds a [`Gap`] instead.
fn without_tube(drawing: &Dimensions, effective: Option<Uncertain>, to: &mut Explanation) {
    const NAME: &str = "oil_modulus";
    let needed = [Entry::Bore, Entry::TubeWall];
    let missing: Vec<_> =
        needed.iter().filter(|entry| drawing.stated(**entry).is_none()).map(|entry| entry.key()).collect();
    let (Some(effective), true) = (effective, missing.is_empty()) else {
        let why = if effective.is_none() { phrases::NO_MODULUS } else { phrases::TUBE_EXPANDS };
        return to.unknown.push(Gap { name: NAME, why: why.into(), entries: missing, parameters: Vec::new() });
    };
    let Some(mut inputs) = drawing.all(&[Entry::Bore, Entry::TubeWall, Entry::TubeModulus]) else { return };
    inputs.push(effective);
    let found = through(&inputs, |x| {
        let compliance = 1.0 / x[3] - oil::tube_compliance(x[0], x[1], x[2]);
        if compliance > 0.0 { 1.0 / compliance } else { f64::INFINITY }
    });
    let from = vec![NAME_OF_EFFECTIVE, Entry::Bore.key(), Entry::TubeWall.key()];
    let quantity = Quantity::new(NAME, "GPa", found.scaled(1.0 / GPA), from, errors::MODULUS);
    to.quantities.push(Quantity { note: Some(phrases::WITH_AIR.into()), ..quantity });
}

const NAME_OF_EFFECTIVE: &str = "oil_modulus_effective";

/// Adds the content of free air to the explanation. The content follows from the stroke of the aeration element, or
/// from the reduced modulus of the oil. If it cannot be determined, adds a [`Gap`] instead.
fn air(model: &Identified, drawing: &Dimensions, effective: Option<Uncertain>, to: &mut Explanation) {
    const NAME: &str = "air_content";
    let chamber = [Entry::GasPressure, Entry::ReboundChamber];
    if let Standing::Known(stroke) = model.number(number!("aeration_stroke")) {
        let Some(mut inputs) = drawing.all(&chamber) else {
            let why = phrases::STROKE_FROM.into();
            let entries = drawing.missing(&chamber);
            return to.unknown.push(Gap { name: NAME, why, entries, parameters: Vec::new() });
        };
        inputs.extend([stroke, Uncertain::within_factor(1.0, errors::AIR)]);
        let found =
            through(&inputs, |x| oil::air_of_stroke(x[2].max(0.0), x[0] + oil::ATMOSPHERE, x[1]) * x[3] * 100.0);
        let from = std::iter::once("aeration_stroke").chain(chamber.map(Entry::key)).collect();
        let found = at_most_all(found);
        return to.quantities.push(Quantity::new(NAME, "% at 1.013 bar absolute", found, from, errors::AIR));
    }
    let needed = [Entry::OilModulus, Entry::GasPressure, Entry::Bore];
    let mut missing = drawing.missing(&needed);
    if drawing.stated(Entry::OilModulus).is_none() {
        missing.insert(0, Entry::OilModulus.key());
    }
    let (Some(effective), true) = (effective, missing.is_empty()) else {
        let why = phrases::AIR_FROM.into();
        // If the model has an oil column, its modulus is only a bound unless the stiffness of the eyes is known.
        let has_column = matches!(model.number(number!("oil_stiffness")), Standing::Known(_));
        let parameters = match effective {
            None if !has_column => vec!["oil_stiffness or aeration_stroke"],
            _ => Vec::new(),
        };
        if effective.is_none() && has_column && drawing.stated(Entry::EyeStiffness).is_none() {
            missing.push(Entry::EyeStiffness.key());
        }
        return to.unknown.push(Gap { name: NAME, why, entries: missing, parameters });
    };
    let Some(mut inputs) =
        drawing.all(&[Entry::OilModulus, Entry::GasPressure, Entry::Bore, Entry::TubeWall, Entry::TubeModulus])
    else {
        return;
    };
    inputs.push(effective);
    let mut found = through(&inputs, |x| {
        let lacking = 1.0 / x[5] - 1.0 / x[0] - oil::tube_compliance(x[2], x[3], x[4]);
        100.0 * lacking.max(0.0) / oil::air_compliance(1.0, x[1] + oil::ATMOSPHERE)
    });
    if found.low == Some(0.0) {
        (found.value, found.low) = (None, None);
    }
    let from = vec![NAME_OF_EFFECTIVE, Entry::OilModulus.key(), Entry::GasPressure.key(), Entry::Bore.key()];
    let found = at_most_all(found);
    to.quantities.push(Quantity::new(NAME, "% at 1.013 bar absolute", found, from, errors::MODULUS));
}

/// Limits a volume fraction, %, to the whole volume.
fn at_most_all(Interval { value, low, high }: Interval) -> Interval {
    let limited = |end: Option<f64>| end.map(|end| end.min(100.0));
    Interval { value: limited(value), low: limited(low), high: limited(high) }
}
