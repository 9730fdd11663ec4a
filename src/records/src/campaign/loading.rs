//! Loads the records of a campaign: finds the files, reads and cleans them in parallel, determines the sign.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::path::PathBuf;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::file_search::{Below, Excluded, File, Found, file_name, find};
use super::profile;
use super::record_file::read_file;
use super::unusable::{self, FaultFilter, Unusable};
use super::{common_clock, date_agreement};
use crate::checks::sign::{self, SignFinding};
use crate::checks::{deviating_tests, force_levels, force_offset, plausibility, truncated_test, unit_magnitude};
use crate::cleaning;
use crate::data::complete_test::CompleteTest;
use crate::data::record::{Note, Record};
use crate::data::rig_frame::RigFrame;
use crate::data::samples::Samples;
use crate::data::setting_signal::SettingSignal;
use crate::error::{ColumnError, RecordError, SelectionError};
use crate::messages::phrases;
use crate::options::{Options, Positive};
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use crate::settings::{assignment, unstated_settings};
use crate::signal::delay::Delay;
use dashpot_messages::Sentence;

/// The records of a campaign, cleaned, in SI, rebound and tension positive.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Campaign {
    /// One record per test, in natural order of the file names, then in the order within the file.
    pub records: Vec<Record>,
    /// Positive direction of the files, and the confidence in it.
    pub sign: SignFinding,
    /// Delay of the force relative to the motion, if significant. The records are not shifted by it.
    pub delay: Option<Delay>,
    /// Notes about the campaign as a whole.
    pub notes: Vec<Note>,
    /// Files and tests that could not be used, each with its reason. The notes also report the first of them.
    pub unusable: Vec<Unusable>,
    /// Every file that was read, including profiles, in the order of reading.
    #[serde(skip)]
    pub files: Vec<PathBuf>,
}

impl Campaign {
    /// Adds the unusable files and tests of another campaign that is compared with this one, with notes about them.
    pub fn also_without(&mut self, others: Vec<Unusable>) {
        self.notes.extend(unusable::notes(&others));
        self.unusable.extend(others);
    }

    /// Accepts the records as those of one damper at several settings. Removes the warnings about several settings, and
    /// adds notes about changes of the setting within a test.
    pub fn accept_settings(&mut self) {
        self.notes.retain(|note| !["settings", "changing_setting"].contains(&note.kind));
        let mut changes: Vec<(Sentence, Vec<usize>)> = Vec::new();
        for (place, record) in self.records.iter().enumerate() {
            let Some(change) = record.setting_signal.as_ref().map(SettingSignal::describe) else { continue };
            match changes.iter_mut().find(|(known, _)| *known == change) {
                Some((_, tests)) => tests.push(place),
                None => changes.push((change, vec![place])),
            }
        }
        let names: Vec<&str> = self.records.iter().map(|record| record.name.as_str()).collect();
        let notes = changes.into_iter().map(|(change, tests)| {
            let named = unstated_settings::together(&names, &tests);
            let text = Sentence::from(phrases::OF_FILE).with_sentence("file", named).with_sentence("text", change);
            Note { kind: "setting_over_time", text }
        });
        let notes: Vec<Note> = notes.collect();
        self.notes.splice(0..0, notes);
    }
}

/// Progress of loading.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Number of finished steps. Reading a file is one step, and cleaning a test is one step.
    pub done: usize,
    /// Total number of steps. Each file that is read adds a step for each of its tests. The number is final once all
    /// files are read and split. It then includes the parts of split tests, but not the excluded tests.
    pub total: usize,
}

/// Loads files and folders as one campaign.
///
/// A folder means all record files directly in it. With [`Options::subfolders`] it includes the record files in its
/// subfolders. `campaign.toml` in a records folder supplies the entries that `options` lack. The campaign leaves out
/// faulty tests and files that are not records, and notes report them. With [`Options::strict`] they are errors.
/// `progress` is called from several threads, once per finished step. The result does not depend on the number of
/// threads.
///
/// # Errors
/// [`RecordError`] if the records require a decision of the user, or if no usable record remains.
pub fn load(
    paths: &[PathBuf],
    options: &Options,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Campaign, RecordError> {
    if let Some(&channel) = [Channel::Time, Channel::Force].iter().find(|c| options.ignore.contains(c)) {
        return Err(SelectionError::Indispensable { channel }.into());
    }
    let mut notes = Vec::new();
    let Found { files, folders, below, mut excluded } = find(paths, options, &mut notes)?;
    let given = options;
    let options = &whole(given, &folders)?;
    let counter = Counter::new(files.len(), progress);
    let read = read_all(&files, &counter);
    // If no file is readable but subfolders contain records, the user likely means the subfolders, so the error names
    // them.
    let strays_alone = excluded.count == 0 && read.iter().all(Result::is_err);
    if let (true, Some(below)) = (strays_alone, below.first()) {
        return Err(below.to_error());
    }
    let mut filter = FaultFilter::new(options.strict);
    let mut tests = select_tests(&files, read, &mut excluded, &mut filter)?;
    if let Some(pattern) = given.exclude.iter().find(|p| !excluded.patterns.contains(*p)) {
        let first = files.first().map_or_else(String::new, |f| file_name(&f.path));
        return Err(SelectionError::ExcludesNothing { pattern: pattern.clone(), first }.into());
    }
    if tests.is_empty() && filter.is_empty() {
        return Err(SelectionError::ExcludesAll { count: excluded.count }.into());
    }
    date_agreement::decide_order(&mut tests, &mut notes);
    notes.extend(below.iter().map(Below::note));
    let pieces = sort_out(tests, &mut filter)?;
    counter.expect(files.len() + pieces.len());
    let units = FileUnits::collect(&pieces);
    let mut motions = mend(pieces, &counter, &mut filter)?;
    tell_splits(&motions, &mut notes);
    let mut of_the_sign = Vec::new();
    let (sign, delay) = sign::determine(&mut motions, options, &mut of_the_sign)?;
    let mut records = finish(motions, options, (&sign, delay), &mut filter)?;
    let unusable = filter.report(&mut notes);
    notes.append(&mut of_the_sign);
    unique_names(&mut records);
    assign_settings(&mut records, options, &mut notes)?;
    common_clock::assign(&mut records, &mut notes);
    check(&mut records, options, &units, sign.positive, &mut notes)?;
    let profiles = folders.iter().map(|(folder, _)| folder.join(profile::FILE));
    let files = profiles.chain(files.iter().map(|file| file.path.clone())).collect();
    Ok(Campaign { records, sign, delay, notes, unusable, files })
}

/// Test or piece of a test, with the options of its file.
type WithOptions<'a, T> = (&'a Options, T);

/// Reads every file, also after an error, so that the first error does not depend on the threads.
fn read_all(files: &[File], counter: &Counter) -> Vec<Result<Vec<Samples>, RecordError>> {
    let read = files.par_iter().map(|file| {
        let tests = read_file(&file.path, &file.options);
        counter.step(tests.as_ref().map_or(0, Vec::len));
        tests
    });
    read.collect()
}

/// Returns the tests that the user does not exclude.
fn select_tests<'a>(
    files: &'a [File],
    read: Vec<Result<Vec<Samples>, RecordError>>,
    excluded: &mut Excluded,
    filter: &mut FaultFilter,
) -> Result<Vec<WithOptions<'a, Samples>>, RecordError> {
    let mut tests = Vec::new();
    for (file, read) in files.iter().zip(read) {
        let mut read = filter.pass(read)?.unwrap_or_default();
        read.iter_mut().for_each(|test| test.name.insert_str(0, &file.within));
        let kept = read.into_iter().filter(|test| !excluded.takes(&file.options, &test.name));
        tests.extend(kept.map(|test| (&*file.options, test)));
    }
    Ok(tests)
}

/// Orders the rows of the tests and splits tests that are interrupted.
fn sort_out<'a>(
    tests: Vec<WithOptions<'a, Samples>>,
    filter: &mut FaultFilter,
) -> Result<Vec<WithOptions<'a, Samples>>, RecordError> {
    let sorted: Vec<WithOptions<Result<Vec<Samples>, RecordError>>> =
        tests.into_par_iter().map(|(options, test)| (options, cleaning::sort_out(test, options))).collect();
    let mut pieces = Vec::new();
    for (options, sorted) in sorted {
        pieces.extend(filter.pass(sorted)?.unwrap_or_default().into_iter().map(|piece| (options, piece)));
    }
    Ok(pieces)
}

/// Repairs the pieces and completes their motion.
fn mend(
    pieces: Vec<WithOptions<Samples>>,
    counter: &Counter,
    filter: &mut FaultFilter,
) -> Result<Vec<CompleteTest>, RecordError> {
    let reach = pieces.iter().fold(cleaning::Reach::default(), |reach, (_, piece)| reach.with(piece));
    let mended: Vec<Result<CompleteTest, RecordError>> = pieces
        .into_par_iter()
        .map(|(options, test)| {
            let mended = cleaning::mend(test, options, &reach);
            counter.step(0);
            mended
        })
        .collect();
    let motions: Vec<CompleteTest> =
        mended.into_iter().map(|m| filter.pass(m)).filter_map(Result::transpose).collect::<Result<_, _>>()?;
    filter.reject_most(motions.len())?;
    Ok(motions)
}

/// Makes the records from the cleaned tests. `rig` is the sign convention of the files and the delay of the force.
fn finish(
    motions: Vec<CompleteTest>,
    options: &Options,
    rig: (&SignFinding, Option<Delay>),
    filter: &mut FaultFilter,
) -> Result<Vec<Record>, RecordError> {
    let (counted, delay_s) = (rig.0.counted(), rig.1.map_or(0.0, |delay| delay.seconds));
    let finished: Vec<Result<Record, RecordError>> = motions
        .into_par_iter()
        .map(|motion| {
            let mut record = cleaning::finish(motion)?;
            record.counted = Some(counted);
            record.apparent_delay_s = delay_s;
            plausibility::reject_absurd(&record, options)?;
            Ok(record)
        })
        .collect();
    let records: Vec<Record> =
        finished.into_iter().map(|r| filter.pass(r)).filter_map(Result::transpose).collect::<Result<_, _>>()?;
    filter.reject_most(records.len())?;
    Ok(records)
}

/// Assigns the settings that the user, the tests or their names state.
fn assign_settings(records: &mut [Record], options: &Options, notes: &mut Vec<Note>) -> Result<(), RecordError> {
    let is_without = records.iter().all(|record| record.setting.is_none() && record.setting_signal.is_none());
    if let Some(wanted) = options.columns.get(&Channel::Setting).filter(|_| is_without && !records.is_empty()) {
        return Err(ColumnError::NoSettingColumn { wanted: wanted.clone() }.into());
    }
    assignment::assign_settings(records, &options.settings, notes);
    Ok(())
}

/// Units in which the files were read.
struct FileUnits<'a> {
    /// Units and options of each test. The key is the location of the test, as text.
    readings: HashMap<String, deviating_tests::Reading<'a>>,
    /// Whether a motion is in inches.
    has_inches: bool,
}

impl<'a> FileUnits<'a> {
    fn collect(pieces: &[WithOptions<'a, Samples>]) -> FileUnits<'a> {
        let readings = pieces.iter().map(|(options, piece)| {
            (piece.at.to_string(), deviating_tests::Reading { units: piece.units.clone(), options })
        });
        let has_inches = pieces.iter().any(|(_, piece)| {
            let units = [(Channel::Displacement, Unit::Inch), (Channel::Velocity, Unit::InchPerSecond)];
            piece.units.iter().any(|unit| units.contains(unit))
        });
        FileUnits { readings: readings.collect(), has_inches }
    }
}

/// Checks units, magnitudes and forces of the records against each other, and stores the frame of the rig in each
/// record.
fn check(
    records: &mut [Record],
    options: &Options,
    units: &FileUnits,
    positive: Positive,
    notes: &mut Vec<Note>,
) -> Result<(), RecordError> {
    unit_magnitude::reject(records, options)?;
    deviating_tests::check(records, &units.readings, notes)?;
    let frame = rig_frame(records, positive, options, units.has_inches);
    records.iter_mut().for_each(|record| record.frame = frame);
    plausibility::remark(records, options, notes)?;
    let in_the_middle = force_levels::in_the_middle(records);
    force_offset::report(records, &in_the_middle, notes);
    unstated_settings::report(records, &in_the_middle, notes);
    truncated_test::report(records, notes);
    Ok(())
}

/// Returns the rig's sign convention, displacement zero and ranges of motion, from the records of a campaign and its
/// options.
fn rig_frame(records: &[Record], positive: Positive, options: &Options, counts_inches: bool) -> RigFrame {
    let direction = if positive == Positive::Compression { -1.0 } else { 1.0 };
    let flipped = if options.flip_motion { -1.0 } else { 1.0 };
    let all = || records.iter().flat_map(|record| record.displacement.iter().copied());
    RigFrame {
        turn: direction * flipped,
        zero_m: options.displacement_zero_m,
        gain: options.gains.get(&Channel::Displacement).copied().unwrap_or(1.0),
        unit: if counts_inches { Unit::Inch } else { Unit::Millimetre },
        reach_m: (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)),
        speed_m_s: records.iter().map(|record| record.peak_velocity).fold(0.0, f64::max),
    }
}

/// Kinds of test notes that concern the file or its division into tests.
const OF_THE_FILE: [&str; 6] = ["gap", "rests", "cut_off", "stale", "late_velocity", "changing_setting"];

/// Largest number of files with a note of the same kind that have a note each. If more files have it, one note names the
/// first files.
const NOTED: usize = 3;

/// Copies the notes about files and their division into tests to the front of the campaign's notes. Equal notes of one
/// file appear once, and notes of one kind from many files become one.
fn tell_splits(motions: &[CompleteTest], notes: &mut Vec<Note>) {
    let mut told: Vec<(String, &Note)> = Vec::new();
    for motion in motions {
        let file = motion.at.file.display().to_string();
        for note in motion.notes.iter().filter(|n| OF_THE_FILE.contains(&n.kind)) {
            if told.iter().all(|(of, n)| *of != file || n.text != note.text) {
                told.push((file.clone(), note));
            }
        }
    }
    let mut files: HashMap<&str, BTreeSet<&str>> = HashMap::new();
    for (file, note) in &told {
        files.entry(note.kind).or_default().insert(file);
    }
    let mut grouped: Vec<Note> = Vec::new();
    for (file, note) in &told {
        let own = Sentence::from(phrases::OF_FILE).with("file", file).with_sentence("text", note.text.clone());
        let files = &files[note.kind];
        let text = if files.len() <= NOTED {
            own
        } else if grouped.iter().all(|earlier| earlier.kind != note.kind) {
            let names: Vec<&str> = files.iter().take(NOTED).copied().collect();
            Sentence::from(phrases::OF_FILES)
                .with("count", files.len())
                .with_names("names", names, phrases::COMMA)
                .with_sentence("text", own)
        } else {
            continue;
        };
        grouped.push(Note { kind: note.kind, text });
    }
    notes.splice(0..0, grouped);
}

/// Returns the options of the campaign as a whole: the given options, completed by the profile if there is only one.
/// With several profiles, only their common positive direction is added. It is an error if the profiles state different
/// directions and the given options state none.
fn whole(options: &Options, folders: &[(PathBuf, Options)]) -> Result<Options, RecordError> {
    let mut whole = options.clone();
    if let [(_, only)] = folders {
        whole = whole.over(only);
    }
    let mut said = folders.iter().filter_map(|(folder, of)| of.positive.map(|p| (folder, p)));
    if let (None, Some((first, positive))) = (options.positive, said.next()) {
        if let Some((second, _)) = said.find(|(_, other)| *other != positive) {
            return Err(SelectionError::ProfilesDisagree {
                first: first.join(profile::FILE),
                second: second.join(profile::FILE),
            }
            .into());
        }
        whole.positive = Some(positive);
    }
    whole.strict = options.strict;
    Ok(whole)
}

/// Counts finished steps for the caller's progress display.
struct Counter<'a> {
    done: std::sync::atomic::AtomicUsize,
    total: std::sync::atomic::AtomicUsize,
    report: &'a (dyn Fn(Progress) + Sync),
}

impl<'a> Counter<'a> {
    fn new(total: usize, report: &'a (dyn Fn(Progress) + Sync)) -> Self {
        Counter { done: 0.into(), total: total.into(), report }
    }

    /// Sets the total number of steps.
    fn expect(&self, total: usize) {
        self.total.store(total, std::sync::atomic::Ordering::Relaxed);
    }

    fn step(&self, new_steps: usize) {
        use std::sync::atomic::Ordering::Relaxed;
        let total = self.total.fetch_add(new_steps, Relaxed) + new_steps;
        let done = self.done.fetch_add(1, Relaxed) + 1;
        (self.report)(Progress { done, total });
    }
}

/// Appends a number to repeated names of records from different files, so that every name is unique.
fn unique_names(records: &mut [Record]) {
    let mut taken: HashSet<String> = HashSet::with_capacity(records.len());
    // Next number to try, by name.
    let mut next: HashMap<String, usize> = HashMap::new();
    for record in records {
        if taken.contains(&record.name) {
            let number = next.entry(record.name.clone()).or_insert(2);
            let name = loop {
                let name = format!("{} ({number})", record.name);
                *number += 1;
                if !taken.contains(&name) {
                    break name;
                }
            };
            record.name = name;
        }
        taken.insert(record.name.clone());
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    use super::*;
    use crate::fixtures::SineTest;

    fn quiet(_: Progress) {}

    /// Makes a folder with the given files.
    fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in files {
            fs::write(folder.path().join(name), text).unwrap();
        }
        folder
    }

    fn load_folder(folder: &tempfile::TempDir, options: &Options) -> Result<Campaign, RecordError> {
        load(&[folder.path().to_path_buf()], options, &quiet)
    }

    fn sine(frequency: f64) -> String {
        SineTest { frequency, seed: (1e3 * frequency) as u64, ..SineTest::default() }.csv()
    }

    #[test]
    fn a_folder_is_a_campaign_in_natural_order() {
        let folder = folder(&[
            ("test10.csv", &sine(2.0)),
            ("test2.csv", &sine(0.5)),
            ("Test1.csv", &sine(0.02)),
            (".hidden.csv", "rubbish"),
            ("~$open.xlsx", "rubbish"),
            ("README.md", "about"),
            ("campaign.toml", ""),
        ]);
        let calls = AtomicUsize::new(0);
        let progress = |p: Progress| {
            assert!(p.done >= 1);
            calls.fetch_add(1, Relaxed);
        };
        let campaign = load(&[folder.path().to_path_buf()], &Options::default(), &progress).unwrap();
        assert_eq!(campaign.records.iter().map(|r| r.name.as_str()).collect::<Vec<_>>(), ["Test1", "test2", "test10"]);
        assert_eq!(calls.load(Relaxed), 6); // three files, three tests
        assert_eq!(campaign.sign.positive, crate::Positive::Rebound);
        let note = &campaign.notes[0];
        assert!(note.kind == "ignored" && note.text.to_string().ends_with("README.md"), "{}", note.text);
        assert!(!note.text.to_string().contains("hidden"));
        for (record, frequency) in campaign.records.iter().zip([0.02, 0.5, 2.0]) {
            assert_eq!(record.cycles.len(), 5);
            assert!((record.frequency / frequency - 1.0).abs() < 2e-3, "{}", record.frequency);
            assert!((record.noise.force_rms / 4.0 - 1.0).abs() < 0.1);
        }
    }

    #[test]
    fn the_result_does_not_depend_on_the_number_of_threads() {
        let files: Vec<(String, String)> = (1..8).map(|k| (format!("t{k}.csv"), sine(0.3 * f64::from(k)))).collect();
        let files: Vec<(&str, &str)> = files.iter().map(|(a, b)| (a.as_str(), b.as_str())).collect();
        let folder = folder(&files);
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            format!("{:?}", pool.install(|| load_folder(&folder, &Options::default()).unwrap()))
        };
        assert!(with(1) == with(4));
    }

    #[test]
    fn one_file_with_several_tests_gives_one_record_each() {
        let mut text = String::from("Test No;Time [ms];Stroke [mm];Force [kN]\n");
        for (name, frequency) in [("A7", 0.5), ("A8", 2.0)] {
            let samples = SineTest { frequency, ..SineTest::default() }.samples();
            let x = samples.displacement.as_ref().unwrap();
            for ((t, x), f) in samples.time.iter().zip(x).zip(&samples.force) {
                let row = format!("{name};{:.3};{:.6};{:.7}\n", 1e3 * t, 1e3 * x, 1e-3 * f);
                text.push_str(&row.replace('.', ","));
            }
        }
        let folder = folder(&[("all.csv", &text)]);
        let last = std::sync::Mutex::new((0, 0));
        let tell = |progress: Progress| {
            let mut last = last.lock().unwrap();
            *last = (*last).max((progress.done, progress.total));
        };
        let campaign = load(&[folder.path().to_path_buf()], &Options::default(), &tell).unwrap();
        // There are three steps: reading the file, and cleaning each of its two tests.
        assert_eq!(*last.lock().unwrap(), (3, 3));
        assert_eq!(campaign.records.iter().map(|r| r.name.as_str()).collect::<Vec<_>>(), ["A7", "A8"]);
        assert!(campaign.records[1].source.ends_with("all.csv (test 'A8')"));
        assert!((campaign.records[1].amplitude - 0.05).abs() < 2e-4);
        let notes = &campaign.records[0].notes;
        assert!(notes.iter().any(|n| n.kind == "converted") && notes.iter().any(|n| n.kind == "derived"));
    }

    #[test]
    fn records_of_equal_name_are_told_apart() {
        let (one, two) = (folder(&[("a.csv", &sine(1.0))]), folder(&[("a.csv", &sine(2.0))]));
        let other_way = one.path().join("..").join(one.path().file_name().unwrap()).join("a.csv");
        let paths = [one.path().join("a.csv"), two.path().to_path_buf(), one.path().join("a.csv"), other_way];
        let campaign = load(&paths, &Options::default(), &quiet).unwrap();
        assert_eq!(campaign.records.iter().map(|r| r.name.as_str()).collect::<Vec<_>>(), ["a", "a (2)"]);
    }

    #[test]
    fn what_cannot_be_read_is_refused_with_the_file_named() {
        let message =
            |files: &[(&str, &str)]| load_folder(&folder(files), &Options::default()).unwrap_err().to_string();
        assert!(message(&[("notes.pdf", "")]).contains("holds no record"));
        assert!(message(&[("notes.txt", "")]).contains("notes.txt: is empty (0 bytes)"));
        assert!(message(&[("a.csv", "alpha,beta\n1,2\n")]).contains("a.csv: no header line"));
        assert!(message(&[("a.csv", "time_s,x_mm,force_N\n")]).contains("a.csv: has a header but no data"));
        assert!(message(&[("a.csv", "time_s,x_mm,force_N\n1,2,3\n")]).contains("only 1 usable sample;"));
        // The message names the first bad file in order, even if another thread finds a fault earlier.
        let files = [("a1.csv", sine(1.0)), ("a2.csv", "x\n".into()), ("a10.csv", "y\n".into())];
        let files: Vec<(&str, &str)> = files.iter().map(|(name, text)| (*name, text.as_str())).collect();
        let strict = Options { strict: true, ..Options::default() };
        assert!(load_folder(&folder(&files), &strict).unwrap_err().to_string().contains("a2.csv"));
        let folder = folder(&[("a.pdf", "")]);
        let path = |name: &str| load(&[folder.path().join(name)], &Options::default(), &quiet).unwrap_err().to_string();
        assert!(path("missing.csv").contains("missing.csv: there is no such file"));
        assert!(path("a.pdf").contains("a.pdf: is no record"));
        assert!(load(&[], &Options::default(), &quiet).unwrap_err().to_string().contains("no record given"));
    }

    #[test]
    fn strays_are_named_and_left_out() {
        let (good, stub) = (sine(1.0), "time_s,x_mm,force_N\n1,2,3\n");
        let files = [
            ("a.csv", good.as_str()),
            ("b.csv", "alpha,beta\n1,2\n"),
            ("c.csv", ""),
            ("d.csv", stub),
            ("e.xlsx", "no workbook"),
            ("readme.txt", "about this folder\n"),
        ];
        let campaign = load_folder(&folder(&files), &Options::default()).unwrap();
        assert_eq!(campaign.records.len(), 1);
        let told: Vec<String> =
            campaign.notes.iter().filter(|n| n.kind == "left_out").map(|n| n.text.to_string()).collect();
        assert_eq!(told.len(), 5, "{told:?}");
        for (name, why) in [
            ("b.csv", "no header line"),
            ("c.csv", "is empty"),
            ("d.csv", "only 1 usable"),
            ("e.xlsx", "workbook"),
            ("readme.txt", "header"),
        ] {
            assert!(told.iter().any(|t| t.contains(name) && t.contains(why)), "{name}: {told:?}");
        }
        // If a record requires a decision of the user, the campaign is rejected instead of leaving the record out.
        let unit = good.replace("force_N", "force");
        let files = [("a.csv", good.as_str()), ("b.csv", unit.as_str())];
        assert!(
            load_folder(&folder(&files), &Options::default()).unwrap_err().to_string().contains("'force' has no unit")
        );
    }

    #[test]
    fn records_in_subfolders_are_told_of_and_read_where_they_are_asked_for() {
        let tests = |folder: &tempfile::TempDir| {
            for (sub, name, frequency) in [("sine", "a", 1.0), ("sine", "b", 2.0), ("tri/slow", "a", 0.5)] {
                fs::create_dir_all(folder.path().join(sub)).unwrap();
                fs::write(folder.path().join(sub).join(format!("{name}.csv")), sine(frequency)).unwrap();
            }
            fs::create_dir_all(folder.path().join("pictures")).unwrap();
            fs::write(folder.path().join("pictures/a.jpg"), "").unwrap();
        };
        let deep = Options { subfolders: true, ..Options::default() };
        let names = |campaign: &Campaign| campaign.records.iter().map(|r| r.name.clone()).collect::<Vec<_>>();
        // The folder contains subfolders alone, then also a results table and a text, which are not records.
        for strays in
            [&[][..], &[("results.csv", "v [m/s];pull [N];push [N]\n0.1;200;90\n"), ("notes.txt", "cold start\n")]]
        {
            let folder = folder(strays);
            tests(&folder);
            let message = load_folder(&folder, &Options::default()).unwrap_err().to_string();
            assert!(message.contains("sine, tri") && message.contains("--subfolders"), "{message}");
            // A link to a folder of the campaign adds no record.
            #[cfg(unix)]
            std::os::unix::fs::symlink(folder.path().join("sine"), folder.path().join("tri/again")).unwrap();
            #[cfg(unix)]
            std::os::unix::fs::symlink(folder.path(), folder.path().join("tri/slow/above")).unwrap();
            let campaign = load_folder(&folder, &deep).unwrap();
            assert_eq!(names(&campaign), ["sine/a", "sine/b", "tri/slow/a"]);
            let left_out = |n: &&Note| n.kind == "left_out";
            assert_eq!(campaign.notes.iter().filter(left_out).count(), strays.len(), "{:?}", campaign.notes);
            assert!(campaign.notes.iter().any(|n| n.text.to_string().contains("pictures")));
            // A pattern may contain the name of the subfolder.
            let without = Options { exclude: vec!["sine/*".into()], ..deep.clone() };
            assert_eq!(names(&load_folder(&folder, &without).unwrap()), ["tri/slow/a"]);
        }
        // If the folder contains records of its own, a note mentions the subfolders. A profile can include them.
        let folder = folder(&[("own.csv", &sine(3.0))]);
        tests(&folder);
        let campaign = load_folder(&folder, &Options::default()).unwrap();
        assert_eq!(names(&campaign), ["own"]);
        let told = campaign.notes.iter().find(|n| n.kind == "subfolders").unwrap().text.to_string();
        assert!(told.contains("3 files") && told.contains("sine, tri") && !told.contains("pictures"), "{told}");
        let profile = "format = \"dashpot campaign profile 1\"\nsubfolders = true\n";
        fs::write(folder.path().join("campaign.toml"), profile).unwrap();
        assert_eq!(
            names(&load_folder(&folder, &Options::default()).unwrap()),
            ["own", "sine/a", "sine/b", "tri/slow/a"]
        );
    }

    #[test]
    fn files_of_text_in_folders_are_records_whatever_their_ending() {
        let texts: Vec<String> = [0.5, 1.0, 2.0, 3.0].iter().map(|f| sine(*f).replace(',', "\t")).collect();
        let blanks = texts[3].replace('\t', "   ");
        let files = [
            ("a.txt", texts[0].as_str()),
            ("b.asc", &texts[1]),
            ("c.dat", &texts[2]),
            ("d.tsv", &texts[3]),
            ("e.txt", &blanks),
        ];
        assert_eq!(load_folder(&folder(&files), &Options::default()).unwrap().records.len(), 5);
    }

    #[test]
    fn patterns_leave_files_and_tests_out() {
        let (a, b) = (sine(1.0), sine(2.0));
        let folder = folder(&[("warmup1.csv", &a), ("t1.csv", &b)]);
        let with = |patterns: &[&str]| {
            let exclude = patterns.iter().map(ToString::to_string).collect();
            load_folder(&folder, &Options { exclude, ..Options::default() })
        };
        assert_eq!(with(&["warm*"]).unwrap().records.len(), 1);
        assert_eq!(with(&["t1.csv"]).unwrap().records[0].name, "warmup1");
        let message = with(&["none*"]).unwrap_err().to_string();
        assert!(message.contains("none*") && message.contains("t1.csv"), "{message}");
        assert!(with(&["*"]).unwrap_err().to_string().contains("leaves no record"));
    }

    #[test]
    fn a_profile_beside_the_records_is_obeyed() {
        let text = sine(1.0).replace("time_s,displacement_m,velocity_m_s,force_N", "A,B,C,D");
        let profile = "format = \"dashpot campaign profile 1\"\nexclude = [\"warm*\"]\npositive = \"compression\"\n\
                       columns = { time = \"A\", displacement = \"B\", velocity = \"C\", force = \"4\" }\n\
                       units = { time = \"s\", displacement = \"m\", velocity = \"m/s\", force = \"N\" }\n";
        let files = [("a.csv", text.as_str()), ("warmup.csv", text.as_str()), ("campaign.toml", profile)];
        let folder = folder(&files);
        for path in [folder.path().to_path_buf(), folder.path().join("a.csv")] {
            let campaign = load(&[path], &Options::default(), &quiet).unwrap();
            assert_eq!(campaign.records.len(), 1);
            assert!(campaign.sign.is_stated && campaign.sign.positive == crate::Positive::Compression);
            assert!(campaign.notes.iter().any(|n| n.kind == "profile" && n.text.to_string().contains("campaign.toml")));
        }
        // The option of the command line has precedence over the profile.
        let options = Options { positive: Some(crate::Positive::Rebound), ..Options::default() };
        assert_eq!(load_folder(&folder, &options).unwrap().sign.positive, crate::Positive::Rebound);
        // The profiles of two folders contradict each other.
        let other = tempfile::tempdir().unwrap();
        fs::write(other.path().join("b.csv"), &text).unwrap();
        fs::write(other.path().join("campaign.toml"), profile.replace("compression", "rebound")).unwrap();
        let paths = [folder.path().to_path_buf(), other.path().to_path_buf()];
        assert!(load(&paths, &Options::default(), &quiet).unwrap_err().to_string().contains("different directions"));
    }

    #[test]
    fn a_profile_that_ignores_what_no_record_can_do_without_is_refused() {
        let text = sine(1.0);
        for channel in ["force", "time"] {
            let profile = format!("format = \"dashpot campaign profile 1\"\nignore = [\"{channel}\"]\n");
            let folder = folder(&[("a.csv", text.as_str()), ("campaign.toml", profile.as_str())]);
            let message = load_folder(&folder, &Options::default()).unwrap_err().to_string();
            assert!(message.contains("campaign.toml") && message.contains("cannot be left out"), "{message}");
        }
    }

    #[test]
    fn gaps_are_said_first() {
        let mut text = String::from("time_s,displacement_m,force_N\n");
        let samples = SineTest::default().samples();
        for (i, ((t, x), f)) in
            samples.time.iter().zip(samples.displacement.as_ref().unwrap()).zip(&samples.force).enumerate()
        {
            let t = if 2 * i > samples.time.len() { t + 5.0 } else { *t };
            text += &format!("{t:.6},{x:.9},{f:.4}\n");
        }
        let campaign = load_folder(&folder(&[("a.csv", &text), ("z.pdf", "")]), &Options::default()).unwrap();
        assert_eq!(campaign.records.iter().map(|r| r.name.as_str()).collect::<Vec<_>>(), ["a part 1", "a part 2"]);
        assert!(
            campaign.notes[0].kind == "gap" && campaign.notes[0].text.to_string().contains("a.csv: gaps in time: 5.0")
        );
    }

    #[test]
    fn compression_positive_files_end_rebound_positive() {
        let mut text = String::from("time_s,displacement_m,force_N\n");
        let samples = SineTest::default().samples();
        for ((t, x), f) in samples.time.iter().zip(samples.displacement.as_ref().unwrap()).zip(&samples.force) {
            text += &format!("{t:.6},{:.9},{:.4}\n", -x, -f);
        }
        let campaign = load_folder(&folder(&[("a.csv", &text)]), &Options::default()).unwrap();
        let record = &campaign.records[0];
        assert_eq!(campaign.sign.positive, crate::Positive::Compression);
        // Cycles begin at an upward zero crossing, which is a motion toward rebound.
        assert!(record.velocity[record.cycles[1].start] > 0.3);
        assert!((record.mean_displacement - 0.01).abs() < 2e-4);
    }

    #[test]
    fn a_note_of_many_files_is_one_line() {
        let lines = |files: usize| {
            let test = cleaning::repair(crate::fixtures::SineTest::default().samples(), &Options::default()).unwrap();
            let motions: Vec<CompleteTest> = (0..files)
                .map(|k| {
                    let text = Sentence::from(phrases::OF_FILE).with("file", k).with("text", "late");
                    let notes = vec![Note { kind: "late_velocity", text }];
                    CompleteTest { at: crate::Place::file(format!("t{k}.csv")), notes, ..test.clone() }
                })
                .collect();
            let mut notes = Vec::new();
            tell_splits(&motions, &mut notes);
            notes.iter().map(|note| note.text.to_string()).collect::<Vec<_>>()
        };
        assert_eq!(lines(3).len(), 3);
        let [line] = &lines(5)[..] else { panic!("{:?}", lines(5)) };
        assert!(line.contains("5 files (t0.csv, t1.csv, t2.csv, ...)") && line.contains("t0.csv: 0: late"), "{line}");
    }

    #[test]
    fn the_description_and_the_truth_of_the_virtual_rig_are_not_reported() {
        let folder = tempfile::tempdir().unwrap();
        let ignored = |format: &str| {
            std::fs::write(folder.path().join("campaign.toml"), format!("format = \"{format}\"\n")).unwrap();
            std::fs::create_dir_all(folder.path().join("sealed")).unwrap();
            std::fs::write(folder.path().join("sealed/clean_force.csv"), "test,force_N\na,1\n").unwrap();
            std::fs::write(folder.path().join("a.csv"), "x").unwrap();
            let mut notes = Vec::new();
            let found = find(&[folder.path().to_owned()], &Options::default(), &mut notes).unwrap();
            (notes.iter().filter(|note| note.kind == "ignored").count(), found.below.len())
        };
        assert_eq!(ignored("dashpot rig campaign 1"), (0, 0));
        assert_eq!(ignored("dashpot campaign profile 1"), (0, 1));
    }
}
