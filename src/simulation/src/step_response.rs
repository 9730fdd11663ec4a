//! Response of the force to a step of the setting: measured and modeled, up and down.
//!
//! For the motion of the test, the model gives the force at the setting before the step and at the setting after it. The response is the
//! completed fraction of the difference of these forces. So a step during a sine is equivalent to a step at constant speed.
//!
//! Both settings are equilibria of the valve, not commands, because a valve with hysteresis stops before it reaches the command.

use crate::prediction::{predict, predict_family};
use dashpot_core::family::Definition;
use dashpot_core::family::actuator::{Actuator, Stand};
use dashpot_identification::model_file::{NoModel, prepared, prepared_family};
use dashpot_identification::validation::{ResponseTimes, SHORTEST_LEVEL, StepGroup, StepResponse, measured_times};
use dashpot_records::smoothing::smooth;
use dashpot_records::{Record, SettingPattern, is_same_setting};
use std::collections::BTreeMap;

/// Time before a step that a response includes, s.
const BEFORE: f64 = 0.01;
/// Longest time after a step that a response includes, s.
const BEHIND: f64 = 1.0;
/// Largest number of points of a response over time.
const POINTS: usize = 1500;
/// Smallest duration of the constant setting after a step, relative to the longest such duration of all steps between the same settings.
/// Shorter steps are left out, because they would truncate the mean response.
const LONG: f64 = 0.5;
/// Smallest number of steps of one test in one stroke direction for which a separate response is computed. With fewer steps, the noise
/// would determine which of these responses is the slowest.
const FEWEST: usize = 3;
/// Last fraction of the time after a step over which the final value of the response is averaged.
const SETTLED: f64 = 0.25;
/// Smallest force change at an instant of a response, relative to the largest force change of all steps, at which the instant is used. The
/// force change is that between the two settings.
const LEAST: f64 = 0.2;
/// Smallest fraction of the force change that counts as completed at the end of the constant setting after a step. Thus, the full change of
/// the measured force is estimated as at most five times the observed change.
const SHORTEST_WAY: f64 = 0.2;
/// Largest error of the force due to a rounded velocity at which an instant is used, relative to the force change of the step.
///
/// If the velocity is computed from the position, the window of the derivative rounds corners of the velocity. With a limit of 1, a step
/// shortly before the reversal of a triangle showed an overshoot of 41 %. Its response time was 14.8 ms instead of 10.1 ms. With 0.1, all
/// instants of a sine are used.
const ROUNDED: f64 = 0.1;

/// Force over time around one step, with the forces at the settings before and after the step.
#[derive(Debug, Clone)]
pub struct StepForces {
    /// Time since the step, s.
    pub time: Vec<f64>,
    /// Force, N.
    pub force: Vec<f64>,
    /// Force at the setting before the step along the same motion, N.
    pub before: Vec<f64>,
    /// Force at the setting after the step along the same motion, N.
    pub after: Vec<f64>,
    /// Window of the derivative, s, if the velocity is computed from the position. It is 0 if the velocity was measured.
    pub velocity_window_s: f64,
}

impl StepForces {
    /// Returns, for each instant, whether the rounded velocity causes only a negligible error of the model's forces.
    ///
    /// The velocity is rounded, because the derivative of the position smooths it over a window. Smoothing moves a value toward the mean of
    /// its neighbors in the window. So the difference between a model force and its mean over the window estimates the force error. In the
    /// middle of a corner, the rounded velocity is linear, so this difference does not show the error. Therefore, instants within a quarter
    /// of the window from a rounded instant count as rounded too.
    fn has_known_motion(&self) -> Vec<bool> {
        if self.velocity_window_s == 0.0 {
            return vec![true; self.time.len()];
        }
        let half = 0.5 * self.velocity_window_s;
        let within = |i: usize, reach: f64| {
            let time = self.time[i];
            self.time.partition_point(|t| *t < time - reach)..self.time.partition_point(|t| *t <= time + reach)
        };
        let is_rounded = |i: usize| {
            let largest = ROUNDED * (self.after[i] - self.before[i]).abs();
            [&self.before, &self.after].iter().any(|forces| {
                let window = &forces[within(i, half)];
                (forces[i] - window.iter().sum::<f64>() / window.len() as f64).abs() > largest
            })
        };
        let rounded: Vec<bool> = (0..self.time.len()).map(is_rounded).collect();
        (0..rounded.len()).map(|i| !rounded[within(i, 0.5 * half)].contains(&true)).collect()
    }
}

/// Averages the responses to steps between the same settings on a grid of times since the step, s. The mean response is 0 before the step
/// and 1 at the end of the grid.
pub fn mean_response(steps: &[StepForces], grid: &[f64]) -> Vec<f64> {
    let raw = fraction_of_way(&steps.iter().collect::<Vec<_>>(), grid);
    let [zero, one] = ends(&raw, grid);
    scaled(&raw, zero, one)
}

/// Computes the completed fraction of the force change on a grid of times since the step, s, by least squares over the steps. Returns NaN
/// at times without a usable step.
fn fraction_of_way(steps: &[&StepForces], grid: &[f64]) -> Vec<f64> {
    let most =
        steps.iter().flat_map(|of| of.after.iter().zip(&of.before)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let mut sums = vec![[0.0; 2]; grid.len()];
    for of in steps {
        let is_known = of.has_known_motion();
        for (sum, t) in sums.iter_mut().zip(grid) {
            let right = of.time.partition_point(|time| time < t);
            if right == 0 || right >= of.time.len() || !(is_known[right - 1] && is_known[right]) {
                continue;
            }
            let part = (t - of.time[right - 1]) / (of.time[right] - of.time[right - 1]);
            let at = |values: &[f64]| values[right - 1] + part * (values[right] - values[right - 1]);
            let (force, before, after) = (at(&of.force), at(&of.before), at(&of.after));
            let way = after - before;
            if way.abs() >= LEAST * most {
                sum[0] += (force - before) * way;
                sum[1] += way * way;
            }
        }
    }
    sums.iter().map(|[product, square]| product / square).collect()
}

/// Averages the completed fraction of the force change before the step, and over the last quarter of the time after the step. Without
/// finite values, the averages are 0 and 1.
fn ends(raw: &[f64], grid: &[f64]) -> [f64; 2] {
    let mean = |wanted: &dyn Fn(f64) -> bool| {
        let own = raw.iter().zip(grid).filter(|(r, t)| r.is_finite() && wanted(**t)).map(|(r, _)| *r);
        let (sum, count) = own.fold((0.0, 0), |(sum, count), r| (sum + r, count + 1));
        (count > 0).then(|| sum / f64::from(count))
    };
    let end = grid.last().copied().unwrap_or(0.0);
    [mean(&|t| t < 0.0).unwrap_or(0.0), mean(&|t| t > (1.0 - SETTLED) * end).unwrap_or(1.0)]
}

fn scaled(raw: &[f64], zero: f64, one: f64) -> Vec<f64> {
    raw.iter().map(|r| (r - zero) / (one - zero)).collect()
}

/// Computes the measured and the modeled response on a grid, and the model's completed fraction at the end of the grid.
///
/// Force errors of the model at the two settings do not belong to the response. So the measured response is scaled to end at the same
/// fraction as the model's response. This fraction is below 1 if the next step follows too early for the valve. If the fraction were set to
/// 1, the measured response would appear too fast. For example, with 0.136 s between the steps, a time constant of 60 ms would appear as
/// 47 ms at 63 %.
fn both(steps: &[&Step], grid: &[f64]) -> ([Vec<f64>; 2], f64) {
    let forces: [fn(&Step) -> &StepForces; 2] = [|step| &step.measured, |step| &step.model];
    let [measured, model] =
        forces.map(|of| fraction_of_way(&steps.iter().map(|step| of(step)).collect::<Vec<_>>(), grid));
    // The model's full force change is known, so only the start of its response is scaled to 0.
    let [zero, one] = ends(&model, grid);
    let model = scaled(&model, zero, 1.0);
    let settled = dashpot_records::restrict((one - zero) / (1.0 - zero), SHORTEST_WAY, 1.0);
    let [zero, one] = ends(&measured, grid);
    let measured = scaled(&measured, zero, zero + (one - zero) / settled);
    ([measured, model], settled)
}

/// Steps of the setting between the same two settings.
#[derive(Default)]
struct Kind {
    levels: [f64; 2],
    steps: Vec<Step>,
    /// Shortest sampling interval, s.
    sample: f64,
    /// Longest interval between two known values of the command, s.
    command_sample: f64,
}

/// One step, measured and modeled.
struct Step {
    test: String,
    /// Whether the damper was in rebound at the step.
    is_rebound: bool,
    /// Time until the next step, s.
    level: f64,
    measured: StepForces,
    model: StepForces,
}

/// State of the valve along the command (setting over time) of a record. The dead time is omitted, because it does not affect the
/// equilibrium of the valve.
struct Valve<'a> {
    actuator: Actuator,
    record: &'a Record,
    stand: Stand,
    /// Index of the sample to which the state belongs.
    sample: usize,
}

impl<'a> Valve<'a> {
    fn new(actuator: Actuator, record: &'a Record) -> Valve<'a> {
        let lagged = record.setting_signal.as_ref().and_then(|signal| signal.values.first()).copied().unwrap_or(0.0);
        Valve { actuator, record, stand: actuator.still(lagged), sample: 0 }
    }

    /// Advances the state to a later sample.
    fn move_to(&mut self, sample: usize) -> &Valve<'a> {
        if let Some(signal) = &self.record.setting_signal {
            while self.sample < sample {
                let [from, to] = [self.sample, self.sample + 1].map(|k| self.record.time[k]);
                self.stand = self.actuator.advance(&self.stand, signal.values[self.sample], to - from);
                self.sample += 1;
            }
        }
        self
    }

    /// Returns the settings at which the valve is in equilibrium under the commands `from` and `to` before and after a step.
    fn settings_at_rest(&self, from: f64, to: f64) -> [f64; 2] {
        [from, to].map(|command| self.actuator.setting(&self.actuator.at_rest(&self.stand, command)))
    }
}

/// Computes the responses of the force to the steps of the setting in records, grouped by the settings before and after the step.
///
/// # Errors
/// Returns an error if the parameters do not form a valid model.
pub fn step_responses(definition: &Definition, records: &[&Record]) -> Result<Vec<StepResponse>, NoModel> {
    let mut kinds: Vec<Kind> = Vec::new();
    let family = prepared_family(definition)?;
    for record in records {
        let Some(signal) = record.setting_signal.as_ref().filter(|s| s.pattern == SettingPattern::Steps) else {
            continue;
        };
        let motion = smooth(record);
        let model = predict_family(&family, record, &motion);
        let mut levels: Vec<(f64, Vec<f64>)> = Vec::new();
        let mut starts_at = 0.0;
        let mut valve = Valve::new(definition.axis.actuator(), record);
        for step in signal.steps() {
            let at_rest = valve.move_to(step.index).settings_at_rest(step.from, step.to);
            for level in at_rest {
                if !levels.iter().any(|(known, _)| is_same_setting(*known, level)) {
                    let damper = prepared(&definition.params_at(level))?;
                    levels.push((level, predict(&damper, record, &motion, 0.0)));
                }
            }
            let level = |wanted: f64| levels.iter().find(|(known, _)| is_same_setting(*known, wanted)).map(|(_, f)| f);
            let [from, to] = at_rest.map(level);
            let (Some(before), Some(after)) = (from, to) else { continue };
            // The instant of the change within a sampling interval is unknown, so use the middle of the interval.
            let instant = 0.5 * (record.time[step.index] + record.time[step.index.saturating_sub(1)]);
            let end = record.time[step.end.min(record.time.len()) - 1];
            let has_settled = instant - starts_at >= SHORTEST_LEVEL && end - instant >= SHORTEST_LEVEL;
            starts_at = instant;
            if !has_settled {
                continue;
            }
            let from = record.time.partition_point(|t| *t < instant - BEFORE);
            let to = record.time.partition_point(|t| *t < end.min(instant + BEHIND));
            let cut = |values: &[f64]| values[from..to].to_vec();
            let forces = |force: &[f64]| StepForces {
                time: record.time[from..to].iter().map(|t| t - instant).collect(),
                force: cut(force),
                before: cut(before),
                after: cut(after),
                velocity_window_s: record.velocity_window_s,
            };
            let is_own = |kind: &Kind| {
                let [from, to] = kind.levels;
                is_same_setting(from, step.from) && is_same_setting(to, step.to)
            };
            let place = kinds.iter().position(is_own).unwrap_or_else(|| {
                kinds.push(Kind { levels: [step.from, step.to], sample: BEHIND, ..Kind::default() });
                kinds.len() - 1
            });
            let kind = &mut kinds[place];
            let sample = (end - record.time[from]) / (step.end - from).max(1) as f64;
            kind.sample = kind.sample.min(sample);
            kind.command_sample = kind.command_sample.max(signal.spacing * sample);
            kind.steps.push(Step {
                test: record.name.clone(),
                is_rebound: motion.velocity.get(step.index).is_some_and(|velocity| *velocity > 0.0),
                level: (end - instant).min(BEHIND),
                measured: forces(&record.force),
                model: forces(&model),
            });
        }
    }
    kinds.sort_by(|a, b| a.levels[0].total_cmp(&b.levels[0]).then(a.levels[1].total_cmp(&b.levels[1])));
    Ok(kinds.into_iter().map(response).collect())
}

/// Computes the mean response to steps between the same two settings.
fn response(kind: Kind) -> StepResponse {
    let longest = kind.steps.iter().map(|step| step.level).fold(0.0, f64::max);
    let steps: Vec<&Step> = kind.steps.iter().filter(|step| step.level >= LONG * longest).collect();
    let span = steps.iter().map(|step| step.level).fold(longest, f64::min) + BEFORE;
    // The grid is not finer than the sampling, because there is no information between the samples.
    let points = (span / kind.sample.max(1e-6)).min(POINTS as f64).max(8.0) as usize;
    let grid: Vec<f64> = (0..=points).map(|k| span * k as f64 / points as f64 - BEFORE).collect();
    let mut groups: BTreeMap<(&str, bool), Vec<&Step>> = BTreeMap::new();
    for step in &steps {
        groups.entry((step.test.as_str(), step.is_rebound)).or_default().push(step);
    }
    let mut tests: Vec<String> = steps.iter().map(|step| step.test.clone()).collect();
    tests.dedup();
    let groups = groups.into_iter().filter(|(_, own)| own.len() >= FEWEST).map(|((test, is_rebound), own)| {
        let [measured, model] = both(&own, &grid).0;
        let (measured, uncertainty) = measured_times(&grid, &measured, &model, [kind.sample, kind.command_sample]);
        StepGroup {
            test: test.to_owned(),
            is_rebound,
            steps: own.len(),
            measured,
            uncertainty,
            model: ResponseTimes::measure(&grid, &model),
        }
    });
    let groups = groups.collect();
    let ([measured, model], settled) = both(&steps, &grid);
    let (times, uncertainty) = measured_times(&grid, &measured, &model, [kind.sample, kind.command_sample]);
    StepResponse {
        from: kind.levels[0],
        to: kind.levels[1],
        steps: steps.len(),
        tests,
        sample_s: kind.sample,
        end_fraction: settled,
        groups,
        measured: times,
        uncertainty,
        model: ResponseTimes::measure(&grid, &model),
        time: grid,
        measured_response: measured,
        model_response: model,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_during_a_sine_counts_as_one_at_constant_speed() {
        let grid: Vec<f64> = (0..300).map(|k| 1e-3 * f64::from(k) - 0.01).collect();
        let step = |phase: f64| {
            let speed: Vec<f64> = grid.iter().map(|t| libm::cos(8.0 * t + phase)).collect();
            let way = |t: f64| if t < 0.0 { 0.0 } else { 1.0 - libm::exp(-t / 0.012) };
            StepForces {
                force: grid.iter().zip(&speed).map(|(t, v)| (200.0 + 800.0 * way(*t)) * v + 3.0).collect(),
                before: speed.iter().map(|v| 200.0 * v).collect(),
                after: speed.iter().map(|v| 1000.0 * v).collect(),
                time: grid.clone(),
                velocity_window_s: 0.0,
            }
        };
        let mean = mean_response(&[step(0.0), step(2.0), step(-0.7)], &grid[1..299]);
        let found = ResponseTimes::measure(&grid[1..299], &mean).unwrap();
        assert!((found.t63_s - 0.012).abs() < 5e-4, "{found:?}");
    }

    #[test]
    fn a_corner_that_the_derivative_rounds_is_no_part_of_a_response() {
        // A triangle reverses 50 ms after the step of the setting. Its velocity is rounded over a window of 17 ms.
        let (turn, half) = (0.05, 0.0085);
        let grid: Vec<f64> = (0..200).map(|k| 1e-3 * f64::from(k) - 0.01).collect();
        let speed = |t: f64| if t < turn { 1.0 } else { -1.0 };
        let rounded = |t: f64| ((turn - t) / half).clamp(-1.0, 1.0);
        let way = |t: f64| if t < 0.0 { 0.0 } else { 1.0 - libm::exp(-t / 0.012) };
        let step = |velocity_window_s| StepForces {
            force: grid.iter().map(|t| (200.0 + 800.0 * way(*t)) * speed(*t)).collect(),
            before: grid.iter().map(|t| 200.0 * rounded(*t)).collect(),
            after: grid.iter().map(|t| 1000.0 * rounded(*t)).collect(),
            time: grid.clone(),
            velocity_window_s,
        };
        let response = |window| mean_response(&[step(window)], &grid[1..199]);
        let wrong = ResponseTimes::measure(&grid[1..199], &response(0.0)).unwrap();
        let right = ResponseTimes::measure(&grid[1..199], &response(2.0 * half)).unwrap();
        assert!(wrong.overshoot > 0.1, "{wrong:?}");
        assert!(right.overshoot < 1e-3 && (right.t63_s - 0.012).abs() < 5e-4, "{right:?}");
    }
}
