//! A force channel that is late by a time.

/// F(t) becomes F(t − τ), by cubic interpolation with slopes from neighbouring samples.
pub(super) fn delay(tau: f64, dt: &[f64], forces: &mut [f64]) {
    let n = forces.len();
    if n < 3 || tau == 0.0 {
        return;
    }
    let before = forces.to_vec();
    let mut time = vec![0.0; n];
    for i in 1..n {
        time[i] = time[i - 1] + dt[i];
    }
    let slope = |i: usize| {
        let (a, b) = (i.saturating_sub(1), (i + 1).min(n - 1));
        (before[b] - before[a]) / (time[b] - time[a])
    };
    let mut right = 1;
    for i in 0..n {
        let t = (time[i] - tau).clamp(time[0], time[n - 1]);
        while right + 1 < n && time[right] < t {
            right += 1;
        }
        while right > 1 && time[right - 1] > t {
            right -= 1;
        }
        let left = right - 1;
        let h = time[right] - time[left];
        let s = (t - time[left]) / h;
        let (s2, s3) = (s * s, s * s * s);
        forces[i] = before[left] * (2.0 * s3 - 3.0 * s2 + 1.0)
            + before[right] * (3.0 * s2 - 2.0 * s3)
            + h * (slope(left) * (s3 - 2.0 * s2 + s) + slope(right) * (s3 - s2));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_delayed_sine_is_the_sine_of_an_earlier_time() {
        let dt = vec![1e-3; 400];
        let wave = |t: f64| 1000.0 * (30.0 * t).sin();
        for tau in [0.4e-3, -0.7e-3, 2.3e-3] {
            let mut forces: Vec<f64> = (0..400).map(|i| wave(f64::from(i) * 1e-3)).collect();
            delay(tau, &dt, &mut forces);
            for i in 5..395 {
                assert!((forces[i] - wave(i as f64 * 1e-3 - tau)).abs() < 0.02, "{i}");
            }
        }
    }
}
