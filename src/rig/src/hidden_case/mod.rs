//! Cases for a diagnosis: a campaign on a neutral damper with injected effects, and the truth about these effects in a
//! sealed folder.

mod run;
mod sealed;

pub use sealed::{CLEAN_FORCE_FILE, SEALED_FOLDER, TRUTH_FILE};

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

use crate::{Campaign, Options, Plan};

/// Injected effects, tests and options of a case.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct InjectedCase {
    /// Names from [`crate::EFFECTS`] or [`crate::UNKNOWN_EFFECTS`] and their strengths. `name:form` selects a physical
    /// form. Without a form, the seed selects it.
    ///
    /// Strength 0 gives exactly the neutral damper, and 1 is a typical strong case. The effect on the force grows
    /// monotonically with the strength.
    pub effects: Vec<(String, f64)>,
    /// Plan of the tests.
    pub plan: Plan,
    /// Seed, noise and channels. The seed determines the damper, the shapes of the effects, the order of the tests and
    /// the noise, each by a separate random stream. The damper therefore does not depend on the injected effects.
    pub options: Options,
}

/// The records and the truth of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct InjectedCampaign {
    /// Records in the order of measurement; their times count from the start of the campaign.
    pub campaign: Campaign,
    /// Injected effects, which are the correct diagnosis.
    pub truth: Truth,
}

/// The injected effects of a campaign.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Truth {
    /// The seed of the case.
    pub seed: u64,
    /// The injected effects. Empty for the neutral damper.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub effects: Vec<InjectedEffect>,
    /// Names, which end with the unit, and values of the parameters of the neutral damper.
    pub damper: BTreeMap<String, f64>,
}

/// One injected effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InjectedEffect {
    /// Name, as in [`crate::EFFECTS`] or [`crate::UNKNOWN_EFFECTS`].
    pub name: String,
    /// Physical form of the effect.
    pub form: String,
    /// Strength of the effect: 0 means absent, 1 a typical strong case.
    pub strength: f64,
    /// Shape parameters drawn from the seed, at strength 1. The names end with the unit, except those of pure numbers.
    pub shapes: BTreeMap<String, f64>,
}
