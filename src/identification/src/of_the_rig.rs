//! Measurement errors that a fit estimates: delay of the force channel, mass on the load cell, drift of gain and zero through a campaign.
//!
//! A fit does not estimate a constant zero error. A zero error of the force is equivalent to another gas force, and one of the displacement
//! to another spring characteristic. So only the user can state a zero error ([`dashpot_records::Options`]).
//!
//! The search for the effects of the damper also decides about these errors, and estimates them together with the numbers of the model.
//! They never become part of the model.

use super::phrases;
use dashpot_estimation::deviations::sandwich;
use dashpot_estimation::hypothesis::{Free, Hypothesis};
use dashpot_estimation::measurement::Artefact;
use dashpot_estimation::refit::Refit;
use dashpot_estimation::samples::Test;
use dashpot_messages::Sentence;
use dashpot_records::Reading;
use dashpot_records::measurement_correction::MeasurementError;
use serde::Serialize;

/// Measurement errors that a fit tries.
const LOOKED_FOR: [Artefact; 4] = [Artefact::Delay, Artefact::Mass, Artefact::GainDrift, Artefact::Drift];

/// Ratio of the highest to the lowest frequency of the tests above which they distinguish a delay from a compliance.
///
/// The phases of a delay and of a compliance grow with frequency, but along different curves. If all tests have the same frequency, a delay
/// and a compliance can give the same phase. The value 1.5 is a choice. The ratio also decides whether the tests distinguish a mass on the
/// load cell from a spring.
const APART: f64 = 1.5;

/// Returns whether the frequencies of the tests distinguish a delay of the force channel from a soft series path.
pub fn can_distinguish_delay(tests: &[Test]) -> bool {
    let turns = |t: &Test| t.segment.peak_velocity / t.segment.amplitude;
    let (low, high) = tests
        .iter()
        .filter(|t| t.segment.amplitude > 0.0)
        .map(turns)
        .fold((f64::INFINITY, 0.0f64), |(l, h), w| (l.min(w), h.max(w)));
    high > APART * low
}

/// Measurement error of the records, with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Measured {
    /// Name: `delay`, `rig_mass`, `gain_drift` or `drift` (drift of the zero of the force).
    pub name: &'static str,
    /// Value, in `unit`.
    pub value: f64,
    /// Lower end of the 95 % interval.
    pub low: f64,
    /// Upper end of the 95 % interval.
    pub high: f64,
    /// Unit of the value and of the interval.
    pub unit: &'static str,
    /// Command-line option that states this error to the reader of records, or `None` if there is no such option.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub option: Option<&'static str>,
}

impl Measured {
    /// Makes a measurement error from the result of a fit.
    fn new(artefact: Artefact, [value, low, high]: [f64; 3]) -> Measured {
        let option = match artefact {
            Artefact::Delay => Some("--delay"),
            Artefact::Mass => Some("--rig-mass"),
            _ => None,
        };
        Measured { name: artefact.parameter(), value, low, high, unit: artefact.unit(), option }
    }

    /// Makes a measurement error from its name and numbers in a model file. Returns `None` for a name that no fit tries, for numbers that
    /// are not finite, and for a negative mass.
    pub fn named(name: &str, numbers: [f64; 3]) -> Option<Measured> {
        let artefact = LOOKED_FOR.into_iter().find(|artefact| artefact.parameter() == name)?;
        let may = numbers.iter().all(|n| n.is_finite()) && (artefact.bounds().0 < 0.0 || numbers[0] >= 0.0);
        may.then(|| Measured::new(artefact, numbers))
    }

    /// Makes a measurement error from the result of a fit or a diagnosis. Returns `None` if no fit tries the error, or if a number is not
    /// finite.
    pub fn from_artefact(artefact: Artefact, numbers: [f64; 3]) -> Option<Measured> {
        let may = LOOKED_FOR.contains(&artefact) && numbers.iter().all(|n| n.is_finite());
        may.then(|| Measured::new(artefact, numbers))
    }

    /// Returns the total error: the one found in the corrected records plus the delay or mass that the user stated.
    pub fn with_stated(self, given: &MeasurementError) -> Measured {
        let before = match self.name {
            "delay" => given.delay_s,
            "rig_mass" => given.mass_kg,
            _ => 0.0,
        };
        Measured { value: self.value + before, low: self.low + before, high: self.high + before, ..self }
    }

    /// Adds the error `rest` to this error. It was found in records that were already corrected for this error. The two errors count as
    /// independent, so the squares of their half-widths add.
    pub fn and(self, rest: Measured) -> Measured {
        let value = self.value + rest.value;
        let half = |m: &Measured| 0.5 * (m.high - m.low);
        let half = libm::hypot(half(&self), half(&rest));
        Measured { value, low: value - half, high: value + half, ..self }
    }

    /// Returns the name of the effect for this error in the vocabulary of the diagnosis.
    pub fn effect(&self) -> Option<&'static str> {
        LOOKED_FOR.into_iter().find(|artefact| artefact.parameter() == self.name).map(Artefact::name)
    }

    /// Returns whether the interval excludes zero.
    pub fn is_there(&self) -> bool {
        self.low > 0.0 || self.high < 0.0
    }

    /// Formats the option that states this error to the reader of other records.
    pub fn as_option(&self) -> Option<String> {
        self.option.map(|option| format!("{option}={:.6}", self.value))
    }

    /// Returns value and ends of the interval in the unit of tables and sentences, for example % a minute instead of 1/s.
    pub fn shown(&self) -> [f64; 3] {
        let (factor, _) = self.shown_unit();
        [self.value, self.low, self.high].map(|number| factor * number)
    }

    /// Returns the factor from `unit` to the unit of tables and sentences, and that unit.
    fn shown_unit(&self) -> (f64, &'static str) {
        match self.name {
            "delay" => (1e3, "ms"),
            "rig_mass" => (1.0, "kg"),
            "gain_drift" => (100.0 * 60.0, "%/min"),
            _ => (60.0, "N/min"),
        }
    }

    /// Formats the error and its interval with the digits and the unit that all tables and sentences use.
    pub fn reading(&self) -> Reading {
        Reading::in_unit(self.shown(), self.shown_unit().1)
    }

    /// Formats the error and its interval as a sentence.
    pub fn finding(&self) -> Sentence {
        // Report a negative delay as a leading channel, because an engineer would consider a negative delay a mistake.
        let is_early = self.name == "delay" && self.value < 0.0;
        let Reading { value, low, high, .. } = if is_early {
            Measured { value: -self.value, low: -self.high, high: -self.low, ..*self }.reading()
        } else {
            self.reading()
        };
        let what = match self.name {
            "delay" if is_early => phrases::FOUND_EARLY,
            "delay" => phrases::FOUND_DELAY,
            "rig_mass" => phrases::FOUND_MASS,
            "gain_drift" => phrases::FOUND_GAIN_DRIFT,
            _ => phrases::FOUND_DRIFT,
        };
        Sentence::from(what).with("value", value).with("low", low).with("high", high)
    }

    /// Formats the error as a sentence that also states that the records are corrected for it, and not the model.
    pub fn in_words(&self) -> Sentence {
        let option = self.as_option().map(|option| Sentence::from(phrases::GIVE_OPTION).with("option", option));
        Sentence::from(phrases::TAKEN_OUT_HERE).with_sentence("finding", self.finding()).with_any("option", option)
    }
}

/// Combines the errors that a fit found in the form with which records are corrected. An error that was not found is 0.
pub fn to_measurement_error(measured: &[Measured]) -> MeasurementError {
    let of = |name: &str| measured.iter().find(|m| m.name == name).map_or(0.0, |m| m.value);
    MeasurementError {
        delay_s: of("delay"),
        mass_kg: of("rig_mass"),
        gain_per_s: of("gain_drift"),
        zero_n_per_s: of("drift"),
    }
}

/// Returns the measurement errors that a fit found, with 95 % intervals. The list is empty if the covariance cannot be computed.
pub fn measured(hypothesis: &Hypothesis, refit: &Refit, tests: &[Test]) -> Vec<Measured> {
    let is_rig = |free: &Free| matches!(free, Free::Rig(_));
    if !hypothesis.numbers.iter().any(|n| is_rig(&n.free)) {
        return Vec::new();
    }
    let Some((covariance, _)) = sandwich(hypothesis, refit, tests) else { return Vec::new() };
    let numbers = hypothesis.numbers.iter().enumerate();
    numbers
        .filter_map(|(k, number)| {
            let Free::Rig(artefact) = number.free else { return None };
            let [low, high] = hypothesis.interval(k, refit.theta[k], covariance[(k, k)].max(0.0).sqrt());
            Measured::from_artefact(artefact, [refit.theta[k], low, high])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mass_below_zero_is_no_measurement_error() {
        assert!(Measured::named("rig_mass", [-3.0, -3.1, -2.9]).is_none());
        assert!(Measured::named("rig_mass", [0.0, -0.1, 0.1]).is_some());
        assert!(Measured::named("delay", [-3e-3, -3.1e-3, -2.9e-3]).is_some());
    }

    #[test]
    fn a_force_channel_that_leads_is_told_as_early() {
        let said = |numbers| Measured::new(Artefact::Delay, numbers).finding().to_string();
        assert_eq!(said([3e-3, 2.9e-3, 3.1e-3]), "the force channel lags the motion by 3.00 ms (95 %: 2.90 to 3.10)");
        assert_eq!(
            said([-0.635e-3, -0.7e-3, -0.5e-3]),
            "the force channel comes early by 0.64 ms (95 %: 0.50 to 0.70)"
        );
    }
}
