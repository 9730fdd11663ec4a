//! A second laboratory with dampers and rig campaigns by laws of the literature.
//!
//! It shares no code and no law with the identified model, nor with the first virtual rig. A diagnosis proves itself
//! on dampers that nobody tuned it for.
//!
//! Signs and units are those of the project: SI, extension and rebound positive, tension positive.

mod campaign;
mod case;
mod draw;
pub mod effects;
mod folder;
mod integrator;
mod jet;
mod machine;
pub mod plant;
pub mod protocol;
pub mod semi_active;
mod sensors;
mod trace;
mod true_set;

pub use campaign::{Accuracy, Campaign, TestRecord, Truth};
pub use case::{Case, InjectedEffect};
pub use folder::TRUTH_FILE;
pub use jet::Jet;
pub use plant::Kind;
pub use protocol::Protocol;
pub use protocol::plan::{LEFT_OUT_PREFIX, Plan};

use std::path::PathBuf;

/// What can go wrong.
#[derive(Debug, thiserror::Error)]
pub enum LabError {
    /// No such effect.
    #[error("there is no effect '{name}' to hide; choose one of: {names}")]
    Effect {
        /// What was asked for.
        name: String,
        /// What there is.
        names: String,
    },
    /// No such law.
    #[error("'{effect}' has no law '{law}'; choose one of: {laws}")]
    Law {
        /// The effect.
        effect: String,
        /// What was asked for.
        law: String,
        /// What there is.
        laws: String,
    },
    /// A strength that is none.
    #[error("the strength of '{effect}' is {strength}: it has to be 0 or more")]
    Strength {
        /// The effect.
        effect: String,
        /// What was asked for.
        strength: f64,
    },
    /// A protocol that cannot be run.
    #[error("the protocol cannot be run: {what}: {why}")]
    Protocol {
        /// The entry.
        what: &'static str,
        /// What is wrong with it.
        why: &'static str,
    },
    /// The simulation found no numbers.
    #[error("the simulation of '{test}' finds no finite force: choose a smaller strength or another seed")]
    NoNumbers {
        /// The test.
        test: String,
    },
    /// A folder that holds something.
    #[error("'{path}' is not an empty folder: choose a new one, so that records of two campaigns do not mix")]
    Folder {
        /// The folder.
        path: PathBuf,
    },
    /// A file that cannot be written.
    #[error("cannot write '{path}'")]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
}
