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
//! | `family` | dampers over a setting: fit, validate, simulate |
//! | `dimensions` | priors from the dimensions of a damper |
//! | `explain` | what a model says of gas, oil and valves |
//! | `literature` | models of the literature as files |
//! | `groups` | diagnose many dampers against one |
//! | `check` | chatter in a host |
//! | `limits` | tables of limits, and what records say of them |
//! | `adams` | files of Adams, and models from them and from tables |
//! | `damper` | many dampers, stepped together |
//! | `export` | FMU |
//! | `papers` | reports, workbooks, certificates, figures |
//! | `rig` | the virtual rig, and matrices of tests |
//! | `errors` | exceptions with the sentences of the command |
//! | `work` | long work without the interpreter's lock, on threads of its own, ended by Ctrl-C |
//! | `progress` | calls back into Python meanwhile |

mod adams;
mod campaign;
mod check;
mod compare;
mod damper;
mod dimensions;
mod errors;
mod examine;
mod explain;
mod export;
mod family;
mod groups;
mod identify;
mod limits;
mod literature;
mod model;
mod papers;
mod progress;
mod rig;
mod work;

use pyo3::prelude::*;

/// The compiled part of dashpot; use the package `dashpot`, which wraps it.
#[pymodule]
mod _native {
    #[pymodule_export]
    use crate::adams::{export_adams, export_adm, export_dpr, import_dpr, import_peaks};
    #[pymodule_export]
    use crate::campaign::Campaign;
    #[pymodule_export]
    use crate::check::check;
    #[pymodule_export]
    use crate::compare::validate;
    #[pymodule_export]
    use crate::damper::Dampers;
    #[pymodule_export]
    use crate::errors::{
        DashpotError, DiagnosisError, DimensionsError, ExportError, FitError, ModelError, MotionError, OutputError,
        RecordError, RigError, StepError, ValidationError,
    };
    #[pymodule_export]
    use crate::examine::{Diagnosed, diagnose, diagnose_family};
    #[pymodule_export]
    use crate::explain::{explain, explain_family};
    #[pymodule_export]
    use crate::export::export_fmu;
    #[pymodule_export]
    use crate::family::{Family, fit_family};
    #[pymodule_export]
    use crate::groups::{Grouped, diagnose_groups};
    #[pymodule_export]
    use crate::identify::{Fitted, fit};
    #[pymodule_export]
    use crate::limits::{Figures, check_limits, read_limits};
    #[pymodule_export]
    use crate::literature::fit_literature;
    #[pymodule_export]
    use crate::model::{Model, write};
    #[pymodule_export]
    use crate::papers::{write_diagnosis, write_fit, write_groups, write_next_tests, write_validation};
    #[pymodule_export]
    use crate::rig::{measure, test_matrix};
    #[pymodule_export]
    use crate::work::set_threads;

    /// Version of the package.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
    /// Whether a fault of the program becomes an exception instead of the end of the process.
    #[pymodule_export]
    const UNWINDS: bool = cfg!(panic = "unwind");
}
