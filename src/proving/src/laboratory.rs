//! Cases from the second laboratory, a simulator whose laws differ from those of the model. Each campaign is simulated,
//! written to files and read back, and a base model is identified. [`at_severities`] chooses the strength of each
//! effect so that the effect has the requested severity.

use crate::EvaluationError;
use crate::outcome::{Outcome, judged};
use dashpot_core::Params;
use dashpot_core::element;
use dashpot_diagnosis::{Diagnosis, Options, refitted};
use dashpot_other_lab::{Campaign, Case, Kind, LEFT_OUT_PREFIX, Protocol};
use dashpot_records::Record;
use dashpot_rig::{InjectedEffect, Truth};
use dashpot_severity::SeverityError;
use dashpot_severity::case::{Measured, model_of};
use dashpot_severity::measured::{base_model, write_and_read};
use std::collections::BTreeMap;

/// Absolute natural logarithm of the ratio of found to requested severity below which the search for a strength ends.
const NEAR: f64 = 0.1;
/// Largest number of trial strengths.
const TRIES: usize = 8;
/// Smallest and largest strength that the search tries. No real damper has an effect above this range.
const STRENGTHS: (f64, f64) = (1e-3, 12.0);
/// Constant part of the laboratory's force noise, N.
const LEAST_NOISE: f64 = 0.5;

/// Choice of the diagnosed model, and of a diagnosis with or without a reference damper.
#[derive(Debug, Clone, Copy, Default)]
pub struct Way {
    /// Whether the damper is compared with itself without the injected effect.
    pub reference: bool,
    /// Whether the model is a user's fit with all elements instead of [`base_model`].
    pub whole_fit: bool,
}

/// Measures the campaign of a case in the form that a diagnosis needs. The numbers in `case.effects` are strengths.
///
/// # Errors
/// Returns the errors of the laboratory, the reader and the fit.
pub fn measure(case: &Case, whole_fit: bool) -> Result<Measured, EvaluationError> {
    let campaign = case.run()?;
    let records = read(&campaign)?;
    let clean = read(&campaign.without_noise())?;
    let held_out: Vec<bool> = records.iter().map(|r| r.name.starts_with(LEFT_OUT_PREFIX)).collect();
    let seen = seen(&records);
    let (base, found) = if whole_fit { model_of(&seen, true)? } else { (base_of(case, &seen)?, Vec::new()) };
    let effects = campaign.truth.injected.iter().map(|hidden| InjectedEffect {
        name: hidden.effect.clone(),
        form: hidden.law.clone(),
        strength: hidden.strength,
        shapes: BTreeMap::new(),
    });
    let scale = &campaign.truth.scale;
    let damper = [
        ("rebound_n", scale.rebound_n),
        ("compression_n", scale.compression_n),
        ("series_n_m", scale.series_n_m),
        ("friction_n", scale.friction_n),
        ("gas_n", scale.gas_n),
    ];
    let truth = Truth {
        seed: case.seed,
        effects: effects.collect(),
        damper: damper.map(|(name, value)| (name.to_owned(), value)).into(),
    };
    let strengths = case.effects.iter().map(|(_, strength)| *strength).collect();
    let true_set = Some(case.true_set()?);
    let mut measured =
        Measured { records, clean, left_out: held_out, base, taken_out: Vec::new(), strengths, truth, true_set };
    measured.take_out(&found);
    Ok(measured)
}

/// Effects that the FV curve, the friction or the springs of the base model absorb almost completely. No strength of
/// these effects gives a measurable severity.
const TAKEN_UP: [&str; 6] =
    ["viscous_friction", "coulomb_friction", "series_compliance", "gas_preload", "parallel_spring", "force_offset"];

/// Number of pairs of effects in each repetition of the suite.
const PAIRS: usize = 8;

/// Returns cases of the second laboratory at typical strengths.
///
/// A suite consists of these blocks:
///
/// - Every known effect that the base model does not absorb.
/// - Every unknown effect.
/// - As many cases without an effect and with white noise as there are unknown effects.
/// - Equally many cases without an effect and with colored noise, hum and a converter of 14 bits.
/// - Pairs of known effects.
/// - Every effect of the first block with a random laboratory protocol.
/// - Equally many cases without an effect as in the third block, with a random laboratory protocol.
///
/// The kinds of dampers alternate. The suite is repeated `repetitions` times. Seeds count up from `first_seed + 1`.
pub fn suite(repetitions: u64, first_seed: u64) -> Vec<(&'static str, Case)> {
    let (known, unknown) = (dashpot_other_lab::effects::KNOWN, dashpot_other_lab::effects::UNKNOWN);
    let hidden: Vec<&str> = known.iter().map(|e| e.name).filter(|name| !TAKEN_UP.contains(name)).collect();
    let mut seed = first_seed;
    let mut all = Vec::new();
    for round in 0..repetitions as usize {
        let mut next = |k: usize| {
            seed += 1;
            Case::new(Kind::ALL[(k + round) % Kind::ALL.len()], seed)
        };
        all.extend(hidden.iter().enumerate().map(|(k, name)| ("single", next(k).hiding(name, 1.0))));
        all.extend(unknown.iter().enumerate().map(|(k, u)| ("unknown", next(k).hiding(u.effect.name, 1.0))));
        all.extend((0..unknown.len()).map(|k| ("null_white", next(k))));
        let coloured = |mut case: Case| {
            case.protocol.noise_colour = 0.8;
            case.protocol.hum_n = 2.0;
            case.protocol.bits = Some(14);
            case
        };
        all.extend((0..unknown.len()).map(|k| ("null_coloured", coloured(next(k)))));
        all.extend((0..PAIRS).map(|k| {
            // The stride 5 and the number of effects are coprime, so the first effects of successive pairs differ. The
            // second effect of a pair is never equal to the first one.
            let a = (5 * (k + PAIRS * round) + 1) % hidden.len();
            let b = (a + 1 + (7 * k + round) % (hidden.len() - 1)) % hidden.len();
            ("pair", next(k).hiding(hidden[a], 1.0).hiding(hidden[b], 1.0))
        }));
        let mut as_some_laboratory = |k: usize| {
            let case = next(k);
            Case { protocol: Protocol::of_laboratory(case.protocol.plan, case.seed), ..case }
        };
        all.extend(hidden.iter().enumerate().map(|(k, name)| ("elsewhere", as_some_laboratory(k).hiding(name, 1.0))));
        all.extend((0..unknown.len()).map(|k| ("null_elsewhere", as_some_laboratory(k))));
    }
    all
}

/// Runs and scores one case.
///
/// # Errors
/// Returns the errors of the laboratory, the reader, the fit and the diagnosis.
pub fn run(block: &'static str, case: &Case, way: Way) -> Result<(Outcome, Diagnosis), EvaluationError> {
    let measured = measure(case, way.whole_fit)?;
    let reference = if way.reference { read(&case.reference().run()?)? } else { Vec::new() };
    let options = Options { reference, ..Options::default() };
    judged(block, case.seed, &case.effects, &measured, &options)
}

/// Replaces each severity of a case by the strength that has this severity if the effect acts alone.
///
/// A severity is the root mean square that a refit of the base model cannot absorb, relative to the noise.
///
/// # Errors
/// Returns the errors of the laboratory, the reader and the fit, and an error for a severity that no strength reaches.
pub fn at_severities(case: &Case) -> Result<Case, EvaluationError> {
    let neutral = Case { effects: Vec::new(), ..case.clone() }.run()?;
    let ground = SeverityContext::new(case, &neutral)?;
    let mut found = case.clone();
    for (asked, (name, wanted)) in found.effects.iter_mut().zip(&case.effects) {
        asked.1 = ground.strength(case, name, *wanted)?;
    }
    Ok(found)
}

/// Writes records to files and loads them, like a user.
///
/// # Errors
/// Returns the errors of the laboratory and the reader.
pub fn read(campaign: &Campaign) -> Result<Vec<Record>, EvaluationError> {
    write_and_read(|path| Ok(campaign.write(path)?))
}

fn seen(records: &[Record]) -> Vec<&Record> {
    records.iter().filter(|r| !r.name.starts_with(LEFT_OUT_PREFIX)).collect()
}

fn base_of(case: &Case, records: &[&Record]) -> Result<Params, EvaluationError> {
    let mut base = base_model(records)?;
    if case.effects.iter().any(|(name, _)| name.starts_with("side_force_friction")) {
        base.enable(element!("side_force_friction"), false);
    }
    Ok(base)
}

/// Campaign of the damper without injected effects, relative to which the severity of an effect is measured.
struct SeverityContext {
    base: Params,
    noise: Vec<f64>,
    /// Residual of the base model on this campaign, relative to the noise.
    own: Vec<f64>,
}

impl SeverityContext {
    fn new(case: &Case, neutral: &Campaign) -> Result<SeverityContext, EvaluationError> {
        let clean = read(&neutral.without_noise())?;
        let records = seen(&clean);
        let noise: Vec<f64> = records
            .iter()
            .map(|r| {
                let rms = (r.force.iter().map(|f| f * f).sum::<f64>() / r.force.len().max(1) as f64).sqrt();
                0.01 * case.protocol.noise_percent * rms + LEAST_NOISE
            })
            .collect();
        let base = base_of(case, &records)?;
        let (base, own) = refitted(&records, &noise, &base).ok_or(SeverityError::NotFinite)?;
        Ok(SeverityContext { base, noise, own })
    }

    fn severity(&self, case: &Case, name: &str, strength: f64, wanted: f64) -> Result<f64, EvaluationError> {
        let campaign = Case { effects: vec![(name.to_owned(), strength)], ..case.clone() }.run()?;
        let clean = read(&campaign.without_noise())?;
        let records = seen(&clean);
        let from_neutral = self.left(&records, &self.base)?;
        if from_neutral <= wanted * (1.0 + NEAR) {
            return Ok(from_neutral);
        }
        // The refit may have ended before it converged. Therefore, identify the model again, and use the smaller
        // severity.
        Ok(self.left(&records, &base_of(case, &records)?)?.min(from_neutral))
    }

    fn left(&self, records: &[&Record], model: &Params) -> Result<f64, EvaluationError> {
        let (_, left) = refitted(records, &self.noise, model).ok_or(SeverityError::NotFinite)?;
        if left.len() != self.own.len() {
            return Err(SeverityError::OtherSamples.into());
        }
        let square: f64 = left.iter().zip(&self.own).map(|(with, without)| (with - without).powi(2)).sum();
        Ok((square / left.len().max(1) as f64).sqrt())
    }

    /// Finds the strength for a severity by a bracketed search on a logarithmic scale. Returns an error if no tried
    /// strength comes near the severity.
    fn strength(&self, case: &Case, name: &str, wanted: f64) -> Result<f64, EvaluationError> {
        if wanted <= 0.0 {
            return Ok(0.0);
        }
        let (mut low, mut high) = (None::<(f64, f64)>, None::<(f64, f64)>);
        let mut strength: f64 = 0.5;
        let mut best = (f64::INFINITY, strength, 0.0);
        for _ in 0..TRIES {
            let found = self.severity(case, name, strength, wanted)?.max(1e-3);
            let off = libm::log(found / wanted);
            if off.abs() < best.0 {
                best = (off.abs(), strength, found);
            }
            if off.abs() < NEAR {
                break;
            }
            *(if off < 0.0 { &mut low } else { &mut high }) = Some((libm::log(strength), off));
            let next = match (low, high) {
                // The logarithm of the severity is nearly linear in the logarithm of the strength. The step stays
                // inside the bracket.
                (Some((a, fa)), Some((b, fb))) => a + (b - a) * (fa / (fa - fb)).clamp(0.15, 0.85),
                (Some((a, fa)), None) => a - fa.max(-2.0),
                (None, Some((b, fb))) => b - fb.min(3.0),
                (None, None) => libm::log(strength),
            };
            let next = libm::exp(next).clamp(STRENGTHS.0, STRENGTHS.1);
            if libm::log(next / strength).abs() < 1e-3 {
                break;
            }
            strength = next;
        }
        if best.0 < 0.35 {
            return Ok(best.1);
        }
        Err(SeverityError::OutOfReach { effect: name.to_owned(), reached: best.2, wanted }.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_other_lab::Plan;

    #[test]
    fn strength_makes_the_severity_that_was_asked_for() {
        let protocol = Protocol { plan: Plan::Reduced, ..Protocol::default() };
        let case = Case { protocol, ..Case::new(Kind::ThesisLike, 2) }.hiding("free_play", 2.0);
        let found = at_severities(&case).unwrap();
        let neutral = Case { effects: Vec::new(), ..case.clone() }.run().unwrap();
        let reached = SeverityContext::new(&case, &neutral)
            .unwrap()
            .severity(&case, "free_play", found.effects[0].1, 2.0)
            .unwrap();
        assert!((reached / 2.0).ln().abs() < 0.35, "{reached}");
        let measured = measure(&found, false).unwrap();
        assert_eq!(measured.records.len(), measured.left_out.len());
        assert_eq!(measured.truth.effects[0].name, "free_play");
        assert!(measured.left_out.iter().any(|out| *out) && measured.base.is_on(element!("fv_curve")));
    }
}
