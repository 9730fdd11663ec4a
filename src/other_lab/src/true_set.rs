//! The true effects of a campaign, by ablation: every effect whose removal visibly changes the force.

use crate::plant::Part;
use crate::{Accuracy, Campaign, Case, LabError};

/// Smallest visible change of the force due to the removal of an effect, relative to the test's root mean square force.
/// The change must also exceed the noise.
const LEAST_PART: f64 = 0.005;
/// Constant part of the standard deviation of the force noise, N.
const NOISE_N: f64 = 0.5;

impl Case {
    /// Returns the names of all effects whose individual removal visibly changes the force.
    ///
    /// A change is visible if it exceeds the noise and 0.5 % of the root mean square force in at least one test.
    /// Injected effects come first, then the effects of the damper itself.
    ///
    /// The campaign is simulated once for each injected effect and once for each part of the damper's physics.
    ///
    /// # Errors
    /// Returns the errors of [`Case::run`].
    pub fn true_set(&self) -> Result<Vec<String>, LabError> {
        let whole = self.run()?;
        let mut found = Vec::new();
        let mut add = |name: &str| {
            if !found.iter().any(|known| known == name) {
                found.push(name.to_owned());
            }
        };
        for k in 0..self.effects.len() {
            let mut without = self.clone();
            // At strength 0, an effect has no influence, so this run is the campaign without it.
            without.effects[k].1 = 0.0;
            if self.is_moved(&whole, &without.run()?) {
                add(self.effects[k].0.split(':').next().unwrap_or_default());
            }
        }
        for part in Part::ALL {
            let mut prepared = self.prepare()?;
            prepared.plant = prepared.plant.without(part);
            if self.is_moved(&whole, &self.run_prepared(prepared, &Accuracy::default())?) {
                add(part.effect());
            }
        }
        Ok(found)
    }

    fn is_moved(&self, whole: &Campaign, without: &Campaign) -> bool {
        let rms = |values: &mut dyn Iterator<Item = f64>| {
            let (sum, count) = values.fold((0.0, 0.0f64), |(sum, count), value| (sum + value * value, count + 1.0));
            (sum / count.max(1.0)).sqrt()
        };
        whole.tests.iter().zip(&without.tests).any(|(with, without)| {
            let force = rms(&mut with.clean_force_n.iter().copied());
            let pairs = with.clean_force_n.iter().zip(&without.clean_force_n);
            let moved = rms(&mut pairs.map(|(a, b)| a - b));
            moved > (0.01 * self.protocol.noise_percent * force + NOISE_N).max(LEAST_PART * force)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Kind, Plan, Protocol};

    fn case(kind: Kind, seed: u64) -> Case {
        let protocol = Protocol { plan: Plan::Reduced, ..Protocol::default() };
        Case { protocol, ..Case::new(kind, seed) }
    }

    #[test]
    fn physical_dampers_have_soft_oil_and_thesis_like_ones_have_not() {
        let has = |kind| case(kind, 3).true_set().unwrap().iter().any(|name| name == "oil_compressibility");
        assert!(has(Kind::TwinTube) && !has(Kind::ThesisLike));
    }

    #[test]
    fn injected_effect_is_true_where_it_is_strong_and_not_where_it_is_nothing() {
        let with = |strength| case(Kind::ThesisLike, 2).hiding("free_play", strength).true_set().unwrap();
        assert_eq!(with(2.0).first().map(String::as_str), Some("free_play"));
        assert!(!with(0.0).iter().any(|name| name == "free_play"));
    }
}
