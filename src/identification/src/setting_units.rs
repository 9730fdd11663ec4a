//! Settings of records in the unit of the damper that they are compared with.

use dashpot_core::family::Axis;
use dashpot_records::{Record, setting_factor};

/// Settings that cannot be compared.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "test '{test}' has its {name} in {unit}, the model in {own}: state the one that is right as setting_unit in campaign.toml beside the records, or in the model file"
)]
pub struct SettingUnitError {
    /// Name of the test.
    pub test: String,
    /// Name of the setting.
    pub name: String,
    /// Unit of the record.
    pub unit: String,
    /// Unit of the model.
    pub own: String,
}

/// Restates the settings of records in the unit of the damper's setting, where they are the same quantity.
///
/// # Errors
/// A unit that is not of one kind with the damper's.
pub fn restate_settings<'r>(
    axis: &Axis,
    records: impl IntoIterator<Item = &'r mut Record>,
) -> Result<(), SettingUnitError> {
    let own = axis.unit();
    let is_own = |name: &str| axis.name().is_empty() || axis.name() == name;
    for record in records {
        let test = &record.name;
        let of = |name: &str, unit: &str| {
            let (test, name, unit, own) = (test.clone(), name.to_owned(), unit.to_owned(), own.to_owned());
            setting_factor(&unit, &own).ok_or(SettingUnitError { test, name, unit, own })
        };
        if let Some(setting) = record.setting.as_mut().filter(|setting| is_own(&setting.name)) {
            setting.value *= of(&setting.name, &setting.unit)?;
            own.clone_into(&mut setting.unit);
        }
        if let Some(signal) = record.setting_signal.as_mut().filter(|signal| is_own(&signal.name)) {
            let factor = of(&signal.name, &signal.unit)?;
            signal.values.iter_mut().chain(&mut signal.range).for_each(|value| *value *= factor);
            own.clone_into(&mut signal.unit);
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
        // Once more changes nothing, and another quantity has no factor.
        restate_settings(&axis, &mut all).unwrap();
        assert!((all[0].setting.as_ref().unwrap().value - 400.0).abs() < 1e-9);
        let mut wrong = [Record { setting: Some(setting("clicks")), ..Record::default() }];
        assert!(restate_settings(&axis, &mut wrong).unwrap_err().to_string().contains("in clicks, the model in mA"));
    }
}
