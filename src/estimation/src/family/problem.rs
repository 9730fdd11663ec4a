//! The least-squares problem of a damper at several settings: one block of residuals for each setting.

use crate::deviations::sandwich_of;
use crate::hypothesis::{Hypothesis, Number, Residual};
use crate::prior_set::PriorSet;
use crate::refit::{Effort, Refit, options};
use crate::samples::Test;
use crate::sensitivity::Accuracy;
use crate::solve::{Bounds, Residuals, Rows, solve_knowing};
use dashpot_core::Params;
use nalgebra::{DMatrix, DVector};

/// The tests of one setting.
#[derive(Debug, Clone)]
pub struct SettingTests {
    /// Value of the setting.
    pub value: f64,
    /// Tests at the setting.
    pub tests: Vec<Test>,
}

/// A damper at several settings: an ordinary hypothesis in which some parameters have a separate value at each setting.
#[derive(Debug, Clone)]
pub struct FamilyHypothesis {
    /// The damper at one setting, with its free parameters.
    pub template: Hypothesis,
    /// For each free parameter, whether it has a separate value at each setting. Otherwise, all settings share one
    /// value.
    pub varies: Vec<bool>,
    /// Start of the parameters at each setting. The start of a shared parameter is its value at the first setting.
    pub starts: Vec<Vec<f64>>,
}

/// Result of a refit of a family.
#[derive(Debug, Clone)]
pub struct FamilyRefit {
    /// The parameters, in the order of [`FamilyHypothesis::numbers`].
    pub theta: Vec<f64>,
    /// Weighted residuals of each setting, measured minus computed.
    pub residuals: Vec<Residual>,
    /// Derivatives of the weighted computed forces of each setting with respect to all parameters of the family.
    pub jacobians: Vec<DMatrix<f64>>,
}

impl FamilyHypothesis {
    /// Returns the number of settings.
    pub fn settings(&self) -> usize {
        self.starts.len()
    }

    /// Returns the index of each free parameter at each setting. The index refers to the vector of the family.
    pub fn columns(&self) -> Vec<Vec<usize>> {
        let settings = self.settings();
        let mut columns = vec![Vec::with_capacity(self.varies.len()); settings];
        let mut next = 0;
        for varies in &self.varies {
            for (setting, column) in columns.iter_mut().enumerate() {
                column.push(next + if *varies { setting } else { 0 });
            }
            next += if *varies { settings } else { 1 };
        }
        columns
    }

    /// Returns the length of the family's parameter vector.
    pub fn len(&self) -> usize {
        self.varies.iter().map(|varies| if *varies { self.settings() } else { 1 }).sum()
    }

    /// Returns whether the family has no free parameters.
    pub fn is_empty(&self) -> bool {
        self.varies.is_empty()
    }

    /// Returns the start of the family as a vector.
    pub fn start(&self) -> Vec<f64> {
        let mut start = vec![0.0; self.len()];
        for (column, values) in self.columns().iter().zip(&self.starts).rev() {
            for (place, value) in column.iter().zip(values) {
                start[*place] = *value;
            }
        }
        start
    }

    /// Returns the free parameters of the family, one for each element of its vector.
    pub fn numbers(&self) -> Vec<Number> {
        let start = self.start();
        let mut numbers = Vec::with_capacity(start.len());
        for (number, varies) in self.template.numbers.iter().zip(&self.varies) {
            for _ in 0..if *varies { self.settings() } else { 1 } {
                numbers.push(Number { start: start[numbers.len()], ..number.clone() });
            }
        }
        numbers
    }

    /// Returns all free parameters as one hypothesis, for functions that need only parameters and priors. The
    /// hypothesis gives no forces.
    pub fn joint(&self) -> Hypothesis {
        Hypothesis { base: self.template.base, numbers: self.numbers(), heating: None, priors: PriorSet::default() }
    }

    /// Returns the parameters of the template at a setting.
    pub fn theta_at(&self, theta: &[f64], setting: usize) -> Vec<f64> {
        self.columns()[setting].iter().map(|place| theta[*place]).collect()
    }

    /// Returns the parameter set of the damper at a setting.
    pub fn params_at(&self, theta: &[f64], setting: usize) -> Params {
        self.template.params(&self.theta_at(theta, setting))
    }

    /// Returns the family with the start `theta`.
    pub fn starting_at(mut self, theta: &[f64]) -> FamilyHypothesis {
        let starts = (0..self.settings()).map(|setting| self.theta_at(theta, setting)).collect();
        self.starts = starts;
        self
    }

    /// Returns the family without the setting with the index `setting`, with the starts of the other settings.
    pub fn without_setting(&self, setting: usize) -> FamilyHypothesis {
        let mut less = self.clone();
        less.starts.remove(setting);
        less
    }

    /// Computes the [covariance](crate::deviations::sandwich) of all free parameters at a refit, and the degree of
    /// determination of each. Returns `None` if the Hessian is singular.
    pub fn covariance(&self, refit: &FamilyRefit, settings: &[SettingTests]) -> Option<(DMatrix<f64>, Vec<f64>)> {
        let tests: Vec<Test> = settings.iter().flat_map(|of| of.tests.iter().cloned()).collect();
        let residual_at = |theta: &[f64]| self.residual_by(Accuracy::Derivatives, settings, theta);
        sandwich_of(&self.joint(), &self.joint_refit(refit), &tests, &residual_at)
    }

    /// Computes the weighted residuals of all settings, concatenated. Returns `None` if a setting gives no finite
    /// force.
    fn residual_by(&self, accuracy: Accuracy, settings: &[SettingTests], theta: &[f64]) -> Option<Residual> {
        let of = |(place, of): (usize, &SettingTests)| {
            self.template.residual_by(accuracy, &of.tests, &self.theta_at(theta, place))
        };
        let all: Vec<Residual> = settings.iter().enumerate().map(of).collect::<Option<_>>()?;
        Some(Residual::from_iterator(all.iter().map(|of| of.len()).sum(), all.iter().flat_map(|of| of.iter().copied())))
    }

    /// Refits the family from its start. Returns `None` if the family gives no finite force.
    pub fn refit(&self, settings: &[SettingTests], effort: Effort) -> Option<FamilyRefit> {
        let numbers = self.numbers();
        let problem = FamilyProblem { family: self, settings, columns: self.columns(), length: self.len(), effort };
        let (low, high) = numbers.iter().map(|n| n.bounds).unzip();
        let mut found = solve_knowing(&problem, &self.start(), None, &Bounds { low, high }, &options(&numbers, effort));
        if !found.cost.is_finite() || found.rows.len() != settings.len() {
            return None;
        }
        let mut refit = FamilyRefit { theta: found.x, residuals: Vec::new(), jacobians: Vec::new() };
        for Rows { residual, jacobian } in found.rows.drain(..) {
            refit.residuals.push(-residual);
            refit.jacobians.push(jacobian);
        }
        Some(refit)
    }

    /// Converts a refit to that of [`FamilyHypothesis::joint`], with the rows of all settings concatenated.
    pub fn joint_refit(&self, refit: &FamilyRefit) -> Refit {
        let rows = refit.residuals.iter().map(|r| r.len()).sum();
        let (mut residual, mut jacobian) = (DVector::zeros(rows), DMatrix::zeros(rows, self.len()));
        let mut row = 0;
        for (own, derivatives) in refit.residuals.iter().zip(&refit.jacobians) {
            residual.rows_mut(row, own.len()).copy_from(own);
            jacobian.rows_mut(row, own.len()).copy_from(derivatives);
            row += own.len();
        }
        Refit::from_point(&self.joint(), refit.theta.clone(), residual, jacobian)
    }

    /// Converts a refit to that of the ordinary damper at a setting. Its derivatives are with respect to the template's
    /// parameters.
    pub fn refit_at(&self, refit: &FamilyRefit, setting: usize) -> Refit {
        let columns = &self.columns()[setting];
        let theta = self.theta_at(&refit.theta, setting);
        let jacobian = refit.jacobians[setting].select_columns(columns);
        Refit::from_point(&self.template, theta, refit.residuals[setting].clone(), jacobian)
    }
}

struct FamilyProblem<'a> {
    family: &'a FamilyHypothesis,
    settings: &'a [SettingTests],
    columns: Vec<Vec<usize>>,
    length: usize,
    effort: Effort,
}

impl FamilyProblem<'_> {
    fn theta(&self, joint: &[f64], setting: usize) -> Vec<f64> {
        self.columns[setting].iter().map(|place| joint[*place]).collect()
    }
}

impl Residuals for FamilyProblem<'_> {
    type At = Vec<f64>;

    fn prepare(&self, theta: &[f64]) -> Option<Vec<f64>> {
        Some(theta.to_vec())
    }

    fn blocks(&self) -> usize {
        self.settings.len()
    }

    /// Computes the residuals as computed minus measured: their derivatives are then those of the computed forces.
    fn residuals(&self, block: usize, joint: &Vec<f64>) -> Option<Vec<f64>> {
        let tests = &self.settings[block].tests;
        let residual = self.family.template.residual_by(self.effort.residuals, tests, &self.theta(joint, block))?;
        Some(residual.iter().map(|r| -r).collect())
    }

    fn jacobian(&self, block: usize, joint: &Vec<f64>) -> Option<DMatrix<f64>> {
        let tests = &self.settings[block].tests;
        let own = self.family.template.jacobian(self.effort.derivatives, tests, &self.theta(joint, block))?;
        let mut jacobian = DMatrix::zeros(own.nrows(), self.length);
        for (column, place) in own.column_iter().zip(&self.columns[block]) {
            jacobian.column_mut(*place).copy_from(&column);
        }
        Some(jacobian)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hypothesis::Free;
    use crate::sines::measured;
    use crate::unknowns::{CurveName, Unknown};
    use crate::vocabulary::base_numbers;

    /// Checks a damper with two settings that differ only in their FV curves.
    #[test]
    fn residuals_of_a_family_are_those_of_each_setting_at_its_own_numbers() {
        let base = Params::new();
        let template = Hypothesis { base, numbers: base_numbers(&base), heating: None, priors: PriorSet::default() };
        let is_curve = |free: &Free| matches!(free, Free::Model(Unknown::Rise { curve: CurveName::Fv, .. }));
        let varies: Vec<bool> = template.numbers.iter().map(|number| is_curve(&number.free)).collect();
        let soft = template.start();
        let mut hard = soft.clone();
        hard.iter_mut().zip(&varies).filter(|(_, varies)| **varies).for_each(|(rise, _)| *rise += 50.0);
        let settings: Vec<SettingTests> = [&soft, &hard]
            .iter()
            .enumerate()
            .map(|(k, theta)| {
                let tests = measured(&template.clone().starting_at(theta), &[(0.01, 8.0), (0.03, 1.0)]);
                SettingTests { value: k as f64, tests }
            })
            .collect();
        let family = FamilyHypothesis { template, varies, starts: vec![soft, hard] };
        let theta = family.start();
        let at = |theta: &[f64]| family.residual_by(Accuracy::Full, &settings, theta).unwrap();
        let truth = at(&theta);
        assert!(truth.len() == 320 && truth.amax() < 1e-9, "{}", truth.amax());
        // Parameters of the first setting change only the residuals of that setting.
        let columns = family.columns();
        let mut moved = theta.clone();
        columns[0].iter().filter(|place| !columns[1].contains(place)).for_each(|place| moved[*place] += 10.0);
        let moved = at(&moved);
        let [first, second] = [0, 160].map(|from| moved.rows(from, 160).amax());
        assert!(first > 0.1 && second < 1e-9, "{first} {second}");
        // The covariance for the intervals follows from the derivatives of the refit.
        let refit = family.refit(&settings, Effort { steps: 0, ..Effort::SCREEN }).unwrap();
        assert!(family.covariance(&refit, &settings).is_some_and(|(_, known)| known.len() == theta.len()));
    }

    #[test]
    fn shared_numbers_have_one_place_and_others_one_for_each_setting() {
        let base = Params::new();
        let mut template =
            Hypothesis { base, numbers: base_numbers(&base), heating: None, priors: PriorSet::default() };
        template.numbers.truncate(3);
        let starts = vec![vec![1.0, 2.0, 3.0], vec![9.0, 5.0, 9.0]];
        let family = FamilyHypothesis { template, varies: vec![false, true, false], starts };
        assert_eq!(family.columns(), [[0, 1, 3], [0, 2, 3]]);
        assert_eq!(family.start(), [1.0, 2.0, 5.0, 3.0]);
        assert_eq!(family.theta_at(&family.start(), 1), [1.0, 5.0, 3.0]);
        assert_eq!(family.numbers().len(), family.len());
        assert_eq!(family.without_setting(0).start(), [9.0, 5.0, 9.0]);
    }
}
