//! Splits friction programs: a few strokes of constant speed in both directions at each of several speeds, without a
//! standstill. Each speed is one test.
//!
//! Each speed has too few whole cycles for a comparison of cycles. Therefore, the strokes are compared.

use super::cycles::{self, turning_points};
use super::rests::part;
use crate::data::cycle::Cycle;
use crate::data::record::Note;
use crate::data::samples::Samples;
use crate::messages::phrases;
use crate::numbers::range;
use crate::signal::noise::difference_noise;
use crate::tuning::cleaning::FEWEST;
use crate::tuning::stairs::{COARSE, FEWEST_STROKES, LINE_DEVIATION, MOST, SAME, STROKE};
use dashpot_messages::Sentence;
use std::ops::Range;

/// A stroke between two turning points.
struct Stroke {
    samples: Range<usize>,
    /// Slope of the fitted straight line, m/s, with its sign.
    speed: f64,
    /// Root mean square deviation from a straight line, m.
    off: f64,
    is_straight: bool,
}

/// Splits a friction program into one test for each speed, and inserts a note about the tests before the other notes.
/// If any stroke has few samples and no velocity was recorded, the mean speed of each stroke becomes its velocity.
pub(crate) fn split(mut samples: Samples) -> Vec<Samples> {
    let Some(x) = samples.displacement.as_deref().filter(|x| x.iter().all(|x| x.is_finite())) else {
        return vec![samples];
    };
    let strokes = strokes(&samples.time, x);
    let straight = strokes.iter().filter(|stroke| stroke.is_straight).count();
    if strokes.len() < 2 * FEWEST_STROKES || (straight as f64) < MOST * strokes.len() as f64 {
        return vec![samples];
    }
    let runs = runs(&strokes);
    let spans: Vec<Range<usize>> =
        runs.iter().map(|run| strokes[run.start].samples.start..strokes[run.end - 1].samples.end).collect();
    let is_test = |(run, span): (&Range<usize>, &Range<usize>)| run.len() >= FEWEST_STROKES && span.len() >= FEWEST;
    if runs.len() < 2 || !runs.iter().zip(&spans).all(is_test) {
        return vec![samples];
    }
    let coarse = samples.velocity.is_none() && strokes.iter().any(|stroke| stroke.samples.len() <= COARSE);
    let count = runs.len();
    let found: Vec<(Vec<Cycle>, f64)> = spans
        .iter()
        .map(|span| (cycles::find(&samples.time[span.clone()], &x[span.clone()]), range(&x[span.clone()])))
        .collect();
    if coarse {
        let mut velocity = vec![0.0; samples.len()];
        for stroke in &strokes {
            velocity[stroke.samples.clone()].fill(stroke.speed);
        }
        samples.velocity = Some(velocity);
        samples.note("derived", Sentence::from(phrases::SPEED_OF_STROKES));
    }
    samples.notes.insert(0, Note { kind: "rests", text: Sentence::from(phrases::AT_SPEEDS).with("count", count) });
    let parts = spans.into_iter().zip(found).enumerate();
    parts.map(|(k, (span, (cycles, stroke)))| part(&samples, span, (k, count), &cycles, stroke)).collect()
}

/// Returns the strokes between turning points. The turning point between two strokes may be between two samples.
fn strokes(time: &[f64], x: &[f64]) -> Vec<Stroke> {
    let threshold = (STROKE * range(x)).max(10.0 * difference_noise(x));
    let turns = turning_points(x, threshold);
    let inner = turns.get(1..turns.len().saturating_sub(1)).unwrap_or_default();
    let mut bounds = vec![0];
    for (k, &turn) in inner.iter().enumerate() {
        // Noise may determine which of two samples at a turning point is the extreme. Assign each sample to the stroke
        // with the closer fitted line.
        let (from, to) = (bounds[k], inner.get(k + 1).copied().unwrap_or(x.len()));
        let off = |cut: &usize| stroke(time, x, from..*cut).off + stroke(time, x, *cut..to).off;
        let cuts = [turn + 1, turn, turn + 2].into_iter().filter(|cut| *cut > from + 2 && *cut + 2 < to);
        bounds.push(cuts.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(turn + 1));
    }
    bounds.push(x.len());
    bounds.windows(2).filter(|pair| pair[1] >= pair[0] + 3).map(|pair| stroke(time, x, pair[0]..pair[1])).collect()
}

fn stroke(time: &[f64], x: &[f64], samples: Range<usize>) -> Stroke {
    let n = samples.len() as f64;
    let (mt, mx) = (time[samples.clone()].iter().sum::<f64>() / n, x[samples.clone()].iter().sum::<f64>() / n);
    let (mut tt, mut tx, mut xx) = (0.0, 0.0, 0.0);
    for i in samples.clone() {
        let (t, x) = (time[i] - mt, x[i] - mx);
        (tt, tx, xx) = (tt + t * t, tx + t * x, xx + x * x);
    }
    let speed = if tt > 0.0 { tx / tt } else { 0.0 };
    let off = ((xx - speed * tx).max(0.0) / n).sqrt();
    let is_straight = off <= LINE_DEVIATION * range(&x[samples.clone()]);
    Stroke { samples, speed, off, is_straight }
}

/// Groups consecutive strokes of one speed.
fn runs(strokes: &[Stroke]) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = Vec::new();
    for (k, stroke) in strokes.iter().enumerate() {
        let is_same = |first: &Stroke| {
            let ratio = (stroke.speed / first.speed).abs();
            ratio < SAME && ratio > 1.0 / SAME
        };
        match runs.last_mut() {
            Some(run) if is_same(&strokes[run.start]) => run.end = k + 1,
            _ => runs.push(k..k + 1),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::{Random, moving};

    /// Makes two cycles of a triangular motion at each speed, mm/s. A stroke has 35 mm or takes half a second,
    /// whichever lasts longer. `rate` is the number of samples per second.
    fn program(rate: f64, speeds: &[f64]) -> Samples {
        let mut random = Random::new(4);
        let mut x = Vec::new();
        for speed in speeds {
            let steps = ((35.0 / speed).max(0.5) * rate).round() as usize;
            for stroke in 0..4 {
                for k in 0..steps {
                    let way = (k as f64 + 0.5) * speed / rate;
                    let top = steps as f64 * speed / rate;
                    x.push(1e-3 * if stroke % 2 == 0 { way } else { top - way } + 2e-6 * random.normal());
                }
            }
        }
        moving(rate, x)
    }

    #[test]
    fn every_speed_of_a_friction_program_is_a_test() {
        for rate in [10.0, 500.0] {
            let speeds = [10.0, 20.0, 30.0, 50.0, 75.0, 100.0, 150.0];
            let parts = split(program(rate, &speeds));
            assert_eq!(parts.len(), 7, "{rate}: {:?}", parts.iter().map(|p| &p.name).collect::<Vec<_>>());
            assert!(
                parts.iter().all(|p| p.notes[0].kind == "rests" && p.notes[0].text.to_string().contains("7 tests"))
            );
            if rate == 10.0 {
                for (part, speed) in parts.iter().zip(speeds) {
                    let v = part.velocity.as_ref().unwrap();
                    assert!(v.iter().all(|v| (v.abs() / (1e-3 * speed) - 1.0).abs() < 0.02), "{speed}: {v:?}");
                }
            }
        }
    }

    #[test]
    fn one_speed_and_sines_are_not_split() {
        assert_eq!(split(program(100.0, &[50.0, 50.0, 51.0])).len(), 1);
        let sine = |rate: f64| -> Vec<f64> {
            (0..4000).map(|i| 0.02 * libm::sin(1e-3 * f64::from(i) * rate * (1.0 + 1e-4 * f64::from(i)))).collect()
        };
        assert_eq!(split(moving(500.0, sine(10.0))).len(), 1);
    }

    #[test]
    fn a_stroke_may_deviate_little_from_a_straight_line() {
        // The root mean square deviation of the parabola b t² from its line is b/√180.
        let is_straight = |deviation: f64| {
            let time: Vec<f64> = (0..200).map(|i| f64::from(i) / 199.0).collect();
            let bend = deviation * 180f64.sqrt();
            let x: Vec<f64> = time.iter().map(|t| 0.05 * ((1.0 - bend) * t + bend * t * t)).collect();
            stroke(&time, &x, 0..200).is_straight
        };
        assert!(is_straight(0.012) && !is_straight(0.018));
    }

    #[test]
    fn short_strokes_get_their_mean_speed_as_velocity() {
        let has_velocity = |rate: f64| split(program(rate, &[75.0, 100.0, 150.0])).iter().all(|p| p.velocity.is_some());
        // A stroke lasts half a second.
        assert!(has_velocity(70.0) && !has_velocity(90.0));
    }
}
