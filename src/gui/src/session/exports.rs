//! Exports of the damper to other programs, with the functions of `dashpot export`.

use crate::session::guarded::write;
use anyhow::{Context as _, bail};
use dashpot_core::family::Axis;
use dashpot_core::{Model, Params};
use dashpot_hosts::adams::folder::SineTest;
use dashpot_hosts::exports::{self, RunFolderInput};
use dashpot_hosts::{fmu, runtimes};
use dashpot_identification::model_file::{self, ModelFile};
use dashpot_output::{FolderLock, Kind};
use dashpot_rig::{Matrix, TestPoint};
use dashpot_simulation::{chatter, stiffness};
use std::path::Path;

/// Target of an export.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Host {
    /// One damper as an FMU, FMI 2.0.
    Fmu,
    /// An FMU of FMI 3.0.
    Fmu3,
    /// Four dampers of a vehicle as an FMU, FMI 2.0, for VI-CarRealTime.
    Vehicle,
    /// A run folder of Adams.
    Adams,
    /// A property file of Adams Car.
    Property,
}

impl Host {
    /// Returns the proposed name of the file or folder.
    pub fn proposed(self) -> &'static str {
        match self {
            Host::Fmu | Host::Fmu3 => "damper.fmu",
            Host::Vehicle => "car.fmu",
            Host::Adams => "adams",
            Host::Property => "damper.dpr",
        }
    }
}

/// Input of an export.
pub struct Export {
    /// Target of the export.
    pub host: Host,
    /// Parameter values of the model.
    pub params: Params,
    /// Text of the model file.
    pub text: String,
    /// Name of the model file, or empty if the model was not saved.
    pub name: String,
}

impl Export {
    /// Writes the export. Returns the notes that the command would print.
    ///
    /// # Errors
    /// The model cannot be exported, or the compiled runtime is missing. A file of another kind exists at the path, or
    /// the path is not writable.
    pub fn write(&self, path: &Path) -> anyhow::Result<Vec<String>> {
        let model = Model::new(&self.params).map_err(|fault| anyhow::anyhow!("{}", fault.reason.text()))?;
        match self.host {
            Host::Fmu => self.fmu(path, fmu::Version::Two, false),
            Host::Fmu3 => self.fmu(path, fmu::Version::Three, false),
            Host::Vehicle => self.fmu(path, fmu::Version::Two, true),
            Host::Adams => self.adams(path, &model),
            Host::Property => self.property(path),
        }
    }

    fn fmu(&self, path: &Path, version: fmu::Version, four: bool) -> anyhow::Result<Vec<String>> {
        let holds_one = runtimes::compiled("linux64", "dashpot_damper.so").is_some();
        let library = exports::static_library()?;
        if !holds_one && !library.is_file() {
            bail!("there is no {} to make an FMU from; {}", library.display(), runtimes::HOW);
        }
        let name = exports::fmu_name(Path::new(&self.name), four);
        let mut remarks = chatter::remarks(&self.params, chatter::Host::TYPICAL);
        remarks.extend(stiffness::remarks(&self.params));
        let corners = fmu::corners(&[self.params], four)?;
        let options = fmu::Options {
            version,
            scales: fmu::Scales::checked(corners.len(), None, None, 0.0)?,
            inputs: fmu::Inputs::Unspecified,
            explicit_step: stiffness::longest_explicit_step(&corners),
            name: &name,
            from_source: (!holds_one).then_some(library.as_path()),
            sources: true,
            conceal_parameters: false,
            more: &[],
            remarks: &remarks,
        };
        write(path, Kind::Fmu, &fmu::fmu(&corners, &options)?.bytes)?;
        Ok(remarks)
    }

    /// Returns the contents of the model file. They include the results of the fit if the text contains them.
    fn file(&self) -> ModelFile {
        let read = model_file::of_text(&self.text, Path::new(&self.name)).ok();
        let (identification, given) = read.map(|file| (file.identification, file.specified)).unwrap_or_default();
        ModelFile::new(self.params, Axis::NONE, identification, given)
    }

    fn property(&self, path: &Path) -> anyhow::Result<Vec<String>> {
        let chatters = |curve: &Params| chatter::remarks(curve, chatter::Host::TYPICAL);
        let of = (self.name.as_str(), self.text.as_bytes());
        let made = exports::property_file(&self.file(), false, path, of, &chatters)?;
        dashpot_output::check([path])?;
        dashpot_output::replace_file(path, made.text.as_bytes())
            .with_context(|| format!("cannot write {}", path.display()))?;
        Ok(made.remarks)
    }

    fn adams(&self, path: &Path, model: &Model) -> anyhow::Result<Vec<String>> {
        let _held = FolderLock::take(path)?;
        let put = |name: &str, bytes: &[u8]| {
            let path = path.join(name);
            dashpot_output::replace_file(&path, bytes).with_context(|| format!("cannot write {}", path.display()))
        };
        let libraries = exports::adams_libraries(None)?;
        let chatters = chatter::remarks(&self.params, chatter::Host::TYPICAL);
        let sine = |p: &TestPoint| SineTest { amplitude_m: p.amplitude_m, frequency_hz: p.frequency_hz };
        let tests: Vec<SineTest> = Matrix::default().points().iter().map(sine).collect();
        let made = exports::run_folder(RunFolderInput {
            params: &self.params,
            model,
            text: self.text.as_bytes(),
            length: None,
            tests: &tests,
            libraries,
            replaced: Vec::new(),
            chatters,
        });
        made.files.iter().try_for_each(|(name, content)| put(name, content))?;
        let mut notes = made.notes(path);
        notes.extend(made.if_coupled());
        Ok(notes)
    }
}
