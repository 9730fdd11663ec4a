//! Motion of a test between its samples, for a delayed or filtered force channel.

use crate::segment::Segment;
use dashpot_core::Input;
use dashpot_records::restrict;

/// Shifts the motion of a test by a delay `tau`, s: the new motion at each sample is the motion at a time `tau`
/// earlier.
///
/// The motion is smooth and may be interpolated. The force must not be interpolated, because friction can reverse
/// within a sample.
pub fn earlier(segment: &Segment, tau: f64) -> Segment {
    let n = segment.input.len();
    let mut delayed = segment.clone();
    if n < 2 || tau == 0.0 {
        return delayed;
    }
    let mut time = vec![0.0; n];
    for i in 1..n {
        time[i] = time[i - 1] + segment.dt[i];
    }
    let mut right = 1;
    for (i, input) in delayed.input.iter_mut().enumerate() {
        let t = time[i] - tau;
        while right + 1 < n && time[right] < t {
            right += 1;
        }
        while right > 1 && time[right - 1] > t {
            right -= 1;
        }
        let (before, after) = (&segment.input[right - 1], &segment.input[right]);
        (input.displacement, input.velocity) =
            between(before, after, time[right] - time[right - 1], t - time[right - 1]);
        if let (Some(to), Some(from)) = (&mut delayed.setting, &segment.setting) {
            to[i] = if t > time[right - 1] { from[right] } else { from[right - 1] };
        }
    }
    delayed
}

/// Returns the segment with each step divided into `parts` equal steps.
pub fn finer(segment: &Segment, parts: usize) -> Segment {
    let mut fine = segment.clone();
    (fine.dt, fine.input) = (Vec::new(), Vec::new());
    // A command is constant during a step.
    let repeated = |(i, value): (usize, &f64)| std::iter::repeat_n(*value, if i == 0 { 1 } else { parts });
    fine.setting = segment.setting.as_ref().map(|all| all.iter().enumerate().flat_map(repeated).collect());
    for (i, (h, input)) in segment.dt.iter().zip(&segment.input).enumerate() {
        if i == 0 {
            fine.dt.push(*h);
            fine.input.push(*input);
            continue;
        }
        let before = &segment.input[i - 1];
        for part in 1..=parts {
            let share = part as f64 / parts as f64;
            let (displacement, velocity) = between(before, input, *h, share * h);
            fine.dt.push(h / parts as f64);
            fine.input.push(Input { displacement, velocity, ..*input });
        }
    }
    // No force was measured at the added samples.
    fine.force = vec![f64::NAN; fine.input.len()];
    fine
}

/// Interpolates displacement, m, and velocity, m/s, at a time `ahead`, s, after a sample. The next sample is `h`, s,
/// later. Between the samples, the displacement is a Hermite cubic. Outside, it is a straight line. Without a
/// displacement, the velocity is linear between the samples and constant outside.
fn between(before: &Input, after: &Input, h: f64, ahead: f64) -> (Option<f64>, f64) {
    let (Some(x0), Some(x1)) = (before.displacement, after.displacement) else {
        let share = (ahead / h).clamp(0.0, 1.0);
        return (None, before.velocity + share * (after.velocity - before.velocity));
    };
    let (v0, v1) = (before.velocity, after.velocity);
    let inside = restrict(ahead, 0.0, h);
    let (s, rise) = (inside / h, (x1 - x0) / h);
    let (bend, twist) = (3.0 * rise - 2.0 * v0 - v1, v0 + v1 - 2.0 * rise);
    let velocity = v0 + s * (2.0 * bend + 3.0 * twist * s);
    (Some(x0 + inside * (v0 + s * (bend + twist * s)) + (ahead - inside) * velocity), velocity)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sine(n: usize, h: f64) -> Segment {
        let at = |i: usize| 40.0 * h * i as f64 + 0.3;
        Segment {
            name: String::new(),
            dt: (0..n).map(|i| if i == 0 { 0.0 } else { h }).collect(),
            input: (0..n)
                .map(|i| Input {
                    displacement: Some(0.01 * libm::sin(at(i))),
                    velocity: 0.4 * libm::cos(at(i)),
                    side_force: 0.0,
                    temperature: 20.0,
                })
                .collect(),
            setting: None,
            force: vec![0.0; n],
            from: 0,
            scale: 1.0,
            top: 1.0,
            peak_velocity: 0.4,
            amplitude: 0.01,
            clock: 0.0,
        }
    }

    #[test]
    fn the_motion_is_that_of_an_earlier_time() {
        let (n, h) = (400, 1e-3);
        let segment = sine(n, h);
        for tau in [0.4e-3, -0.7e-3, 2.3e-3] {
            let delayed = earlier(&segment, tau);
            for i in 5..n - 5 {
                let phase = 40.0 * (h * i as f64 - tau) + 0.3;
                let x = delayed.input[i].displacement.unwrap_or(f64::NAN);
                assert!((x - 0.01 * phase.sin()).abs() < 1e-9, "{i}: {x}");
                assert!((delayed.input[i].velocity - 0.4 * phase.cos()).abs() < 1e-5, "{i}");
            }
        }
    }

    #[test]
    fn a_finer_motion_passes_through_the_same_samples() {
        let segment = sine(60, 1e-3);
        let fine = finer(&segment, 3);
        assert_eq!(fine.input.len(), 3 * 59 + 1);
        for (i, input) in segment.input.iter().enumerate() {
            let (there, here) = (fine.input[3 * i].displacement, input.displacement);
            assert!((there.unwrap_or(f64::NAN) - here.unwrap_or(f64::NAN)).abs() < 1e-15, "{i}");
            assert!((fine.input[3 * i].velocity - input.velocity).abs() < 1e-12, "{i}");
        }
        let middle: f64 = 40.0 * (10.0 + 1.0 / 3.0) * 1e-3 + 0.3;
        assert!((fine.input[31].displacement.unwrap_or(f64::NAN) - 0.01 * middle.sin()).abs() < 1e-9);
    }

    #[test]
    fn it_goes_straight_on_beyond_its_ends() {
        let segment = sine(50, 1e-3);
        let (first, last) = (&segment.input[0], &segment.input[49]);
        let ahead = earlier(&segment, 1.5e-3).input[0];
        let beyond = earlier(&segment, -1.5e-3).input[49];
        for (moved, end, by) in [(ahead, first, -1.5e-3), (beyond, last, 1.5e-3)] {
            let (x, x0) = (moved.displacement.unwrap_or(f64::NAN), end.displacement.unwrap_or(f64::NAN));
            assert!((x - (x0 + by * end.velocity)).abs() < 1e-12, "{x}");
            assert!((moved.velocity - end.velocity).abs() < 1e-12);
        }
    }
}
