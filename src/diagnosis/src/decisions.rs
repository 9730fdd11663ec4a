//! Every number that decides about an answer, with its reason.

/// Probability from which an effect is named: below it the name is more likely wrong than right.
pub const NAMED: f64 = 0.5;

/// Root mean square residual, in units of what noise and the form of curves leave, up to which nothing is said to be missing: beyond it
/// the form error is larger than the noise.
pub const QUIET: f64 = 1.5;

/// Fraction of the disagreement left from which that is reported beside the names.
pub const UNEXPLAINED: f64 = 0.25;

/// Force of a change against a reference, over the root mean square of the measured force, below which it stands in the table alone:
/// dampers of one series differ by as much, and windows of force allow it.
pub const MATERIAL: f64 = 0.005;
