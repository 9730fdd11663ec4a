//! Test plans for the neutral damper: short campaigns that reveal injected effects, and poor plans that reveal only
//! some effects.

mod diagnosis;
mod poor;

use crate::{Matrix, RigError};

/// Names of the plans, for [`Plan::named`].
pub const PLANS: [&str; 7] =
    ["diagnosis", "thesis", "one-amplitude", "one-frequency", "no-slow-tests", "centred", "no-side-force"];

/// Prefix of the names of tests that a diagnosis should use only for verification.
pub const CHECK_PREFIX: &str = "check_";

/// Tests of a campaign.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Plan {
    /// 34 tests over strokes, frequencies, mean positions and side force, and 14 more for verification, in shuffled
    /// order.
    ///
    /// Three of the 34 tests are one reference test, at start, middle and end.
    #[default]
    Diagnosis,
    /// The matrix of the thesis (Jonnalagadda & Vyas 2020), in the order of the thesis.
    Thesis,
    /// Poor plan: sines at 25 mm only.
    OneAmplitude,
    /// Poor plan: sines at 2 Hz only.
    OneFrequency,
    /// Poor plan: the diagnosis plan without tests below 50 mm/s.
    NoSlowTests,
    /// Poor plan: the diagnosis plan about mid-stroke only.
    Centred,
    /// Poor plan: the diagnosis plan without side force.
    NoSideForce,
}

impl Plan {
    /// Returns the plan with a name in [`PLANS`].
    ///
    /// # Errors
    /// [`RigError::Option`] with the list of plans, if the name is unknown.
    pub fn named(name: &str) -> Result<Self, RigError> {
        Ok(match name {
            "diagnosis" => Self::Diagnosis,
            "thesis" => Self::Thesis,
            "one-amplitude" => Self::OneAmplitude,
            "one-frequency" => Self::OneFrequency,
            "no-slow-tests" => Self::NoSlowTests,
            "centred" => Self::Centred,
            "no-side-force" => Self::NoSideForce,
            _ => {
                return Err(RigError::Option {
                    option: "plan",
                    problem: format!("'{name}' is no plan; give one of: {}", PLANS.join(", ")),
                });
            }
        })
    }

    /// Returns the tests, in the order of execution. `order` is the seed for the shuffle; the thesis's plan is not
    /// shuffled. The order of the tests influences the temperatures.
    pub fn matrix(self, order: u64) -> Matrix {
        let tests = match self {
            Self::Thesis => return Matrix::default(),
            Self::Diagnosis => diagnosis::tests(),
            Self::OneAmplitude => poor::one_amplitude(),
            Self::OneFrequency => poor::one_frequency(),
            Self::NoSlowTests => poor::without_slow_tests(),
            Self::Centred => poor::centred(),
            Self::NoSideForce => poor::without_side_force(),
        };
        Matrix::new(diagnosis::shuffled(tests, order)).expect("the plans are within the rig's limits")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_plan_has_its_name_and_runs_in_a_shuffled_order() {
        for name in PLANS {
            let plan = Plan::named(name).unwrap();
            let matrix = plan.matrix(1);
            assert!(matrix.points().len() >= 6, "{name}");
            let names = |order| {
                let mut names: Vec<String> = plan.matrix(order).points().iter().map(|p| p.name.clone()).collect();
                names.sort();
                names
            };
            assert_eq!(names(1), names(2), "{name}: the order changes, the tests do not");
            if plan != Plan::Thesis {
                assert_ne!(plan.matrix(1), plan.matrix(2), "{name}");
            }
        }
        let message = Plan::named("best").unwrap_err().to_string();
        assert!(message.contains("'best'") && message.contains("diagnosis, thesis"), "{message}");
    }

    #[test]
    fn diagnosis_covers_what_it_says() {
        let matrix = Plan::Diagnosis.matrix(5);
        let points = matrix.points();
        assert_eq!(points.len(), 48);
        assert_eq!(points.iter().filter(|p| p.name.starts_with(CHECK_PREFIX)).count(), 14);
        assert_eq!(points.iter().filter(|p| p.road_seed.is_some()).count(), 3);
        let references: Vec<usize> = (0..48).filter(|i| points[*i].name.starts_with("reference")).collect();
        assert_eq!((references[0], references[2]), (0, 47));
        assert!((20..28).contains(&references[1]));
        assert!(points.iter().all(|p| p.peak_velocity_m_s <= 1.6 && p.frequency_hz <= 25.03 && p.cycles >= 3));
        for side in [500.0, 1000.0] {
            assert!(points.iter().any(|p| p.side_force_n == side));
        }
        assert!(points.iter().any(|p| p.mean_displacement_m == 0.025));
        assert!(points.iter().any(|p| p.mean_displacement_m == -0.025));
        assert!(points.iter().filter(|p| p.peak_velocity_m_s < 0.02).count() >= 5);
        // Each check test differs in amplitude, mean displacement or side force from all training tests.
        for check in points.iter().filter(|p| p.name.starts_with(CHECK_PREFIX)) {
            assert!(points.iter().filter(|p| !p.name.starts_with(CHECK_PREFIX)).all(|p| {
                (p.amplitude_m, p.mean_displacement_m, p.side_force_n)
                    != (check.amplitude_m, check.mean_displacement_m, check.side_force_n)
            }));
        }
    }

    #[test]
    fn poor_plans_lack_what_their_name_says() {
        let of = |name: &str| Plan::named(name).unwrap().matrix(0).points().to_vec();
        assert!(of("one-amplitude").iter().all(|p| p.amplitude_m == 0.025));
        assert!(of("one-frequency").iter().all(|p| (p.frequency_hz - 2.0).abs() < 1e-9));
        assert!(of("no-slow-tests").iter().all(|p| p.peak_velocity_m_s >= 0.05));
        assert!(of("centred").iter().all(|p| p.mean_displacement_m == 0.0));
        assert!(of("no-side-force").iter().all(|p| p.side_force_n == 0.0));
    }
}
