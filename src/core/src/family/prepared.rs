//! A prepared family: a damper whose parameters depend on a setting.

use super::actuator::{Actuator, Stand};
use super::axis::{Axis, MAX_NUMBERS};
use super::delay::Delay;
use super::interpolation::{GridPosition, MAX_GRID, derivatives};
use super::lending::Numbers;
use super::section::{Lent, Points, ROOM, Section};
use crate::assembly::Renewed;
use crate::curve::Interpolation;
use crate::evaluate::{evaluate_of, partials_of};
use crate::fault::{Fault, NO_PARAMETER, Reason};
use crate::input::Input;
use crate::integration::Integration;
use crate::layout::{LAG, bits, with_actuator};
use crate::math::{max, min};
use crate::model::Model;
use crate::parameter::{Element, Params, Row, table};
use crate::state::{MAX_INTERNAL, Output, State};
use crate::step::step_borrowed;
use crate::{Partials, element, list, number};

/// Step of the central differences with respect to the setting, as a fraction of the grid's range.
///
/// The forces have a relative accuracy of 1e-13, so a step of 1e-6 gives derivatives with seven valid digits.
const NEAR: f64 = 1e-6;
/// Host step, s, at which the costs of the integration methods at the grid values are compared: see
/// [`crate::integration`].
const COMPARED_AT: f64 = 1e-3;

/// Elements in which a parameter with value 0 switches off a part of the element and its state.
const SWITCHED_BY_NUMBERS: [Element; 2] = [element!("bushing"), element!("oil_compressibility")];

/// Number of points of an FV curve below which a [`Section`] reads at most this many entries of its arrays.
const FEW_POINTS: usize = 16;

/// A parameter that depends on the setting, and its interpolation over the grid.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
struct Interpolated {
    group: u64,
    slot: u64,
    low: f64,
    high: f64,
    values: [f64; MAX_GRID],
    derivatives: [f64; MAX_GRID],
}

impl Interpolated {
    const NONE: Interpolated =
        Interpolated { group: 0, slot: 0, low: 0.0, high: 0.0, values: [0.0; MAX_GRID], derivatives: [0.0; MAX_GRID] };
}

/// Dependence of the FV curve on the setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u64)]
enum Fv {
    /// The curve does not depend on the setting, or there is no curve.
    Same,
    /// The forces of the curve's table depend on the setting.
    Forces,
    /// The derivatives and knees of the piecewise-linear curve depend on the setting.
    Knees,
}

/// A prepared family. It is constant during a run and serves any number of dampers, each at its own setting.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Family {
    /// The damper at the start setting.
    model: Model,
    /// Parameters of the damper at the start setting.
    params: Params,
    count: u64,
    grid: [f64; MAX_GRID],
    start: f64,
    actuator: Actuator,
    /// Bit set of the elements that depend on the setting.
    varying: u64,
    /// Parameters that depend on the setting, in the order of the parameter table.
    numbers: [Interpolated; MAX_NUMBERS],
    used: u64,
    /// Whether a moving mass inside the damper must be added to the internal mass at each setting.
    has_mass_inside: bool,
    fv: Fv,
    /// Points of the FV curve at the start setting, and the interpolation between them.
    points: Points,
    point_count: u64,
    interpolation: Interpolation,
    /// Forces of the FV curve's points at each grid value, N, and their derivatives with respect to the setting.
    forces: [[f64; ROOM]; MAX_GRID],
    derivatives: [[f64; ROOM]; MAX_GRID],
    layout: f64,
    /// Index of the actuator's first state, the lagged setting, among the internal states.
    lagged_at: u64,
}

/// Derivatives of force and state derivatives (rates) with respect to the commanded setting, at constant states.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct BySetting {
    /// Derivative of the force with respect to the commanded setting, N per unit of the setting. It is 0 if the
    /// actuator has a lag, because the force then depends on the actuator's states instead.
    pub force: f64,
    /// Derivatives of the rates of the states with respect to the commanded setting.
    pub rate: [f64; 10],
}

impl BySetting {
    /// All zero.
    pub const ZERO: BySetting = BySetting { force: 0.0, rate: [0.0; 10] };
}

/// The parameters of a family at one setting.
struct At<'a> {
    family: &'a Family,
    place: GridPosition,
}

impl Numbers for At<'_> {
    #[inline(always)]
    fn vary(&self, group: usize) -> bool {
        self.family.varying & (1 << group) != 0
    }

    #[inline(always)]
    fn put(&self, group: usize, first_slot: usize, slots: &mut [f64]) {
        for number in self.family.numbers.iter().take(self.family.used as usize) {
            if number.group == group as u64
                && let Some(slot) = slots.get_mut((number.slot as usize).wrapping_sub(first_slot))
            {
                let value = self.place.value(&number.values, &number.derivatives);
                // The parameter's values at both neighboring grid values lie within its bounds, so only rounding can
                // move the value beyond them.
                *slot = min(number.high, max(number.low, value));
            }
        }
        if self.family.has_mass_inside {
            self.put_mass_inside(group, first_slot, slots);
        }
    }

    #[inline(always)]
    fn params(&self) -> &Params {
        &self.family.params
    }
}

impl At<'_> {
    /// Adds a moving mass inside the damper to the internal mass, and sets the mass of its own element to 0.
    #[cold]
    #[inline(never)]
    fn put_mass_inside(&self, group: usize, first_slot: usize, slots: &mut [f64]) {
        let (inside, internal) = (number!("moving_mass"), number!("internal_mass"));
        let place = |row: &Row| row.slot.wrapping_sub(first_slot);
        if group == inside.row().group
            && let Some(slot) = slots.get_mut(place(inside.row()))
        {
            *slot = 0.0;
        }
        if group == internal.row().group
            && let Some(slot) = slots.get_mut(place(internal.row()))
        {
            let own = |number: &&Interpolated| number.slot == inside.row().slot as u64;
            let varies = self.family.numbers.iter().take(self.family.used as usize).find(own);
            let value = |number: &Interpolated| self.place.value(&number.values, &number.derivatives);
            *slot += varies.map_or_else(|| self.family.params.number(inside), value);
        }
    }
}

/// Returns the number of stages of a host step of length [`COMPARED_AT`], as a measure of the cost of an integration.
fn stages(integration: &Integration) -> u32 {
    let substeps = integration.substeps(COMPARED_AT);
    substeps * integration.method_of(COMPARED_AT, substeps, || 1.0).stages()
}

impl Family {
    /// An empty family, the initial value for [`Family::set`].
    pub const OFF: Family = Family {
        model: Model::OFF,
        params: Params::BLANK,
        count: 0,
        grid: [0.0; MAX_GRID],
        start: 0.0,
        actuator: Actuator::NONE,
        varying: 0,
        numbers: [Interpolated::NONE; MAX_NUMBERS],
        used: 0,
        has_mass_inside: false,
        fv: Fv::Same,
        points: Points { u: [0.0; ROOM], per: [0.0; ROOM], f: [0.0; ROOM] },
        point_count: 0,
        interpolation: Interpolation::Linear,
        forces: [[0.0; ROOM]; MAX_GRID],
        derivatives: [[0.0; ROOM]; MAX_GRID],
        layout: 0.0,
        lagged_at: 0,
    };

    /// Checks whether the parameters and the axis define a family.
    ///
    /// Every grid value must define a valid damper, and all these dampers must have the same states.
    ///
    /// # Errors
    /// Returns the parameter at fault and the reason.
    pub fn check(params: &Params, axis: &Axis) -> Result<(), Fault> {
        axis.check()?;
        if !axis.is_some() {
            return Err(Fault { parameter: NO_PARAMETER, reason: Reason::SettingGrid });
        }
        if axis.has_forces() && params.list(list!("fv_velocity")).len() != axis.forces(0).map_or(0, <[f64]>::len) {
            return Err(list!("fv_force").fault(Reason::CurveLengths));
        }
        let mut at = *params;
        for setting in axis.grid() {
            axis.put(&mut at, *setting);
            Model::check(&at)?;
        }
        for varying in axis.numbers() {
            let Some(row) = table().nth(varying.row as usize) else { continue };
            let values = varying.values.get(..axis.grid().len()).unwrap_or(&[]);
            let is_off = |value: &f64| *value == 0.0;
            let switches = values.iter().any(is_off) && !values.iter().all(is_off);
            if switches && row.element().is_some_and(|element| SWITCHED_BY_NUMBERS.contains(&element)) {
                return Err(row.fault(Reason::SettingStates));
            }
        }
        let actuator = axis.actuator();
        let own = usize::from(actuator.has_lag()) + usize::from(actuator.has_hysteresis());
        if Model::memories_of(&at) + own > MAX_INTERNAL {
            return Err(Fault { parameter: NO_PARAMETER, reason: Reason::TooManyStates });
        }
        Ok(())
    }

    /// Prepares a family in place.
    ///
    /// # Errors
    /// Returns the errors of [`Family::check`]; the family then stays unchanged.
    pub fn set(&mut self, params: &Params, axis: &Axis) -> Result<(), Fault> {
        Family::check(params, axis)?;
        self.set_checked(params, axis)
    }

    /// Prepares a family from a parameter set and an axis that passed [`Family::check`].
    ///
    /// # Errors
    /// Returns no error for a set and an axis that passed the check.
    #[inline(never)]
    pub fn set_checked(&mut self, params: &Params, axis: &Axis) -> Result<(), Fault> {
        let grid = axis.grid();
        self.params = *params;
        self.count = grid.len() as u64;
        self.grid = [0.0; MAX_GRID];
        for (to, from) in self.grid.iter_mut().zip(grid) {
            *to = *from;
        }
        self.start = axis.start();
        self.actuator = axis.actuator();
        self.set_numbers(axis);
        // Use the most expensive of the integrations at the grid values. It is accurate enough at all grid values.
        let mut chosen = Integration::OFF;
        let mut cheap_up_to = f64::INFINITY;
        for (index, setting) in grid.iter().enumerate() {
            axis.put(&mut self.params, *setting);
            self.model.set(&self.params)?;
            let integration = self.model.integration();
            cheap_up_to = min(integration.cheap_up_to, cheap_up_to);
            let costs = (stages(&integration), integration.per_time);
            if index == 0 || costs > (stages(&chosen), chosen.per_time) {
                chosen = integration;
            }
        }
        axis.put(&mut self.params, self.start);
        self.model.set(&self.params)?;
        chosen.cheap_up_to = cheap_up_to;
        self.model.integration = chosen;
        self.set_curve(axis);
        self.lagged_at = self.model.elements.memories() as u64;
        self.layout = with_actuator(self.model.layout, self.actuator.has_lag(), self.actuator.has_hysteresis());
        Ok(())
    }

    fn set_numbers(&mut self, axis: &Axis) {
        (self.used, self.varying, self.has_mass_inside) = (0, 0, false);
        for row in table() {
            let Some(varying) = axis.numbers().iter().find(|varying| varying.row == row.index as u64) else { continue };
            let values = varying.values;
            let derivatives = derivatives(axis.grid(), values.get(..axis.grid().len()).unwrap_or(&[]));
            // A parameter of an element that is off has no effect.
            let Some(element) = row.element().filter(|element| self.params.is_on(*element)) else { continue };
            if let Some(to) = self.numbers.get_mut(self.used as usize) {
                let (group, slot) = (row.group as u64, row.slot as u64);
                *to =
                    Interpolated { group, slot, low: row.parameter.low, high: row.parameter.high, values, derivatives };
                self.used += 1;
            }
            self.varying |= element.bit();
        }
        // The moving mass may be a part of the internal mass, which belongs to the series compliance. If one of these
        // elements is prepared for a setting, the other must be prepared too.
        let both = element!("series_compliance").bit() | element!("moving_mass").bit();
        if self.varying & both != 0 {
            self.varying |= both & self.params.elements();
            let is_inside = self.params.number(number!("moving_mass_place")) == 1.0;
            self.has_mass_inside = is_inside && self.params.elements() & both == both;
        }
    }

    fn set_curve(&mut self, axis: &Axis) {
        (self.fv, self.point_count, self.interpolation) = (Fv::Same, 0, Interpolation::Linear);
        self.points = Points::NONE;
        let curve = element!("fv_curve");
        if !self.params.is_on(curve) {
            self.varying &= !curve.bit();
            return;
        }
        if self.params.number(number!("fv_form")) == 1.0 {
            let (u, f) = crate::elements::fv_curve::knees(&self.params.view(curve.place()));
            self.points.set(&u, &f);
            self.point_count = u.len() as u64;
            if self.varying & curve.bit() != 0 {
                self.fv = Fv::Knees;
            }
        } else {
            let u = self.params.list(list!("fv_velocity"));
            self.points.set(u, self.params.list(list!("fv_force")));
            self.point_count = u.len() as u64;
            self.interpolation = crate::elements::fv_curve::fv_interpolation(&self.params);
            if axis.has_forces() {
                self.fv = Fv::Forces;
                for (index, (forces, derivatives)) in self.forces.iter_mut().zip(&mut self.derivatives).enumerate() {
                    (*forces, *derivatives) = (Points::NONE.f, [0.0; ROOM]);
                    if index < axis.grid().len() {
                        let (of_points, over_setting) = axis.forces_with_derivatives(index);
                        for (to, from) in forces.iter_mut().zip(of_points).take(u.len()) {
                            *to = from;
                        }
                        for (to, from) in derivatives.iter_mut().zip(over_setting) {
                            *to = from;
                        }
                    }
                }
            }
        }
        // The FV curve at a setting is computed from its points, so it needs no preparation with the small elements.
        self.varying &= !curve.bit();
    }

    /// Returns the damper at the start setting.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Returns the setting that applies if the host gives none.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// Returns the actuator of the setting.
    pub fn actuator(&self) -> &Actuator {
        &self.actuator
    }

    /// Returns the first and the last setting of the grid.
    #[inline(always)]
    pub fn range(&self) -> (f64, f64) {
        let last = (self.count as usize).wrapping_sub(1) & (MAX_GRID - 1);
        (self.grid[0], self.grid[last])
    }

    /// Returns whether a setting lies outside the grid, where it is clamped.
    #[inline(always)]
    pub fn is_outside(&self, setting: f64) -> bool {
        let (low, high) = self.range();
        setting < low || setting > high
    }

    /// Returns the number of states that a solver of the host integrates: the damper's states, followed by those of the
    /// actuator.
    pub fn states(&self) -> usize {
        self.model.states() + usize::from(self.actuator.has_lag()) + usize::from(self.actuator.has_hysteresis())
    }

    /// Returns name and unit of state `index`: see [`Model::state_name`]. The unit `setting` stands for the unit of the
    /// setting.
    pub fn state_name(&self, index: usize) -> Option<(&'static str, &'static str)> {
        let own = index.checked_sub(self.model.states());
        match own {
            None => self.model.state_name(index),
            Some(0) if self.actuator.has_lag() => Some(("setting", "setting")),
            Some(1) if self.actuator.has_hysteresis() => Some(("setting_hysteresis", "-")),
            Some(_) => None,
        }
    }

    /// Returns the setting that the host commands, or else the start setting, clamped to the grid.
    #[inline(always)]
    fn command(&self, setting: Option<f64>) -> f64 {
        let (low, high) = self.range();
        min(high, max(low, setting.unwrap_or(self.start)))
    }

    #[inline(always)]
    fn stand(&self, state: &State) -> Stand {
        let at = |place: u64| state.internal.get(place as usize).copied().unwrap_or(0.0);
        let turned = if self.actuator.has_hysteresis() { at(self.lagged_at + 1) } else { 0.0 };
        Stand { lagged: at(self.lagged_at), turned }
    }

    #[inline(always)]
    fn put_stand(&self, state: &mut State, stand: &Stand) {
        if let Some(slot) = state.internal.get_mut(self.lagged_at as usize) {
            *slot = stand.lagged;
        }
        if self.actuator.has_hysteresis()
            && let Some(slot) = state.internal.get_mut(self.lagged_at as usize + 1)
        {
            *slot = stand.turned;
        }
    }

    /// Returns the actual setting in a state, at which the damper is evaluated. Without a lag it equals the command.
    pub fn setting_of(&self, state: &State, setting: Option<f64>) -> f64 {
        if self.actuator.has_lag() { self.actuator.setting(&self.stand(state)) } else { self.command(setting) }
    }

    /// Calls `question` with the damper at a setting. This damper exists only during the call.
    #[inline(always)]
    fn ask<R>(&self, setting: f64, question: impl FnOnce(&Model<Lent<'_>>) -> R) -> R {
        let place = GridPosition::new(&self.grid, self.count as usize, setting);
        let at = At { family: self, place };
        let count = self.point_count as usize;
        let mut forces;
        let knees;
        let (u, per, f) = match self.fv {
            Fv::Same => (&self.points.u, &self.points.per, &self.points.f),
            Fv::Forces => {
                forces = [0.0; ROOM];
                self.forces_at(&at.place, &mut forces);
                (&self.points.u, &self.points.per, &forces)
            }
            Fv::Knees => {
                knees = self.knees_at(&at);
                (&knees.u, &knees.per, &knees.f)
            }
        };
        let fv = Section::new(u, per, f, count, self.interpolation);
        let mut renewed = Renewed::none();
        let mut model = Model {
            elements: self.model.elements.lent(fv, &at, &mut renewed),
            integration: self.model.integration,
            layout: self.layout,
        };
        if self.fv != Fv::Same {
            model.elements.paths.valve_hysteresis.measure();
        }
        question(&model)
    }

    /// Interpolates the forces of the FV table at a position between grid values; forces after the last point have no
    /// meaning.
    #[inline(always)]
    fn forces_at(&self, place: &GridPosition, forces: &mut [f64; ROOM]) {
        let (from, to) = (place.interval & (MAX_GRID - 1), (place.interval + 1) & (MAX_GRID - 1));
        let [w0, w1, w2, w3] = place.weights;
        let (f0, f1, d0, d1) = (&self.forces[from], &self.forces[to], &self.derivatives[from], &self.derivatives[to]);
        let value = |point: usize| (w0 * f0[point] + w1 * f1[point]) + (w2 * d0[point] + w3 * d1[point]);
        // Most tables have fewer than 16 points. A section then reads no force after the sixteenth.
        for (point, force) in forces.iter_mut().enumerate().take(FEW_POINTS) {
            *force = value(point);
        }
        if self.point_count as usize >= FEW_POINTS {
            for (point, force) in forces.iter_mut().enumerate().skip(FEW_POINTS) {
                *force = value(point);
            }
        }
    }

    /// Computes the points of a piecewise-linear FV curve, given by derivatives and knees, at a setting. Not inlined,
    /// because such curves are rare.
    #[inline(never)]
    fn knees_at(&self, at: &At) -> Points {
        let group = element!("fv_curve").place();
        let (first, slot) = crate::parameter::row::start_of(group);
        let mut values = [0.0; FV_SLOTS];
        for (to, from) in values.iter_mut().zip(self.params.slots(slot, FV_SLOTS)) {
            *to = *from;
        }
        at.put(group, slot, &mut values);
        let (u, f) =
            crate::elements::fv_curve::knees(&crate::schema::View::new(first, self.params.lengths(first), &values));
        let mut points = Points::NONE;
        points.set(&u, &f);
        points
    }

    /// Returns the equilibrium state after the command `setting` has been constant for a long time: see
    /// [`Model::steady_state`].
    #[inline(never)]
    pub fn steady_state(&self, input: &Input, setting: Option<f64>) -> State {
        let command = self.command(setting);
        let mut state = self.ask(command, |model| model.equilibrium(input));
        self.put_stand_if_any(&mut state, command);
        state
    }

    fn put_stand_if_any(&self, state: &mut State, command: f64) {
        if self.actuator.has_lag() {
            self.put_stand(state, &self.actuator.still(command));
        }
    }

    /// Returns the dead-time buffer after the command `setting` has been constant for a long time.
    pub fn steady_delay(&self, setting: Option<f64>) -> Delay {
        Delay::constant(self.command(setting))
    }

    /// Converts a state with the layout of other elements to the layout of this family: see [`Model::laid_out`].
    #[cold]
    #[inline(never)]
    pub fn laid_out(&self, state: &State, setting: Option<f64>) -> State {
        let command = self.command(setting);
        let mut own = self.ask(command, |model| model.converted(state));
        if bits(state.layout).is_some_and(|before| before & LAG == 0) {
            self.put_stand_if_any(&mut own, command);
        }
        own
    }

    /// Advances one step of `dt`, s, in place: see [`crate::step::step_in_place`]. `to` is the input at the end of the
    /// step, and `setting` the command, which is constant during the step. Without `derivatives`, the derivatives of
    /// the output have no meaning.
    ///
    /// Returns false and changes nothing if a number of the new state or of the output is not finite.
    ///
    /// The damper is evaluated at the actual setting at the end of the step. With `dt = 0` the output is the
    /// equilibrium force at the command, and the state does not change.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    pub fn step_in_place(
        &self,
        state: &mut State,
        delay: &mut Delay,
        to: &Input,
        setting: Option<f64>,
        dt: f64,
        output: &mut Output,
        derivatives: bool,
    ) -> bool {
        if state.layout != self.layout || self.actuator.has_lag() || self.actuator.dead_time > 0.0 {
            return self.step_behind_actuator(state, delay, to, setting, dt, output, derivatives);
        }
        self.step_at(self.command(setting), state, to, dt, output, derivatives)
    }

    /// Steps at the actual setting `at` from a state in the layout of this family.
    #[inline(never)]
    fn step_at(&self, at: f64, state: &mut State, to: &Input, dt: f64, output: &mut Output, derivatives: bool) -> bool {
        self.ask(at, |model| step_borrowed(model, state, to, dt, output, derivatives))
    }

    /// Takes a step with the dynamics of the actuator, or from a state with the layout of other elements.
    #[inline(never)]
    #[allow(clippy::too_many_arguments)]
    fn step_behind_actuator(
        &self,
        state: &mut State,
        delay: &mut Delay,
        to: &Input,
        setting: Option<f64>,
        dt: f64,
        output: &mut Output,
        derivatives: bool,
    ) -> bool {
        if state.layout != self.layout {
            let mut own = self.laid_out(state, setting);
            let done = self.step_in_place(&mut own, delay, to, setting, dt, output, derivatives);
            if done {
                *state = own;
            }
            return done;
        }
        let command = self.command(setting);
        let (stand, after) = self.moved(state, delay, command, dt);
        let at = if self.actuator.has_lag() { self.actuator.setting(&stand) } else { stand.lagged };
        let done = self.step_at(at, state, to, dt, output, derivatives);
        if done && dt > 0.0 {
            if self.actuator.has_lag() {
                self.put_stand(state, &stand);
            }
            if let Some(after) = after {
                *delay = after;
            }
        }
        done
    }

    /// Returns the actuator's states and the dead-time buffer after a step. The buffer is `None` if it does not change.
    #[inline(always)]
    fn moved(&self, state: &State, delay: &Delay, command: f64, dt: f64) -> (Stand, Option<Delay>) {
        let stand = if self.actuator.has_lag() { self.stand(state) } else { Stand { lagged: command, turned: 0.0 } };
        if dt == 0.0 {
            return (self.actuator.at_rest(&stand, command), None);
        }
        if self.actuator.dead_time == 0.0 {
            return (self.actuator.advance(&stand, command, dt), None);
        }
        let mut after = if delay.is_set() { *delay } else { Delay::constant(stand.lagged) };
        let u = after.advance(command, self.actuator.dead_time, dt);
        (self.actuator.advance(&stand, u, dt), Some(after))
    }

    /// Computes the total derivative of the force at the end of a step with respect to the actual setting at that time.
    /// With `dt = 0`, the result is the derivative of the equilibrium force. Returns `None` if a force is not finite.
    #[inline(never)]
    pub fn d_force_d_setting(
        &self,
        state: &State,
        delay: &Delay,
        to: &Input,
        setting: Option<f64>,
        dt: f64,
    ) -> Option<f64> {
        if state.layout != self.layout {
            return self.d_force_d_setting(&self.laid_out(state, setting), delay, to, setting, dt);
        }
        let command = self.command(setting);
        let (stand, _) = self.moved(state, delay, command, dt);
        let at = if self.actuator.has_lag() { self.actuator.setting(&stand) } else { stand.lagged };
        let force = |setting: f64| {
            let (mut reached, mut output) = (*state, Output::ZERO);
            self.step_at(setting, &mut reached, to, dt, &mut output, false).then_some(output.force)
        };
        self.difference(at, |setting| force(setting).map(|force| [force])).map(|[by]| by)
    }

    /// Computes the derivatives of `numbers` with respect to the setting, by central differences inside the grid.
    /// `None` if a value is not finite.
    #[inline(always)]
    fn difference<const N: usize>(
        &self,
        at: f64,
        mut numbers: impl FnMut(f64) -> Option<[f64; N]>,
    ) -> Option<[f64; N]> {
        let (low, high) = self.range();
        let near = NEAR * (high - low);
        let middle = min(high - near, max(low + near, at));
        let (before, after) = (middle - near, middle + near);
        let (from, to) = (numbers(before)?, numbers(after)?);
        let mut by = [0.0; N];
        for (by, (from, to)) in by.iter_mut().zip(from.iter().zip(&to)) {
            *by = (to - from) / (after - before);
        }
        Some(by)
    }

    /// Evaluates force and rates of the damper at a setting. Neither this function nor `partials_at` is inlined, so
    /// that the stack space of each is freed on return.
    #[inline(never)]
    fn evaluate_at(&self, at: f64, state: &State, input: &Input) -> (Output, State) {
        self.ask(at, |model| evaluate_of(model, state, input))
    }

    /// Computes the partial derivatives of the damper at a setting.
    #[inline(never)]
    fn partials_at(&self, at: f64, state: &State, input: &Input) -> Partials {
        self.ask(at, |model| partials_of(model, state, input))
    }

    /// Evaluates force and rates at a state: see [`crate::evaluate()`]. The dead time does not act: `setting` is the
    /// command after the dead time.
    #[inline(never)]
    pub fn evaluate(&self, state: &State, input: &Input, setting: Option<f64>) -> (Output, State) {
        if state.layout != self.layout {
            return self.evaluate(&self.laid_out(state, setting), input, setting);
        }
        let (output, mut rate) = self.evaluate_at(self.setting_of(state, setting), state, input);
        if self.actuator.has_lag() {
            let [lagged, turned] = self.actuator.rates(&self.stand(state), self.command(setting)).rate;
            self.put_stand(&mut rate, &Stand { lagged, turned });
        }
        (output, rate)
    }

    /// Computes all partial derivatives at a state, including those with respect to the commanded setting: see
    /// [`crate::evaluate::partials`].
    #[inline(never)]
    pub fn partials(&self, state: &State, input: &Input, setting: Option<f64>) -> (Partials, BySetting) {
        if state.layout != self.layout {
            return self.partials(&self.laid_out(state, setting), input, setting);
        }
        let at = self.setting_of(state, setting);
        let mut p = self.partials_at(at, state, input);
        let rates = |setting: f64| {
            let (output, rate) = self.evaluate_at(setting, state, input);
            let mut numbers = [0.0; 11];
            let all = [output.force, rate.mass_displacement, rate.mass_velocity];
            for (to, from) in numbers.iter_mut().zip(all.iter().chain(&rate.internal)) {
                *to = *from;
            }
            Some(numbers)
        };
        let by = self.difference(at, rates).unwrap_or([0.0; 11]);
        let [force, rates @ ..] = by;
        let mut by_setting = BySetting::ZERO;
        if !self.actuator.has_lag() {
            if !setting.is_some_and(|setting| self.is_outside(setting)) {
                by_setting = BySetting { force, rate: rates };
            }
            return (p, by_setting);
        }
        // The force depends on the actual setting, which is the lagged setting y minus the hysteresis h times its state
        // z, plus a constant.
        let of = self.actuator.rates(&self.stand(state), self.command(setting));
        let follows_command = !setting.is_some_and(|setting| self.is_outside(setting));
        let (y, h) = (self.lagged_at as usize + 2, self.actuator.hysteresis);
        let states = if self.actuator.has_hysteresis() { 2 } else { 1 };
        for (state, by_stand) in [(y, 1.0), (y + 1, -h)].into_iter().take(states) {
            if let Some(to) = p.d_force_d_state.get_mut(state) {
                *to = force * by_stand;
            }
            for (row, rate) in p.d_rate_d_state.iter_mut().zip(rates) {
                if let Some(to) = row.get_mut(state) {
                    *to = rate * by_stand;
                }
            }
        }
        let rows = [[of.lagged_by[0], 0.0], [of.turned_by[0], of.turned_by[1]]];
        let commands = [of.lagged_by[1], of.turned_by[2]];
        for (own, (of_states, by_command)) in rows.into_iter().zip(commands).enumerate().take(states) {
            if let Some(row) = p.d_rate_d_state.get_mut(y + own) {
                for (to, from) in row.iter_mut().skip(y).zip(of_states).take(states) {
                    *to = from;
                }
            }
            if let Some(to) = by_setting.rate.get_mut(y + own)
                && follows_command
            {
                *to = by_command;
            }
        }
        (p, by_setting)
    }
}

/// Number of slots of the FV curve in a parameter set.
const FV_SLOTS: usize =
    crate::parameter::row::slots_of(<crate::elements::fv_curve::FvCurve as crate::schema::Describe>::PARAMETERS);
