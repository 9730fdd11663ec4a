//! Prior distribution of a parameter: center and spread over dampers.

/// Prior distribution of one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distribution {
    /// A positive size: its median, and a factor. A third of the dampers differs from the median by more than this
    /// factor.
    Size(f64, f64),
    /// A strength, which may be arbitrarily small: its median, and a factor. A sixth of the dampers exceeds the median
    /// times this factor.
    ///
    /// The median applies to the dampers that have the effect.
    Strength(f64, f64),
    /// A position, or any quantity that may be positive or negative: its mean and standard deviation.
    Place(f64, f64),
    /// A skewed quantity that may be positive or negative: its mode, and the standard deviations below and above the
    /// mode (a split normal distribution).
    Skewed(f64, f64, f64),
}

/// Standard deviation of a strength whose search coordinate is not a logarithm, in units of its median times its
/// factor. The mean is 0. The value is large enough to avoid a bias toward 0.
const FREE: f64 = 3.0;

impl Distribution {
    /// Returns mean and standard deviation in the search coordinate: the logarithm or the parameter itself.
    pub fn in_search(self, logarithm: bool) -> (f64, f64) {
        match (self, logarithm) {
            (Distribution::Size(median, factor) | Distribution::Strength(median, factor), true) => {
                (libm::log(median), libm::log(factor))
            }
            (Distribution::Size(median, factor), false) => (median, median * (factor - 1.0 / factor)),
            (Distribution::Strength(median, factor), false) => (0.0, FREE * median * factor),
            // The search uses the deviation above the mode on both sides. [`Distribution::standard_score`] uses both
            // deviations.
            (Distribution::Place(mean, deviation) | Distribution::Skewed(mean, _, deviation), false) => {
                (mean, deviation)
            }
            (Distribution::Place(mean, deviation) | Distribution::Skewed(mean, _, deviation), true) => {
                (libm::log(mean.abs().max(1e-12)), libm::log(1.0 + deviation / mean.abs().max(1e-12)))
            }
        }
    }

    /// Computes the distance of a value from the center in standard deviations. The distance of a strength below its
    /// median is 0.
    pub fn standard_score(self, value: f64) -> f64 {
        match self {
            Distribution::Size(median, factor) => libm::log(value.abs().max(1e-300) / median) / libm::log(factor),
            Distribution::Strength(median, factor) => libm::log((value.abs() / median).max(1.0)) / libm::log(factor),
            Distribution::Place(mean, deviation) => (value - mean) / deviation,
            Distribution::Skewed(mode, below, _) if value < mode => (value - mode) / below,
            Distribution::Skewed(mode, _, above) => (value - mode) / above,
        }
    }

    /// Returns the center of the distribution: median, mean or mode.
    pub fn center(self) -> f64 {
        match self {
            Distribution::Size(center, _)
            | Distribution::Strength(center, _)
            | Distribution::Place(center, _)
            | Distribution::Skewed(center, ..) => center,
        }
    }

    /// Computes the ends of the interval that extends `deviations` standard deviations to each side of the center.
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
