//! A campaign on disk: one CSV record per test, and a description of the campaign in TOML.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{Campaign, Record};
use crate::RigError;
use crate::files::{read_text, write_file};
use crate::hidden_case::SEALED_FOLDER;

/// File name of a campaign's description, which identifies a folder as a campaign.
pub const CAMPAIGN_FILE: &str = "campaign.toml";
/// Value of `format`, the first entry of [`CAMPAIGN_FILE`].
const FORMAT: &str = "dashpot rig campaign 1";
/// Subfolder in which records are written before they move to the campaign's folder.
const UNFINISHED: &str = ".unfinished-campaign";

/// Contents of [`CAMPAIGN_FILE`]: the execution of the campaign, without parameters of the damper.
///
/// The seed determines the parameters of the damper. It is omitted if the truth (true damper and effects) is in a
/// sealed folder.
#[derive(Debug, Serialize, Deserialize)]
struct Description {
    format: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    seed: Option<u64>,
    noise_percent: f64,
    channels: Vec<String>,
    signs: String,
    test: Vec<Test>,
}

#[derive(Debug, Serialize, Deserialize)]
struct Test {
    file: String,
    amplitude_mm: f64,
    frequency_hz: f64,
    peak_velocity_mm_s: f64,
    mean_displacement_mm: f64,
    side_force_n: f64,
    cycles: u32,
    sample_rate_hz: f64,
    samples: u64,
}

impl Campaign {
    /// Writes the campaign into a folder, which is created if it is missing.
    ///
    /// Every test gives a file `<test>.csv`. The header is `time_s,displacement_m,velocity_m_s,force_N`, followed by
    /// `side_force_N` and `temperature_C` if these channels are recorded. `campaign.toml` describes the execution of
    /// the campaign. The new campaign replaces an earlier campaign in the folder and its sealed truth (the true damper
    /// and effects). Records are first written to a separate folder, so a failure leaves no incomplete record.
    ///
    /// # Errors
    /// [`RigError::Folder`] if the folder is not empty and contains no earlier campaign, or if it contains a CSV file
    /// that is no record of the earlier campaign. The folder then stays unchanged. [`RigError::Io`] if a file is not
    /// writable.
    pub fn write(&self, folder: &Path) -> Result<(), RigError> {
        let earlier = earlier_records(folder)?;
        fs::create_dir_all(folder).map_err(RigError::io("make the folder", folder))?;
        let aside = folder.join(UNFINISHED);
        remove_folder(&aside)?;
        // The sealed truth (true damper and effects) of an earlier campaign does not apply to the new campaign.
        remove_folder(&folder.join(SEALED_FOLDER))?;
        fs::create_dir(&aside).map_err(RigError::io("make the folder", &aside))?;
        let outcome = self.write_by_way_of(folder, &aside, &earlier);
        let cleared = remove_folder(&aside);
        outcome.and(cleared)
    }

    fn write_by_way_of(&self, folder: &Path, aside: &Path, earlier: &BTreeSet<String>) -> Result<(), RigError> {
        let files: Vec<String> = self.records.iter().map(Record::file_name).collect();
        let written: Vec<Result<(), RigError>> = self
            .records
            .par_iter()
            .zip(&files)
            .map(|(record, file)| write_file(&aside.join(file), |out| record.write_csv(out)))
            .collect();
        written.into_iter().collect::<Result<(), _>>()?;

        // Remove records that the new campaign does not contain, and replace the description before the records. So,
        // even after a failure, the description lists every record in the folder.
        for file in earlier.iter().filter(|file| !files.contains(file)) {
            let path = folder.join(file);
            match fs::remove_file(&path) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(RigError::io("remove the earlier record", &path)(error));
                }
                _ => {}
            }
        }
        let description = toml::to_string(&self.description()).map_err(|error| {
            RigError::io("describe the campaign in", &folder.join(CAMPAIGN_FILE))(io::Error::other(error))
        })?;
        let place = folder.join(CAMPAIGN_FILE);
        write_file(&aside.join(CAMPAIGN_FILE), |out| out.write_all(description.as_bytes()))?;
        fs::rename(aside.join(CAMPAIGN_FILE), &place).map_err(RigError::io("write", &place))?;
        for file in &files {
            let place = folder.join(file);
            fs::rename(aside.join(file), &place).map_err(RigError::io("write", &place))?;
        }
        Ok(())
    }

    fn description(&self) -> Description {
        let mut channels = vec!["time_s", "displacement_m", "velocity_m_s", "force_N"];
        if self.records.iter().any(|record| record.side_force_n.is_some()) {
            channels.push("side_force_N");
        }
        if self.records.iter().any(|record| record.temperature_c.is_some()) {
            channels.push("temperature_C");
        }
        // Six decimals of a millimeter are a nanometer. Further decimals would only show the rounding error of the
        // binary representation.
        let tidy = |value: f64| (value * 1e6).round() / 1e6;
        Description {
            format: FORMAT.into(),
            seed: (!self.sealed).then_some(self.options.seed),
            noise_percent: self.options.noise_percent,
            channels: channels.into_iter().map(str::to_owned).collect(),
            signs: "extension (rebound) displacement and velocity positive, tension force positive".into(),
            test: self
                .records
                .iter()
                .map(|record| Test {
                    file: record.file_name(),
                    amplitude_mm: tidy(record.point.amplitude_m * 1e3),
                    frequency_hz: tidy(record.point.frequency_hz),
                    peak_velocity_mm_s: tidy(record.point.peak_velocity_m_s * 1e3),
                    mean_displacement_mm: tidy(record.point.mean_displacement_m * 1e3),
                    side_force_n: tidy(record.point.side_force_n),
                    cycles: record.point.cycles,
                    sample_rate_hz: record.sample_rate_hz,
                    samples: record.time_s.len() as u64,
                })
                .collect(),
        }
    }
}

impl Record {
    fn file_name(&self) -> String {
        format!("{}.csv", self.point.name)
    }

    /// Writes the record as CSV. In every channel except time, the last decimal is at most a tenth of the default
    /// sensor noise.
    fn write_csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let side = self.side_force_n.as_deref();
        let temperature = self.temperature_c.as_deref();
        out.write_all(b"time_s,displacement_m,velocity_m_s,force_N")?;
        out.write_all(if side.is_some() { b",side_force_N" } else { b"" })?;
        out.write_all(if temperature.is_some() { b",temperature_C\n" } else { b"\n" })?;
        for (i, time) in self.time_s.iter().enumerate() {
            write!(out, "{time:.6},{:.7},{:.7},{:.3}", self.displacement_m[i], self.velocity_m_s[i], self.force_n[i])?;
            if let Some(side) = side {
                write!(out, ",{:.2}", side[i])?;
            }
            if let Some(temperature) = temperature {
                write!(out, ",{:.2}", temperature[i])?;
            }
            out.write_all(b"\n")?;
        }
        Ok(())
    }
}

/// Lists the records of the earlier campaign in the folder. The list is empty if the folder is empty or missing.
///
/// Returns an error if a non-empty folder contains no earlier campaign, or contains a CSV file that is no record of
/// that campaign.
fn earlier_records(folder: &Path) -> Result<BTreeSet<String>, RigError> {
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(BTreeSet::new()),
        Err(error) => return Err(RigError::io("read the folder", folder)(error)),
        Ok(entries) => entries,
    };
    let mut present = BTreeSet::new();
    for entry in entries {
        let entry = entry.map_err(RigError::io("read the folder", folder))?;
        present.insert(entry.file_name().to_string_lossy().into_owned());
    }
    present.remove(UNFINISHED);
    if present.is_empty() {
        return Ok(BTreeSet::new());
    }
    let refuse = |problem: String| Err(RigError::Folder { folder: folder.to_owned(), problem });
    let description = folder.join(CAMPAIGN_FILE);
    let listed = if present.contains(CAMPAIGN_FILE) {
        let text = read_text(&description).map_err(RigError::io("read", &description))?;
        toml::from_str::<Description>(&text)
            .ok()
            .filter(|description| description.format == FORMAT)
            .map(|description| description.test.into_iter().map(|test| test.file).collect())
    } else {
        None
    };
    let Some(listed): Option<BTreeSet<String>> = listed else {
        return refuse(format!(
            "the folder is not empty and is no earlier campaign (no {CAMPAIGN_FILE} of one); \
             choose a new or empty folder"
        ));
    };
    // Any other CSV file could be mistaken for a record of the campaign, or be overwritten by a record.
    let foreign = present.iter().find(|name| name.to_lowercase().ends_with(".csv") && !listed.contains(*name));
    if let Some(name) = foreign {
        return refuse(format!(
            "'{name}' does not belong to the earlier campaign in this folder; move it away or choose another folder"
        ));
    }
    Ok(listed.intersection(&present).cloned().collect())
}

fn remove_folder(folder: &Path) -> Result<(), RigError> {
    match fs::remove_dir_all(folder) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(RigError::io("remove the folder", folder)(error)),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Matrix, MatrixOptions, Options};
    use std::collections::BTreeMap;

    fn matrix(amplitudes_m: Vec<f64>) -> Matrix {
        Matrix::thesis(&MatrixOptions {
            amplitudes_m,
            peak_velocities_m_s: vec![0.25, 0.5],
            slow_tests: false,
            ..MatrixOptions::default()
        })
        .unwrap()
    }

    fn campaign(matrix: &Matrix, threads: usize) -> Campaign {
        let options = Options { seed: 3, threads: Some(threads), ..Options::default() };
        Campaign::run(matrix, &options, |_, _| {}).unwrap()
    }

    fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
        fs::read_dir(folder)
            .unwrap()
            .map(|entry| {
                let entry = entry.unwrap();
                (entry.file_name().into_string().unwrap(), fs::read(entry.path()).unwrap())
            })
            .collect()
    }

    #[test]
    fn files_are_the_same_bytes_whatever_the_threads() {
        let matrix = matrix(vec![0.01, 0.02]);
        let folder = tempfile::tempdir().unwrap();
        let folders = [1, 4].map(|threads| {
            let path = folder.path().join(threads.to_string());
            campaign(&matrix, threads).write(&path).unwrap();
            contents(&path)
        });
        assert_eq!(folders[0], folders[1]);
        assert_eq!(folders[0].len(), 5, "{:?}", folders[0].keys());
    }

    #[test]
    fn records_read_back_as_measured() {
        let folder = tempfile::tempdir().unwrap();
        let mut points = matrix(vec![0.01]).points().to_vec();
        points[0].side_force_n = 300.0;
        let campaign = campaign(&Matrix::new(points).unwrap(), 2);
        campaign.write(folder.path()).unwrap();
        for record in &campaign.records {
            let mut reader = csv::Reader::from_path(folder.path().join(record.file_name())).unwrap();
            let header: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
            assert_eq!(header, ["time_s", "displacement_m", "velocity_m_s", "force_N", "side_force_N"]);
            let rows: Vec<[f64; 5]> = reader.deserialize().map(Result::unwrap).collect();
            assert_eq!(rows.len(), record.time_s.len());
            let side = record.side_force_n.as_ref().unwrap();
            for (i, row) in rows.iter().enumerate() {
                assert!((row[0] - record.time_s[i]).abs() < 1e-9);
                assert!((row[1] - record.displacement_m[i]).abs() <= 0.51e-7);
                assert!((row[2] - record.velocity_m_s[i]).abs() <= 0.51e-7);
                assert!((row[3] - record.force_n[i]).abs() <= 0.51e-3);
                assert!((row[4] - side[i]).abs() <= 0.51e-2);
            }
        }
    }

    #[test]
    fn earlier_campaign_is_replaced_without_leftovers() {
        let folder = tempfile::tempdir().unwrap();
        campaign(&matrix(vec![0.01, 0.02]), 2).write(folder.path()).unwrap();
        // Make the files of an interrupted earlier run, which the next run must remove, and a user's notes, which it
        // must keep.
        fs::create_dir(folder.path().join(UNFINISHED)).unwrap();
        fs::write(folder.path().join(UNFINISHED).join("x.csv"), "half").unwrap();
        fs::write(folder.path().join("notes.txt"), "kept").unwrap();
        campaign(&matrix(vec![0.02]), 2).write(folder.path()).unwrap();
        let names: Vec<String> = contents(folder.path()).into_keys().collect();
        assert_eq!(names, ["a20mm_v0250mm_s.csv", "a20mm_v0500mm_s.csv", "campaign.toml", "notes.txt"]);
    }

    #[test]
    fn foreign_folders_are_refused_untouched() {
        let campaign = campaign(&matrix(vec![0.01]), 2);
        let refused = |prepare: &dyn Fn(&Path)| {
            let folder = tempfile::tempdir().unwrap();
            prepare(folder.path());
            let before = contents(folder.path());
            let message = campaign.write(folder.path()).unwrap_err().to_string();
            assert_eq!(contents(folder.path()), before);
            message
        };
        let message = refused(&|folder| fs::write(folder.join("thesis.csv"), "mine").unwrap());
        assert!(message.contains("no earlier campaign") && message.contains("choose a new or empty folder"));
        let message = refused(&|folder| fs::write(folder.join(CAMPAIGN_FILE), "format = \"other\"\n").unwrap());
        assert!(message.contains("no earlier campaign"));
        let message = refused(&|folder| {
            campaign.write(folder).unwrap();
            fs::write(folder.join("mine.csv"), "mine").unwrap();
        });
        assert!(message.contains("'mine.csv' does not belong"), "{message}");
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, "x").unwrap();
        let message = campaign.write(&file).unwrap_err().to_string();
        assert!(message.contains("file"), "{message}");
    }

    #[test]
    fn description_says_how_and_nothing_of_the_damper() {
        let folder = tempfile::tempdir().unwrap();
        let campaign = campaign(&matrix(vec![0.01]), 2);
        campaign.write(folder.path()).unwrap();
        let text = fs::read_to_string(folder.path().join(CAMPAIGN_FILE)).unwrap();
        let description: Description = toml::from_str(&text).unwrap();
        assert_eq!((description.seed, description.noise_percent), (Some(3), 1.0));
        assert_eq!(description.test.len(), 2);
        assert_eq!(description.test[1].samples as usize, campaign.records[1].time_s.len());
        for word in ["bulk", "preload", "seal", "friction", "gas", "valve"] {
            assert!(!text.contains(word), "{text}");
        }
    }
}
