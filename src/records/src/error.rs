//! Why a record or a campaign cannot be read, in words that say where and what to do.

use std::fmt;
use std::path::{Path, PathBuf};

use super::channel::Channel;
use super::phrases;
use super::sentence::{Sentence, Template};
use super::unit::Unit;

/// The files that are read, for messages.
fn kinds() -> String {
    let all = super::campaign::ENDINGS.map(|ending| format!(".{ending}"));
    let (last, others) = (&all[all.len() - 1], &all[..all.len() - 1]);
    format!("{} and {last}", others.join(", "))
}

/// The place a message speaks of: a file, and the sheet or test within it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The file.
    pub file: PathBuf,
    /// Sheet or test within the file, where it holds several.
    pub part: Option<String>,
}

impl Place {
    /// A place that is a whole file.
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

/// Why reading a campaign was refused. Every message names the file, the line where there is one, and what to do.
///
/// Lines count from 1 as an editor shows them; in a sheet they are its rows, in a MAT file the elements.
#[derive(Debug, thiserror::Error)]
#[allow(missing_docs)] // the messages are the meaning of variants and fields
pub enum RecordError {
    #[error("{file}: there is no such file or folder; check the path", file = .file.display())]
    NotFound { file: PathBuf },

    #[error("{file}: cannot be read ({source})", file = .file.display())]
    Read {
        file: PathBuf,
        #[source]
        source: std::io::Error,
    },

    #[error("{folder}: holds no record; a campaign folder holds {}", kinds(), folder = .folder.display())]
    EmptyFolder { folder: PathBuf },

    #[error("{}", self.fault())]
    EmptyFile { file: PathBuf },

    #[error("--exclude {pattern:?} matches no file and no test; the first file is called {first:?}")]
    ExcludesNothing { pattern: String, first: String },

    #[error("--exclude leaves no record; all {count} files and tests match")]
    ExcludesAll { count: usize },

    #[error("{file}: {cause}", file = .file.display())]
    Profile { file: PathBuf, cause: String },

    #[error(
        "{first} and {second} say different directions positive; make them agree, or give --positive",
        first = .first.display(), second = .second.display()
    )]
    ProfilesDisagree { first: PathBuf, second: PathBuf },

    #[error(
        "{at}: the headings '{first}' and '{second}' look swapped: {evidence}. Correct the header, or give --column {of_first}=\"{second}\" \
         --column {of_second}=\"{first}\" (and --unit where the unit is swapped too); if they are right, give --unit {of_first}=... to insist"
    )]
    Swapped { at: Place, first: String, second: String, of_first: Channel, of_second: Channel, evidence: String },

    #[error(
        "{evidence}; that speaks for {likely} written as {written}. Give --unit {channel}={likely}, or --unit {channel}={written} to insist"
    )]
    UnitSlip { channel: Channel, written: Unit, likely: Unit, evidence: String },

    #[error("no record given; name a record file or a campaign folder")]
    NoPaths,

    #[error("{}", self.fault())]
    UnknownType { file: PathBuf },

    #[error("{}", self.fault())]
    NotRead { file: PathBuf, is: &'static str, instead: &'static str },

    #[error("{}", self.fault())]
    Workbook { file: PathBuf, cause: String },

    #[error("{}", self.fault())]
    Mat { file: PathBuf, cause: String },

    #[error("{at}, line {line}: {cause}")]
    PeakTable { at: Place, line: usize, cause: String },

    #[error("{}", self.fault())]
    Binary { file: PathBuf, kind: &'static str, cause: String },

    #[error("{}", self.fault())]
    Rpc { file: PathBuf, cause: String },

    #[error("{} Understood are: {understood}. Other headings can be given as --column force=\"Load Cell 1\"", self.fault())]
    Header { at: Place, found: String, understood: String },

    #[error(
        "{at}, line {line}: no column for {missing}; the columns are {found}.{near} Name the column with --column {example}=\"heading\"{otherwise}",
        otherwise = if *.example == Channel::Time {
            ", or, where the file has none, say --sample-rate 1000 (samples per second)"
        } else {
            ""
        }
    )]
    MissingColumn { at: Place, line: usize, missing: &'static str, example: Channel, found: String, near: String },

    #[error(
        "{at}, line {line}: both '{first}' and '{second}' could be {channel}; choose one with --column {channel}=\"{first}\""
    )]
    TwoColumns { at: Place, line: usize, channel: Channel, first: String, second: String },

    #[error("{at}, line {line}: there is no column '{wanted}' for {channel}; the columns are {found}.{near}")]
    NoSuchColumn { at: Place, line: usize, channel: Channel, wanted: String, found: String, near: String },

    #[error(
        "{at}, line {line}: column '{column}' has no unit; write it in the heading as '{column} [{example}]' or give \
         --unit {channel}={example}. Understood for {channel}: {understood}",
        understood = .channel.units_understood()
    )]
    MissingUnit { at: Place, line: usize, column: String, channel: Channel, example: &'static str },

    #[error(
        "{at}, line {line}: column '{column}' has the unit '{unit}', which is not understood for {channel}; understood are \
         {understood}. Give --unit {channel}=... if the heading is wrong",
        understood = .channel.units_understood()
    )]
    UnknownUnit { at: Place, line: usize, column: String, unit: String, channel: Channel },

    #[error("{}", self.fault())]
    Cell { at: Place, line: usize, column: String, text: String, hint: Option<Template> },

    #[error("{}", self.fault())]
    Fields { at: Place, line: usize, found: usize, expected: usize, hint: Option<Template> },

    #[error("{}", self.fault())]
    Missing { at: Place, line: usize, channel: Channel, count: usize, rows: usize },

    #[error("{}", self.fault())]
    NoData { at: Place },

    #[error("{}", self.fault())]
    TooFew { at: Place, samples: usize, needed: usize },

    #[error("{}", self.fault())]
    ConstantTime { at: Place, time: f64 },

    #[error("{}", self.fault())]
    TimeBackwards { at: Place, line: usize, from: f64, to: f64 },

    #[error("{}", self.fault())]
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

    #[error("{}", self.fault())]
    Clipped { at: Place, line: usize, channel: Channel, value: f64, percent: f64, advice: Template },

    #[error("{}", self.fault())]
    NoMotion { at: Place, channel: Channel, range: f64, unit: &'static str },

    #[error("{}", self.fault())]
    ConstantForce { at: Place, value: f64 },

    #[error(
        "{at}, line {line}: {channel} is missing or no number; a motion is used as it stands, so fill the gap or cut it off"
    )]
    MotionGap { at: Place, line: usize, channel: Channel },

    #[error("{at}, line {line}: time does not increase: {to} s comes after {from} s; a motion needs increasing time")]
    MotionTime { at: Place, line: usize, from: f64, to: f64 },

    #[error("{at}: has one row; a motion needs at least two")]
    ShortMotion { at: Place },

    #[error("{file}: holds several tests, '{first}' and '{second}'; a motion is one, so cut the file", file = .file.display())]
    SeveralMotions { file: PathBuf, first: String, second: String },

    #[error("{record}: shows {what}, which no suspension damper has; {advice}")]
    Absurd { record: String, what: String, advice: &'static str },

    #[error(
        "{count} of {all} tests show no force: in {record} it does not stand out of its noise of {noise:.3} N, although the damper \
         moves. Check the load cell and its channel (--column force=\"heading\")"
    )]
    NoForce { count: usize, all: usize, record: String, noise: f64 },

    #[error("{channel} cannot be left out of records; take it off --ignore")]
    Indispensable { channel: Channel },

    #[error("{}", self.fault())]
    Contradiction { at: Place, cause: Sentence },

    #[error("the damper would feed energy into the rig, so a sign is wrong: {cause}")]
    FeedsEnergy { cause: String, tests: Vec<String> },
}

impl RecordError {
    /// What is wrong with a file or test that a campaign can do without, as a sentence that reports say in their own language. What is a
    /// question to the user is said on the terminal alone.
    pub(crate) fn fault(&self) -> Sentence {
        let of = |template: Template, at: &Place| Sentence::from(template).with("at", at);
        let in_file = |template: Template, file: &Path| Sentence::from(template).with("file", file.display());
        let any = |sentence: Sentence, name, template: &Option<Template>| {
            sentence.with_any(name, template.map(Sentence::from))
        };
        match self {
            RecordError::UnknownType { file } => in_file(phrases::UNKNOWN_TYPE, file).with("kinds", kinds()),
            RecordError::NotRead { file, is, instead } => {
                in_file(phrases::NOT_READ, file).with_word("is", is).with_word("instead", instead)
            }
            RecordError::EmptyFile { file } => in_file(phrases::EMPTY_FILE, file),
            RecordError::Workbook { file, cause } => in_file(phrases::WORKBOOK, file).with("cause", cause),
            RecordError::Rpc { file, cause } => in_file(phrases::RPC, file).with("cause", cause),
            RecordError::Binary { file, kind, cause } => {
                in_file(phrases::BINARY, file).with("kind", kind).with("cause", cause)
            }
            RecordError::Mat { file, cause } => in_file(phrases::MAT, file).with("cause", cause),
            RecordError::Header { at, found, .. } => of(phrases::NO_HEADER, at).with("found", found),
            RecordError::NoData { at } => of(phrases::NO_DATA, at),
            RecordError::TooFew { at, samples, needed } => {
                of(phrases::TOO_FEW, at).with("samples", samples).with("needed", needed)
            }
            RecordError::Missing { at, line, channel, count, rows } => of(phrases::MISSING, at)
                .with("line", line)
                .with_word("channel", channel.name())
                .with("count", count)
                .with("rows", rows)
                .with_any("advice", channel.leave_out_advice()),
            RecordError::ConstantTime { at, time } => of(phrases::CONSTANT_TIME, at).with("time", time),
            RecordError::TimeBackwards { at, line, from, to } => {
                of(phrases::TIME_BACKWARDS, at).with("line", line).with("from", from).with("to", to)
            }
            RecordError::Frozen { at, channel, first, last, value, seconds, moving, advice } => of(phrases::FROZEN, at)
                .with("first", first)
                .with("last", last)
                .with_word("channel", channel.name())
                .with("value", format!("{value:.6}"))
                .with("seconds", format!("{seconds:.3}"))
                .with_said("moving", *moving)
                .with_said("advice", *advice),
            RecordError::Clipped { at, line, channel, value, percent, advice } => of(phrases::CLIPPED, at)
                .with("line", line)
                .with_word("channel", channel.name())
                .with("value", format!("{value:.5}"))
                .with("percent", format!("{percent:.1}"))
                .with_said("advice", *advice),
            RecordError::NoMotion { at, channel, range, unit } => of(phrases::NO_MOTION, at)
                .with_word("channel", channel.name())
                .with("range", format!("{range:.4}"))
                .with("unit", unit),
            RecordError::ConstantForce { at, value } => {
                of(phrases::CONSTANT_FORCE, at).with("value", format!("{value:.6}"))
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
                of(phrases::CONTRADICTION, at).with_said("cause", cause.clone())
            }
            question => Sentence::as_it_is(question),
        }
    }
}
