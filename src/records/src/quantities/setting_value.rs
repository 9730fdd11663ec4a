//! The setting of an adjustable damper in a test: the current of its valve, or the clicks of its adjuster. Its source
//! is a rule of the user, a channel, or the name of the test.

use serde::{Deserialize, Serialize};

use crate::numbers::{quantile, white_noise};
use dashpot_messages::{Sentence, format_number};

/// A setting of an adjustable damper.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    /// Name of the setting, such as `current`, `clicks`, `voltage` or `pressure`.
    pub name: String,
    /// Unit of the setting, such as `A`; empty for clicks.
    pub unit: String,
    /// Value of the setting, in the unit `unit`.
    pub value: f64,
}

/// Largest variation of a setting channel within a test that counts as one setting.
///
/// The first limit is a fraction of the value. The second limit is in the unit of the channel. The larger limit
/// applies. For a current in A, the second limit covers sensor noise and supply ripple.
const STEADY: (f64, f64) = (0.1, 0.05);
/// Range of white noise without [`SPIKES`], in standard deviations. For many samples the range is 3.3 standard
/// deviations. The value is a quarter larger, because few samples give an uncertain estimate.
const NOISE: f64 = 4.1;
/// Fraction of samples at each extreme that may be spikes or the switch-on transition. The range of a channel leaves
/// them out.
const SPIKES: f64 = 0.05;
/// Largest difference of values that count as one setting, A or clicks. Supplies have a resolution of 0.01 A: a
/// difference of 0.01 is within the limit, a difference of 0.02 is not.
pub(crate) const SAME: f64 = 0.0195;
/// Largest relative difference of values that count as one setting, in any unit. With a larger limit, 200 and 201
/// clicks would be one setting.
const ALIKE: f64 = 0.005;

/// Words for the clicks of an adjuster, in headings and in names of tests.
pub(crate) const CLICKS: [&str; 9] = ["clk", "clks", "click", "clicks", "klick", "klicks", "cran", "crans", "档"];
/// Units in names of tests: spellings, name of the setting, its unit, and the factor to this unit.
const UNITS: [(&[&str], &str, &str, f64); 9] = [
    (&["A", "Amp", "amp", "amps"], "current", "A", 1.0),
    (&["mA"], "current", "A", 1e-3),
    (&["V", "Volt", "volt", "volts"], "voltage", "V", 1.0),
    (&["mV"], "voltage", "V", 1e-3),
    (&["clk", "clks", "click", "clicks", "klick", "klicks", "Klick", "Klicks"], "clicks", "", 1.0),
    (&["psi", "PSI"], "pressure", "psi", 1.0),
    (&["bar", "Bar"], "pressure", "bar", 1.0),
    (&["kPa"], "pressure", "kPa", 1.0),
    (&["MPa"], "pressure", "MPa", 1.0),
];
/// Units of pressure, Pa, for comparisons of pressures. A pressure is stored in its stated unit.
const PRESSURES: [(&str, f64); 4] = [("psi", 6_894.757_293_168), ("bar", 1e5), ("kPa", 1e3), ("MPa", 1e6)];
/// Names of settings with translations in every language.
pub(crate) const NAMES: [&str; 4] = ["current", "clicks", "voltage", "pressure"];

/// Inserts the name of a setting into a sentence.
///
/// The name is translated if it is in [`NAMES`]. A name given by the user is equal in all languages.
pub(crate) fn with_setting_name(text: Sentence, place: &'static str, name: &str) -> Sentence {
    if NAMES.contains(&name) { text.with_word(place, name) } else { text.with(place, name) }
}

/// Returns the name of the setting for a unit, the stored unit, and the conversion factor to the stored unit. Returns
/// `None` for an unknown unit.
pub(crate) fn setting_in_unit(written: &str) -> Option<(&'static str, &'static str, f64)> {
    let (_, name, unit, factor) = UNITS.iter().find(|(words, ..)| words.contains(&written))?;
    Some((name, unit, *factor))
}

/// Returns the clicks in a part of a name, such as `12clicks`, `out-2clicks` or `click4`. Clicks are never negative.
fn clicks_in(part: &str) -> Option<f64> {
    let part = part.to_lowercase();
    let is_of_number = |c: char| c.is_ascii_digit() || c == '.';
    let longest = |matches: &dyn Fn(&str) -> Option<usize>| CLICKS.iter().filter_map(|word| matches(word)).max();
    let before = longest(&|word| part.ends_with(word).then_some(word.len()));
    let after = longest(&|word| part.starts_with(word).then_some(word.len()));
    let count = match (before, after) {
        (Some(word), _) => {
            let rest = &part[..part.len() - word];
            rest[rest.rfind(|c: char| !is_of_number(c)).map_or(0, |end| end + 1)..].trim_start_matches('.')
        }
        (None, Some(word)) => part[word..].trim_start_matches(['=', '-']),
        (None, None) => return None,
    };
    if count.chars().all(is_of_number) { count.parse().ok() } else { None }
}

/// Rounds a measured value to the likely set value. Set currents are multiples of 0.01 A, and other set values have at
/// most four digits.
pub(crate) fn as_set(value: f64, unit: &str) -> f64 {
    let per_step =
        if unit == "A" || value == 0.0 { 100.0 } else { 10f64.powi(3 - libm::log10(value.abs()).floor() as i32) };
    // Adding 0.0 removes the sign of −0.
    (value * per_step).round() / per_step + 0.0
}

/// Returns the largest range of a channel that counts as steady, in the unit of the channel. `middle` is its median.
pub(crate) fn tolerance(middle: f64, channel: &[f64]) -> f64 {
    STEADY.1.max(STEADY.0 * middle.abs()) + NOISE * white_noise(channel)
}

impl Setting {
    /// Returns the setting of a channel, or `None` if the channel has no value. If the channel is not steady, the error
    /// contains the lowest and the highest value.
    pub(crate) fn of_channel(channel: &[f64], name: &str, unit: &str) -> Result<Option<Setting>, (f64, f64)> {
        let mut values: Vec<f64> = channel.iter().copied().filter(|v| v.is_finite()).collect();
        if values.is_empty() {
            return Ok(None);
        }
        let (low, high) = (quantile(&mut values, SPIKES), quantile(&mut values, 1.0 - SPIKES));
        let middle = quantile(&mut values, 0.5);
        if high - low > tolerance(middle, channel) {
            return Err((low, high));
        }
        Ok(Some(Setting { name: name.to_owned(), unit: unit.to_owned(), value: as_set(middle, unit) }))
    }

    /// Returns the setting in a part of a test's name, such as `1.6A`, `800mA`, `12clicks`, `c12`, `150psi`. Also
    /// returns whether the part is certainly a setting and not the number of the test.
    fn of_part(part: &str) -> Option<(Setting, bool)> {
        let part = part.trim_start_matches(['I', 'i', '=']).replace(',', ".");
        if let Some(count) = part.strip_prefix(['c', 'C']).filter(|count| count.chars().all(|c| c.is_ascii_digit())) {
            let value: f64 = count.parse().ok()?;
            return Some((Setting { name: "clicks".into(), unit: String::new(), value }, false));
        }
        if let Some(value) = clicks_in(&part) {
            return Some((Setting { name: "clicks".into(), unit: String::new(), value }, true));
        }
        let digits = part.find(|c: char| !c.is_ascii_digit() && c != '.' && c != '-')?;
        let (number, unit) = part.split_at(digits);
        let value: f64 = number.parse().ok()?;
        let (name, unit, factor) = setting_in_unit(unit)?;
        // A whole number with a single letter may be the number of the test.
        let is_sure = part.len() > digits + 1 || value.fract() != 0.0;
        Some((Setting { name: name.into(), unit: unit.into(), value: value * factor }, is_sure))
    }

    /// Returns the setting in a name, and whether it is certainly a setting and not the number of the test. Returns
    /// `None` if the name states no setting or several different settings.
    pub(crate) fn of_name(name: &str) -> Option<(Setting, bool)> {
        let parts: Vec<&str> =
            name.split(|c: char| "_ ()[]/;".contains(c) || c == '\u{a0}').filter(|part| !part.is_empty()).collect();
        // A word for clicks may be separate from its number.
        let is_word = |part: &str| CLICKS.contains(&part.to_lowercase().as_str());
        let whole = |(k, part): (usize, &&str)| match parts.get(k + 1).filter(|next| is_word(next)) {
            Some(word) if part.chars().all(|c| c.is_ascii_digit()) => Setting::of_part(&format!("{part}{word}")),
            _ => Setting::of_part(part),
        };
        let mut found = parts.iter().enumerate().filter_map(whole);
        let first = found.next()?;
        // A folder and the files in it may state the same setting, so equal settings are not several.
        found.all(|(other, _)| first.0.is_same(&other)).then_some(first)
    }

    pub(crate) fn is_same(&self, other: &Setting) -> bool {
        self.name == other.name && is_same_setting(self.value, other.value)
    }
}

/// Returns the factor from one unit of a setting to another, such as from mA to A. Returns 1 if a unit is empty, and
/// `None` if the units measure different quantities.
pub fn setting_factor(from: &str, to: &str) -> Option<f64> {
    if from.is_empty() || to.is_empty() || from == to {
        return Some(1.0);
    }
    let ((_, base, factor), (_, other, of_other)) = (setting_in_unit(from)?, setting_in_unit(to)?);
    let pascals = |unit: &str| PRESSURES.iter().find(|(known, _)| *known == unit).map(|(_, pascals)| *pascals);
    match (pascals(base), pascals(other)) {
        (Some(from), Some(to)) => Some(from / to),
        _ => (base == other).then_some(factor / of_other),
    }
}

/// Converts values of a setting to another unit. Returns whether the units measure one quantity. If they do not, the
/// values stay unchanged.
pub fn restate_in_unit<'v>(unit: &mut String, to: &str, values: impl IntoIterator<Item = &'v mut f64>) -> bool {
    let Some(factor) = setting_factor(unit, to) else { return false };
    // 700 mA are 0.7 A to the last digit only by division.
    let parts = (1.0 / factor).round();
    let by_parts = factor < 1.0 && (parts * factor - 1.0).abs() < 1e-12;
    values.into_iter().for_each(|value| *value = if by_parts { *value / parts } else { *value * factor });
    if !to.is_empty() {
        to.clone_into(unit);
    }
    true
}

/// Returns whether two values are the same setting. The resolution of supplies is a hundredth of an ampere. Steps of
/// other settings are larger than a two-hundredth of the value. Values that differ by less are one setting.
pub fn is_same_setting(a: f64, b: f64) -> bool {
    (a - b).abs() < SAME.max(ALIKE * a.abs().max(b.abs()))
}

/// Formats a value of a setting with its unit, if it has one: `0.8 A`.
pub fn setting_in_words(value: f64, unit: &str) -> String {
    format!("{} {unit}", format_number(value)).trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_small_setting_has_an_exponent() {
        assert_eq!(setting_in_words(1e-308, "A"), "1e-308 A");
    }

    #[test]
    fn settings_are_found_in_names() {
        let of = |name: &str| Setting::of_name(name).map(|(s, _)| (s.name, s.unit, s.value));
        let current = |value| Some(("current".to_owned(), "A".to_owned(), value));
        assert_eq!(of("SH_25mm_0.3Hz_1.6A"), current(1.6));
        assert_eq!(of("SH_25mm_I0,4A"), current(0.4));
        assert_eq!(of("sine 800mA 2Hz"), current(0.8));
        assert_eq!(of("a25_12clicks"), Some(("clicks".to_owned(), String::new(), 12.0)));
        assert_eq!(of("a25_c12"), Some(("clicks".to_owned(), String::new(), 12.0)));
        for name in ["sine-2clicks", "a25 2 clicks", "2_Clicks_out", "a25_click2", "a25_-2clicks", "clk=2_a25"] {
            assert_eq!(of(name), Some(("clicks".to_owned(), String::new(), 2.0)), "{name}");
        }
        assert!(of("clicks_a").is_none() && of("2.5clicksx").is_none());
        assert_eq!(of("a25_1.5clicks"), Some(("clicks".to_owned(), String::new(), 1.5)));
        assert_eq!(of("0.871V_ensaio3"), Some(("voltage".to_owned(), "V".to_owned(), 0.871)));
        assert_eq!(of("gas 150psi 2Hz"), Some(("pressure".to_owned(), "psi".to_owned(), 150.0)));
        assert_eq!(of("0.5A/10mm2Hz_0.5A"), current(0.5));
        for none in ["a25mm_v0131mm_s", "test_A", "1.6A_0.4A", "part2", "0.3Hz", "12B"] {
            assert_eq!(of(none), None, "{none}");
        }
    }

    /// Checks that 0.25 A is not rounded to 0.26 A, and that 1245 psi is not rounded to 1250 psi.
    #[test]
    fn a_measured_setting_is_the_value_that_was_set() {
        for (unit, measured, set) in [
            ("A", 0.2504, 0.25),
            ("A", 0.4496, 0.45),
            ("A", 1.3502, 1.35),
            ("A", -3e-4, 0.0),
            ("MPa", 1.25, 1.25),
            ("psi", 1245.02, 1245.0),
            ("V", 0.8712, 0.8712),
            ("%", 0.0, 0.0),
        ] {
            assert_eq!(as_set(measured, unit), set, "{measured} {unit}");
        }
        let same = |a: f64, b: f64| is_same_setting(a, b);
        assert!(same(299.8, 700.1 - 400.0) && same(0.41, 0.4) && !same(0.42, 0.4) && !same(20.0, 21.0));
    }

    #[test]
    fn a_steady_current_is_a_setting_and_a_changing_one_is_none() {
        // Uniform white noise with a standard deviation of 30 mA, three fifths of the variation of 50 mA that one
        // setting may have without noise.
        let mut seed = 1u32;
        let mut white = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed >> 8) / f64::from(1u32 << 24) - 0.5
        };
        let rippled: Vec<f64> = (0..4000).map(|_| 0.4 + 0.03 * 3.46 * white()).collect();
        let steady = Setting::of_channel(&rippled, "current", "A");
        assert_eq!(steady.ok().flatten().map(|of| of.value), Some(0.4));
        let stepped: Vec<f64> =
            rippled.iter().enumerate().map(|(k, i)| i + if k % 1000 < 500 { 0.0 } else { 0.3 }).collect();
        assert!(Setting::of_channel(&stepped, "current", "A").is_err());
        let slow: Vec<f64> = (0..4000).map(|k| 0.8 + 0.4 * libm::sin(f64::from(k) / 300.0)).collect();
        assert!(Setting::of_channel(&slow, "current", "A").is_err());
        let noisy: Vec<f64> = (0..1000).map(|k| 0.8 + 0.01 * libm::sin(f64::from(k))).collect();
        let of = |values: &[f64]| Setting::of_channel(values, "current", "A");
        assert_eq!(of(&noisy).unwrap().map(|s| s.value), Some(0.8));
        let swept: Vec<f64> = (0..1000).map(|k| 1e-3 * f64::from(k)).collect();
        assert!(of(&swept).is_err());
        assert_eq!(of(&[f64::NAN]), Ok(None));
    }
}
