//! The instant within a sample at which a command changes.
//!
//! A logger stores the command before and after a change, and the change is anywhere between the two samples. The
//! estimate assumes a change midway between them. If a rig switches with its clock, all steps have the same timing
//! error, so averaging over steps does not reduce the error. The instant is therefore a considered parameter, not an
//! estimated one. Its uniform distribution over a sample widens the intervals of all other parameters.

/// Standard deviation of the instant within a sample, in samples: 1/√12.
pub const SPREAD: f64 = 0.288_675_134_594_812_9;
/// Step of the central difference with respect to the instant, in samples. The mean command of a step is linear in the
/// instant up to half a sample. Therefore, any smaller step gives an equal derivative, until rounding dominates.
pub const STEP: f64 = 0.1;

/// Computes the commands of time steps `dt`, s, for a signal that is delayed by `later`, s. Each command is the mean of
/// the delayed signal over the step.
pub fn shifted(dt: &[f64], commands: &[f64], later: f64) -> Vec<f64> {
    let count = commands.len().min(dt.len());
    let (Some(first), Some(last)) = (commands.first(), commands[..count].last()) else { return Vec::new() };
    let mut time = vec![0.0; count];
    let mut integral = vec![0.0; count];
    for i in 1..count {
        time[i] = time[i - 1] + dt[i];
        integral[i] = integral[i - 1] + commands[i] * dt[i];
    }
    let mut right = 1;
    let mut until = |t: f64| {
        if t <= 0.0 {
            return first * t;
        }
        while right + 1 < count && time[right] < t {
            right += 1;
        }
        match time.get(right) {
            Some(end) if t <= *end => integral[right] - commands[right] * (end - t),
            _ => integral[count - 1] + last * (t - time[count - 1]),
        }
    };
    let mut before = until(-later);
    let mut all = vec![*first];
    for i in 1..count {
        let now = until(time[i] - later);
        all.push(if dt[i] > 0.0 { (now - before) / dt[i] } else { commands[i] });
        before = now;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shifted_command_keeps_its_integral_and_moves_its_step() {
        let dt = [0.0, 1.0, 1.0, 2.0, 1.0, 1.0];
        let commands = [0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
        let close = |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(close(&shifted(&dt, &commands, 0.0), &commands));
        assert!(close(&shifted(&dt, &commands, 0.5), &[0.0, 0.0, 0.0, 0.75, 1.0, 1.0]));
        assert!(close(&shifted(&dt, &commands, -0.5), &[0.0, 0.0, 0.5, 1.0, 1.0, 1.0]));
        assert!(close(&shifted(&dt, &commands, 2.5), &[0.0, 0.0, 0.0, 0.0, 0.5, 1.0]));
        // The variance of [`SPREAD`] is that of a uniform distribution. The derivative is constant within half a
        // sample.
        assert!((12.0 * SPREAD * SPREAD - 1.0).abs() < 1e-12);
        let moved = |later: f64| shifted(&dt, &commands, later)[3] - commands[3];
        assert!((moved(STEP) / STEP - moved(0.5) / 0.5).abs() < 1e-12);
        assert!(shifted(&[], &[], 0.5).is_empty() && close(&shifted(&[0.0], &[3.0], 0.5), &[3.0]));
    }
}
