//! Rejects exchanged headings: a time that does not increase, or a displacement with the properties of a force.

use crate::data::complete_test::CompleteTest;
use crate::data::cycle::Cycle;
use crate::data::samples::Samples;
use crate::error::{PlausibilityError, RecordError};
use crate::messages::phrases;
use crate::numbers::{median, quantile, range};
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::tuning::swapped_columns::{FORWARD, HIGHEST, LONGEST, NO_SINE, PURER, ROUGHER};
use dashpot_messages::{Sentence, format_decimals};

/// Rejects samples with headings that are probably exchanged. A unit that the user gave for a channel confirms its
/// heading.
pub(crate) fn reject(samples: &Samples, options: &Options) -> Result<(), RecordError> {
    let insisted = |a: Channel, b: Channel| [a, b].iter().any(|c| options.units.contains_key(c));
    let error = |a: Channel, b: Channel, evidence: Sentence| {
        RecordError::Implausible(PlausibilityError::Swapped {
            at: samples.at.clone(),
            first: samples.heading(a),
            second: samples.heading(b),
            of_first: a,
            of_second: b,
            evidence,
        })
    };
    if samples.len() < 20 {
        return Ok(());
    }
    if !insisted(Channel::Time, Channel::Time) && forward(&samples.time) < 0.7 {
        for other in [Channel::Force, Channel::Displacement, Channel::Velocity] {
            let advances = samples.channel(other).is_some_and(|v| range(v) > 0.0 && forward(v) > FORWARD);
            if advances && !insisted(Channel::Time, other) {
                let evidence = Sentence::from(phrases::TIME_STANDS)
                    .with("percent", format_decimals(100.0 * (1.0 - forward(&samples.time)), 0))
                    .with_sentence("other", other.message());
                return Err(error(Channel::Time, other, evidence));
            }
        }
    }
    let Some(x) = &samples.displacement else { return Ok(()) };
    if insisted(Channel::Displacement, Channel::Force) {
        return Ok(());
    }
    let (move_range, force_range) = (spread(x), spread(&samples.force));
    if !(move_range > 0.0 && force_range > 0.0) {
        return Ok(());
    }
    let spans = Sentence::from(phrases::SPANS)
        .with("displacement", format_decimals(1e3 * move_range, 1))
        .with("force", format_decimals(force_range, 3));
    let rougher = roughness(x) > ROUGHER * roughness(&samples.force);
    // These conditions together indicate exchanged channels. The displacement ranges over more than 1 m ([`LONGEST`]),
    // the force over less than 500 N, and the displacement is rougher than the force.
    if move_range > LONGEST && force_range < 500.0 && rougher {
        return Err(error(
            Channel::Displacement,
            Channel::Force,
            Sentence::from(phrases::FORCE_SMOOTHER).with_sentence("spans", spans),
        ));
    }
    // A damper dissipates, so the sense of rotation of the force-displacement loop is known. Exchanged channels reverse
    // this sense, and so does a wrong sign. Therefore, a reversed loop counts as evidence only if the displacement is
    // rougher than the force. With a velocity channel, the evidence is its correlation with the derivatives of both
    // channels.
    if let Some(v) = &samples.velocity {
        let (by_x, by_f) = (follows(&samples.time, x, v), follows(&samples.time, &samples.force, v));
        if by_f > 0.97 && by_x < 0.8 {
            let evidence = Sentence::from(phrases::DERIVATIVE_OF_FORCE)
                .with("with_force", format_decimals(by_f, 2))
                .with("with_displacement", format_decimals(by_x, 2));
            return Err(error(Channel::Displacement, Channel::Force, evidence));
        }
    } else if rougher && loop_area(x, &samples.force) < 0.0 {
        let evidence = Sentence::from(phrases::DISPLACEMENT_ROUGHER)
            .with("times", format_decimals(roughness(x) / roughness(&samples.force), 1))
            .with_sentence("spans", spans);
        return Err(error(Channel::Displacement, Channel::Force, evidence));
    }
    Ok(())
}

/// Deviation of a periodic test from a sine in displacement and in force: the ratios of harmonics to fundamental.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Overtones {
    pub displacement: f64,
    pub force: f64,
}

impl Overtones {
    /// Returns whether the channels of force and motion seem exchanged: the displacement has harmonics, and the force
    /// has far fewer.
    pub fn exchanged(&self) -> bool {
        self.displacement > NO_SINE && self.displacement > PURER * self.force
    }

    /// Computes the harmonics over the whole cycles of a test. Returns `None` without cycles or with too few samples.
    pub fn measure(motion: &CompleteTest) -> Option<Overtones> {
        let of = |values: &[f64]| {
            let mut shares: Vec<f64> =
                motion.cycles.iter().filter_map(|c| overtones(&motion.time, values, c)).collect();
            (!shares.is_empty()).then(|| median(&mut shares))
        };
        Some(Overtones { displacement: of(&motion.displacement)?, force: of(&motion.force)? })
    }
}

/// Computes the harmonics of one cycle relative to its fundamental. Returns `None` for too few samples or without a
/// fundamental.
fn overtones(time: &[f64], values: &[f64], cycle: &Cycle) -> Option<f64> {
    let span = cycle.start..cycle.end;
    if span.len() < 4 * HIGHEST {
        return None;
    }
    let (time, values) = (&time[span.clone()], &values[span]);
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let turn = std::f64::consts::TAU / (cycle.end_time - cycle.start_time);
    let wave = |k: usize| {
        let (mut a, mut b) = (0.0, 0.0);
        for (t, value) in time.iter().zip(values) {
            let phase = turn * k as f64 * (t - cycle.start_time);
            a += (value - mean) * libm::cos(phase);
            b += (value - mean) * libm::sin(phase);
        }
        libm::hypot(a, b)
    };
    let ground = wave(1);
    let over = (2..=HIGHEST).map(wave).fold(0.0, libm::hypot);
    (ground > 0.0).then(|| over / ground)
}

/// Returns the fraction of steps that increase.
fn forward(values: &[f64]) -> f64 {
    let steps = values.windows(2).filter(|w| w[1] > w[0]).count();
    steps as f64 / (values.len() - 1).max(1) as f64
}

/// Returns the range of the finite values without the highest and the lowest 2 %, which may be outliers.
fn spread(values: &[f64]) -> f64 {
    let mut finite: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    quantile(&mut finite, 0.98) - quantile(&mut finite, 0.02)
}

/// Computes the root mean square of the third differences relative to the [`spread`]. Steps, knees and noise increase
/// it.
fn roughness(values: &[f64]) -> f64 {
    let mut sizes: Vec<f64> =
        values.windows(4).map(|w| (w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0]).powi(2)).filter(|d| d.is_finite()).collect();
    let spread = spread(values);
    // The largest 0.5 % of the differences may be outliers, so they are excluded.
    let count = sizes.len();
    sizes.sort_by(f64::total_cmp);
    sizes.truncate(count - count / 200);
    let mean = sizes.iter().sum::<f64>() / sizes.len().max(1) as f64;
    if spread > 0.0 { (mean.sqrt() / spread).max(1e-12) } else { 1e-12 }
}

/// Computes the area of the force-displacement loop, N m, positive if the damper dissipates.
fn loop_area(x: &[f64], force: &[f64]) -> f64 {
    let pairs = x.windows(2).zip(force.windows(2));
    pairs.map(|(x, f)| 0.5 * (f[0] + f[1]) * (x[1] - x[0])).filter(|a| a.is_finite()).sum()
}

/// Computes the correlation between the derivative of the column `values` and the column `speed`. Near one, `speed` is
/// the velocity of `values`.
fn follows(time: &[f64], values: &[f64], speed: &[f64]) -> f64 {
    let (mut ab, mut aa, mut bb) = (0.0, 0.0, 0.0);
    // Differences over several samples reduce the noise.
    let reach = (time.len() / 400).clamp(1, 20);
    for i in reach..time.len().saturating_sub(reach) {
        let step = time[i + reach] - time[i - reach];
        let (a, b) = ((values[i + reach] - values[i - reach]) / step, speed[i]);
        if step > 0.0 && a.is_finite() && b.is_finite() {
            ab += a * b;
            aa += a * a;
            bb += b * b;
        }
    }
    if aa > 0.0 && bb > 0.0 { ab / (aa * bb).sqrt() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::SineTest;

    fn said(change: impl Fn(&mut Samples)) -> String {
        let mut samples = SineTest::default().samples();
        change(&mut samples);
        reject(&samples, &Options::default()).map_or_else(|e| e.to_string(), |()| String::new())
    }

    fn swap_with_force(samples: &mut Samples) {
        let x = samples.displacement.as_mut().unwrap();
        std::mem::swap(x, &mut samples.force);
    }

    #[test]
    fn a_spike_is_no_evidence_of_swapped_headings() {
        for height in [1e4, 1e7] {
            let with_spike = |s: &mut Samples| {
                s.velocity = None;
                s.force[700] = height;
            };
            assert_eq!(said(with_spike), "");
        }
    }

    #[test]
    fn swapped_headings_are_told_with_the_evidence() {
        assert_eq!(said(|_| ()), "");
        assert_eq!(said(|s| s.velocity = None), "");
        // A reversed sign of force or motion is not an exchange. `checks/sign.rs` reports it.
        assert_eq!(said(|s| s.force.iter_mut().for_each(|f| *f = -*f)), "");
        assert_eq!(
            said(|s| {
                s.velocity = None;
                s.force.iter_mut().for_each(|f| *f = -*f)
            }),
            ""
        );
        for without_velocity in [false, true] {
            for scale in [1.0, 1e-3] {
                let message = said(|s| {
                    swap_with_force(s);
                    // A wrong heading also gives the column a wrong unit.
                    s.displacement.as_mut().unwrap().iter_mut().for_each(|x| *x *= scale);
                    s.force.iter_mut().for_each(|f| *f *= 1e3);
                    if without_velocity {
                        s.velocity = None;
                    }
                });
                assert!(message.contains("swapped") && message.contains("--column displacement="), "{scale} {message}");
            }
        }
        let message = said(|s| {
            let x = s.displacement.as_mut().unwrap();
            std::mem::swap(x, &mut s.time);
        });
        assert!(message.contains("column read as time"), "{message}");
    }

    #[test]
    fn a_unit_given_insists() {
        let mut samples = SineTest::default().samples();
        swap_with_force(&mut samples);
        let mut options = Options::default();
        assert!(reject(&samples, &options).is_err());
        options.units.insert(Channel::Displacement, "mm".parse().unwrap());
        assert!(reject(&samples, &options).is_ok());
    }

    /// Returns whether the displacement is rejected as a force. The displacement has the given `range`, m, and `times`
    /// the roughness of the force. The recorded velocity is the derivative of the displacement, so it is no evidence of
    /// an exchange.
    fn is_rejected(range: f64, times: f64) -> bool {
        let phase = |i: usize| std::f64::consts::TAU * i as f64 / 400.0;
        // The eleventh harmonic increases the third differences by 11³ and hardly changes the range.
        let harmonic = (times * times - 1.0).sqrt() / 1331.0;
        let mut samples = SineTest { noise: 0.0, ..SineTest::default() }.samples();
        let n = samples.len();
        let of = |wave: &dyn Fn(f64) -> f64| (0..n).map(|i| 0.5 * range * wave(phase(i))).collect::<Vec<f64>>();
        samples.displacement = Some(of(&|p| libm::sin(p) + harmonic * libm::sin(11.0 * p)));
        samples.velocity = Some(of(&|p| libm::cos(p) + 11.0 * harmonic * libm::cos(11.0 * p)));
        samples.force = (0..n).map(|i| 100.0 * libm::cos(phase(i))).collect();
        reject(&samples, &Options::default()).is_err()
    }

    #[test]
    fn a_rough_displacement_of_more_than_a_meter_is_a_force() {
        assert!(is_rejected(1.3, 4.0) && !is_rejected(0.8, 4.0));
        assert!(is_rejected(1.3, 3.0) && !is_rejected(1.3, 2.0));
    }
}
