//! First-order estimate of a family in which other parameters depend on the setting.
//!
//! The derivatives with respect to the template's parameters at each setting define the linear least-squares problem of
//! every pattern of shared and varying parameters. Therefore, all patterns that differ in one quantity can be evaluated
//! without a refit.

use super::pattern::{Site, varies};
use super::problem::{FamilyHypothesis, SettingTests};
use super::structure::{FamilyStructure, evidence, log_prior_of};
use crate::gram::gram;
use crate::refit::weights;
use dashpot_records::restrict;
use nalgebra::{DMatrix, DVector};

/// Largest change of a parameter in a linear estimate, in typical steps of the parameter in a search. Beyond it, the
/// linearization is unreliable.
const TRUSTED: f64 = 5.0;
/// Largest number of solutions of the bounded linear problem. Each solution fixes the parameters that exceeded their
/// bounds in earlier solutions.
const ITERATIONS: usize = 6;
/// Weight of the current value of a parameter, relative to its diagonal element of the normal matrix plus 1/step². It
/// matters only if neither records nor prior determine the parameter.
const RIDGE: f64 = 1e-9;

/// The linear problem of a refitted family.
pub struct Linearization<'a> {
    structure: &'a FamilyStructure,
    settings: &'a [SettingTests],
    /// Values of the free parameters of the template (the damper at one setting), at each setting.
    thetas: Vec<Vec<f64>>,
    /// Derivatives of the weighted forces at each setting with respect to the free parameters of the template.
    jacobians: Vec<DMatrix<f64>>,
    /// Weighted normal matrix and right-hand side of each setting.
    normals: Vec<(DMatrix<f64>, DVector<f64>)>,
}

/// A family predicted by a linearization.
pub struct Prediction {
    /// The family, starting from the predicted parameters.
    pub hypothesis: FamilyHypothesis,
    /// Predicted log posterior.
    pub log_posterior: f64,
}

impl<'a> Linearization<'a> {
    /// Linearizes the residuals of a refitted family.
    pub fn new(structure: &'a FamilyStructure, settings: &'a [SettingTests]) -> Linearization<'a> {
        let hypothesis = &structure.hypothesis;
        let columns = hypothesis.columns();
        let thetas: Vec<Vec<f64>> =
            (0..settings.len()).map(|setting| hypothesis.theta_at(&structure.refit.theta, setting)).collect();
        let jacobians: Vec<DMatrix<f64>> = structure
            .refit
            .jacobians
            .iter()
            .zip(&columns)
            .map(|(jacobian, own)| jacobian.select_columns(own))
            .collect();
        let normals = jacobians
            .iter()
            .zip(&structure.refit.residuals)
            .map(|(jacobian, residual)| {
                let weights = DVector::from_vec(weights(residual));
                let mut weighted = jacobian.clone();
                weighted.column_iter_mut().for_each(|mut column| column.component_mul_assign(&weights));
                let right = weighted.tr_mul(&residual.component_mul(&weights));
                (gram(&weighted), right)
            })
            .collect();
        Linearization { structure, settings, thetas, jacobians, normals }
    }

    /// Predicts the family in which the quantities `sites` vary with the setting and all others are shared. Returns
    /// `None` if the linear problem has no solution.
    pub fn predict(&self, sites: &[Site]) -> Option<Prediction> {
        let from = &self.structure.hypothesis;
        let varies = varies(&from.template, sites);
        let mut hypothesis = FamilyHypothesis { template: from.template.clone(), varies, starts: self.thetas.clone() };
        let columns = hypothesis.columns();
        let theta = self.solve(&hypothesis, &columns)?;
        let residuals: Vec<DVector<f64>> = columns
            .iter()
            .enumerate()
            .map(|(setting, own)| {
                let moved = own.iter().zip(&self.thetas[setting]).map(|(place, was)| theta[*place] - was);
                let moved = DVector::from_iterator(own.len(), moved);
                &self.structure.refit.residuals[setting] - &self.jacobians[setting] * moved
            })
            .collect();
        hypothesis = hypothesis.starting_at(&theta);
        let evidence = evidence(&hypothesis, &theta, &residuals, self.settings);
        let log_posterior = evidence.log_evidence() + log_prior_of(&hypothesis, &self.structure.components);
        Some(Prediction { hypothesis, log_posterior })
    }

    /// Solves the linear problem for parameters within their bounds and near the current values. Returns `None` if the
    /// normal matrix is not positive definite.
    fn solve(&self, hypothesis: &FamilyHypothesis, columns: &[Vec<usize>]) -> Option<Vec<f64>> {
        let numbers = hypothesis.numbers();
        let n = numbers.len();
        let (mut normal, mut right) = (DMatrix::zeros(n, n), DVector::zeros(n));
        let mut range = vec![(f64::INFINITY, f64::NEG_INFINITY); n];
        for ((own, theta), (block, pull)) in columns.iter().zip(&self.thetas).zip(&self.normals) {
            let target = pull + block * DVector::from_column_slice(theta);
            for (i, a) in own.iter().enumerate() {
                right[*a] += target[i];
                let (low, high) = &mut range[*a];
                (*low, *high) = (low.min(theta[i]), high.max(theta[i]));
                for (j, b) in own.iter().enumerate() {
                    normal[(*a, *b)] += block[(i, j)];
                }
            }
        }
        for (i, number) in numbers.iter().enumerate() {
            let ridge = RIDGE * (normal[(i, i)] + 1.0 / (number.step * number.step));
            normal[(i, i)] += ridge;
            right[i] += ridge * 0.5 * (range[i].0 + range[i].1);
            if let Some((mean, spread)) = number.prior {
                normal[(i, i)] += 1.0 / (spread * spread);
                right[i] += mean / (spread * spread);
            }
        }
        let bounds: Vec<(f64, f64)> = numbers
            .iter()
            .zip(&range)
            .map(|(number, (low, high))| {
                let reach = TRUSTED * number.step;
                ((low - reach).max(number.bounds.0), (high + reach).min(number.bounds.1))
            })
            .collect();
        let mut fixed: Vec<Option<f64>> = vec![None; n];
        let mut theta = vec![0.0; n];
        for _ in 0..ITERATIONS {
            let (mut matrix, mut vector) = (normal.clone(), right.clone());
            for (i, value) in fixed.iter().enumerate().filter_map(|(i, value)| Some((i, (*value)?))) {
                for k in 0..n {
                    vector[k] -= normal[(k, i)] * value;
                    (matrix[(k, i)], matrix[(i, k)]) = (0.0, 0.0);
                }
                matrix[(i, i)] = 1.0;
                vector[i] = value;
            }
            for (i, value) in fixed.iter().enumerate().filter_map(|(i, value)| Some((i, (*value)?))) {
                vector[i] = value;
            }
            let solution = matrix.cholesky()?.solve(&vector);
            theta = solution.iter().copied().collect();
            let mut is_inside = true;
            for (i, value) in theta.iter_mut().enumerate() {
                let (low, high) = bounds[i];
                if fixed[i].is_none() && !(low..=high).contains(value) {
                    *value = restrict(*value, low, high);
                    fixed[i] = Some(*value);
                    is_inside = false;
                }
            }
            if is_inside {
                break;
            }
        }
        Some(theta)
    }
}
