//! Physical effects and measurement errors that can be injected into the neutral damper, one file each.
//!
//! Every effect has a strength: 0 means absent, 1 a typical strong case. The force of the effect grows smoothly and
//! monotonically with the strength, so that bisection finds the strength for a required force. Shape parameters, and
//! the physical form if there are several, are drawn from the seed and do not depend on the strength.

mod aeration;
mod bump_stop;
mod bushing;
mod cavitation;
mod channel_delay;
mod force_drift;
mod force_offset;
mod free_play;
mod frequency_selective_damping;
mod gas_spring;
mod moving_mass;
mod oil_compressibility;
mod position_dependent_damping;
mod presliding_friction;
mod rebound_stop;
mod side_force_friction;
#[cfg(test)]
mod signatures;
mod stop;
mod stribeck_friction;
mod temperature_fade;
mod unknown;
mod valve_hysteresis;

use crate::RigError;
use crate::draw::Draw;
pub(crate) use crate::neutral::DamperEffect;
use crate::neutral::Neutral;

/// Names of the effects that a diagnosis is expected to know.
///
/// Viscous friction is excluded, because an identified force-velocity curve absorbs it completely.
pub const EFFECTS: [&str; 19] = [
    "gas_spring",
    "stribeck_friction",
    "presliding_friction",
    "side_force_friction",
    "bushing",
    "oil_compressibility",
    "aeration",
    "cavitation",
    "temperature_fade",
    "position_dependent_damping",
    "bump_stop",
    "rebound_stop",
    "free_play",
    "frequency_selective_damping",
    "valve_hysteresis",
    "moving_mass",
    "channel_delay",
    "force_offset",
    "force_drift",
];

/// Names of effects that no catalog of damper models contains. The correct diagnosis is an unnamed missing effect.
pub const UNKNOWN_EFFECTS: [&str; 11] = [
    "unknown_shear_softening",
    "unknown_rig_resonance",
    "unknown_crosshead_tilt",
    "unknown_load_cell_hysteresis",
    "unknown_start_up_memory",
    "unknown_position_lag_loop",
    "unknown_third_harmonic",
    "unknown_stick_slip_bursts",
    "unknown_hose_resonance",
    "unknown_wear_step",
    "unknown_self_pumping",
];

/// Name on the command line that requests the neutral damper, without injected effects.
pub const NOTHING: &str = "nothing";

/// An effect with drawn parameters, and the data that [`crate::Truth`] states about it.
pub(crate) struct RandomEffect {
    pub name: &'static str,
    pub form: &'static str,
    pub strength: f64,
    /// Names (with unit) and values of the drawn shape parameters.
    pub shapes: Vec<(String, f64)>,
    pub effect: Box<dyn DamperEffect>,
}

/// Inputs for drawing an effect.
pub(crate) struct Recipe<'a> {
    pub strength: f64,
    pub neutral: &'a Neutral,
    /// Time from the start of the campaign to the end of the last test, s.
    pub campaign_s: f64,
    pub draw: Draw,
    wanted: Option<&'a str>,
    name: &'static str,
    /// The selected form; it is the first form if the requested form is unknown, and `refused` then lists the forms.
    form: &'static str,
    refused: Option<&'static [&'static str]>,
}

impl Recipe<'_> {
    /// Selects the physical form: the requested form, else a form drawn from the seed.
    fn form(&mut self, forms: &'static [&'static str]) -> usize {
        // Always draw, so that the request of a form does not change the shape parameters.
        let drawn = self.draw.choice(forms.len());
        let index = match self.wanted {
            None => drawn,
            Some(wanted) => forms.iter().position(|form| *form == wanted).unwrap_or_else(|| {
                self.refused = Some(forms);
                0
            }),
        };
        self.form = forms[index];
        index
    }
}

/// Splits `name:form`. Rejects names that are in neither [`EFFECTS`] nor [`UNKNOWN_EFFECTS`].
pub(crate) fn split_name(text: &str) -> Result<(&'static str, Option<&str>), RigError> {
    let (name, form) = text.split_once(':').map_or((text, None), |(name, form)| (name, Some(form)));
    match EFFECTS.iter().chain(&UNKNOWN_EFFECTS).find(|known| **known == name) {
        Some(known) => Ok((known, form)),
        None => Err(RigError::Option {
            option: "hide",
            problem: format!(
                "'{name}' is no effect of the rig; give '{NOTHING}' or some of: {}; {}",
                EFFECTS.join(", "),
                UNKNOWN_EFFECTS.join(", ")
            ),
        }),
    }
}

/// Draws the effect that `text` requests as `name` or `name:form`. Rejects unknown names and forms.
pub(crate) fn draw(
    text: &str,
    strength: f64,
    seed: u64,
    neutral: &Neutral,
    campaign_s: f64,
) -> Result<RandomEffect, RigError> {
    let (name, wanted) = split_name(text)?;
    let draw = Draw::new(seed, name);
    let mut recipe = Recipe { strength, neutral, campaign_s, draw, wanted, name, form: "", refused: None };
    let hidden = build(&mut recipe);
    if let Some(forms) = recipe.refused {
        return Err(RigError::Option {
            option: "hide",
            problem: format!("'{}' is no form of {name}; it has: {}", wanted.unwrap_or_default(), forms.join(", ")),
        });
    }
    Ok(RandomEffect { name, form: recipe.form, strength, shapes: recipe.draw.values, effect: hidden })
}

fn build(recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    match recipe.name {
        "gas_spring" => gas_spring::draw(recipe),
        "stribeck_friction" => stribeck_friction::draw(recipe),
        "presliding_friction" => presliding_friction::draw(recipe),
        "side_force_friction" => side_force_friction::draw(recipe),
        "bushing" => bushing::draw(recipe),
        "oil_compressibility" => oil_compressibility::draw(recipe),
        "aeration" => aeration::draw(recipe),
        "cavitation" => cavitation::draw(recipe),
        "temperature_fade" => temperature_fade::draw(recipe),
        "position_dependent_damping" => position_dependent_damping::draw(recipe),
        "bump_stop" => bump_stop::draw(recipe),
        "rebound_stop" => rebound_stop::draw(recipe),
        "free_play" => free_play::draw(recipe),
        "frequency_selective_damping" => frequency_selective_damping::draw(recipe),
        "valve_hysteresis" => valve_hysteresis::draw(recipe),
        "moving_mass" => moving_mass::draw(recipe),
        "channel_delay" => channel_delay::draw(recipe),
        "force_offset" => force_offset::draw(recipe),
        "force_drift" => force_drift::draw(recipe),
        unknown => unknown::draw(unknown, recipe),
    }
}
