//! What is usual of a number: the middle of what dampers show and how far they scatter about it.

/// What is known of one number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Usual {
    /// A size: its median, and the factor by which one damper in three lies off it.
    Size(f64, f64),
    /// A strength, which may be as small as it likes: where half of the dampers that have the effect at all lie, and the factor by which
    /// one in six lies above it.
    Strength(f64, f64),
    /// A place, or anything of either sign: its mean and standard deviation.
    Place(f64, f64),
}

/// How many strengths a strength may lie above its median before a search is drawn back: far enough to bias nothing.
const FREE: f64 = 3.0;

impl Usual {
    /// Mean and standard deviation in the coordinate in which a search moves: the logarithm, or the number itself.
    pub fn in_search(self, logarithm: bool) -> (f64, f64) {
        match (self, logarithm) {
            (Usual::Size(median, factor) | Usual::Strength(median, factor), true) => {
                (libm::log(median), libm::log(factor))
            }
            (Usual::Size(median, factor), false) => (median, median * (factor - 1.0 / factor)),
            (Usual::Strength(median, factor), false) => (0.0, FREE * median * factor),
            (Usual::Place(mean, deviation), false) => (mean, deviation),
            (Usual::Place(mean, deviation), true) => {
                (libm::log(mean.abs().max(1e-12)), libm::log(1.0 + deviation / mean.abs().max(1e-12)))
            }
        }
    }

    /// How many standard deviations a value is from what is usual; 0 for a strength below its median.
    pub fn off(self, value: f64) -> f64 {
        match self {
            Usual::Size(median, factor) => libm::log(value.abs().max(1e-300) / median) / libm::log(factor),
            Usual::Strength(median, factor) => libm::log((value.abs() / median).max(1.0)) / libm::log(factor),
            Usual::Place(mean, deviation) => (value - mean) / deviation,
        }
    }
}
