//! Functions for numbers: limits, numbers in texts, and statistics of lists.

/// Limits a value to the interval from `low` to `high`. If the limits are in the wrong order, the upper limit has
/// precedence, whereas `clamp` would panic.
pub fn restrict<T: PartialOrd>(value: T, low: T, high: T) -> T {
    let raised = if value < low { low } else { value };
    if raised > high { high } else { raised }
}

/// Splits a text such as `500mA` into the number at its start and the unit after it. Returns `None` if the text does
/// not begin with a finite number.
pub fn split_unit(text: &str) -> Option<(f64, &str)> {
    let ends = text.char_indices().map(|(at, letter)| at + letter.len_utf8());
    // Use the longest prefix that is a number, so that the e of 1e-3s belongs to the number.
    let longest = ends.filter_map(|end| Some((text[..end].parse::<f64>().ok()?, text[end..].trim()))).next_back();
    longest.filter(|(value, _)| value.is_finite())
}

/// Returns the median (the upper of two middle values), or 0 for an empty list. Reorders its argument.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    quantile(values, 0.5)
}

/// Returns the quantile of the values at the fraction `q` (nearest rank), or 0 for an empty list. Reorders its
/// argument.
pub(crate) fn quantile(values: &mut [f64], q: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let rank = ((values.len() - 1) as f64 * q).round() as usize;
    *values.select_nth_unstable_by(rank, f64::total_cmp).1
}

/// Returns the difference between the largest and the smallest value, or 0 for an empty list.
pub(crate) fn range(values: &[f64]) -> f64 {
    let (low, high) =
        values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)));
    (high - low).max(0.0)
}

/// Returns the median time between samples, s; `time` contains the sample times, s.
pub(crate) fn sample_time(time: &[f64]) -> f64 {
    median(&mut time.windows(2).map(|w| w[1] - w[0]).collect::<Vec<_>>())
}
/// Returns the resolution of a channel: the smallest nonzero difference of neighboring samples, or 0 for a constant
/// channel.
pub(crate) fn quantum(values: &[f64]) -> f64 {
    let smallest = values.windows(2).map(|w| (w[1] - w[0]).abs()).filter(|&d| d > 0.0).fold(f64::INFINITY, f64::min);
    if smallest.is_finite() { smallest } else { 0.0 }
}

/// Estimates the standard deviation of white noise from differences of neighboring samples. The median suppresses the
/// effect of steps. Returns 0 if no difference is finite.
pub(crate) fn white_noise(values: &[f64]) -> f64 {
    let mut differences: Vec<f64> =
        values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).filter(|difference| difference.is_finite()).collect();
    // Differences increase the noise by √2. The median of |normal| is 0.6745.
    if differences.is_empty() { 0.0 } else { median(&mut differences) / (0.6745 * std::f64::consts::SQRT_2) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_may_cross() {
        assert_eq!((restrict(5.0, 0.0, 3.0), restrict(-5.0, 0.0, 3.0), restrict(1.0, 0.0, 3.0)), (3.0, 0.0, 1.0));
        assert_eq!((restrict(5, 4, 2), restrict(1, 4, 2)), (2, 2));
        assert_eq!(restrict(1.0, f64::NAN, f64::NAN), 1.0);
        assert!(restrict(f64::NAN, 0.0, 1.0).is_nan());
    }
}
