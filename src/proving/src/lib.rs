//! The proving ground of the diagnosis: dampers with effects hidden in them at a stated severity, and how often the right
//! name comes back.
//!
//! The only place that knows both sides: the rig that hides and the laboratory that looks.
//!
//! | file | what |
//! |---|---|
//! | [`laboratory`] | campaigns of the second laboratory at a stated severity |
//! | [`drawing`] | what a drawing of a damper of the second laboratory says |
//! | [`semi_active`] | how well a semi-active damper of the second laboratory is identified |
//! | [`outcome`] | what the diagnosis answered, beside the sealed truth |
//! | [`suite`] | the cases of the benchmark |
//! | [`split`] | which seeds a figure may come from, and the ledger of those that were opened |
//! | [`score`] | the table of figures and the confusion matrix |

pub mod drawing;
pub mod laboratory;
pub mod outcome;
pub mod score;
pub mod semi_active;
pub mod split;
pub mod suite;

/// Why a case cannot be run.
#[derive(Debug, thiserror::Error)]
pub enum EvaluationError {
    /// It cannot be made.
    #[error(transparent)]
    Severity(#[from] dashpot_severity::SeverityError),
    /// No family is fitted to its records.
    #[error("the family of the case's records: {0}")]
    Family(String),
    /// The second laboratory refuses it.
    #[error(transparent)]
    Laboratory(#[from] dashpot_other_lab::LabError),
    /// The diagnosis refuses it.
    #[error(transparent)]
    Diagnosis(#[from] dashpot_diagnosis::DiagnosisError),
}
