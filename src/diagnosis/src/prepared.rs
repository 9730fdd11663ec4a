//! Preparation of records for a diagnosis, with or without a reference.

use super::options::{DiagnosisError, Options};
use super::{opposite, reference};
use dashpot_core::Params;
use dashpot_estimation::gap::errors;
use dashpot_estimation::heating::Heating;
use dashpot_estimation::refit::Effort;
use dashpot_estimation::samples::{self, Test};
use dashpot_estimation::sensitivity::Accuracy;
use dashpot_estimation::situation::Situation;
use dashpot_estimation::step_at_rest::{has_dry_friction, read_step};
use dashpot_estimation::structure::context::Structure;
use dashpot_estimation::structure::curve_at_rest::with_other_form_at_rest;
use dashpot_estimation::structure::starts::{self, StartModel};
use dashpot_records::Record;
use std::sync::Arc;

/// Prepared input of a diagnosis.
pub(super) struct Prepared {
    /// Tests that refits use.
    pub fitted: Vec<Test>,
    /// Left-out tests.
    pub left: Vec<Test>,
    /// Heat that the damper absorbed, evaluated at each fitted test.
    pub heating: Arc<Heating>,
    /// Properties of the fitted tests that determine which effects they can show.
    pub situation: Situation,
}

/// Splits the records into fitted and left-out tests, and computes the [`Situation`] of the fitted tests.
pub(super) fn prepare(records: &[&Record], held_out: &[bool], params: &Params) -> Prepared {
    let all = samples::as_long_as_remembered(samples::tests(records), params);
    let out = |test: &Test| held_out.get(test.record).copied().unwrap_or(false);
    let (left, fitted): (Vec<Test>, Vec<Test>) = all.into_iter().partition(out);
    let heating = Arc::new(Heating::new(records, &fitted));
    let situation = Situation::new(params, records, &fitted);
    Prepared { fitted, left, heating, situation }
}

/// Reference damper.
pub(super) struct Against {
    /// Structure of the model fitted to the reference damper.
    pub structure: Structure,
    /// Names of tests without a counterpart in the reference campaign.
    pub missing: Vec<String>,
    /// Names of tests whose nearest counterpart in the reference has another speed or stroke.
    pub shifted: Vec<String>,
}

/// Returns the structure with the step of its FV curve at zero velocity converted to friction and gas force. Returns
/// the structure unchanged if it already has friction, or if the conversion raises the mean square residual by more
/// than 5 %. `fit` fits a model to the records.
fn with_friction(structure: Structure, fit: impl Fn(&Params) -> Option<Structure>) -> Structure {
    /// Largest ratio of the mean square residual with friction to that without friction at which the friction is
    /// accepted.
    const OPEN: f64 = 1.05;
    let params = structure.hypothesis.params(&structure.refit.theta);
    if has_dry_friction(&params) {
        return structure;
    }
    let read = read_step(&params).and_then(|read| fit(&read));
    read.filter(|read| read.evidence.mean() <= OPEN * structure.evidence.mean()).unwrap_or(structure)
}

/// Returns the tests of the reference to which tests are compared. They are the fitted tests, but each road is there
/// whole and with every stretch. So any stretch of the same road has its counterpart.
fn counterparts(reference: &[&Record], fitted: Vec<Test>) -> Vec<Test> {
    let is_cyclic = |test: &Test| !reference.get(test.record).is_some_and(|record| samples::is_road(record));
    fitted.into_iter().filter(is_cyclic).chain(samples::of_all_extents(reference)).collect()
}

impl Prepared {
    /// Fits the model to the reference, and corrects the tests by the form error, which this damper shares with the
    /// reference. Returns the structure of the reference, and the tests without an equal counterpart.
    pub fn against(
        &mut self,
        records: &[&Record],
        options: &Options,
        params: &Params,
    ) -> Result<Against, DiagnosisError> {
        let reference = &options.reference;
        let good: Vec<&Record> = reference.iter().collect();
        let own = prepare(&good, &[], params);
        if own.fitted.is_empty() {
            let turned = opposite::opposite(records, reference);
            return Err(DiagnosisError::NothingToCompare { turned });
        }
        // Fit the given model in both forms of its FV curve at zero velocity, kinked and smooth, if the curve has both.
        // If the model has no friction, also fit models made from the records alone. Without friction in the reference
        // model, a change of friction could not be found.
        let no_heat = |(mut hypothesis, components): StartModel| {
            hypothesis.heating = None;
            (hypothesis.with_priors(&options.priors), components)
        };
        let start = |params: &Params| no_heat(starts::from_params(params, &own.heating));
        let mut all = vec![start(params)];
        all.extend(with_other_form_at_rest(params).as_ref().map(start));
        if !has_dry_friction(params) {
            all.extend(starts::plain(&own.fitted, &own.heating, &|_| true).into_iter().map(no_heat));
        }
        let fit =
            |(hypothesis, components): StartModel| Structure::fit(hypothesis, components, &own.fitted, Effort::FINE);
        let structure = all
            .into_iter()
            .filter_map(fit)
            .max_by(|a, b| a.log_posterior.total_cmp(&b.log_posterior))
            .ok_or(DiagnosisError::NotFinite)?;
        let structure = with_friction(structure, |params| fit(start(params)));
        // Use the integration of the refits, because its error is then equal for this damper and the reference damper.
        let known = counterparts(&good, own.fitted);
        let residual = errors(Accuracy::Single, &structure.hypothesis, &structure.refit.theta, &good, &known);
        let residual = residual.ok_or(DiagnosisError::NotFinite)?;
        let (mut missing, mut shifted) = (Vec::new(), Vec::new());
        for tests in [&mut self.fitted, &mut self.left] {
            let found = reference::without_shared_error(std::mem::take(tests), &known, &residual);
            *tests = found.tests;
            missing.extend(found.missing);
            shifted.extend(found.shifted);
        }
        // The heating refers to tests by index, so it must refer to the new list of tests.
        self.heating = Arc::new(self.heating.of_tests(&self.fitted));
        Ok(Against { structure, missing, shifted })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes a road of half a minute. Its displacement and force have the noise of one of several measurements.
    fn road(measurement: f64) -> Record {
        let n = 15_000;
        let time: Vec<f64> = (0..n).map(|k| 2e-3 * k as f64).collect();
        let noise = |k: usize| libm::sin(1e3 * k as f64 + measurement * (k * k % 977) as f64);
        let parts = [(0.02, 8.3, 0.1), (0.005, 39.1, 1.0), (0.001, 80.7, 2.0)];
        let displacement = |t: f64| parts.iter().map(|(a, w, at)| a * libm::sin(w * t + at)).sum::<f64>();
        let velocity = |t: f64| parts.iter().map(|(a, w, at)| a * w * libm::cos(w * t + at)).sum::<f64>();
        Record {
            name: "road".into(),
            displacement: time.iter().enumerate().map(|(k, t)| displacement(*t) + 2e-5 * noise(k)).collect(),
            velocity: time.iter().map(|t| velocity(*t)).collect(),
            force: time.iter().enumerate().map(|(k, t)| 1500.0 * velocity(*t) + 5.0 * noise(k)).collect(),
            time,
            amplitude: 0.026,
            peak_velocity: 0.4,
            ..Record::default()
        }
    }

    #[test]
    fn every_stretch_of_a_road_has_its_counterpart_in_the_same_road_of_the_reference() {
        let (own, good) = (road(1.0), road(2.0));
        // Among many tests a road is cut into a few stretches, but alone it is one test.
        let tests = samples::tests(&[&own; 30]);
        assert_eq!(tests.len(), 120);
        for count in [1, 10] {
            let reference = vec![&good; count];
            let known = counterparts(&reference, samples::tests(&reference));
            let residual: Vec<Vec<f64>> = known.iter().map(|test| test.forces().to_vec()).collect();
            let freed = reference::without_shared_error(tests.clone(), &known, &residual);
            assert_eq!(freed.missing, Vec::<String>::new());
            // The residual of the reference is its force, so only noise remains.
            for test in &freed.tests {
                let rest = test.forces().iter().map(|force| force * force).sum::<f64>() / test.count() as f64;
                assert!(rest.sqrt() < 0.05 * test.segment.top, "{rest} of {}", test.segment.top);
            }
        }
    }
}
