//! A case: the injected effects with their severities, the measurement, and the diagnosed model.

use crate::SeverityError;
use crate::context;
use crate::measured::{base_model, read, without_noise};
use dashpot_core::Params;
use dashpot_core::{element, number};
use dashpot_identification::{FitOptions, fit, to_measurement_error};
use dashpot_records::Record;
use dashpot_records::measurement_correction::correct_record;
use dashpot_rig::{CHECK_PREFIX, InjectedCampaign, InjectedCase, Matrix, Options, Plan, TestPoint, Truth};

/// Specification of a campaign with injected effects, and of its base model.
#[derive(Debug, Clone)]
pub struct Case {
    /// Names of the injected effects with their severities, in units of the noise; `name:form` selects a form.
    pub effects: Vec<(String, f64)>,
    /// Plan of the tests.
    pub plan: Plan,
    /// Options of the rig: seed, noise, channels.
    pub options: Options,
    /// Whether the base model's FV curve is piecewise linear, regardless of the damper's curve.
    pub linear_curve: bool,
    /// Whether the base model is a user's fit with all elements.
    pub whole_fit: bool,
}

/// A measured case with its identified base model.
pub struct Measured {
    /// The noisy records, read from files.
    pub records: Vec<Record>,
    /// The records without noise, at the same samples.
    pub clean: Vec<Record>,
    /// Whether each test is excluded from all refits.
    pub left_out: Vec<bool>,
    /// The identified base model.
    pub base: Params,
    /// Names of the measurement errors that the fit found. The records are corrected for them, as on the command line.
    pub taken_out: Vec<&'static str>,
    /// Strengths of the injected effects; 1 is a typical strong case.
    pub strengths: Vec<f64>,
    /// The injected effects and the parameters of the damper.
    pub truth: Truth,
    /// Effects with a visible change of force if they are removed from the simulator. `None` for the first virtual rig,
    /// because its dampers have only the injected effects.
    pub true_set: Option<Vec<String>>,
}

impl Case {
    /// Makes a case without injected effects, with 2 % noise.
    pub fn nothing(seed: u64) -> Case {
        let options = Options { seed, noise_percent: 2.0, threads: Some(1), ..Options::default() };
        Case { effects: Vec::new(), plan: Plan::Diagnosis, options, linear_curve: false, whole_fit: false }
    }

    /// Adds an effect to be injected with a severity.
    #[must_use]
    pub fn hiding(mut self, effect: &str, severity: f64) -> Case {
        self.effects.push((effect.to_owned(), severity));
        self
    }

    fn hides_side_force(&self) -> bool {
        self.effects.iter().any(|(name, _)| name.starts_with("side_force_friction"))
    }

    fn at(
        &self,
        strengths: &[f64],
        more: &[TestPoint],
        watch: &dyn Fn(usize, usize),
    ) -> Result<InjectedCampaign, SeverityError> {
        let effects = self.effects.iter().zip(strengths).map(|((name, _), s)| (name.clone(), *s)).collect();
        let case = InjectedCase { effects, plan: self.plan, options: self.options.clone() };
        let planned = self.plan.matrix(self.options.order.unwrap_or(self.options.seed));
        if more.is_empty() {
            return Ok(case.run_matrix(&planned, watch)?);
        }
        let matrix = Matrix::new(planned.points().iter().chain(more).cloned().collect())?;
        Ok(case.run_matrix(&matrix, watch)?)
    }

    /// Finds the strength for each severity, with each effect alone. The severity of all effects together may differ.
    ///
    /// # Errors
    /// Errors of rig, reader or fit, or a severity that no strength reaches.
    pub fn strengths(&self) -> Result<Vec<f64>, SeverityError> {
        self.strengths_watched(&|_, _| ())
    }

    /// Finds the strength for each severity. For every trial strength, `watch` receives the number of measured tests
    /// and of all tests.
    ///
    /// # Errors
    /// The errors of [`Case::strengths`].
    pub fn strengths_watched(&self, watch: &dyn Fn(usize, usize)) -> Result<Vec<f64>, SeverityError> {
        let mut strengths = vec![0.0; self.effects.len()];
        if self.effects.iter().all(|(_, wanted)| *wanted <= 0.0) {
            return Ok(strengths);
        }
        let neutral = self.at(&strengths, &[], watch)?;
        let ground =
            context::SeverityContext::new(&neutral.campaign, self.options.noise_percent, !self.hides_side_force())?;
        for (k, (name, wanted)) in self.effects.iter().enumerate() {
            let mut alone = vec![0.0; self.effects.len()];
            let found = ground.strength(name, *wanted, |strength| {
                alone[k] = strength;
                Ok(self.at(&alone, &[], watch)?.campaign)
            });
            strengths[k] = match found {
                // With a sparse plan, no strength may reach the severity. The typical strength of 1 is then used.
                Err(SeverityError::OutOfReach { .. }) if self.plan != Plan::Diagnosis => 1.0,
                other => other?,
            };
        }
        Ok(strengths)
    }

    /// Finds the strengths, measures, and identifies the base model.
    ///
    /// # Errors
    /// Errors of rig, reader or fit, or a severity that no strength reaches.
    pub fn measure(&self) -> Result<Measured, SeverityError> {
        self.measure_at(self.strengths()?, &[])
    }

    /// Measures the tests of the plan and the tests `more` at known strengths, and identifies the base model.
    ///
    /// # Errors
    /// Errors of rig, reader or fit.
    pub fn measure_at(&self, strengths: Vec<f64>, more: &[TestPoint]) -> Result<Measured, SeverityError> {
        let hidden = self.at(&strengths, more, &|_, _| ())?;
        let noisy = read(&hidden.campaign)?;
        let clean = read(&without_noise(&hidden.campaign))?;
        let held_out: Vec<bool> = noisy.iter().map(|r| r.name.starts_with(CHECK_PREFIX)).collect();
        let seen: Vec<&Record> = noisy.iter().zip(&held_out).filter(|(_, out)| !**out).map(|(r, _)| r).collect();
        let (mut base, measured) = model_of(&seen, self.whole_fit)?;
        if self.hides_side_force() {
            base.enable(element!("side_force_friction"), false);
        }
        if self.linear_curve {
            let _ = base.set(number!("fv_interpolation"), 1.0);
        }
        let mut found = Measured {
            records: noisy,
            clean,
            left_out: held_out,
            base,
            taken_out: Vec::new(),
            strengths,
            truth: hidden.truth,
            true_set: None,
        };
        found.take_out(&measured);
        Ok(found)
    }
}

impl Measured {
    /// Corrects the records for the measurement errors that the fit found, as the command line does.
    pub fn take_out(&mut self, measured: &[dashpot_identification::Measured]) {
        let off = to_measurement_error(measured);
        for record in self.records.iter_mut().chain(&mut self.clean) {
            *record = correct_record(record, &off);
        }
        self.taken_out = measured.iter().filter_map(dashpot_identification::Measured::effect).collect();
    }
}

/// Identifies the diagnosed model, with the measurement errors that the fit found.
///
/// With `whole_fit`, the model is a user's fit with all elements. Otherwise, it is [`base_model`], and the list of
/// measurement errors is empty, so the records are not corrected.
pub fn model_of(
    records: &[&Record],
    whole_fit: bool,
) -> Result<(Params, Vec<dashpot_identification::Measured>), SeverityError> {
    if !whole_fit {
        return Ok((base_model(records)?, Vec::new()));
    }
    let found = fit(records, &FitOptions::default(), |_| ())?;
    Ok((found.params, found.measured))
}
