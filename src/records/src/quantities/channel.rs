//! The channels of a rig record.

use std::fmt;

use serde::Serialize;

use super::unit::{Dimension, Unit};
use crate::messages::phrases;
use dashpot_messages::{Sentence, Template};

/// A quantity in a rig record.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// Time.
    Time,
    /// Displacement of the damper.
    Displacement,
    /// Velocity of the damper.
    Velocity,
    /// Axial damper force.
    Force,
    /// Side force on the rod.
    SideForce,
    /// Damper temperature.
    Temperature,
    /// Current of an adjustable damper's valve.
    Current,
    /// Setting of an adjustable damper other than the current: voltage, pressure, clicks. Only clicks are recognized by
    /// their heading. The user must name other setting columns.
    Setting,
}

impl Channel {
    /// All channels.
    pub const ALL: [Channel; 8] = [
        Channel::Time,
        Channel::Displacement,
        Channel::Velocity,
        Channel::Force,
        Channel::SideForce,
        Channel::Temperature,
        Channel::Current,
        Channel::Setting,
    ];

    /// Returns the channel's name on the command line and in messages.
    pub fn name(self) -> &'static str {
        match self {
            Channel::Time => "time",
            Channel::Displacement => "displacement",
            Channel::Velocity => "velocity",
            Channel::Force => "force",
            Channel::SideForce => "side_force",
            Channel::Temperature => "temperature",
            Channel::Current => "current",
            Channel::Setting => "setting",
        }
    }

    /// Returns the channel's name as a translatable message.
    pub(crate) fn message(self) -> Template {
        match self {
            Channel::Time => phrases::CHANNEL_TIME,
            Channel::Displacement => phrases::CHANNEL_DISPLACEMENT,
            Channel::Velocity => phrases::CHANNEL_VELOCITY,
            Channel::Force => phrases::CHANNEL_FORCE,
            Channel::SideForce => phrases::CHANNEL_SIDE_FORCE,
            Channel::Temperature => phrases::CHANNEL_TEMPERATURE,
            Channel::Current => phrases::CHANNEL_CURRENT,
            Channel::Setting => phrases::CHANNEL_SETTING,
        }
    }

    /// Returns the advice to ignore the channel, for messages, or `None` if a record requires the channel.
    pub(crate) fn leave_out_advice(self) -> Option<Sentence> {
        match self {
            Channel::Time | Channel::Force => None,
            // The value of the option is the untranslated name.
            _ => Some(Sentence::from(phrases::OR_IGNORE).with("channel", self)),
        }
    }

    /// Returns the SI unit in which the channel is stored.
    pub(crate) fn si(self) -> &'static str {
        match self {
            Channel::Time => "s",
            Channel::Displacement => "m",
            Channel::Velocity => "m/s",
            Channel::Force | Channel::SideForce => "N",
            Channel::Temperature => "°C",
            Channel::Current => "A",
            // A setting is stored in the unit of its column.
            Channel::Setting => "",
        }
    }

    /// Returns the quantity that the channel measures.
    pub fn dimension(self) -> Dimension {
        match self {
            Channel::Time => Dimension::Time,
            Channel::Displacement => Dimension::Length,
            Channel::Velocity => Dimension::Speed,
            Channel::Force | Channel::SideForce => Dimension::Force,
            Channel::Temperature => Dimension::Temperature,
            Channel::Current => Dimension::Current,
            Channel::Setting => Dimension::Setting,
        }
    }

    /// Returns a common unit of the channel, for examples.
    pub(crate) fn example(self) -> Unit {
        match self {
            Channel::Time => Unit::Second,
            Channel::Displacement => Unit::Millimetre,
            Channel::Velocity => Unit::MetrePerSecond,
            Channel::Force | Channel::SideForce => Unit::Newton,
            Channel::Temperature => Unit::Celsius,
            Channel::Current => Unit::Ampere,
            Channel::Setting => Unit::AsWritten,
        }
    }

    /// Returns the supported units of this channel, for messages.
    pub fn units_understood(self) -> String {
        Unit::ALL.iter().filter(|u| u.dimension() == self.dimension()).map(|u| u.name()).collect::<Vec<_>>().join(", ")
    }
}

impl fmt::Display for Channel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Splits a command-line assignment such as `force=kN` or `force=Load Cell 1`.
///
/// # Errors
/// A sentence if there is no `=`, the left side is not a channel, or the right side is empty.
pub fn assignment(text: &str) -> Result<(Channel, &str), String> {
    let (channel, value) =
        text.split_once('=').ok_or_else(|| format!("'{text}' should read channel=value, for example force=kN"))?;
    let value = value.trim().trim_matches('"');
    if value.is_empty() {
        return Err(format!("'{text}' says nothing after the '='"));
    }
    Ok((channel.trim().parse()?, value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn assignments_from_the_command_line() {
        assert_eq!(assignment("force=kN"), Ok((Channel::Force, "kN")));
        assert_eq!(assignment("side_force=\"Load Cell 2\""), Ok((Channel::SideForce, "Load Cell 2")));
        assert!(assignment("force").is_err());
        assert!(assignment("pressure=bar").unwrap_err().contains("displacement"));
    }
}
