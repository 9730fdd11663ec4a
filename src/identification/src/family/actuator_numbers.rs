//! Numbers of the actuator in a model file, with their intervals.

use crate::model_file::{Identification, Interval};
use dashpot_core::family::axis::{Axis, ENTRIES};

/// Number of an actuator, such as a time constant.
#[derive(Debug, Clone, PartialEq)]
pub struct ActuatorNumber {
    /// Name in the model file.
    pub name: &'static str,
    /// Value, in `unit`.
    pub value: f64,
    /// Unit of the value and of the interval.
    pub unit: String,
    /// 95 % interval, or `None` if the file has none or its two ends are equal.
    pub interval: Option<[f64; 2]>,
}

/// Returns the nonzero numbers of the actuator of an axis.
pub fn actuator_numbers(axis: &Axis, known: &Identification) -> Vec<ActuatorNumber> {
    // The first entry is the start value of the setting, which is not a number of the actuator.
    let entries = ENTRIES.iter().enumerate().skip(1).filter(|(index, _)| axis.number(*index) != 0.0);
    entries
        .map(|(index, entry)| ActuatorNumber {
            name: entry.name,
            value: axis.number(index),
            unit: entry.unit.replace('*', axis.unit()),
            interval: match known.intervals.get(entry.name) {
                Some(Interval::Number([low, high])) if low < high => Some([*low, *high]),
                _ => None,
            },
        })
        .collect()
}
