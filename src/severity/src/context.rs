//! Severity: what refitting the base model cannot absorb of an effect, in units of the noise; and the strength that makes
//! it.
//!
//! The neutral damper too leaves something, since the base model's form is not quite its own. Severity is the root mean
//! square of the difference between what the two leave: a difference of two such figures would count where the effect
//! happens to point along what is left anyway.

use crate::SeverityError;
use crate::measured::{base_model, read, without_noise};
use dashpot_core::Params;
use dashpot_core::element;
use dashpot_diagnosis::refitted;
use dashpot_records::Record;
use dashpot_rig::{CHECK_PREFIX, Campaign};

/// How near the severity must come.
const NEAR: f64 = 0.08;
/// Most strengths tried.
const TRIES: usize = 7;
/// Strengths a case may have.
const STRENGTHS: (f64, f64) = (1e-3, 12.0);
/// Constant part of the rig's force noise, N.
const LEAST_NOISE: f64 = 0.5;

/// The neutral damper's campaign, relative to which the severity of an effect is measured.
pub struct SeverityContext {
    /// The base model refitted to it.
    base: Params,
    /// Noise of each record, N.
    noise: Vec<f64>,
    /// What the base model leaves of it, in units of the noise.
    own: Vec<f64>,
}

/// The base model identified from records, with friction by side force or without.
fn identified(records: &[&Record], knows_side_force: bool) -> Result<Params, SeverityError> {
    let mut base = base_model(records)?;
    // A name of the kernel's own list.
    base.enable(element!("side_force_friction"), knows_side_force);
    Ok(base)
}

fn seen(records: &[Record]) -> Vec<&Record> {
    records.iter().filter(|r| !r.name.starts_with(CHECK_PREFIX)).collect()
}

impl SeverityContext {
    /// From the neutral damper's campaign; `knows_side_force` where the model diagnosed has friction by side force.
    ///
    /// # Errors
    /// What reader or fit refuse.
    pub fn new(neutral: &Campaign, percent: f64, knows_side_force: bool) -> Result<SeverityContext, SeverityError> {
        let clean = read(&without_noise(neutral))?;
        let records = seen(&clean);
        let base = identified(&records, knows_side_force)?;
        let noise: Vec<f64> = records
            .iter()
            .map(|r| {
                let rms = (r.force.iter().map(|f| f * f).sum::<f64>() / r.force.len().max(1) as f64).sqrt();
                0.01 * percent * rms + LEAST_NOISE
            })
            .collect();
        let (base, own) = refitted(&records, &noise, &base).ok_or(SeverityError::NotFinite)?;
        Ok(SeverityContext { base, noise, own })
    }

    /// Severity of a campaign; where it is not above `wanted`, no less than it.
    ///
    /// The refit goes on from the neutral damper's model. Where that leaves more than is wanted, a model identified from
    /// nothing is refitted as well, and what leaves less counts: friction in the FV curve behind the series spring is an
    /// elastic contact, which a model with friction beside them never turns into step by step.
    ///
    /// # Errors
    /// What reader or fit refuse.
    pub fn severity(&self, campaign: &Campaign, wanted: f64) -> Result<f64, SeverityError> {
        let clean = read(&without_noise(campaign))?;
        let records = seen(&clean);
        let from_neutral = self.left(&records, &self.base)?;
        if from_neutral <= wanted * (1.0 + NEAR) {
            return Ok(from_neutral);
        }
        let afresh = identified(&records, self.base.is_on(element!("side_force_friction")))?;
        Ok(self.left(&records, &afresh)?.min(from_neutral))
    }

    /// What refitting a model leaves beyond what it leaves of the neutral damper.
    fn left(&self, records: &[&Record], model: &Params) -> Result<f64, SeverityError> {
        let (_, left) = refitted(records, &self.noise, model).ok_or(SeverityError::NotFinite)?;
        if left.len() != self.own.len() {
            return Err(SeverityError::OtherSamples);
        }
        let of_effect: f64 = left.iter().zip(&self.own).map(|(with, without)| (with - without).powi(2)).sum();
        Ok((of_effect / left.len().max(1) as f64).sqrt())
    }

    /// The strength at which an effect has the severity asked for.
    ///
    /// # Errors
    /// What rig or reader refuse; a severity out of reach.
    pub fn strength(
        &self,
        effect: &str,
        wanted: f64,
        mut campaign: impl FnMut(f64) -> Result<Campaign, SeverityError>,
    ) -> Result<f64, SeverityError> {
        if wanted <= 0.0 {
            return Ok(0.0);
        }
        // The trace grows steadily with strength: regula falsi on logarithms, inside what is known.
        let (mut low, mut high) = (None::<(f64, f64)>, None::<(f64, f64)>);
        let mut strength: f64 = 0.3;
        let mut best = (f64::INFINITY, strength, 0.0);
        for _ in 0..TRIES {
            let found = self.severity(&campaign(strength)?, wanted)?.max(1e-3);
            let off = libm::log(found / wanted);
            if off.abs() < best.0 {
                best = (off.abs(), strength, found);
            }
            if off.abs() < NEAR {
                return Ok(strength);
            }
            if off < 0.0 {
                low = Some((libm::log(strength), off));
            } else {
                high = Some((libm::log(strength), off));
            }
            let next = match (low, high) {
                (Some((a, fa)), Some((b, fb))) => a + (b - a) * (-fa / (fb - fa)).clamp(0.15, 0.85),
                (Some((a, fa)), None) => a - fa.max(-2.3),
                (None, Some((b, fb))) => b - fb.min(3.5),
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
        Err(SeverityError::OutOfReach { effect: effect.to_owned(), reached: best.2, wanted })
    }
}
