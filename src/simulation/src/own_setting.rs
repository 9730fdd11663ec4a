//! Setting that a record states, for the simulation of an adjustable damper.

use dashpot_core::family::Axis;
use dashpot_identification::setting_units::is_of_axis;
use dashpot_records::{Record, setting_factor};

/// Setting that a record states.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OwnSetting {
    /// The record does not state the setting of the axis, or states it in another unit.
    Unstated,
    /// The setting is constant.
    Constant(f64),
    /// The setting changes within the record.
    Changing,
}

impl OwnSetting {
    /// Finds the setting of a record. A setting whose name or unit differs from the axis is ignored.
    pub fn find(axis: &Axis, record: &Record) -> OwnSetting {
        let is_own = |name: &str, unit: &str| is_of_axis(axis, name) && setting_factor(unit, axis.unit()) == Some(1.0);
        if record.setting_signal.as_ref().is_some_and(|signal| is_own(&signal.name, &signal.unit)) {
            return OwnSetting::Changing;
        }
        let own = record.setting.as_ref().filter(|setting| is_own(&setting.name, &setting.unit));
        own.map_or(OwnSetting::Unstated, |setting| OwnSetting::Constant(setting.value))
    }
}
