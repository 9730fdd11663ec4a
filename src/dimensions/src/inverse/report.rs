//! What an explanation says: quantities, gaps and contradictions, as JSON and in lines.

use crate::phrases::QUANTITIES;
use crate::uncertain::Interval;
use dashpot_messages::Sentence;
use serde::Serialize;

/// A quantity of the damper that the model tells.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quantity {
    /// Name.
    pub name: &'static str,
    /// Value; `None` where only a bound is known.
    pub value: Option<f64>,
    /// Lower end of the 95 % interval; `None` where it has none.
    pub low: Option<f64>,
    /// Upper end; `None` where it has none.
    pub high: Option<f64>,
    /// Unit.
    pub unit: &'static str,
    /// Parameters of the model and entries of the drawing that it follows from.
    pub from: Vec<&'static str>,
    /// Factor by which the model's form may be off in 95 of 100 dampers; it is in the interval.
    pub model_error: f64,
    /// What else is to know, or nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<Sentence>,
}

/// A quantity that cannot be told.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Gap {
    /// Name.
    pub name: &'static str,
    /// Why.
    pub why: Sentence,
    /// Entries of the drawing that are missing.
    pub entries: Vec<&'static str>,
    /// Parameters of the model that are missing.
    pub parameters: Vec<&'static str>,
}

/// A number of the model that the drawing contradicts.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Contradiction {
    /// Parameter of the model.
    pub parameter: &'static str,
    /// What the model has.
    pub model: f64,
    /// What the drawing gives.
    pub dimensions: f64,
    /// The one over the other.
    pub ratio: f64,
    /// Unit of both.
    pub unit: &'static str,
    /// In a sentence.
    pub text: Sentence,
}

/// What a model says of its damper.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Explanation {
    /// What is told.
    pub quantities: Vec<Quantity>,
    /// What cannot be told, and why.
    pub unknown: Vec<Gap>,
    /// Where drawing and model contradict each other.
    pub contradictions: Vec<Contradiction>,
}

impl Explanation {
    /// The quantity of a name.
    pub fn find(&self, name: &str) -> Option<&Quantity> {
        self.quantities.iter().find(|quantity| quantity.name == name)
    }

    /// In lines for a terminal.
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

/// What the quantity of a name is called.
fn noun(name: &'static str) -> &'static str {
    QUANTITIES.iter().find(|(known, _)| *known == name).map_or(name, |(_, noun)| *noun)
}

/// A number with three digits that count.
pub fn digits(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || !size.is_finite() {
        return format!("{value}");
    }
    let behind = (2 - libm::floor(libm::log10(size)) as i32).clamp(0, 9) as usize;
    format!("{value:.behind$}")
}

impl Quantity {
    /// From an interval in the quantity's own unit.
    pub(super) fn new(
        name: &'static str,
        unit: &'static str,
        found: Interval,
        from: Vec<&'static str>,
        model_error: f64,
    ) -> Quantity {
        let Interval { value, low, high } = found;
        // Where one end is open, a value in the middle would say more than is known.
        let value = value.filter(|_| low.is_some() && high.is_some());
        Quantity { name, value, low, high, unit, from, model_error, note: None }
    }

    /// What it is called, in English.
    pub fn noun(&self) -> &'static str {
        noun(self.name)
    }

    fn line(&self) -> String {
        let unit = self.unit;
        let range = match (self.low, self.high) {
            (Some(low), Some(high)) => format!("95 %: {} to {}", digits(low), digits(high)),
            (Some(low), None) => format!("95 %: at least {}", digits(low)),
            (None, Some(high)) => format!("95 %: at most {}", digits(high)),
            (None, None) => "no bound".to_owned(),
        };
        let note = self.note.as_ref().map_or_else(String::new, |note| format!("; {note}"));
        let name = self.name.replace('_', " ");
        let value = self.value.map_or_else(|| format!("{unit}, "), |value| format!("{} {unit}, ", digits(value)));
        format!("{name:<24} {value}{range}, from {}{note}", self.from.join(", "))
    }
}

impl Gap {
    /// What the quantity is called, in English.
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
