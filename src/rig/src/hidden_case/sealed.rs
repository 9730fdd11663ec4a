//! The truth of a case on disk, in a folder beside the records that no reader of records opens.

use std::fs;
use std::io;
use std::path::Path;

use super::{InjectedCampaign, Truth};
use crate::RigError;
use crate::files::replace_file;

/// Folder of the truth, in that of the records.
pub const SEALED_FOLDER: &str = "sealed";
/// What is hidden.
pub const TRUTH_FILE: &str = "truth.toml";
/// Forces without noise: one line per sample, records one after the other in the order of their names.
pub const CLEAN_FORCE_FILE: &str = "clean_force.csv";

impl InjectedCampaign {
    /// Writes the campaign and a sealed folder with the truth.
    ///
    /// The records are those of [`crate::Campaign::write`]. The folder [`SEALED_FOLDER`] has `truth.toml` and
    /// `clean_force.csv` (header `test,force_N`; the test's name stands in its first line only).
    ///
    /// # Errors
    /// As [`crate::Campaign::write`].
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
    /// Reads the truth beside the records in a folder.
    ///
    /// # Errors
    /// [`RigError::Io`] when there is none or it cannot be understood.
    pub fn read(folder: &Path) -> Result<Self, RigError> {
        let place = folder.join(SEALED_FOLDER).join(TRUTH_FILE);
        let text = fs::read_to_string(&place).map_err(RigError::io("read", &place))?;
        toml::from_str(&text).map_err(|error| RigError::io("understand", &place)(io::Error::other(error)))
    }
}
