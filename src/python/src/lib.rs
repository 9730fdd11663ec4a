//! The compiled part of the Python package `dashpot`. It provides records, models and dampers as objects, and results as JSON.
//!
//! The user interface is Python code on top of this part (`python/dashpot`), which converts results to dataclasses. Results are passed as
//! the JSON of the command-line program, so Python and that program give equal digits. Every number is printed so that it parses back to a
//! bitwise equal value.
//!
//! | file | what |
//! |---|---|
//! | `campaign` | rig records |
//! | `model` | model files, and the force for a motion |
//! | `identify`, `compare`, `examine` | fit, validate, diagnose |
//! | `family` | dampers over a setting: fit, validate, simulate |
//! | `dimensions` | priors from the dimensions of a damper |
//! | `explain` | properties of gas, oil and valves that follow from a model |
//! | `literature` | models of the literature as files |
//! | `groups` | diagnose many dampers against one |
//! | `check` | chatter in a host |
//! | `limits` | tables of limits, and their checks on records |
//! | `adams` | files of Adams, and models from such files and from tables |
//! | `damper` | many dampers in one step |
//! | `export` | FMU |
//! | `papers` | reports, workbooks, certificates, figures |
//! | `rig` | the virtual rig, and matrices of tests |
//! | `errors` | exceptions with the messages of the command-line program |
//! | `work` | long work without the interpreter lock, on separate threads, interrupted by Ctrl-C |
//! | `progress` | calls of a Python function during long work |

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

/// Compiled part of dashpot. Use the package `dashpot`, which wraps it.
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
    use crate::limits::{Figures, SettingsFigures, check_limits, is_same_setting, read_limits, restate_setting};
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
    /// Whether a panic of the program becomes an exception instead of aborting the process.
    #[pymodule_export]
    const UNWINDS: bool = cfg!(panic = "unwind");
    /// Kinds of notes that are warnings.
    #[pymodule_export]
    const LOUD_NOTES: [&str; 6] = dashpot_records::Note::LOUD;
}
