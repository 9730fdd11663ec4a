//! Severity of an effect: the rms force that a refit of the base model cannot absorb, relative to the noise.
//!
//! [`SeverityContext::strength`] finds the strength at which an injected effect has a requested severity.
//!
//! The neutral damper, without injected effects, also has a residual, because its form differs from that of the base
//! model. Severity is therefore the root mean square of the difference between the residual with the effect and the
//! neutral residual. A difference of two root mean squares would depend on the direction of the effect relative to the
//! neutral residual.

use crate::SeverityError;
use crate::measured::{base_model, read, without_noise};
use dashpot_core::Params;
use dashpot_core::element;
use dashpot_diagnosis::refitted;
use dashpot_records::Record;
use dashpot_rig::{CHECK_PREFIX, Campaign};

/// Absolute natural logarithm of the ratio of found to requested severity below which the search for the strength ends.
const NEAR: f64 = 0.08;
/// Largest number of trial strengths.
const TRIES: usize = 7;
/// Range of trial strengths. A strength of 1 is a typical strong case.
const STRENGTHS: (f64, f64) = (1e-3, 12.0);
/// Constant part of the standard deviation of the rig's force noise, N.
const LEAST_NOISE: f64 = 0.5;

/// The neutral damper's campaign, relative to which the severity of an effect is measured.
pub struct SeverityContext {
    /// The base model refitted to the campaign of the neutral damper.
    base: Params,
    /// Standard deviation of the force noise of each record, N.
    noise: Vec<f64>,
    /// Residual of the base model for the campaign of the neutral damper, relative to the noise.
    own: Vec<f64>,
}

/// Identifies the base model from records, with or without side force friction.
fn identified(records: &[&Record], knows_side_force: bool) -> Result<Params, SeverityError> {
    let mut base = base_model(records)?;
    base.enable(element!("side_force_friction"), knows_side_force);
    Ok(base)
}

fn seen(records: &[Record]) -> Vec<&Record> {
    records.iter().filter(|r| !r.name.starts_with(CHECK_PREFIX)).collect()
}

impl SeverityContext {
    /// Makes the context from the campaign of the neutral damper, which has no injected effect. The noise of a record
    /// has a standard deviation of `percent` percent of its rms force, plus 0.5 N. `knows_side_force` is true if the
    /// diagnosed model has side-force friction.
    ///
    /// # Errors
    /// Errors of reader or fit.
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

    /// Computes the severity of a campaign, relative to the noise. A result above `wanted` may be too large.
    ///
    /// The refit starts from the neutral damper's model. If its result exceeds `wanted`, a newly identified model is
    /// refitted as well, and the smaller of both residuals is returned. For example, friction in the FV curve behind
    /// the series spring acts like an elastic contact. The refit of a model with parallel friction cannot reach that
    /// form.
    ///
    /// # Errors
    /// Errors of reader or fit.
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

    /// Refits a model and computes the root mean square difference of its residual from that of the neutral damper,
    /// relative to the noise.
    fn left(&self, records: &[&Record], model: &Params) -> Result<f64, SeverityError> {
        let (_, left) = refitted(records, &self.noise, model).ok_or(SeverityError::NotFinite)?;
        if left.len() != self.own.len() {
            return Err(SeverityError::OtherSamples);
        }
        let of_effect: f64 = left.iter().zip(&self.own).map(|(with, without)| (with - without).powi(2)).sum();
        Ok((of_effect / left.len().max(1) as f64).sqrt())
    }

    /// Finds the strength at which an effect has the requested severity. `campaign` measures the damper at a trial
    /// strength. If the trials end without such a strength, the best trial counts if its logarithmic deviation is below
    /// 0.35. Returns 0 for a severity of 0 or less.
    ///
    /// # Errors
    /// Errors of rig or reader, or a severity that no strength reaches.
    pub fn strength(
        &self,
        effect: &str,
        wanted: f64,
        mut campaign: impl FnMut(f64) -> Result<Campaign, SeverityError>,
    ) -> Result<f64, SeverityError> {
        if wanted <= 0.0 {
            return Ok(0.0);
        }
        // The severity grows continuously with strength, so use regula falsi on logarithms, inside the bracket of `low`
        // and `high`.
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
