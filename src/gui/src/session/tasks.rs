//! Long tasks in the background: reading, fitting, validating, diagnosing, studying, writing. One task runs at a time, with
//! [`Kind::Respond`] as the only exception. A task reports its progress, and the user can cancel it.

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

/// Kind of task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Reads records.
    Read,
    /// Reads records of another campaign for comparison.
    ReadReference,
    /// Identifies a model.
    Fit,
    /// Validates the model.
    Validate,
    /// Searches for the missing effect.
    Diagnose,
    /// Varies a parameter.
    Study,
    /// Compares the forces of model and tests after steps of the setting.
    Respond,
    /// Writes files for a host, or a report.
    Write,
}

/// Result of a task.
pub enum Outcome {
    /// Records for fit, validation and diagnosis.
    Read(Loaded),
    /// Records for comparison.
    Reference(Loaded),
    /// A fitted model of an ordinary damper.
    Fitted(Fitted),
    /// A fitted model of an adjustable damper.
    FittedFamily(Box<FamilyFit>),
    /// Result of a validation and its basis.
    Validated(Box<Validation>, Box<Basis>),
    /// Result of a diagnosis and its basis.
    Diagnosed(Diagnosed, Box<Basis>),
    /// Loops of one test for several values of a parameter.
    Studied(Study),
    /// Responses to steps of the setting.
    Responded(Vec<StepResponse>),
    /// A written file or folder, and notes on it.
    Written(PathBuf, Vec<String>),
}

/// A running task.
pub struct Task {
    /// Kind of the task.
    pub kind: Kind,
    /// Start time.
    pub began: Instant,
    cancel: Cancel,
    progress: Arc<Mutex<Progress>>,
    result: Receiver<Option<Result<Outcome, Sentence>>>,
}

/// Status of a task.
// A box would not save memory, because there is only one value at a time, and it is consumed immediately.
#[allow(clippy::large_enum_variant)]
pub enum Standing {
    /// The task is running.
    Working,
    /// The task has stopped after a request to cancel.
    Cancelled,
    /// The task is complete, with its result.
    Done(Result<Outcome, Sentence>),
}

impl Task {
    /// Starts a task.
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
        // If the thread cannot start, its channel is closed, so the session treats the task as cancelled.
        drop(began);
        Task { kind, began: Instant::now(), cancel, progress, result }
    }

    /// Requests the task to stop.
    pub fn cancel(&self) {
        self.cancel.ask();
    }

    /// Returns whether a stop of the task was requested.
    pub fn is_cancelled(&self) -> bool {
        self.cancel.asked()
    }

    /// Returns the progress of the task.
    pub fn progress(&self) -> Progress {
        self.progress.lock().map(|p| p.clone()).unwrap_or_default()
    }

    /// Returns the status of the task. A cancelled task has no result, even if it completed just before the request.
    pub fn standing(&self) -> Standing {
        match self.result.try_recv() {
            Ok(_) if self.is_cancelled() => Standing::Cancelled,
            Ok(Some(result)) => Standing::Done(result),
            Err(TryRecvError::Empty) => Standing::Working,
            Ok(None) | Err(TryRecvError::Disconnected) => Standing::Cancelled,
        }
    }
}
