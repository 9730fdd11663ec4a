//! Interpolation of a quantity with unequal time steps.

/// Interpolates `values`, given at the times `time`, at the time `t` with Hermite's cubic.
///
/// Outside the range of times, the result is the first or the last value.
///
/// The slope at each point is that of the parabola through this point and its neighbors, or 0 at an extremum.
pub fn interpolate(time: &[f64], values: &[f64], t: f64) -> f64 {
    let n = time.len();
    if t <= time[0] || n < 3 {
        return values[0];
    }
    if t >= time[n - 1] {
        return values[n - 1];
    }
    let i = time.partition_point(|known| *known <= t).min(n - 1).max(1) - 1;
    let slope = |k: usize| {
        let k = k.min(n - 2).max(1);
        let (before, after) = (time[k] - time[k - 1], time[k + 1] - time[k]);
        let (m0, m1) = ((values[k] - values[k - 1]) / before, (values[k + 1] - values[k]) / after);
        // The slope is zero at a local extremum of the values, so that the curve does not overshoot them.
        if m0 * m1 <= 0.0 { 0.0 } else { (m0 * after + m1 * before) / (before + after) }
    };
    let h = time[i + 1] - time[i];
    let u = (t - time[i]) / h;
    let (u2, u3) = (u * u, u * u * u);
    (2.0 * u3 - 3.0 * u2 + 1.0) * values[i]
        + (u3 - 2.0 * u2 + u) * h * slope(i)
        + (3.0 * u2 - 2.0 * u3) * values[i + 1]
        + (u3 - u2) * h * slope(i + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_quantity_is_read_between_uneven_instants() {
        let time: Vec<f64> = (0..200).map(|i| f64::from(i) * 0.01 + 2e-3 * f64::from(i % 3)).collect();
        let values: Vec<f64> = time.iter().map(|t| libm::sin(5.0 * t)).collect();
        for i in 0..190 {
            let t = 0.013 + 0.01 * f64::from(i);
            assert!((interpolate(&time, &values, t) - (5.0 * t).sin()).abs() < 2e-3);
        }
        assert_eq!(interpolate(&time, &values, -1.0), values[0]);
        assert_eq!(interpolate(&time, &values, 9.0), values[199]);
    }
}
