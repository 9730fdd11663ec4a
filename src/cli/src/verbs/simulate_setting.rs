//! Setting of the damper along a motion, from the file of the motion or from `dashpot simulate --setting`.

use super::data::name_of;
use super::setting::note_of_interpolation;
use crate::quantity::{SettingText, seconds};
use anyhow::bail;
use dashpot_core::family::Axis;
use dashpot_identification::setting_units::is_of_axis;
use dashpot_messages::format_number;
use dashpot_records::{Channel, MotionSetting, SettingSource, is_same_setting, restrict, setting_in_words};
use dashpot_simulation::imposed_motion::ImposedMotion;
use std::path::Path;

/// Largest magnitude of a time of `--setting`, s. It includes times of a clock in seconds since 1970.
const LATEST: f64 = 1e10;

/// Largest accepted ratio of a setting to the largest setting of the model file. With a larger ratio, the setting is probably in another
/// unit, such as mA instead of A, and it is rejected. With a smaller ratio above 1, the valve is at its stop, so the setting is clamped
/// with a note. A lower limit would reject such valves of a model file with few settings. A limit above 1000 would accept mA.
const OF_ANOTHER_UNIT: f64 = 30.0;

/// Settings over time from the option `--setting`: start time, s, and setting of each entry.
#[derive(Debug, Clone, PartialEq)]
pub struct Schedule(Vec<(f64, SettingText)>);

impl Schedule {
    /// Parses a setting, or pairs of time and setting such as `0:0.4,1.5:1.2`.
    ///
    /// # Errors
    /// The text is not of this form, or the times do not increase.
    pub fn parse(text: &str) -> Result<Schedule, String> {
        let setting = |text: &str| {
            text.parse::<SettingText>().map_err(|why| format!("{why}, or times and settings such as 0:0.4,1.5:1.2"))
        };
        if !text.contains(':') {
            return Ok(Schedule(vec![(f64::NEG_INFINITY, setting(text)?)]));
        }
        let mut all = Vec::new();
        for part in text.split(',') {
            let (time, value) = part.split_once(':').ok_or_else(|| format!("{part:?} has no time, as in 1.5:1.2"))?;
            let start = seconds(time)?;
            if start.abs() > LATEST {
                let (start, latest) = (format_number(start), format_number(LATEST));
                return Err(format!("the time {start} s is beyond any motion; give -{latest} to {latest} s"));
            }
            all.push((start, setting(value)?));
        }
        if all.windows(2).any(|pair| pair[1].0 <= pair[0].0) {
            return Err("the times must increase".to_owned());
        }
        Ok(Schedule(all))
    }

    /// Converts the settings to the unit of a damper's setting.
    fn values(&self, axis: &Axis) -> anyhow::Result<Vec<(f64, f64)>> {
        self.0.iter().map(|(from, setting)| Ok((*from, setting.in_unit_of(axis)?))).collect()
    }
}

/// Returns the setting of a schedule at a time. Before the first time of the schedule this is `start`.
fn value_at(schedule: &[(f64, f64)], time: f64, start: f64) -> f64 {
    schedule.iter().rev().find(|(from, _)| *from <= time).map_or(start, |(_, value)| *value)
}

/// Source of the setting of a simulation.
#[derive(Debug, Clone, PartialEq)]
enum Source {
    /// The option `--setting` as pairs of time, s, and setting, and the start setting of the model file. The start
    /// setting applies before the first time.
    Schedule(Vec<(f64, f64)>, f64),
    /// The file of the motion.
    Motion,
    /// The start setting of the model file.
    Start(f64),
}

/// Commands to the valve in a simulation, with notes for the user.
#[derive(Debug, Clone, PartialEq)]
pub struct Commands {
    source: Source,
    /// Notes for the user on the choice of the setting.
    pub notes: Vec<String>,
}

impl Commands {
    /// Chooses between the option `--setting`, the motion's own setting, and the start setting of the model file.
    ///
    /// # Errors
    /// Both the option and a column of the motion have a setting, or the setting that applies has another unit than the model.
    pub fn choose(
        (model, axis): (&Path, &Axis),
        (motion, own): (&Path, Option<&MotionSetting>),
        given: Option<&Schedule>,
    ) -> anyhow::Result<Commands> {
        // A column of the channel `setting` is used even if the setting of the model has another name. Either the user named this column,
        // or its heading means clicks.
        let is_named = |of: &MotionSetting| matches!(of.source, SettingSource::Column(_, Channel::Setting));
        let is_of_model = |of: &&MotionSetting| is_of_axis(axis, &of.name) || is_named(of);
        let mut notes = Vec::new();
        // A part of a file name such as 1A may number the motions. It counts as a current only if the model depends on a current in this
        // unit and the range of its settings includes the value.
        let (low, high) = axis.range();
        let can_be = |of: &&MotionSetting| {
            of.source != SettingSource::Name { is_sure: false }
                || is_of_model(of)
                    && of.unit == axis.unit()
                    && of.values.iter().all(|value| (low..=high).contains(value))
        };
        let own = own.filter(can_be);
        if let Some(other) = own.filter(|of| !is_of_model(of)) {
            notes.push(format!(
                "{} states its {}, but {} depends on {}; the {} is not read",
                name_of(motion),
                other.name,
                model.display(),
                axis.name(),
                other.name
            ));
        }
        let own = own.filter(is_of_model);
        if let Some(schedule) = given {
            match own.map(|of| &of.source) {
                // The option and the column contradict each other, and the intended one is unknown.
                Some(SettingSource::Column(heading, channel)) => bail!(
                    "{} has the setting of each sample in its column '{heading}': leave --setting out, or leave the column unread with \
                     --ignore {channel}",
                    motion.display()
                ),
                Some(SettingSource::Name { .. }) => {
                    notes.push(format!("--setting goes before the setting in the name {}", name_of(motion)));
                }
                Some(SettingSource::Profile) => notes.push(format!(
                    "--setting goes before the setting that campaign.toml states for {}",
                    name_of(motion)
                )),
                None => {}
            }
            let values = schedule.values(axis)?;
            check_unit(values.iter().map(|(_, value)| *value), (axis, model), "--setting")?;
            return Ok(Commands { source: Source::Schedule(values, axis.start()), notes });
        }
        let Some(of) = own else {
            notes.push(format!(
                "the damper is at the start setting of {}, {}; no setting was found in the motion's columns or read from its name. \
                 Give --setting, such as --setting 0.8 or --setting 0:0.4,1.5:1.2, or name its column with --column setting=HEADING. A column of currents without a unit is not read: --unit current=A",
                model.display(),
                axis.start()
            ));
            return Ok(Commands { source: Source::Start(axis.start()), notes });
        };
        if !axis.unit().is_empty() && !of.unit.is_empty() && axis.unit() != of.unit {
            bail!(
                "{} has its {} in {}, {} in {}: convert the one or the other, or give --setting",
                motion.display(),
                of.name,
                of.unit,
                model.display(),
                axis.unit()
            );
        }
        check_unit(of.values.iter().copied(), (axis, model), &format!("the {} of {}", of.name, motion.display()))?;
        notes.push(describe(of, motion));
        notes.extend(outside(of, axis));
        Ok(Commands { source: Source::Motion, notes })
    }

    /// Returns a note if settings of the option lie outside the range of the model, with the number of samples at which they are clamped.
    pub fn clamped(&self, motion: &ImposedMotion, axis: &Axis) -> Option<String> {
        let ((low, high), unit) = (axis.range(), axis.unit());
        let Source::Schedule(schedule, _) = &self.source else { return None };
        let is_outside = |value: f64| !(low..=high).contains(&value);
        let (_, value) = schedule.iter().find(|(_, value)| is_outside(*value))?;
        let all = motion.time.len();
        let count = (0..all).filter(|sample| is_outside(self.command(motion, *sample))).count();
        let [value, low, high] = [*value, low, high].map(|value| setting_in_words(value, unit));
        Some(format!(
            "the setting {value} lies outside those of the model file, {low} to {high}, and is clamped to them at {count} of {all} samples; \
             check its unit"
        ))
    }

    /// Returns a note if the option states one setting, and its force is interpolated.
    pub fn interpolated(&self, axis: &Axis) -> Option<String> {
        let Source::Schedule(schedule, _) = &self.source else { return None };
        let [(_, setting)] = schedule[..] else { return None };
        note_of_interpolation(axis, setting)
    }

    /// Returns a note if the option has times after the end of the motion, `end`, s.
    pub fn unreached(&self, end: f64) -> Option<String> {
        let Source::Schedule(schedule, _) = &self.source else { return None };
        let (from, value) = schedule.iter().find(|(from, _)| *from > end)?;
        let [end, value, from] = [end, *value, *from].map(format_number);
        Some(format!(
            "the motion ends at {end} s, so the setting {value} from {from} s on is never reached; times are in s, or with a unit such as 500ms"
        ))
    }

    /// Returns the command during the step of a motion that ends at a sample.
    pub fn command(&self, motion: &ImposedMotion, sample: usize) -> f64 {
        match &self.source {
            Source::Schedule(schedule, start) => {
                value_at(schedule, motion.time.get(sample).copied().unwrap_or(0.0), *start)
            }
            Source::Motion => motion.command(sample).unwrap_or(0.0),
            Source::Start(start) => *start,
        }
    }

    /// Returns the setting at a sample of a motion.
    pub fn setting(&self, motion: &ImposedMotion, sample: usize) -> f64 {
        match &self.source {
            Source::Motion => motion.setting.as_ref().and_then(|of| of.get(sample)).copied().unwrap_or(0.0),
            Source::Schedule(..) | Source::Start(_) => self.command(motion, sample),
        }
    }
}

/// Returns the heading of the column of a setting, such as `current_A`. The reader of records recognizes this heading.
pub fn heading(axis: &Axis) -> String {
    let text = match axis.unit() {
        "" => axis.name().to_owned(),
        unit => format!("{}_{unit}", axis.name()),
    };
    text.chars().map(|letter| if letter.is_alphanumeric() { letter } else { '_' }).collect()
}

/// Returns the lowest and the highest setting of a motion.
fn range(of: &MotionSetting) -> (f64, f64) {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    of.values.iter().fold(ends, |(low, high), value| (low.min(*value), high.max(*value)))
}

/// Rounds a value to the decimals that give `size` three digits. Integer digits are not rounded.
///
/// The rounding removes the noise of a logged current, which is never exactly 0 and whose many digits obscure the actual values.
fn rounded(value: f64, size: f64) -> f64 {
    if size <= 0.0 {
        return value;
    }
    let decimals = (2.0 - libm::log10(size).floor()).clamp(0.0, 9.0) as usize;
    // The sum removes the sign of a negative zero.
    format!("{value:.decimals$}").parse().unwrap_or(value) + 0.0
}

/// Describes the source of the setting, and the range of its values.
fn describe(of: &MotionSetting, motion: &Path) -> String {
    let (low, high) = range(of);
    let size = low.abs().max(high.abs());
    let [low, high] = [low, high].map(|value| rounded(value, size));
    let is_one = low >= high;
    let [low, high] = [low, high].map(format_number);
    let values = if is_one { format!("{low} {}", of.unit) } else { format!("{low} to {high} {}", of.unit) };
    let source = match &of.source {
        SettingSource::Column(heading, _) => format!("from the column '{heading}' of {}", name_of(motion)),
        SettingSource::Name { .. } => format!("from the name {}", name_of(motion)),
        SettingSource::Profile => format!("from campaign.toml for {}", name_of(motion)),
    };
    format!("{} {source}: {}", of.name, values.trim_end())
}

/// Returns a note if settings of the motion lie outside the range of the model.
fn outside(of: &MotionSetting, axis: &Axis) -> Option<String> {
    let (low, high) = axis.range();
    // At the end of the range, the noise of a logged current does not count as another setting.
    let is_outside = |value: f64| !is_same_setting(value, restrict(value, low, high));
    let count = of.values.iter().filter(|value| is_outside(**value)).count();
    (count > 0).then(|| {
        let [low, high] = [low, high].map(|value| setting_in_words(value, axis.unit()));
        format!(
            "at {count} of {} samples the {} lies outside the settings of the model file, {low} to {high}, and is clamped to them",
            of.values.len(),
            of.name
        )
    })
}

/// Checks that settings are plausible in the unit of a model file. `source` is the option or column with the settings.
///
/// # Errors
/// The largest setting exceeds the largest setting of the model file by more than the factor [`OF_ANOTHER_UNIT`].
fn check_unit(settings: impl Iterator<Item = f64>, (axis, model): (&Axis, &Path), source: &str) -> anyhow::Result<()> {
    let (low, high) = axis.range();
    let largest = settings.map(f64::abs).fold(0.0, f64::max);
    if largest > OF_ANOTHER_UNIT * low.abs().max(high.abs()) {
        let [largest, low, high] = [largest, low, high].map(|value| setting_in_words(value, axis.unit()));
        bail!(
            "{source} reaches {largest}, and the settings of {} are {low} to {high}: it is in another unit. Give the unit with the number \
             (600mA), in the heading of the column, or with --unit",
            model.display()
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes the axis of a valve current from 0 to 1.6 A.
    fn current() -> Axis {
        let mut axis = Axis::NONE;
        axis.set_grid(&[0.0, 1.6]).unwrap();
        axis.set_name("current").unwrap();
        axis.set_unit("A").unwrap();
        axis
    }

    #[test]
    fn a_schedule_may_bear_units() {
        let axis = current();
        let values = |text: &str| Schedule::parse(text).unwrap().values(&axis);
        assert_eq!(values("400mA").unwrap(), [(f64::NEG_INFINITY, 0.4)]);
        assert_eq!(values("0:400mA, 500ms:1.2A,1.5:0").unwrap(), [(0.0, 0.4), (0.5, 1.2), (1.5, 0.0)]);
        assert!(values("3bar").unwrap_err().to_string().contains("counted in A"));
        assert!(Schedule::parse("1:0,0:1").is_err() && Schedule::parse("0:0.4,1.2").is_err());
    }

    #[test]
    fn times_and_settings_beyond_their_bounds_are_rejected() {
        let mut axis = Axis::NONE;
        axis.set_grid(&[0.0, 1.6]).unwrap();
        let values = |text: &str| match Schedule::parse(text) {
            Ok(schedule) => schedule.values(&axis).map(|_| ()).map_err(|why| why.to_string()),
            Err(why) => Err(why),
        };
        for bad in ["1e308", "-1e308", "nan", "inf"] {
            for text in [bad.to_owned(), format!("0:{bad}"), format!("{bad}:1"), format!("0:0.4,{bad}:1")] {
                let message = values(&text).unwrap_err();
                assert!(message.contains(bad) && message.len() < 300, "{text}: {message}");
            }
        }
        assert!(values("1e-308:1e-308").is_ok() && values("-1:0").is_ok());
    }

    #[test]
    fn a_logged_current_is_said_in_few_digits_and_its_noise_is_not_outside() {
        let mut axis = Axis::NONE;
        axis.set_grid(&[0.0, 1.6]).unwrap();
        let motion = |values: Vec<f64>| MotionSetting {
            name: "current".to_owned(),
            unit: "A".to_owned(),
            values,
            source: SettingSource::Name { is_sure: true },
        };
        let noisy = motion(vec![-0.0003, 0.8, 1.6004]);
        assert!(describe(&noisy, Path::new("x.csv")).ends_with(": 0 to 1.6 A"));
        assert!(describe(&motion(vec![1234.2; 2]), Path::new("x.csv")).ends_with(": 1234 A"));
        assert_eq!(outside(&noisy, &axis), None);
        assert!(outside(&motion(vec![-0.1, 1.0]), &axis).unwrap().contains("at 1 of 2"));
    }

    #[test]
    fn a_whole_number_in_a_name_is_a_current_where_the_model_reaches_it() {
        let axis = current();
        let source = |name: &str, is_sure: bool, value: f64| {
            let motion = MotionSetting {
                name: name.to_owned(),
                unit: "A".to_owned(),
                values: vec![value; 3],
                source: SettingSource::Name { is_sure },
            };
            let found =
                Commands::choose((Path::new("m.toml"), &axis), (Path::new("x.csv"), Some(&motion)), None).unwrap();
            (matches!(found.source, Source::Motion), found.notes.concat())
        };
        assert!(source("current", false, 1.0).0 && source("current", true, 0.4).0);
        // A number in a file name may number the motions. A value outside the range of the model, or a setting of another quantity, is
        // ignored.
        assert!(!source("current", false, 9.0).0);
        let (is_read, notes) = source("clicks", false, 1.0);
        assert!(!is_read && !notes.contains("clicks"), "{notes}");
        assert!(source("clicks", true, 1.0).1.contains("the clicks is not read"));
    }

    #[test]
    fn one_setting_between_those_of_the_model_file_is_said_to_be_interpolated() {
        let axis = current();
        let note = |text: &str| {
            let schedule = Schedule::parse(text).unwrap();
            let chosen = Commands::choose((Path::new("m.toml"), &axis), (Path::new("x.csv"), None), Some(&schedule));
            chosen.unwrap().interpolated(&axis)
        };
        assert_eq!((note("0"), note("1.6"), note("9")), (None, None, None));
        let said = note("0.3").unwrap();
        assert!(said.contains("0.3 A lies between the settings") && said.contains("interpolated"), "{said}");
    }

    #[test]
    fn a_setting_in_another_unit_is_rejected_and_one_beyond_the_grid_is_not() {
        let axis = current();
        let of_motion = |value: f64| {
            let motion = MotionSetting {
                name: "current".to_owned(),
                unit: "A".to_owned(),
                values: vec![0.0, value],
                source: SettingSource::Name { is_sure: true },
            };
            Commands::choose((Path::new("m.toml"), &axis), (Path::new("x.csv"), Some(&motion)), None)
        };
        let of_option = |text: &str| {
            let schedule = Schedule::parse(text).unwrap();
            Commands::choose((Path::new("m.toml"), &axis), (Path::new("x.csv"), None), Some(&schedule))
        };
        assert!(of_motion(2.5).is_ok() && of_option("0:0,1:2.5").is_ok());
        for refused in [of_motion(800.0), of_motion(-800.0), of_option("0:0,1:800")] {
            let why = refused.unwrap_err().to_string();
            assert!(why.contains("800 A") && why.contains("0 A to 1.6 A") && why.contains("600mA"), "{why}");
        }
    }
}
