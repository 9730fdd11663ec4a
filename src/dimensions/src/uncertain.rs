//! Numbers with a 95 % interval, and the propagation of such intervals through a formula.

/// Half-width of the 95 % interval of a normal distribution, in standard deviations.
const Z: f64 = 1.959_963_985;

/// A number with the ends of its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Uncertain {
    /// Central value.
    pub value: f64,
    /// Lower end of the 95 % interval.
    pub low: f64,
    /// Upper end of the 95 % interval.
    pub high: f64,
}

impl Uncertain {
    /// Makes a positive number that is known within a factor.
    pub fn within_factor(value: f64, factor: f64) -> Uncertain {
        Uncertain { value, low: value / factor, high: value * factor }
    }

    /// Makes a number that is known within a half-width.
    pub fn within(value: f64, half: f64) -> Uncertain {
        Uncertain { value, low: value - half, high: value + half }
    }

    /// Returns the value that is `z` standard deviations above the center. The two sides may have different widths. The
    /// distribution of positive numbers is that of their logarithm.
    fn at_deviation(&self, z: f64) -> f64 {
        let (end, part) = if z < 0.0 { (self.low, -z / Z) } else { (self.high, z / Z) };
        if self.low > 0.0 && self.value > 0.0 {
            self.value * libm::pow(end / self.value, part)
        } else {
            self.value + (end - self.value) * part
        }
    }

    /// Returns one standard deviation of a normal distribution with this 95 % interval.
    pub fn deviation(&self) -> f64 {
        (self.high - self.low) / (2.0 * Z)
    }

    /// Returns one standard deviation of a positive number, as a factor.
    pub fn factor(&self) -> f64 {
        libm::exp(libm::log(self.high / self.low) / (2.0 * Z))
    }
}

/// A computed number with its 95 % interval. A missing end is unbounded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Value at the central inputs.
    pub value: Option<f64>,
    /// Lower end of the 95 % interval.
    pub low: Option<f64>,
    /// Upper end of the 95 % interval.
    pub high: Option<f64>,
}

impl Interval {
    /// Converts the interval to another unit.
    pub fn scaled(self, factor: f64) -> Interval {
        let times = |x: Option<f64>| x.map(|x| x * factor);
        Interval { value: times(self.value), low: times(self.low), high: times(self.high) }
    }
}

/// Number of samples from which one interval is computed. The error of its ends is a hundredth of its width. More
/// samples cost time and do not change the printed digits.
const SAMPLES: usize = 4000;

/// Computes the interval of a formula of uncertain numbers by sampling. A result that is not finite counts as infinite,
/// so that the upper end is unbounded.
///
/// The samples are those of an additive recurrence (Roberts' sequence), so that equal inputs give equal digits.
pub fn through(inputs: &[Uncertain], formula: impl Fn(&[f64]) -> f64) -> Interval {
    let finite = |x: f64| if x.is_finite() { x } else { f64::INFINITY };
    let steps = recurrence(inputs.len());
    let mut outcomes: Vec<f64> = (0..SAMPLES)
        .map(|i| {
            let values: Vec<f64> = inputs
                .iter()
                .zip(&steps)
                .map(|(input, step)| {
                    let u = 0.5 + (i as f64 + 1.0) * step;
                    input.at_deviation(normal_quantile((u - libm::floor(u)).clamp(1e-6, 0.999_999)))
                })
                .collect();
            finite(formula(&values))
        })
        .collect();
    outcomes.sort_by(f64::total_cmp);
    let central: Vec<f64> = inputs.iter().map(|input| input.value).collect();
    let bounded = |x: f64| Some(x).filter(|x| x.is_finite());
    Interval {
        value: bounded(formula(&central)),
        low: bounded(outcomes[SAMPLES / 40]),
        high: bounded(outcomes[SAMPLES - 1 - SAMPLES / 40]),
    }
}

/// Returns the steps of Roberts' sequence in d = `count` dimensions: powers of 1/x, where x is the root of x^(d+1) = x
/// + 1.
fn recurrence(count: usize) -> Vec<f64> {
    let power = count as f64 + 1.0;
    let root = (0..60).fold(2.0, |x: f64, _| libm::pow(1.0 + x, 1.0 / power));
    (1..=count).map(|k| libm::pow(root, -(k as f64))).collect()
}

/// Computes the quantile of the standard normal distribution (Acklam's rational approximation, relative error 1e-9).
fn normal_quantile(p: f64) -> f64 {
    const A: [f64; 6] = [
        -3.969_683_028_665_376e1,
        2.209_460_984_245_205e2,
        -2.759_285_104_469_687e2,
        1.383_577_518_672_69e2,
        -3.066_479_806_614_716e1,
        2.506_628_277_459_239,
    ];
    const B: [f64; 5] = [
        -5.447_609_879_822_406e1,
        1.615_858_368_580_409e2,
        -1.556_989_798_598_866e2,
        6.680_131_188_771_972e1,
        -1.328_068_155_288_572e1,
    ];
    const C: [f64; 6] = [
        -7.784_894_002_430_293e-3,
        -3.223_964_580_411_365e-1,
        -2.400_758_277_161_838,
        -2.549_732_539_343_734,
        4.374_664_141_464_968,
        2.938_163_982_698_783,
    ];
    const D: [f64; 4] =
        [7.784_695_709_041_462e-3, 3.224_671_290_700_398e-1, 2.445_134_137_142_996, 3.754_408_661_907_416];
    const TAIL: f64 = 0.024_25;
    let polynomial = |coefficients: &[f64], x: f64| coefficients.iter().fold(0.0, |sum, c| sum * x + c);
    if p > 0.5 {
        return -normal_quantile(1.0 - p);
    }
    if p < TAIL {
        let q = libm::sqrt(-2.0 * libm::log(p));
        return polynomial(&C, q) / (polynomial(&D, q) * q + 1.0);
    }
    let q = p - 0.5;
    let r = q * q;
    polynomial(&A, r) * q / (polynomial(&B, r) * r + 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_the_table() {
        for (p, z) in [(0.5, 0.0), (0.975, Z), (0.025, -Z), (0.01, -2.326_347_874), (0.999, 3.090_232_306)] {
            assert!((normal_quantile(p) - z).abs() < 1e-7, "{p}");
        }
    }

    #[test]
    fn an_interval_goes_through_unchanged_and_independent_ones_add_in_squares() {
        let a = Uncertain::within(10.0, 0.6);
        let same = through(&[a], |x| x[0]);
        assert!((same.low.unwrap() - 9.4).abs() < 0.01 && (same.high.unwrap() - 10.6).abs() < 0.01);
        let sum = through(&[a, Uncertain::within(5.0, 0.8)], |x| x[0] + x[1]);
        assert!((sum.high.unwrap() - 16.0).abs() < 0.03, "{sum:?}");
        let product = through(&[Uncertain::within_factor(2.0, 1.5)], |x| x[0] * x[0]);
        assert!((product.high.unwrap() / 9.0 - 1.0).abs() < 0.01, "{product:?}");
    }

    #[test]
    fn what_may_be_infinite_has_no_upper_end() {
        let open = through(&[Uncertain::within(1.0, 2.0)], |x| if x[0] > 0.0 { 1.0 / x[0] } else { f64::NAN });
        assert_eq!(open.high, None);
        assert!(open.low.is_some());
    }
}
