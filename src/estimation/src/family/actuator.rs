//! Estimation problem of the actuator of an adjustable damper, from forces under a setting that changes within the
//! test.
//!
//! The forces of the damper at constant settings (its family) are known. The free parameters are those of the actuator,
//! and relative errors of the family's force. For each direction of motion, there is one error at each setting of the
//! grid, and one midway between two neighboring settings. Without these errors, an error of the family's force would be
//! attributed to the response of the actuator. The [instant](super::command_time) within a sample at which the command
//! changes is unknown. This uncertainty widens the intervals.

use super::command_time::{STEP, shifted};
use super::response::run_commanded;
use crate::hypothesis::Hypothesis;
use crate::refit::HUBER;
use crate::samples::Test;
use crate::solve::{Bounds, Derivatives, Loss, Options, Prior, Residuals, Rows, solve_knowing};
use dashpot_core::family::axis::index_of;
use dashpot_core::family::{Axis, Definition, Family};
use dashpot_records::restrict;
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::cell::RefCell;
use std::sync::OnceLock;

/// Directions of the valve, rising and falling setting, to which a parameter applies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ways {
    /// The parameter does not exist.
    Neither,
    /// Rising and falling settings share one value.
    Shared,
    /// Rising and falling settings have separate values.
    Each,
}

/// Set of parameters of an actuator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct ActuatorForm {
    /// Directions that have a time constant.
    pub lag: Ways,
    /// Whether there is a dead time.
    pub dead_time: bool,
    /// Directions that have a rate limit.
    pub rate: Ways,
    /// Whether there is hysteresis over the setting.
    pub hysteresis: bool,
}

impl ActuatorForm {
    /// No actuator: the valve follows the command without delay.
    pub const NONE: ActuatorForm =
        ActuatorForm { lag: Ways::Neither, dead_time: false, rate: Ways::Neither, hysteresis: false };
}

/// A free parameter of an actuator: the entries of the setting [`Axis`] that it sets, its transformation, start, bounds
/// and prior.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActuatorNumber {
    /// Names of the entries of the setting axis that the parameter sets.
    pub entries: &'static [&'static str],
    /// Whether the free parameter is the logarithm of the entry.
    pub is_log: bool,
    /// Start of the free parameter.
    pub start: f64,
    /// Step of the free parameter in a finite difference.
    pub step: f64,
    /// Bounds of the free parameter.
    pub bounds: (f64, f64),
    /// Mean and standard deviation of the free parameter over valves.
    pub prior: (f64, f64),
}

/// Median response time of a proportional damper valve, s, and the standard deviation of its logarithm. Published
/// response times are 5 to 30 ms (Savaresi et al., Semi-Active Suspension Control Design for Vehicles, 2010, chapter
/// 2). The spread includes a magneto-rheological coil and a slow pilot stage.
const TIME: f64 = 0.01;
const TIME_SPREAD: f64 = 1.0;
/// Mean and standard deviation of the dead time of driver and pilot stage, s: a few milliseconds, rarely ten.
const DEAD_TIME: (f64, f64) = (0.003, 0.004);
/// Mean and standard deviation of the hysteresis of solenoid valves, as a fraction of their range: friction and
/// magnetic remanence cause one to six percent.
const HYSTERESIS: (f64, f64) = (0.02, 0.03);
/// Mean and standard deviation of the position in the hysteresis band at which the valve stands during tests at
/// constant settings. The position is 1 if the setting was reached from below, and −1 if it was reached from above.
/// Rigs mostly switch the setting on from zero, so positive positions are more probable.
const REST: (f64, f64) = (0.6, 0.6);
/// Name of the entry of the setting axis for the position in the hysteresis band.
pub const REST_ENTRY: &str = "setting_hysteresis_rest";
/// Name of the entry of the setting axis for the dead time.
const DEAD_TIME_ENTRY: &str = "setting_dead_time";
/// Positions in the hysteresis band that are compared. The result is the best of them. The positions are a quarter
/// apart, so the rounding error is at most an eighth.
const PLACES: [f64; 9] = [-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0];
/// Standard deviation that fixes the position in the hysteresis band during a refit.
const FIXED: f64 = 1e-3;
/// Time to cross the whole range at a typical rate limit, s: some tens of milliseconds. [`RATE_SPREAD`] is the standard
/// deviation of its logarithm.
const CROSSES: f64 = 0.03;
const RATE_SPREAD: f64 = 1.0;
/// Standard deviation of the error of the force at a setting, as a fraction of the force.
const LEVEL_SPREAD: f64 = 0.05;
/// Largest standard deviation of the error of the force between neighbors of the grid of settings, as a fraction of the
/// force. A larger estimate is reduced to this value, because a family with a larger error is unusable.
const MOST_BETWEEN: f64 = 0.3;
/// Bound of the force error midway between neighbors of the grid, in prior standard deviations of this error.
const WITHIN: f64 = 2.0;
/// Standard deviation of the force errors, as a fraction of the force, in a refit with fixed forces of the family. It
/// is far below the resolution of any record, so the force errors stay practically zero.
const HELD_SPREAD: f64 = 1e-6;
/// Largest hysteresis as a fraction of the range of settings. The kernel accepts a quarter.
const MOST_HYSTERESIS: f64 = 0.24;

impl ActuatorNumber {
    /// Returns the free parameters of a form for a grid whose settings span `range`, in the unit of the setting.
    pub fn of_form(form: ActuatorForm, range: f64) -> Vec<ActuatorNumber> {
        let mut numbers = Vec::new();
        let time = |entries| {
            let ln = libm::log;
            ActuatorNumber {
                entries,
                is_log: true,
                start: ln(TIME),
                step: 0.02,
                bounds: (ln(2e-4), ln(5.0)),
                prior: (ln(TIME), TIME_SPREAD),
            }
        };
        let rate = |entries| {
            let typical = libm::log(range / CROSSES);
            ActuatorNumber {
                entries,
                is_log: true,
                start: typical,
                step: 0.02,
                bounds: (typical - 6.0, typical + 6.0),
                prior: (typical, RATE_SPREAD),
            }
        };
        match form.lag {
            Ways::Neither => {}
            Ways::Shared => numbers.push(time(&["setting_time_up", "setting_time_down"])),
            Ways::Each => numbers.extend([time(&["setting_time_up"]), time(&["setting_time_down"])]),
        }
        if form.dead_time {
            let (mean, spread) = DEAD_TIME;
            numbers.push(ActuatorNumber {
                entries: &[DEAD_TIME_ENTRY],
                is_log: false,
                start: mean,
                step: 2e-4,
                bounds: (0.0, 0.5),
                prior: (mean, spread),
            });
        }
        match form.rate {
            Ways::Neither => {}
            Ways::Shared => numbers.push(rate(&["setting_rate_up", "setting_rate_down"])),
            Ways::Each => numbers.extend([rate(&["setting_rate_up"]), rate(&["setting_rate_down"])]),
        }
        if form.hysteresis {
            let (mean, spread) = HYSTERESIS;
            numbers.push(ActuatorNumber {
                entries: &["setting_hysteresis"],
                is_log: false,
                start: mean * range,
                step: 1e-3 * range,
                bounds: (0.0, MOST_HYSTERESIS * range),
                prior: (mean * range, spread * range),
            });
            let (mean, spread) = REST;
            numbers.push(ActuatorNumber {
                entries: &[REST_ENTRY],
                is_log: false,
                start: mean,
                step: 0.05,
                bounds: (-1.0, 1.0),
                prior: (mean, spread),
            });
        }
        numbers
    }

    /// Converts the free parameter to the common value of its entries.
    pub fn value(&self, free: f64) -> f64 {
        if self.is_log { libm::exp(free) } else { free }
    }
}

/// Known data for the identification of an actuator.
pub struct ActuatorContext<'a> {
    /// The damper at constant settings.
    pub definition: &'a Definition,
    /// The measurement errors of the rig, at `rig_theta`.
    pub rig: &'a Hypothesis,
    /// Values of the free parameters of `rig`.
    pub rig_theta: &'a [f64],
    /// Tests whose setting changes.
    pub tests: &'a [Test],
    /// Time between two samples of the record of each test, s.
    pub sample_times: &'a [f64],
    /// Standard deviation of the error of the force midway between each two neighbors of the grid, as a fraction of the
    /// force.
    pub gap_spreads: &'a [f64],
}

/// Least-squares problem of an actuator with its free parameters.
pub struct ActuatorProblem<'a> {
    context: &'a ActuatorContext<'a>,
    form: ActuatorForm,
    numbers: Vec<ActuatorNumber>,
}

/// Result of a refit of an actuator.
#[derive(Debug, Clone)]
pub struct ActuatorRefit {
    /// Form of the actuator.
    pub form: ActuatorForm,
    /// Parameters of the form.
    pub numbers: Vec<ActuatorNumber>,
    /// Values of the free parameters, followed by the relative errors of the force at each setting and between
    /// neighbors.
    pub theta: Vec<f64>,
    /// Prior standard deviations of the relative force errors.
    spreads: Vec<f64>,
    /// Derivatives and weighted residuals of each test, computed minus measured.
    pub blocks: Vec<(DMatrix<f64>, Vec<f64>)>,
    /// Negative log prior: half the sum of squared distances from the prior means, each divided by its variance. Force
    /// errors between settings are excluded.
    pub negative_log_prior: f64,
    /// Negative log prior of the force errors between settings.
    pub negative_log_prior_between: f64,
}

/// Values and derivatives of an actuator at one point of the search.
pub struct ActuatorPoint {
    family: Box<Family>,
    x: Vec<f64>,
    moved: OnceLock<Option<Vec<(Box<Family>, f64)>>>,
}

/// Returns the family with the values `x` of the actuator's free parameters. Returns `None` if the kernel rejects them.
fn family_with(definition: &Definition, numbers: &[ActuatorNumber], x: &[f64]) -> Option<Box<Family>> {
    let axis = axis_with(&definition.axis, numbers, x)?;
    let mut family = Box::new(Family::OFF);
    family.set(&definition.params, &axis).ok()?;
    Some(family)
}

/// Returns the axis with the values `x` of the actuator's free parameters. Returns `None` if the axis rejects them.
pub fn axis_with(axis: &Axis, numbers: &[ActuatorNumber], x: &[f64]) -> Option<Axis> {
    let mut axis = *axis;
    for (number, value) in numbers.iter().zip(x) {
        for entry in number.entries {
            axis.set_number(index_of(entry.as_bytes())?, number.value(*value)).ok()?;
        }
    }
    Some(axis)
}

/// Computes the weights of the force errors at the two neighboring grid values of a setting, by linear interpolation.
///
/// Returns their indices with the weights. The sign of `velocity` selects the errors of one direction of motion.
fn level_weights(grid: &[f64], setting: f64, velocity: f64) -> [(usize, f64); 2] {
    let right = restrict(grid.partition_point(|value| *value <= setting), 1, grid.len() - 1);
    let (low, high) = (grid[right - 1], grid[right]);
    let part = restrict((setting - low) / (high - low), 0.0, 1.0);
    let first = if velocity < 0.0 { grid.len() } else { 0 };
    [(first + right - 1, 1.0 - part), (first + right, part)]
}

/// Derivatives that are computed together with the forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Wanted {
    /// No derivatives.
    Forces,
    /// Derivatives with respect to the errors of the force at each setting and direction, and between neighbors.
    Levels,
}

/// Computes the shape of an interpolation error: zero at both neighbors and 1 midway.
fn bump([(_, left), (_, right)]: [(usize, f64); 2]) -> f64 {
    4.0 * left * right
}

impl<'a> ActuatorProblem<'a> {
    /// Makes the problem of an actuator of a form.
    pub fn new(context: &'a ActuatorContext<'a>, form: ActuatorForm) -> ActuatorProblem<'a> {
        let (low, high) = context.definition.axis.range();
        ActuatorProblem { context, form, numbers: ActuatorNumber::of_form(form, high - low) }
    }

    fn grid(&self) -> &[f64] {
        self.context.definition.axis.grid()
    }

    /// Computes the forces at the scored samples of the test of a block, N, and the requested derivatives.
    ///
    /// The command is delayed by `later` samples.
    fn forces(&self, block: usize, family: &Family, x: &[f64], wanted: Wanted, later: f64) -> (Vec<f64>, DMatrix<f64>) {
        let test = &self.context.tests[block];
        let (grid, levels) = (self.grid(), &x[self.numbers.len()..]);
        let later = later * self.context.sample_times.get(block).copied().unwrap_or(0.0);
        let count = match wanted {
            Wanted::Forces => 0,
            Wanted::Levels => levels.len(),
        };
        let found = RefCell::new((DMatrix::zeros(0, 0), 1));
        let along = |segment: &crate::segment::Segment| {
            let moved = segment.setting.as_ref().filter(|_| later != 0.0).map(|all| shifted(&segment.dt, all, later));
            let commands = moved.as_deref().or(segment.setting.as_deref());
            let (mut forces, settings) = run_commanded(family, segment, commands);
            let mut columns = DMatrix::zeros(forces.len(), count);
            for (i, (force, setting)) in forces.iter_mut().zip(&settings).enumerate() {
                let [left, right] = level_weights(grid, *setting, segment.input[i].velocity);
                let gap = left.0 % grid.len() + if left.0 < grid.len() { 0 } else { grid.len() - 1 };
                let between = (2 * grid.len() + gap, bump([left, right]));
                let weights = [left, right, between];
                let gain = 1.0 + weights.iter().map(|(level, weight)| weight * levels[*level]).sum::<f64>();
                if wanted == Wanted::Levels {
                    weights.iter().for_each(|(level, weight)| columns[(i, *level)] += weight * *force);
                }
                *force *= gain;
            }
            *found.borrow_mut() = (columns, forces.len());
            forces
        };
        let forces = self.context.rig.measured_forces(test, None, self.context.rig_theta, &along);
        let (columns, length) = found.into_inner();
        if wanted == Wanted::Forces {
            return (forces, columns);
        }
        // If the force channel is filtered, the segment has several steps for each sample. Only the last step of each
        // sample is a row of the result.
        let every = ((length - 1) / (test.segment.input.len() - 1).max(1)).max(1);
        let at = |row: usize, level: usize| columns[((row + test.segment.from) * every, level)];
        let scored = DMatrix::from_fn(forces.len(), count, at);
        (forces, scored)
    }

    fn weighted(&self, test: &Test, forces: &[f64]) -> Option<Vec<f64>> {
        let each = forces.iter().zip(test.forces()).zip(&test.allowed);
        let residual: Vec<f64> = each.map(|((computed, measured), allowed)| (computed - measured) / allowed).collect();
        residual.iter().all(|r| r.is_finite()).then_some(residual)
    }

    /// Refits the parameters from a start. Without a start, the refit begins with the typical valve. `effort` is the
    /// largest number of steps and the tolerance. Returns `None` if the model gives no finite force.
    pub fn refit(&self, start: Option<&[f64]>, effort: (usize, f64)) -> Option<ActuatorRefit> {
        self.refit_with(start, effort, [LEVEL_SPREAD, MOST_BETWEEN])
    }

    /// Refits the parameters with the force errors between grid settings held near zero. Those at the settings stay
    /// free. Returns `None` if the model gives no finite force.
    pub fn refit_without_errors_between(&self, start: &[f64], effort: (usize, f64)) -> Option<ActuatorRefit> {
        let mut from = start.to_vec();
        from.iter_mut().skip(self.numbers.len() + 2 * self.grid().len()).for_each(|error| *error = 0.0);
        self.refit_with(Some(&from), effort, [LEVEL_SPREAD, HELD_SPREAD])
    }

    /// Refits the parameters with the forces of the family fixed, then with all parameters free. Returns both refits, or
    /// `None` if the model gives no finite force.
    ///
    /// From a distant start, free force errors absorb a part of the response. In a test with one command step, the
    /// estimated time constant was then 61 ms instead of 30 ms.
    ///
    /// The sum of squares counts every sample, but the log posterior counts a test as about one observation. Free force
    /// errors can therefore lower the sum and the posterior. In a family without the damper's series compliance, this
    /// excluded a lag of 8 ms. So the log posterior decides between both refits.
    pub fn refit_both(&self, start: &[f64], effort: (usize, f64)) -> Option<[ActuatorRefit; 2]> {
        let held = self.refit_with(Some(start), effort, [HELD_SPREAD; 2])?;
        let free = self.refit(Some(&held.theta), effort)?;
        // The errors of the fixed forces are as unknown as those of the free forces, so both refits have the same prior
        // deviations.
        let mut held = ActuatorRefit { spreads: free.spreads.clone(), negative_log_prior_between: 0.0, ..held };
        held.theta.iter_mut().skip(self.numbers.len()).for_each(|error| *error = 0.0);
        let distance = |(x, number): (&f64, &ActuatorNumber)| 0.5 * ((x - number.prior.0) / number.prior.1).powi(2);
        held.negative_log_prior = held.theta.iter().zip(&self.numbers).map(distance).sum();
        Some([held, free])
    }

    /// Finds the position in the hysteresis band at which tests at constant settings hold the valve. Refits all other
    /// parameters at each of [`PLACES`], and returns the refit at the best position.
    ///
    /// The free errors of the force at and between the settings explain the forces at any position nearly as well. The
    /// identified model does not contain these errors, so the positions are compared without them. `log_likelihood`
    /// evaluates a refit.
    pub fn refit_place(
        &self,
        from: ActuatorRefit,
        effort: (usize, f64),
        log_likelihood: &(dyn Fn(&ActuatorRefit) -> f64 + Sync),
    ) -> ActuatorRefit {
        let Some(place) = self.numbers.iter().position(|number| number.entries == [REST_ENTRY]) else { return from };
        let at = |rest: f64| {
            let mut numbers = self.numbers.clone();
            (numbers[place].prior, numbers[place].start) = ((rest, FIXED), rest);
            let problem = ActuatorProblem { context: self.context, form: self.form, numbers };
            let mut start = from.theta.clone();
            start[place] = rest;
            let mut refit = problem.refit(Some(&start), effort)?;
            // The position counts as a free parameter for its interval, although each refit fixes it.
            refit.numbers.clone_from(&self.numbers);
            let (mean, spread) = REST;
            let prior = 0.5 * ((rest - mean) / spread).powi(2);
            Some((log_likelihood(&self.without_force_errors(&refit)?) - prior, refit))
        };
        let found: Vec<Option<(f64, ActuatorRefit)>> = PLACES.into_par_iter().map(at).collect();
        found.into_iter().flatten().max_by(|a, b| a.0.total_cmp(&b.0)).map_or(from, |(_, refit)| refit)
    }

    fn refit_with(
        &self,
        start: Option<&[f64]>,
        (steps, tolerance): (usize, f64),
        [spread_of_levels, most_between]: [f64; 2],
    ) -> Option<ActuatorRefit> {
        let gaps = self.context.gap_spreads.iter().map(|spread| restrict(*spread, HELD_SPREAD, most_between));
        // Rebound and compression have separate force errors between settings, so each standard deviation occurs twice.
        let spreads: Vec<f64> =
            std::iter::repeat_n(spread_of_levels, 2 * self.grid().len()).chain(gaps.clone()).chain(gaps).collect();
        // An error of the family's force is equal at all samples of a command step, but the sum of squares counts every
        // sample. Therefore, a prior alone would be too weak, and bounds apply.
        let most: Vec<f64> = spreads
            .iter()
            .enumerate()
            .map(|(k, spread)| if k < 2 * self.grid().len() { 0.5 } else { WITHIN * spread })
            .collect();
        let levels = spreads.len();
        let mut from: Vec<f64> = self.numbers.iter().map(|number| number.start).collect();
        from.extend(std::iter::repeat_n(0.0, levels));
        if let Some(start) = start {
            from.copy_from_slice(start);
        }
        let priors: Vec<Prior> = self
            .numbers
            .iter()
            .map(|number| Prior { mean: number.prior.0, spread: number.prior.1 })
            .chain(spreads.iter().map(|spread| Prior { mean: 0.0, spread: *spread }))
            .collect();
        let bounds = Bounds {
            low: self.numbers.iter().map(|n| n.bounds.0).chain(most.iter().map(|most| -most)).collect(),
            high: self.numbers.iter().map(|n| n.bounds.1).chain(most.iter().copied()).collect(),
        };
        let options = Options {
            steps,
            tolerance,
            loss: Loss::Huber(HUBER),
            priors: priors.iter().copied().map(Some).collect(),
            derivatives: Derivatives::Fresh,
            damping: 1e-2,
            quiet: 1,
        };
        let found = solve_knowing(self, &from, None, &bounds, &options);
        if !found.cost.is_finite() {
            return None;
        }
        let distance = |(x, prior): (&f64, &Prior)| 0.5 * ((x - prior.mean) / prior.spread).powi(2);
        let mut distances = found.x.iter().zip(&priors).map(distance);
        let negative_log_prior = distances.by_ref().take(self.numbers.len() + 2 * self.grid().len()).sum();
        let negative_log_prior_between = distances.sum();
        let blocks = |Rows { residual, jacobian }| (jacobian, Vec::from(residual.data));
        Some(ActuatorRefit {
            form: self.form,
            numbers: self.numbers.clone(),
            theta: found.x,
            spreads,
            blocks: found.rows.into_iter().map(blocks).collect(),
            negative_log_prior,
            negative_log_prior_between,
        })
    }
}

impl ActuatorProblem<'_> {
    /// Returns a refit with the residuals of the model alone, without the force errors at and between the settings. Its
    /// derivatives are empty. Returns `None` if the kernel rejects the parameters or a force is not finite.
    pub fn without_force_errors(&self, refit: &ActuatorRefit) -> Option<ActuatorRefit> {
        let mut theta = refit.theta.clone();
        theta.iter_mut().skip(self.numbers.len()).for_each(|error| *error = 0.0);
        let family = family_with(self.context.definition, &self.numbers, &theta)?;
        let of_test = |block: usize| {
            let forces = self.forces(block, &family, &theta, Wanted::Forces, 0.0).0;
            Some((DMatrix::zeros(0, 0), self.weighted(&self.context.tests[block], &forces)?))
        };
        let blocks = (0..self.context.tests.len()).map(of_test).collect::<Option<_>>()?;
        Some(ActuatorRefit { theta, blocks, ..refit.clone() })
    }

    /// Computes derivatives of the weighted residuals of each test with respect to the instant of the command change
    /// within a sample, in samples. Returns `None` if the kernel rejects the parameters or a force is not finite.
    ///
    /// A later command is equivalent to a longer dead time. If the form has a dead time, its derivatives are therefore
    /// used. Two separate finite differences would deviate by a few percent, and the estimates of the lags would absorb
    /// this deviation.
    pub fn timing_derivatives(&self, refit: &ActuatorRefit) -> Option<Vec<Vec<f64>>> {
        let sample_time = |block: usize| self.context.sample_times.get(block).copied().unwrap_or(0.0);
        if let Some(place) = self.numbers.iter().position(|number| number.entries == [DEAD_TIME_ENTRY]) {
            let of_test = |(block, (jacobian, _)): (usize, &(DMatrix<f64>, Vec<f64>))| {
                jacobian.column(place).iter().map(|by| by * sample_time(block)).collect()
            };
            return Some(refit.blocks.iter().enumerate().map(of_test).collect());
        }
        let x = &refit.theta;
        let family = family_with(self.context.definition, &self.numbers, x)?;
        let of_test = |block: usize| {
            let at = |later: f64| {
                let forces = self.forces(block, &family, x, Wanted::Forces, later).0;
                self.weighted(&self.context.tests[block], &forces)
            };
            let (early, late) = (at(-STEP)?, at(STEP)?);
            Some(early.iter().zip(&late).map(|(early, late)| (late - early) / (2.0 * STEP)).collect())
        };
        (0..self.context.tests.len()).map(of_test).collect()
    }
}

impl ActuatorRefit {
    /// Returns the precisions (reciprocal variances) of the priors of all free parameters.
    pub fn precisions(&self) -> Vec<f64> {
        let own = self.numbers.iter().map(|number| number.prior.1);
        own.chain(self.spreads.iter().copied()).map(|spread| 1.0 / (spread * spread)).collect()
    }

    /// Makes a start for the search of another form, on a grid whose settings span `range`.
    ///
    /// Parameters that both forms contain keep their values, the others get typical values, and the force errors are
    /// those of this refit.
    pub fn start_of(&self, form: ActuatorForm, range: f64) -> Vec<f64> {
        let own = |number: &ActuatorNumber| {
            let known =
                self.numbers.iter().position(|of| of.entries.iter().any(|entry| number.entries.contains(entry)));
            known.map_or(number.start, |place| self.theta[place])
        };
        let numbers = ActuatorNumber::of_form(form, range);
        numbers.iter().map(own).chain(self.theta[self.numbers.len()..].iter().copied()).collect()
    }
}

impl Residuals for ActuatorProblem<'_> {
    type At = ActuatorPoint;

    fn prepare(&self, x: &[f64]) -> Option<ActuatorPoint> {
        let family = family_with(self.context.definition, &self.numbers, x)?;
        Some(ActuatorPoint { family, x: x.to_vec(), moved: OnceLock::new() })
    }

    fn blocks(&self) -> usize {
        self.context.tests.len()
    }

    fn residuals(&self, block: usize, at: &ActuatorPoint) -> Option<Vec<f64>> {
        self.weighted(&self.context.tests[block], &self.forces(block, &at.family, &at.x, Wanted::Forces, 0.0).0)
    }

    fn jacobian(&self, block: usize, at: &ActuatorPoint) -> Option<DMatrix<f64>> {
        let test = &self.context.tests[block];
        let moved = at.moved.get_or_init(|| {
            let of = |(place, number): (usize, &ActuatorNumber)| {
                let mut x = at.x.clone();
                let step = if x[place] + number.step > number.bounds.1 { -number.step } else { number.step };
                x[place] += step;
                Some((family_with(self.context.definition, &self.numbers, &x)?, step))
            };
            self.numbers.iter().enumerate().map(of).collect()
        });
        let (forces, levels) = self.forces(block, &at.family, &at.x, Wanted::Levels, 0.0);
        let mut jacobian = DMatrix::zeros(forces.len(), at.x.len());
        for (column, (family, step)) in moved.as_ref()?.iter().enumerate() {
            let (near, _) = self.forces(block, family, &at.x, Wanted::Forces, 0.0);
            for (row, (near, force)) in near.iter().zip(&forces).enumerate() {
                jacobian[(row, column)] = (near - force) / step / test.allowed[row];
            }
        }
        for (level, column) in levels.column_iter().enumerate() {
            for (row, value) in column.iter().enumerate() {
                jacobian[(row, self.numbers.len() + level)] = value / test.allowed[row];
            }
        }
        Some(jacobian)
    }
}
