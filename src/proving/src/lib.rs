//! The proving ground of the diagnosis: dampers with effects hidden in them at a stated severity, and how often the right
//! name comes back.
//!
//! The only place that knows both sides: the rig that hides and the laboratory that looks. Severity is what refitting the
//! base model cannot absorb, in units of the noise; any other measure would count effects that no data can show.
//!
//! | file | what |
//! |---|---|
//! | [`case`] | a case: what is hidden at which severity, and which model is diagnosed |
//! | [`asked`] | the strengths of what somebody asks to hide |
//! | [`laboratory`] | the same for campaigns of the second laboratory |
//! | [`drawing`] | what a drawing of a damper of the second laboratory says |
//! | [`severity`] | the strength that makes a severity |
//! | [`outcome`] | what the diagnosis answered, beside the sealed truth |
//! | [`suite`] | the cases of the benchmark |
//! | [`split`] | which seeds a figure may come from, and the ledger of those that were opened |
//! | [`score`] | the table of figures and the confusion matrix |

pub mod asked;
pub mod case;
pub mod drawing;
pub mod laboratory;
pub mod measured;
pub mod outcome;
pub mod score;
pub mod semi_active;
pub mod severity;
pub mod split;
pub mod suite;

/// Why a case cannot be run.
#[derive(Debug, thiserror::Error)]
pub enum EvaluationError {
    /// The rig refuses it.
    #[error(transparent)]
    Rig(#[from] dashpot_rig::RigError),
    /// The second laboratory refuses it.
    #[error(transparent)]
    Laboratory(#[from] dashpot_other_lab::LabError),
    /// Its records cannot be read back.
    #[error("reading the case's own records: {0}")]
    Records(String),
    /// The base model cannot be fitted.
    #[error(transparent)]
    Fit(#[from] dashpot_identification::FitError),
    /// The diagnosis refuses it.
    #[error(transparent)]
    Diagnosis(#[from] dashpot_diagnosis::DiagnosisError),
    /// No folder for the records.
    #[error("no folder for the records: {0}")]
    Folder(#[from] std::io::Error),
    /// The model gives no finite force.
    #[error("the base model gives no finite force for the case's records")]
    NotFinite,
    /// Samples that cannot be compared.
    #[error("the case's records have other samples than those of the neutral damper")]
    OtherSamples,
    /// No strength makes this severity with these tests.
    #[error("{effect} reaches a severity of {reached:.2} with these tests, not {wanted}: the model absorbs the rest")]
    OutOfReach {
        /// The effect.
        effect: String,
        /// The largest severity found.
        reached: f64,
        /// The severity asked for.
        wanted: f64,
    },
    /// A severity on tests that are no plan of the rig's.
    #[error("a severity needs one of the rig's plans; with tests of your own (--matrix), give strengths (--strength)")]
    OwnTests,
    /// A severity without noise.
    #[error("a severity is in units of the noise, and there is none; give --noise, or strengths (--strength)")]
    NoNoise,
}
