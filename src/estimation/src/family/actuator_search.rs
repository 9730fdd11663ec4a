//! Search for the most probable actuator: none, one lag, or one lag for each direction, with optional dead time, rate
//! limit and hysteresis.

use super::actuator::{ActuatorContext, ActuatorForm, ActuatorProblem, ActuatorRefit, Ways};
use crate::cancel;
use crate::samples::Test;
use crate::structure::evidence::{Evidence, mean_square};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Prior log odds of a lag: every valve has a lag, but records of slow loggers do not resolve the lag.
const LAG: f64 = 1.0;
/// Prior log odds that rising and falling settings have different time constants.
const EACH_WAY: f64 = -0.5;
/// Prior log odds of a dead time.
const DEAD_TIME: f64 = 0.0;
/// Prior log odds of hysteresis over the setting.
const HYSTERESIS: f64 = -1.0;
/// Prior log odds of a rate limit, which is hard to distinguish from a lag.
const RATE: f64 = -2.0;
/// Smallest rise of the log posterior at which the search replaces the current form.
const RISE: f64 = 0.5;
/// Time after a change of the command during which the force depends on the valve dynamics, s. The log posterior uses
/// only these samples.
///
/// It is five times the longest typical time constant of semi-active dampers, 30 ms (Savaresi et al. 2010, chapter 2).
/// If all samples counted, with 60 N noise, the search would find one time constant of 18 ms instead of 10 and 18 ms.
const RESPONSE: f64 = 0.15;
/// Start values of the time constant, s, for a form that adds a lag.
const STARTS: [f64; 3] = [0.003, 0.012, 0.08];
/// Number of steps and tolerance of a refit for comparison. [`FINE`] applies to the final refit.
const COMPARE: (usize, f64) = (8, 1e-3);
const FINE: (usize, f64) = (20, 1e-5);

/// A part of an actuator, and its log odds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ActuatorPart {
    /// Name in files: `lag`, `lag_each_way`, `dead_time`, `rate_limit`, `hysteresis`.
    pub name: &'static str,
    /// Whether the most probable actuator has the part.
    pub is_present: bool,
    /// Log posterior of the actuator with the part minus the log posterior without the part.
    pub log_odds: f64,
}

/// The most probable actuator.
pub struct ActuatorSearch {
    /// Refit of the most probable actuator.
    pub best: ActuatorRefit,
    /// All parts, present or absent.
    pub parts: Vec<ActuatorPart>,
    /// Other forms that the records do not rule out, with their log posterior minus that of the best form.
    pub alternatives: Vec<(f64, ActuatorRefit)>,
    /// Refit of the best form without errors of the force between the settings; `None` if it gives no finite force.
    pub without_errors_between: Option<ActuatorRefit>,
    /// Derivatives of the residuals with respect to the instant of the command change within a sample: see
    /// [`ActuatorProblem::timing_derivatives`].
    pub timing: Vec<Vec<f64>>,
}

/// Returns the form with a part added, or removed if it is present. Returns `None` for separate lags of a form without
/// a lag.
fn toggled(form: ActuatorForm, part: &str) -> Option<ActuatorForm> {
    let with = match part {
        "lag" if form.lag == Ways::Neither => ActuatorForm { lag: Ways::Shared, ..form },
        "lag" => ActuatorForm { lag: Ways::Neither, ..form },
        "lag_each_way" => match form.lag {
            Ways::Neither => return None,
            Ways::Shared => ActuatorForm { lag: Ways::Each, ..form },
            Ways::Each => ActuatorForm { lag: Ways::Shared, ..form },
        },
        "dead_time" => ActuatorForm { dead_time: !form.dead_time, ..form },
        "rate_limit" => {
            ActuatorForm { rate: if form.rate == Ways::Neither { Ways::Each } else { Ways::Neither }, ..form }
        }
        _ => ActuatorForm { hysteresis: !form.hysteresis, ..form },
    };
    Some(with)
}

/// Forms of most valves: a shared lag or one lag for each direction, without and with a dead time.
const VALVES: [ActuatorForm; 4] = {
    let lag = ActuatorForm { lag: Ways::Shared, ..ActuatorForm::NONE };
    let each = ActuatorForm { lag: Ways::Each, ..ActuatorForm::NONE };
    [lag, ActuatorForm { dead_time: true, ..lag }, each, ActuatorForm { dead_time: true, ..each }]
};

/// Largest difference of log posteriors at which another form counts as an alternative. Beyond it, the weight
/// exp(−difference/2) of the form in the intervals is below one in a thousand.
const RULED_OUT: f64 = 14.0;

/// Largest difference of log posteriors at which two forms count as equally probable. One form then has 1.6 times the
/// weight exp(difference/2) of the other. With 4 instead of 1, the search includes a doubtful hysteresis. The worst
/// error of an identified lag of the physical valve is then −21 % instead of −19 % (`prove_semi_active 1 3040001`).
const TIED: f64 = 1.0;

/// Number of fits after which the search is usually half done. It only scales the displayed progress, because the total
/// number of fits is unknown in advance.
const USUAL_FITS: usize = 8;

const PARTS: [&str; 5] = ["lag", "lag_each_way", "dead_time", "rate_limit", "hysteresis"];

fn has(form: ActuatorForm, part: &str) -> bool {
    match part {
        "lag" => form.lag != Ways::Neither,
        "lag_each_way" => form.lag == Ways::Each,
        "dead_time" => form.dead_time,
        "rate_limit" => form.rate != Ways::Neither,
        _ => form.hysteresis,
    }
}

fn log_prior(form: ActuatorForm) -> f64 {
    let odds = [LAG, EACH_WAY, DEAD_TIME, RATE, HYSTERESIS];
    PARTS.iter().zip(odds).map(|(part, odds)| if has(form, part) { odds } else { 0.0 }).sum()
}

/// Returns the scored samples of a test at which the valve may respond to a command change. Returns all samples if the
/// command does not change.
///
/// A steady force contains no information about the valve. Its noise would mask the samples after a step.
fn responding(test: &Test) -> Vec<usize> {
    let segment = &test.segment;
    let Some(commands) = &segment.setting else { return (0..test.allowed.len()).collect() };
    let mut since = f64::INFINITY;
    let mut found = Vec::new();
    for (k, (command, dt)) in commands.iter().zip(&segment.dt).enumerate() {
        let has_changed = k > 0 && commands.get(k - 1).is_some_and(|before| before != command);
        since = if has_changed { 0.0 } else { since + dt };
        if since <= RESPONSE && k >= segment.from {
            found.push(k - segment.from);
        }
    }
    if found.is_empty() { (0..test.allowed.len()).collect() } else { found }
}

/// Computes the log posterior of an actuator from the samples of each test at which the valve responds.
fn log_posterior(refit: &ActuatorRefit, context: &ActuatorContext, places: &[Vec<usize>]) -> f64 {
    let of_test = |((test, (_, residual)), places): ((&Test, &(_, Vec<f64>)), &Vec<usize>)| {
        let samples = places.iter().filter_map(|k| Some((*residual.get(*k)?, *test.allowed.get(*k)?)));
        mean_square(test.unit(), samples)
    };
    let squares = context.tests.iter().zip(&refit.blocks).zip(places).map(of_test).collect();
    let evidence = Evidence {
        weights: context.tests.iter().map(|test| test.weight).collect(),
        mean_squares: squares,
        numbers: refit.numbers.len() as f64,
        negative_log_prior: refit.negative_log_prior,
        relief: 0.0,
    };
    evidence.log_evidence() + log_prior(refit.form)
}

/// A form that the search refitted.
struct Trial {
    refit: ActuatorRefit,
    /// Log posterior without the prior of the force errors between settings.
    log_posterior: f64,
}

/// All forms that the search refitted; `None` for a form that gives no finite force.
#[derive(Default)]
struct Trials(BTreeMap<ActuatorForm, Option<Trial>>);

impl Trials {
    /// Returns the log posterior of a form.
    ///
    /// The force has errors between the settings, whatever the form of the actuator. A valve without a lag jumps from
    /// setting to setting, so its refit does not show these errors. Therefore, only the excess of their negative log
    /// prior counts, relative to the form with a lag that needs the smallest errors.
    fn log_posterior(&self, trial: &Trial) -> f64 {
        let passing = self.0.values().flatten().filter(|trial| trial.refit.form.lag != Ways::Neither);
        let least = passing.map(|trial| trial.refit.negative_log_prior_between).fold(f64::INFINITY, f64::min);
        trial.log_posterior - (trial.refit.negative_log_prior_between - least).max(0.0)
    }

    fn find(&self, form: ActuatorForm) -> Option<&Trial> {
        self.0.get(&form)?.as_ref()
    }

    /// Returns a form with its log posterior.
    fn scored(&self, form: ActuatorForm) -> Option<(f64, &Trial)> {
        self.find(form).map(|trial| (self.log_posterior(trial), trial))
    }

    /// Returns the most probable form, or `now` if no other form is clearly more probable.
    fn best(&self, now: ActuatorForm) -> ActuatorForm {
        let all = self.0.keys().filter_map(|form| Some((self.scored(*form)?.0, *form)));
        let best = all.reduce(|best, next| if next.0 > best.0 { next } else { best });
        let own = self.scored(now).map_or(f64::NEG_INFINITY, |(own, _)| own);
        best.filter(|(log_posterior, _)| *log_posterior > own + RISE).map_or(now, |(_, form)| form)
    }
}

/// Data and progress of a search.
struct Search<'a> {
    context: &'a ActuatorContext<'a>,
    /// Samples of each test at which the valve responds.
    places: Vec<Vec<usize>>,
    /// Number of fits so far.
    fits: AtomicUsize,
    progress: &'a (dyn Fn(f64) + Sync),
}

impl Search<'_> {
    /// Refits a form from another one. Returns `None` if it gives no finite force.
    fn fit(&self, form: ActuatorForm, from: Option<&ActuatorRefit>) -> Option<Trial> {
        let done = self.fits.fetch_add(1, Ordering::Relaxed);
        (self.progress)(done as f64 / (done + USUAL_FITS) as f64);
        let problem = ActuatorProblem::new(self.context, form);
        let is_far = from.is_some_and(|from| from.form.lag == Ways::Neither && form.lag != Ways::Neither);
        let found: Vec<ActuatorRefit> = self
            .starts(form, from, is_far)
            .into_par_iter()
            .flat_map_iter(|start| match start {
                Some(start) => self.refits(&problem, &start, COMPARE, is_far),
                None => problem.refit(None, COMPARE).into_iter().collect(),
            })
            .collect();
        self.most_probable(found)
    }

    /// Refits a form twice: with the forces of the family fixed, then with free force errors. If the start is not far,
    /// also refits directly with free force errors. Returns all refits.
    fn refits(
        &self,
        problem: &ActuatorProblem,
        start: &[f64],
        effort: (usize, f64),
        is_far: bool,
    ) -> Vec<ActuatorRefit> {
        let direct = if is_far { None } else { problem.refit(Some(start), effort) };
        problem.refit_both(start, effort).into_iter().flatten().chain(direct).collect()
    }

    /// Returns the refit with the highest log posterior, which includes the prior of all its force errors.
    fn most_probable(&self, refits: Vec<ActuatorRefit>) -> Option<Trial> {
        let trials = refits.into_iter().map(|refit| Trial { log_posterior: self.log_posterior(&refit), refit });
        let whole = |trial: &Trial| trial.log_posterior - trial.refit.negative_log_prior_between;
        trials.reduce(|best, next| if whole(&next) > whole(&best) { next } else { best })
    }

    /// Returns the starts of a refit of `form` from the form `from`. If `from` has no lag and `form` has one, there is
    /// a start for each of several time constants.
    fn starts(&self, form: ActuatorForm, from: Option<&ActuatorRefit>, adds_lag: bool) -> Vec<Option<Vec<f64>>> {
        let (low, high) = self.context.definition.axis.range();
        let Some(from) = from else { return vec![None] };
        let base = from.start_of(form, high - low);
        if !adds_lag {
            return vec![Some(base)];
        }
        let with_time = |time: &f64| {
            let mut start = base.clone();
            start[0] = libm::log(*time);
            Some(start)
        };
        STARTS.iter().map(with_time).collect()
    }

    fn log_posterior(&self, refit: &ActuatorRefit) -> f64 {
        log_posterior(refit, self.context, &self.places)
    }

    /// Refits the forms of most valves. Returns `None` if even an actuator without dynamics gives no finite force.
    fn try_valves(&self) -> Option<Trials> {
        let none = self.fit(ActuatorForm::NONE, None)?;
        let mut from = none.refit.clone();
        let mut trials = Trials::default();
        trials.0.insert(ActuatorForm::NONE, Some(none));
        // If the time constants of rising and falling settings differ, a shared lag may be less probable than no lag. A
        // search that changes single parts would then miss the correct form.
        for form in VALVES {
            let found = self.fit(form, Some(&from));
            if let Some(Trial { refit, .. }) = &found {
                from = refit.clone();
            }
            trials.0.insert(form, found);
        }
        // Hysteresis and two lags together may be more probable than a shared lag although neither is alone. Without
        // hysteresis, errors of the force at the settings explain the force after a step.
        let with_hysteresis = |form: ActuatorForm| {
            let without = trials.find(form)?;
            let form = ActuatorForm { hysteresis: true, ..form };
            Some((form, self.fit(form, Some(&without.refit))))
        };
        let further: Vec<_> = VALVES.into_par_iter().filter_map(with_hysteresis).collect();
        trials.0.extend(further);
        Some(trials)
    }

    /// Refits the forms that have one part more or less than a form.
    fn try_parts(&self, trials: &mut Trials, of: ActuatorForm) {
        let own = trials.find(of).map(|trial| &trial.refit);
        let forms = PARTS.iter().filter_map(|part| toggled(of, part)).filter(|form| !trials.0.contains_key(form));
        let forms: Vec<ActuatorForm> = forms.collect();
        let found: Vec<_> = forms.into_par_iter().map(|form| (form, self.fit(form, own))).collect();
        trials.0.extend(found);
    }

    /// Returns the most probable form, found by changes of single parts.
    fn climb(&self, trials: &mut Trials) -> ActuatorForm {
        let mut best = trials.best(ActuatorForm::NONE);
        for _ in 0..2 * PARTS.len() {
            if cancel::asked() {
                break;
            }
            self.try_parts(trials, best);
            let next = trials.best(best);
            if next == best {
                break;
            }
            best = next;
        }
        best
    }

    /// Returns the form that predicts best among those that are as probable as `best`. The identified model contains no
    /// force errors, so the form that fits best without these errors also predicts best.
    fn break_tie(&self, trials: &Trials, best: ActuatorForm) -> Option<ActuatorForm> {
        let most = trials.scored(best)?.0;
        let tied = trials.0.values().flatten().filter(|trial| trials.log_posterior(trial) > most - TIED);
        let alone = |Trial { refit, .. }: &Trial| {
            let alone = ActuatorProblem::new(self.context, refit.form).without_force_errors(refit)?;
            Some((self.log_posterior(&alone), refit.form))
        };
        let closest = tied.filter_map(alone).max_by(|a, b| a.0.total_cmp(&b.0));
        Some(closest.map_or(best, |(_, form)| form))
    }
}

/// Returns the log odds of every part: the log posterior with the part minus that without it. The other parts are those
/// of the form `best`, whose log posterior is `most`.
fn part_odds(trials: &Trials, best: ActuatorForm, most: f64) -> Vec<ActuatorPart> {
    let odds = |part: &&'static str| {
        let is_present = has(best, part);
        let other = trials.scored(toggled(best, part)?)?.0;
        let log_odds = if is_present { most - other } else { other - most };
        Some(ActuatorPart { name: part, is_present, log_odds })
    };
    PARTS.iter().filter_map(odds).collect()
}

/// Finds the most probable actuator. Returns `None` if no form gives a finite force.
pub fn search_actuator(context: &ActuatorContext, progress: &(dyn Fn(f64) + Sync)) -> Option<ActuatorSearch> {
    let places = context.tests.iter().map(responding).collect();
    let search = Search { context, places, fits: AtomicUsize::new(0), progress };
    let mut trials = search.try_valves()?;
    let best = search.climb(&mut trials);
    let best = search.break_tie(&trials, best)?;
    // Every part of the chosen form gets its log odds, which compare the form with and without it.
    search.try_parts(&mut trials, best);
    let (most, own) = trials.scored(best)?;
    let parts = part_odds(&trials, best, most);
    let others = trials.0.values().flatten().filter(|trial| trial.refit.form != best);
    let alternatives = others
        .map(|trial| (trials.log_posterior(trial) - most, trial.refit.clone()))
        .filter(|(difference, _)| *difference > -RULED_OUT)
        .collect();
    let problem = ActuatorProblem::new(context, best);
    let best = search.most_probable(search.refits(&problem, &own.refit.theta, FINE, false))?.refit;
    let best = problem.refit_place(best, FINE, &|refit| search.log_posterior(refit));
    let timing = problem.timing_derivatives(&best)?;
    let without_errors_between = problem.refit_without_errors_between(&best.theta, FINE);
    Some(ActuatorSearch { best, parts, alternatives, without_errors_between, timing })
}
