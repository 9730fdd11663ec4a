//! A campaign on disk: one CSV file per test, and a file with the true damper and effects.

use crate::LabError;
use crate::campaign::{Campaign, TestRecord};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// Name of the file with the true damper and effects.
pub const TRUTH_FILE: &str = "truth.json";

impl Campaign {
    /// Writes `<test>.csv` for every test and [`TRUTH_FILE`] into a folder, which must be new or empty. A failure
    /// leaves no incomplete folder.
    ///
    /// # Errors
    /// [`LabError::Folder`] if the folder is not empty, [`LabError::Io`] if it is not writable.
    pub fn write(&self, folder: &Path) -> Result<(), LabError> {
        let io = |path: &Path| {
            let path = path.to_owned();
            move |source| LabError::Io { path, source }
        };
        match fs::read_dir(folder).map(Iterator::count) {
            Ok(1..) => return Err(LabError::Folder { path: folder.to_owned() }),
            Ok(_) => fs::remove_dir(folder).map_err(io(folder))?,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => {}
            Err(error) => return Err(io(folder)(error)),
        }
        let name = folder.file_name().map_or_else(|| "campaign".into(), |n| n.to_string_lossy().into_owned());
        let aside = folder.with_file_name(format!(".{name}.unfinished"));
        let written = (|| {
            if aside.exists() {
                fs::remove_dir_all(&aside).map_err(io(&aside))?;
            }
            fs::create_dir_all(&aside).map_err(io(&aside))?;
            for test in &self.tests {
                let path = aside.join(format!("{}.csv", test.name));
                fs::write(&path, test.csv()).map_err(io(&path))?;
            }
            let path = aside.join(TRUTH_FILE);
            let truth = serde_json::to_string_pretty(&self.truth).map_err(std::io::Error::other);
            fs::write(&path, truth.map_err(io(&path))? + "\n").map_err(io(&path))?;
            fs::rename(&aside, folder).map_err(io(folder))
        })();
        if written.is_err() {
            // Ignore an error of the removal, because the first error is reported.
            let _ = fs::remove_dir_all(&aside);
        }
        written
    }

    /// Returns the campaign with the noise-free force as its measured force.
    #[must_use]
    pub fn without_noise(&self) -> Campaign {
        let mut clean = self.clone();
        for test in &mut clean.tests {
            test.force_n.clone_from(&test.clean_force_n);
        }
        clean
    }
}

impl TestRecord {
    /// Formats the record as CSV in SI units, with extension and tension positive.
    pub fn csv(&self) -> String {
        let channels = [
            ("velocity_m_s", &self.velocity_m_s, 6),
            ("side_force_N", &self.side_force_n, 2),
            ("temperature_C", &self.temperature_c, 2),
        ];
        let mut text = String::from("time_s,displacement_m,force_N");
        for (name, values, _) in channels {
            if values.is_some() {
                let _ = write!(text, ",{name}");
            }
        }
        text.push('\n');
        for (i, time) in self.time_s.iter().enumerate() {
            let _ = write!(text, "{time:.6},{:.7},{:.3}", self.displacement_m[i], self.force_n[i]);
            for (_, values, digits) in channels {
                if let Some(values) = values {
                    let _ = write!(text, ",{:.digits$}", values[i]);
                }
            }
            text.push('\n');
        }
        text
    }
}
