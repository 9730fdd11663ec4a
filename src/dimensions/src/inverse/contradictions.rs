//! Contradictions between the parameters of a model and the drawing.

use super::model::{Identified, Standing};
use super::report::{Contradiction, Explanation, digits};
use crate::dimensions::Dimensions;
use crate::entry::ENTRIES;
use crate::forward::{Expectation, expectations};
use crate::phrases;
use crate::uncertain::Uncertain;
use dashpot_core::number;
use dashpot_messages::Sentence;

/// Adds the contradictions to the explanation: parameters whose interval in the model does not overlap the interval that
/// the drawing implies.
pub(super) fn explain(model: &Identified, drawing: &Dimensions, to: &mut Explanation) {
    let all = expectations(drawing);
    let column = all.iter().find(|e| e.number == number!("oil_stiffness"));
    let has_column = model.number(number!("oil_stiffness")) != Standing::Off;
    for expectation in &all {
        let Standing::Known(own) = model.number(expectation.number) else { continue };
        // A shortening of zero means a column of constant length, not an estimate.
        if expectation.number == number!("oil_shortening") && own.value == 0.0 {
            continue;
        }
        let is_series = expectation.number == number!("series_stiffness");
        // Without an oil column, the series spring includes eyes and oil, so it may be softer than the eyes.
        let is_below = own.high < expectation.expected.low && (!is_series || has_column);
        if is_below || own.low > expectation.expected.high {
            to.contradictions.push(contradiction(own, expectation, drawing));
        }
    }
    if let (Some(column), false, Standing::Known(own)) = (column, has_column, model.number(number!("series_stiffness")))
        && own.low > column.expected.high
    {
        let own_of_series =
            Expectation { number: number!("series_stiffness"), noun: "series stiffness", ..column.clone() };
        to.contradictions.push(contradiction(own, &own_of_series, drawing));
    }
}

fn contradiction(own: Uncertain, expectation: &Expectation, drawing: &Dimensions) -> Contradiction {
    let (model, dimensions) = (own.value, expectation.expected.value);
    let unit = expectation.number.parameter().unit;
    let with_unit = |value: f64| {
        let digits = digits(value);
        if unit == "-" { digits } else { format!("{digits} {unit}") }
    };
    let is_one = expectation.from.len() == 1 && expectation.number != number!("gas_force");
    let text = Sentence::from(if is_one { phrases::CONTRADICTS_ONE } else { phrases::CONTRADICTS_SEVERAL })
        .with_word("noun", expectation.noun)
        .with("model", with_unit(model))
        .with("ratio", two_digits(model / dimensions))
        .with("dimensions", with_unit(dimensions))
        .with_sentence("facts", facts(expectation, drawing));
    Contradiction {
        parameter: expectation.number.name(),
        model,
        dimensions,
        ratio: model / dimensions,
        unit,
        entries: expectation.from.clone(),
        text,
    }
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

/// Formats a number as in the file, without digits due to rounding in the conversion to SI. The center of a stated range may have many
/// digits; it is rounded to three decimals.
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
