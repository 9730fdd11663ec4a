//! The damper for other programs, as `dashpot export` writes it.

use crate::session::outputs::write;
use anyhow::{Context as _, bail};
use dashpot_core::elements::{self, GROUPS};
use dashpot_core::{Model, Params};
use dashpot_hosts::adams::folder;
use dashpot_hosts::adams::property::{self, Curve, Form, Properties};
use dashpot_hosts::{fmu, runtimes};
use dashpot_output::{FolderLock, Kind};
use dashpot_rig::Matrix;
use dashpot_simulation::chatter;
use std::path::Path;

/// A host that a model is exported to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Host {
    /// One damper as an FMU, FMI 2.0.
    Fmu,
    /// The same, FMI 3.0.
    Fmu3,
    /// Four dampers of a vehicle as an FMU, FMI 2.0: what VI-CarRealTime takes.
    Vehicle,
    /// A run folder of Adams.
    Adams,
    /// A property file of Adams Car.
    Property,
}

impl Host {
    /// The name of the file or folder that is proposed.
    pub fn proposed(self) -> &'static str {
        match self {
            Host::Fmu | Host::Fmu3 => "damper.fmu",
            Host::Vehicle => "car.fmu",
            Host::Adams => "adams",
            Host::Property => "damper.dpr",
        }
    }
}

/// A model on its way to a host.
pub struct Export {
    /// Where to.
    pub host: Host,
    /// Values of the model.
    pub params: Params,
    /// The text of its file.
    pub text: String,
    /// The name of its file; empty where it was not saved.
    pub name: String,
}

impl Export {
    /// Writes it. Returns what must be known beside it, as the command says it.
    ///
    /// # Errors
    /// Where the model has nothing to export, a place is taken by something else, or cannot be written.
    pub fn write(&self, path: &Path) -> anyhow::Result<Vec<String>> {
        let model = Model::new(&self.params).map_err(|fault| anyhow::anyhow!("{}", fault.reason.text()))?;
        match self.host {
            Host::Fmu => self.fmu(path, fmu::Version::Two, false),
            Host::Fmu3 => self.fmu(path, fmu::Version::Three, false),
            Host::Vehicle => self.fmu(path, fmu::Version::Two, true),
            Host::Adams => self.adams(path, &model),
            Host::Property => self.property(path, &model),
        }
    }

    fn fmu(&self, path: &Path, version: fmu::Version, four: bool) -> anyhow::Result<Vec<String>> {
        let holds_one = runtimes::compiled("linux64", "dashpot_damper.so").is_some();
        let library = std::env::current_exe()?.with_file_name("libdashpot.a");
        if !holds_one && !library.is_file() {
            bail!("there is no {} to make an FMU from; {}", library.display(), runtimes::HOW);
        }
        let stem =
            Path::new(&self.name).file_stem().map_or_else(|| "damper".into(), |s| s.to_string_lossy().into_owned());
        let name = if four { format!("dashpot vehicle, four dampers ({stem})") } else { format!("dashpot {stem}") };
        let remarks = chatter::remarks(&self.params, chatter::Host::USUAL);
        let corners = fmu::corners(&[self.params], four)?;
        let options = fmu::Options {
            version,
            scales: fmu::Scales::checked(corners.len(), None, None, 0.0)?,
            name: &name,
            from_source: (!holds_one).then_some(library.as_path()),
            sources: true,
            hide_parameters: false,
            more: &[],
            remarks: &remarks,
        };
        write(path, Kind::Fmu, &fmu::fmu(&corners, &options)?.bytes)?;
        Ok(remarks)
    }

    fn property(&self, path: &Path, model: &Model) -> anyhow::Result<Vec<String>> {
        let params = &self.params;
        if !params.is_on("fv_curve") {
            bail!("the element fv_curve is off, so there is no curve to export");
        }
        let xml = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("xml"));
        let held = |name: &str| name == "fv_curve" || (xml && name == "gas_preload");
        let left_out: Vec<&str> =
            GROUPS[..elements::COUNT].iter().map(|g| g.name).filter(|n| params.is_on(n) && !held(n)).collect();
        let named = if self.name.is_ascii() && !self.name.is_empty() { &self.name } else { "a model in the window" };
        let mut notes = vec![format!(
            "{}{} from {named} (check sum {:08x}). Rebound and tension are positive.",
            dashpot_output::WRITTEN,
            env!("CARGO_PKG_VERSION"),
            fmu::check_sum(self.text.as_bytes())
        )];
        let mut said = Vec::new();
        if !left_out.is_empty() {
            said.push(format!("Left out, for a property file has no place for it: {}.", left_out.join(", ")));
        }
        // What chatters is the curve, which is all that the file holds.
        let mut alone = *params;
        alone.disable_all();
        alone.enable("fv_curve", true).map_err(|fault| anyhow::anyhow!("{}", fault.reason.text()))?;
        said.extend(chatter::remarks(&alone, chatter::Host::USUAL));
        notes.extend(said.iter().cloned());
        let gas_force = if xml && params.is_on("gas_preload") { params.scalar("gas_force") } else { 0.0 };
        let properties = Properties { curve: Curve::of(params, model), straight: false, gas_force, notes };
        let written = property::write(&properties, if xml { Form::Xml } else { Form::TeimOrbit });
        dashpot_output::check([path])?;
        dashpot_output::replace_file(path, written.as_bytes())
            .with_context(|| format!("cannot write {}", path.display()))?;
        Ok(said)
    }

    fn adams(&self, path: &Path, model: &Model) -> anyhow::Result<Vec<String>> {
        let _held = FolderLock::take(path)?;
        let put = |name: &str, bytes: &[u8]| {
            let path = path.join(name);
            dashpot_output::replace_file(&path, bytes).with_context(|| format!("cannot write {}", path.display()))
        };
        put("damper.toml", self.text.as_bytes())?;
        let name = if cfg!(windows) { "dashpot_adams.dll" } else { "dashpot_adams.so" };
        let beside = std::env::current_exe()?.with_file_name(name);
        let mut libraries: Vec<(&str, Vec<u8>)> = [("linux64", "dashpot_adams.so"), ("win64", "dashpot_adams.dll")]
            .into_iter()
            .filter_map(|(platform, name)| Some((name, runtimes::compiled(platform, name)?.to_vec())))
            .collect();
        if libraries.is_empty() && beside.is_file() {
            libraries.push((name, std::fs::read(&beside)?));
        }
        let mut said = chatter::remarks(&self.params, chatter::Host::USUAL);
        if libraries.is_empty() {
            said.insert(0, format!("THE LIBRARY IS NOT HERE. {}", runtimes::HOW));
        }
        let (files, no_native) = folder::files(&self.params, model, "damper.toml", LENGTH, &Matrix::default());
        for file in files {
            let text = if file.name == "README.txt" { folder::above(&said, &file.text) } else { file.text };
            put(file.name, text.as_bytes())?;
        }
        libraries.iter().try_for_each(|(name, content)| put(name, content))?;
        said.extend(no_native.map(|reason| format!("There is no native.adm, because {reason}")));
        Ok(said)
    }
}

/// Distance of the damper's markers at zero displacement, mm; as the command's default, to be set in the folder's files.
const LENGTH: f64 = 400.0;
