//! Dampers of the virtual rig with injected effects of stated severity.
//!
//! Severity is the part of an effect that a refit of the base model cannot absorb, relative to the noise. Other
//! measures would include effects that no data can show.
//!
//! | file | contents |
//! |---|---|
//! | [`case`] | a case: the injected effects with their severities, and the diagnosed model |
//! | [`request`] | the strengths of the effects that a user requests |
//! | [`context`] | the severity of an effect, and the strength that gives a severity |
//! | [`measured`] | a campaign of the rig in the form that a user has |

pub mod case;
pub mod context;
pub mod measured;
pub mod request;

use dashpot_messages::format_number;

/// Reason why a case cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum SeverityError {
    /// The rig rejects the case.
    #[error(transparent)]
    Rig(#[from] dashpot_rig::RigError),
    /// The records cannot be read back.
    #[error("reading the case's own records: {0}")]
    Records(String),
    /// The base model cannot be fitted.
    #[error(transparent)]
    Fit(#[from] dashpot_identification::FitError),
    /// A folder for the records cannot be made.
    #[error("no folder for the records: {0}")]
    Folder(#[from] std::io::Error),
    /// The model gives no finite force.
    #[error("the base model gives no finite force for the case's records")]
    NotFinite,
    /// The samples differ from those of the neutral damper.
    #[error("the case's records have other samples than those of the neutral damper")]
    OtherSamples,
    /// No strength has this severity with these tests.
    #[error("{effect} reaches a severity of {reached:.2} with these tests, not {}: the model absorbs the rest", format_number(*wanted))]
    OutOfReach {
        /// Name of the effect.
        effect: String,
        /// The severity of a trial that is nearest to the requested one.
        reached: f64,
        /// The requested severity.
        wanted: f64,
    },
    /// A severity is requested for tests that are not those of a plan of the rig.
    #[error("a severity needs one of the rig's plans; with tests of your own (--matrix), give strengths (--strength)")]
    OwnTests,
    /// A severity is requested without noise.
    #[error("a severity is in units of the noise, and there is none; give --noise, or strengths (--strength)")]
    NoNoise,
}
