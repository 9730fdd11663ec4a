//! Cases for a diagnosis: a campaign on a neutral damper in which chosen effects are hidden, and the sealed truth.

mod run;
mod sealed;

pub use sealed::{CLEAN_FORCE_FILE, SEALED_FOLDER, TRUTH_FILE};

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

use crate::{Campaign, Options, Plan};

/// What is hidden, where, and how it is measured.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct InjectedCase {
    /// Names from [`crate::EFFECTS`] or [`crate::UNKNOWN_EFFECTS`] and their strengths. `name:form` asks for one of the
    /// effect's physical forms; otherwise the seed chooses. Strength 1 is a typical strong case; 0 leaves the neutral
    /// damper exactly as it is; in between and beyond, the trace in the force grows steadily.
    pub effects: Vec<(String, f64)>,
    /// The tests.
    pub plan: Plan,
    /// Seed, noise and channels. The seed chooses the damper, the shapes of the effects, the order of the tests and the
    /// noise, each by a stream of its own: the damper is the same whatever is hidden in it.
    pub options: Options,
}

/// A measured case.
#[derive(Debug, Clone, PartialEq)]
pub struct InjectedCampaign {
    /// Records on the campaign clock, in the order in which they were measured.
    pub campaign: Campaign,
    /// What a diagnosis should find.
    pub truth: Truth,
}

/// What is hidden in a campaign.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Truth {
    /// The seed of the case.
    pub seed: u64,
    /// What is hidden; empty for the neutral damper.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub effects: Vec<InjectedEffect>,
    /// The neutral damper's own figures; names end with their unit.
    pub damper: BTreeMap<String, f64>,
}

/// One hidden effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InjectedEffect {
    /// Name, as in [`crate::EFFECTS`] or [`crate::UNKNOWN_EFFECTS`].
    pub name: String,
    /// Physical form.
    pub form: String,
    /// Strength.
    pub strength: f64,
    /// Shapes drawn from the seed, at strength 1; names end with their unit, shares have none.
    pub shapes: BTreeMap<String, f64>,
}
