//! Reads the setting of the damper during a test from a channel of the record.

use crate::columns::heading::{without_unit, written_unit};
use crate::data::samples::Samples;
use crate::data::setting_signal::{SettingPattern, SettingSignal};
use crate::messages::phrases;
use crate::quantities::channel::Channel;
use crate::quantities::setting_rules::SettingRules;
use crate::quantities::setting_value::{CLICKS, Setting, as_set, setting_in_unit, tolerance};
use dashpot_messages::{Sentence, format_decimals};

/// A column with the setting of a damper.
#[derive(Debug, Clone, PartialEq)]
struct SettingColumn {
    /// Name of the setting.
    name: String,
    /// Unit of the setting.
    unit: String,
    /// Factor from the unit of the column to the unit of the setting.
    factor: f64,
}

impl SettingColumn {
    /// Determines name and unit of the setting in a column. The sources are the user's rules, else the unit in the
    /// heading, else the words of the heading.
    fn new(heading: &str, rules: &SettingRules) -> SettingColumn {
        let written = written_unit(heading).unwrap_or_default();
        let own = without_unit(heading);
        let named = match own.as_str() {
            "" => "setting",
            word if CLICKS.contains(&word.to_lowercase().as_str()) => "clicks",
            own => own,
        };
        let (name, unit, factor) = setting_in_unit(written).unwrap_or((named, written, 1.0));
        // If the user states a unit, the values of the column are in that unit.
        let is_other = rules.name.is_some() && !rules.unit.is_empty() && rules.unit != unit;
        SettingColumn {
            name: rules.name.clone().unwrap_or_else(|| name.to_owned()),
            unit: if is_other { rules.unit.clone() } else { unit.to_owned() },
            factor: if is_other { 1.0 } else { factor },
        }
    }
}

/// Moves the channel of the setting out of the samples, with its name and unit. A setting column has precedence over a
/// current column, which is removed too. Returns `None` without such a channel.
pub(crate) fn setting_channel(samples: &mut Samples, rules: &SettingRules) -> Option<(Vec<f64>, String, String)> {
    match (samples.setting.take(), samples.current.take()) {
        (Some(mut values), _) => {
            let column = SettingColumn::new(&samples.heading(Channel::Setting), rules);
            values.iter_mut().for_each(|value| *value *= column.factor);
            Some((values, column.name, column.unit))
        }
        (None, Some(current)) => Some((current, "current".to_owned(), "A".to_owned())),
        (None, None) => None,
    }
}

/// Reciprocal of the largest fraction of a test that may be cut off at its start. If the setting changes for longer,
/// the change is the purpose of the test.
///
/// Test: `the_start_of_a_slow_supply_is_cut_off_and_steps_stay`.
const START: usize = 2;

/// Cuts off the start of a test in which a slow supply brings the setting to the value at which it then stays.
///
/// A test with steps between levels stays whole, because its steps show the response of the valve.
pub(super) fn drop_start(mut samples: Samples, rules: &SettingRules) -> Samples {
    if samples.setting.is_none() && samples.current.is_none() {
        return samples;
    }
    let own = (samples.setting.clone(), samples.current.clone());
    let channel = setting_channel(&mut samples, rules);
    (samples.setting, samples.current) = own;
    let Some((channel, name, unit)) = channel else { return samples };
    let half = channel.len() / START;
    let steady_part = &channel[half..];
    let Ok(Some(value)) = Setting::of_channel(steady_part, &name, &unit) else { return samples };
    let tolerance = tolerance(value.value, steady_part);
    let is_off = |own: &f64| (own - value.value).abs() > tolerance;
    let Some(last) = channel[..half].iter().rposition(is_off) else { return samples };
    if Setting::of_channel(&channel, &name, &unit).is_ok()
        || SettingSignal::new(&name, &unit, &channel).pattern == SettingPattern::Steps
    {
        return samples;
    }
    let steady = last + 1;
    let seconds = samples.time.get(steady).zip(samples.time.first()).map_or(0.0, |(to, from)| to - from);
    samples.retain(|place| place >= steady);
    let text =
        Sentence::from(phrases::SETTING_START).with("setting", &name).with("seconds", format_decimals(seconds, 2));
    samples.note("setting_start", text);
    samples
}

/// Determines the setting of the damper: a constant value, or a signal if it changes. Without a channel of the setting,
/// both are `None`. Removes the channel from the samples and adds notes about empty, missing, small or changing values.
pub(super) fn take(samples: &mut Samples, rules: &SettingRules) -> (Option<Setting>, Option<SettingSignal>) {
    let is_current = samples.setting.is_none();
    let in_milliamperes = samples.heading(Channel::Current).trim_end_matches([']', ')', '}', ' ']).ends_with("mA");
    let Some((channel, name, unit)) = setting_channel(samples, rules) else { return (None, None) };
    if channel.iter().all(|value| !value.is_finite()) {
        samples.note("empty_setting", Sentence::from(phrases::SETTING_EMPTY).with("setting", &name));
    }
    let largest = channel.iter().copied().filter(|value| value.is_finite()).fold(0.0, |most: f64, i| most.max(i.abs()));
    // The heading states mA, but the values are typical of a column in A.
    if is_current && in_milliamperes && largest > 0.0 && as_set(largest, "A") == 0.0 {
        let current = format_decimals(1e3 * largest, 1);
        samples.note("small_current", Sentence::from(phrases::SMALL_CURRENT).with("current", current));
    }
    let missing = channel.iter().filter(|value| !value.is_finite()).count();
    if missing > 0 && missing < channel.len() {
        let held = Sentence::from(phrases::SETTING_HELD).with("count", missing).with("rows", channel.len());
        samples.note("missing", held.with("setting", &name));
    }
    match Setting::of_channel(&channel, &name, &unit) {
        Ok(setting) => (setting, None),
        Err(_) => {
            let signal = SettingSignal::new(&name, &unit, &channel);
            let change = Sentence::from(phrases::SETTING_CHANGES).with_sentence("change", signal.describe());
            samples.note("changing_setting", change.with("option", &name));
            (None, Some(signal))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_is_named_by_the_user_or_by_its_unit_or_by_its_words() {
        let none = SettingRules::default();
        let of = |heading: &str, rules: &SettingRules| {
            let SettingColumn { name, unit, factor } = SettingColumn::new(heading, rules);
            (name, unit, factor)
        };
        let owned = |name: &str, unit: &str, factor| (name.to_owned(), unit.to_owned(), factor);
        assert_eq!(of("valve command [mV]", &none), owned("voltage", "V", 1e-3));
        assert_eq!(of("p pilot [bar]", &none), owned("pressure", "bar", 1.0));
        assert_eq!(of("Duty Cycle [%]", &none), owned("duty cycle", "%", 1.0));
        for word in ["clicks", "Klicks", "CLK"] {
            assert_eq!(of(word, &none), owned("clicks", "", 1.0));
        }
        let rules = SettingRules { name: Some("pilot".into()), unit: "MPa".into(), ..SettingRules::default() };
        assert_eq!(of("p [bar]", &rules), owned("pilot", "MPa", 1.0));
        let named = SettingRules { name: Some("pilot".into()), ..SettingRules::default() };
        assert_eq!(of("p [bar]", &named), owned("pilot", "bar", 1.0));
    }

    /// Checks that only the start of a slow supply is cut off. A constant setting, a step, a sine and a ramp stay
    /// whole.
    #[test]
    fn the_start_of_a_slow_supply_is_cut_off_and_steps_stay() {
        let with = |current: &dyn Fn(f64) -> f64| {
            let mut samples = crate::fixtures::moving(1000.0, vec![0.0; 4000]);
            samples.current = Some((0..4000).map(|k| current(1e-3 * f64::from(k))).collect());
            drop_start(samples, &SettingRules::default())
        };
        let slow = with(&|t| 0.8 * (1.0 - libm::exp(-t / 0.15)));
        assert!((3000..3700).contains(&slow.time.len()), "{}", slow.time.len());
        assert!(slow.notes.iter().any(|note| note.kind == "setting_start" && note.is_of_damage()));
        for whole in [
            with(&|_| 0.8),
            with(&|t| if t < 1.0 { 0.0 } else { 0.8 }),
            with(&|t| 0.8 + 0.4 * libm::sin(3.0 * t)),
            with(&|t| 0.2 * t),
        ] {
            assert_eq!(whole.time.len(), 4000);
        }
    }

    #[test]
    fn currents_that_no_valve_answers_to_and_empty_columns_are_noted() {
        let noted = |heading: &str, current: f64| {
            let mut samples = crate::fixtures::moving(1000.0, vec![0.0; 50]);
            samples.current = Some(vec![current; 50]);
            samples.headings.push((Channel::Current, heading.to_owned()));
            let (setting, _) = take(&mut samples, &SettingRules::default());
            assert!(samples.notes.iter().all(|note| note.is_of_damage()), "shown by every verb");
            let notes: Vec<String> = samples.notes.iter().map(|note| note.text.to_string()).collect();
            (setting.map(|setting| setting.value), notes.concat())
        };
        // The column contains the value 1.6, and its heading states mA.
        let (value, said) = noted("I_mA", 1.6e-3);
        assert!(value == Some(0.0) && said.contains("at most 1.6 mA") && said.contains("--unit current=A"), "{said}");
        // A sensor offset (1.6 mA) and a valve that is on (0.4 A) or off (0 A) give no note.
        for (heading, current) in [("current [A]", 1.6e-3), ("current [mA]", 0.4), ("current [mA]", 0.0)] {
            assert_eq!(noted(heading, current).1, "", "{heading} {current}");
        }
        let (value, said) = noted("current [A]", f64::NAN);
        assert!(value.is_none() && said.contains("'current' is empty"), "{said}");
    }
}
