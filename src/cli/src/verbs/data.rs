//! Rig records on the command line: paths, units, columns, signs.

use crate::progress::Progress;
use crate::quantity::{metres, newtons, seconds};
use anyhow::{Context as _, bail};
use clap::Args;
use dashpot_identification::model_file::ModelFile;
use dashpot_identification::setting_units::restate_settings;
use dashpot_records::{Campaign, Channel, DateOrder, Note, Options, Positive, RecordError, assignment, load};
use std::cell::RefCell;
use std::path::{Path, PathBuf};

/// Options for reading records.
#[derive(Args, Debug, Clone)]
pub struct DataArgs {
    /// Record files (text, XLSX, MAT, MDF, TDMS, RPC III) or folders of them. A campaign.toml in their folder applies
    #[arg(required = true, value_name = "DATA")]
    pub data: Vec<PathBuf>,
    /// Direction that is positive in the files; determined from the data if not given
    #[arg(long, value_name = "rebound|compression")]
    positive: Option<Positive>,
    /// Reverse the sign of one channel: force or motion (displacement and velocity)
    #[arg(long, value_name = "force|motion")]
    flip: Vec<String>,
    #[command(flatten)]
    columns: ColumnArgs,
    #[command(flatten)]
    sensors: SensorArgs,
    /// Samples per second of files without a time column
    #[arg(long, value_name = "HZ", allow_negative_numbers = true)]
    sample_rate: Option<f64>,
    /// Order of day and month in dates such as 3/11/2026; determined from the files if not given
    #[arg(long, value_name = "day-first|month-first")]
    dates: Option<DateOrder>,
    /// Displacement at the first sample, m, if only velocity was recorded
    #[arg(long, value_name = "M", value_parser = metres, default_value_t = 0.0, allow_negative_numbers = true)]
    initial_position: f64,
    /// Files or tests to leave out, by name; * stands for any characters
    #[arg(long, value_name = "GLOB", value_delimiter = ',')]
    exclude: Vec<String>,
    /// Read the records in subfolders as tests of the same campaign. The names of their tests begin with the folder
    #[arg(long)]
    subfolders: bool,
    /// Reject files that are not records, and tests with a fault of their own (too short, no motion, clipped), instead of leaving them out
    #[arg(long)]
    strict: bool,
}

/// Known errors of the sensors.
#[derive(Args, Debug, Clone)]
struct SensorArgs {
    /// Delay of the force channel relative to the motion, s; corrected
    #[arg(long, value_name = "S", value_parser = seconds, default_value_t = 0.0, allow_negative_numbers = true)]
    delay: f64,
    /// Zero offset of the force channel, N, in the file's direction; subtracted
    #[arg(long, value_name = "N", value_parser = newtons, default_value_t = 0.0, allow_negative_numbers = true)]
    force_zero: f64,
    /// Reading of the displacement channel at the desired zero, m, in the file's direction; subtracted
    #[arg(long, value_name = "M", value_parser = metres, default_value_t = 0.0, allow_negative_numbers = true)]
    displacement_zero: f64,
    /// Factor on the force after subtraction of its zero, or on another channel, such as displacement=1.02
    #[arg(long, value_name = "[CHANNEL=]FACTOR")]
    gain: Vec<String>,
    /// Mass between load cell and damper that moves with the damper's end (eye, clamp, joint), kg, 0 or more. Its inertia force is subtracted
    #[arg(long, value_name = "KG", default_value_t = 0.0, allow_negative_numbers = true)]
    rig_mass: f64,
}

impl SensorArgs {
    /// Arguments for sensors that need no corrections.
    const NONE: SensorArgs =
        SensorArgs { delay: 0.0, force_zero: 0.0, displacement_zero: 0.0, gain: Vec::new(), rig_mass: 0.0 };

    fn apply(&self, options: &mut Options) -> anyhow::Result<()> {
        options.delay_s = self.delay;
        options.force_zero_n = self.force_zero;
        options.displacement_zero_m = self.displacement_zero;
        for text in &self.gain {
            let (channel, factor) = match text.contains('=') {
                true => assignment(text).map_err(anyhow::Error::msg).context("--gain")?,
                false => (Channel::Force, text.as_str()),
            };
            let factor: f64 = factor.parse().map_err(|_| anyhow::anyhow!("--gain takes a factor, not {factor:?}"))?;
            match channel {
                Channel::Force => options.gain = factor,
                other => drop(options.gains.insert(other, factor)),
            }
        }
        options.rig_mass_kg = self.rig_mass;
        options.check().map_err(anyhow::Error::msg)
    }
}

/// Columns of the channels, and their units.
#[derive(Args, Debug, Clone, Default)]
pub struct ColumnArgs {
    /// Unit of a channel whose heading states none, such as force=kN
    #[arg(long, value_name = "CHANNEL=UNIT")]
    unit: Vec<String>,
    /// Heading of a channel's column, with or without its unit, or the column's number from 1: force="Load Cell 1", force=3
    #[arg(long, value_name = "CHANNEL=HEADING")]
    column: Vec<String>,
    /// Channel to ignore, such as velocity
    #[arg(long, value_name = "CHANNEL")]
    ignore: Vec<String>,
}

impl ColumnArgs {
    /// Converts the arguments to options of the reader. The reader determines all other options from the files.
    pub fn options(&self) -> anyhow::Result<Options> {
        let mut options = Options::default();
        for text in &self.unit {
            let (channel, unit) = assignment(text).map_err(anyhow::Error::msg).context("--unit")?;
            options.units.insert(channel, unit.parse().map_err(anyhow::Error::msg).context("--unit")?);
        }
        for text in &self.column {
            let (channel, heading) = assignment(text).map_err(anyhow::Error::msg).context("--column")?;
            options.columns.insert(channel, heading.to_owned());
        }
        for text in &self.ignore {
            options.ignore.insert(text.parse().map_err(anyhow::Error::msg).context("--ignore")?);
        }
        Ok(options)
    }
}

impl DataArgs {
    /// Makes the arguments for the records of a folder, without further options.
    pub fn folder(path: PathBuf) -> DataArgs {
        DataArgs {
            data: vec![path],
            positive: None,
            flip: vec![],
            columns: ColumnArgs::default(),
            sensors: SensorArgs::NONE,
            sample_rate: None,
            dates: None,
            initial_position: 0.0,
            exclude: vec![],
            subfolders: false,
            strict: false,
        }
    }

    /// Converts the arguments to options of the reader.
    pub fn options(&self) -> anyhow::Result<Options> {
        let mut options = Options {
            positive: self.positive,
            sample_rate_hz: self.sample_rate,
            dates: self.dates,
            initial_position: self.initial_position,
            exclude: self.exclude.clone(),
            subfolders: self.subfolders,
            strict: self.strict,
            ..self.columns.options()?
        };
        self.sensors.apply(&mut options)?;
        for text in &self.flip {
            match text.as_str() {
                "force" => options.flip_force = true,
                "motion" => options.flip_motion = true,
                _ => bail!("--flip takes force or motion, not {text:?}"),
            }
        }
        Ok(options)
    }

    /// Reads and cleans the records. Warns about an uncertain sign.
    pub fn load(&self) -> anyhow::Result<Campaign> {
        let campaign = self.load_like(&self.data)?;
        print_sign(&campaign.notes);
        Ok(campaign)
    }

    /// Reads and cleans records of one damper at several settings. Warns about an uncertain sign, but not about different settings.
    pub fn load_over_setting(&self) -> anyhow::Result<Campaign> {
        let campaign = self.load_over_setting_like(&self.data)?;
        print_sign(&campaign.notes);
        Ok(campaign)
    }

    /// Reads and cleans the records at `paths`, of one damper at several settings, with these options. Prints the notes on settings that
    /// change during a record. Does not warn about an uncertain sign. Call [`print_sign`] once the signs of all campaigns agree.
    pub fn load_over_setting_like(&self, paths: &[PathBuf]) -> anyhow::Result<Campaign> {
        let is_wanted = |note: &Note| !["settings", "changing_setting"].contains(&note.kind);
        let mut campaign = self.read_noting(paths, &self.options()?, &is_wanted)?;
        campaign.accept_settings();
        for note in campaign.notes.iter().filter(|note| note.kind == "setting_over_time") {
            dashpot_output::warn(&format!("note: {}", note.text));
        }
        Ok(campaign)
    }

    /// Reads and cleans the records, and corrects the measurement errors that the fit of the model found in these records.
    pub fn load_for(&self, model: &ModelFile) -> anyhow::Result<Campaign> {
        let load = |of: &DataArgs| match model.axis.is_some() {
            true => of.load_over_setting_like(&of.data),
            false => of.load_like(&of.data),
        };
        let mut campaign = load(self)?;
        let knows = |campaign: &Campaign| campaign.records.iter().any(|record| model.identification.used(record));
        // The positive direction may be uncertain in a part of the fitted records, although the fit determined it from all of them. If only
        // the opposite direction reproduces records that the fit used, the records are read again with the opposite direction.
        let is_open = self.positive.is_none() && !model.identification.fingerprints.is_empty();
        if is_open && !knows(&campaign) && campaign.notes.iter().any(|note| note.kind == "sign_unsure") {
            let positive = campaign.sign.positive.opposite();
            let turned = load(&DataArgs { positive: Some(positive), ..self.clone() })?;
            if knows(&turned) {
                let name = positive.name();
                dashpot_output::warn(&format!(
                    "note: the fit of the model counted these very records {name} positive, so they are counted so here"
                ));
                campaign = turned;
            }
        }
        print_sign(&campaign.notes);
        restate_settings(&model.axis, &mut campaign.records)?;
        let note = model.identification.right(&mut campaign.records);
        note.iter().for_each(|note| dashpot_output::warn(&format!("note: {}", note.text)));
        campaign.notes.extend(note);
        Ok(campaign)
    }

    /// Reads and cleans the records at `paths` with these options. Does not warn about an uncertain sign. Call [`print_sign`] once the
    /// signs of all campaigns agree.
    pub fn load_like(&self, paths: &[PathBuf]) -> anyhow::Result<Campaign> {
        Ok(self.read(paths, &self.options()?)?)
    }

    /// Reads the records of the reference damper. Errors name the option `--reference`, because the reference's file names often equal
    /// those of the diagnosed damper.
    pub fn load_reference(&self, paths: &[PathBuf]) -> anyhow::Result<Campaign> {
        self.load_like(paths).map_err(|error| of_reference(error, paths))
    }

    /// Reads the records of a reference damper at several settings. Errors name the option `--reference`.
    pub fn load_reference_over_setting(&self, paths: &[PathBuf]) -> anyhow::Result<Campaign> {
        self.load_over_setting_like(paths).map_err(|error| of_reference(error, paths))
    }

    /// Reads records with the given options, and prints the notes for which [`is_shown_first`] is true, except on an uncertain sign.
    pub fn read(&self, paths: &[PathBuf], options: &Options) -> Result<Campaign, RecordError> {
        self.read_noting(paths, options, &|_| true)
    }

    /// Reads one of many campaigns. Adds the notes that [`DataArgs::read`] prints to `notes`, for [`print_notes_of_groups`].
    pub fn read_one_of_many(
        &self,
        paths: &[PathBuf],
        options: &Options,
        notes: &RefCell<Vec<Note>>,
    ) -> Result<Campaign, RecordError> {
        let campaign = self.read_noting(paths, options, &|_| false)?;
        let shown = campaign.notes.iter().filter(|note| is_shown_first(note) && note.kind != "sign_unsure");
        notes.borrow_mut().extend(shown.cloned());
        Ok(campaign)
    }

    /// Reads records, and prints the notes for which both [`is_shown_first`] and `is_wanted` are true, except on an uncertain sign.
    fn read_noting(
        &self,
        paths: &[PathBuf],
        options: &Options,
        is_wanted: &dyn Fn(&Note) -> bool,
    ) -> Result<Campaign, RecordError> {
        let progress = Progress::new("reading");
        let campaign = load(paths, options, &|p| progress.count(p.done, p.total))?;
        drop(progress);
        // These notes state which samples and channels are used and how they are interpreted, so every verb prints them before its results.
        for note in campaign.notes.iter().filter(|n| is_shown_first(n) && n.kind != "sign_unsure" && is_wanted(n)) {
            let word = if note.is_loud() { "warning" } else { "note" };
            dashpot_output::warn(&format!("{word}: {}", note.text));
        }
        Ok(campaign)
    }

    /// Formats the paths of the records as a list.
    pub fn named(&self) -> String {
        named(&self.data)
    }
}

fn of_reference(error: anyhow::Error, paths: &[PathBuf]) -> anyhow::Error {
    error.context(format!("--reference {}", named(paths)))
}

/// Formats paths as a list.
pub fn named(paths: &[PathBuf]) -> String {
    paths.iter().map(|p| p.display().to_string()).collect::<Vec<_>>().join(", ")
}

/// Returns whether a note of this kind is printed when the records are read, before the results of a verb.
pub fn is_shown_first(note: &Note) -> bool {
    [
        "gap",
        "rests",
        "left_out",
        "subfolders",
        "late",
        "exchanged",
        "profile",
        "clock",
        "duplicated",
        "no_force",
        "small",
        "zero",
        "torn",
        "sign_unsure",
        "settings",
        "setting_name",
        "changing_setting",
        "setting_over_time",
        "cut_off",
        "stale",
        "late_velocity",
    ]
    .contains(&note.kind)
}

/// Warns if the positive direction of the files is uncertain.
pub fn print_sign<'a>(notes: impl IntoIterator<Item = &'a Note>) {
    for note in notes.into_iter().filter(|note| note.kind == "sign_unsure") {
        dashpot_output::warn(&format!("warning: {}", note.text));
    }
}

/// Prints the notes on many campaigns. Notes that differ only in names and numbers are printed once, with the number of the others, so that
/// the output stays short. Warnings are printed for each campaign.
pub fn print_notes_of_groups(notes: &[Note]) {
    let (loud, quiet): (Vec<&Note>, Vec<&Note>) = notes.iter().partition(|note| note.is_loud());
    for note in loud {
        dashpot_output::warn(&format!("warning: {}", note.text));
    }
    let mut first: Vec<(&Note, usize)> = Vec::new();
    for note in quiet {
        match first.iter_mut().find(|(known, _)| known.text.template() == note.text.template()) {
            Some((_, others)) => *others += 1,
            None => first.push((note, 0)),
        }
    }
    for (note, others) in first {
        let more = if others == 0 { String::new() } else { format!(" (and {others} more such notes)") };
        dashpot_output::warn(&format!("note: {}{more}", note.text));
    }
}

/// Returns the name of a file without its folder.
pub fn name_of(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned())
}
