//! Thresholds of the decisions in a diagnosis, with their reasons.

/// Smallest probability at which an effect is named. Below it, the name would more often be wrong than correct.
pub const NAMED: f64 = 0.5;

/// Ratio of the residual to the noise of the mean cycles above which a diagnosis without a finding reports both values
/// in a note.
///
/// If the residual is twice the noise, the form error is 1.7 times the noise. The form error then limits the findings
/// more than the noise does. The value decides only whether a note is added. Test:
/// `a_residual_above_twice_the_noise_is_stated_with_it`.
pub const CLEARLY: f64 = 2.0;

/// Largest root mean square residual at which the model counts as complete. Its unit is the error expected from noise
/// and from the form of the FV curve. The search adds effects in pairs above the same value.
pub const QUIET: f64 = dashpot_estimation::structure::search::QUIET;

/// Ratio of a test's residual to the error expected from noise and curve form above which the model misses the test.
/// The unexplained error is then 1.7 times the expected error. Test:
/// `a_test_that_the_model_misses_is_named_although_the_mean_is_small`.
pub const MISSED: f64 = 2.0;

/// Smallest gain of log likelihood at which a structure with other effects is preferred to the given model. The value 1
/// is a likelihood ratio of e.
///
/// With a smaller value, the diagnosis replaced an effect of the given model by another effect that fits the records as
/// well.
pub const NEEDED: f64 = 1.0;

/// Unexplained fraction of the disagreement above which the diagnosis reports it in addition to the named effects. The
/// disagreement is the mean square residual in excess of noise.
pub const UNEXPLAINED: f64 = 0.25;

/// Smallest force of a named effect and of a reported change, as a fraction of the root mean square measured force.
///
/// A smaller change appears only in the table, because dampers of one series differ by this amount, and force
/// tolerances allow it. The force of a named effect must also exceed the noise of a sample in at least one test. The
/// second laboratory uses the same fraction to define the true effects of a simulated damper (`true_set.rs`).
pub const MATERIAL: f64 = 0.005;
