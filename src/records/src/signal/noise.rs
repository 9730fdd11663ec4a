//! Noise floor of the force: the part that no model can explain.

use crate::data::cycle::Cycle;
use crate::data::record::{Noise, NoiseSource};
use crate::numbers::median;
use crate::tuning::noise::FEWEST;

/// Estimates the noise of a single force sample, as a standard deviation, N, and an autocorrelation at a lag of one
/// sample.
///
/// With three or more cycles, every sample of the inner cycles is compared with the previous and the next cycle at
/// equal phase. With two cycles, the second is compared with the first. Without cycles, the estimate uses differences
/// of neighboring samples. For fewer than [`FEWEST`] samples, the noise is unknown. The comparison with both neighbors
/// cancels a slow trend such as heating.
///
/// The values of neighboring cycles are interpolated between samples, which reduces their noise. For noise with a
/// geometrically decreasing autocorrelation, the estimate corrects this effect and the noise of the neighbors exactly.
///
/// Deviations beyond 3.5 times the robust spread are left out. Such deviations occur on steep flanks, such as a
/// reversal of friction. A small phase difference is a large force difference there.
pub(crate) fn floor(time: &[f64], force: &[f64], cycles: &[Cycle]) -> Noise {
    if let Some(noise) = cycle_repeat(time, force, cycles) {
        return noise;
    }
    if force.len() < FEWEST {
        return Noise::default();
    }
    Noise { force_rms: difference_noise(force), lag1: 0.0, from: NoiseSource::SampleDifferences }
}

/// Estimates the standard deviation of white noise on a smooth signal, from third differences of neighboring samples.
///
/// The third difference of a parabola is zero. The median suppresses the effect of edges.
pub(crate) fn difference_noise(values: &[f64]) -> f64 {
    let mut third: Vec<f64> = values.windows(4).map(|w| (w[0] - 3.0 * w[1] + 3.0 * w[2] - w[3]).abs()).collect();
    // The third difference has the variance 1 + 9 + 9 + 1. The median of |normal| is 0.6745 standard deviations.
    median(&mut third) / (0.6745 * 20.0_f64.sqrt())
}

/// Force of a neighboring cycle at equal phase, N, interpolated between two samples, and the weight of the later one.
struct Partner {
    value: f64,
    weight: f64,
}

/// Deviation of a sample from the mean `partner` of the forces of neighboring cycles at equal phase, N, and their
/// interpolation weights.
struct Deviation {
    value: f64,
    partner: f64,
    weights: [f64; 2],
}

/// Removes the effect of a small time shift of the whole cycle from the deviations `run`.
///
/// Without speed control, the period of a drive varies by a fraction of a sample. On a steep flank, the shift would
/// count as noise.
fn remove_shift(run: &mut [Deviation]) {
    let reach = (run.len() / 200).max(2);
    if run.len() < 8 * reach {
        return;
    }
    let slope = |i: usize| run[(i + reach).min(run.len() - 1)].partner - run[i.saturating_sub(reach)].partner;
    let slopes: Vec<f64> = (0..run.len()).map(slope).collect();
    let (mut along, mut square) = (0.0, 0.0);
    for (deviation, slope) in run.iter().zip(&slopes) {
        along += deviation.value * slope;
        square += slope * slope;
    }
    if square > 0.0 {
        for (deviation, slope) in run.iter_mut().zip(&slopes) {
            deviation.value -= along / square * slope;
        }
    }
}

fn partner(time: &[f64], force: &[f64], from: &Cycle, to: &Cycle, t: f64) -> Option<Partner> {
    let phase = (t - from.start_time) / from.period();
    let at = to.start_time + phase * to.period();
    // Include one sample beyond each end of the cycle, if the record contains such samples.
    let span = to.start.saturating_sub(1)..(to.end + 1).min(time.len());
    let after = span.start + time[span.clone()].partition_point(|&t| t <= at);
    if after <= span.start || after >= span.end {
        return None;
    }
    let (a, b) = (time[after - 1], time[after]);
    // Do not interpolate across a gap.
    if b - a > 0.05 * to.period() && to.end - to.start > 40 {
        return None;
    }
    let weight = (at - a) / (b - a);
    Some(Partner { value: force[after - 1] + weight * (force[after] - force[after - 1]), weight })
}

fn cycle_repeat(time: &[f64], force: &[f64], cycles: &[Cycle]) -> Option<Noise> {
    if cycles.len() < 2 {
        return None;
    }
    // Deviations of consecutive samples. A sample without a force at equal phase in a neighboring cycle ends a run.
    let mut runs: Vec<Vec<Deviation>> = Vec::new();
    let one_sided = cycles.len() == 2;
    let judged = if one_sided { 1..2 } else { 1..cycles.len() - 1 };
    for k in judged {
        let this = &cycles[k];
        let mut run = Vec::with_capacity(this.end - this.start);
        for i in this.start..this.end {
            let before = partner(time, force, this, &cycles[k - 1], time[i]);
            let entry = if one_sided {
                before.map(|b| Deviation { value: force[i] - b.value, partner: b.value, weights: [b.weight, f64::NAN] })
            } else {
                let after = partner(time, force, this, &cycles[k + 1], time[i]);
                before.zip(after).map(|(b, a)| {
                    let partner = 0.5 * (b.value + a.value);
                    Deviation { value: force[i] - partner, partner, weights: [b.weight, a.weight] }
                })
            };
            match entry {
                Some(entry) => run.push(entry),
                None => runs.push(std::mem::take(&mut run)),
            }
        }
        runs.push(run);
    }
    for run in &mut runs {
        remove_shift(run);
    }
    let all: Vec<f64> = runs.iter().flatten().map(|d| d.value).collect();
    if all.len() < FEWEST {
        return None;
    }
    let centre = median(&mut all.clone());
    let spread = median(&mut all.iter().map(|d| (d - centre).abs()).collect::<Vec<_>>()) / 0.6745;
    let near = |d: f64| (d - centre).abs() <= 3.5 * spread;

    // Second moments of the deviations at lags of 0 and 1 sample (`d0`, `d1`), and their counts (`n0`, `n1`). `share`
    // is the weight of a neighboring cycle's variance in a deviation.
    let share = if one_sided { 1.0 } else { 0.25 };
    let (mut d0, mut n0, mut d1, mut n1) = (0.0, 0.0, 0.0, 0.0);
    // Sums over the neighboring cycles of (1−w)² + w² and of w(1−w), with the interpolation weight w.
    let (mut same, mut cross) = (0.0, 0.0);
    for run in &runs {
        for (i, Deviation { value: d, weights, .. }) in run.iter().enumerate() {
            if !near(*d) {
                continue;
            }
            d0 += (d - centre).powi(2);
            n0 += 1.0;
            for w in weights.iter().filter(|w| !w.is_nan()) {
                same += share * ((1.0 - w).powi(2) + w * w);
                cross += share * w * (1.0 - w);
            }
            if let Some(next) = run.get(i + 1).filter(|next| near(next.value)) {
                d1 += (d - centre) * (next.value - centre);
                n1 += 1.0;
            }
        }
    }
    if n0 < FEWEST as f64 || n1 == 0.0 {
        return None;
    }
    let (d0, d1, same, cross) = (d0 / n0, d1 / n1, same / n0, cross / n0);
    if d0 == 0.0 {
        return Some(Noise { force_rms: 0.0, lag1: 0.0, from: NoiseSource::CycleRepeat });
    }
    // The noise has the variance c0 and the autocorrelation r at lag 1 (r² at lag 2). The expected second moments D0
    // and D1 at lags of 0 and 1 sample are then:
    //   D0 = c0 (1 + same + 2 cross r),   D1 = c0 (r + same r + cross (1 + r²)).
    // D1/D0 increases with r, so bisection finds r.
    let ratio = d1 / d0;
    let of = |r: f64| (r + same * r + cross * (1.0 + r * r)) / (1.0 + same + 2.0 * cross * r);
    let (mut low, mut high) = (-0.99, 0.99);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if of(middle) < ratio {
            low = middle;
        } else {
            high = middle;
        }
    }
    let lag1 = 0.5 * (low + high);
    let variance = d0 / (1.0 + same + 2.0 * cross * lag1);
    Some(Noise { force_rms: variance.sqrt(), lag1, from: NoiseSource::CycleRepeat })
}

/// Returns the root mean square deviation of each cycle's force from the median of up to eight other cycles at equal
/// phase, N.
pub(crate) fn cycle_deviations(time: &[f64], force: &[f64], cycles: &[Cycle]) -> Vec<f64> {
    cycles
        .iter()
        .enumerate()
        .map(|(k, this)| {
            let others: Vec<&Cycle> =
                cycles.iter().enumerate().filter(|(j, _)| *j != k).map(|(_, c)| c).take(8).collect();
            let (mut sum, mut count) = (0.0, 0);
            // A few hundred phases suffice for a mean, so long cycles are decimated.
            for i in (this.start..this.end).step_by(((this.end - this.start) / 400).max(1)) {
                let mut values: Vec<f64> =
                    others.iter().filter_map(|c| partner(time, force, this, c, time[i])).map(|p| p.value).collect();
                if !values.is_empty() {
                    sum += (force[i] - median(&mut values)).powi(2);
                    count += 1;
                }
            }
            if count == 0 { 0.0 } else { (sum / f64::from(count)).sqrt() }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cleaning::find_cycles;
    use crate::fixtures::{Random, SineTest};

    fn estimate(test: &SineTest) -> Noise {
        let samples = test.samples();
        let cycles = find_cycles(&samples.time, samples.displacement.as_ref().unwrap());
        floor(&samples.time, &samples.force, &cycles)
    }

    #[test]
    fn cycle_repeat_finds_level_and_correlation_of_the_noise() {
        for (noise, lag1) in [(4.0, 0.0), (4.0, 0.6), (25.0, -0.3), (1.0, 0.3)] {
            for (cycles, per_cycle, frequency) in [(3, 1000, 0.01), (12, 300, 1.6), (2, 2000, 5.0)] {
                let test = SineTest { noise, lag1, cycles, per_cycle, frequency, seed: 7, ..SineTest::default() };
                let found = estimate(&test);
                assert_eq!(found.from, NoiseSource::CycleRepeat);
                assert!((found.force_rms / noise - 1.0).abs() < 0.10, "{found:?} for {test:?}");
                assert!((found.lag1 - lag1).abs() < 0.12, "{found:?} for {test:?}");
            }
        }
    }

    #[test]
    fn a_slow_trend_is_no_noise() {
        let mut samples = SineTest { cycles: 8, ..SineTest::default() }.samples();
        for (force, t) in samples.force.iter_mut().zip(&samples.time) {
            *force *= 1.0 - 0.02 * t; // fade by heating
        }
        let cycles = find_cycles(&samples.time, samples.displacement.as_ref().unwrap());
        let found = floor(&samples.time, &samples.force, &cycles);
        assert!((found.force_rms / 4.0 - 1.0).abs() < 0.15, "{found:?}");
    }

    #[test]
    fn without_cycles_differences_of_samples_serve() {
        let mut random = Random::new(3);
        let time: Vec<f64> = (0..4000).map(|i| f64::from(i) * 1e-3).collect();
        let force: Vec<f64> = time.iter().map(|t| 800.0 * libm::sin(9.0 * t) + 6.0 * random.normal()).collect();
        let found = floor(&time, &force, &[]);
        assert_eq!(found.from, NoiseSource::SampleDifferences);
        assert!((found.force_rms / 6.0 - 1.0).abs() < 0.08, "{found:?}");
        assert_eq!(floor(&time[..5], &force[..5], &[]).from, NoiseSource::Unknown);
    }
}
