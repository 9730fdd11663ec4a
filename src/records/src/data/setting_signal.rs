//! A setting that changes within a test: steps of a valve's current, or a continuously varying current.

use serde::{Deserialize, Serialize};

use crate::messages::phrases;
use crate::numbers::{median, white_noise};
use crate::quantities::setting_value::{as_set, with_setting_name};
use dashpot_messages::{Sentence, format_decimals};

/// Tolerance of a level (a constant value over several samples), as a fraction of the signal's range. The tolerance is
/// the largest deviation of a sample from the mean of its level. The larger of this tolerance and that by [`NOISE`]
/// applies.
const LEVEL: f64 = 0.03;
/// Tolerance of a level in standard deviations of the noise (see [`LEVEL`]).
const NOISE: f64 = 4.0;
/// Smallest difference of successive levels, in multiples of the tolerance, at which a signal consists of steps. The
/// apparent levels of a ramp differ by less, so a ramp counts as varying.
const APART: f64 = 3.0;
/// Largest deviation, in multiples of the tolerance, of samples between two equal levels at which both levels count as
/// one. The deviation is that from the second level.
const OUTLIER: f64 = 2.0;
/// Smallest number of samples of a level. A supply in transition gives fewer nearly equal samples.
const STAYS: usize = 5;
/// Smallest fraction of samples that must belong to levels in a signal of steps. The other samples may be transitions
/// of a slow supply.
const COVERED: f64 = 0.9;

/// Pattern of a setting that changes within a test.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SettingPattern {
    /// Steps between constant levels.
    Steps,
    /// Any other change.
    Varying,
}

/// A change from one level to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SettingStep {
    /// Index of the first sample after the previous level.
    pub index: usize,
    /// Index of the first sample after the next level.
    pub end: usize,
    /// Level before the change.
    pub from: f64,
    /// Level after the change.
    pub to: f64,
}

/// A setting that changes within a test, from a channel.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SettingSignal {
    /// Name of the setting, such as `current`.
    pub name: String,
    /// Unit of the setting.
    pub unit: String,
    /// Pattern of the change.
    pub pattern: SettingPattern,
    /// Lowest and highest value.
    pub range: [f64; 2],
    /// Value at each sample of the record. Within a level, this is the value of the level, without noise.
    #[serde(skip)]
    pub values: Vec<f64>,
    /// Mean number of samples between two known values of the channel; 1 if no value is missing. The instant of a step
    /// is uncertain by this number of samples.
    #[serde(skip, default = "every_sample")]
    pub spacing: f64,
}

/// Spacing of a channel without missing values.
fn every_sample() -> f64 {
    1.0
}

/// A range of samples at one level.
#[derive(Debug, Clone, Copy)]
struct Level {
    from: usize,
    end: usize,
    value: f64,
}

impl SettingSignal {
    /// Makes the signal of a channel. Replaces a missing value by the previous value.
    pub fn new(name: &str, unit: &str, channel: &[f64]) -> SettingSignal {
        let known = channel.iter().filter(|value| value.is_finite()).count();
        let spacing = channel.len().max(1) as f64 / known.max(1) as f64;
        let mut values = channel.to_vec();
        let mut last = channel.iter().copied().find(|v| v.is_finite()).unwrap_or(0.0);
        for value in &mut values {
            if value.is_finite() {
                last = *value;
            }
            *value = last;
        }
        let mut found = levels(&values);
        found.iter_mut().flatten().for_each(|level| level.value = as_set(level.value, unit));
        let pattern = if found.is_some() { SettingPattern::Steps } else { SettingPattern::Varying };
        for level in found.iter().flatten() {
            values[level.from..level.end].fill(level.value);
        }
        let range = extremes(&values);
        SettingSignal { name: name.to_owned(), unit: unit.to_owned(), pattern, range, values, spacing }
    }

    /// Returns the changes between levels, or none for a varying signal.
    pub fn steps(&self) -> Vec<SettingStep> {
        let of = |pair: &[Level]| SettingStep {
            index: pair[0].end,
            end: pair[1].end,
            from: pair[0].value,
            to: pair[1].value,
        };
        levels(&self.values).map_or_else(Vec::new, |levels| levels.windows(2).map(of).collect())
    }

    /// Returns the value of the setting during the time step that ends at a sample. A change may occur anywhere in the
    /// time step, so the result is the mean of the values at both ends of the step.
    pub fn command(&self, sample: usize) -> f64 {
        let at = |index: usize| self.values.get(index).copied().unwrap_or(0.0);
        0.5 * (at(sample.saturating_sub(1)) + at(sample))
    }

    /// Describes the change in a sentence.
    pub fn describe(&self) -> Sentence {
        let text = match self.pattern {
            SettingPattern::Steps => Sentence::from(phrases::SETTING_STEPS).with("count", self.steps().len()),
            SettingPattern::Varying => phrases::SETTING_VARIES.into(),
        };
        let text = with_setting_name(text, "setting", &self.name);
        let [low, high] = self.range;
        let high = format!("{high:.2} {}", self.unit);
        text.with("low", format_decimals(low, 2)).with("high", high.trim_end())
    }

    /// Returns the difference between the largest and the smallest value in a range of samples.
    pub fn swing(&self, range: std::ops::Range<usize>) -> f64 {
        let [low, high] = extremes(self.values.get(range).unwrap_or(&[]));
        (high - low).max(0.0)
    }

    /// Returns the signal at other samples, each stated by its index in this signal.
    #[must_use]
    pub fn select(&self, indices: impl IntoIterator<Item = usize>) -> SettingSignal {
        let values = indices.into_iter().filter_map(|index| self.values.get(index).copied()).collect();
        SettingSignal { values, ..self.clone() }
    }

    /// Returns the signal with its values replaced, one per sample of the record.
    #[must_use]
    pub fn with_values(&self, values: Vec<f64>) -> SettingSignal {
        SettingSignal { values, ..self.clone() }
    }
}

fn extremes(values: &[f64]) -> [f64; 2] {
    let (low, high) = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = values.iter().fold((low, high), |(low, high), v| (low.min(*v), high.max(*v)));
    [low, high]
}

/// Largest width of the running median that reduces noise before the search for levels, samples. A median preserves the
/// position of a step, but removes levels that are not longer than half its width.
const SMOOTHED: usize = 25;

/// A signal without the white noise that masks its levels.
struct Smoothed {
    values: Vec<f64>,
    /// Largest deviation of a value from the mean of its level.
    tolerance: f64,
    /// Width of the running median, samples; 1 if no median was necessary.
    width: usize,
}

/// Smooths a signal with the shortest running median after which [`NOISE`] standard deviations of the noise are within
/// the tolerance by [`LEVEL`]. The median is at most [`SMOOTHED`] samples wide.
fn without_noise(values: &[f64]) -> Smoothed {
    let smooth = |width: usize| -> Vec<f64> {
        let at = |k: usize| {
            let (from, to) = (k.saturating_sub(width / 2), (k + width / 2 + 1).min(values.len()));
            median(&mut values[from..to].to_vec())
        };
        if width == 1 { values.to_vec() } else { (0..values.len()).map(at).collect() }
    };
    let noise = white_noise(values);
    let mut width = 1;
    loop {
        let smoothed = smooth(width);
        let [low, high] = extremes(&smoothed);
        // The median of n samples has 1.25/√n times their standard deviation.
        let left = if width == 1 { noise } else { 1.25 * noise / (width as f64).sqrt() };
        let of_range = LEVEL * (high - low);
        if NOISE * left <= of_range || width >= SMOOTHED.min(values.len()) {
            return Smoothed { values: smoothed, tolerance: of_range.max(NOISE * left), width };
        }
        let needed = (1.25 * NOISE * noise / of_range).powi(2).ceil();
        width = if needed < SMOOTHED as f64 { (needed as usize | 1).max(width + 2) } else { SMOOTHED };
    }
}

/// Locates the steps between noisy levels. Each step is at the position with the smallest sum of squared deviations
/// from its two levels.
fn place_steps(values: &[f64], levels: &mut [Level], width: usize) {
    for k in 1..levels.len() {
        let [before, after] = [levels[k - 1], levels[k]];
        if after.from - before.end > width {
            continue;
        }
        let (from, to) = (before.end.saturating_sub(width / 2).max(before.from + 1), after.from + width / 2);
        let (mut least, mut sum, mut step) = (0.0, 0.0, from);
        for (at, value) in values.iter().enumerate().take(to.min(after.end)).skip(from) {
            sum += (value - before.value).powi(2) - (value - after.value).powi(2);
            if sum < least {
                (least, step) = (sum, at + 1);
            }
        }
        (levels[k - 1].end, levels[k].from) = (step, step);
    }
}

/// Returns the levels of a signal, or `None` if the signal does not consist of levels.
fn levels(values: &[f64]) -> Option<Vec<Level>> {
    let Smoothed { values: smoothed, tolerance, width } = without_noise(values);
    // Within half the median's width of a step, the median of noisy samples is biased toward the other level. A level
    // must therefore be as long as the median.
    let stays = STAYS.max(if width == 1 { 0 } else { width });
    let mut levels: Vec<Level> = Vec::new();
    let mut from = 0;
    while from < smoothed.len() {
        let (mut sum, mut end) = (0.0, from);
        while end < smoothed.len() && (end == from || (smoothed[end] - sum / (end - from) as f64).abs() <= tolerance) {
            sum += smoothed[end];
            end += 1;
        }
        if end - from >= stays {
            let value = median(&mut values[from..end].to_vec());
            match levels.last_mut() {
                // A single noisy sample beyond the tolerance does not end a level.
                Some(last)
                    if (last.value - value).abs() <= tolerance
                        && from - last.end < stays
                        && smoothed[last.end..from].iter().all(|v| (v - value).abs() <= OUTLIER * tolerance) =>
                {
                    last.end = end;
                    last.value = median(&mut values[last.from..end].to_vec());
                }
                _ => levels.push(Level { from, end, value }),
            }
            from = end;
        } else {
            from += 1;
        }
    }
    if width > 1 {
        place_steps(values, &mut levels, width);
    }
    let covered: usize = levels.iter().map(|level| level.end - level.from).sum();
    let are_apart = levels.windows(2).all(|pair| (pair[1].value - pair[0].value).abs() >= APART * tolerance);
    let stays = levels.len() > 1 && are_apart && covered as f64 >= COVERED * values.len() as f64;
    stays.then_some(levels)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scatter(k: usize) -> f64 {
        let bits = (k as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40;
        bits as f64 / f64::from(1u32 << 24) - 0.5
    }

    #[test]
    fn steps_are_told_from_what_never_stays() {
        let stepped: Vec<f64> =
            (0..2000).map(|k| if (k / 400) % 2 == 0 { 0.2 } else { 1.4 } + 0.01 * scatter(k)).collect();
        let signal = SettingSignal::new("current", "A", &stepped);
        assert_eq!(signal.pattern, SettingPattern::Steps);
        let steps = signal.steps();
        assert_eq!(steps.iter().map(|s| s.index).collect::<Vec<_>>(), [400, 800, 1200, 1600]);
        assert!((steps[0].from - 0.2).abs() < 1e-3 && (steps[0].to - 1.4).abs() < 1e-3);
        // A level contains no noise.
        assert!(signal.swing(0..400) == 0.0 && signal.swing(390..410) > 1.0);
        let ramp: Vec<f64> = (0..2000).map(|k| 1e-3 * k as f64).collect();
        let sine: Vec<f64> = (0..2000).map(|k| 0.8 + 0.8 * libm::sin(0.01 * k as f64)).collect();
        for varying in [ramp, sine] {
            let signal = SettingSignal::new("current", "A", &varying);
            assert_eq!(signal.pattern, SettingPattern::Varying);
            assert!(signal.steps().is_empty() && signal.values == varying);
        }
    }

    /// Checks that the search finds every step of at least 0.4 A in noise with a standard deviation of up to 0.05 A.
    /// Such noise is typical of a current clamp.
    #[test]
    fn noise_hides_no_step() {
        let mut seed = 1u32;
        let mut white = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed >> 8) / f64::from(1u32 << 24) - 0.5
        };
        // The sum of twelve uniform numbers is nearly normal.
        let mut normal = || (0..12).map(|_| white()).sum::<f64>();
        for noise in [0.0, 0.01, 0.03, 0.05] {
            let levels = [0.3, 0.7, 1.1, 1.6, 0.3, 1.6, 0.7];
            let stepped: Vec<f64> = (0..7000).map(|k| levels[k / 1000] + noise * normal()).collect();
            let signal = SettingSignal::new("current", "A", &stepped);
            let steps = signal.steps();
            assert_eq!(steps.len(), 6, "{noise}: {steps:?}");
            for (step, (k, pair)) in steps.iter().zip(levels.windows(2).enumerate()) {
                assert!((step.from - pair[0]).abs() < 0.006 && (step.to - pair[1]).abs() < 0.006, "{noise}: {step:?}");
                assert!(step.index.abs_diff(1000 * (k + 1)) <= 1, "{noise}: {step:?}");
            }
        }
        let short: Vec<f64> = (0..8000).map(|k| if k / 130 % 2 == 0 { 1.1 } else { 1.6 } + 0.03 * normal()).collect();
        let steps = SettingSignal::new("current", "A", &short).steps();
        assert!(steps.len() == 61 && steps.iter().enumerate().all(|(k, s)| s.index.abs_diff(130 * (k + 1)) <= 1));
        let ramp: Vec<f64> = (0..7000).map(|k| 2e-4 * k as f64 + 0.03 * normal()).collect();
        assert_eq!(SettingSignal::new("current", "A", &ramp).pattern, SettingPattern::Varying);
    }

    #[test]
    fn a_supply_that_takes_a_few_samples_makes_a_step() {
        let slow: Vec<f64> =
            (0..1000).map(|k| if k < 500 { 0.0 } else { 1.0 - libm::exp(-(k as f64 - 500.0) / 3.0) }).collect();
        let signal = SettingSignal::new("current", "A", &slow);
        assert_eq!(signal.pattern, SettingPattern::Steps);
        assert_eq!(signal.steps().len(), 1);
        // During a transition, the signal has the measured values.
        assert!((signal.values[502] - slow[502]).abs() < 1e-12);
    }

    #[test]
    fn missing_values_are_those_before_them() {
        let mut values = vec![0.5; 40];
        values.extend([f64::NAN; 3]);
        values.extend([1.5; 40]);
        let signal = SettingSignal::new("current", "A", &values);
        assert_eq!((signal.values[41], signal.steps()[0].index), (0.5, 43));
        assert_eq!(signal.command(43), 1.0);
    }

    #[test]
    fn missing_values_widen_the_known_interval_of_the_command() {
        let channel: Vec<f64> = (0..100).map(|k| if k % 5 == 0 { 0.4 } else { f64::NAN }).collect();
        assert_eq!(SettingSignal::new("current", "A", &channel).spacing, 5.0);
        assert_eq!(SettingSignal::new("current", "A", &[0.4; 100]).spacing, 1.0);
    }
}
