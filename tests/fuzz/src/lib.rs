//! Targets of the fuzzer: every reader of files, and the processing of the reader's output. A reader may accept or
//! reject a file. A panic, an access out of bounds, more than 1.5 GiB of memory or more than ten seconds are failures.

use dashpot_core::{Params, model_file as kernel};
use dashpot_hosts::adams::patch::{Damper, patch};
use dashpot_hosts::adams::property;
use dashpot_dimensions::read as dimensions;
use dashpot_identification::limits;
use dashpot_identification::literature::file as literature;
use dashpot_identification::model_file::{self, prepared};
use dashpot_records::{Options, PeakOptions, Unit, load, profile, read_motion, read_peaks};
use dashpot_rig::Matrix;
use dashpot_simulation::vehicle::Car;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use tempfile::TempDir;

/// Folder for the files that the targets read. It is in memory if the system has the folder /dev/shm.
static FOLDER: LazyLock<TempDir> = LazyLock::new(|| {
    let made = tempfile::tempdir_in("/dev/shm").or_else(|_| tempfile::tempdir());
    made.expect("a folder for the files that are read")
});

fn written(name: &str, bytes: &[u8]) -> PathBuf {
    let file = FOLDER.path().join(name);
    std::fs::write(&file, bytes).expect("room for the file that is read");
    file
}

/// Reads the bytes as a campaign of one record, whose file has the extension `ending`.
pub fn records(ending: &str, bytes: &[u8]) {
    let file = written(&format!("a.{ending}"), bytes);
    let mut options = Options::default();
    if let Ok(channel) = "force".parse() {
        options.units.insert(channel, Unit::Newton);
    }
    let _ = load(&[file], &options, &|_| ());
}

/// Reads a model file with the kernel's reader and with the reader of the program `dashpot`, and builds the model. If
/// neither reader reports an error, their parameters must be equal. The reader of literature models reads the same
/// file.
pub fn model(bytes: &[u8]) {
    let mut params = Params::new();
    let by_kernel = kernel::read(bytes, &mut params);
    let Ok(read) = model_file::read(&written("damper.toml", bytes)) else { return };
    if by_kernel.is_ok() {
        assert_eq!(params, read.params, "both readers read the same");
    }
    let _ = prepared(&read.params);
    let _ = literature::read(&FOLDER.path().join("damper.toml"));
}

/// Reads the profile of a campaign, or another small input file of a subcommand. The first byte selects the kind of
/// file.
pub fn settings(bytes: &[u8]) {
    let Some((kind, bytes)) = bytes.split_first() else { return };
    let text = std::str::from_utf8(bytes);
    match kind % 7 {
        0 => {
            let folder = FOLDER.path().join("campaign");
            if !folder.is_dir() {
                std::fs::create_dir(&folder).expect("a folder for the campaign");
                std::fs::write(folder.join("a.csv"), sine()).expect("room for a record");
            }
            std::fs::write(folder.join(profile::FILE), bytes).expect("room for the profile");
            let _ = load(&[folder], &Options::default(), &|_| ());
        }
        1 => {
            if let Ok(text) = text {
                let _ = limits::parse(Path::new("limits.csv"), text);
            }
        }
        2 => {
            let _ = read_peaks(&written("peaks.csv", bytes), &PeakOptions::default());
        }
        3 => {
            let _ = Matrix::read(&written("matrix.csv", bytes));
        }
        4 => {
            let _ = read_motion(&written("motion.csv", bytes), &Options::default());
        }
        5 => {
            if let Ok(text) = text {
                let _ = Car::read(text);
            }
        }
        _ => {
            if let Ok(text) = text {
                let _ = dimensions::parse(text, Path::new("dimensions.toml"));
            }
        }
    }
}

/// Reads the bytes as an Adams property file, writes it and reads it again. Then patches the bytes as an Adams dataset.
pub fn adams(bytes: &[u8]) {
    if let Ok(read) = property::read(bytes) {
        let again = property::read(property::write(&read, property::Form::Xml).as_bytes());
        assert!(
            again.is_ok_and(|again| again.curve.forces == read.curve.forces),
            "what was read can be written: {read:?}"
        );
    }
    let damper = [Damper { name: "dal_ride_damper.force".into(), length: 412.5, model_file: "damper.toml".into() }];
    let _ = patch(bytes, &damper, false);
}

/// Makes a record of three columns whose headings do not name the channels, so that the profile of the campaign must
/// assign the channels.
fn sine() -> String {
    let row = |i: u32| {
        let t = 0.01 * f64::from(i);
        let v = 0.3 * (6.0 * t).cos();
        format!("{t},{},{}\n", 0.05 * (6.0 * t).sin(), 1500.0 * v + 40.0 * (v / 0.01).tanh())
    };
    "A,B,C\n".to_owned() + &(0..240).map(row).collect::<String>()
}
