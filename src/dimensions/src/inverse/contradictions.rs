//! Contradictions between the parameters of a model and the drawing.

use super::model::{Identified, Standing};
use super::report::{Cause, Contradiction, Explanation, digits};
use crate::dimensions::Dimensions;
use crate::entry::{ENTRIES, Entry, EntryRow};
use crate::forward::{Expectation, central, expectations};
use crate::phrases;
use crate::uncertain::{Uncertain, through};
use dashpot_core::number;
use dashpot_core::parameter::Number;
use dashpot_messages::Sentence;
use dashpot_records::reading_unit;

/// Natural logarithm of the largest factor, a hundred, by which the search for the cause of a contradiction changes an
/// entry. A mistaken unit gives a larger factor, and the mistaken entry is mostly outside its bounds.
const LARGEST_CHANGE: f64 = 4.6;
/// Step of the natural logarithm of an entry in the search for the cause of a contradiction. The result is interpolated
/// within the step.
const STEP: f64 = 0.02;
/// Largest ratio of a cause's change to the smallest change of all causes at which the entry of the cause is in doubt.
/// Every change is in units of the tolerance of its entry.
///
/// With a larger ratio, each contradiction of the oil column would also put the rod diameter in doubt, and thus every
/// quantity. Test: `round_trip.rs`.
const AS_LIKELY: f64 = 2.0;

impl Contradiction {
    /// Returns the causes whose change, in tolerances of the entry, is at most [`AS_LIKELY`] times that of the first
    /// cause.
    pub(super) fn likely_causes(&self) -> impl Iterator<Item = &Cause> {
        let least = self.causes.first().map_or(0.0, |cause| cause.tolerances);
        self.causes.iter().filter(move |cause| cause.tolerances <= AS_LIKELY * least)
    }
}

/// Parameter of the model, with the formula for its value from a drawing.
struct Stand<'a> {
    number: Number,
    noun: &'static str,
    /// Computes the central value that a drawing implies.
    central: &'a dyn Fn(&Dimensions) -> Option<f64>,
}

/// Adds the contradictions to the explanation: parameters whose interval in the model does not overlap the interval that
/// the drawing implies.
pub(super) fn explain(model: &Identified, drawing: &Dimensions, to: &mut Explanation) {
    let all = expectations(drawing);
    let find = |number: Number| all.iter().find(|expectation| expectation.number == number).cloned();
    let has_column = model.number(number!("oil_stiffness")) != Standing::Off;
    let has_series = model.number(number!("series_stiffness")) != Standing::Off;
    for expectation in &all {
        let number = expectation.number;
        let Standing::Known(own) = model.number(number) else { continue };
        // A shortening of zero means a column of constant length, not an estimate.
        if number == number!("oil_shortening") && own.value == 0.0 {
            continue;
        }
        let is_series = number == number!("series_stiffness");
        // Without a series spring, the oil column of the model includes the compliance of the eyes.
        let with_eyes = number == number!("oil_stiffness") && !has_series;
        let expectation =
            if with_eyes { in_series_with_eyes(expectation.clone(), drawing) } else { expectation.clone() };
        // Without an oil column, the series spring includes the compliance of eyes and oil, so it may be softer than
        // the eyes. Likewise, an oil column without a series spring includes the compliance of eyes and oil. It may be
        // softer than the oil if the drawing does not state the stiffness of the eyes.
        let may_be_softer =
            if is_series { !has_column } else { with_eyes && drawing.stated(Entry::EyeStiffness).is_none() };
        let is_below = own.high < expectation.expected.low && !may_be_softer;
        if is_below || own.low > expectation.expected.high {
            let of_drawing = |of: &Dimensions| {
                let value = central(of, number)?;
                let eyes = of.stated(Entry::EyeStiffness).filter(|_| with_eyes);
                Some(eyes.map_or(value, |eyes| in_series(value, eyes.value)))
            };
            let stand = Stand { number, noun: expectation.noun, central: &of_drawing };
            to.contradictions.push(contradiction(own, expectation, &stand, drawing));
        }
    }
    if let (Some(column), false, Standing::Known(own)) =
        (find(number!("oil_stiffness")), has_column, model.number(number!("series_stiffness")))
        && own.low > column.expected.high
    {
        let of_drawing = |of: &Dimensions| central(of, number!("oil_stiffness"));
        let stand = Stand { number: number!("series_stiffness"), noun: "series stiffness", central: &of_drawing };
        to.contradictions.push(contradiction(own, column, &stand, drawing));
    }
    // If the gas spring is off, the parallel spring includes the stiffness of the gas, so it must not be softer than
    // the gas.
    if let (Some(gas), Standing::Off, Standing::Known(own)) =
        (find(number!("gas_stiffness")), model.number(number!("gas_stiffness")), model.number(number!("spring_linear")))
        && own.high < gas.expected.low
        // A spring without a linear term has another law, whose stiffness at zero says nothing about the gas.
        && own.value > 0.0
    {
        let of_drawing = |of: &Dimensions| central(of, number!("gas_stiffness"));
        let stand = Stand { number: number!("spring_linear"), noun: "parallel spring", central: &of_drawing };
        to.contradictions.push(contradiction(own, gas, &stand, drawing));
    }
}

/// Computes the stiffness, N/m, of two springs in series from their stiffnesses, N/m.
fn in_series(one: f64, other: f64) -> f64 {
    1.0 / (1.0 / one + 1.0 / other)
}

/// Returns the expected stiffness of an oil column in series with the eyes, if the drawing states the eyes' stiffness.
fn in_series_with_eyes(column: Expectation, of: &Dimensions) -> Expectation {
    let Some(eyes) = of.stated(Entry::EyeStiffness) else { return column };
    let found = through(&[column.expected, eyes], |x| in_series(x[0], x[1]));
    match (found.value, found.low, found.high) {
        (Some(value), Some(low), Some(high)) => {
            let from = column.from.into_iter().chain([Entry::EyeStiffness.key()]).collect();
            Expectation { expected: Uncertain { value, low, high }, from, ..column }
        }
        _ => column,
    }
}

fn contradiction(own: Uncertain, expectation: Expectation, stand: &Stand<'_>, drawing: &Dimensions) -> Contradiction {
    let (model, dimensions) = (own.value, expectation.expected.value);
    let unit = stand.number.parameter().unit;
    let with_unit = |value: f64| {
        // Both values are in the unit of the tables of the model's numbers.
        let (factor, unit) = reading_unit(model, unit);
        format!("{} {unit}", digits(factor * value)).trim_end().to_owned()
    };
    let is_one = expectation.from.len() == 1 && expectation.number != number!("gas_force");
    let causes = causes(own.value, &expectation, stand, drawing);
    let cause = match causes.first() {
        Some(cause) => {
            Sentence::from(phrases::EXPLAINED_BY).with("entry", cause.entry).with("value", digits(cause.value))
        }
        None => phrases::NO_CAUSE.into(),
    };
    // A drawing may state zero, for example no gas pressure. Then there is no ratio.
    let template = match (dimensions == 0.0, is_one) {
        (true, _) => phrases::CONTRADICTS_ZERO,
        (false, true) => phrases::CONTRADICTS_ONE,
        (false, false) => phrases::CONTRADICTS_SEVERAL,
    };
    let text = Sentence::from(template)
        .with_word("noun", stand.noun)
        .with("model", with_unit(model))
        .with("ratio", two_digits(model / dimensions))
        .with("dimensions", with_unit(dimensions))
        .with_sentence("facts", facts(&expectation, drawing))
        .with_sentence("cause", cause);
    Contradiction {
        parameter: stand.number.name(),
        model,
        dimensions,
        ratio: model / dimensions,
        unit,
        entries: expectation.from,
        causes,
        text,
    }
}

/// Returns the stated entries that explain the value of the model if only that entry has another value. The entry with
/// the smallest change, in units of its tolerance, is first.
fn causes(own: f64, expectation: &Expectation, stand: &Stand<'_>, drawing: &Dimensions) -> Vec<Cause> {
    let rows = ENTRIES.iter().filter(|row| expectation.from.contains(&row.key));
    let mut causes: Vec<Cause> = rows
        .filter_map(|row| {
            let stated = drawing.stated(row.entry)?;
            let bounds = (row.bounds.0 * row.to_si, row.bounds.1 * row.to_si);
            if stated.value == 0.0 {
                return cause_of_zero(own, row, stand, drawing);
            }
            let log_ratio = |change: f64| {
                let by = libm::exp(change);
                let value = Uncertain { value: by * stated.value, low: by * stated.low, high: by * stated.high };
                let is_possible = (bounds.0..=bounds.1).contains(&value.value);
                let central = (stand.central)(&drawing.clone().with(row.entry, value)).filter(|_| is_possible)?;
                Some(libm::log(central / own)).filter(|ratio| ratio.is_finite())
            };
            let change = [1.0, -1.0]
                .into_iter()
                .filter_map(|direction| first_zero(|size| log_ratio(direction * size)).map(|size| direction * size))
                .min_by(|a, b| a.abs().total_cmp(&b.abs()))?;
            let tolerance = (0.5 * libm::log(stated.high / stated.low)).max(Entry::Bore.row().tolerance);
            let value = libm::exp(change) * stated.value / row.to_si;
            Some(Cause { entry: row.key, value, tolerances: change.abs() / tolerance })
        })
        .collect();
    causes.sort_by(|a, b| a.tolerances.total_cmp(&b.tolerances));
    causes
}

/// Returns the value of an entry stated as zero that explains the value of the model. Its change is relative to the
/// tolerance of that value.
fn cause_of_zero(own: f64, row: &EntryRow, stand: &Stand<'_>, drawing: &Dimensions) -> Option<Cause> {
    let largest = row.bounds.1 * row.to_si;
    let value_at = |change: f64| largest * libm::expm1(change) / libm::expm1(LARGEST_CHANGE);
    let difference = |change: f64| {
        let stated = Uncertain { value: value_at(change), low: value_at(change), high: value_at(change) };
        let central = (stand.central)(&drawing.clone().with(row.entry, stated))?;
        Some(central / own - 1.0).filter(|difference| difference.is_finite())
    };
    let value = value_at(first_zero(difference)?) / row.to_si;
    Some(Cause { entry: row.key, value, tolerances: 1.0 / row.tolerance.max(Entry::Bore.row().tolerance) })
}

/// Returns the smallest positive change up to [`LARGEST_CHANGE`] at which a function changes its sign. Returns `None`
/// if there is no such change, or if the function has no value at a smaller change.
fn first_zero(function: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    let mut last = function(0.0)?;
    let steps = (LARGEST_CHANGE / STEP) as usize;
    for step in 1..=steps {
        let next = function(STEP * step as f64)?;
        if (next > 0.0) != (last > 0.0) {
            return Some(STEP * (step as f64 - next / (next - last)));
        }
        last = next;
    }
    None
}

/// Formats the entries from which an expectation follows, with their values in the drawing.
fn facts(expectation: &Expectation, drawing: &Dimensions) -> Sentence {
    let rows = ENTRIES.iter().filter(|row| expectation.from.contains(&row.key));
    let value = |key: &str| {
        let row = ENTRIES.iter().find(|row| row.key == key)?;
        Some(plain(drawing.stated(row.entry)?.value / row.to_si))
    };
    if let (true, Some(pressure), Some(rod)) =
        (expectation.number == number!("gas_force"), value("gas_pressure_bar"), value("rod_mm"))
    {
        return Sentence::from(phrases::PRESSURE_ON_ROD).with("pressure", pressure).with("diameter", rod);
    }
    let all: Vec<String> = rows.filter_map(|row| Some(format!("{} = {}", row.key, value(row.key)?))).collect();
    Sentence::as_it_is(all.join(", "))
}

/// Formats a number as in the file, without digits due to rounding in the conversion to SI. The center of a stated
/// range may have many digits; it is rounded to three decimals.
fn plain(value: f64) -> String {
    let text = if value.abs() < 1.0 { format!("{value:.6}") } else { format!("{value:.3}") };
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn two_digits(ratio: f64) -> String {
    if ratio >= 10.0 {
        format!("{ratio:.0}")
    } else if ratio >= 1.0 {
        format!("{ratio:.1}")
    } else {
        format!("{ratio:.2}")
    }
}
