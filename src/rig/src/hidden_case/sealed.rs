//! The truth of a case (its damper and injected effects) on disk, in a subfolder that readers of records do not open.

use std::fs;
use std::io;
use std::path::Path;

use super::{InjectedCampaign, Truth};
use crate::RigError;
use crate::files::{read_text, replace_file};

/// Name of the subfolder that contains the truth.
pub const SEALED_FOLDER: &str = "sealed";
/// Name of the file with the injected effects and the damper's parameters.
pub const TRUTH_FILE: &str = "truth.toml";
/// Name of the file with the forces without noise: one line per sample, records in the order of measurement.
pub const CLEAN_FORCE_FILE: &str = "clean_force.csv";

impl InjectedCampaign {
    /// Writes the campaign and a sealed folder with the truth.
    ///
    /// The records are those of [`crate::Campaign::write`]. The folder [`SEALED_FOLDER`] contains `truth.toml` and
    /// `clean_force.csv` (header `test,force_N`; only the first line of a test contains its name).
    ///
    /// # Errors
    /// Returns the errors of [`crate::Campaign::write`].
    pub fn write(&self, folder: &Path) -> Result<(), RigError> {
        self.campaign.write(folder)?;
        let sealed = folder.join(SEALED_FOLDER);
        fs::create_dir_all(&sealed).map_err(RigError::io("make the folder", &sealed))?;
        replace_file(&sealed.join(CLEAN_FORCE_FILE), |out| {
            out.write_all(b"test,force_N\n")?;
            for record in &self.campaign.records {
                for (index, force) in record.clean_force_n.iter().enumerate() {
                    let name = if index == 0 { record.point.name.as_str() } else { "" };
                    writeln!(out, "{name},{force:.3}")?;
                }
            }
            Ok(())
        })?;
        let place = sealed.join(TRUTH_FILE);
        let text = toml::to_string(&self.truth)
            .map_err(|error| RigError::io("describe the truth in", &place)(io::Error::other(error)))?;
        replace_file(&place, |out| out.write_all(text.as_bytes()))
    }
}

impl Truth {
    /// Reads the truth from the subfolder of a folder of records.
    ///
    /// # Errors
    /// [`RigError::Io`] if the file is missing or invalid.
    pub fn read(folder: &Path) -> Result<Self, RigError> {
        let place = folder.join(SEALED_FOLDER).join(TRUTH_FILE);
        let text = read_text(&place).map_err(RigError::io("read", &place))?;
        toml::from_str(&text).map_err(|error| RigError::io("understand", &place)(io::Error::other(error)))
    }
}
