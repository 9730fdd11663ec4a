//! The samples of one test as read from the file: in SI, but with the signs and faults of the file.

use std::ops::Range;

use super::record::Note;
use super::test_metadata::TestMetadata;
use crate::dates::file_dates::Dates;
use crate::error::Place;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use dashpot_messages::Sentence;

/// One test before cleaning. All channels have the length of `time`; missing values are NaN.
#[derive(Debug, Clone)]
pub(crate) struct Samples {
    /// File, and sheet or test within it.
    pub at: Place,
    /// Name of the test.
    pub name: String,
    /// Line (row, element) of every sample in its file, from 1.
    pub lines: Vec<usize>,
    pub time: Vec<f64>,
    /// Date and time of the test's time zero, s since 1970 by the rig's own clock, if the file states it. A value below
    /// one day is a time of an unknown day.
    pub begins: Option<f64>,
    /// Evidence for the order of day and month in the start date.
    pub dates: Dates,
    /// Metadata of the test that the file states.
    pub about: TestMetadata,
    pub force: Vec<f64>,
    pub displacement: Option<Vec<f64>>,
    pub velocity: Option<Vec<f64>>,
    pub side_force: Option<Vec<f64>>,
    pub temperature: Option<Vec<f64>>,
    /// Current of an adjustable damper's valve, A.
    pub current: Option<Vec<f64>>,
    /// A setting of the damper other than the current, in the unit of its column.
    pub setting: Option<Vec<f64>>,
    /// Headings of the available channels, as the file writes them.
    pub headings: Vec<(Channel, String)>,
    /// The units in which the channels were read.
    pub units: Vec<(Channel, Unit)>,
    pub notes: Vec<Note>,
}

impl Samples {
    pub fn len(&self) -> usize {
        self.time.len()
    }

    /// Adds the date and time of the first sample, if the time column does not state them.
    pub fn beginning(mut self, first: Option<f64>, dates: Dates) -> Samples {
        if self.begins.is_none() {
            let zero = self.time.iter().find(|t| t.is_finite());
            self.begins = first.zip(zero).map(|(first, zero)| first - zero);
            self.dates = dates;
        }
        self
    }

    pub fn note(&mut self, kind: &'static str, text: Sentence) {
        self.notes.push(Note { kind, text });
    }

    /// Returns the heading of a channel in the file, or the name of the channel if the file has no heading for it.
    pub fn heading(&self, channel: Channel) -> String {
        let found = self.headings.iter().find(|(c, _)| *c == channel);
        found.map_or_else(|| channel.to_string(), |(_, heading)| heading.clone())
    }

    /// Returns a channel's values, if the record has the channel.
    pub fn channel(&self, channel: Channel) -> Option<&[f64]> {
        match channel {
            Channel::Time => Some(&self.time),
            Channel::Force => Some(&self.force),
            Channel::Displacement => self.displacement.as_deref(),
            Channel::Velocity => self.velocity.as_deref(),
            Channel::SideForce => self.side_force.as_deref(),
            Channel::Temperature => self.temperature.as_deref(),
            Channel::Current => self.current.as_deref(),
            Channel::Setting => self.setting.as_deref(),
        }
    }

    /// Returns the values of a channel, mutable.
    pub fn channel_mut(&mut self, channel: Channel) -> Option<&mut Vec<f64>> {
        match channel {
            Channel::Time => Some(&mut self.time),
            Channel::Force => Some(&mut self.force),
            Channel::Displacement => self.displacement.as_mut(),
            Channel::Velocity => self.velocity.as_mut(),
            Channel::SideForce => self.side_force.as_mut(),
            Channel::Temperature => self.temperature.as_mut(),
            Channel::Current => self.current.as_mut(),
            Channel::Setting => self.setting.as_mut(),
        }
    }

    /// Keeps the samples with the listed indices, in the order of the list, in every channel.
    pub fn select(&mut self, indices: &[usize]) {
        self.lines = indices.iter().map(|&i| self.lines[i]).collect();
        for channel in Channel::ALL {
            if let Some(values) = self.channel_mut(channel) {
                *values = indices.iter().map(|&i| values[i]).collect();
            }
        }
    }

    /// Returns the samples of a range as a separate test, with all metadata of this test.
    pub fn piece(&self, span: Range<usize>) -> Samples {
        let cut = |values: &[f64]| values[span.clone()].to_vec();
        Samples {
            at: self.at.clone(),
            name: self.name.clone(),
            lines: self.lines[span.clone()].to_vec(),
            time: cut(&self.time),
            begins: self.begins,
            dates: self.dates.clone(),
            about: self.about.clone(),
            force: cut(&self.force),
            displacement: self.displacement.as_deref().map(cut),
            velocity: self.velocity.as_deref().map(cut),
            side_force: self.side_force.as_deref().map(cut),
            temperature: self.temperature.as_deref().map(cut),
            current: self.current.as_deref().map(cut),
            setting: self.setting.as_deref().map(cut),
            headings: self.headings.clone(),
            units: self.units.clone(),
            notes: self.notes.clone(),
        }
    }

    /// Keeps the samples for which `keep` is true.
    pub fn retain(&mut self, keep: impl Fn(usize) -> bool) {
        let indices: Vec<usize> = (0..self.len()).filter(|&i| keep(i)).collect();
        if indices.len() < self.len() {
            self.select(&indices);
        }
    }
}
