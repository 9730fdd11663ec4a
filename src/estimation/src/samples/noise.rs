//! Noise of the samples that are compared with the model. With enough cycles, the noise follows from their differences,
//! for any noise spectrum. Otherwise, it is the estimate in the record.

use dashpot_records::restrict;

/// Smallest number of cycles at which their differences give the noise of their mean. With fewer cycles, the noise
/// comes from the record.
const REPEATS: usize = 3;
/// Fraction of the deviations that is clamped as outliers. Their cause is steep parts of the force, not noise. [`KEPT`]
/// is the fraction of the variance of normal noise that remains after clamping.
const STEEP: f64 = 0.02;
const KEPT: f64 = 0.964;

/// Statistics of the differences between cycles.
pub struct Repeat {
    /// Standard deviation of the noise of the mean cycle, N.
    pub mean_noise: f64,
    /// Fraction of independent samples.
    pub independence: f64,
    /// Significance of the relative growth of the force from cycle to cycle, in standard deviations.
    pub growth: f64,
}

/// Computes the statistics from the deviations of cycles from their mean at equal phase, for any noise spectrum.
/// `bounds` are the begin and end of each cycle, s, and `mean` the phases, 0 to 1, and forces, N, of the mean cycle.
/// Returns `None` for too few cycles or samples, or if all deviations are zero.
pub fn repeat(bounds: &[(f64, f64)], mean: &[(f64, f64)], force: impl Fn(f64) -> f64) -> Option<Repeat> {
    let count = mean.len();
    if bounds.len() < REPEATS || count < 16 {
        return None;
    }
    let deviations: Vec<Vec<f64>> =
        bounds.iter().map(|(a, b)| mean.iter().map(|(phase, m)| force(a + (b - a) * phase) - m).collect()).collect();
    let mut sizes: Vec<f64> = deviations.iter().flatten().map(|d| d.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let limit = sizes[((1.0 - STEEP) * (sizes.len() - 1) as f64) as usize];
    let near = |d: f64| restrict(d, -limit, limit);
    let product = |lag: usize| {
        let of = |d: &Vec<f64>| (lag..count).map(|k| near(d[k]) * near(d[k - lag])).sum::<f64>();
        deviations.iter().map(of).sum::<f64>() / ((count - lag) * deviations.len()) as f64
    };
    let variance = product(0);
    if variance <= 0.0 {
        return None;
    }
    // The sum of autocorrelations is truncated after Geyer's initial positive sequence (Stat. Sci. 7, 1992), at the
    // latest at a quarter of a cycle.
    let mut stands_for = 1.0;
    for lag in 1..count / 4 {
        let correlation = product(lag) / variance;
        if correlation < 0.05 {
            break;
        }
        stands_for += 2.0 * correlation;
    }
    let n = bounds.len() as f64;
    // The deviations are relative to the mean of the same cycles, which costs one degree of freedom.
    Some(Repeat {
        mean_noise: (variance / KEPT / (n - 1.0)).sqrt(),
        independence: 1.0 / stands_for,
        growth: growth(&deviations, mean, stands_for),
    })
}

/// Computes the growth of the force from cycle to cycle in standard deviations, from each cycle's gain relative to the
/// mean cycle. `stands_for` is the number of samples that contain the information of one independent sample.
fn growth(deviations: &[Vec<f64>], mean: &[(f64, f64)], stands_for: f64) -> f64 {
    let middle = mean.iter().map(|m| m.1).sum::<f64>() / mean.len() as f64;
    let shape: Vec<f64> = mean.iter().map(|m| m.1 - middle).collect();
    let square: f64 = shape.iter().map(|f| f * f).sum::<f64>().max(1e-300);
    let gains: Vec<f64> =
        deviations.iter().map(|d| d.iter().zip(&shape).map(|(d, f)| d * f).sum::<f64>() / square).collect();
    let left: f64 = deviations
        .iter()
        .zip(&gains)
        .flat_map(|(d, g)| d.iter().zip(&shape).map(move |(d, f)| (d - g * f).powi(2)))
        .sum::<f64>();
    let n = gains.len() as f64;
    let of_gain = stands_for * left / ((n - 1.0) * mean.len() as f64 * square);
    let place = |k: usize| k as f64 - 0.5 * (n - 1.0);
    let places: f64 = (0..gains.len()).map(|k| place(k).powi(2)).sum();
    let slope = gains.iter().enumerate().map(|(k, g)| place(k) * g).sum::<f64>() / places;
    slope / (of_gain / places).sqrt().max(1e-300)
}

/// Computes the fraction of independent samples from the autocorrelation `lag` of neighboring samples.
pub fn independence(lag: f64) -> f64 {
    (1.0 - lag) / (1.0 + lag)
}

/// Computes the variance of the mean of `count` neighbors relative to the variance of one sample. The autocorrelation
/// of the noise is `lag1` between neighbors and decays geometrically.
pub fn mean_variance(count: usize, lag1: f64) -> f64 {
    let n = count as f64;
    let sum: f64 = (1..count).map(|k| (n - k as f64) * lag1.powi(k as i32)).sum();
    (n + 2.0 * sum) / (n * n)
}
