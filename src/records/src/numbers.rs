//! What is asked of lists of numbers.

/// The value within limits that were computed and may cross; the upper one then wins. `clamp` panics where limits cross, and a panic ends
/// the program.
pub fn restrict<T: PartialOrd>(value: T, low: T, high: T) -> T {
    let raised = if value < low { low } else { value };
    if raised > high { high } else { raised }
}

/// The number that a text begins with, and the unit behind it, as in `500mA`. Nothing where it begins with none that is finite.
pub fn split_unit(text: &str) -> Option<(f64, &str)> {
    let ends = text.char_indices().map(|(at, letter)| at + letter.len_utf8());
    // The longest beginning that is a number; so the e of 1e-3s belongs to it.
    let longest = ends.filter_map(|end| Some((text[..end].parse::<f64>().ok()?, text[end..].trim()))).last();
    longest.filter(|(value, _)| value.is_finite())
}

/// The median; 0 of nothing. Reorders its argument.
pub(crate) fn median(values: &mut [f64]) -> f64 {
    quantile(values, 0.5)
}

/// The value below which the share `q` of the values lies (nearest rank); 0 of nothing. Reorders its argument.
pub(crate) fn quantile(values: &mut [f64], q: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let rank = ((values.len() - 1) as f64 * q).round() as usize;
    *values.select_nth_unstable_by(rank, f64::total_cmp).1
}

/// Difference of the largest and the smallest value; 0 of nothing.
pub(crate) fn range(values: &[f64]) -> f64 {
    let (low, high) =
        values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)));
    (high - low).max(0.0)
}

/// Typical time from sample to sample (the median step).
pub(crate) fn sample_time(time: &[f64]) -> f64 {
    median(&mut time.windows(2).map(|w| w[1] - w[0]).collect::<Vec<_>>())
}
/// The step of a channel's last digit: the smallest difference of neighbours that is not zero.
pub(crate) fn quantum(values: &[f64]) -> f64 {
    let smallest = values.windows(2).map(|w| (w[1] - w[0]).abs()).filter(|&d| d > 0.0).fold(f64::INFINITY, f64::min);
    if smallest.is_finite() { smallest } else { 0.0 }
}

/// Standard deviation of white noise, from differences of neighboring samples; the median makes steps harmless.
pub(crate) fn white_noise(values: &[f64]) -> f64 {
    let mut differences: Vec<f64> =
        values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).filter(|difference| difference.is_finite()).collect();
    // √2 is the gain of the difference, 0.6745 the median of |normal|.
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
