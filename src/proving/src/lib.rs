//! Evaluation of the diagnosis: dampers with injected effects of stated severity, and the rate of correct names.
//!
//! Only this crate uses both sides: the rig that injects effects, and the diagnosis.
//!
//! | file | contents |
//! |---|---|
//! | [`laboratory`] | campaigns of the second laboratory at a stated severity |
//! | [`drawing`] | the drawing of a damper of the second laboratory |
//! | [`semi_active`] | accuracy of the identification of a semi-active damper of the second laboratory |
//! | [`outcome`] | the result of the diagnosis, compared with the truth |
//! | [`suite`] | the cases of the benchmark |
//! | [`split`] | the splits of the seeds, and the ledger of used seeds |
//! | [`score`] | the table of results and the confusion matrix |

pub mod drawing;
pub mod laboratory;
pub mod outcome;
pub mod score;
pub mod semi_active;
pub mod split;
pub mod suite;

/// Reason why a case cannot be run.
#[derive(Debug, thiserror::Error)]
pub enum EvaluationError {
    /// The case cannot be made.
    #[error(transparent)]
    Severity(#[from] dashpot_severity::SeverityError),
    /// The fit of an adjustable damper to the records fails.
    #[error("the family of the case's records: {0}")]
    Family(String),
    /// The second laboratory rejects the case.
    #[error(transparent)]
    Laboratory(#[from] dashpot_other_lab::LabError),
    /// The diagnosis rejects the case.
    #[error(transparent)]
    Diagnosis(#[from] dashpot_diagnosis::DiagnosisError),
}
