//! A case: a damper, its injected effects, and the protocol of measurement.

use crate::LabError;
use crate::draw::Draw;
use crate::effects::{self, EffectModel};
use crate::plant::{Kind, Plant};
use crate::protocol::Protocol;
use serde::Serialize;

/// A damper, its injected effects, and the protocol of measurement.
#[derive(Debug, Clone)]
pub struct Case {
    /// Kind of damper.
    pub plant: Kind,
    /// Names and strengths of the injected effects. `name:law` selects the law, one of the effect's equations. Without
    /// a law, the seed selects it.
    pub effects: Vec<(String, f64)>,
    /// Protocol of the measurement.
    pub protocol: Protocol,
    /// Seed of the damper, of the effects' parameters and of the order of the tests.
    pub seed: u64,
    /// Seed of the sensor noise. Another seed gives another measurement of the same damper.
    pub noise_seed: u64,
}

/// An injected effect.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct InjectedEffect {
    /// Name of the effect.
    pub effect: String,
    /// Name of the law, which is one of the effect's equations.
    pub law: String,
    /// Strength of the effect: 0 has no influence, 1 is typical.
    pub strength: f64,
    /// Whether a diagnosis should name the effect.
    pub known: bool,
}

pub(crate) struct Prepared {
    pub plant: Plant,
    pub effects: Vec<Box<dyn EffectModel>>,
    pub truth: Vec<InjectedEffect>,
}

impl Case {
    /// Makes a case without injected effects, with the default protocol.
    pub fn new(plant: Kind, seed: u64) -> Case {
        Case { plant, effects: Vec::new(), protocol: Protocol::default(), seed, noise_seed: seed }
    }

    /// Adds an injected effect.
    #[must_use]
    pub fn hiding(mut self, effect: &str, strength: f64) -> Case {
        self.effects.push((effect.to_owned(), strength));
        self
    }

    /// Returns the reference: the damper without the injected effects, in the same tests and order, but with different
    /// noise.
    #[must_use]
    pub fn reference(&self) -> Case {
        Case { effects: Vec::new(), noise_seed: self.noise_seed ^ 0x5265_6665_7265_6e63, ..self.clone() }
    }

    pub(crate) fn prepare(&self) -> Result<Prepared, LabError> {
        let plant = Plant::new(self.plant, self.seed);
        let (mut effects, mut truth) = (Vec::new(), Vec::new());
        for (asked, strength) in &self.effects {
            let (name, law) = asked.split_once(':').map_or((asked.as_str(), None), |(n, l)| (n, Some(l)));
            let Some(effect) = effects::find(name) else {
                let names: Vec<&str> = effects::names().collect();
                return Err(LabError::Effect { name: name.to_owned(), names: names.join(", ") });
            };
            let laws: Vec<&str> = effect.laws.iter().map(|(name, _)| *name).collect();
            let chosen = match law {
                None => Draw::new(self.seed, &format!("law of {name}")).choice(laws.len()),
                Some(law) => laws.iter().position(|known| *known == law).ok_or_else(|| LabError::Law {
                    effect: name.to_owned(),
                    law: law.to_owned(),
                    laws: laws.join(", "),
                })?,
            };
            if !strength.is_finite() || *strength < 0.0 {
                return Err(LabError::Strength { effect: name.to_owned(), strength: *strength });
            }
            truth.push(InjectedEffect {
                effect: name.to_owned(),
                law: laws[chosen].to_owned(),
                strength: *strength,
                known: effects::KNOWN.iter().any(|e| e.name == name),
            });
            if *strength > 0.0 {
                let mut draw = Draw::new(self.seed, &format!("{name}:{}", laws[chosen]));
                effects.push((effect.laws[chosen].1)(*strength, &plant.scale, &mut draw));
            }
        }
        Ok(Prepared { plant, effects, truth })
    }
}
