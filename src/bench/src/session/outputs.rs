//! Everything that is written: model files, what is known about records, files for hosts, reports. All through the guards of
//! the command's outputs: a file of another kind is never replaced, and nothing is ever half written.

use crate::session::Session;
use crate::session::campaign::Loaded;
use crate::session::tasks::{Diagnosed, Kind as Work, Outcome};
use crate::session::verbs::compared;
use anyhow::{Context as _, bail};
use dashpot_core::elements::{self, GROUPS};
use dashpot_core::{Model, Params};
use dashpot_hosts::adams::folder;
use dashpot_hosts::adams::property::{self, Curve, Form, Properties};
use dashpot_hosts::{fmu, runtimes};
use dashpot_identification::model_file;
use dashpot_identification::validation::validate;
use dashpot_output::{FolderLock, Kind};
use dashpot_records::{Profile, profile};
use dashpot_report::diagnosis::DiagnosisReport;
use dashpot_report::{Made, Print, ReportInput};
use dashpot_rig::Matrix;
use dashpot_simulation::chatter;
use dashpot_simulation::comparison::at_constant_velocity;
use std::path::{Path, PathBuf};

/// A host that a model is exported to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Host {
    /// FMI 2.0.
    Fmu,
    /// A run folder of Adams.
    Adams,
    /// A property file of Adams Car.
    Property,
}

impl Host {
    /// The name of the file or folder that is proposed.
    pub fn proposed(self) -> &'static str {
        match self {
            Host::Fmu => "damper.fmu",
            Host::Adams => "adams",
            Host::Property => "damper.dpr",
        }
    }
}

/// The error with its causes in one sentence.
fn told(error: &anyhow::Error) -> String {
    format!("{error:#}")
}

impl Session {
    /// Writes the model as it stands; whether it could.
    pub fn save(&mut self, path: &Path) -> bool {
        let Some(model) = &self.model else { return false };
        let (text, params) = (model.text(), *model.params());
        match write(path, Kind::Model, text.as_bytes()) {
            Ok(()) => {
                if let Some(model) = &mut self.model {
                    model.saved_to(path, params);
                }
                self.say(path.display().to_string());
                true
            }
            Err(error) => {
                self.complain(told(&error));
                false
            }
        }
    }

    /// Keeps how the records are read as `campaign.toml` beside them; whether it could.
    pub fn keep_reading(&mut self) -> bool {
        let Some(folder) = self.campaign.as_ref().and_then(|c| c.folder.clone()) else { return false };
        let path = folder.join(profile::FILE);
        let written = || -> anyhow::Result<()> {
            self.reading.check().map_err(anyhow::Error::msg)?;
            write(&path, Kind::Profile, Profile::from_options(&self.reading).text().as_bytes())
        };
        match written() {
            Ok(()) => {
                self.say(path.display().to_string());
                true
            }
            Err(error) => {
                self.complain(told(&error));
                false
            }
        }
    }

    /// Leaves a test out whenever these records are read, beside the window and by every verb.
    pub fn exclude(&mut self, test: usize) {
        let Some(name) = self.record(test).map(|r| r.name.clone()) else { return };
        if !self.reading.exclude.contains(&name) {
            self.reading.exclude.push(name);
        }
        if self.keep_reading() {
            self.read_again();
        }
    }

    /// Writes files for a host.
    pub fn export(&mut self, host: Host, path: PathBuf) {
        let Some(model) = &self.model else { return };
        let (params, text) = (*model.params(), model.text());
        self.begin(Work::Write, move |report| {
            report(0.1, "");
            export(host, &params, &text, &path).map(|()| Outcome::Written(path)).map_err(|e| told(&e))
        });
    }

    /// Writes the report of the validation.
    pub fn write_report(&mut self, path: PathBuf) {
        let (Some(loaded), Some(model)) = (self.campaign.clone(), &self.model) else { return };
        let named = model
            .path
            .as_ref()
            .and_then(|p| p.file_name())
            .map_or_else(String::new, |n| n.to_string_lossy().into_owned());
        let (file, ticked) = (model.file(), self.ticked());
        self.begin(Work::Write, move |report| {
            let compared = compared(&file, &loaded, &ticked, report)?;
            let validation = validate(&compared).map_err(|e| e.to_string())?;
            let input = ReportInput {
                words: &dashpot_report::words::EN,
                print: Print::Brief,
                made: Made { version: env!("CARGO_PKG_VERSION").to_owned(), ..Made::default() },
                curve: at_constant_velocity(
                    &model_file::prepared(&file.params).map_err(|e| e.to_string())?,
                    &validation,
                ),
                model_file: named,
                data: loaded.named(),
                validation: &validation,
                tests: &compared,
                parameters: Vec::new(),
                identification: Vec::new(),
                extra: Vec::new(),
            };
            checked(&path, Kind::Report).map_err(|e| told(&e))?;
            dashpot_report::write_atomic(&input, &path).map(|()| Outcome::Written(path)).map_err(|e| told(&e))
        });
    }

    /// Writes the report of the diagnosis.
    pub fn write_diagnosis(&mut self, path: PathBuf) {
        let (Some(loaded), Some(Diagnosed { found, over_whole_records, .. }), Some(model)) =
            (self.campaign.clone(), &self.answers.diagnosis, &self.model)
        else {
            return;
        };
        let model_file = model
            .path
            .as_ref()
            .and_then(|p| p.file_name())
            .map_or_else(String::new, |n| n.to_string_lossy().into_owned());
        let (found, over_whole_records, ticked) = (found.clone(), *over_whole_records, self.ticked());
        self.begin(Work::Write, move |_| {
            let records: Vec<_> = ticked.iter().filter_map(|k| loaded.campaign.records.get(*k)).collect();
            let report = DiagnosisReport {
                model_file,
                data: loaded.named(),
                found: &found,
                records: &records,
                reading: loaded.campaign.notes.iter().map(|n| n.text.clone()).collect(),
                over_whole_records,
                parameters: Vec::new(),
            };
            checked(&path, Kind::Report).map_err(|e| told(&e))?;
            report.write(&path).map(|()| Outcome::Written(path)).map_err(|e| told(&e))
        });
    }
}

/// Refuses a place where something else would be lost.
fn checked(path: &Path, kind: Kind) -> anyhow::Result<()> {
    dashpot_output::check_kinds([(Some(path), kind)])
}

/// Writes a file of a kind.
pub fn write(path: &Path, kind: Kind, bytes: &[u8]) -> anyhow::Result<()> {
    checked(path, kind)?;
    dashpot_output::replace_file(path, bytes).with_context(|| format!("cannot write {}", path.display()))
}

fn export(host: Host, params: &Params, text: &str, path: &Path) -> anyhow::Result<()> {
    let model = Model::new(params).map_err(|fault| anyhow::anyhow!("{}", fault.reason.text()))?;
    match host {
        Host::Fmu => {
            dashpot_output::check([path])?;
            let holds_one = runtimes::compiled("linux64", "dashpot_damper.so").is_some();
            let library = std::env::current_exe()?.with_file_name("libdashpot.a");
            if !holds_one && !library.is_file() {
                bail!("there is no {} to make an FMU from; {}", library.display(), runtimes::HOW);
            }
            let options = fmu::Options {
                version: fmu::Version::Two,
                scales: fmu::Scales { motion: 1.0, force: 1.0, position_offset: 0.0 },
                name: "dashpot damper",
                from_source: (!holds_one).then_some(library.as_path()),
                sources: true,
                more: &[],
                remarks: &chatter::remarks(params, chatter::Host::USUAL),
            };
            let made = fmu::fmu(&[*params], &options)?;
            write(path, Kind::Fmu, &made.bytes)
        }
        Host::Property => {
            if !params.is_on("fv_curve") {
                bail!("the element fv_curve is off, so there is no curve to export");
            }
            let xml = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("xml"));
            let held = |name: &str| name == "fv_curve" || (xml && name == "gas_preload");
            let left_out: Vec<&str> =
                GROUPS[..elements::COUNT].iter().map(|g| g.name).filter(|n| params.is_on(n) && !held(n)).collect();
            let mut notes =
                vec![format!("Written by dashpot {}. Rebound and tension are positive.", env!("CARGO_PKG_VERSION"))];
            if !left_out.is_empty() {
                notes.push(format!("Left out, for a property file has no place for it: {}.", left_out.join(", ")));
            }
            let properties = Properties {
                curve: Curve::of(params, &model),
                straight: false,
                gas_force: if xml && params.is_on("gas_preload") { params.scalar("gas_force") } else { 0.0 },
                notes,
            };
            let written = property::write(&properties, if xml { Form::Xml } else { Form::TeimOrbit });
            dashpot_output::check([path])?;
            dashpot_output::replace_file(path, written.as_bytes())
                .with_context(|| format!("cannot write {}", path.display()))
        }
        Host::Adams => adams(params, &model, text, path),
    }
}

/// Distance of the damper's markers at zero displacement, mm; as the command's default, to be set in the folder's README.
const LENGTH: f64 = 400.0;

fn adams(params: &Params, model: &Model, text: &str, path: &Path) -> anyhow::Result<()> {
    let _held = FolderLock::take(path)?;
    let put = |name: &str, bytes: &[u8]| {
        let path = path.join(name);
        dashpot_output::replace_file(&path, bytes).with_context(|| format!("cannot write {}", path.display()))
    };
    put("damper.toml", text.as_bytes())?;
    let name = if cfg!(windows) { "dashpot_adams.dll" } else { "dashpot_adams.so" };
    let beside = std::env::current_exe()?.with_file_name(name);
    let mut libraries: Vec<(&str, Vec<u8>)> = [("linux64", "dashpot_adams.so"), ("win64", "dashpot_adams.dll")]
        .into_iter()
        .filter_map(|(platform, name)| Some((name, runtimes::compiled(platform, name)?.to_vec())))
        .collect();
    if libraries.is_empty() && beside.is_file() {
        libraries.push((name, std::fs::read(&beside)?));
    }
    for file in folder::files(params, model, "damper.toml", LENGTH, &Matrix::default()).0 {
        let missing = libraries.is_empty() && file.name == "README.txt";
        let note = if missing { format!("THE LIBRARY IS NOT HERE. {}\n\n", runtimes::HOW) } else { String::new() };
        put(file.name, (note + &file.text).as_bytes())?;
    }
    libraries.iter().try_for_each(|(name, content)| put(name, content))
}

/// A plot as a table: every line with its two columns.
pub fn table(heading: [&str; 2], lines: &[(String, Vec<[f64; 2]>)]) -> String {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let mut out = format!("line,{},{}\n", quoted(heading[0]), quoted(heading[1]));
    for (name, points) in lines {
        for [x, y] in points {
            out += &format!("{},{x},{y}\n", quoted(name));
        }
    }
    out
}

/// The campaign's own records are never replaced: the outputs know them as inputs of this run.
pub fn remember_inputs(loaded: &Loaded) {
    dashpot_output::remember_inputs(loaded.paths.iter().cloned());
}
