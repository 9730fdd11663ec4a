//! Errors of a motion that is imposed on a model.

use std::path::PathBuf;

use super::{Place, locate, locate_file, locate_line};
use crate::messages::phrases;
use crate::quantities::channel::Channel;
use dashpot_messages::{Sentence, format_number};

/// Reason for which a file cannot be imposed on a model as a motion.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
#[allow(missing_docs)] // the messages are the meaning of variants and fields
pub enum ImposedMotionError {
    Gap { at: Place, line: usize, channel: Channel },

    Beyond { at: Place, line: usize, channel: Channel, value: f64, limit: f64 },

    TimeBackwards { at: Place, line: usize, from: f64, to: f64 },

    TooShort { at: Place },

    Several { file: PathBuf, first: String, second: String },
}

impl ImposedMotionError {
    /// Returns the cause and the remedy as a translatable sentence.
    pub fn sentence(&self) -> Sentence {
        match self {
            ImposedMotionError::Gap { at, line, channel } => {
                locate_line(phrases::MOTION_GAP, at, line).with_sentence("channel", channel.message())
            }
            ImposedMotionError::Beyond { at, line, channel, value, limit } => {
                let with_unit =
                    |number: f64| format!("{} {}", format_number(number), channel.si()).trim_end().to_owned();
                locate_line(phrases::MOTION_BEYOND, at, line)
                    .with_sentence("channel", channel.message())
                    .with("value", with_unit(*value))
                    .with("limit", with_unit(*limit))
            }
            ImposedMotionError::TimeBackwards { at, line, from, to } => locate_line(phrases::MOTION_TIME, at, line)
                .with("to", format_number(*to))
                .with("from", format_number(*from)),
            ImposedMotionError::TooShort { at } => locate(phrases::SHORT_MOTION, at),
            ImposedMotionError::Several { file, first, second } => {
                locate_file(phrases::SEVERAL_MOTIONS, file).with("first", first).with("second", second)
            }
        }
    }
}
