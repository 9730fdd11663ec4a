//! Detection of numbers of a model file that were changed since the fit. A changed number is detected if it is outside its interval from
//! the fit.

use crate::fit_tables::{Identification, Interval, IntervalOverSetting};
use dashpot_core::Params;
use dashpot_core::family::Axis;
use dashpot_core::family::axis::ENTRIES;
use dashpot_core::parameter::{self, Number, Row};

/// Interval, with NaN ends, that replaces the interval of a point that was changed since the fit.
const NONE: [f64; 2] = [f64::NAN; 2];

/// Removes the intervals and sources of numbers that were changed since the fit. Returns the names of these numbers in the format of the
/// entry `not_identified` of a model file.
///
/// `known` contains the results of the fit. A curve keeps the intervals of its unchanged points. A change of a number without an interval
/// cannot be detected.
pub(crate) fn take_out(params: &Params, axis: &Axis, known: &mut Identification) -> Vec<String> {
    let mut edited = Vec::new();
    for row in parameter::table().filter(|row| row.element().is_none_or(|element| params.is_on(element))) {
        edited.extend(of_row(&row, params, axis, known));
    }
    for (index, entry) in ENTRIES.iter().enumerate() {
        if let Some(Interval::Number(ends)) = known.intervals.get(entry.name)
            && axis.is_some()
            && !holds(ends, axis.number(index))
        {
            known.intervals.remove(entry.name);
            edited.push(entry.name.to_owned());
        }
    }
    edited
}

fn of_row(row: &Row, params: &Params, axis: &Axis, known: &mut Identification) -> Vec<String> {
    let name = row.parameter.name;
    let mut edited = Vec::new();
    let values = params.get(row);
    let is_over_setting = known.intervals_over_setting.contains_key(name);
    match known.intervals.get_mut(name) {
        Some(Interval::Number(ends)) if !values.iter().all(|value| holds(ends, *value)) => {
            known.intervals.remove(name);
            edited.push(name.to_owned());
        }
        Some(Interval::List(all)) if all.len() == values.len() => {
            edited.extend(blank(all, values).into_iter().map(|at| format!("{name}[{at}]")));
        }
        // The list has another number of points than its intervals, so no interval of the fit is valid.
        Some(Interval::List(_)) => {
            known.intervals.remove(name);
            edited.push(name.to_owned());
        }
        _ => {}
    }
    let grid = axis.grid();
    let number = Number::try_from(*row).ok();
    let is_whole = match known.intervals_over_setting.get_mut(name) {
        Some(IntervalOverSetting::Number(all)) => match number.and_then(|number| axis.values(number)) {
            Some(values) if values.len() == all.len() => {
                edited.extend(blank(all, values).into_iter().map(|at| format!("{name}@{}", grid[at])));
                true
            }
            _ => false,
        },
        Some(IntervalOverSetting::List(all)) if all.len() == grid.len() => {
            all.iter_mut().enumerate().all(|(place, all)| match axis.forces(place) {
                Some(forces) if forces.len() == all.len() => {
                    edited.extend(blank(all, forces).into_iter().map(|at| format!("{name}[{at}]@{}", grid[place])));
                    true
                }
                _ => false,
            })
        }
        _ => false,
    };
    // The grid of settings or the number of points of a curve was changed, so no interval over the setting is valid.
    if is_over_setting && !is_whole {
        known.intervals_over_setting.remove(name);
        edited = vec![name.to_owned()];
    }
    if !edited.is_empty() {
        known.sources.remove(name);
    }
    edited
}

/// Replaces each interval that does not contain its value by NaN ends. Returns the indices of these intervals.
fn blank(all: &mut [[f64; 2]], values: &[f64]) -> Vec<usize> {
    let mut places = Vec::new();
    for (at, (ends, value)) in all.iter_mut().zip(values).enumerate() {
        if !holds(ends, *value) {
            *ends = NONE;
            places.push(at);
        }
    }
    places
}

/// Returns whether an interval contains a value. An interval with a NaN end contains every value. The interval of a fixed point of a curve
/// has two equal ends, so a tolerance of 1e-9 of the value covers rounding.
fn holds(ends: &[f64; 2], value: f64) -> bool {
    let room = 1e-9 * value.abs();
    ends.iter().any(|end| end.is_nan()) || (ends[0] - room..=ends[1] + room).contains(&value)
}
