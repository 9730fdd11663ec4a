//! Errors of reading a record or a campaign. Each message states the location and the remedy.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::messages::phrases;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use dashpot_messages::{Sentence, Template, format_decimals, format_number};

/// Lists the supported file extensions, for messages.
fn kinds() -> Sentence {
    let all = crate::file_extensions::EXTENSIONS.map(|ending| format!(".{ending}"));
    let (last, others) = (&all[all.len() - 1], &all[..all.len() - 1]);
    Sentence::from(phrases::KINDS).with("others", others.join(", ")).with("last", last)
}

/// Formats the options that state the units of channels, each with an example.
fn unit_options(channels: impl Iterator<Item = Channel>) -> String {
    channels.map(|channel| format!("--unit {channel}={}", channel.example())).collect::<Vec<_>>().join(" ")
}

/// Formats a file size for messages: below 10 MiB in bytes, else in MiB.
fn size(bytes: u64) -> String {
    if bytes < 10 << 20 { format!("{bytes} bytes") } else { format!("{} MiB", bytes >> 20) }
}

/// The location that a message refers to: a file, and the sheet or test within it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Path of the file.
    pub file: PathBuf,
    /// Sheet or test within the file, if the file contains several.
    pub part: Option<String>,
}

impl Place {
    /// Makes the location of a whole file.
    pub fn file(file: impl Into<PathBuf>) -> Self {
        Place { file: file.into(), part: None }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file.display())?;
        if let Some(part) = &self.part {
            write!(f, " ({part})")?;
        }
        Ok(())
    }
}

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

/// Names tests in a list. Names at most twelve and states the number of the others, so that the text stays readable.
pub(crate) fn name_several(tests: &[String]) -> Sentence {
    const NAMED: usize = 12;
    let named = Sentence::list(tests.iter().take(NAMED).map(Sentence::as_it_is).collect(), phrases::COMMA);
    match tests.len().saturating_sub(NAMED) {
        0 => named,
        more => Sentence::from(phrases::AND_MORE).with_sentence("names", named).with("count", more),
    }
}

/// Reason for which a campaign is rejected. Every message states the file, the line if known, and the remedy.
///
/// Lines count from 1, as in an editor. The lines of a sheet are its rows, and the lines of a MAT file are the elements
/// of its arrays.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
#[allow(missing_docs)] // the messages are the meaning of variants and fields
pub enum RecordError {
    NotFound {
        file: PathBuf,
    },

    Read {
        file: PathBuf,
        #[source]
        source: std::io::Error,
    },

    /// The path is a pipe, a device or a folder, not a file.
    NotRegular {
        file: PathBuf,
    },

    TooLarge {
        file: PathBuf,
        bytes: u64,
        largest: u64,
    },

    TooCostly {
        at: Place,
    },

    TooManyColumns {
        at: Place,
        line: usize,
        found: usize,
        most: usize,
    },

    EmptyFolder {
        folder: PathBuf,
    },

    InSubfolders {
        folder: PathBuf,
        names: Vec<String>,
        count: usize,
    },

    EmptyFile {
        file: PathBuf,
    },

    ExcludesNothing {
        pattern: String,
        first: String,
    },

    ExcludesAll {
        count: usize,
    },

    Profile {
        file: PathBuf,
        cause: String,
    },

    ProfilesDisagree {
        first: PathBuf,
        second: PathBuf,
    },

    Swapped {
        at: Place,
        first: String,
        second: String,
        of_first: Channel,
        of_second: Channel,
        evidence: Sentence,
    },

    UnitSlip {
        channel: Channel,
        written: Unit,
        likely: Unit,
        evidence: Sentence,
    },

    FilesUnit(Box<FilesUnit>),

    NoPaths,

    MixedCurrent {
        record: String,
        test: String,
        current: f64,
        others: f64,
    },

    UnknownType {
        file: PathBuf,
    },

    NotRead {
        file: PathBuf,
        is: Template,
        instead: Template,
    },

    Workbook {
        file: PathBuf,
        cause: String,
    },

    Mat {
        file: PathBuf,
        cause: String,
    },

    PeakTable {
        at: Place,
        line: usize,
        cause: String,
    },

    /// The file contains a table of peaks instead of a record.
    IsPeakTable {
        file: PathBuf,
    },

    Binary {
        file: PathBuf,
        kind: &'static str,
        cause: String,
    },

    Rpc {
        file: PathBuf,
        cause: String,
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

    MotionGap {
        at: Place,
        line: usize,
        channel: Channel,
    },

    MotionBeyond {
        at: Place,
        line: usize,
        channel: Channel,
        value: f64,
        limit: f64,
    },

    MotionTime {
        at: Place,
        line: usize,
        from: f64,
        to: f64,
    },

    ShortMotion {
        at: Place,
    },

    SeveralMotions {
        file: PathBuf,
        first: String,
        second: String,
    },

    Absurd {
        record: String,
        what: Sentence,
        advice: Template,
    },

    NoForce {
        count: usize,
        all: usize,
        record: String,
        noise: f64,
    },

    Indispensable {
        channel: Channel,
    },

    Contradiction {
        at: Place,
        cause: Sentence,
    },

    FeedsEnergy {
        cause: Sentence,
        tests: Vec<String>,
    },

    Exchanged {
        cause: Sentence,
        tests: Vec<String>,
    },
}

impl RecordError {
    /// Returns the cause and the remedy as a translatable sentence.
    pub fn sentence(&self) -> Sentence {
        let of = |template: Template, at: &Place| Sentence::from(template).with("at", at);
        let in_line = |template: Template, at: &Place, line: &usize| of(template, at).with("line", line);
        let in_file = |template: Template, file: &Path| Sentence::from(template).with("file", file.display());
        let any = |sentence: Sentence, name, template: &Option<Template>| {
            sentence.with_any(name, template.map(Sentence::from))
        };
        match self {
            RecordError::UnknownType { file } => in_file(phrases::UNKNOWN_TYPE, file).with_sentence("kinds", kinds()),
            RecordError::NotRead { file, is, instead } => {
                in_file(phrases::NOT_READ, file).with_sentence("is", *is).with_sentence("instead", *instead)
            }
            RecordError::EmptyFile { file } => in_file(phrases::EMPTY_FILE, file),
            RecordError::Workbook { file, cause } => in_file(phrases::WORKBOOK, file).with_foreign("cause", cause),
            RecordError::Rpc { file, cause } => in_file(phrases::RPC, file).with_foreign("cause", cause),
            RecordError::Binary { file, kind, cause } => {
                in_file(phrases::BINARY, file).with("kind", kind).with_foreign("cause", cause)
            }
            RecordError::Mat { file, cause } => in_file(phrases::MAT, file).with_foreign("cause", cause),
            RecordError::Header { understood, .. } => {
                Sentence::from(phrases::UNDERSTOOD).with_sentence("header", self.fault()).with("understood", understood)
            }
            RecordError::NoData { at } => of(phrases::NO_DATA, at),
            RecordError::TooFew { at, samples, needed } => {
                of(phrases::TOO_FEW, at).with("samples", samples).with("needed", needed)
            }
            RecordError::Missing { at, line, channel, count, rows } => of(phrases::MISSING, at)
                .with("line", line)
                .with_sentence("channel", channel.message())
                .with("count", count)
                .with("rows", rows)
                .with_any("advice", channel.leave_out_advice()),
            RecordError::ConstantTime { at, time } => of(phrases::CONSTANT_TIME, at).with("time", format_number(*time)),
            RecordError::TimeBackwards { at, line, from, to } => of(phrases::TIME_BACKWARDS, at)
                .with("line", line)
                .with("from", format_number(*from))
                .with("to", format_number(*to)),
            RecordError::Frozen { at, channel, first, last, value, seconds, moving, advice } => of(phrases::FROZEN, at)
                .with("first", first)
                .with("last", last)
                .with_sentence("channel", channel.message())
                .with("value", format_decimals(*value, 6))
                .with("unit", channel.si())
                .with("seconds", format_decimals(*seconds, 3))
                .with_sentence("moving", *moving)
                .with_sentence("advice", *advice),
            RecordError::Clipped { at, line, channel, value, percent, advice } => of(phrases::CLIPPED, at)
                .with("line", line)
                .with_sentence("channel", channel.message())
                .with("value", format_decimals(*value, 5))
                .with("unit", channel.si())
                .with("percent", format_decimals(*percent, 1))
                .with_sentence("advice", *advice),
            RecordError::NoMotion { at, channel, range, unit } => of(phrases::NO_MOTION, at)
                .with_sentence("channel", channel.message())
                .with("range", format_decimals(*range, 4))
                .with("unit", unit),
            RecordError::ConstantForce { at, value } => {
                of(phrases::CONSTANT_FORCE, at).with("value", format_decimals(*value, 6))
            }
            RecordError::Cell { at, line, column, text, hint } => {
                let cell = of(phrases::CELL, at).with("line", line).with("column", column).with("text", text);
                any(cell, "hint", hint)
            }
            RecordError::Fields { at, line, found, expected, hint } => {
                let fields = of(phrases::FIELDS, at).with("line", line);
                any(fields.with("found", found).with("expected", expected), "hint", hint)
            }
            RecordError::Contradiction { at, cause } => {
                of(phrases::CONTRADICTION, at).with_sentence("cause", cause.clone())
            }
            RecordError::NotFound { file } => in_file(phrases::NOT_FOUND, file),
            RecordError::Read { file, source } => in_file(phrases::CANNOT_READ, file).with_foreign("cause", source),
            RecordError::NotRegular { file } => in_file(phrases::NOT_REGULAR, file),
            RecordError::IsPeakTable { file } => in_file(phrases::IS_PEAK_TABLE, file),
            RecordError::TooLarge { file, bytes, largest } => {
                in_file(phrases::TOO_LARGE, file).with("size", size(*bytes)).with("largest", size(*largest))
            }
            RecordError::TooCostly { at } => of(phrases::TOO_COSTLY, at),
            RecordError::TooManyColumns { at, line, found, most } => {
                in_line(phrases::TOO_MANY_COLUMNS, at, line).with("found", found).with("most", most)
            }
            RecordError::EmptyFolder { folder } => {
                Sentence::from(phrases::EMPTY_FOLDER).with("folder", folder.display()).with_sentence("kinds", kinds())
            }
            RecordError::InSubfolders { folder, names, count } => Sentence::from(phrases::IN_SUBFOLDERS)
                .with("folder", folder.display())
                .with("count", count)
                .with_names("names", names, phrases::COMMA),
            RecordError::ExcludesNothing { pattern, first } => Sentence::from(phrases::EXCLUDES_NOTHING)
                .with("pattern", format!("{pattern:?}"))
                .with("first", format!("{first:?}")),
            RecordError::ExcludesAll { count } => Sentence::from(phrases::EXCLUDES_ALL).with("count", count),
            RecordError::Profile { file, cause } => {
                in_file(phrases::OF_FILE, file).with_sentence("text", Sentence::as_it_is(cause))
            }
            RecordError::ProfilesDisagree { first, second } => Sentence::from(phrases::PROFILES_DISAGREE)
                .with("first", first.display())
                .with("second", second.display()),
            RecordError::Swapped { at, first, second, of_first, of_second, evidence } => of(phrases::SWAPPED, at)
                .with("first", first)
                .with("second", second)
                .with("of_first", of_first)
                .with("of_second", of_second)
                .with_sentence("evidence", evidence.clone()),
            RecordError::UnitSlip { channel, written, likely, evidence } => Sentence::from(phrases::WRONG_UNIT)
                .with_sentence("evidence", evidence.clone())
                .with("likely", likely)
                .with("written", written)
                .with("channel", channel),
            RecordError::FilesUnit(slip) => slip.sentence(),
            RecordError::NoPaths => phrases::NO_PATHS.into(),
            RecordError::MixedCurrent { record, test, current, others } => Sentence::from(phrases::MIXED_CURRENT)
                .with("record", record)
                .with("test", test)
                .with("current", format_decimals(*current, 0))
                .with("others", format_decimals(*others, 2)),
            RecordError::PeakTable { at, line, cause } => {
                in_line(phrases::IN_LINE, at, line).with_sentence("cause", Sentence::as_it_is(cause))
            }
            RecordError::MissingColumn { at, line, missing, example, found, near, units } => {
                let units = (!units.is_empty())
                    .then(|| Sentence::from(phrases::UNITS_TOO).with("options", unit_options(units.iter().copied())));
                let otherwise = (*example == Channel::Time).then(|| phrases::OR_SAMPLE_RATE.into());
                in_line(phrases::MISSING_COLUMN, at, line)
                    .with_word("missing", missing)
                    .with("found", found)
                    .with_any("near", near.clone())
                    .with("example", example)
                    .with_any("otherwise", otherwise)
                    .with_any("units", units)
            }
            RecordError::SeveralColumns { at, line, channel, headings } => {
                let quoted = |h: &String| Sentence::from(phrases::QUOTED).with("test", h);
                in_line(phrases::SEVERAL_COLUMNS, at, line)
                    .with_list("names", headings.iter().map(quoted).collect(), phrases::COMMA)
                    .with("first", headings.first().map_or("", String::as_str))
                    .with("channel", channel)
            }
            RecordError::NoSuchColumn { at, line, channel, wanted, found, near } => {
                in_line(phrases::NO_SUCH_COLUMN, at, line)
                    .with("wanted", wanted)
                    .with_sentence("channel", channel.message())
                    .with("found", found)
                    .with_any("near", near.clone())
            }
            RecordError::NoSettingColumn { wanted } => {
                Sentence::from(phrases::NO_SETTING_COLUMN).with("wanted", wanted)
            }
            RecordError::MissingUnit { at, line, columns, headed } => match &columns[..] {
                [(channel, column)] if *headed => in_line(phrases::MISSING_UNIT, at, line)
                    .with("column", column)
                    .with("example", channel.example())
                    .with("channel", channel)
                    .with("understood", channel.units_understood()),
                several => {
                    let quoted = |(_, column): &(Channel, String)| Sentence::from(phrases::QUOTED).with("test", column);
                    let in_heading = headed.then(|| phrases::OR_IN_HEADING.into());
                    let of = |(channel, _): &(Channel, String)| format!("{channel} {}", channel.units_understood());
                    in_line(phrases::MISSING_UNITS, at, line)
                        .with_list("columns", several.iter().map(quoted).collect(), phrases::COMMA)
                        .with("options", unit_options(several.iter().map(|(channel, _)| *channel)))
                        .with_any("in_heading", in_heading)
                        .with("understood", several.iter().map(of).collect::<Vec<_>>().join("; "))
                }
            },
            RecordError::UnknownUnit { at, line, column, unit, channel } => in_line(phrases::UNKNOWN_UNIT, at, line)
                .with("column", column)
                .with("unit", unit)
                .with("channel", channel)
                .with("understood", channel.units_understood()),
            RecordError::MotionGap { at, line, channel } => {
                in_line(phrases::MOTION_GAP, at, line).with_sentence("channel", channel.message())
            }
            RecordError::MotionTime { at, line, from, to } => in_line(phrases::MOTION_TIME, at, line)
                .with("to", format_number(*to))
                .with("from", format_number(*from)),
            RecordError::MotionBeyond { at, line, channel, value, limit } => {
                let with_unit =
                    |number: f64| format!("{} {}", format_number(number), channel.si()).trim_end().to_owned();
                in_line(phrases::MOTION_BEYOND, at, line)
                    .with_sentence("channel", channel.message())
                    .with("value", with_unit(*value))
                    .with("limit", with_unit(*limit))
            }
            RecordError::ShortMotion { at } => of(phrases::SHORT_MOTION, at),
            RecordError::SeveralMotions { file, first, second } => {
                in_file(phrases::SEVERAL_MOTIONS, file).with("first", first).with("second", second)
            }
            RecordError::Absurd { record, what, advice } => Sentence::from(phrases::ABSURD)
                .with("record", record)
                .with_sentence("what", what.clone())
                .with_sentence("advice", *advice),
            RecordError::NoForce { count, all, record, noise } => Sentence::from(phrases::ALL_WITHOUT_FORCE)
                .with("count", count)
                .with("all", all)
                .with("record", record)
                .with("noise", format_decimals(*noise, 3)),
            RecordError::Indispensable { channel } => {
                Sentence::from(phrases::INDISPENSABLE).with_sentence("channel", channel.message())
            }
            RecordError::FeedsEnergy { cause, .. } => {
                Sentence::from(phrases::FEEDS_ENERGY).with_sentence("cause", cause.clone())
            }
            RecordError::Exchanged { cause, .. } => cause.clone(),
        }
    }

    /// Returns the sentence for a file or test that the campaign leaves out. The user need not act, so the sentence
    /// omits the list of supported headings.
    pub(crate) fn fault(&self) -> Sentence {
        match self {
            RecordError::Header { at, found, near, .. } => {
                Sentence::from(phrases::NO_HEADER).with("at", at).with("found", found).with_any("near", near.clone())
            }
            _ => self.sentence(),
        }
    }
}
