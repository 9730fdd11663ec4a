//! Prior distribution of a number: center and spread of what dampers show.

/// Prior distribution of one number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distribution {
    /// A size: its median, and the factor by which one damper in three lies off it.
    Size(f64, f64),
    /// A strength, which may be arbitrarily small: its median, and the factor by which one in six lies above it.
    ///
    /// The median is that of the dampers that have the effect at all.
    Strength(f64, f64),
    /// A place, or anything of either sign: its mean and standard deviation.
    Place(f64, f64),
}

/// How many strengths a strength may lie above its median before a search is drawn back: far enough to bias nothing.
const FREE: f64 = 3.0;

impl Distribution {
    /// Mean and standard deviation in the coordinate in which a search moves: the logarithm, or the number itself.
    pub fn in_search(self, logarithm: bool) -> (f64, f64) {
        match (self, logarithm) {
            (Distribution::Size(median, factor) | Distribution::Strength(median, factor), true) => {
                (libm::log(median), libm::log(factor))
            }
            (Distribution::Size(median, factor), false) => (median, median * (factor - 1.0 / factor)),
            (Distribution::Strength(median, factor), false) => (0.0, FREE * median * factor),
            (Distribution::Place(mean, deviation), false) => (mean, deviation),
            (Distribution::Place(mean, deviation), true) => {
                (libm::log(mean.abs().max(1e-12)), libm::log(1.0 + deviation / mean.abs().max(1e-12)))
            }
        }
    }

    /// Distance of a value from the center in standard deviations; 0 for a strength below its median.
    pub fn standard_score(self, value: f64) -> f64 {
        match self {
            Distribution::Size(median, factor) => libm::log(value.abs().max(1e-300) / median) / libm::log(factor),
            Distribution::Strength(median, factor) => libm::log((value.abs() / median).max(1.0)) / libm::log(factor),
            Distribution::Place(mean, deviation) => (value - mean) / deviation,
        }
    }
}
