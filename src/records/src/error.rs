//! Why a record or a campaign cannot be read, in words that say where and what to do.

use std::fmt;
use std::path::PathBuf;

use super::channel::Channel;
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

    #[error("{file}: is empty (0 bytes); export it again", file = .file.display())]
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

    #[error("{file}: is no record; records are {} files", kinds(), file = .file.display())]
    UnknownType { file: PathBuf },

    #[error("{file}: is {is}, which is not read; {instead}", file = .file.display())]
    NotRead { file: PathBuf, is: &'static str, instead: &'static str },

    #[error("{file}: cannot be read as a workbook ({cause}); save it again as .xlsx, or export the sheet as CSV", file = .file.display())]
    Workbook { file: PathBuf, cause: String },

    #[error("{file}: cannot be read as a MAT file ({cause}); save it again with save(..., '-v7')", file = .file.display())]
    Mat { file: PathBuf, cause: String },

    #[error("{at}, line {line}: {cause}")]
    PeakTable { at: Place, line: usize, cause: String },

    #[error("{file}: cannot be read as {kind} ({cause})", file = .file.display())]
    Binary { file: PathBuf, kind: &'static str, cause: String },

    #[error("{file}: cannot be read as an RPC III time history ({cause})", file = .file.display())]
    Rpc { file: PathBuf, cause: String },

    #[error(
        "{at}: no header line found that names time and other channels; the first line reads '{found}'. Understood are: \
         {understood}. Other headings can be given as --column force=\"Load Cell 1\""
    )]
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

    #[error("{at}, line {line}, column '{column}': '{text}' is no number{hint}")]
    Cell { at: Place, line: usize, column: String, text: String, hint: &'static str },

    #[error("{at}, line {line}: has {found} fields where the header has {expected}{hint}")]
    Fields { at: Place, line: usize, found: usize, expected: usize, hint: &'static str },

    #[error(
        "{at}, line {line}: {channel} is missing or not a number here and in {count} of {rows} rows in all; too many to \
         drop. Repair the export{advice}",
        advice = channel.leave_out_advice()
    )]
    Missing { at: Place, line: usize, channel: Channel, count: usize, rows: usize },

    #[error("{at}: has a header but no data rows")]
    NoData { at: Place },

    #[error("{at}: has only {samples} usable samples; a test needs at least {needed}, so measure it again")]
    TooFew { at: Place, samples: usize, needed: usize },

    #[error("{at}: time does not advance, it is {time} s in every row; check that the right column is read as time")]
    ConstantTime { at: Place, time: f64 },

    #[error(
        "{at}, line {line}: time goes back from {from} s to {to} s. If the file holds several tests one after another, \
         add a column 'test' or split it; otherwise cut the stray block"
    )]
    TimeBackwards { at: Place, line: usize, from: f64, to: f64 },

    #[error(
        "{at}, lines {first} to {last}: {channel} is frozen at {value:.6} (SI) for {seconds:.3} s while {moving}; {advice}"
    )]
    Frozen {
        at: Place,
        channel: Channel,
        first: usize,
        last: usize,
        value: f64,
        seconds: f64,
        moving: &'static str,
        advice: &'static str,
    },

    #[error(
        "{at}, first at line {line}: {channel} is clipped at {value:.5} (SI) in {percent:.1} % of the samples, which leaves too \
         little to trust; {advice}"
    )]
    Clipped { at: Place, line: usize, channel: Channel, value: f64, percent: f64, advice: &'static str },

    #[error(
        "{at}: the damper does not move: {channel} shows nothing but noise, within {range:.4} {unit}. Measure the test again, or, if \
         it is meant to stand, take it out"
    )]
    NoMotion { at: Place, channel: Channel, range: f64, unit: &'static str },

    #[error(
        "{at}: force is {value:.6} N in every row while the damper moves; check the load cell and its cable, and measure again"
    )]
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

    #[error("{at}: displacement and velocity contradict each other: {cause}")]
    Contradiction { at: Place, cause: String },

    #[error("the damper would feed energy into the rig, so a sign is wrong: {cause}")]
    FeedsEnergy { cause: String, tests: Vec<String> },
}
