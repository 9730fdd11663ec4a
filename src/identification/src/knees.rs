//! Points of the FV curve where it bends sharply. The points of the first guess stand at fixed ratios of speed, and a valve that blows off within
//! a tenth of its speed is rounded by them. What a point too few leaves of the records is a bump between two points: in the middle of the
//! interval the model lies to the one side of them and at its ends to the other, in every test that passes through, and alike while it speeds
//! up and while it slows down. Free play, oil that gives and friction leave bumps too, but others on the way up and down: a curve must not take
//! them, for a diagnosis looks for them in what is left.

use super::first_guess::SLOW;
use super::more_points::with_points;
use super::variants::Structure;
use dashpot_core::Params;
use dashpot_core::list;
use dashpot_estimation::segment::Segment;
use dashpot_estimation::sensitivity::{Accuracy, Run};

/// Smallest speed, m/s, from which an interval may get points: below, what friction leaves is no knee of a valve.
const FROM: f64 = 0.02;
/// Narrowest interval that is parted, as the ratio of its ends: knees of valves are no narrower, and the smoothing of a measured velocity
/// blurs what is.
const NARROWEST: f64 = 1.12;
/// Fewest tests that must pass through an interval.
const TESTS: usize = 3;
/// Fewest samples of a test in the middle of an interval, and at each of its ends, in each sense: a fast test has few there. Both ends, or a slope
/// would pass for a bump; what one sample scatters by shows between the tests.
const SAMPLES: usize = 1;
/// How many standard errors of the mean over the tests a bump is from nothing, in each of the two senses.
const CLEAR: f64 = 2.0;
/// How many times the bump of the one sense may be that of the other.
const ALIKE: f64 = 2.0;
/// Smallest bump, in units of what a test's noise and floor allow: a smaller one is not worth a point.
const LEAST: f64 = 0.15;

/// The intervals of the curve that show a bump.
fn bumps(structure: Structure, from: &Params, segments: &[Segment]) -> Option<Vec<usize>> {
    let velocity = from.list(list!("fv_velocity"));
    let unknowns = structure.unknowns(from, segments);
    let theta = unknowns.start();
    let run = Run::new(&unknowns, &theta, Accuracy::Full)?;
    // Of each interval, speeding up and slowing down, the bump of each test.
    let mut of: Vec<[Vec<f64>; 2]> = vec![Default::default(); velocity.len().saturating_sub(1)];
    for segment in segments.iter().filter(|s| s.peak_velocity > SLOW) {
        let forces = unknowns.forces(&run, &theta, segment);
        // Sum and count at the one end of each interval, in its middle half, and at the other end.
        let mut sums = vec![[[(0.0, 0usize); 3]; 2]; of.len()];
        let speed = |i: usize| segment.input.get(i).map(|input| input.velocity.abs());
        for (i, model) in forces.iter().enumerate().skip(segment.from.max(1)) {
            let (Some(before), Some(here), Some(next)) = (speed(i - 1), speed(i), speed(i + 1)) else { continue };
            let k = velocity.partition_point(|v| *v <= segment.input[i].velocity);
            if k == 0 || k == velocity.len() {
                continue;
            }
            let (a, b) = (velocity[k - 1].abs(), velocity[k].abs());
            let place = libm::log(here / a) / libm::log(b / a);
            let part = usize::from(place > 0.25) + usize::from(place > 0.75);
            let sum = &mut sums[k - 1][usize::from(next < before)][part];
            *sum = (sum.0 + segment.force[i] - model, sum.1 + 1);
        }
        for (bumps, parts) in of.iter_mut().flatten().zip(sums.iter().flatten()) {
            if parts.iter().all(|part| part.1 >= SAMPLES) {
                let [one, middle, other] = parts.map(|part| part.0 / part.1 as f64);
                bumps.push((middle - 0.5 * (one + other)) / segment.scale);
            }
        }
    }
    // The mean bump, where it is clear.
    let clear = |bumps: &[f64]| {
        let n = bumps.len() as f64;
        let mean = bumps.iter().sum::<f64>() / n;
        let error = (bumps.iter().map(|b| (b - mean).powi(2)).sum::<f64>() / (n * (n - 1.0))).sqrt();
        (bumps.len() >= TESTS && mean.abs() > LEAST && mean.abs() > CLEAR * error).then_some(mean)
    };
    let is_clear = |[up, down]: &[Vec<f64>; 2]| match (clear(up), clear(down)) {
        (Some(up), Some(down)) => up * down > 0.0 && up.abs().max(down.abs()) < ALIKE * up.abs().min(down.abs()),
        _ => false,
    };
    let may = |k: usize| {
        let (low, high) = (velocity[k].abs().min(velocity[k + 1].abs()), velocity[k].abs().max(velocity[k + 1].abs()));
        low >= FROM && high >= NARROWEST * low
    };
    Some((0..of.len()).filter(|&k| may(k) && is_clear(&of[k])).collect())
}

/// The same parameters with every interval of the FV curve that shows a bump parted in so many; nothing where none does, or there are too many
/// points already.
pub fn with_points_at_knees(structure: Structure, from: &Params, segments: &[Segment], parts: usize) -> Option<Params> {
    let v = from.list(list!("fv_velocity"));
    let part = |k: usize| {
        let (a, b) = (v[k], v[k + 1]);
        (1..parts).map(move |i| a * libm::pow(b / a, i as f64 / parts as f64))
    };
    with_points(from, bumps(structure, from, segments)?.into_iter().flat_map(part))
}
