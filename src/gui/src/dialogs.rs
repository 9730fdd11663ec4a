//! Non-blocking dialogs of the operating system for files and folders.

use crate::session::Waker;
use crate::session::exports::Host;
use crate::session::papers::Paper;
use std::cell::{Cell, RefCell};
use std::ffi::OsString;
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};

/// A request for a file or a folder, which a dialog shows to the user.
#[derive(Debug, Clone, PartialEq)]
pub enum Ask {
    /// A folder of records.
    Folder,
    /// Record files.
    Files,
    /// A folder of records for comparison.
    Reference,
    /// A model file.
    Model,
    /// A file of dimensions.
    Dimensions,
    /// File to which the model is saved.
    SaveModel,
    /// File or folder for an export.
    Export(Host),
    /// File for a report or a workbook.
    Paper(Paper),
    /// File for a text: the proposed name, and the text.
    Text(&'static str, String),
    /// File for a picture of a part of the window: left, top, right, bottom, points.
    Picture([f32; 4]),
}

impl Ask {
    /// Returns the proposed name and the accepted extensions.
    pub fn proposed(&self) -> (&'static str, &'static [&'static str]) {
        match self {
            Ask::Folder | Ask::Reference => ("", &[]),
            Ask::Files => ("", &dashpot_records::EXTENSIONS),
            Ask::Model | Ask::Dimensions => ("", &["toml"]),
            Ask::SaveModel => ("damper.toml", &["toml"]),
            Ask::Export(Host::Property) => (Host::Property.proposed(), &["dpr", "xml"]),
            Ask::Export(host @ (Host::Fmu | Host::Fmu3 | Host::Vehicle)) => (host.proposed(), &["fmu"]),
            Ask::Export(Host::Adams) => (Host::Adams.proposed(), &[]),
            Ask::Paper(paper) => paper.proposed(),
            Ask::Text(name, _) => (name, if name.ends_with(".svg") { &["svg"] } else { &["csv"] }),
            Ask::Picture(_) => ("plot.png", &["png"]),
        }
    }
}

impl Ask {
    /// Returns whether the request is for a folder.
    pub fn is_of_folder(&self) -> bool {
        matches!(self, Ask::Folder | Ask::Reference | Ask::Export(Host::Adams))
    }

    /// Returns whether the file or folder must exist.
    pub fn is_of_input(&self) -> bool {
        matches!(self, Ask::Folder | Ask::Reference | Ask::Files | Ask::Model | Ask::Dimensions)
    }
}

/// Result of a request.
#[derive(Debug, Clone, PartialEq)]
pub enum Reply {
    /// The chosen paths; empty if the user cancelled.
    Paths(Vec<PathBuf>),
    /// The system shows no dialogs.
    NoDialog,
}

/// Source of the paths that the user chooses.
pub trait Dialogs {
    /// Opens a dialog that begins in a folder. Returns without waiting for the user.
    fn ask(&mut self, ask: Ask, from: Option<PathBuf>, waker: Waker);
    /// Returns the reply to a request, only once.
    fn poll(&mut self) -> Option<(Ask, Reply)>;
}

/// Shortest time after which an empty reply means that the user cancelled. On Linux, an earlier empty reply counts as [`Reply::NoDialog`].
/// A desktop portal that is missing or has no backend fails within this time, and no user cancels so quickly.
const SHOWN: Duration = Duration::from_millis(800);

thread_local! {
    /// Whether the last dialog of this thread could not be shown.
    static FAILED: Cell<bool> = const { Cell::new(false) };
}

/// Log of the dialog library. Without it, a dialog that cannot be shown looks like one that the user cancelled.
struct Failures;

impl log::Log for Failures {
    fn enabled(&self, of: &log::Metadata<'_>) -> bool {
        of.level() == log::Level::Error && of.target().starts_with("rfd")
    }

    fn log(&self, record: &log::Record<'_>) {
        // The library tries zenity last, so an error of the portal alone does not mean that no dialog was shown.
        if self.enabled(record.metadata()) && record.args().to_string().contains("zenity") {
            FAILED.set(true);
        }
    }

    fn flush(&self) {}
}

/// Returns whether the system may be able to show dialogs: over the desktop portal (D-Bus) or by zenity. Returns `true` on Windows and
/// macOS.
fn may_show(environment: Environment) -> bool {
    if cfg!(any(windows, target_os = "macos")) {
        return true;
    }
    let set = |name: &str| environment(name).filter(|value| !value.is_empty());
    let bus = set("DBUS_SESSION_BUS_ADDRESS").is_some()
        || set("XDG_RUNTIME_DIR").is_some_and(|folder| PathBuf::from(folder).join("bus").exists());
    let zenity = set("PATH").is_some_and(|path| std::env::split_paths(&path).any(|p| p.join("zenity").is_file()));
    bus || zenity
}

/// Function that returns an environment variable.
pub type Environment = fn(&str) -> Option<OsString>;

/// Dialogs of the operating system.
pub struct Native {
    environment: Environment,
    send: Sender<(Ask, Reply)>,
    answers: Receiver<(Ask, Reply)>,
}

impl Default for Native {
    fn default() -> Self {
        Native::new(|name| std::env::var_os(name))
    }
}

impl Native {
    /// Makes the dialogs for an environment, which decides whether the system may be able to show them.
    pub fn new(environment: Environment) -> Native {
        let _ = log::set_logger(&Failures).map(|()| log::set_max_level(log::LevelFilter::Error));
        let (send, answers) = channel();
        Native { environment, send, answers }
    }
}

impl Dialogs for Native {
    fn ask(&mut self, ask: Ask, from: Option<PathBuf>, waker: Waker) {
        let send = self.send.clone();
        if !may_show(self.environment) {
            let _ = send.send((ask, Reply::NoDialog));
            waker();
            return;
        }
        // The dialog blocks until the user replies, so it has its own thread.
        let asking = move || {
            let (name, endings) = ask.proposed();
            let dialog = rfd::FileDialog::new();
            let dialog = if let Some(from) = from { dialog.set_directory(from) } else { dialog };
            FAILED.set(false);
            let began = Instant::now();
            let dialog = if endings.is_empty() { dialog } else { dialog.add_filter(endings.join(", "), endings) };
            let paths: Vec<PathBuf> = match &ask {
                Ask::Folder | Ask::Reference => dialog.pick_folder().into_iter().collect(),
                Ask::Files => dialog.pick_files().unwrap_or_default(),
                Ask::Model | Ask::Dimensions => dialog.pick_file().into_iter().collect(),
                _ => dialog.set_file_name(name).save_file().into_iter().collect(),
            };
            let is_early = began.elapsed() < SHOWN && !cfg!(any(windows, target_os = "macos"));
            let failed = paths.is_empty() && (is_early || FAILED.get());
            let _ = send.send((ask, if failed { Reply::NoDialog } else { Reply::Paths(paths) }));
            waker();
        };
        let _ = std::thread::Builder::new().name("dialog".into()).spawn(asking);
    }

    fn poll(&mut self) -> Option<(Ask, Reply)> {
        self.answers.try_recv().ok()
    }
}

/// Dialogs that return prepared replies, for tests.
#[derive(Default)]
pub struct Message {
    paths: Vec<Vec<PathBuf>>,
    asked: Vec<Ask>,
    /// Initial folder of each request.
    began: Rc<RefCell<Vec<Option<PathBuf>>>>,
    /// Whether to simulate a system without dialogs.
    without: bool,
}

impl Message {
    /// Prepares one reply per request. An empty list means that the user cancels.
    pub fn naming(paths: Vec<Vec<PathBuf>>) -> Message {
        Message { paths, ..Message::default() }
    }

    /// Simulates a system without dialogs. `began` receives the initial folder of each request.
    pub fn without_dialogs(began: Rc<RefCell<Vec<Option<PathBuf>>>>) -> Message {
        Message { began, without: true, ..Message::default() }
    }
}

impl Dialogs for Message {
    fn ask(&mut self, ask: Ask, from: Option<PathBuf>, waker: Waker) {
        self.asked.push(ask);
        self.began.borrow_mut().push(from);
        waker();
    }

    fn poll(&mut self) -> Option<(Ask, Reply)> {
        let ask = self.asked.pop()?;
        if self.without {
            return Some((ask, Reply::NoDialog));
        }
        let paths = if self.paths.is_empty() { Vec::new() } else { self.paths.remove(0) };
        Some((ask, Reply::Paths(paths)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::process::Command;

    #[test]
    fn only_a_bus_or_zenity_can_show_dialogs() {
        assert!(!may_show(|_| None) && !may_show(|_| Some("".into())));
        assert!(!may_show(|name| (name != "DBUS_SESSION_BUS_ADDRESS").then(|| "/nowhere".into())));
        assert!(may_show(|name| (name == "DBUS_SESSION_BUS_ADDRESS").then(|| "unix:path=/nowhere".into())));
    }

    /// A bus without an answer, or without a portal, may fail after any time. The time of an empty reply therefore does not distinguish a
    /// failure from a cancellation.
    #[test]
    fn a_late_failure_is_known_by_the_log_and_a_failed_portal_alone_is_none() {
        let log = |text: std::fmt::Arguments<'_>, target: &str, level: log::Level| {
            FAILED.set(false);
            let record = log::Record::builder().level(level).target(target).args(text).build();
            log::Log::log(&Failures, &record);
            FAILED.get()
        };
        let of_portal = "rfd::backend::xdg_desktop_portal";
        assert!(log(format_args!("Failed to save file with zenity: No such file"), of_portal, log::Level::Error));
        assert!(!log(format_args!("OpenFile failed: NameHasNoOwner"), of_portal, log::Level::Error));
        assert!(!log(format_args!("Using zenity fallback"), of_portal, log::Level::Warn));
        assert!(!log(format_args!("zenity"), "egui", log::Level::Error));
    }

    /// Variable that the test sets for its child process.
    const CHILD: &str = "DASHPOT_TEST_WITHOUT_DIALOGS";

    /// The test runs itself in a child process without display, because a developer's desktop would show the dialog.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_bus_that_does_not_answer_and_no_zenity_are_known_by_the_library_itself() {
        if std::env::var_os(CHILD).is_none() {
            let name = "dialogs::tests::a_bus_that_does_not_answer_and_no_zenity_are_known_by_the_library_itself";
            let mut child = Command::new(std::env::current_exe().unwrap());
            child.args(["--exact", name]).env_clear().env(CHILD, "1").env("PATH", "/nowhere");
            child.env("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nowhere/bus");
            let output = child.output().unwrap();
            let said = String::from_utf8_lossy(&output.stdout);
            assert!(output.status.success() && said.contains("1 passed"), "{said}");
            return;
        }
        let mut dialogs = Native::default();
        assert!(may_show(dialogs.environment), "the bus is named, so it is tried");
        for ask in [Ask::SaveModel, Ask::Folder, Ask::Files, Ask::Model] {
            dialogs.ask(ask.clone(), None, std::sync::Arc::new(|| ()));
            let answer = dialogs.answers.recv_timeout(Duration::from_secs(60)).unwrap();
            assert_eq!(answer, (ask, Reply::NoDialog));
        }
        // The library logs the failure. So the failure is detected even if it occurs after a long time.
        FAILED.set(false);
        assert_eq!(rfd::FileDialog::new().save_file(), None);
        assert!(FAILED.get());
    }
}
