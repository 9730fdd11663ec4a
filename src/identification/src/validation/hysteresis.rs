//! Hysteresis of one test: the force gap between rising and falling velocity, the loop area, and the energy per cycle.
//!
//! These figures come from whole cycles only, because an open loop has no area.
//!
//! The gap is the force at rising velocity minus the force at falling velocity, and the area has the same sign. Both are negative for a
//! force that lags the velocity (gas and oil compressibility, a parallel spring). They are positive for a force that leads the velocity
//! (moving mass). They are zero for a force that is a function of velocity alone.

use super::Compared;
use serde::Serialize;

/// Number of velocity bins from the negative to the positive peak velocity.
///
/// The number is even, so that zero velocity is the edge of a bin. Friction changes sign at zero velocity, so a bin across zero would
/// average the friction to zero.
const BINS: usize = 20;

/// Smallest number of samples of a branch (rising or falling velocity) in a bin. A bin with fewer samples is left out.
const MIN_SAMPLES: usize = 2;

/// Smallest number of samples of a cycle. A cycle with fewer samples is left out.
const MIN_CYCLE_SAMPLES: usize = 8;

/// One statistic for each of three forces: the measured force, that of the full model and that of the FV curve alone.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct OfEach {
    /// Figure of the measured force.
    pub measured: f64,
    /// Figure of the full model.
    pub model: f64,
    /// Figure of the force–velocity curve alone.
    pub fv_only: f64,
}

/// Gap between rising and falling velocity in one velocity bin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GapBin {
    /// Middle of the velocity bin, m/s.
    pub velocity_m_s: f64,
    /// Force at rising velocity minus force at falling velocity, N.
    pub gap_n: OfEach,
}

/// Hysteresis of one test, averaged over its whole cycles.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Hysteresis {
    /// Number of whole cycles used.
    pub cycles: usize,
    /// Gap over velocity, without bins that have too few samples of a branch.
    pub gap: Vec<GapBin>,
    /// Mean of |gap| over the bins, N; zero without bins.
    pub mean_gap_n: OfEach,
    /// Largest |gap|, N; zero without bins.
    pub max_gap_n: OfEach,
    /// Mean over the bins of |gap of the model − measured gap|, N; zero without bins.
    pub gap_error_n: f64,
    /// Mean over the bins of |gap of the force–velocity curve alone − measured gap|, N; zero without bins.
    pub gap_error_fv_only_n: f64,
    /// ∮F dv of one cycle, N·m/s.
    pub area_n_m_s: OfEach,
    /// ∮F dx of one cycle, J: the heat that the damper dissipates.
    pub energy_j: OfEach,
}

impl OfEach {
    /// Computes a figure of each of the three forces.
    fn of(compared: &Compared<'_>, mut figure: impl FnMut(&[f64]) -> f64) -> Self {
        Self {
            measured: figure(&compared.record.force),
            model: figure(&compared.model),
            fv_only: figure(&compared.fv_only),
        }
    }

    /// Computes a statistic over bins for each of the three forces.
    fn over(bins: &[GapBin], figure: impl Fn(&mut dyn Iterator<Item = f64>) -> f64) -> Self {
        Self {
            measured: figure(&mut bins.iter().map(|bin| bin.gap_n.measured)),
            model: figure(&mut bins.iter().map(|bin| bin.gap_n.model)),
            fv_only: figure(&mut bins.iter().map(|bin| bin.gap_n.fv_only)),
        }
    }
}

impl Hysteresis {
    /// Computes the hysteresis of a checked test. Returns `None` if the test has no whole cycle or no motion.
    pub(crate) fn of_test(compared: &Compared<'_>) -> Option<Self> {
        let record = compared.record;
        let cycles: Vec<_> = record.cycles.iter().filter(|cycle| cycle.len() >= MIN_CYCLE_SAMPLES).cloned().collect();
        let peak = record.peak_velocity;
        if cycles.is_empty() || !(peak.is_finite() && peak > 0.0) {
            return None;
        }
        let per_cycle = |force: &[f64], over: &[f64]| {
            let loops = cycles.iter().map(|cycle| loop_integral(&force[cycle.clone()], &over[cycle.clone()]));
            loops.sum::<f64>() / cycles.len() as f64
        };
        let bins = Bins::sort(&record.velocity, &record.displacement, &cycles, peak);
        let gap: Vec<GapBin> = (0..BINS)
            .filter(|bin| bins.is_usable(*bin))
            .map(|bin| GapBin {
                velocity_m_s: bins.middle(bin),
                gap_n: OfEach::of(compared, |force| bins.gap(bin, &record.velocity, force)),
            })
            .collect();
        let count = gap.len().max(1) as f64;
        let mean = |of: &dyn Fn(&GapBin) -> f64| gap.iter().map(of).sum::<f64>() / count;
        Some(Self {
            cycles: cycles.len(),
            mean_gap_n: OfEach::over(&gap, |gaps| gaps.map(f64::abs).sum::<f64>() / count),
            max_gap_n: OfEach::over(&gap, |gaps| gaps.map(f64::abs).fold(0.0, f64::max)),
            gap_error_n: mean(&|bin| (bin.gap_n.model - bin.gap_n.measured).abs()),
            gap_error_fv_only_n: mean(&|bin| (bin.gap_n.fv_only - bin.gap_n.measured).abs()),
            area_n_m_s: OfEach::of(compared, |force| per_cycle(force, &record.velocity)),
            energy_j: OfEach::of(compared, |force| per_cycle(force, &record.displacement)),
            gap,
        })
    }
}

/// Computes ∮F dq of one cycle by the trapezoidal rule, with the force F and the quantity q in `over`. The loop is closed from its last
/// sample to its first.
fn loop_integral(force: &[f64], over: &[f64]) -> f64 {
    let next = |i: usize| (i + 1) % force.len();
    (0..force.len()).map(|i| 0.5 * (force[i] + force[next(i)]) * (over[next(i)] - over[i])).sum()
}

/// Samples of whole cycles, sorted by velocity bin and by branch: rising or falling velocity.
struct Bins {
    /// Velocity at the outer edge of the outermost bins, m/s.
    peak: f64,
    /// Samples of `[rising, falling]` velocity in each bin.
    samples: Vec<[Vec<usize>; 2]>,
    /// Whether a bin has enough samples for a gap.
    usable: Vec<bool>,
}

impl Bins {
    /// Sorts samples into bins and branches.
    ///
    /// Velocity rises while the damper is below the middle of its stroke, and falls while it is above. The branch follows from the
    /// displacement, because the derivative of a measured velocity is too noisy.
    fn sort(velocity: &[f64], displacement: &[f64], cycles: &[std::ops::Range<usize>], peak: f64) -> Self {
        let mut samples = vec![[Vec::new(), Vec::new()]; BINS];
        for cycle in cycles {
            let stroke = &displacement[cycle.clone()];
            let (low, high) = stroke.iter().fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(*x), h.max(*x)));
            let middle = 0.5 * (low + high);
            for i in cycle.clone() {
                let place = (velocity[i] / peak + 1.0) * 0.5 * BINS as f64;
                if (0.0..BINS as f64).contains(&place) {
                    samples[place as usize][usize::from(displacement[i] >= middle)].push(i);
                }
            }
        }
        let mut bins = Self { peak, samples, usable: vec![false; BINS] };
        for bin in 0..BINS {
            let enough = bins.samples[bin].iter().all(|branch| branch.len() >= MIN_SAMPLES);
            bins.usable[bin] = enough && bins.spread(bin, velocity) > 0.0;
        }
        bins
    }

    fn is_usable(&self, bin: usize) -> bool {
        self.usable[bin]
    }

    /// Returns the velocity in the middle of a bin, m/s.
    fn middle(&self, bin: usize) -> f64 {
        self.peak * ((2 * bin + 1) as f64 / BINS as f64 - 1.0)
    }

    /// Returns the sum of squared velocity deviations from the branch means in a bin, m²/s².
    fn spread(&self, bin: usize, velocity: &[f64]) -> f64 {
        self.samples[bin].iter().map(|branch| co_deviation(branch, velocity, velocity)).sum()
    }

    /// Returns the gap of a usable bin, N: the distance in force between two parallel lines through the branches.
    ///
    /// The shared slope corrects different mean velocities of the branches, which would otherwise appear as hysteresis.
    fn gap(&self, bin: usize, velocity: &[f64], force: &[f64]) -> f64 {
        let [rising, falling] = &self.samples[bin];
        let along: f64 = [rising, falling].map(|branch| co_deviation(branch, velocity, force)).iter().sum();
        let slope = along / self.spread(bin, velocity);
        let offset = mean(rising, velocity) - mean(falling, velocity);
        mean(rising, force) - mean(falling, force) - slope * offset
    }
}

/// Averages a channel over the chosen samples.
fn mean(samples: &[usize], of: &[f64]) -> f64 {
    samples.iter().map(|i| of[*i]).sum::<f64>() / samples.len() as f64
}

/// Sums the product of two channels' deviations from their means over the chosen samples.
fn co_deviation(samples: &[usize], a: &[f64], b: &[f64]) -> f64 {
    let (mean_a, mean_b) = (mean(samples, a), mean(samples, b));
    samples.iter().map(|i| (a[*i] - mean_a) * (b[*i] - mean_b)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_records::Record;
    use std::f64::consts::PI;

    const AMPLITUDE: f64 = 0.02;
    const FREQUENCY: f64 = 1.5;

    /// Makes a sine test of whole cycles about 30 mm. The force is a function of the displacement from this mean, the velocity and the
    /// acceleration.
    fn sine(cycles: usize, per_cycle: usize, force: impl Fn(f64, f64, f64) -> f64) -> Record {
        let omega = 2.0 * PI * FREQUENCY;
        let mut record = Record {
            cycles: (0..cycles).map(|c| c * per_cycle..(c + 1) * per_cycle).collect(),
            amplitude: AMPLITUDE,
            frequency: FREQUENCY,
            peak_velocity: AMPLITUDE * omega,
            ..Record::default()
        };
        for i in 0..cycles * per_cycle {
            let phase = 2.0 * PI * i as f64 / per_cycle as f64;
            let (x, v) = (AMPLITUDE * libm::sin(phase), AMPLITUDE * omega * libm::cos(phase));
            record.time.push(phase / omega);
            record.displacement.push(x + 0.03);
            record.velocity.push(v);
            record.force.push(force(x, v, -omega * omega * x));
        }
        record
    }

    fn measured(record: &Record) -> Hysteresis {
        let zero = vec![0.0; record.force.len()];
        let compared = Compared { record, model: record.force.clone(), fv_only: zero, used_in_fit: false };
        Hysteresis::of_test(&compared).unwrap()
    }

    #[test]
    fn spring_and_damper_trace_the_ellipse_of_the_textbook() {
        let (k, c) = (12_000.0, 1_500.0);
        let omega = 2.0 * PI * FREQUENCY;
        let got = measured(&sine(3, 2000, |x, v, _| k * x + c * v + 200.0));
        let area = -k * PI * AMPLITUDE * AMPLITUDE * omega;
        let energy = c * PI * AMPLITUDE * AMPLITUDE * omega;
        assert!((got.area_n_m_s.measured / area - 1.0).abs() < 1e-4, "{} {area}", got.area_n_m_s.measured);
        assert!((got.energy_j.measured / energy - 1.0).abs() < 1e-4);
        assert_eq!((got.gap.len(), got.cycles), (20, 3));
        for bin in &got.gap {
            let part: f64 = bin.velocity_m_s / (AMPLITUDE * omega);
            let gap = |part: f64| -2.0 * k * AMPLITUDE * (1.0 - part * part).max(0.0).sqrt();
            if part.abs() < 0.9 {
                assert!((bin.gap_n.measured / gap(part) - 1.0).abs() < 0.02, "{part} {}", bin.gap_n.measured);
            } else {
                // The outermost bins include the end of the loop, where the gap closes.
                assert!((gap(0.9)..0.0).contains(&bin.gap_n.measured), "{part} {}", bin.gap_n.measured);
            }
        }
        assert!((got.max_gap_n.measured / (2.0 * k * AMPLITUDE) - 1.0).abs() < 0.01);
    }

    #[test]
    fn a_function_of_velocity_alone_has_no_hysteresis() {
        let got = measured(&sine(2, 1777, |_, v, _| 900.0 * v * v.abs() + 80.0 * libm::tanh(50.0 * v)));
        assert!(got.max_gap_n.measured < 1.0, "{:?}", got.max_gap_n);
        assert!(got.area_n_m_s.measured.abs() < 1e-6, "{}", got.area_n_m_s.measured);
    }

    #[test]
    fn mass_leads_and_spring_lags() {
        assert!(measured(&sine(1, 400, |_, _, a| 2.0 * a)).area_n_m_s.measured > 0.0);
        assert!(measured(&sine(1, 400, |x, _, _| 2000.0 * x)).area_n_m_s.measured < 0.0);
    }

    #[test]
    fn the_gap_integrates_to_the_area() {
        let got = measured(&sine(2, 3000, |x, v, _| 9e5 * x * x.abs() + 1000.0 * v - 4e4 * x * v.abs()));
        let width = 2.0 * AMPLITUDE * 2.0 * PI * FREQUENCY / BINS as f64;
        let integral: f64 = got.gap.iter().map(|bin| bin.gap_n.measured * width).sum();
        assert!((integral / got.area_n_m_s.measured - 1.0).abs() < 0.01, "{integral} {}", got.area_n_m_s.measured);
    }

    #[test]
    fn friction_at_the_reversal_is_not_a_gap() {
        let got = measured(&sine(2, 997, |_, v, _| 60.0 * v.signum()));
        assert!(got.max_gap_n.measured < 1e-9, "{:?}", got.max_gap_n);
        assert!((got.energy_j.measured / (4.0 * 60.0 * AMPLITUDE) - 1.0).abs() < 0.01);
    }

    #[test]
    fn sparse_cycles_leave_bins_out_and_stay_finite() {
        let got = measured(&sine(1, 12, |x, v, _| 5000.0 * x + 1000.0 * v));
        assert!(got.gap.len() < BINS);
        assert!(got.mean_gap_n.measured.is_finite() && got.gap_error_n == 0.0 && got.area_n_m_s.measured < 0.0);
    }

    #[test]
    fn without_cycles_or_motion_there_is_none() {
        let mut record = sine(1, 100, |x, _, _| x);
        let none = |record: &Record| {
            let zero = vec![0.0; record.force.len()];
            let compared = Compared { record, model: zero.clone(), fv_only: zero, used_in_fit: false };
            Hysteresis::of_test(&compared).is_none()
        };
        record.peak_velocity = 0.0;
        assert!(none(&record));
        record.peak_velocity = 1.0;
        record.cycles.clear();
        assert!(none(&record));
    }
}
