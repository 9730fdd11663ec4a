//! Refit of a model and samples as in a diagnosis, for programs that inject an effect of a given severity.

use dashpot_core::Params;
use dashpot_estimation::hypothesis::Hypothesis;
use dashpot_estimation::prior_set::PriorSet;
use dashpot_estimation::refit;
use dashpot_estimation::samples;
use dashpot_estimation::vocabulary::base_numbers;
use dashpot_records::Record;

/// Refits a model to noise-free records. Returns the model with the residual of every sample, relative to the stated
/// noise of its record.
///
/// Returns `None` if the model gives no finite force.
pub fn refitted(records: &[&Record], noise: &[f64], params: &Params) -> Option<(Params, Vec<f64>)> {
    let mut tests = samples::as_long_as_remembered(samples::tests(records), params);
    for test in &mut tests {
        let noise = noise[test.record];
        test.allowed.iter_mut().for_each(|a| *a = noise);
    }
    let base = Hypothesis { base: *params, numbers: base_numbers(params), heating: None, priors: PriorSet::default() };
    let found = refit::refit(&base, &tests, &base.start(), None, refit::Effort::FINE)?;
    Some((base.params(&found.theta), found.residual.as_slice().to_vec()))
}

/// Returns the mean cycle's force of every record, by name, at the samples that a diagnosis uses.
pub fn mean_cycles(records: &[&Record]) -> Vec<(String, Vec<f64>)> {
    samples::tests(records).iter().map(|t| (t.segment.name.clone(), t.forces().to_vec())).collect()
}
