//! Writing of files other than reports ([`super::papers`]): model files, options of reading, plots, exports. The output checks of the
//! command apply to all files. A file of another kind is never replaced, and no file is ever incomplete.

use crate::session::Session;
use crate::session::campaign::Loaded;
use crate::session::exports::{Export, Host};
use crate::session::guarded::write;
use crate::session::tasks::{Kind as Work, Outcome};
use dashpot_messages::Sentence;
use dashpot_output::Kind;
use dashpot_records::{Profile, profile};
use std::path::{Path, PathBuf};

/// Formats an error with its causes as one sentence.
pub fn error_sentence(error: &anyhow::Error) -> Sentence {
    Sentence::as_it_is(format!("{error:#}"))
}

impl Session {
    /// Saves the current model. Returns whether the file was written.
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
                self.complain(error_sentence(&error));
                false
            }
        }
    }

    /// Stores the options of reading as `campaign.toml` in the folder of the records. Returns whether the file was written.
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
                self.complain(error_sentence(&error));
                false
            }
        }
    }

    /// Excludes a test from all later readings of these records, in the window and by every verb.
    pub fn exclude(&mut self, test: usize) {
        let Some(name) = self.record(test).map(|r| r.name.clone()) else { return };
        if !self.reading.exclude.contains(&name) {
            self.reading.exclude.push(name);
        }
        if self.keep_reading() {
            self.read_again();
        }
    }

    /// Writes an export in the background.
    pub fn export(&mut self, host: Host, path: PathBuf) {
        let Some(model) = &self.model else { return };
        let export = Export { host, params: *model.params(), text: model.text(), name: model.name() };
        self.begin(Work::Write, move |report| {
            report(0.1, None);
            export.write(&path).map(|said| Outcome::Written(path, said)).map_err(|e| error_sentence(&e))
        });
    }
}

/// Formats a plot as CSV: a row for every point, with the name of its line.
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

/// Registers the campaign's records as inputs, because outputs must never replace inputs.
pub fn register_inputs(loaded: &Loaded) {
    dashpot_output::register_inputs(loaded.paths.iter().cloned());
}
