//! A second laboratory: dampers and rig campaigns with laws from the literature.
//!
//! This crate shares no code and no law with the identified model or the first virtual rig (`dashpot-rig`). It
//! therefore tests a diagnosis on dampers that did not influence the development of the diagnosis.
//!
//! All values are in SI units; extension (rebound) and tension are positive.

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

/// Errors of the second laboratory.
#[derive(Debug, thiserror::Error)]
pub enum LabError {
    /// An unknown effect.
    #[error("there is no effect '{name}' to hide; choose one of: {names}")]
    Effect {
        /// Name of the requested effect.
        name: String,
        /// Names of the available effects.
        names: String,
    },
    /// An unknown law.
    #[error("'{effect}' has no law '{law}'; choose one of: {laws}")]
    Law {
        /// Name of the effect.
        effect: String,
        /// Name of the requested law.
        law: String,
        /// Names of the laws of the effect.
        laws: String,
    },
    /// An invalid strength.
    #[error("the strength of '{effect}' is {strength}: it has to be 0 or more")]
    Strength {
        /// Name of the effect.
        effect: String,
        /// The requested strength.
        strength: f64,
    },
    /// An invalid protocol.
    #[error("the protocol cannot be run: {what}: {why}")]
    Protocol {
        /// The invalid entry of the protocol.
        what: &'static str,
        /// The problem with the entry.
        why: &'static str,
    },
    /// A simulation without a finite force.
    #[error("the simulation of '{test}' finds no finite force: choose a smaller strength or another seed")]
    NoNumbers {
        /// Name of the test.
        test: String,
    },
    /// A folder that is not empty.
    #[error("'{path}' is not an empty folder: choose a new one, so that records of two campaigns do not mix")]
    Folder {
        /// Path of the folder.
        path: PathBuf,
    },
    /// A file that is not writable.
    #[error("cannot write '{path}'")]
    Io {
        /// Path of the file.
        path: PathBuf,
        /// Error of the operating system.
        source: std::io::Error,
    },
}
