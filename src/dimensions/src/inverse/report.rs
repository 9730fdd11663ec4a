//! Report of an explanation: quantities, gaps and contradictions, as JSON and as lines.

use crate::phrases::{self, QUANTITIES};
use crate::uncertain::Interval;
use dashpot_messages::Sentence;
use serde::Serialize;

/// A quantity of the damper that follows from the model.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quantity {
    /// Name of the quantity.
    pub name: &'static str,
    /// Value, or `None` if only a bound is known.
    pub value: Option<f64>,
    /// Lower end of the 95 % interval, or `None` if unbounded.
    pub low: Option<f64>,
    /// Upper end of the interval, or `None` if unbounded.
    pub high: Option<f64>,
    /// Unit of the value and of the interval.
    pub unit: &'static str,
    /// Parameters of the model and entries of the drawing from which the quantity follows.
    pub from: Vec<&'static str>,
    /// Factor within which the error due to the form of the model lies in 95 of 100 dampers. The interval includes this
    /// error.
    pub model_error: f64,
    /// Further remark, if any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<Sentence>,
}

/// A quantity that cannot be determined.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Gap {
    /// Name of the quantity.
    pub name: &'static str,
    /// Reason why the quantity cannot be determined.
    pub why: Sentence,
    /// Entries of the drawing that are missing.
    pub entries: Vec<&'static str>,
    /// Parameters of the model that are missing.
    pub parameters: Vec<&'static str>,
}

/// A parameter of the model that contradicts the drawing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Contradiction {
    /// Parameter of the model.
    pub parameter: &'static str,
    /// Value of the model.
    pub model: f64,
    /// Value that the drawing implies.
    pub dimensions: f64,
    /// Ratio of the model's value to that of the drawing.
    pub ratio: f64,
    /// Unit of `model` and `dimensions`.
    pub unit: &'static str,
    /// Entries of the drawing from which `dimensions` was computed. At least one of them, or the model, is wrong.
    pub entries: Vec<&'static str>,
    /// Entries that would explain the contradiction if only that entry had another value, the smallest change first.
    pub causes: Vec<Cause>,
    /// The contradiction as a sentence.
    pub text: Sentence,
}

/// An entry of the drawing that would explain a contradiction if only this entry had another value.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cause {
    /// Key of the entry in the drawing.
    pub entry: &'static str,
    /// Value that explains the contradiction, in the unit of the drawing.
    pub value: f64,
    /// Ratio of the logarithmic change to the tolerance of the entry.
    pub tolerances: f64,
}

/// Physical quantities of a damper, explained from its model.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Explanation {
    /// Determined quantities.
    pub quantities: Vec<Quantity>,
    /// Quantities that cannot be determined, with the reasons.
    pub unknown: Vec<Gap>,
    /// Contradictions between drawing and model.
    pub contradictions: Vec<Contradiction>,
}

impl Explanation {
    /// Returns the quantity with a name.
    pub fn find(&self, name: &str) -> Option<&Quantity> {
        self.quantities.iter().find(|quantity| quantity.name == name)
    }

    /// Formats the explanation as lines for a terminal.
    pub fn lines(&self) -> Vec<String> {
        let mut lines: Vec<String> = self.quantities.iter().map(Quantity::line).collect();
        lines.extend(self.unknown.iter().map(Gap::line));
        lines.extend(self.contradictions.iter().map(|found| format!("contradiction: {}", found.text)));
        if lines.is_empty() {
            lines.push("The drawing states nothing and the model has nothing to explain.".to_owned());
        }
        lines
    }
}

/// Returns the English name of a quantity.
fn noun(name: &'static str) -> &'static str {
    QUANTITIES.iter().find(|(known, _)| *known == name).map_or(name, |(_, noun)| *noun)
}

/// Formats a number with three significant digits.
pub fn digits(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || !size.is_finite() {
        return format!("{value}");
    }
    let behind = (2 - libm::floor(libm::log10(size)) as i32).clamp(0, 9) as usize;
    format!("{value:.behind$}")
}

impl Quantity {
    /// Makes a quantity from an interval in the unit of the quantity.
    pub(super) fn new(
        name: &'static str,
        unit: &'static str,
        found: Interval,
        from: Vec<&'static str>,
        model_error: f64,
    ) -> Quantity {
        let Interval { value, low, high } = found;
        // If one end is unbounded, a central value would be misleading.
        let value = value.filter(|_| low.is_some() && high.is_some());
        Quantity { name, value, low, high, unit, from, model_error, note: None }
    }

    /// Adds a remark after the present one.
    pub(super) fn add_note(&mut self, note: Sentence) {
        let all = self.note.take().into_iter().chain([note]).collect();
        self.note = Some(Sentence::list(all, phrases::SEMICOLON));
    }

    /// Returns the English name of the quantity.
    pub fn noun(&self) -> &'static str {
        noun(self.name)
    }

    fn line(&self) -> String {
        let unit = self.unit;
        let range = match (self.low, self.high) {
            (Some(low), Some(high)) => format!("95 %: {} to {}", digits(low), digits(high)),
            (Some(low), None) => format!("95 %: at least {} {unit}", digits(low)),
            (None, Some(high)) => format!("95 %: at most {} {unit}", digits(high)),
            (None, None) => "not determined by records and drawing".to_owned(),
        };
        let note = self.note.as_ref().map_or_else(String::new, |note| format!("; {note}"));
        let name = self.name.replace('_', " ");
        let value = self.value.map_or_else(String::new, |value| format!("{} {unit}, ", digits(value)));
        format!("{name:<24} {value}{range}, from {}{note}", self.from.join(", "))
    }
}

impl Gap {
    /// Returns the English name of the quantity.
    pub fn noun(&self) -> &'static str {
        noun(self.name)
    }

    fn line(&self) -> String {
        let mut line = format!("{:<24} cannot be told: {}", self.name.replace('_', " "), self.why);
        if !self.entries.is_empty() {
            line += &format!("; the drawing lacks {}", self.entries.join(", "));
        }
        if !self.parameters.is_empty() {
            line += &format!("; the model lacks {}", self.parameters.join(", "));
        }
        line
    }
}
