//! Errors of records whose values contradict the physics of a damper, or each other.

use super::{Place, locate, name_several};
use crate::messages::phrases;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use dashpot_messages::{Sentence, Template, format_decimals};

/// Files of a campaign whose unit likely differs from that of the other files.
#[derive(Debug, Clone)]
pub struct FilesUnit {
    /// Whether the tests state a setting, so that a wrong label is possible too.
    pub has_setting: bool,
    /// The tests whose unit likely differs.
    pub tests: Vec<String>,
    /// The tests that agree with each other.
    pub others: Vec<String>,
    /// Number of all tests of the campaign.
    pub all: usize,
    /// Name of the test with the values that the message states.
    pub shown: String,
    /// A velocity of the test `shown`, m/s, and the damping force of the test at this velocity, N.
    pub at: (f64, f64),
    /// The closest velocity of the other tests, m/s, and their damping force at that velocity, N.
    pub expected: (f64, f64),
    /// Channel whose unit likely differs.
    pub channel: Channel,
    /// The unit in which the channel was read.
    pub written: Unit,
    /// The likely units. The list contains several units if they explain the forces nearly equally well, such as kgf
    /// and daN.
    pub likely: Vec<Unit>,
}

impl FilesUnit {
    fn sentence(&self) -> Sentence {
        // If the other tests are not clearly in the majority, the wrong unit may be that of the other tests.
        let either = (2 * self.others.len() < 3 * self.tests.len())
            .then(|| Sentence::from(phrases::OR_THE_OTHERS).with_sentence("others", name_several(&self.others)));
        let figure = |value: f64| match value {
            v if v < 0.1 => format!("{v:.2e}"),
            v if v < 10.0 => format_decimals(v, 3),
            v => format_decimals(v, 0),
        };
        let first = self.likely.first().map_or("", |unit| unit.name());
        Sentence::from(phrases::FILES_UNIT)
            .with("count", self.tests.len())
            .with("all", self.all)
            .with_sentence("tests", name_several(&self.tests))
            .with("test", &self.shown)
            .with("force", figure(self.at.1))
            .with("velocity", figure(1e3 * self.at.0))
            .with("usual", figure(self.expected.1))
            .with("there", figure(1e3 * self.expected.0))
            .with_names("likely", &self.likely, phrases::OR)
            .with("written", self.written)
            .with("channel", self.channel)
            .with("first", first)
            .with_any("either", either)
            .with_any("labels", self.has_setting.then(|| Sentence::from(phrases::OR_LABELS)))
    }
}

/// Reason for which readable records are implausible.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
#[allow(missing_docs)] // the messages are the meaning of variants and fields
pub enum PlausibilityError {
    Swapped { at: Place, first: String, second: String, of_first: Channel, of_second: Channel, evidence: Sentence },

    UnitSlip { channel: Channel, written: Unit, likely: Unit, evidence: Sentence },

    FilesUnit(Box<FilesUnit>),

    MixedCurrent { record: String, test: String, current: f64, others: f64 },

    Absurd { record: String, what: Sentence, advice: Template },

    NoForce { count: usize, all: usize, record: String, noise: f64 },

    FeedsEnergy { cause: Sentence, tests: Vec<String> },

    Exchanged { cause: Sentence, tests: Vec<String> },
}

impl PlausibilityError {
    /// Returns the cause and the remedy as a translatable sentence.
    pub fn sentence(&self) -> Sentence {
        match self {
            PlausibilityError::Swapped { at, first, second, of_first, of_second, evidence } => {
                locate(phrases::SWAPPED, at)
                    .with("first", first)
                    .with("second", second)
                    .with("of_first", of_first)
                    .with("of_second", of_second)
                    .with_sentence("evidence", evidence.clone())
            }
            PlausibilityError::UnitSlip { channel, written, likely, evidence } => Sentence::from(phrases::WRONG_UNIT)
                .with_sentence("evidence", evidence.clone())
                .with("likely", likely)
                .with("written", written)
                .with("channel", channel),
            PlausibilityError::FilesUnit(slip) => slip.sentence(),
            PlausibilityError::MixedCurrent { record, test, current, others } => Sentence::from(phrases::MIXED_CURRENT)
                .with("record", record)
                .with("test", test)
                .with("current", format_decimals(*current, 0))
                .with("others", format_decimals(*others, 2)),
            PlausibilityError::Absurd { record, what, advice } => Sentence::from(phrases::ABSURD)
                .with("record", record)
                .with_sentence("what", what.clone())
                .with_sentence("advice", *advice),
            PlausibilityError::NoForce { count, all, record, noise } => Sentence::from(phrases::ALL_WITHOUT_FORCE)
                .with("count", count)
                .with("all", all)
                .with("record", record)
                .with("noise", format_decimals(*noise, 3)),
            PlausibilityError::FeedsEnergy { cause, .. } => {
                Sentence::from(phrases::FEEDS_ENERGY).with_sentence("cause", cause.clone())
            }
            PlausibilityError::Exchanged { cause, .. } => cause.clone(),
        }
    }
}
