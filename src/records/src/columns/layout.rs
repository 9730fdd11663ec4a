//! Assigns the columns of a table to channels and units, by their headings, the row of units and the user's options.

use super::crank;
use super::heading::{
    Heading, HeadingUnit, by_unit, heading, is_plain, is_setpoint, is_stopgap, nearest, nearest_to, unit_of_command,
    unit_of_current, without_unit, written_unit,
};
use crate::error::{ColumnError, Place, RecordError};
use crate::messages::phrases;
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use dashpot_messages::Sentence;

/// Largest number of columns of a table. A rig records tens of columns. The limit bounds the comparisons of headings
/// with channels.
pub(crate) const MOST_COLUMNS: usize = 4096;

/// Largest number of columns that a message lists.
pub(super) const LISTED: usize = 40;

/// Assignment of columns to channels.
#[derive(Debug, Clone)]
pub(crate) struct Layout {
    pub columns: Vec<Column>,
    pub test: Option<usize>,
    pub(super) ignored: Vec<String>,
    /// Columns assigned to a channel by their unit alone.
    pub(super) guessed: Vec<(Channel, String)>,
    /// Columns that may contain the setting, if none is recognized: heading, unit and channel.
    ///
    /// The note on such a column advises to assign it to the channel.
    pub(super) unread_settings: Vec<(String, String, Channel)>,
    /// Time between samples that the user gives for files without a time column, s.
    pub(super) step: Option<f64>,
}

/// One column that is read.
#[derive(Debug, Clone)]
pub(crate) struct Column {
    pub channel: Channel,
    pub index: usize,
    pub unit: Unit,
    pub heading: String,
    /// Whether the column contains times of day.
    pub clock: bool,
}

/// Returns names for the columns of a table without a header.
pub(crate) fn numbered(columns: usize) -> Vec<String> {
    (1..=columns).map(|n| format!("column {n}")).collect()
}

fn same(wanted: &str, text: &str) -> bool {
    wanted.trim().eq_ignore_ascii_case(text.trim())
}

/// Returns whether a name given by the user matches this heading, exactly or without its unit.
pub(super) fn names(wanted: &str, text: &str) -> bool {
    same(wanted, text) || {
        let (wanted, text) = (without_unit(wanted), without_unit(text));
        !wanted.is_empty() && wanted == text
    }
}

/// Returns the channel of a heading, as named by the user or as recognized.
pub(crate) fn channel_of(text: &str, options: &Options) -> Option<Channel> {
    let named = options.columns.iter().find(|(_, wanted)| names(wanted, text)).map(|(channel, _)| *channel);
    named.or_else(|| match heading(text.trim()) {
        Heading::Channel(channel, _) => Some(channel),
        _ => None,
    })
}

/// Returns the column number if the user states a number instead of a heading. Columns count from 1.
pub(crate) fn column_number(wanted: &str) -> Option<usize> {
    wanted.trim().parse::<usize>().ok().filter(|n| *n > 0)
}

/// Returns the columns that match the user's name: the whole heading, else the heading without its unit, else the
/// number. Of several equal headings, the first counts. Several returned columns mean that the name is ambiguous.
fn wanted_column(wanted: &str, header: &[&str]) -> Vec<usize> {
    let at = |found: &dyn Fn(&str) -> bool| -> Vec<usize> { (0..header.len()).filter(|i| found(header[*i])).collect() };
    let exact = at(&|h| same(wanted, h));
    if let Some(first) = exact.first() {
        return vec![*first];
    }
    let by_name = at(&|h| names(wanted, h));
    if !by_name.is_empty() {
        return by_name;
    }
    column_number(wanted).filter(|n| *n <= header.len()).map(|n| n - 1).into_iter().collect()
}

fn maybe(near: Option<&str>) -> Option<Sentence> {
    near.map(|near| Sentence::from(phrases::MEANT).with("near", near))
}

/// Header of a table, with the data for the assignment of its columns to channels.
struct Header<'a> {
    at: &'a Place,
    /// Line of the header in the file, for messages.
    line: usize,
    texts: Vec<&'a str>,
    headings: Vec<Heading>,
    /// Cells of the row of units. A column beyond its end has no unit.
    units: Vec<&'a str>,
    options: &'a Options,
}

/// Column that a heading or a unit assigns to a channel.
struct Recognized {
    index: usize,
    /// Whether only the unit indicates the channel.
    is_guess: bool,
}

impl<'a> Header<'a> {
    fn new<S: AsRef<str>>(
        at: &'a Place,
        line: usize,
        header: &'a [S],
        units: Option<&'a [S]>,
        options: &'a Options,
    ) -> Result<Header<'a>, RecordError> {
        if header.len() > MOST_COLUMNS {
            let (at, found) = (at.clone(), header.len());
            return Err(ColumnError::TooManyColumns { at, line, found, most: MOST_COLUMNS }.into());
        }
        let texts: Vec<&str> = header.iter().map(|cell| cell.as_ref().trim().trim_start_matches('\u{feff}')).collect();
        let headings = texts.iter().map(|text| heading(text)).collect();
        let units = units.unwrap_or_default().iter().map(AsRef::as_ref).collect();
        Ok(Header { at, line, texts, headings, units, options })
    }

    /// Returns the unit in the row of units, without brackets.
    fn unit_below(&self, index: usize) -> Option<&'a str> {
        self.units.get(index).map(|unit| unit.trim().trim_matches(|c| "[]()".contains(c)))
    }

    /// Returns whether the file contains headings. Otherwise, `texts` contains the names from [`numbered`].
    fn is_headed(&self) -> bool {
        self.texts.iter().zip(numbered(self.texts.len())).any(|(own, number)| *own != number)
    }

    /// Lists the headings, for messages.
    fn list(&self) -> String {
        let listed = self.texts.iter().take(LISTED).map(|h| format!("'{h}'")).collect::<Vec<_>>().join(", ");
        let more = self.texts.len().saturating_sub(LISTED);
        if more > 0 { format!("{listed} and {more} more") } else { listed }
    }

    /// Returns the column that the user names for a channel.
    fn find_wanted(&self, channel: Channel, wanted: &str) -> Result<Option<usize>, RecordError> {
        match wanted_column(wanted, &self.texts)[..] {
            [index] => Ok(Some(index)),
            // If the name of a test states a constant setting, the table has no setting column. The missing column is
            // therefore no error here.
            [] if channel == Channel::Setting => Ok(None),
            [] => Err(ColumnError::NoSuchColumn {
                at: self.at.clone(),
                line: self.line,
                channel,
                wanted: wanted.to_owned(),
                found: self.list(),
                near: maybe(nearest(wanted, self.texts.iter().copied())),
            }
            .into()),
            ref several => Err(self.ask_for_one_of(channel, several)),
        }
    }

    /// Returns whether the user names a column for another channel.
    fn is_taken(&self, index: usize, channel: Channel) -> bool {
        let mut others = self.options.columns.iter().filter(|(other, _)| **other != channel);
        others.any(|(_, wanted)| wanted_column(wanted, &self.texts).contains(&index))
    }

    /// Returns the columns whose heading names a channel, except columns that the user names for another channel.
    fn find_named(&self, channel: Channel) -> Vec<usize> {
        let is_named = |i: &usize| matches!(&self.headings[*i], Heading::Channel(c, _) if *c == channel);
        (0..self.texts.len()).filter(|i| is_named(i) && !self.is_taken(*i, channel)).collect()
    }

    /// Returns the columns whose unit indicates a channel, except columns that the user names for another channel.
    fn find_by_unit(&self, channel: Channel) -> Vec<usize> {
        let speaks = |i: &usize| by_unit(self.texts[*i], self.unit_below(*i)) == Some(channel);
        (0..self.texts.len()).filter(|i| speaks(i) && !self.is_taken(*i, channel)).collect()
    }

    /// Retains the columns with the plainest headings, and of these the ones in a unit of the channel.
    ///
    /// A heading that contains only the quantity has precedence over a heading that also contains the sensor. Of a pair
    /// such as `Force (V)` and `Force (kN)`, the column with a unit of the quantity counts.
    fn retain_plainest(&self, candidates: &mut Vec<usize>, channel: Channel) {
        prefer(candidates, |i| !is_setpoint(self.texts[i]));
        prefer(candidates, |i| is_plain(self.texts[i]) && !is_stopgap(self.texts[i]));
        prefer(candidates, |i| is_plain(self.texts[i]));
        prefer(candidates, |i| {
            let is_own = |unit: &Unit| unit.dimension() == channel.dimension();
            matches!(&self.headings[i], Heading::Channel(_, HeadingUnit::Known(unit)) if is_own(unit))
                || self.units.get(i).and_then(|unit| unit.parse::<Unit>().ok()).is_some_and(|unit| is_own(&unit))
        });
    }

    /// Returns whether a unit alone may assign a column to a channel. For a displacement, this requires that no column
    /// is a velocity.
    fn may_guess(&self, channel: Channel) -> bool {
        let is_velocity = |heading: &Heading| matches!(heading, Heading::Channel(Channel::Velocity, _));
        match channel {
            Channel::Displacement => {
                !self.options.columns.contains_key(&Channel::Velocity) && !self.headings.iter().any(is_velocity)
            }
            _ => channel == Channel::Force,
        }
    }

    /// Returns the column that a heading, or else a unit, assigns to a channel.
    fn recognize(&self, channel: Channel) -> Result<Option<Recognized>, RecordError> {
        let mut candidates = self.find_named(channel);
        let by_their_unit = self.find_by_unit(channel);
        let mut possible = [&candidates[..], &by_their_unit].concat();
        possible.sort_unstable();
        self.retain_plainest(&mut candidates, channel);
        let is_guess = candidates.is_empty() && self.may_guess(channel);
        if is_guess {
            candidates = by_their_unit;
        }
        match (channel, &candidates[..]) {
            // A current may belong to any device, so only a column with a unit of current counts.
            (Channel::Current, [index]) if !matches!(self.find_unit(channel, *index), Ok(Some(_))) => Ok(None),
            (_, [index]) => Ok(Some(Recognized { index: *index, is_guess })),
            (_, []) => Ok(None),
            // Several columns of clicks occur in a table of peaks or for two adjusters, so none of them is used.
            (Channel::Current | Channel::Setting, _) => Ok(None),
            _ => Err(self.ask_for_one_of(channel, &possible)),
        }
    }

    /// Makes the error that asks the user to select one of several columns.
    fn ask_for_one_of(&self, channel: Channel, several: &[usize]) -> RecordError {
        let headings = several.iter().take(LISTED).map(|i| self.texts[*i].to_string()).collect();
        ColumnError::SeveralColumns { at: self.at.clone(), line: self.line, channel, headings }.into()
    }

    /// Returns the unit of a column, or `None` if no source states it. An unknown unit, or one of another quantity, is
    /// an error.
    fn find_unit(&self, channel: Channel, index: usize) -> Result<Option<Unit>, RecordError> {
        let column = self.texts[index];
        let unknown = |unit: &str| -> RecordError {
            let (column, unit) = (column.to_string(), unit.to_string());
            ColumnError::UnknownUnit { at: self.at.clone(), line: self.line, column, unit, channel }.into()
        };
        if channel == Channel::Setting {
            return Ok(Some(Unit::AsWritten));
        }
        if let Some(&unit) = self.options.units.get(&channel) {
            return if unit.dimension() == channel.dimension() { Ok(Some(unit)) } else { Err(unknown(unit.name())) };
        }
        match &self.headings[index] {
            Heading::Channel(_, HeadingUnit::Known(unit)) if unit.dimension() == channel.dimension() => {
                return Ok(Some(*unit));
            }
            Heading::Channel(_, HeadingUnit::Known(unit)) => return Err(unknown(unit.name())),
            Heading::Channel(_, HeadingUnit::Unknown(text)) => return Err(unknown(text)),
            _ => {}
        }
        // The heading of a column that the user selected may contain its unit: `Load Cell 1 [kN]`.
        let written = column.rsplit_once(['[', '(']).map(|(_, unit)| unit);
        let below = self.units.get(index).map(|unit| unit.trim()).filter(|unit| !unit.is_empty());
        let parsed = |text: &str| text.parse::<Unit>().ok().filter(|unit| unit.dimension() == channel.dimension());
        if let Some(unit) = written.and_then(parsed).or_else(|| below.and_then(parsed)) {
            return Ok(Some(unit));
        }
        if let Some(text) = below.or(written) {
            return Err(unknown(text.trim_matches(|c| "[]()".contains(c))));
        }
        Ok(None)
    }

    /// Returns the heading of a column. The name and unit of a setting follow from its heading, so a unit below the
    /// heading is added to it.
    fn complete_heading(&self, channel: Channel, index: usize) -> String {
        let text = self.texts[index];
        let is_setting = matches!(channel, Channel::Current | Channel::Setting);
        match self.unit_below(index).filter(|unit| !unit.is_empty()) {
            Some(unit) if is_setting && written_unit(text).is_none() => format!("{text} [{unit}]"),
            _ => text.to_string(),
        }
    }
}

/// Columns of a header that have a channel.
#[derive(Default)]
struct Assigned {
    columns: Vec<Column>,
    /// Columns assigned to a channel by their unit alone.
    guessed: Vec<(Channel, String)>,
    /// Columns whose unit no source states.
    without_unit: Vec<(Channel, String)>,
}

impl Assigned {
    /// Adds the column of a channel, if the header has one. `is_clock` returns whether a column contains times of day.
    fn add(&mut self, header: &Header, channel: Channel, is_clock: &dyn Fn(usize) -> bool) -> Result<(), RecordError> {
        let index = match header.options.columns.get(&channel) {
            Some(wanted) => header.find_wanted(channel, wanted)?,
            None => header.recognize(channel)?.map(|Recognized { index, is_guess }| {
                if is_guess {
                    self.guessed.push((channel, header.texts[index].to_string()));
                }
                index
            }),
        };
        let Some(index) = index else { return Ok(()) };
        let clock = channel == Channel::Time && is_clock(index);
        let unit = if clock { Some(Unit::Second) } else { header.find_unit(channel, index)? };
        let unit = unit.unwrap_or_else(|| {
            self.without_unit.push((channel, header.texts[index].to_string()));
            channel.example()
        });
        let heading = header.complete_heading(channel, index);
        self.columns.push(Column { channel, index, unit, heading, clock });
        Ok(())
    }

    fn has(&self, channel: Channel) -> bool {
        self.columns.iter().any(|column| column.channel == channel)
    }

    fn contains(&self, index: usize) -> bool {
        self.columns.iter().any(|column| column.index == index)
    }

    /// Returns an error if a record lacks a channel or a unit. `needs_time` is false if the source states its sample
    /// time.
    fn check_complete(&self, header: &Header, needs_time: bool) -> Result<(), RecordError> {
        let missing = if !self.has(Channel::Time) && needs_time {
            Some(("time", Channel::Time))
        } else if !self.has(Channel::Force) && !header.options.ignore.contains(&Channel::Force) {
            Some(("force", Channel::Force))
        } else if !self.has(Channel::Displacement) && !self.has(Channel::Velocity) {
            Some(("displacement or velocity", Channel::Displacement))
        } else {
            None
        };
        let (at, line) = (header.at.clone(), header.line);
        if let Some((missing, example)) = missing {
            let free = (0..header.texts.len()).filter(|i| !self.contains(*i)).map(|i| header.texts[i]);
            let near = maybe(nearest_to(example, &free.collect::<Vec<_>>()));
            let units = self.without_unit.iter().map(|(channel, _)| *channel).collect();
            let angle = header.texts.iter().find(|text| crank::is_angle(text)).map(|text| (*text).to_owned());
            let found = header.list();
            return Err(ColumnError::MissingColumn { at, line, missing, example, found, near, angle, units }.into());
        }
        if !self.without_unit.is_empty() {
            let (columns, headed) = (self.without_unit.clone(), header.is_headed());
            return Err(ColumnError::MissingUnit { at, line, columns, headed }.into());
        }
        Ok(())
    }

    /// Lists the headings of the columns that are not read, for a note.
    fn list_ignored(&self, header: &Header, test: Option<usize>) -> Vec<String> {
        /// Largest number of columns that the note names.
        const NAMED: usize = 100;
        (0..header.texts.len())
            .filter(|i| !header.texts[*i].is_empty() && Some(*i) != test && !self.contains(*i))
            .filter(|i| !matches!(header.headings[*i], Heading::SampleTime(_) | Heading::SampleRate))
            .map(|i| header.texts[i].to_string())
            .take(NAMED)
            .collect()
    }

    /// Lists the columns that may contain the setting, of a table whose setting is not read. They are columns in a unit
    /// of current, and commands to a valve in another unit.
    fn list_unread_settings(&self, header: &Header) -> Vec<(String, String, Channel)> {
        if self.has(Channel::Current) || self.has(Channel::Setting) || header.options.ignore.contains(&Channel::Current)
        {
            return Vec::new();
        }
        let of = |(i, text): (usize, &&str)| {
            let below = header.unit_below(i);
            let current = unit_of_current(text, below).map(|unit| (unit, Channel::Current));
            let (unit, channel) =
                current.or_else(|| unit_of_command(text, below).map(|unit| (unit, Channel::Setting)))?;
            Some(((*text).to_owned(), unit.to_owned(), channel))
        };
        header.texts.iter().enumerate().filter_map(of).take(LISTED).collect()
    }
}

impl Layout {
    /// Assigns the columns of a header to channels.
    ///
    /// `line` is the line of the header in the file, for messages. A column beyond the end of `units` has no unit.
    /// `sample_time_given` is true if the source states its own sample time and requires no time column.
    pub fn new<S: AsRef<str>>(
        at: &Place,
        line: usize,
        header: &[S],
        units: Option<&[S]>,
        options: &Options,
        sample_time_given: bool,
    ) -> Result<Layout, RecordError> {
        Layout::with_clock(at, line, header, units, options, sample_time_given, &|_| false)
    }

    /// Assigns the columns of a header to channels. `is_clock` returns whether a column contains times of day, which
    /// require no unit.
    pub fn with_clock<S: AsRef<str>>(
        at: &Place,
        line: usize,
        header: &[S],
        units: Option<&[S]>,
        options: &Options,
        sample_time_given: bool,
        is_clock: &dyn Fn(usize) -> bool,
    ) -> Result<Layout, RecordError> {
        let header = Header::new(at, line, header, units, options)?;
        let mut assigned = Assigned::default();
        for channel in Channel::ALL.into_iter().filter(|channel| !options.ignore.contains(channel)) {
            assigned.add(&header, channel, is_clock)?;
        }
        assigned.check_complete(&header, !sample_time_given && options.sample_rate_hz.is_none())?;
        let test = header.headings.iter().position(|heading| *heading == Heading::Test);
        Ok(Layout {
            test,
            ignored: assigned.list_ignored(&header, test),
            unread_settings: assigned.list_unread_settings(&header),
            columns: assigned.columns,
            guessed: assigned.guessed,
            step: options.sample_rate_hz.map(|rate| 1.0 / rate),
        })
    }
}

/// Retains only the candidates for which `better` is true, if there are several candidates and some are better.
fn prefer(candidates: &mut Vec<usize>, better: impl Fn(usize) -> bool) {
    if candidates.len() > 1 && candidates.iter().any(|i| better(*i)) {
        candidates.retain(|i| better(*i));
    }
}
