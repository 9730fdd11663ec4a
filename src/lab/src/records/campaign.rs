//! Loads the records of a campaign: finds the files, reads and cleans them in parallel, settles the sign.

use std::cmp::Ordering;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde::Serialize;

use super::channel::Channel;
use super::cleaning;
use super::error::RecordError;
use super::options::Options;
use super::plausibility;
use super::record::{Note, Record};
use super::samples::Samples;
use super::sign::{self, SignFinding};
use super::{csv, mat, xlsx};

/// The records of a campaign, cleaned, in SI, rebound and tension positive.
#[derive(Debug, Clone, Serialize)]
pub struct Campaign {
    /// One record per test, in natural order of the file names, then in the order within the file.
    pub records: Vec<Record>,
    /// Which direction the files count positive, and how sure that is.
    pub sign: SignFinding,
    /// What concerns the campaign as a whole.
    pub notes: Vec<Note>,
}

/// How far loading has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Steps done.
    pub done: usize,
    /// Steps in all; may grow while files turn out to hold several tests.
    pub total: usize,
}

/// Loads files and folders as one campaign.
///
/// A folder stands for all `*.csv`, `*.xlsx` and `*.mat` files directly in it. `progress` is called from several
/// threads, once per finished step. The result does not depend on the number of threads.
///
/// # Errors
/// [`RecordError`] for the first file, in order, that cannot be read or trusted.
pub fn load(
    paths: &[PathBuf],
    options: &Options,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Campaign, RecordError> {
    if let Some(&channel) = [Channel::Time, Channel::Force].iter().find(|c| options.ignore.contains(c)) {
        return Err(RecordError::Indispensable { channel });
    }
    let mut notes = Vec::new();
    let files = find(paths, &mut notes)?;
    let counter = Counter::new(files.len(), progress);
    // Every file is read before the first error is picked, so that the error does not depend on the threads.
    let read: Vec<Result<Vec<Samples>, RecordError>> = files
        .par_iter()
        .map(|file| {
            let tests = read_file(file, options);
            counter.step(tests.as_ref().map_or(0, Vec::len));
            tests
        })
        .collect();
    let mut tests = Vec::new();
    for file in read {
        tests.extend(file?);
    }
    let flawless: Vec<Result<_, RecordError>> = tests
        .into_par_iter()
        .map(|test| {
            let repaired = cleaning::repair(test, options);
            counter.step(0);
            repaired
        })
        .collect();
    let mut motions = flawless.into_iter().collect::<Result<Vec<_>, _>>()?;
    let sign = sign::settle(&mut motions, options, &mut notes)?;
    let mut records: Vec<Record> = motions
        .into_par_iter()
        .map(|motion| {
            let record = cleaning::finish(motion)?;
            plausibility::refuse_absurd(&record)?;
            Ok(record)
        })
        .collect::<Result<_, _>>()?;
    unique_names(&mut records);
    plausibility::remark(&records, &mut notes)?;
    Ok(Campaign { records, sign, notes })
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

    fn step(&self, new_steps: usize) {
        use std::sync::atomic::Ordering::Relaxed;
        let total = self.total.fetch_add(new_steps, Relaxed) + new_steps;
        let done = self.done.fetch_add(1, Relaxed) + 1;
        (self.report)(Progress { done, total });
    }
}

/// The record files among the paths, folders opened.
fn find(paths: &[PathBuf], notes: &mut Vec<Note>) -> Result<Vec<PathBuf>, RecordError> {
    if paths.is_empty() {
        return Err(RecordError::NoPaths);
    }
    let mut files = Vec::new();
    for path in paths {
        if !path.exists() {
            return Err(RecordError::NotFound { file: path.clone() });
        }
        if !path.is_dir() {
            if !files.contains(path) {
                files.push(path.clone());
            }
            continue;
        }
        let unreadable = |source| RecordError::Read { file: path.clone(), source };
        let mut entries = Vec::new();
        for entry in std::fs::read_dir(path).map_err(unreadable)? {
            entries.push(entry.map_err(unreadable)?.path());
        }
        entries.sort_by(|a, b| natural_order(&file_name(a), &file_name(b)));
        let mut ignored = Vec::new();
        let before = files.len();
        for entry in entries {
            let name = file_name(&entry);
            // Hidden files, and the lock files that a spreadsheet leaves beside an open workbook.
            if name.starts_with('.') || name.starts_with("~$") {
                continue;
            }
            if entry.is_file() && matches!(extension(&entry).as_str(), "csv" | "xlsx" | "mat") {
                if !files.contains(&entry) {
                    files.push(entry);
                }
            } else {
                ignored.push(name);
            }
        }
        if !ignored.is_empty() {
            notes.push(Note {
                kind: "ignored",
                text: format!("in {}, not read as records: {}", path.display(), ignored.join(", ")),
            });
        }
        if files.len() == before {
            return Err(RecordError::EmptyFolder { folder: path.clone() });
        }
    }
    Ok(files)
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn extension(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase()
}

/// The tests of one file, read by its extension.
pub(crate) fn read_file(file: &Path, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    match extension(file).as_str() {
        "csv" | "txt" | "tsv" | "asc" => csv::read(file, &name, options),
        "xlsx" | "xlsm" => xlsx::read(file, &name, options),
        "mat" => mat::read(file, &name, options),
        _ => Err(RecordError::UnknownType { file: file.into() }),
    }
}

/// Order in which people number files: digits compare as numbers, `test2` before `test10`.
fn natural_order(a: &str, b: &str) -> Ordering {
    let (mut left, mut right) = (a.chars().peekable(), b.chars().peekable());
    loop {
        match (left.peek().copied(), right.peek().copied()) {
            (None, None) => return a.cmp(b),
            (None, _) => return Ordering::Less,
            (_, None) => return Ordering::Greater,
            (Some(x), Some(y)) if x.is_ascii_digit() && y.is_ascii_digit() => {
                let digits = |side: &mut std::iter::Peekable<std::str::Chars<'_>>| {
                    let mut text = String::new();
                    while let Some(c) = side.next_if(char::is_ascii_digit) {
                        text.push(c);
                    }
                    text.trim_start_matches('0').to_string()
                };
                let (x, y) = (digits(&mut left), digits(&mut right));
                let order = x.len().cmp(&y.len()).then_with(|| x.cmp(&y));
                if order != Ordering::Equal {
                    return order;
                }
            }
            (Some(x), Some(y)) => {
                let order = x.to_lowercase().cmp(y.to_lowercase()).then(x.cmp(&y));
                if x.to_lowercase().ne(y.to_lowercase()) {
                    return order;
                }
                left.next();
                right.next();
            }
        }
    }
}

/// Gives records of equal name (same test name in two files) a number, so that every name is one record.
fn unique_names(records: &mut [Record]) {
    for i in 1..records.len() {
        let taken = |name: &str, records: &[Record]| records[..i].iter().any(|r| r.name == name);
        if taken(&records[i].name, records) {
            let base = records[i].name.clone();
            let name = (2..).map(|n| format!("{base} ({n})")).find(|name| !taken(name, records)).unwrap_or(base);
            records[i].name = name;
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    use super::super::fixtures::SineTest;
    use super::*;

    fn quiet(_: Progress) {}

    /// A folder with these files.
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
        assert_eq!(campaign.sign.positive, super::super::Positive::Rebound);
        let note = &campaign.notes[0];
        assert!(
            note.kind == "ignored" && note.text.contains("README.md, campaign.toml")
                || note.text.contains("campaign.toml, README.md")
        );
        assert!(!note.text.contains("hidden"));
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
        let campaign = load_folder(&folder, &Options::default()).unwrap();
        assert_eq!(campaign.records.iter().map(|r| r.name.as_str()).collect::<Vec<_>>(), ["A7", "A8"]);
        assert!(campaign.records[1].source.ends_with("all.csv (test 'A8')"));
        assert!((campaign.records[1].amplitude - 0.05).abs() < 2e-4);
        let notes = &campaign.records[0].notes;
        assert!(notes.iter().any(|n| n.kind == "converted") && notes.iter().any(|n| n.kind == "derived"));
    }

    #[test]
    fn records_of_equal_name_are_told_apart() {
        let (one, two) = (folder(&[("a.csv", &sine(1.0))]), folder(&[("a.csv", &sine(2.0))]));
        let paths = [one.path().join("a.csv"), two.path().to_path_buf(), one.path().join("a.csv")];
        let campaign = load(&paths, &Options::default(), &quiet).unwrap();
        assert_eq!(campaign.records.iter().map(|r| r.name.as_str()).collect::<Vec<_>>(), ["a", "a (2)"]);
    }

    #[test]
    fn what_cannot_be_read_is_refused_with_the_file_named() {
        let message =
            |files: &[(&str, &str)]| load_folder(&folder(files), &Options::default()).unwrap_err().to_string();
        assert!(message(&[("notes.txt", "")]).contains("holds no record"));
        assert!(message(&[("a.csv", "alpha,beta\n1,2\n")]).contains("a.csv: no header line"));
        assert!(message(&[("a.csv", "time_s,x_mm,force_N\n")]).contains("a.csv: has a header but no data"));
        assert!(message(&[("a.csv", "time_s,x_mm,force_N\n1,2,3\n")]).contains("only 1 usable samples"));
        // The first bad file in order is named, whichever thread finds its fault first.
        assert!(message(&[("a1.csv", &sine(1.0)), ("a2.csv", "x\n"), ("a10.csv", "y\n")]).contains("a2.csv"));
        let folder = folder(&[("a.pdf", "")]);
        let path = |name: &str| load(&[folder.path().join(name)], &Options::default(), &quiet).unwrap_err().to_string();
        assert!(path("missing.csv").contains("missing.csv: there is no such file"));
        assert!(path("a.pdf").contains("a.pdf: is no record"));
        assert!(load(&[], &Options::default(), &quiet).unwrap_err().to_string().contains("no record given"));
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
        assert_eq!(campaign.sign.positive, super::super::Positive::Compression);
        // Cycles begin on the way into rebound.
        assert!(record.velocity[record.cycles[1].start] > 0.3);
        assert!((record.mean_displacement - 0.01).abs() < 2e-4);
    }

    #[test]
    fn natural_order_compares_numbers_as_numbers() {
        let mut names = ["t10", "t9", "T1", "t010a", "t", "s3", "t9.5", "t9.10"];
        names.sort_by(|a, b| natural_order(a, b));
        assert_eq!(names, ["s3", "t", "T1", "t9", "t9.5", "t9.10", "t10", "t010a"]);
    }
}
