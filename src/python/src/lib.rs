//! The compiled part of the Python package `dashpot`: records, models and dampers as objects, results as JSON.
//!
//! What a user sees is written in Python on top of this (`python/dashpot`), where results become dataclasses. They cross as
//! the JSON that the command writes, so that both say the same digits: every number is printed so that it reads back to the bit.
//!
//! | file | what |
//! |---|---|
//! | `campaign` | rig records |
//! | `model` | model files, and the force for a motion |
//! | `identify`, `compare`, `examine` | fit, validate, diagnose |
//! | `damper` | many dampers, stepped together |
//! | `export` | FMU |
//! | `rig` | the virtual rig |
//! | `errors` | exceptions with the sentences of the command |
//! | `progress` | calls back into Python while the work runs without the interpreter's lock |

mod campaign;
mod compare;
mod damper;
mod errors;
mod examine;
mod export;
mod identify;
mod model;
mod progress;
mod rig;

use pyo3::prelude::*;

/// The compiled part of dashpot; use the package `dashpot`, which wraps it.
#[pymodule]
mod _native {
    #[pymodule_export]
    use super::set_threads;
    #[pymodule_export]
    use crate::campaign::Campaign;
    #[pymodule_export]
    use crate::compare::{Compared, validate};
    #[pymodule_export]
    use crate::damper::Dampers;
    #[pymodule_export]
    use crate::errors::{
        DashpotError, DiagnosisError, ExportError, FitError, ModelError, MotionError, OutputError, RecordError,
        RigError, StepError, ValidationError,
    };
    #[pymodule_export]
    use crate::examine::{Diagnosed, diagnose};
    #[pymodule_export]
    use crate::export::export_fmu;
    #[pymodule_export]
    use crate::identify::fit;
    #[pymodule_export]
    use crate::model::{Model, write};
    #[pymodule_export]
    use crate::rig::measure;

    /// Version of the package.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
    /// Whether a fault of the program becomes an exception instead of the end of the process.
    #[pymodule_export]
    const UNWINDS: bool = cfg!(panic = "unwind");
}

/// Threads that fit, validate and diagnose may use; False where they have started already. As many as there are processors where
/// it is never called.
#[pyfunction]
fn set_threads(count: usize) -> bool {
    rayon::ThreadPoolBuilder::new().num_threads(count).build_global().is_ok()
}
