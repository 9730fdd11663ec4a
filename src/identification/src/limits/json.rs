//! Serialization of a checked limit to JSON. The key of a figure ends in its unit: `_n` for forces, `_s` for times.

use super::table::Limit;
use super::{Checked, Value};
use serde::ser::SerializeMap as _;
use serde::{Serialize, Serializer};

/// Figure with the JSON key that its quantity and unit determine.
struct Figure<'a> {
    key: &'static str,
    of: &'a Value,
}

impl Serialize for Figure<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_map(None)?;
        map.serialize_entry(self.key, &self.of.value)?;
        if let Some(uncertainty) = self.of.uncertainty {
            map.serialize_entry("uncertainty_s", &uncertainty)?;
        }
        if let Some(damping) = self.of.damping {
            map.serialize_entry("damping_n", &damping)?;
        }
        if let Some(step) = self.of.step {
            map.serialize_entry("step", &step)?;
        }
        map.serialize_entry("tests", &self.of.tests)?;
        map.end()
    }
}

impl Serialize for Checked {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let Limit { name, quantity, velocity_m_s, amplitude_m, low, high, setting, setting_unit, line } = &self.limit;
        let [low_key, high_key, key] = quantity.keys();
        let figure = |of| Figure { key, of };
        let mut map = to.serialize_map(None)?;
        map.serialize_entry("name", name)?;
        map.serialize_entry("quantity", quantity)?;
        map.serialize_entry("velocity_m_s", velocity_m_s)?;
        map.serialize_entry("amplitude_m", amplitude_m)?;
        map.serialize_entry(low_key, low)?;
        map.serialize_entry(high_key, high)?;
        if let Some(setting) = setting {
            map.serialize_entry("setting", setting)?;
            if !setting_unit.is_empty() {
                map.serialize_entry("setting_unit", setting_unit)?;
            }
        }
        map.serialize_entry("line", line)?;
        map.serialize_entry("measured", &self.measured.as_ref().map(figure))?;
        map.serialize_entry("model", &self.model.as_ref().map(figure))?;
        map.serialize_entry("verdict", &self.verdict)?;
        map.serialize_entry("model_verdict", &self.model_verdict)?;
        map.end()
    }
}
