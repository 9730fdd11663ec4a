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
    /// A place that is far likelier off to one side: its mode, and the standard deviations below and above it (a split normal distribution).
    Skewed(f64, f64, f64),
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
            // The search is drawn back on the narrow side no more than on the wide one; the evidence is.
            (Distribution::Place(mean, deviation) | Distribution::Skewed(mean, _, deviation), false) => {
                (mean, deviation)
            }
            (Distribution::Place(mean, deviation) | Distribution::Skewed(mean, _, deviation), true) => {
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
            Distribution::Skewed(mode, below, _) if value < mode => (value - mode) / below,
            Distribution::Skewed(mode, _, above) => (value - mode) / above,
        }
    }

    /// Its center: median, mean or mode.
    pub fn center(self) -> f64 {
        match self {
            Distribution::Size(center, _)
            | Distribution::Strength(center, _)
            | Distribution::Place(center, _)
            | Distribution::Skewed(center, ..) => center,
        }
    }

    /// The ends of the interval of so many standard deviations to each side.
    pub fn interval(self, deviations: f64) -> (f64, f64) {
        match self {
            Distribution::Size(median, factor) | Distribution::Strength(median, factor) => {
                let factor = libm::pow(factor, deviations);
                (median / factor, median * factor)
            }
            Distribution::Place(mean, deviation) => (mean - deviations * deviation, mean + deviations * deviation),
            Distribution::Skewed(mode, below, above) => (mode - deviations * below, mode + deviations * above),
        }
    }
}
