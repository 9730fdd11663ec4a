//! First guess of the parameters without a search: FV points at peak velocity, friction and gas force from slow tests.

use crate::scale::Scale;
use crate::segment::Segment;
use crate::unknowns::anchor;
use dashpot_core::Params;
use dashpot_core::curve::Interpolation;
use dashpot_core::elements::fv_curve::choice_of_interpolation;
use dashpot_core::parameter::Number;
use dashpot_core::{element, list, number};
use serde::{Deserialize, Serialize};

/// Peak velocity, m/s, below which tests show only friction and gas force. In Test 9 of the thesis (Jonnalagadda &
/// Vyas, KTH 2020), such tests had at most 2.58 mm/s.
pub const SLOW: f64 = 0.006;
/// Ratio of adjacent velocities of the FV table. Knees extend over this ratio, and closer points would fit noise.
const RATIO: f64 = 1.65;
/// Smallest velocity of an FV point, m/s: at lower velocities, friction and damping cannot be distinguished.
const SMALLEST: f64 = 0.010;
/// Smallest initial friction of a fit, N, for a passenger-car damper. If a fit began at zero friction, it could not
/// find friction.
const LEAST_FRICTION: f64 = 1.0;
/// Smallest number of samples between an FV point and the previous point. A point with fewer samples is omitted, unless
/// it is the first or the last point of its side.
const ENOUGH: usize = 12;

/// Friction and gas force from the forces of steady sliding in both directions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Dry {
    /// Friction, N: half the difference of the two forces.
    pub friction: f64,
    /// Gas force, which pushes the rod out, N: the negative mean of the two forces.
    pub gas: f64,
}

fn median(mut values: Vec<f64>) -> Option<f64> {
    let middle = values.len().checked_sub(1)? / 2;
    Some(*values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// Computes friction and gas force from the median forces of both strokes. Uses samples with velocities between the
/// fractions `low` and `high` of the peak velocity of their test. Returns `None` if a stroke has no such sample.
fn strokes<'a>(segments: impl Iterator<Item = &'a Segment> + Clone, low: f64, high: f64) -> Option<Dry> {
    let side = |sign: f64| {
        let forces = segments
            .clone()
            .flat_map(|s| {
                s.input.iter().zip(&s.force).filter_map(move |(i, f)| {
                    let part = sign * i.velocity / s.peak_velocity;
                    (part > low && part < high).then_some(*f)
                })
            })
            .collect();
        median(forces)
    };
    let (up, down) = (side(1.0)?, side(-1.0)?);
    Some(Dry { friction: 0.5 * (up - down), gas: -0.5 * (up + down) })
}

/// Computes friction and gas force from tests that are all slow, at velocities above half of their peak velocity.
/// Returns `None` if a stroke has no such sample.
pub fn sliding(slow: &[Segment]) -> Option<Dry> {
    strokes(slow.iter(), 0.5, f64::INFINITY)
}

/// Computes the part of the friction of slow tests that grows with velocity, N: damping. The tests must contain samples
/// at half of their peak velocity and less.
///
/// Friction is assumed linear in velocity, through its values near full speed and below half of full speed. The result
/// is the growing part at the typical velocity of the faster samples. Returns zero for friction that falls with
/// velocity.
pub fn sliding_damping(slow: &[Segment]) -> Option<f64> {
    /// Lower limit, upper limit and typical velocity of the slower samples, as fractions of the peak velocity of a
    /// sine. Below the lower limit, presliding reduces the friction.
    const SLOWER: (f64, f64, f64) = (0.2, 0.5, 0.36);
    /// Typical velocity of the faster samples of a sine: the median between half and full speed.
    const FASTER: f64 = 0.87;
    let (low, high, at) = SLOWER;
    let (slower, faster) = (strokes(slow.iter(), low, high)?, sliding(slow)?);
    let damping = (faster.friction - slower.friction) * FASTER / (FASTER - at);
    Some(damping.min(faster.friction).max(0.0))
}

/// Computes the size of the damper from the largest force of its tests, before an FV curve exists.
pub fn size(segments: &[Segment]) -> Scale {
    Scale::of_force(segments.iter().fold(0.0f64, |most, segment| most.max(segment.top)))
}

/// Computes friction and gas force from the slowest tests. If no test has a peak velocity of at most [`SLOW`], uses
/// samples near the reversals of the slowest tests. Without such samples, returns the smallest initial friction and no
/// gas force.
pub fn dry(segments: &[Segment]) -> Dry {
    let slowest = segments.iter().map(|s| s.peak_velocity).fold(f64::INFINITY, f64::min);
    let limit = SLOW.max(1.5 * slowest);
    let slow = segments.iter().filter(|s| s.peak_velocity <= limit);
    let (low, high) = if slowest <= SLOW { (0.5, f64::INFINITY) } else { (0.02, 0.2) };
    let least = LEAST_FRICTION * size(segments).force();
    match strokes(slow, low, high) {
        Some(dry) => Dry { friction: dry.friction.max(least), ..dry },
        None => Dry { friction: least, gas: 0.0 },
    }
}

/// Returns velocities for the FV table, m/s: zero, and on each side a geometric progression up to the fastest test.
/// Points without enough samples are omitted, except the first and the last point of each side.
pub fn velocities(segments: &[Segment]) -> Vec<f64> {
    let all: Vec<f64> = segments.iter().flat_map(|s| s.input[s.from..].iter().map(|i| i.velocity)).collect();
    let side = |sign: f64| {
        let mut speeds: Vec<f64> = all.iter().map(|v| sign * v).filter(|v| *v > 0.0).collect();
        speeds.sort_by(f64::total_cmp);
        let mut points = Vec::new();
        // The last point is within the samples, not at a single noisy peak.
        let Some(top) = speeds.get(speeds.len().saturating_sub(4)).copied() else { return points };
        // If all tests are very slow, they show mainly friction and determine only a linear FV curve.
        let first = SMALLEST.min(top);
        let steps = (libm::log(top / first) / libm::log(RATIO)).round() as usize;
        for k in 0..=steps {
            points.push(if k == steps { top } else { first * libm::pow(top / first, k as f64 / steps as f64) });
        }
        let mut kept: Vec<f64> = Vec::new();
        for (k, v) in points.iter().enumerate() {
            let below = kept.last().copied().unwrap_or(0.0);
            let count = speeds.partition_point(|s| s <= v) - speeds.partition_point(|s| *s <= below);
            if count >= ENOUGH || k == 0 {
                kept.push(*v);
            } else if k + 1 == points.len() {
                // If there are too few samples between the last two points, keep only the last point, at the end of the
                // data.
                if kept.len() > 1 {
                    kept.pop();
                }
                kept.push(*v);
            }
        }
        kept
    };
    let mut v: Vec<f64> = side(-1.0).into_iter().rev().map(|v| -v).collect();
    v.push(0.0);
    v.extend(side(1.0));
    v
}

/// Computes forces of the FV table, N, at `velocities`, m/s: the mean of acceleration and deceleration over the tests,
/// minus friction and gas force. Samples above 0.9 times the peak velocity of their test have twenty times the weight.
/// Slow tests are excluded. The result is strictly increasing.
pub fn forces(segments: &[Segment], velocities: &[f64], dry: Dry) -> Vec<f64> {
    forces_where(segments, velocities, dry, |_, _| true)
}

/// Computes forces of the FV table, N, from only those samples at which the damper slows down.
///
/// These forces contain no effect of voids and free play. Such effects begin at a reversal and end before the damper
/// slows down for the next reversal.
pub fn slowing_forces(segments: &[Segment], velocities: &[f64], dry: Dry) -> Vec<f64> {
    forces_where(segments, velocities, dry, |s, k| {
        s.input.get(k + 1).is_some_and(|next| next.velocity.abs() < s.input[k].velocity.abs())
    })
}

fn forces_where(
    segments: &[Segment],
    velocities: &[f64],
    dry: Dry,
    is_taken: impl Fn(&Segment, usize) -> bool,
) -> Vec<f64> {
    let zero = anchor(velocities);
    let mut sums = vec![(0.0, 0.0); velocities.len()];
    for s in segments.iter().filter(|s| s.peak_velocity > SLOW) {
        for (place, (input, f)) in s.input.iter().zip(&s.force).enumerate().skip(s.from) {
            if !is_taken(s, place) {
                continue;
            }
            let v = input.velocity;
            // The weight of a sample at a point is the fourth power of its linear interpolation weight.
            let right = velocities.partition_point(|p| *p <= v);
            let (a, b) = (right.saturating_sub(1), right.min(velocities.len() - 1));
            let share = if b > a { (v - velocities[a]) / (velocities[b] - velocities[a]) } else { 0.0 };
            for (k, w) in [(a, 1.0 - share), (b, share)] {
                let w = w.clamp(0.0, 1.0).powi(4) * if v.abs() > 0.9 * s.peak_velocity { 20.0 } else { 1.0 };
                sums[k].0 += w * f;
                sums[k].1 += w;
            }
        }
    }
    let mut f: Vec<f64> = velocities
        .iter()
        .zip(&sums)
        .map(|(v, (sum, weight))| {
            let mean = if *weight > 0.0 { sum / weight } else { 0.0 };
            mean + dry.gas - dry.friction * v.signum()
        })
        .collect();
    f[zero] = 0.0;
    let least = 1e-3 * f.iter().fold(size(segments).force(), |m, f| m.max(f.abs()));
    for k in zero + 1..f.len() {
        f[k] = f[k].max(f[k - 1] + least);
    }
    for k in (0..zero).rev() {
        f[k] = f[k].min(f[k + 1] - least);
    }
    f
}

/// Makes a parameter set with the first guess for all elements; only the FV curve is enabled.
pub fn guess(segments: &[Segment]) -> Params {
    let dry = dry(segments);
    let v = velocities(segments);
    let f = forces(segments, &v, dry);
    let mut p = Params::new();
    p.disable_all();
    let set = |p: &mut Params, number: Number, value: f64| {
        let _ = p.set(number, number.inside(value));
    };
    // Defaults apply to a car damper. Without scaling, the prior would keep the internal mass near 0.5 kg in a damper
    // with twenty times the force.
    let scale = size(segments);
    for number in dashpot_core::parameter::table().filter_map(|row| Number::try_from(row).ok()) {
        set(&mut p, number, scale.of_number(number) * number.default());
    }
    // Valves of rebound and compression have different derivatives at zero velocity. A curve with a common derivative
    // would bias gas force and friction.
    set(&mut p, number!("fv_interpolation"), choice_of_interpolation(Interpolation::CubicEachSide));
    let _ = p.set_list(list!("fv_velocity"), &v);
    let _ = p.set_list(list!("fv_force"), &f);
    p.enable(element!("fv_curve"), true);
    for number in [number!("coulomb_force"), number!("stribeck_coulomb_force"), number!("presliding_force")] {
        set(&mut p, number, dry.friction);
    }
    set(&mut p, number!("stribeck_breakaway_force"), 1.15 * dry.friction);
    set(&mut p, number!("gas_force"), dry.gas);
    for number in [
        number!("spring_linear"),
        number!("spring_quadratic"),
        number!("spring_cubic"),
        number!("spring_quartic"),
        number!("viscous_coefficient"),
    ] {
        set(&mut p, number, 0.0);
    }
    p
}
