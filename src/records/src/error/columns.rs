//! Errors of the headings and units of a table.

use super::{Place, locate, locate_line};
use crate::messages::phrases;
use crate::quantities::channel::Channel;
use dashpot_messages::Sentence;

/// Formats the options that state the units of channels, each with an example.
fn unit_options(channels: impl Iterator<Item = Channel>) -> String {
    channels.map(|channel| format!("--unit {channel}={}", channel.example())).collect::<Vec<_>>().join(" ")
}

/// Reason for which the columns of a table cannot be assigned to channels and units.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
#[allow(missing_docs)] // the messages are the meaning of variants and fields
pub enum ColumnError {
    TooManyColumns {
        at: Place,
        line: usize,
        found: usize,
        most: usize,
    },

    Header {
        at: Place,
        found: String,
        near: Option<Sentence>,
        understood: String,
    },

    MissingColumn {
        at: Place,
        line: usize,
        missing: &'static str,
        example: Channel,
        found: String,
        near: Option<Sentence>,
        /// Heading of a column of crank angles, if the table has one.
        angle: Option<String>,
        units: Vec<Channel>,
    },

    SeveralColumns {
        at: Place,
        line: usize,
        channel: Channel,
        headings: Vec<String>,
    },

    NoSuchColumn {
        at: Place,
        line: usize,
        channel: Channel,
        wanted: String,
        found: String,
        near: Option<Sentence>,
    },

    NoSettingColumn {
        wanted: String,
    },

    MissingUnit {
        at: Place,
        line: usize,
        columns: Vec<(Channel, String)>,
        headed: bool,
    },

    UnknownUnit {
        at: Place,
        line: usize,
        column: String,
        unit: String,
        channel: Channel,
    },
}

impl ColumnError {
    /// Returns the cause and the remedy as a translatable sentence.
    pub fn sentence(&self) -> Sentence {
        match self {
            ColumnError::TooManyColumns { at, line, found, most } => {
                locate_line(phrases::TOO_MANY_COLUMNS, at, line).with("found", found).with("most", most)
            }
            ColumnError::Header { understood, .. } => {
                Sentence::from(phrases::UNDERSTOOD).with_sentence("header", self.fault()).with("understood", understood)
            }
            ColumnError::MissingColumn { at, line, missing, example, found, near, angle, units } => {
                let units = (!units.is_empty())
                    .then(|| Sentence::from(phrases::UNITS_TOO).with("options", unit_options(units.iter().copied())));
                // One sampling rate would give the tests of a crank the same time at each speed.
                let otherwise = (*example == Channel::Time).then(|| match angle {
                    Some(column) => Sentence::from(phrases::OR_CRANK_SPEED).with("column", column),
                    None => phrases::OR_SAMPLE_RATE.into(),
                });
                locate_line(phrases::MISSING_COLUMN, at, line)
                    .with_word("missing", missing)
                    .with("found", found)
                    .with_any("near", near.clone())
                    .with("example", example)
                    .with_any("otherwise", otherwise)
                    .with_any("units", units)
            }
            ColumnError::SeveralColumns { at, line, channel, headings } => {
                let quoted = |h: &String| Sentence::from(phrases::QUOTED).with("test", h);
                locate_line(phrases::SEVERAL_COLUMNS, at, line)
                    .with_list("names", headings.iter().map(quoted).collect(), phrases::COMMA)
                    .with("first", headings.first().map_or("", String::as_str))
                    .with("channel", channel)
            }
            ColumnError::NoSuchColumn { at, line, channel, wanted, found, near } => {
                locate_line(phrases::NO_SUCH_COLUMN, at, line)
                    .with("wanted", wanted)
                    .with_sentence("channel", channel.message())
                    .with("found", found)
                    .with_any("near", near.clone())
            }
            ColumnError::NoSettingColumn { wanted } => {
                Sentence::from(phrases::NO_SETTING_COLUMN).with("wanted", wanted)
            }
            ColumnError::MissingUnit { at, line, columns, headed } => match &columns[..] {
                [(channel, column)] if *headed => locate_line(phrases::MISSING_UNIT, at, line)
                    .with("column", column)
                    .with("example", channel.example())
                    .with("channel", channel)
                    .with("understood", channel.units_understood()),
                several => {
                    let quoted = |(_, column): &(Channel, String)| Sentence::from(phrases::QUOTED).with("test", column);
                    let in_heading = headed.then(|| phrases::OR_IN_HEADING.into());
                    let of = |(channel, _): &(Channel, String)| format!("{channel} {}", channel.units_understood());
                    locate_line(phrases::MISSING_UNITS, at, line)
                        .with_list("columns", several.iter().map(quoted).collect(), phrases::COMMA)
                        .with("options", unit_options(several.iter().map(|(channel, _)| *channel)))
                        .with_any("in_heading", in_heading)
                        .with("understood", several.iter().map(of).collect::<Vec<_>>().join("; "))
                }
            },
            ColumnError::UnknownUnit { at, line, column, unit, channel } => {
                locate_line(phrases::UNKNOWN_UNIT, at, line)
                    .with("column", column)
                    .with("unit", unit)
                    .with("channel", channel)
                    .with("understood", channel.units_understood())
            }
        }
    }

    /// Returns the sentence for a table that the campaign leaves out, without the list of supported headings.
    pub(super) fn fault(&self) -> Sentence {
        match self {
            ColumnError::Header { at, found, near, .. } => {
                locate(phrases::NO_HEADER, at).with("found", found).with_any("near", near.clone())
            }
            _ => self.sentence(),
        }
    }
}
