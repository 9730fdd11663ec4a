//! Files and folders that the user names, in the system's own dialogs, beside the window.

use crate::session::Waker;
use crate::session::exports::Host;
use crate::session::papers::Paper;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};

/// What is asked for.
#[derive(Debug, Clone, PartialEq)]
pub enum Ask {
    /// A folder of records.
    Folder,
    /// Record files.
    Files,
    /// A folder of records to compare with.
    Reference,
    /// A model file.
    Model,
    /// Where to save the model.
    SaveModel,
    /// Where to export to.
    Export(Host),
    /// Where a report or a workbook goes.
    Paper(Paper),
    /// Where a text goes, with the name that is proposed.
    Text(&'static str, String),
    /// Where a picture of a part of the window goes: left, top, right, bottom.
    Picture([f32; 4]),
}

impl Ask {
    /// Name that is proposed, and the endings of names that fit.
    fn proposed(&self) -> (&'static str, &'static [&'static str]) {
        match self {
            Ask::Folder | Ask::Reference => ("", &[]),
            Ask::Files => ("", &dashpot_records::ENDINGS),
            Ask::Model => ("", &["toml"]),
            Ask::SaveModel => ("damper.toml", &["toml"]),
            Ask::Export(Host::Property) => (Host::Property.proposed(), &["dpr", "xml"]),
            Ask::Export(host) => (host.proposed(), &["fmu"]),
            Ask::Paper(paper) => paper.proposed(),
            Ask::Text(name, _) => (name, if name.ends_with(".svg") { &["svg"] } else { &["csv"] }),
            Ask::Picture(_) => ("plot.png", &["png"]),
        }
    }
}

/// Who asks the user.
pub trait Dialogs {
    /// Asks; does not wait.
    fn ask(&mut self, ask: Ask, waker: Waker);
    /// What was named, once; nothing where the user thought better of it.
    fn answer(&mut self) -> Option<(Ask, Vec<PathBuf>)>;
}

/// The system's dialogs.
pub struct Native {
    send: Sender<(Ask, Vec<PathBuf>)>,
    answers: Receiver<(Ask, Vec<PathBuf>)>,
}

impl Default for Native {
    fn default() -> Self {
        let (send, answers) = channel();
        Native { send, answers }
    }
}

impl Dialogs for Native {
    fn ask(&mut self, ask: Ask, waker: Waker) {
        let send = self.send.clone();
        // On a thread of its own: the dialog waits for the user.
        let asking = move || {
            let (name, endings) = ask.proposed();
            let dialog = rfd::FileDialog::new();
            let dialog = if endings.is_empty() { dialog } else { dialog.add_filter(endings.join(", "), endings) };
            let paths = match &ask {
                Ask::Folder | Ask::Reference => dialog.pick_folder().into_iter().collect(),
                Ask::Files => dialog.pick_files().unwrap_or_default(),
                Ask::Model => dialog.pick_file().into_iter().collect(),
                _ => dialog.set_file_name(name).save_file().into_iter().collect::<Vec<PathBuf>>(),
            };
            let _ = send.send((ask, paths));
            waker();
        };
        let _ = std::thread::Builder::new().name("dialog".into()).spawn(asking);
    }

    fn answer(&mut self) -> Option<(Ask, Vec<PathBuf>)> {
        self.answers.try_recv().ok()
    }
}

/// Answers given beforehand, for tests.
#[derive(Default)]
pub struct Told {
    paths: Vec<Vec<PathBuf>>,
    asked: Vec<Ask>,
}

impl Told {
    /// What will be named, question by question; nothing stands for a user who thinks better of it.
    pub fn naming(paths: Vec<Vec<PathBuf>>) -> Told {
        Told { paths, asked: Vec::new() }
    }
}

impl Dialogs for Told {
    fn ask(&mut self, ask: Ask, waker: Waker) {
        self.asked.push(ask);
        waker();
    }

    fn answer(&mut self) -> Option<(Ask, Vec<PathBuf>)> {
        let ask = self.asked.pop()?;
        let paths = if self.paths.is_empty() { Vec::new() } else { self.paths.remove(0) };
        Some((ask, paths))
    }
}
