//! Every number that decides about an answer, with its reason.

/// Probability from which an effect is named: below it the name is more likely wrong than right.
pub const NAMED: f64 = 0.5;

/// Largest root mean square residual at which nothing is missing, in units of what noise and the form of curves leave.
///
/// Beyond it the form error is larger than the noise.
pub const QUIET: f64 = 1.5;

/// Log likelihood that a structure with other effects must have above the given model's: with e to one the records speak for it at all.
///
/// With less, an effect was named in the place of one that fits as well.
pub const NEEDED: f64 = 1.0;

/// Fraction of the disagreement left from which that is reported beside the names.
pub const UNEXPLAINED: f64 = 0.25;

/// Smallest force of a named effect and of a reported change, as a fraction of the root mean square measured force.
///
/// A smaller change stands in the table alone: dampers of one series differ by as much, and windows of force allow it. A name needs more
/// than the noise of a sample besides, in one test at least. So the laboratory defines which effects a damper has (`true_set.rs`).
pub const MATERIAL: f64 = 0.005;
