//! Errors of the cells and signals of a record.

use super::{Place, locate, locate_line};
use crate::messages::phrases;
use crate::quantities::channel::Channel;
use dashpot_messages::{Sentence, Template, format_decimals, format_number};

/// Reason for which the rows of a record are no usable signals.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
#[allow(missing_docs)] // the messages are the meaning of variants and fields
pub enum SampleError {
    Cell {
        at: Place,
        line: usize,
        column: String,
        text: String,
        hint: Option<Template>,
    },

    Fields {
        at: Place,
        line: usize,
        found: usize,
        expected: usize,
        hint: Option<Template>,
    },

    Missing {
        at: Place,
        line: usize,
        channel: Channel,
        count: usize,
        rows: usize,
    },

    NoData {
        at: Place,
    },

    TooFew {
        at: Place,
        samples: usize,
        needed: usize,
    },

    ConstantTime {
        at: Place,
        time: f64,
    },

    TimeBackwards {
        at: Place,
        line: usize,
        from: f64,
        to: f64,
    },

    Frozen {
        at: Place,
        channel: Channel,
        first: usize,
        last: usize,
        value: f64,
        seconds: f64,
        moving: Template,
        advice: Template,
    },

    Clipped {
        at: Place,
        line: usize,
        channel: Channel,
        value: f64,
        percent: f64,
        advice: Template,
    },

    NoMotion {
        at: Place,
        channel: Channel,
        range: f64,
        unit: &'static str,
    },

    ConstantForce {
        at: Place,
        value: f64,
    },

    Contradiction {
        at: Place,
        cause: Sentence,
    },
}

impl SampleError {
    /// Returns the cause and the remedy as a translatable sentence.
    pub fn sentence(&self) -> Sentence {
        match self {
            SampleError::Cell { at, line, column, text, hint } => {
                let cell = locate_line(phrases::CELL, at, line).with("column", column).with("text", text);
                cell.with_any("hint", hint.map(Sentence::from))
            }
            SampleError::Fields { at, line, found, expected, hint } => {
                let fields = locate_line(phrases::FIELDS, at, line).with("found", found).with("expected", expected);
                fields.with_any("hint", hint.map(Sentence::from))
            }
            SampleError::Missing { at, line, channel, count, rows } => locate_line(phrases::MISSING, at, line)
                .with_sentence("channel", channel.message())
                .with("count", count)
                .with("rows", rows)
                .with_any("advice", channel.leave_out_advice()),
            SampleError::NoData { at } => locate(phrases::NO_DATA, at),
            SampleError::TooFew { at, samples, needed } => {
                locate(phrases::TOO_FEW, at).with("samples", samples).with("needed", needed)
            }
            SampleError::ConstantTime { at, time } => {
                locate(phrases::CONSTANT_TIME, at).with("time", format_number(*time))
            }
            SampleError::TimeBackwards { at, line, from, to } => locate_line(phrases::TIME_BACKWARDS, at, line)
                .with("from", format_number(*from))
                .with("to", format_number(*to)),
            SampleError::Frozen { at, channel, first, last, value, seconds, moving, advice } => {
                locate(phrases::FROZEN, at)
                    .with("first", first)
                    .with("last", last)
                    .with_sentence("channel", channel.message())
                    .with("value", format_decimals(*value, 6))
                    .with("unit", channel.si())
                    .with("seconds", format_decimals(*seconds, 3))
                    .with_sentence("moving", *moving)
                    .with_sentence("advice", *advice)
            }
            SampleError::Clipped { at, line, channel, value, percent, advice } => {
                locate_line(phrases::CLIPPED, at, line)
                    .with_sentence("channel", channel.message())
                    .with("value", format_decimals(*value, 5))
                    .with("unit", channel.si())
                    .with("percent", format_decimals(*percent, 1))
                    .with_sentence("advice", *advice)
            }
            SampleError::NoMotion { at, channel, range, unit } => locate(phrases::NO_MOTION, at)
                .with_sentence("channel", channel.message())
                .with("range", format_decimals(*range, 4))
                .with("unit", unit),
            SampleError::ConstantForce { at, value } => {
                locate(phrases::CONSTANT_FORCE, at).with("value", format_decimals(*value, 6))
            }
            SampleError::Contradiction { at, cause } => {
                locate(phrases::CONTRADICTION, at).with_sentence("cause", cause.clone())
            }
        }
    }
}
