//! What a fit looks for in the measurement itself: how late the force channel is, which mass hangs on the load cell, and how gain and zero
//! of the cell move through a campaign.
//!
//! A zero that is off all the time is not among them: of the force it is the same as another gas force, of the displacement the same as
//! another table of the spring, so that only the user can tell them ([`dashpot_records::Options`]). The others are estimated beside the
//! numbers of the model, where tests left out of the fit are predicted better with them, and never become part of the model.

use super::intervals::Z;
use super::phrases;
use dashpot_estimation::least_squares::covariance;
use dashpot_estimation::measurement::Artefact;
use dashpot_estimation::rig_number::RigNumber;
use dashpot_estimation::scale::Scale;
use dashpot_estimation::segment::Segment;
use dashpot_estimation::sensitivity::Accuracy;
use dashpot_estimation::unknowns::Unknowns;
use dashpot_records::Sentence;
use dashpot_records::taken_out::Off;
use serde::Serialize;

/// A number of the measurement that is looked for: what is usual of it and where its fit starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sought {
    usual: (f64, f64),
    start: f64,
}

/// The numbers of the measurement in a fit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct OfTheRig {
    delay: Option<Sought>,
    mass: Option<Sought>,
    gain_drift: Option<Sought>,
    force_drift: Option<Sought>,
}

/// How late the force channel of a rig usually comes, s: a filter of 200 Hz makes 1 ms.
const DELAY: f64 = 1e-3;
/// Mass, kg, that usually hangs between load cell and damper, as the table of priors has it: eye, clamp and joint have some tenths of a
/// kilogram to five, and a rig that makes up for it takes as much too little or too much.
const MASS: f64 = 2.0;
/// How much a load cell's gain (as a share) usually moves in a campaign. A guess on the wide side, since it pulls what is found towards
/// nothing: with half of it a true drift of 3.6 % came out 6 % too low.
const GAIN: f64 = 0.02;
/// How much its zero usually moves, N: a tenth of a percent of a cell of 20 kN. It pulls as that of the gain does.
const ZERO: f64 = 20.0;

/// What each is called, alone and all together.
const LATE: &str = "a late force channel";
const WITH_MASS: &str = "a mass on the load cell";
const GAIN_DRIFTS: &str = "a gain that drifts";
const ZERO_DRIFTS: &str = "a zero that drifts";
const ALL: &str = "all of these";
pub(super) const WORDS: [&str; 5] = [LATE, WITH_MASS, GAIN_DRIFTS, ZERO_DRIFTS, ALL];

/// All that is looked for, in the order in which the load cell makes it.
const LOOKED_FOR: [Artefact; 4] = [Artefact::Delay, Artefact::Mass, Artefact::GainDrift, Artefact::Drift];

impl OfTheRig {
    /// None of them.
    pub const NONE: OfTheRig = OfTheRig { delay: None, mass: None, gain_drift: None, force_drift: None };

    /// Each of them that these tests can show, alone, and all together, with names for the report. `late` is the delay that a first look at
    /// the records found, `scale` how strong the damper is, `clock_runs_on` whether their clocks run through the campaign: what drifts is not looked for by clocks that start anew.
    pub fn ways(
        segments: &[Segment],
        late: Option<f64>,
        clock_runs_on: bool,
        scale: Scale,
    ) -> Vec<(&'static str, OfTheRig)> {
        let around = |mean: f64, spread: f64| Some(Sought { usual: (mean, spread), start: mean });
        let mut all = OfTheRig::NONE;
        let mut ways = Vec::new();
        if tells_delay(segments) {
            all.delay = around(late.unwrap_or(0.0), DELAY);
            all.mass = around(0.0, MASS * scale.force());
            ways.push((LATE, OfTheRig { delay: all.delay, ..OfTheRig::NONE }));
            ways.push((WITH_MASS, OfTheRig { mass: all.mass, ..OfTheRig::NONE }));
        }
        let clocks = segments.iter().map(|s| s.clock);
        let last = clocks.clone().fold(0.0, f64::max);
        let span = last - clocks.fold(f64::INFINITY, f64::min);
        if clock_runs_on && segments.len() >= FEWEST && span > 0.5 * last && span > SHORTEST {
            (all.gain_drift, all.force_drift) = (around(0.0, GAIN / last), around(0.0, ZERO * scale.force() / last));
            ways.push((GAIN_DRIFTS, OfTheRig { gain_drift: all.gain_drift, ..OfTheRig::NONE }));
            ways.push((ZERO_DRIFTS, OfTheRig { force_drift: all.force_drift, ..OfTheRig::NONE }));
        }
        if ways.len() > 1 {
            ways.push((ALL, all));
        }
        ways
    }

    /// What the measurement may still be off by where it was not looked for, or not believed, and nobody gave it: how late the force channel of
    /// a rig usually is, and what usually hangs on its load cell. A soft series path looks like either.
    pub fn left_open(looked_for: &[RigNumber], given: &Off, scale: Scale) -> Vec<RigNumber> {
        let open = [(Artefact::Delay, DELAY, given.delay_s), (Artefact::Mass, MASS * scale.force(), given.mass_kg)];
        let is_open = |artefact: Artefact| looked_for.iter().all(|number| number.artefact != artefact);
        let open = open.into_iter().filter(|(artefact, _, given)| *given == 0.0 && is_open(*artefact));
        open.map(|(artefact, spread, _)| RigNumber { artefact, start: 0.0, usual: (0.0, spread) }).collect()
    }

    /// Whether it ended at a mass below nothing.
    pub fn has_less_than_no_mass(self) -> bool {
        self.mass.is_some_and(|mass| mass.start < 0.0)
    }

    /// The delay at which it ended, s.
    pub fn delay_found(self) -> f64 {
        self.delay.map_or(0.0, |delay| delay.start)
    }

    /// The same without what moves the zero.
    pub fn without_drift(self) -> OfTheRig {
        OfTheRig { force_drift: None, ..self }
    }

    /// Whether a late force channel is all that is looked for.
    pub fn is_delay_alone(self) -> bool {
        self.delay.is_some() && self.all().count() == 1
    }

    fn all(self) -> impl Iterator<Item = (Artefact, Sought)> {
        LOOKED_FOR
            .into_iter()
            .zip([self.delay, self.mass, self.gain_drift, self.force_drift])
            .filter_map(|(artefact, sought)| Some((artefact, sought?)))
    }

    /// As numbers of a fit.
    pub fn numbers(self) -> Vec<RigNumber> {
        self.all().map(|(artefact, s)| RigNumber { artefact, start: s.start, usual: s.usual }).collect()
    }

    /// The same from where another fit of them ended.
    pub fn starting_at(mut self, ended: &[RigNumber]) -> OfTheRig {
        for number in ended {
            let sought = match number.artefact {
                Artefact::Delay => &mut self.delay,
                Artefact::Mass => &mut self.mass,
                Artefact::GainDrift => &mut self.gain_drift,
                Artefact::Drift => &mut self.force_drift,
                _ => continue,
            };
            if let Some(sought) = sought {
                sought.start = number.start;
            }
        }
        self
    }
}

/// Fewest tests from which a drift through a campaign shows apart from the tests' own differences: two numbers need twice as many tests,
/// and as many again for what the model itself takes from each.
const FEWEST: usize = 6;
/// Its shortest span, s: a load cell does not move by more than noise in less than a minute.
const SHORTEST: f64 = 60.0;

/// How much faster the fastest test must turn than the slowest for a delay to be told from compliance: the phase of both grows with
/// frequency, but along other curves. At one frequency they are the same; half as much again is a choice. A mass and a spring are told apart
/// in the same way.
const APART: f64 = 1.5;

/// Whether the frequencies of the tests tell a delay from a soft series path.
pub fn tells_delay(segments: &[Segment]) -> bool {
    let turns = |s: &Segment| s.peak_velocity / s.amplitude;
    let (low, high) = segments
        .iter()
        .filter(|s| s.amplitude > 0.0)
        .map(turns)
        .fold((f64::INFINITY, 0.0f64), |(l, h), w| (l.min(w), h.max(w)));
    high > APART * low
}

/// One number of the measurement that the records are off by.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Measured {
    /// What it is: `delay`, `rig_mass`, `gain_drift` or `drift` (of the force's zero).
    pub name: &'static str,
    /// Value.
    pub value: f64,
    /// Lower end of the 95 % interval.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Unit.
    pub unit: &'static str,
    /// How to tell the reader of records, where it has an option for it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub option: Option<&'static str>,
}

impl Measured {
    /// One number, as a fit found it.
    fn new(artefact: Artefact, [value, low, high]: [f64; 3]) -> Measured {
        let option = match artefact {
            Artefact::Delay => Some("--delay"),
            Artefact::Mass => Some("--rig-mass"),
            _ => None,
        };
        Measured { name: artefact.parameter(), value, low, high, unit: artefact.unit(), option }
    }

    /// The same from a model file; `None` for a name that no fit looks for, and for what is no number.
    pub fn named(name: &str, numbers: [f64; 3]) -> Option<Measured> {
        let artefact = LOOKED_FOR.into_iter().find(|artefact| artefact.parameter() == name)?;
        numbers.iter().all(|n| n.is_finite()).then(|| Measured::new(artefact, numbers))
    }

    /// One number, as a diagnosis found it; `None` for what the reader of records cannot take out.
    pub fn of(artefact: Artefact, numbers: [f64; 3]) -> Option<Measured> {
        let may = LOOKED_FOR.contains(&artefact) && numbers.iter().all(|n| n.is_finite());
        may.then(|| Measured::new(artefact, numbers))
    }

    /// What was found in records out of which the user had some taken before: of both together.
    pub fn beside(self, given: &Off) -> Measured {
        let before = match self.name {
            "delay" => given.delay_s,
            "rig_mass" => given.mass_kg,
            _ => 0.0,
        };
        Measured { value: self.value + before, low: self.low + before, high: self.high + before, ..self }
    }

    /// What was taken out with what was found in the rest: of both together.
    ///
    /// The intervals are of separate records of the same thing, so that their squares add.
    pub fn and(self, rest: Measured) -> Measured {
        let value = self.value + rest.value;
        let half = |m: &Measured| 0.5 * (m.high - m.low);
        let half = libm::hypot(half(&self), half(&rest));
        Measured { value, low: value - half, high: value + half, ..self }
    }

    /// Name in the vocabulary of the diagnosis.
    pub fn effect(&self) -> Option<&'static str> {
        LOOKED_FOR.into_iter().find(|artefact| artefact.parameter() == self.name).map(Artefact::name)
    }

    /// Whether the interval is off zero.
    pub fn is_there(&self) -> bool {
        self.low > 0.0 || self.high < 0.0
    }

    /// How to say it to the reader of other records.
    pub fn as_option(&self) -> Option<String> {
        self.option.map(|option| format!("{option}={:.6}", self.value))
    }

    /// What was found, in words.
    pub fn finding(&self) -> Sentence {
        let (factor, what) = match self.name {
            "delay" if self.value < 0.0 => {
                // Said as a lead: who reads of a negative delay takes it for a mistake.
                let of = |value: f64| format!("{:.3}", -1e3 * value);
                return Sentence::from(phrases::FOUND_EARLY)
                    .with("value", of(self.value))
                    .with("low", of(self.high))
                    .with("high", of(self.low));
            }
            "delay" => (1e3, phrases::FOUND_DELAY),
            "rig_mass" => (1.0, phrases::FOUND_MASS),
            "gain_drift" => (100.0 * 60.0, phrases::FOUND_GAIN_DRIFT),
            _ => (60.0, phrases::FOUND_DRIFT),
        };
        let of = |value: f64| format!("{:.3}", factor * value);
        Sentence::from(what).with("value", of(self.value)).with("low", of(self.low)).with("high", of(self.high))
    }

    /// The same in a sentence that says what became of it.
    pub fn in_words(&self) -> Sentence {
        let option = self.as_option().map(|option| Sentence::from(phrases::GIVE_OPTION).with("option", option));
        Sentence::from(phrases::TAKEN_OUT_HERE).with_said("finding", self.finding()).with_any("option", option)
    }
}

/// What a fit found of the measurement, as records lose it.
pub fn off(measured: &[Measured]) -> Off {
    let of = |name: &str| measured.iter().find(|m| m.name == name).map_or(0.0, |m| m.value);
    Off { delay_s: of("delay"), mass_kg: of("rig_mass"), gain_per_s: of("gain_drift"), zero_n_per_s: of("drift") }
}

/// What a fit found of the measurement.
pub fn measured(segments: &[Segment], unknowns: &Unknowns, theta: &[f64], accuracy: Accuracy) -> Vec<Measured> {
    if unknowns.rig.is_empty() {
        return Vec::new();
    }
    let refs: Vec<&Segment> = segments.iter().collect();
    let Some((covariance, _)) = covariance(&refs, unknowns, theta, accuracy) else { return Vec::new() };
    let numbers = unknowns.rig.iter().enumerate();
    numbers
        .map(|(k, number)| {
            let place = unknowns.list.len() + k;
            let (value, half) = (theta[place], Z * covariance[(place, place)].max(0.0).sqrt());
            Measured::new(number.artefact, [value, value - half, value + half])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_channel_that_leads_is_told_as_early() {
        let said = |numbers| Measured::new(Artefact::Delay, numbers).finding().to_string();
        assert_eq!(said([3e-3, 2.9e-3, 3.1e-3]), "the force channel comes late by 3.000 ms (95 %: 2.900 to 3.100)");
        assert_eq!(
            said([-0.635e-3, -0.7e-3, -0.5e-3]),
            "the force channel comes early by 0.635 ms (95 %: 0.500 to 0.700)"
        );
    }
}
