//! Reads a motion to be imposed on a model. The file formats are those of records, but the motion is not cleaned.

use std::path::Path;

use super::motion_setting::MotionSetting;
use super::profile::{self, Profile};
use super::record_file::read_file;
use crate::cleaning::corrections::calibrate;
use crate::cleaning::still;
use crate::data::samples::Samples;
use crate::error::{ColumnError, ImposedMotionError, RecordError, RecordFileError, SampleError};
use crate::options::{Options, Positive};
use crate::quantities::channel::Channel;
use crate::quantities::motion_limit::motion_limit;
use crate::signal::consistency;

/// A motion as recorded in its file: SI, extension (rebound) positive, not cleaned.
///
/// All channels have the same length, at least two samples. Time increases. Displacement or velocity is present, or
/// both.
#[derive(Debug, Clone, Default)]
pub struct MotionRecord {
    /// Time, s, strictly increasing.
    pub time: Vec<f64>,
    /// Displacement, m.
    pub displacement: Option<Vec<f64>>,
    /// Velocity, m/s.
    pub velocity: Option<Vec<f64>>,
    /// Side force, N.
    pub side_force: Option<Vec<f64>>,
    /// Damper temperature, °C.
    pub temperature: Option<Vec<f64>>,
    /// Setting of an adjustable damper, if the file states one.
    pub setting: Option<MotionSetting>,
    /// Positive direction of the file as stated by the options or by a profile, if stated.
    pub positive: Option<Positive>,
}

/// Reads a motion. `options` state units, columns, ignored channels, signs and the displacement zero, with precedence
/// over a profile in the file's folder. Gains of the channels apply as in records. Extension is positive unless the
/// options or the profile state another direction. The force column is not read. The setting is recognized as in
/// records.
///
/// # Errors
/// [`RecordError`] if the file cannot be read, contains several tests or has a missing value, or if its time does not
/// increase. A missing setting column, or a velocity that contradicts the displacement, is also a [`RecordError`].
pub fn read_motion(file: &Path, options: &Options) -> Result<MotionRecord, RecordError> {
    if !file.exists() {
        return Err(RecordFileError::NotFound { file: file.into() }.into());
    }
    let setting_column = options.columns.get(&Channel::Setting).filter(|_| !options.ignore.contains(&Channel::Setting));
    let mut options = with_profile(file, options)?;
    options.ignore.insert(Channel::Force);
    let mut tests = read_file(file, &options)?;
    let Some(mut samples) = tests.pop() else {
        return Err(SampleError::NoData { at: crate::Place::file(file) }.into());
    };
    if let Some(other) = tests.first() {
        return Err(
            ImposedMotionError::Several { file: file.into(), first: other.name.clone(), second: samples.name }.into()
        );
    }
    if let Some(wanted) = setting_column.filter(|_| samples.setting.is_none()) {
        return Err(ColumnError::NoSettingColumn { wanted: wanted.clone() }.into());
    }
    check(&samples)?;
    calibrate(&mut samples, &options);
    // At rest, both channels contain only noise, and their noise does not agree.
    if !still::is_at_rest(&samples)
        && let (Some(displacement), Some(velocity)) = (&samples.displacement, &samples.velocity)
        && let Some(agreement) = consistency::compare(&samples.time, displacement, velocity)
        && let Some(cause) = consistency::contradiction(&agreement, &samples.units)
    {
        return Err(SampleError::Contradiction { at: samples.at, cause }.into());
    }
    let setting = MotionSetting::take(&mut samples, &options.settings);
    let Samples { time, mut displacement, mut velocity, side_force, temperature, .. } = samples;
    let sign = turn(&options);
    displacement.iter_mut().flatten().for_each(|x| *x = sign * (*x - options.displacement_zero_m));
    velocity.iter_mut().flatten().for_each(|v| *v *= sign);
    Ok(MotionRecord { time, displacement, velocity, side_force, temperature, setting, positive: options.positive })
}

/// Reads the force, N, that was recorded with a motion. The force is tension positive if the options and the profile
/// state the right direction and sign. Returns `None` if the options ignore the force. Also returns `None` if the file
/// cannot be read, has no force, or has missing values of the force.
pub fn read_force_of_motion(file: &Path, options: &Options) -> Option<Vec<f64>> {
    let options = with_profile(file, options).ok().filter(|options| !options.ignore.contains(&Channel::Force))?;
    let mut force = read_file(file, &options).ok()?.pop()?.force;
    let sign = if options.positive == Some(Positive::Compression) { -1.0 } else { 1.0 };
    let sign = if options.flip_force { -sign } else { sign };
    force.iter_mut().for_each(|force| *force = sign * options.gain * (*force - options.force_zero_n));
    (!force.is_empty() && force.iter().all(|force| force.is_finite())).then_some(force)
}

/// Returns the options, completed by those of the profile in the folder of the file.
fn with_profile(file: &Path, options: &Options) -> Result<Options, RecordError> {
    let profile = Profile::read(&profile::folder_of(file))?.map(|profile| profile.options().unwrap_or_default());
    Ok(profile.map_or_else(|| options.clone(), |profile| options.over(&profile)))
}

/// Returns the factor, 1 or -1, that makes displacement and velocity of the file positive in extension.
fn turn(options: &Options) -> f64 {
    if options.flip_motion != (options.positive == Some(Positive::Compression)) { -1.0 } else { 1.0 }
}

fn check(samples: &Samples) -> Result<(), RecordError> {
    for channel in Channel::ALL {
        let Some(values) = samples.channel(channel) else { continue };
        if let Some(row) = values.iter().position(|v| !v.is_finite()) {
            return Err(ImposedMotionError::Gap { at: samples.at.clone(), line: samples.lines[row], channel }.into());
        }
        let limit = motion_limit(channel);
        if let Some(row) = values.iter().position(|v| v.abs() > limit) {
            let (at, line, value) = (samples.at.clone(), samples.lines[row], values[row]);
            return Err(ImposedMotionError::Beyond { at, line, channel, value, limit }.into());
        }
    }
    if samples.len() < 2 {
        return Err(ImposedMotionError::TooShort { at: samples.at.clone() }.into());
    }
    if let Some(row) = samples.time.windows(2).position(|t| t[1] <= t[0]) {
        return Err(ImposedMotionError::TimeBackwards {
            at: samples.at.clone(),
            line: samples.lines[row + 1],
            from: samples.time[row],
            to: samples.time[row + 1],
        }
        .into());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Channel;
    use crate::SettingSource;
    use crate::Unit;

    fn read(text: &str, options: &Options) -> Result<MotionRecord, String> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("road.csv");
        std::fs::write(&file, text).unwrap();
        read_motion(&file, options).map_err(|e| e.to_string())
    }

    #[test]
    fn a_motion_needs_no_force_and_is_not_touched() {
        let motion = read("t_ms;x_mm;F\n0;0,5;1\n1;99;2\n2;0,5;3\n", &Options::default()).unwrap();
        assert_eq!(motion.time, [0.0, 0.001, 0.002]);
        // The cleaning of records would remove the jump as an outlier.
        assert_eq!(motion.displacement.unwrap(), [0.0005, 0.099, 0.0005]);
        assert!(motion.velocity.is_none());
        let options = Options { units: [(Channel::Velocity, Unit::MillimetrePerSecond)].into(), ..Options::default() };
        let motion = read("time [s],velocity\n0,5\n1,6\n", &options).unwrap();
        assert_eq!(motion.velocity.unwrap(), [0.005, 0.006]);
    }

    #[test]
    fn options_and_profile_state_the_sign_of_motion_and_force() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("road.csv");
        std::fs::write(&file, "time_s,x_m,force_N\n0,1,10\n1,2,20\n").unwrap();
        let read = |positive: Option<Positive>| {
            let options = Options { positive, ..Options::default() };
            let motion = read_motion(&file, &options).unwrap();
            (motion.displacement.unwrap(), read_force_of_motion(&file, &options).unwrap(), motion.positive)
        };
        let (as_it_is, reversed) = ((vec![1.0, 2.0], vec![10.0, 20.0]), (vec![-1.0, -2.0], vec![-10.0, -20.0]));
        assert_eq!(read(None), (as_it_is.0.clone(), as_it_is.1.clone(), None));
        let compression = Some(Positive::Compression);
        assert_eq!(read(compression), (reversed.0.clone(), reversed.1.clone(), compression));
        let profile = "format = \"dashpot campaign profile 1\"\npositive = \"compression\"\n";
        std::fs::write(folder.path().join("campaign.toml"), profile).unwrap();
        assert_eq!(read(None), (reversed.0, reversed.1, compression));
        let rebound = Some(Positive::Rebound);
        assert_eq!(read(rebound), (as_it_is.0, as_it_is.1, rebound));
        std::fs::write(&file, "time_s,x_m\n0,1\n1,2\n").unwrap();
        assert_eq!(read_force_of_motion(&file, &Options::default()), None);
        std::fs::write(&file, "time_s,x_m,force_N\n0,1,\n1,2,3\n").unwrap();
        assert_eq!(read_force_of_motion(&file, &Options::default()), None);
    }

    #[test]
    fn gains_apply_before_the_zero_as_in_records() {
        let options = Options {
            gains: [(Channel::Displacement, 1.5), (Channel::Temperature, 2.0)].into(),
            displacement_zero_m: 1.0,
            ..Options::default()
        };
        let motion = read("t_s,x_m,T_degC\n0,2,20\n1,4,20\n", &options).unwrap();
        assert_eq!((motion.displacement, motion.temperature), (Some(vec![2.0, 5.0]), Some(vec![40.0, 40.0])));
    }

    #[test]
    fn the_setting_of_a_motion_is_recognized_as_in_records() {
        let setting = |text: &str, options: &Options| read(text, options).map(|motion| motion.setting);
        let found = setting("t_ms,x_mm,current [mA]\n0,1,200\n1,1,1400\n", &Options::default()).unwrap().unwrap();
        assert_eq!((found.name.as_str(), found.unit.as_str(), &found.values[..]), ("current", "A", &[0.2, 1.4][..]));
        assert_eq!(found.source, SettingSource::Column("current [mA]".into(), Channel::Current));
        // Clicks need no declaration, because only adjusters have clicks.
        let found = setting("t_ms,x_mm,Clicks\n0,1,4\n1,1,4\n", &Options::default()).unwrap().unwrap();
        assert_eq!((found.name.as_str(), found.unit.as_str(), &found.values[..]), ("clicks", "", &[4.0, 4.0][..]));
        let text = "t_ms,x_mm,p pilot [bar]\n0,1,5\n1,1,6\n";
        assert_eq!(setting(text, &Options::default()).unwrap(), None);
        let named =
            |heading: &str| Options { columns: [(Channel::Setting, heading.to_owned())].into(), ..Options::default() };
        let found = setting(text, &named("p pilot [bar]")).unwrap().unwrap();
        assert_eq!((found.name.as_str(), found.unit.as_str(), &found.values[..]), ("pressure", "bar", &[5.0, 6.0][..]));
        assert!(setting(text, &named("lost")).unwrap_err().contains("'lost'"));
        let message = setting("t_ms,x_mm,current [A]\n0,1,0\n1,1,\n", &Options::default()).unwrap_err();
        assert!(message.contains("line 3: current is missing"), "{message}");
        // The user's statement about the file has precedence over its column. The file name counts if there is no
        // column.
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("road_1.6A.csv");
        let read = |text: &str| {
            std::fs::write(&file, text).unwrap();
            let setting = read_motion(&file, &Options::default()).unwrap().setting.unwrap();
            (setting.values[0], setting.source)
        };
        assert_eq!(read("t_ms,x_mm\n0,1\n1,1\n"), (1.6, SettingSource::Name { is_sure: true }));
        let column = SettingSource::Column("current [A]".into(), Channel::Current);
        assert_eq!(read("t_ms,x_mm,current [A]\n0,1,0.4\n1,1,0.4\n"), (0.4, column));
        let profile = "format = \"dashpot campaign profile 1\"\nsetting = \"current\"\n[settings]\n\"road*\" = 0.8\n";
        std::fs::write(folder.path().join("campaign.toml"), profile).unwrap();
        assert_eq!(read("t_ms,x_mm,current [A]\n0,1,0.4\n1,1,0.4\n"), (0.8, SettingSource::Profile));
    }

    #[test]
    fn a_motion_at_rest_is_not_compared_with_its_velocity() {
        let mut random = crate::fixtures::Random::new(5);
        let mut row =
            |k: i32| format!("{},{:.7},{:.7}\n", 0.001 * f64::from(k), 1e-6 * random.normal(), 1e-4 * random.normal());
        let rows: String = (0..250).map(&mut row).collect();
        assert!(read(&format!("time_s,x_m,v_m_s\n{rows}"), &Options::default()).is_ok());
    }

    #[test]
    fn a_velocity_of_another_sign_or_unit_than_the_displacement_is_refused() {
        let rows = |scale: f64| {
            let row = |k: i32| {
                let phase = 0.1 * f64::from(k);
                format!("{},{},{}\n", 0.01 * f64::from(k), 0.01 * phase.sin(), scale * 0.1 * phase.cos())
            };
            (0..200).map(row).collect::<String>()
        };
        let message = |scale| read(&format!("time_s,x_m,v_m_s\n{}", rows(scale)), &Options::default()).unwrap_err();
        assert!(message(-1.0).contains("opposite signs") && message(-1.0).contains("road.csv"), "{}", message(-1.0));
        assert!(message(1000.0).contains("mm"), "{}", message(1000.0));
        assert!(read(&format!("time_s,x_m,v_m_s\n{}", rows(1.0)), &Options::default()).is_ok());
    }

    #[test]
    fn numbers_beyond_those_of_a_motion_are_rejected_with_line_and_limit() {
        for (headings, column, named, limit) in [
            ("time_s,x_m", 0, "time", "1e10 s"),
            ("time_s,x_m", 1, "displacement", "1000 m"),
            ("time_s,v_m_s", 1, "velocity", "1000 m/s"),
            ("time_s,x_m,side_force_N", 2, "side_force", "1e9 N"),
            ("time_s,x_m,T_degC", 2, "temperature", "100000 °C"),
            ("time_s,x_m,current [A]", 2, "current", "1e9 A"),
            ("time_s,x_m,Clicks", 2, "setting", "1e9"),
        ] {
            for value in ["1e308", "-1e308"] {
                let mut rows = [["0", "0", "0"], ["1", "0", "0"], ["2", "0", "0"]];
                rows[1][column] = value;
                let count = headings.split(',').count();
                let rows: String = rows.iter().map(|row| row[..count].join(",") + "\n").collect();
                let message = read(&format!("{headings}\n{rows}"), &Options::default()).unwrap_err();
                let unit = limit.split_once(' ').map_or("", |(_, unit)| unit);
                let wanted = format!("line 3: {named} is {}", format!("{value} {unit}").trim_end());
                assert!(message.contains(&wanted) && message.contains(&format!("±{limit};")), "{message}");
                assert!(message.len() < 300, "{message}");
            }
        }
        assert!(read("time_s,x_m\n0,0\n1e-308,1e-308\n", &Options::default()).is_ok());
    }

    #[test]
    fn what_is_no_motion_is_refused_with_its_line() {
        for (text, wanted) in [
            ("time_s,x_m\n0,1\n1,nan\n2,1\n", "road.csv, line 3: displacement is missing or no number"),
            ("time_s,x_m\n0,1\n,2\n2,1\n", "line 3: time is missing"),
            ("time_s,x_m\n0,1\n1,1\n1,2\n", "line 4: time does not increase: 1 s comes after 1 s"),
            ("time_s,x_m\n0,1\n2,1\n1,2\n", "line 4: time does not increase: 1 s comes after 2 s"),
            ("time_s,x_m\n0,1\n", "has one row; a motion needs at least two"),
            ("time_s,x_m\n", "no data rows"),
            ("", "is empty (0 bytes)"),
            ("a,b\n1,2\n", "no header line"),
            ("time_s,force_N\n0,1\n1,1\n", "no column for displacement or velocity"),
            ("test,time_s,x_m\na,0,1\na,1,1\nb,0,1\nb,1,1\n", "holds several tests, 'a' and 'b'"),
        ] {
            let message = read(text, &Options::default()).unwrap_err();
            assert!(message.contains(wanted) && message.contains("road.csv"), "{text:?}: {message}");
        }
    }
}
