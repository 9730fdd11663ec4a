//! Conversion of the settings of records to the unit of the damper's setting, for a comparison of the records with the damper.

use dashpot_core::family::Axis;
use dashpot_records::{Record, restate_in_unit};

/// Error of a setting whose unit measures another quantity than the unit of the damper's setting.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "test '{test}' has its {name} in {unit}, the model in {own}: state the one that is right as setting_unit in campaign.toml beside the records, or in the model file"
)]
pub struct SettingUnitError {
    /// Name of the test.
    pub test: String,
    /// Name of the setting.
    pub name: String,
    /// Unit of the record's setting.
    pub unit: String,
    /// Unit of the model's setting.
    pub own: String,
}

/// Returns whether `name` is the setting of an axis. An axis without a name accepts any name.
pub fn is_of_axis(axis: &Axis, name: &str) -> bool {
    axis.name().is_empty() || axis.name() == name
}

/// Converts values of the setting `name` to the unit of the axis, if it is the setting of that axis.
///
/// Returns `false` only if `name` is the setting of the axis and the two units measure different quantities.
pub fn restate<'v>(axis: &Axis, name: &str, unit: &mut String, values: impl IntoIterator<Item = &'v mut f64>) -> bool {
    if !axis.is_some() || !is_of_axis(axis, name) {
        return true;
    }
    restate_in_unit(unit, axis.unit(), values)
}

/// Converts the settings of records to the unit of the damper's setting. Settings with another name stay unchanged.
///
/// # Errors
/// The unit of a setting and the unit of the damper belong to different quantities.
pub fn restate_settings<'r>(
    axis: &Axis,
    records: impl IntoIterator<Item = &'r mut Record>,
) -> Result<(), SettingUnitError> {
    for Record { name: test, setting, setting_signal, .. } in records {
        let refused = |name: &str, unit: &str| SettingUnitError {
            test: test.clone(),
            name: name.to_owned(),
            unit: unit.to_owned(),
            own: axis.unit().to_owned(),
        };
        if let Some(of) = setting
            && !restate(axis, &of.name, &mut of.unit, [&mut of.value])
        {
            return Err(refused(&of.name, &of.unit));
        }
        if let Some(of) = setting_signal
            && !restate(axis, &of.name, &mut of.unit, of.values.iter_mut().chain(&mut of.range))
        {
            return Err(refused(&of.name, &of.unit));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_records::{Setting, SettingSignal};

    #[test]
    fn a_damper_over_milliampere_meets_records_in_ampere() {
        let mut axis = Axis::NONE;
        axis.set_grid(&[0.0, 1600.0]).unwrap();
        axis.set_name("current").unwrap();
        axis.set_unit("mA").unwrap();
        let setting = |unit: &str| Setting { name: "current".into(), unit: unit.into(), value: 0.4 };
        let constant = Record { setting: Some(setting("A")), ..Record::default() };
        let signal = SettingSignal::new("current", "A", &[0.0, 1.2, 1.2]);
        let mut all = [constant, Record { setting_signal: Some(signal), ..Record::default() }];
        restate_settings(&axis, &mut all).unwrap();
        assert!((all[0].setting.as_ref().unwrap().value - 400.0).abs() < 1e-9);
        assert!((all[1].setting_signal.as_ref().unwrap().range[1] - 1200.0).abs() < 1e-9);
        // An ordinary damper, or a setting without a unit, keeps the unit of the record.
        let mut ordinary = [Record { setting: Some(setting("A")), ..Record::default() }];
        restate_settings(&Axis::NONE, &mut ordinary).unwrap();
        assert_eq!(ordinary[0].setting, Some(setting("A")));
        // A second conversion changes nothing. Another quantity has no conversion factor.
        restate_settings(&axis, &mut all).unwrap();
        assert!((all[0].setting.as_ref().unwrap().value - 400.0).abs() < 1e-9);
        let mut wrong = [Record { setting: Some(setting("clicks")), ..Record::default() }];
        assert!(restate_settings(&axis, &mut wrong).unwrap_err().to_string().contains("in clicks, the model in mA"));
    }
}
