//! Long work beside the window: reading, fitting, validating, diagnosing, studying, writing. One of a kind at a time; each says how
//! far it is and can be told to stop.

use crate::session::Waker;
use crate::session::campaign::Loaded;
use crate::session::progress::{Progress, Report};
use crate::session::results::{Basis, Diagnosed, Fitted};
use crate::session::study::Study;
use dashpot_estimation::cancel::Cancel;
use dashpot_identification::family::FamilyFit;
use dashpot_identification::validation::{StepResponse, Validation};
use dashpot_messages::Sentence;
use dashpot_messages::Template;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::sync::{Arc, Mutex};
use std::time::Instant;

/// What is being done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Records are read.
    Read,
    /// Records of another campaign are read, to compare with.
    ReadReference,
    /// A model is identified.
    Fit,
    /// The model is validated.
    Validate,
    /// The missing effect is sought.
    Diagnose,
    /// A number is studied.
    Study,
    /// The force of tests is compared after steps of the setting.
    Respond,
    /// Files for a host, or a report, are written.
    Write,
}

/// What came of it.
pub enum Outcome {
    /// Records.
    Read(Loaded),
    /// Records to compare with.
    Reference(Loaded),
    /// A model.
    Fitted(Fitted),
    /// A damper over a setting.
    FittedFamily(Box<FamilyFit>),
    /// Errors, and of what.
    Validated(Box<Validation>, Box<Basis>),
    /// What a model lacks, and of what.
    Diagnosed(Diagnosed, Box<Basis>),
    /// A family of loops.
    Studied(Study),
    /// Responses to steps of the setting.
    Responded(Vec<StepResponse>),
    /// A file or folder was written, and what must be known beside it.
    Written(PathBuf, Vec<String>),
}

/// Work under way.
pub struct Task {
    /// What it is.
    pub kind: Kind,
    /// When it began.
    pub began: Instant,
    cancel: Cancel,
    progress: Arc<Mutex<Progress>>,
    result: Receiver<Option<Result<Outcome, Sentence>>>,
}

/// How a task stands.
// One at a time, and taken apart at once: a box would save nothing.
#[allow(clippy::large_enum_variant)]
pub enum Standing {
    /// Under way.
    Working,
    /// Told to stop, and stopped.
    Cancelled,
    /// At its end.
    Done(Result<Outcome, Sentence>),
}

impl Task {
    /// Begins.
    pub fn begin(
        kind: Kind,
        waker: Waker,
        work: impl FnOnce(Report<'_>) -> Result<Outcome, Sentence> + Send + 'static,
    ) -> Task {
        let (cancel, progress) = (Cancel::default(), Arc::new(Mutex::new(Progress::default())));
        let (send, result) = channel();
        let (own_cancel, own_progress, own_waker) = (cancel.clone(), progress.clone(), waker.clone());
        let began = std::thread::Builder::new().name("task".into()).spawn(move || {
            let report = |done: f64, text: Option<Template>| {
                if let Ok(mut progress) = own_progress.lock() {
                    progress.done = progress.done.max(done);
                    progress.text = text.or(progress.text);
                }
                own_waker();
            };
            let done = own_cancel.run(|| work(&report));
            let _ = send.send(done);
            own_waker();
        });
        // Without a thread the channel is closed, which reads as cancelled.
        drop(began);
        Task { kind, began: Instant::now(), cancel, progress, result }
    }

    /// Tells it to stop.
    pub fn cancel(&self) {
        self.cancel.ask();
    }

    /// Whether it was told to stop.
    pub fn is_cancelled(&self) -> bool {
        self.cancel.asked()
    }

    /// How far it is.
    pub fn progress(&self) -> Progress {
        self.progress.lock().map(|p| p.clone()).unwrap_or_default()
    }

    /// How it stands. Whoever pressed Cancel gets no result, even one that was whole a moment before.
    pub fn standing(&self) -> Standing {
        match self.result.try_recv() {
            Ok(_) if self.is_cancelled() => Standing::Cancelled,
            Ok(Some(result)) => Standing::Done(result),
            Err(TryRecvError::Empty) => Standing::Working,
            Ok(None) | Err(TryRecvError::Disconnected) => Standing::Cancelled,
        }
    }
}
