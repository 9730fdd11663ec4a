//! Determines the positive direction of the files from the physics of a passive damper.
//!
//! Two questions have separate answers. First: do force and motion have consistent signs? A damper takes energy out of
//! the rig, so force times velocity must be positive on average. If the mean is negative, one of the two signs is
//! reversed, and the campaign is rejected.
//!
//! Second: are force and motion positive in rebound or in compression? The energy does not depend on this. Gas pressure
//! pushes the rod out, and most dampers resist rebound more than compression. Both facts are evidence, combined as
//! odds.
//!
//! The asymmetry comes from the valves, so only the increase of the force with speed counts. Friction does not increase
//! with speed and has no preferred direction. Gas and the zero of the load cell cancel in the increase.

use serde::{Deserialize, Serialize};

use crate::cleaning::delay_motion;
use crate::cleaning::swapped_columns::Overtones;
use crate::data::complete_test::CompleteTest;
use crate::data::record::{Counted, Note};
use crate::error::{PlausibilityError, RecordError};
use crate::messages::newtons::newtons;
use crate::messages::phrases;
use crate::numbers::{median, quantile};
use crate::options::{Options, Positive};
use crate::quantities::load_cell;
use crate::signal::delay::{self, Cause, Delay};
use crate::tuning::delay::UNCLEAR;
use crate::tuning::sign::{
    FAST, FEWEST, HYSTERESIS, MOST_BY_SHAPE, PRIOR_RATIO, RATIO_SCATTER, SLOW, SUREST, TARED, UNSURE,
};
use dashpot_messages::{Sentence, format_decimals};

/// Result of determining the positive direction of the files.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct SignFinding {
    /// Positive direction of the files, after the sign reversals that the options request.
    pub positive: Positive,
    /// Whether the user stated the direction. Otherwise it is an estimate.
    pub is_stated: bool,
    /// Probability that the direction is correct: 0.5 without evidence, 1 if certain.
    pub confidence: f64,
    /// Evidence for and against the direction, as sentences.
    pub reasons: Vec<Sentence>,
    /// Force at standstill, tension positive, N: minus the gas force, plus the offset of the load cell.
    pub standstill_force: f64,
    /// Ratio of the damping force in rebound to that in compression at similar speed, for the direction `positive`, if
    /// the ratio could be determined.
    pub asymmetry: Option<f64>,
}

impl SignFinding {
    /// Returns the part of the result that every record of the campaign stores.
    pub fn counted(&self) -> Counted {
        Counted { positive: self.positive, is_stated: self.is_stated }
    }
}

/// Evidence of one test for the positive direction, with the signs of the file.
struct Evidence {
    name: String,
    /// Correlation of force and velocity over whole cycles: the power relative to the largest possible power at these
    /// amplitudes.
    power: f64,
    /// Force at standstill and its uncertainty, N.
    standstill: Option<(f64, f64)>,
    /// Natural logarithm of the ratio of the damping force at positive velocity to that at negative velocity.
    asymmetry: Option<f64>,
    /// Increase of the force from low to high speed, at positive and at negative velocity, N.
    growth: Option<[f64; 2]>,
    /// Uncertainty of the force at a given speed due to hysteresis, N.
    level_error: f64,
    peak_velocity: f64,
}

/// Estimates the positive direction of the files unless the user states it, and makes rebound positive in all motions.
///
/// Also detects a delay of the force channel. The delay is removed for the estimate of the direction, but the motions
/// retain it.
pub(crate) fn determine(
    motions: &mut [CompleteTest],
    options: &Options,
    notes: &mut Vec<Note>,
) -> Result<(SignFinding, Option<Delay>), RecordError> {
    let flip = |values: &mut Vec<f64>| values.iter_mut().for_each(|v| *v = -*v);
    let (mut evidence, mut standstill) = weigh(motions);
    let late = lateness(motions, &evidence, standstill, options, notes)?;
    if let Some(late) = late {
        let mut in_time = motions.to_vec();
        in_time.iter_mut().for_each(|motion| {
            delay_motion(motion, late.seconds);
        });
        (evidence, standstill) = weigh(&in_time);
    }
    let mut finding = direction(&evidence, standstill, options, notes);
    let cycles: Vec<(usize, Overtones)> =
        motions.iter().enumerate().filter_map(|(i, motion)| Some((i, Overtones::measure(motion)?))).collect();
    let exchanged: Vec<(usize, Overtones)> = cycles.iter().copied().filter(|(_, o)| o.exchanged()).collect();
    // With the recorded signs, the damper dissipates energy. The channels may therefore be correct, and the damper of
    // an unknown kind. So add a note and leave the record unchanged.
    if 2 * exchanged.len() > cycles.len() {
        let text =
            Sentence::from(phrases::EXCHANGED_DOUBT).with_sentence("exchanged", told_exchanged(&evidence, &exchanged));
        notes.push(Note { kind: "exchanged", text });
        finding.reasons.push(phrases::MAYBE_EXCHANGED.into());
        finding.confidence = finding.confidence.min(0.5);
    }
    if finding.positive == Positive::Compression {
        for motion in motions.iter_mut() {
            flip(&mut motion.force);
            flip(&mut motion.displacement);
            flip(&mut motion.velocity);
        }
    }
    Ok((finding, late))
}

/// Gathers the evidence of all tests, and the campaign's force at standstill with its uncertainty, N.
fn weigh(motions: &[CompleteTest]) -> (Vec<Evidence>, Option<(f64, f64)>) {
    // A force at standstill below the expected offset of the load cell is no evidence of gas.
    let offset = load_cell::offset(motions.iter().flat_map(|m| &m.force).fold(0.0, |most: f64, f| most.max(f.abs())));
    let mut evidence: Vec<Evidence> = motions.iter().map(|motion| gather(motion, offset)).collect();
    let standstill = standstill(&evidence);
    let slow: Vec<Slow> = evidence.iter().zip(motions).map(|(of, motion)| Slow::of(motion, of.peak_velocity)).collect();
    for (evidence, motion) in evidence.iter_mut().zip(motions.iter()) {
        evidence.asymmetry = asymmetry(motion, standstill.map_or(0.0, |s| s.0));
        evidence.growth = growth(motion, evidence.peak_velocity, &slow);
    }
    (evidence, standstill)
}

/// Returns the delay of the force, if significant, and adds a note about it. Rejects the campaign if tests feed energy
/// into the rig for a reason other than a delay.
fn lateness(
    motions: &[CompleteTest],
    evidence: &[Evidence],
    standstill: Option<(f64, f64)>,
    options: &Options,
    notes: &mut Vec<Note>,
) -> Result<Option<Delay>, RecordError> {
    let feeding: Vec<usize> = (0..evidence.len()).filter(|&i| evidence[i].power < -UNCLEAR).collect();
    // Exchanged channels, a wrong sign and a delay of half a cycle all reverse the loop. Only the wave form
    // distinguishes these causes.
    let exchanged: Vec<(usize, Overtones)> = feeding
        .iter()
        .filter_map(|&i| Some((i, Overtones::measure(&motions[i])?)))
        .filter(|(_, overtones)| overtones.exchanged())
        .collect();
    if !feeding.is_empty() && 2 * exchanged.len() >= feeding.len() {
        let cause =
            Sentence::from(phrases::EXCHANGED_FEED).with_sentence("exchanged", told_exchanged(evidence, &exchanged));
        let tests = exchanged.iter().map(|(i, _)| evidence[*i].name.clone()).collect();
        return Err(PlausibilityError::Exchanged { cause, tests }.into());
    }
    let describe = |late: &Delay| {
        Sentence::from(phrases::LATE)
            .with("delay", format_decimals(1e3 * late.seconds, 1))
            .with("left", format_decimals(100.0 * late.unexplained, 1))
            .with("recorded", format_decimals(100.0 * late.unexplained_as_recorded.min(1.0), 1))
    };
    let flag = |late: &Delay| format!("--delay {:.4}", options.delay_s + late.seconds);
    let late = if feeding.is_empty() {
        delay::find(motions)
    } else {
        match delay::cause(motions, &feeding) {
            Cause::Delay(late) => Some(late),
            Cause::Either(late) => {
                let also =
                    Sentence::from(phrases::OR_LATE).with_sentence("late", describe(&late)).with("option", flag(&late));
                return Err(energy_fed(evidence, standstill, Some(also)));
            }
            Cause::Sign => return Err(energy_fed(evidence, standstill, None)),
        }
    };
    if let Some(late) = &late {
        let energy = (!feeding.is_empty())
            .then(|| Sentence::from(phrases::WOULD_FEED).with("count", feeding.len()).with("all", evidence.len()));
        notes.push(Note {
            kind: "late",
            text: Sentence::from(phrases::LATE_NOT_MOVED)
                .with_sentence("late", describe(late))
                .with_any("energy", energy)
                .with("option", flag(late)),
        });
    }
    Ok(late)
}

/// Formats a force with its sign.
fn signed(force: f64) -> String {
    format!("{}{}", if force < 0.0 { "-" } else { "+" }, newtons(force.abs(), 0))
}

fn gather(motion: &CompleteTest, offset: f64) -> Evidence {
    let span = motion.steady();
    let (time, x, v, force) = (
        &motion.time[span.clone()],
        &motion.displacement[span.clone()],
        &motion.velocity[span.clone()],
        &motion.force[span],
    );
    let n = x.len() as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / n;
    let (mx, mf) = (mean(x), mean(force));
    // Over whole cycles, springs and gas return the energy that they store. Without whole cycles, a linear fit removes
    // their contribution.
    let stiffness = if motion.cycles.is_empty() {
        let sxx: f64 = x.iter().map(|x| (x - mx).powi(2)).sum();
        let sxf: f64 = x.iter().zip(force).map(|(x, f)| (x - mx) * (f - mf)).sum();
        if sxx > 0.0 { sxf / sxx } else { 0.0 }
    } else {
        0.0
    };
    let (mut power, mut ff, mut vv) = (0.0, 0.0, 0.0);
    for i in 1..x.len() {
        let dt = time[i] - time[i - 1];
        let f = 0.5 * (force[i] + force[i - 1]) - mf - stiffness * (0.5 * (x[i] + x[i - 1]) - mx);
        let w = 0.5 * (v[i] + v[i - 1]);
        power += f * w * dt;
        ff += f * f * dt;
        vv += w * w * dt;
    }
    let power = if ff > 0.0 && vv > 0.0 { power / (ff * vv).sqrt() } else { 0.0 };

    let peak_velocity = crate::cleaning::robust_peak(v, &[]);
    // Both turning points have equal weight, so that friction and hysteresis cancel.
    let at_rest = |top: bool| -> Vec<f64> {
        (0..x.len()).filter(|&i| v[i].abs() < 0.05 * peak_velocity && (x[i] > mx) == top).map(|i| force[i]).collect()
    };
    let (mut top, mut bottom) = (at_rest(true), at_rest(false));
    let force_range = quantile(&mut force.to_vec(), 0.99) - quantile(&mut force.to_vec(), 0.01);
    let level_error = HYSTERESIS * 0.5 * force_range;
    let standstill = (top.len() >= 2 && bottom.len() >= 2)
        .then(|| (0.5 * (median(&mut top) + median(&mut bottom)), libm::hypot(level_error, offset)));
    Evidence { name: motion.name.clone(), power, standstill, asymmetry: None, growth: None, level_error, peak_velocity }
}

/// Returns the weighted mean force at standstill of the campaign and its uncertainty, N. Returns `None` if no test
/// shows a force at standstill.
///
/// The uncertainties are correlated between tests, so averaging does not reduce them.
fn standstill(evidence: &[Evidence]) -> Option<(f64, f64)> {
    let (mut weights, mut sum, mut spread) = (0.0, 0.0, 0.0);
    for (force, uncertainty) in evidence.iter().filter_map(|e| e.standstill) {
        let weight = uncertainty.powi(-4);
        weights += weight;
        sum += weight * force;
        spread += weight * uncertainty;
    }
    (weights > 0.0).then(|| (sum / weights, spread / weights))
}

/// Returns the median force in one direction, N, at speeds between two fractions of the speed `peak`, m/s. Returns
/// `None` for fewer than [`FEWEST`] samples.
fn level(motion: &CompleteTest, positive: bool, peak: f64, [from, to]: [f64; 2]) -> Option<f64> {
    let span = motion.steady();
    let is_there = |v: f64| (v > 0.0) == positive && (from * peak..=to * peak).contains(&v.abs());
    let mut forces: Vec<f64> = span.filter(|&i| is_there(motion.velocity[i])).map(|i| motion.force[i]).collect();
    (forces.len() >= FEWEST).then(|| median(&mut forces))
}

/// Forces of a test near its peak velocity. A faster test without slow samples, such as a triangular motion, uses them
/// as its forces at low speed.
struct Slow {
    peak: f64,
    /// Median force near the peak velocity, at positive and at negative velocity, N.
    forces: [Option<f64>; 2],
}

impl Slow {
    fn of(motion: &CompleteTest, peak: f64) -> Slow {
        Slow { peak, forces: [true, false].map(|positive| level(motion, positive, peak, [FAST, f64::INFINITY])) }
    }
}

/// Computes the increase of a test's force from low to high speed in each direction, N. Returns `None` if the force at
/// one of the speeds is unknown. `others` supply the force at low speed if the test has no slow samples.
fn growth(motion: &CompleteTest, peak: f64, others: &[Slow]) -> Option<[f64; 2]> {
    let of = |positive: bool| {
        let fast = level(motion, positive, peak, [FAST, f64::INFINITY])?;
        let of_others = || {
            let slow = others.iter().filter(|o| (SLOW[0] * peak..=SLOW[1] * peak).contains(&o.peak));
            let mut forces: Vec<f64> = slow.filter_map(|o| o.forces[usize::from(!positive)]).collect();
            (!forces.is_empty()).then(|| median(&mut forces))
        };
        let slow = level(motion, positive, peak, SLOW).or_else(of_others)?;
        Some(if positive { fast - slow } else { slow - fast })
    };
    Some([of(true)?, of(false)?])
}

/// Returns the natural logarithm of the ratio of force increases at positive and negative velocity, and its
/// uncertainty.
///
/// Both returned values are medians over the tests with a peak velocity of at least half of `fastest`. Returns `None`
/// if the increase is unknown in all these tests. Hysteresis is similar in all tests, so more tests do not reduce the
/// uncertainty.
fn grows(evidence: &[Evidence], fastest: f64) -> Option<(f64, f64)> {
    let mut all: Vec<(f64, f64)> = evidence
        .iter()
        .filter(|e| e.peak_velocity >= 0.5 * fastest)
        .filter_map(|e| {
            let [positive, negative] = e.growth?;
            let error = e.level_error.max(f64::MIN_POSITIVE);
            // An increase below its error is replaced by the error, because the true increase may be as large as the
            // error.
            let (positive, negative) = (positive.max(error), negative.max(error));
            Some((libm::log(positive / negative), libm::hypot(error / positive, error / negative)))
        })
        .collect();
    let mut errors: Vec<f64> = all.iter().map(|one| one.1).collect();
    let mut ratios: Vec<f64> = all.drain(..).map(|one| one.0).collect();
    (!ratios.is_empty()).then(|| (median(&mut ratios), median(&mut errors)))
}

/// Returns the logarithm of the odds that the force is tension positive, from the force at standstill and its
/// uncertainty, N.
///
/// The gas pushes the rod out, and its force has a uniform prior. The error of the force is normally distributed. In
/// the fraction [`TARED`] of the rigs, the force is no evidence, which limits the odds.
fn gas_odds(force: f64, uncertainty: f64) -> f64 {
    // This logistic curve approximates the cumulative normal distribution with an error below 0.01.
    let tension = 1.0 / (1.0 + libm::exp(1.702 * force / uncertainty));
    let tempered = |share: f64| (1.0 - TARED) * share + TARED * 0.5;
    libm::log(tempered(tension) / tempered(1.0 - tension))
}

/// Smallest absolute log odds at which the force at standstill counts as evidence for a direction of the force. The
/// value is a choice: odds of 2.7 to one.
const CLEAR_GAS: f64 = 1.0;

/// Returns the positive direction of the force that the force at standstill indicates. `standstill` is this force and
/// its uncertainty, N. The result does not depend on whether motion and force have consistent signs.
///
/// Returns `None` if the force at standstill is unknown or its evidence is weak (see [`CLEAR_GAS`]).
fn positive_by_gas(standstill: Option<(f64, f64)>) -> Option<Positive> {
    let odds = standstill.map_or(0.0, |(force, uncertainty)| gas_odds(force, uncertainty));
    let positive = if odds > 0.0 { Positive::Rebound } else { Positive::Compression };
    (odds.abs() > CLEAR_GAS).then_some(positive)
}

/// Formats the force at standstill, its uncertainty, and the positive direction that it indicates.
fn describe_standstill(standstill: Option<(f64, f64)>) -> Sentence {
    let Some((force, uncertainty)) = standstill else { return phrases::NO_STANDSTILL.into() };
    let verdict = match positive_by_gas(standstill) {
        Some(Positive::Rebound) => phrases::SPEAKS_FOR_TENSION,
        Some(Positive::Compression) => phrases::SPEAKS_FOR_PUSH,
        None => phrases::TOO_SMALL_TO_TELL,
    };
    Sentence::from(phrases::STANDSTILL)
        .with("force", signed(force))
        .with("error", newtons(uncertainty, 0))
        .with_sentence("verdict", verdict)
}

/// Returns the natural logarithm of the ratio of damping forces at positive and negative velocity. A damping force is
/// the 95 % quantile of the absolute deviation from the force at standstill, N. Returns `None` for fewer than ten
/// samples in a direction.
fn asymmetry(motion: &CompleteTest, standstill: f64) -> Option<f64> {
    let span = motion.steady();
    let side = |positive: bool| -> Option<f64> {
        let mut forces: Vec<f64> = span
            .clone()
            .filter(|&i| (motion.velocity[i] > 0.0) == positive)
            .map(|i| (motion.force[i] - standstill).abs())
            .collect();
        (forces.len() >= 10).then(|| quantile(&mut forces, 0.95))
    };
    let (positive, negative) = (side(true)?, side(false)?);
    (positive > 0.0 && negative > 0.0).then(|| libm::log(positive / negative))
}

/// Formats the names of the tests with seemingly exchanged channels, and the evidence.
fn told_exchanged(evidence: &[Evidence], exchanged: &[(usize, Overtones)]) -> Sentence {
    let names: Vec<&Evidence> = exchanged.iter().map(|(i, _)| &evidence[*i]).collect();
    let clearest = exchanged.iter().max_by(|a, b| a.1.displacement.total_cmp(&b.1.displacement));
    let (shown, overtones) = clearest.map_or(("", None), |(i, o)| (evidence[*i].name.as_str(), Some(o)));
    let percent = |share: Option<f64>| format_decimals(100.0 * share.unwrap_or(0.0), 1);
    Sentence::from(phrases::EXCHANGED)
        .with("count", exchanged.len())
        .with("all", evidence.len())
        .with_sentence("names", list(&names))
        .with("test", shown)
        .with("of_force", percent(overtones.map(|o| o.force)))
        .with("of_displacement", percent(overtones.map(|o| o.displacement)))
}

fn list(names: &[&Evidence]) -> Sentence {
    /// Largest number of tests that the message names. The message states only the number of the other tests, to stay
    /// readable.
    const NAMED: usize = 8;
    let quoted = |e: &&Evidence| Sentence::from(phrases::QUOTED).with("test", &e.name);
    let named = Sentence::list(names.iter().take(NAMED).map(quoted).collect(), phrases::COMMA);
    match names.len().saturating_sub(NAMED) {
        0 => named,
        more => Sentence::from(phrases::AND_MORE).with_sentence("names", named).with("count", more),
    }
}

/// Makes the error for tests that feed energy, with the likely cause.
fn energy_fed(evidence: &[Evidence], standstill: Option<(f64, f64)>, also: Option<Sentence>) -> RecordError {
    let feeding: Vec<&Evidence> = evidence.iter().filter(|e| e.power < -UNCLEAR).collect();
    let dissipating: Vec<&Evidence> = evidence.iter().filter(|e| e.power > UNCLEAR).collect();
    let tests = feeding.iter().map(|e| e.name.clone()).collect();
    if !dissipating.is_empty() {
        let (fewer, more, few) = if feeding.len() <= dissipating.len() {
            (&feeding, dissipating.len(), phrases::FEW_FEED)
        } else {
            (&dissipating, feeding.len(), phrases::FEW_TAKE)
        };
        let cause = Sentence::from(few)
            .with("fewer", fewer.len())
            .with("count", evidence.len())
            .with("more", more)
            .with_sentence("names", list(fewer))
            .with_sentence("apart", phrases::APART)
            .with_any("also", also);
        return RecordError::Implausible(PlausibilityError::FeedsEnergy { cause, tests });
    }
    // All tests feed energy, so force and motion have opposite signs. The gas force may reveal which of the two is
    // wrong.
    let culprit = match positive_by_gas(standstill) {
        Some(Positive::Rebound) => phrases::FLIP_MOTION,
        Some(Positive::Compression) => phrases::FLIP_FORCE,
        None => phrases::FLIP_EITHER,
    };
    let culprit = Sentence::from(culprit).with_sentence("standstill", describe_standstill(standstill));
    let powers: Vec<f64> = feeding.iter().map(|e| e.power).collect();
    let cause = Sentence::from(phrases::ALL_FEED)
        .with("count", feeding.len())
        .with("correlation", format_decimals(median(&mut powers.clone()), 2))
        .with_sentence("culprit", culprit)
        .with_any("also", also);
    RecordError::Implausible(PlausibilityError::FeedsEnergy { cause, tests })
}

fn direction(
    evidence: &[Evidence],
    standstill: Option<(f64, f64)>,
    options: &Options,
    notes: &mut Vec<Note>,
) -> SignFinding {
    let mut reasons = Vec::new();
    // Positive log odds favor rebound positive.
    let gas = standstill.map_or(0.0, |(force, uncertainty)| gas_odds(force, uncertainty));
    reasons.push(describe_standstill(standstill));
    let fastest = evidence.iter().map(|e| e.peak_velocity).fold(0.0, f64::max);
    let mut ratios: Vec<f64> =
        evidence.iter().filter(|e| e.peak_velocity >= 0.5 * fastest).filter_map(|e| e.asymmetry).collect();
    let ratio = (!ratios.is_empty()).then(|| median(&mut ratios));
    let grows = grows(evidence, fastest);
    // The logarithm of the ratio of force increases has a normal distribution about plus or minus the prior, one for
    // each direction. The log odds are then 2 · prior · found ratio / scatter². Use half of these log odds, and odds of
    // at most seven to one, because some dampers are symmetric or resist compression more than rebound. The error of
    // the force increase adds to the scatter of dampers.
    let shape = grows.map_or(0.0, |(ratio, error)| {
        (PRIOR_RATIO * ratio / (RATIO_SCATTER.powi(2) + error.powi(2))).clamp(-MOST_BY_SHAPE, MOST_BY_SHAPE)
    });
    if let Some((ratio, error)) = grows {
        let verdict = match shape {
            s if s > 0.3 => phrases::SPEAKS_FOR_REBOUND,
            s if s < -0.3 => phrases::SPEAKS_FOR_COMPRESSION,
            _ => phrases::TELLS_NOTHING,
        };
        let said = Sentence::from(phrases::ASYMMETRY)
            .with("ratio", format_decimals(libm::exp(ratio), 2))
            .with("error", format_decimals(libm::exp(error), 1))
            .with_sentence("verdict", verdict);
        reasons.push(said);
    }
    if gas.abs() > CLEAR_GAS && shape.abs() > 0.3 && gas.signum() != shape.signum() {
        reasons.push(phrases::CONTRADICT.into());
    }
    if !evidence.iter().any(|e| e.power > UNCLEAR) {
        reasons.push(phrases::NOT_DISSIPATING.into());
    }
    let odds = (gas + shape).clamp(-SUREST, SUREST);
    let found = if odds < 0.0 { Positive::Compression } else { Positive::Rebound };
    // The probability is 0.5 without evidence for either direction.
    let sure = 1.0 / (1.0 + libm::exp(-odds.abs()));
    if options.positive.is_none() && sure < UNSURE {
        let text = Sentence::from(phrases::SIGN_UNSURE)
            .with_word("direction", word(found))
            .with("percent", format_decimals(100.0 * sure, 0))
            .with_list("reasons", reasons.clone(), phrases::SEMICOLON)
            .with("option", format!("--positive {}", found.name()));
        notes.push(Note { kind: "sign_unsure", text });
        reasons.push(phrases::WEAK.into());
    }
    let (positive, given, confidence) = match options.positive {
        Some(positive) => {
            if positive != found && sure > 0.9 {
                notes.push(Note {
                    kind: "sign",
                    text: Sentence::from(phrases::AGAINST_GIVEN).with_word("direction", word(positive)).with_list(
                        "reasons",
                        reasons.clone(),
                        phrases::SEMICOLON,
                    ),
                });
            }
            reasons.insert(0, Sentence::from(phrases::GIVEN).with_word("direction", word(positive)));
            (positive, true, 1.0)
        }
        None => (found, false, sure),
    };
    let turn = if positive == Positive::Compression { -1.0 } else { 1.0 };
    // A tensile force at standstill would mean that the gas pulls the rod in.
    if let Some((force, uncertainty)) = standstill
        && turn * force > 2.0 * uncertainty
    {
        let pull = Sentence::from(phrases::NEGATIVE_GAS).with("force", newtons(force.abs(), 0));
        if !given {
            notes.push(Note { kind: "sign_unsure", text: pull.clone() });
        }
        reasons.push(pull);
    }
    SignFinding {
        positive,
        is_stated: given,
        confidence,
        reasons,
        standstill_force: turn * standstill.map_or(0.0, |s| s.0),
        asymmetry: ratio.map(|r| libm::exp(turn * r)),
    }
}

fn word(positive: Positive) -> &'static str {
    match positive {
        Positive::Rebound => "rebound",
        Positive::Compression => "compression",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cleaning;
    use crate::fixtures::SineTest;
    use crate::quantities::channel::Channel;
    use crate::quantities::unit::Unit;

    #[test]
    fn eight_tests_are_named_and_the_others_counted() {
        let of = |k: usize| Evidence {
            name: format!("t{k}"),
            power: 0.0,
            standstill: None,
            asymmetry: None,
            growth: None,
            level_error: 0.0,
            peak_velocity: 0.0,
        };
        let all: Vec<Evidence> = (1..=10).map(of).collect();
        let names: Vec<&Evidence> = all.iter().collect();
        let eight = "'t1', 't2', 't3', 't4', 't5', 't6', 't7', 't8'";
        assert_eq!(list(&names[..8]).to_string(), eight);
        assert_eq!(list(&names).to_string(), format!("{eight} and 2 more"));
    }

    /// Makes three tests of one damper, recorded by a rig that multiplies force and motion by the given signs.
    /// `preload` is the force at standstill, N.
    fn campaign(force: f64, motion: f64, preload: f64) -> Vec<CompleteTest> {
        campaign_read(force, motion, preload, &Options::default())
    }

    fn campaign_read(force: f64, motion: f64, preload: f64, options: &Options) -> Vec<CompleteTest> {
        [0.02, 0.4, 2.0]
            .iter()
            .enumerate()
            .map(|(k, &frequency)| {
                let mut samples = SineTest { frequency, preload, seed: k as u64, ..SineTest::default() }.samples();
                samples.name = format!("test{k}");
                samples.force.iter_mut().for_each(|f| *f *= force);
                for channel in [&mut samples.displacement, &mut samples.velocity].into_iter().flatten() {
                    channel.iter_mut().for_each(|x| *x *= motion);
                }
                cleaning::repair(samples, options).unwrap()
            })
            .collect()
    }

    fn settled(
        mut motions: Vec<CompleteTest>,
        options: &Options,
    ) -> Result<(SignFinding, Vec<CompleteTest>, Vec<Note>), RecordError> {
        let mut notes = Vec::new();
        determine(&mut motions, options, &mut notes).map(|(finding, _)| (finding, motions, notes))
    }

    #[test]
    fn both_conventions_end_rebound_positive_and_dissipate() {
        let (rebound, reference, _) = settled(campaign(1.0, 1.0, -150.0), &Options::default()).unwrap();
        assert_eq!(rebound.positive, Positive::Rebound);
        let (compression, turned, _) = settled(campaign(-1.0, -1.0, -150.0), &Options::default()).unwrap();
        assert_eq!(compression.positive, Positive::Compression);
        for finding in [&rebound, &compression] {
            assert!(finding.confidence > 0.95 && !finding.is_stated, "{finding:?}");
            assert!((finding.standstill_force + 150.0).abs() < 15.0, "{finding:?}");
            assert!(finding.asymmetry.unwrap() > 1.2, "{finding:?}");
        }
        for (a, b) in reference.iter().zip(&turned) {
            assert_eq!((&a.force, &a.velocity, &a.displacement), (&b.force, &b.velocity, &b.displacement));
            let power: f64 = a.force.iter().zip(&a.velocity).map(|(f, v)| f * v).sum();
            assert!(power > 0.0);
        }
    }

    #[test]
    fn a_damper_that_feeds_energy_is_refused_with_the_likely_cause() {
        let cases = [
            (-1.0, 1.0, "--flip force", Options { flip_force: true, ..Options::default() }, Positive::Rebound),
            (1.0, -1.0, "--flip motion", Options { flip_motion: true, ..Options::default() }, Positive::Rebound),
            // A reversal of the motion also makes the signs consistent. Force and motion are then positive in
            // compression.
            (-1.0, 1.0, "--flip force", Options { flip_motion: true, ..Options::default() }, Positive::Compression),
        ];
        for (force, motion, advice, cure, positive) in cases {
            let error = settled(campaign(force, motion, -150.0), &Options::default()).unwrap_err().to_string();
            assert!(error.contains("feed energy") && error.contains("all 3 tests"), "{error}");
            assert!(error.contains(&format!("Give {advice} (or")), "{error}");
            let (finding, motions, _) = settled(campaign_read(force, motion, -150.0, &cure), &cure).unwrap();
            assert_eq!(finding.positive, positive);
            let reference = campaign(1.0, 1.0, -150.0);
            assert_eq!(motions[1].force, reference[1].force);
            assert_eq!(motions[1].velocity, reference[1].velocity);
        }
        let error = settled(campaign(-1.0, 1.0, 0.0), &Options::default()).unwrap_err().to_string();
        assert!(error.contains("too small to tell"), "{error}");
    }

    #[test]
    fn a_force_at_standstill_is_judged_alike_whether_or_not_the_damper_feeds_energy() {
        let mut judged = Vec::new();
        for preload in [-150.0, -60.0, -30.0, -15.0, -5.0, 0.0] {
            let (finding, ..) = settled(campaign(1.0, 1.0, preload), &Options::default()).unwrap();
            let is_clear = finding.reasons[0].to_string().contains("speaks for tension");
            for (force, motion, flag) in [(-1.0, 1.0, "--flip force"), (1.0, -1.0, "--flip motion")] {
                let error = settled(campaign(force, motion, preload), &Options::default()).unwrap_err().to_string();
                assert!(error.contains("force at standstill is"), "{error}");
                assert_eq!(error.contains(&format!("Give {flag} (or")), is_clear, "{preload}: {error}");
                assert_eq!(error.contains("too small to tell"), !is_clear, "{preload}: {error}");
            }
            judged.push(is_clear);
        }
        assert!(judged.contains(&true) && judged.contains(&false));
    }

    /// Makes tests of a nonlinear damper, some of them with exchanged force and displacement. The units stay the same,
    /// and `sign` multiplies the displacement that is read as force.
    fn exchanged_campaign(exchanged: &[bool], sign: f64) -> Vec<CompleteTest> {
        let mut motions = Vec::new();
        for (k, &swap) in exchanged.iter().enumerate() {
            let mut samples = SineTest { frequency: 0.5 + 0.5 * k as f64, ..SineTest::default() }.samples();
            samples.name = format!("test{k}");
            samples.velocity = None;
            if swap {
                let x = samples.displacement.as_mut().unwrap();
                x.iter_mut().for_each(|x| *x *= sign * 1e3);
                samples.force.iter_mut().for_each(|f| *f *= 1e-4);
                std::mem::swap(x, &mut samples.force);
            }
            // The stated unit confirms the headings, so `swapped_columns::reject` does not reject the test first.
            let options = Options { units: [(Channel::Force, Unit::Newton)].into(), ..Options::default() };
            motions.push(cleaning::repair(samples, &options).unwrap());
        }
        motions
    }

    #[test]
    fn exchanged_channels_are_told_before_a_sign_or_a_delay_is_blamed() {
        for which in [[true, true, true], [true, false, false]] {
            let error = settled(exchanged_campaign(&which, 1.0), &Options::default()).unwrap_err();
            let RecordError::Implausible(PlausibilityError::Exchanged { tests, .. }) = &error else {
                panic!("{error}")
            };
            assert_eq!(tests.len(), which.iter().filter(|w| **w).count());
            let text = error.to_string();
            assert!(text.contains("look exchanged") && !text.contains("--delay") && !text.contains("--flip"), "{text}");
        }
        // With exchanged channels and a reversed sign, the damper dissipates. The tests are accepted, but the direction
        // is uncertain.
        let (finding, _, notes) = settled(exchanged_campaign(&[true; 3], -1.0), &Options::default()).unwrap();
        assert!(finding.confidence <= 0.5 && notes.iter().any(|n| n.kind == "exchanged"), "{finding:?}");
        let (finding, _, notes) = settled(exchanged_campaign(&[false; 3], 1.0), &Options::default()).unwrap();
        assert!(finding.confidence > 0.5 && notes.iter().all(|n| n.kind != "exchanged"), "{finding:?}");
    }

    #[test]
    fn a_late_force_is_told_and_left_as_it_is() {
        for (late, feeds) in [(0.015, false), (0.045, true)] {
            let mut motions: Vec<CompleteTest> = [0.5, 3.0, 9.0]
                .iter()
                .map(|&frequency| {
                    let test = SineTest { frequency, amplitude: 0.1 / (1.0 + 4.0 * frequency), ..SineTest::default() };
                    let mut samples = test.samples();
                    let steps = (late * frequency * test.per_cycle as f64).round() as usize;
                    samples.force.rotate_right(steps);
                    cleaning::repair(samples, &Options::default()).unwrap()
                })
                .collect();
            assert_eq!(motions.iter().map(|m| gather(m, 15.0)).any(|e| e.power < -UNCLEAR), feeds);
            let (before, mut notes) = (motions.clone(), Vec::new());
            let (sign, found) = determine(&mut motions, &Options::default(), &mut notes).unwrap();
            assert!((found.unwrap().seconds - late).abs() < 1e-3, "{found:?}");
            assert!(sign.positive == Positive::Rebound && sign.confidence > 0.9, "{sign:?}");
            assert_eq!(before[2].force, motions[2].force);
            assert_eq!(before[2].velocity, motions[2].velocity);
            let note = notes.iter().find(|n| n.kind == "late").unwrap();
            let text = note.text.to_string();
            assert!(text.contains("--delay 0.0") && text.contains("would feed energy") == feeds, "{text}");
        }
    }

    #[test]
    fn single_tests_that_feed_energy_are_named() {
        let mut motions = campaign(1.0, 1.0, -150.0);
        motions[1].force.iter_mut().for_each(|f| *f = -*f);
        match settled(motions, &Options::default()).unwrap_err() {
            RecordError::Implausible(PlausibilityError::FeedsEnergy { cause, tests }) => {
                assert_eq!(tests, ["test1"]);
                let cause = cause.to_string();
                assert!(cause.contains("'test1'") && cause.contains("1 of 3"), "{cause}");
            }
            other => panic!("{other}"),
        }
    }

    /// Finds the positive direction of a device in sine or triangular motion at three speeds. `force` computes the
    /// force, N, from the velocity, m/s.
    fn device(triangle: bool, force: impl Fn(f64) -> f64) -> SignFinding {
        let motions: Vec<CompleteTest> = [0.4, 1.5, 2.0]
            .iter()
            .map(|&frequency| {
                let mut samples = SineTest { frequency, ..SineTest::default() }.samples();
                if triangle {
                    let (x, v) = (samples.displacement.as_mut().unwrap(), samples.velocity.as_mut().unwrap());
                    let (mut place, step) = (0.01, samples.time[1] - samples.time[0]);
                    for (x, v) in x.iter_mut().zip(v) {
                        // The speed of the triangular motion is the mean speed of the sine, with its sign. Zero
                        // velocity stays zero.
                        *v = if *v == 0.0 { 0.0 } else { (4.0 * 0.05 * frequency).copysign(*v) };
                        place += step * *v;
                        *x = place;
                    }
                }
                for (f, v) in samples.force.iter_mut().zip(samples.velocity.as_ref().unwrap()) {
                    *f = force(*v);
                }
                cleaning::repair(samples, &Options::default()).unwrap()
            })
            .collect();
        settled(motions, &Options::default()).unwrap().0
    }

    #[test]
    fn friction_tells_no_direction_however_unlike_its_sides_are() {
        for triangle in [false, true] {
            // The friction is sixty percent larger at positive velocity, and nearly independent of speed.
            let rubs = |v: f64| (if v > 0.0 { 800.0 } else { 500.0 }) * libm::tanh(v / 0.002) + 40.0 * v;
            let finding = device(triangle, |v| rubs(v) - 150.0);
            assert!(finding.confidence < 0.62, "{triangle} {finding:?}");
            assert!(finding.reasons.iter().any(|r| r.to_string().contains("tells nothing")), "{finding:?}");
            // An additional valve that is harder in the other direction determines the sign.
            let valve = device(triangle, |v| rubs(v) - 150.0 + if v > 0.0 { 600.0 * v } else { 2400.0 * v });
            assert!(valve.positive == Positive::Compression && valve.confidence > 0.55, "{triangle} {valve:?}");
        }
    }

    #[test]
    fn no_direction_that_was_worked_out_is_certain() {
        let (sure, ..) = settled(campaign(1.0, 1.0, -2000.0), &Options::default()).unwrap();
        assert!((0.95..0.9901).contains(&sure.confidence), "{sure:?}");
        assert!(gas_odds(-1e6, 20.0) < 3.7 && (gas_odds(30.0, 20.0) + gas_odds(-30.0, 20.0)).abs() < 1e-9);
    }

    #[test]
    fn what_the_user_says_counts_and_doubt_is_told() {
        let options = Options { positive: Some(Positive::Compression), ..Options::default() };
        let (finding, motions, notes) = settled(campaign(1.0, 1.0, -150.0), &options).unwrap();
        assert!(finding.is_stated && finding.confidence == 1.0);
        assert!(notes.iter().any(|n| n.kind == "sign" && n.text.to_string().contains("speak for the opposite")));
        assert_eq!(motions[0].force[7], -campaign(1.0, 1.0, -150.0)[0].force[7]);

        // Without a gas force, the only evidence is the asymmetry, so the direction is uncertain.
        let (weak, ..) = settled(campaign(1.0, 1.0, 0.0), &Options::default()).unwrap();
        assert!((0.5..0.93).contains(&weak.confidence) && weak.positive == Positive::Rebound, "{weak:?}");
        // The gas force contradicts the asymmetry.
        let (torn, ..) = settled(campaign(1.0, 1.0, 60.0), &Options::default()).unwrap();
        assert!(torn.reasons.iter().any(|r| r.to_string().contains("contradict")), "{torn:?}");
    }

    /// Checks dampers with 150 N of gas whose load cell has a zero of its own, in both conventions of the rig.
    #[test]
    fn a_shifted_zero_of_the_load_cell_is_never_sure() {
        for zero in [200.0, 300.0, 400.0, 800.0] {
            for sign in [1.0, -1.0] {
                let (finding, _, notes) = settled(campaign(sign, sign, zero - 150.0), &Options::default()).unwrap();
                assert!(finding.confidence < UNSURE, "{zero} {sign}: {finding:?}");
                let warning = notes.iter().find(|note| note.kind == "sign_unsure").unwrap().text.to_string();
                assert!(warning.contains("contradict") && warning.contains("--positive"), "{warning}");
            }
        }
    }

    #[test]
    fn the_force_at_a_speed_is_the_median_of_ten_samples() {
        let force = |samples: usize| {
            let mut motion = cleaning::repair(SineTest::default().samples(), &Options::default()).unwrap();
            let from = motion.steady().start;
            motion.velocity.fill(0.0);
            motion.velocity[from..from + samples].fill(0.3);
            level(&motion, true, 1.0, SLOW)
        };
        assert!(force(12).is_some() && force(8).is_none());
    }
}
