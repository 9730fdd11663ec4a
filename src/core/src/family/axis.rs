//! Data of an adjustable damper that the user supplies: the grid of the setting, the parameter values over the grid,
//! the actuator.

use super::actuator::Actuator;
use super::interpolation::{GridPosition, MAX_GRID, limit};
use crate::curve::MAX_POINTS;
use crate::fault::{Fault, NO_PARAMETER, Reason};
use crate::math::max;
use crate::parameter::values::check;
use crate::parameter::{Acts, Element, List, Number, Params, Shape, acts, table};
use crate::{element, list};

/// Largest number of parameters that may depend on the setting, in addition to the forces of the FV table.
pub const MAX_NUMBERS: usize = 32;
/// Largest number of bytes of the setting's name and unit.
pub const MAX_TEXT: usize = 31;
/// Largest magnitude of a setting, in its own unit. Even values in revolutions per minute or pascals are below it.
pub const LARGEST_SETTING: f64 = 1e9;
/// Smallest interval between two grid values, relative to the range of the grid. A grid with closer values is rejected.
const LEAST_INTERVAL: f64 = 1e-6;

/// Description of a numeric entry of the setting that is not a parameter of the damper, such as a time constant of the
/// actuator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Name in model files and in C.
    pub name: &'static str,
    /// Unit; `*` stands for the unit of the setting, `*/s` for that unit per second.
    pub unit: &'static str,
    /// Smallest and largest value.
    pub bounds: (f64, f64),
    /// Meaning in one sentence.
    pub meaning: &'static str,
}

const fn entry(name: &'static str, unit: &'static str, bounds: (f64, f64), meaning: &'static str) -> Entry {
    Entry { name, unit, bounds, meaning }
}

/// Descriptions of the numeric entries of a setting, in the order of the indices of [`Axis::number`].
pub const ENTRIES: [Entry; 8] = [
    entry(
        "setting_start",
        "*",
        (-LARGEST_SETTING, LARGEST_SETTING),
        "initial setting, and setting if the host provides none; default: first value of the grid",
    ),
    entry("setting_time_up", "s", (0.0, 100.0), "time constant of the actuator while the setting rises; 0: none"),
    entry("setting_time_down", "s", (0.0, 100.0), "time constant of the actuator while the setting falls; 0: none"),
    entry("setting_dead_time", "s", (0.0, 10.0), "time between a command and the first movement of the actuator"),
    entry("setting_rate_up", "*/s", (0.0, 1e12), "largest rate of the actuator while the setting rises; 0: no limit"),
    entry("setting_rate_down", "*/s", (0.0, 1e12), "largest rate of the actuator while the setting falls; 0: no limit"),
    entry(
        "setting_hysteresis",
        "*",
        (0.0, LARGEST_SETTING),
        "half width of the hysteresis: lag of the valve behind a setting that has risen or fallen over a long range",
    ),
    entry(
        "setting_hysteresis_rest",
        "-",
        (-1.0, 1.0),
        "state of the hysteresis at which the numbers of the grid apply: 1 if settings were reached from below, -1 from above",
    ),
];

/// A parameter of the damper that depends on the setting, with its values over the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Varying {
    /// Index of the parameter in the parameter table.
    pub row: u64,
    /// Value of the parameter at each grid value; unused entries are 0.
    pub values: [f64; MAX_GRID],
}

/// The setting on which a damper depends. Without a grid, the damper depends on no setting.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Axis {
    count: u64,
    grid: [f64; MAX_GRID],
    /// Values of the [`ENTRIES`]; the first, the start setting, is NaN if it is not given.
    entries: [f64; ENTRIES.len()],
    varying: u64,
    numbers: [Varying; MAX_NUMBERS],
    /// Number of points of the FV table if its forces depend on the setting; otherwise 0.
    points: u64,
    /// Bit set of the grid values at which forces of the FV table are given.
    given: u64,
    forces: [[f64; MAX_POINTS]; MAX_GRID],
    name: [u8; MAX_TEXT + 1],
    unit: [u8; MAX_TEXT + 1],
}

/// A damper as defined by a model file: an ordinary damper, or an adjustable damper, which depends on a setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Definition {
    /// Parameters of the damper. If it depends on a setting, these are the parameters at the start setting.
    pub params: Params,
    /// Setting of the damper. Without a setting, the axis has no grid.
    pub axis: Axis,
}

impl From<Params> for Definition {
    fn from(params: Params) -> Definition {
        Definition { params, axis: Axis::NONE }
    }
}

impl Definition {
    /// Returns the ordinary damper at a setting, or the damper unchanged if it depends on no setting.
    pub fn params_at(&self, setting: f64) -> Params {
        self.axis.params_at(&self.params, setting)
    }
}

const NO_NUMBER: Varying = Varying { row: 0, values: [0.0; MAX_GRID] };

impl Default for Axis {
    fn default() -> Axis {
        Axis::NONE
    }
}

/// Makes a fault of the setting as a whole, which names no parameter.
fn of_the_axis(reason: Reason) -> Fault {
    Fault { parameter: NO_PARAMETER, reason }
}

/// Returns the bytes of a text up to its first zero byte.
fn text(bytes: &[u8]) -> &[u8] {
    let end = bytes.iter().position(|byte| *byte == 0).unwrap_or(bytes.len());
    bytes.get(..end).unwrap_or(&[])
}

impl Axis {
    const NO_ENTRIES: [f64; ENTRIES.len()] = [f64::NAN, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];

    /// The axis without a setting.
    pub const NONE: Axis = Axis {
        count: 0,
        grid: [0.0; MAX_GRID],
        entries: Axis::NO_ENTRIES,
        varying: 0,
        numbers: [NO_NUMBER; MAX_NUMBERS],
        points: 0,
        given: 0,
        forces: [[0.0; MAX_POINTS]; MAX_GRID],
        name: [0; MAX_TEXT + 1],
        unit: [0; MAX_TEXT + 1],
    };

    /// Removes the setting, with its grid, its values, its actuator, its name and its unit.
    pub fn clear(&mut self) {
        (self.count, self.varying, self.points, self.given) = (0, 0, 0, 0);
        self.grid = [0.0; MAX_GRID];
        self.entries = Axis::NO_ENTRIES;
        (self.name, self.unit) = ([0; MAX_TEXT + 1], [0; MAX_TEXT + 1]);
    }

    /// Returns whether the damper depends on a setting.
    pub fn is_some(&self) -> bool {
        self.count > 0
    }

    /// Returns the grid of the setting, ascending; empty without a setting.
    pub fn grid(&self) -> &[f64] {
        self.grid.get(..self.count as usize).unwrap_or(&[])
    }

    /// Returns the first and the last value of the grid; zeros without a setting.
    pub fn range(&self) -> (f64, f64) {
        let grid = self.grid();
        (grid.first().copied().unwrap_or(0.0), grid.last().copied().unwrap_or(0.0))
    }

    /// Sets the grid. All values over the previous grid are removed; name, unit and actuator stay.
    ///
    /// # Errors
    /// Returns [`Reason::SettingGrid`] for fewer than two or more than eight numbers, or numbers that do not increase.
    /// Numbers beyond ±1e9, and intervals below 1e-6 of the range, are errors too.
    pub fn set_grid(&mut self, grid: &[f64]) -> Result<(), Fault> {
        check_grid(grid).map_err(of_the_axis)?;
        for (to, from) in self.grid.iter_mut().zip(grid) {
            *to = *from;
        }
        (self.count, self.varying, self.points, self.given) = (grid.len() as u64, 0, 0, 0);
        Ok(())
    }

    /// Returns the name of the setting, such as current; empty if none is given.
    // Inline, so that the library does not contain this function: see `name_bytes`.
    #[inline]
    pub fn name(&self) -> &str {
        core::str::from_utf8(self.name_bytes()).unwrap_or("")
    }

    /// Returns the name of the setting in bytes. [`Axis::name`] is not in the library, because the UTF-8 check of the
    /// standard library can panic.
    pub fn name_bytes(&self) -> &[u8] {
        text(&self.name)
    }

    /// Returns the unit of the setting, such as A; empty if none is given.
    // Inline, so that the library does not contain this function: see `name_bytes`.
    #[inline]
    pub fn unit(&self) -> &str {
        core::str::from_utf8(self.unit_bytes()).unwrap_or("")
    }

    /// Returns the unit of the setting in bytes.
    pub fn unit_bytes(&self) -> &[u8] {
        text(&self.unit)
    }

    /// Sets the name of the setting, of at most [`MAX_TEXT`] bytes.
    ///
    /// # Errors
    /// Returns [`Reason::PointCount`] for a longer text.
    pub fn set_name(&mut self, name: &str) -> Result<(), Fault> {
        self.set_name_bytes(name.as_bytes())
    }

    pub(crate) fn set_name_bytes(&mut self, name: &[u8]) -> Result<(), Fault> {
        keep(&mut self.name, name)
    }

    /// Sets the unit of the setting, of at most [`MAX_TEXT`] bytes.
    ///
    /// # Errors
    /// Returns [`Reason::PointCount`] for a longer text.
    pub fn set_unit(&mut self, unit: &str) -> Result<(), Fault> {
        self.set_unit_bytes(unit.as_bytes())
    }

    pub(crate) fn set_unit_bytes(&mut self, unit: &[u8]) -> Result<(), Fault> {
        keep(&mut self.unit, unit)
    }

    /// Returns the value of entry `index` of [`ENTRIES`], or 0 if there is no such entry.
    pub fn number(&self, index: usize) -> f64 {
        match index {
            0 => self.start(),
            _ => self.entries.get(index).copied().unwrap_or(0.0),
        }
    }

    /// Sets the value of entry `index` of [`ENTRIES`].
    ///
    /// # Errors
    /// Returns an error for an unknown index, and for a number that is not finite or out of bounds.
    pub fn set_number(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        check_entry(index, value)?;
        if let Some(slot) = self.entries.get_mut(index) {
            *slot = value;
        }
        Ok(())
    }

    /// Returns the setting that applies if the host gives none: the given start setting, or else the first of the grid.
    pub fn start(&self) -> f64 {
        let (first, _) = self.range();
        self.entries.first().copied().filter(|start| !start.is_nan()).unwrap_or(first)
    }

    /// Returns the actuator of the setting.
    pub fn actuator(&self) -> Actuator {
        let [_, up, down, dead_time, rising, falling, hysteresis, rest] = self.entries;
        Actuator { time: [up, down], rate: [rising, falling], dead_time, hysteresis, rest }
    }

    /// Returns the parameters that depend on the setting.
    pub fn numbers(&self) -> &[Varying] {
        self.numbers.get(..self.varying as usize).unwrap_or(&[])
    }

    /// Returns the values of a parameter over the grid; `None` if it does not depend on the setting.
    pub fn values(&self, number: Number) -> Option<&[f64]> {
        let found = self.numbers().iter().find(|varying| varying.row == number.row().index as u64)?;
        found.values.get(..self.count as usize)
    }

    /// Sets the values of a parameter over the grid.
    ///
    /// # Errors
    /// Returns an error for a parameter that cannot depend on the setting, and for a wrong number of values. Values
    /// that the parameter table rejects, and more than [`MAX_NUMBERS`] parameters, are errors too.
    pub fn set_values(&mut self, number: Number, values: &[f64]) -> Result<(), Fault> {
        let row = number.row();
        check_values(number, values, self.count as usize)?;
        let index = row.index as u64;
        let place = self.numbers().iter().position(|varying| varying.row == index).unwrap_or(self.varying as usize);
        let Some(slot) = self.numbers.get_mut(place) else { return Err(row.fault(Reason::SettingTooMany)) };
        let mut kept = [0.0; MAX_GRID];
        for (to, from) in kept.iter_mut().zip(values) {
            *to = *from;
        }
        *slot = Varying { row: index, values: kept };
        self.varying = self.varying.max(place as u64 + 1);
        Ok(())
    }

    /// Makes a parameter independent of the setting: removes its values over the grid.
    pub fn forget_values(&mut self, number: Number) {
        let index = number.row().index as u64;
        let Some(place) = self.numbers().iter().position(|varying| varying.row == index) else { return };
        for place in place..self.numbers().len() {
            let next = self.numbers.get(place + 1).copied().unwrap_or(NO_NUMBER);
            if let Some(slot) = self.numbers.get_mut(place) {
                *slot = next;
            }
        }
        self.varying = self.varying.saturating_sub(1);
    }

    /// Makes the forces of the FV table independent of the setting.
    pub fn forget_forces(&mut self) {
        (self.points, self.given) = (0, 0);
    }

    /// Sets the values of a list at grid value `index`. The only list that may depend on the setting is the forces of
    /// the FV table.
    ///
    /// # Errors
    /// Returns an error for another list, and the errors of [`Axis::set_forces`].
    pub fn set_list(&mut self, list: List, index: usize, values: &[f64]) -> Result<(), Fault> {
        if can_vary(list) { self.set_forces(index, values) } else { Err(list.fault(Reason::SettingFixed)) }
    }

    /// Returns whether the forces of the FV table depend on the setting.
    pub fn has_forces(&self) -> bool {
        self.points > 0
    }

    /// Returns the forces of the FV table at grid value `index`; `None` if they do not depend on the setting.
    pub fn forces(&self, index: usize) -> Option<&[f64]> {
        if index >= self.count as usize || !self.has_forces() {
            return None;
        }
        self.forces.get(index)?.get(..self.points as usize)
    }

    /// Sets the forces of the FV table at grid value `index`. All grid values need the same number of forces.
    ///
    /// # Errors
    /// Returns an error for an index beyond the grid, for a different number of forces than at other grid values, and
    /// for an invalid force.
    pub fn set_forces(&mut self, index: usize, forces: &[f64]) -> Result<(), Fault> {
        let row = *list!("fv_force").row();
        if index >= self.count as usize {
            return Err(row.fault(Reason::SettingCount));
        }
        if forces.is_empty() || forces.len() > MAX_POINTS {
            return Err(row.fault(Reason::PointCount));
        }
        if self.points > 0 && self.points != forces.len() as u64 {
            return Err(row.fault(Reason::CurveLengths));
        }
        check(&row, forces)?;
        if let Some(to) = self.forces.get_mut(index) {
            for (to, from) in to.iter_mut().zip(forces) {
                *to = *from;
            }
        }
        self.points = forces.len() as u64;
        self.given |= 1 << index;
        Ok(())
    }

    /// Returns the forces of all points of the FV table at grid value `index`, and their derivatives with respect to
    /// the setting.
    ///
    /// The derivatives are limited, so that the forces do not decrease with velocity at any setting between the grid
    /// values.
    pub(crate) fn forces_with_derivatives(&self, index: usize) -> ([f64; MAX_POINTS], [f64; MAX_POINTS]) {
        let (grid, points) = (self.grid(), self.points as usize);
        let forces = self.forces.get(index).copied().unwrap_or([0.0; MAX_POINTS]);
        let mut derivatives = [0.0; MAX_POINTS];
        for (point, derivative) in derivatives.iter_mut().enumerate().take(points) {
            let mut over = [0.0; MAX_GRID];
            for (to, forces) in over.iter_mut().zip(&self.forces) {
                *to = forces.get(point).copied().unwrap_or(0.0);
            }
            let of_point = super::interpolation::derivatives(grid, over.get(..grid.len()).unwrap_or(&[]));
            *derivative = of_point.get(index).copied().unwrap_or(0.0);
        }
        let at = |place: usize| grid.get(place).copied();
        let length = |from: Option<f64>, to: Option<f64>| match (from, to) {
            (Some(from), Some(to)) => to - from,
            _ => f64::INFINITY,
        };
        let before = length(index.checked_sub(1).and_then(at), at(index));
        let after = length(at(index), at(index + 1));
        let force = |point: usize| forces.get(point).copied().unwrap_or(0.0);
        if let Some(derivatives) = derivatives.get_mut(..points) {
            limit(derivatives, |point| force(point + 1) - force(point), before, after);
        }
        (forces, derivatives)
    }

    /// Returns the ordinary damper at a setting: `params` with interpolated numbers and forces. The setting is clamped
    /// to the grid.
    pub fn params_at(&self, params: &Params, setting: f64) -> Params {
        let mut at = *params;
        self.put(&mut at, setting);
        at
    }

    /// Writes the values interpolated at a setting into a parameter set that already contains the constant values.
    pub fn put(&self, params: &mut Params, setting: f64) {
        let grid = self.grid();
        if grid.len() < 2 {
            return;
        }
        let place = GridPosition::new(&self.grid, grid.len(), setting);
        for varying in self.numbers() {
            let Some(row) = table().nth(varying.row as usize) else { continue };
            let Ok(number) = Number::try_from(row) else { continue };
            let derivatives = super::interpolation::derivatives(grid, varying.values.get(..grid.len()).unwrap_or(&[]));
            // The value lies between two valid values, so `set` cannot fail.
            let _ = params.set(number, number.inside(place.value(&varying.values, &derivatives)));
        }
        if self.has_forces() {
            let (from, from_derivatives) = self.forces_with_derivatives(place.interval);
            let (to, to_derivatives) = self.forces_with_derivatives(place.interval + 1);
            let [w0, w1, w2, w3] = place.weights;
            let mut forces = [0.0; MAX_POINTS];
            let ends = from.iter().zip(&to).zip(from_derivatives.iter().zip(&to_derivatives));
            // The interpolated forces do not decrease with velocity, except by rounding errors, which the maximum
            // removes.
            let mut last = f64::NEG_INFINITY;
            for (force, ((f0, f1), (d0, d1))) in forces.iter_mut().zip(ends) {
                *force = max((w0 * f0 + w1 * f1) + (w2 * d0 + w3 * d1), last);
                last = *force;
            }
            let _ = params.set_list(list!("fv_force"), forces.get(..self.points as usize).unwrap_or(&[]));
        }
    }

    /// Checks the whole axis. Values over a setting need a grid, and the start setting must lie inside the grid. The
    /// hysteresis must be at most a quarter of the range of the grid. Given forces must cover all grid values and must
    /// not decrease with velocity.
    ///
    /// # Errors
    /// Returns the error and the parameter at fault.
    pub fn check(&self) -> Result<(), Fault> {
        if !self.is_some() {
            return if self.varying > 0 || self.has_forces() { Err(of_the_axis(Reason::SettingGrid)) } else { Ok(()) };
        }
        if !(2..=MAX_GRID).contains(&(self.count as usize))
            || self.varying as usize > MAX_NUMBERS
            || self.points as usize > MAX_POINTS
        {
            return Err(of_the_axis(Reason::SettingGrid));
        }
        check_grid(self.grid()).map_err(of_the_axis)?;
        let (low, high) = self.range();
        let start = self.start();
        let leaves_a_way = 4.0 * self.actuator().hysteresis <= high - low;
        if !(start >= low && start <= high && leaves_a_way) {
            return Err(of_the_axis(Reason::OutOfBounds));
        }
        if self.has_forces() && self.given != (1 << self.count) - 1 {
            return Err(list!("fv_force").fault(Reason::SettingCount));
        }
        for forces in (0..self.grid().len()).filter_map(|index| self.forces(index)) {
            if forces.iter().zip(forces.iter().skip(1)).any(|(force, next)| next < force) {
                return Err(list!("fv_force").fault(Reason::ForceDecreases));
            }
        }
        for varying in self.numbers() {
            let row = table().nth(varying.row as usize).ok_or(of_the_axis(Reason::UnknownName))?;
            check_values(
                Number::try_from(row)?,
                varying.values.get(..self.count as usize).unwrap_or(&[]),
                self.count as usize,
            )?;
        }
        Ok(())
    }

    /// Makes the definition of a family from one parameter set per grid value. Returns the first set, and an axis with
    /// the values that differ between the sets.
    ///
    /// # Errors
    /// Returns an error for sets that differ in a value that cannot depend on the setting. An invalid grid, and a
    /// number of sets other than that of the grid values, are errors too.
    pub fn through(grid: &[f64], sets: &[Params]) -> Result<(Params, Axis), Fault> {
        let mut axis = Axis::NONE;
        axis.set_grid(grid)?;
        let Some(first) = sets.first().filter(|_| sets.len() == grid.len()) else {
            return Err(of_the_axis(Reason::SettingCount));
        };
        for element in Element::all() {
            if sets.iter().any(|set| set.is_on(element) != first.is_on(element)) {
                let row = table().find(|row| row.group == element.place());
                return Err(row.map_or(of_the_axis(Reason::SettingFixed), |row| row.fault(Reason::SettingFixed)));
            }
        }
        for row in table() {
            if sets.iter().all(|set| set.get(&row) == first.get(&row)) {
                continue;
            }
            if let Ok(number) = Number::try_from(row) {
                let mut values = [0.0; MAX_GRID];
                for (value, set) in values.iter_mut().zip(sets) {
                    *value = set.number(number);
                }
                axis.set_values(number, values.get(..sets.len()).unwrap_or(&[]))?;
            } else if row == *list!("fv_force").row() {
                for (index, set) in sets.iter().enumerate() {
                    axis.set_forces(index, set.list(list!("fv_force")))?;
                }
            } else {
                return Err(row.fault(Reason::SettingFixed));
            }
        }
        Ok((*first, axis))
    }

    /// Returns the parameters that depend on the setting and do not only affect dissipation: they affect stored energy
    /// or the force at rest.
    ///
    /// A change of the setting may do work on the host through these parameters. If the result is empty, the damper is
    /// passive for any change of the setting, with two exceptions. An FV curve with a force at zero velocity that depends
    /// on the setting does work at low velocities. The filter form of frequency-selective damping stores the FV force.
    ///
    /// Energy is stored in springs, oil columns and masses, in the force or the temperature of the gas, and in the
    /// deflection of a contact. A parameter that only affects dissipation may change at any time: at every instant the
    /// power is that of a damper at a constant setting.
    pub fn stores_energy(&self) -> impl Iterator<Item = Number> {
        self.numbers().iter().filter_map(|varying| {
            let row = table().nth(varying.row as usize)?;
            let element = row.element()?;
            let is_friction = acts(row.group) == Acts::Friction;
            let dissipates = is_friction || DISSIPATES.contains(&element) || row.parameter.name == "series_damping";
            (!dissipates).then(|| Number::try_from(row).ok()).flatten()
        })
    }
}

/// Elements other than friction whose parameters only affect dissipation.
const DISSIPATES: [Element; 5] = [
    element!("fv_curve"),
    element!("position_dependent_damping"),
    element!("temperature_fade"),
    element!("frequency_selective_damping"),
    element!("valve_hysteresis"),
];

/// Checks a value for entry `index` of [`ENTRIES`].
pub(crate) fn check_entry(index: usize, value: f64) -> Result<(), Fault> {
    let entry = ENTRIES.get(index).ok_or(of_the_axis(Reason::UnknownName))?;
    if !value.is_finite() {
        return Err(of_the_axis(Reason::NotFinite));
    }
    if value < entry.bounds.0 || value > entry.bounds.1 {
        return Err(of_the_axis(Reason::OutOfBounds));
    }
    Ok(())
}

/// Checks the length of the setting's name or unit.
pub(crate) fn check_text(text: &[u8]) -> Result<(), Fault> {
    if text.len() > MAX_TEXT { Err(of_the_axis(Reason::PointCount)) } else { Ok(()) }
}

fn keep(slot: &mut [u8; MAX_TEXT + 1], text: &[u8]) -> Result<(), Fault> {
    check_text(text)?;
    *slot = [0; MAX_TEXT + 1];
    for (to, from) in slot.iter_mut().zip(text.iter().copied()) {
        *to = from;
    }
    Ok(())
}

pub(crate) fn check_grid(grid: &[f64]) -> Result<(), Reason> {
    let (Some(first), Some(last)) = (grid.first(), grid.last()) else { return Err(Reason::SettingGrid) };
    let known = grid.iter().all(|value| value.abs() <= LARGEST_SETTING);
    let least = LEAST_INTERVAL * (last - first);
    let apart = grid.iter().zip(grid.iter().skip(1)).all(|(a, b)| b - a > 0.0 && b - a >= least);
    if known && apart && (2..=MAX_GRID).contains(&grid.len()) { Ok(()) } else { Err(Reason::SettingGrid) }
}

pub(crate) fn check_values(number: Number, values: &[f64], count: usize) -> Result<(), Fault> {
    let row = number.row();
    if !matches!(row.parameter.shape, Shape::Scalar) || row.element().is_none() {
        return Err(row.fault(Reason::SettingFixed));
    }
    if values.len() != count || count == 0 {
        return Err(row.fault(Reason::SettingCount));
    }
    for value in values {
        if !value.is_finite() {
            return Err(row.fault(Reason::NotFinite));
        }
        let (low, high) = number.bounds();
        if *value < low || *value > high {
            return Err(row.fault(Reason::OutOfBounds));
        }
    }
    Ok(())
}

/// Returns whether a list may depend on the setting.
pub fn can_vary(list: List) -> bool {
    list == list!("fv_force")
}

/// Returns the index of the entry of [`ENTRIES`] with this name, or `None`.
pub fn index_of(name: &[u8]) -> Option<usize> {
    ENTRIES.iter().position(|entry| entry.name.as_bytes() == name)
}
