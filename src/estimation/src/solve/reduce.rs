//! Reduction of a linear least-squares problem to an equivalent problem with at most one row per parameter.

use crate::gram::gram;
use nalgebra::{DMatrix, DVector};

/// Smallest independent fraction of a column at which the normal equations are accurate enough.
///
/// The fraction is the part that is linearly independent of the previous columns. If it is 10⁻ⁿ, the normal equations
/// lose 2n of sixteen digits.
const APART: f64 = 1e-4;

/// Computes a triangular factor of the rows, and the residuals rotated with them.
///
/// The factor is the Cholesky factor of the normal equations, because a matrix product is several times faster than
/// reflections. For nearly dependent columns, Cholesky would lose half of the digits, so the method is Householder QR
/// factorization. A problem without surplus rows is returned unchanged.
///
/// A parameter without influence on these rows has a column of zeros, for example a curve point beyond the speed of a
/// test. The columns of zeros get no rows.
pub fn reduce(jacobian: &DMatrix<f64>, residual: &DVector<f64>) -> (DMatrix<f64>, DVector<f64>) {
    let n = jacobian.ncols();
    if jacobian.nrows() <= n {
        return (jacobian.clone(), residual.clone());
    }
    let occupied: Vec<usize> = (0..n).filter(|c| jacobian.column(*c).iter().any(|v| *v != 0.0)).collect();
    if occupied.len() < n {
        let (part, right) = reduce(&jacobian.select_columns(&occupied), residual);
        let mut factor = DMatrix::zeros(part.nrows(), n);
        for (column, place) in part.column_iter().zip(&occupied) {
            factor.set_column(*place, &column);
        }
        return (factor, right);
    }
    if let Some(squared) = by_squares(jacobian, residual) {
        return squared;
    }
    let qr = jacobian.clone().qr();
    let mut right = residual.clone();
    qr.q_tr_mul(&mut right);
    (qr.r(), right.rows(0, n).into_owned())
}

/// Factors the normal equations by Cholesky. Returns `None` if columns are nearly dependent.
fn by_squares(jacobian: &DMatrix<f64>, residual: &DVector<f64>) -> Option<(DMatrix<f64>, DVector<f64>)> {
    let n = jacobian.ncols();
    let squares = gram(jacobian);
    let lengths = DVector::from_fn(n, |i, _| squares[(i, i)].sqrt());
    if lengths.iter().any(|l| !(*l > 0.0)) {
        return None;
    }
    let scaled = DMatrix::from_fn(n, n, |r, c| squares[(r, c)] / (lengths[r] * lengths[c]));
    let lower = scaled.cholesky()?.unpack();
    if lower.diagonal().iter().any(|d| *d < APART) {
        return None;
    }
    let turned = jacobian.tr_mul(residual).component_div(&lengths);
    let right = lower.solve_lower_triangular(&turned)?;
    let mut factor = lower.transpose();
    for (mut column, length) in factor.column_iter_mut().zip(&lengths) {
        column *= *length;
    }
    Some((factor, right))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(near: f64) -> (DMatrix<f64>, DVector<f64>) {
        let t = |i: usize| i as f64 / 40.0;
        let jacobian = DMatrix::from_fn(40, 3, |i, c| match c {
            0 => 1e3,
            1 => 1e-2 * t(i),
            _ => 1e-2 * t(i) + near * libm::sin(9.0 * t(i)),
        });
        (jacobian, DVector::from_fn(40, |i, _| libm::cos(3.0 * t(i))))
    }

    #[test]
    fn columns_of_zeros_get_no_rows() {
        let (full, residual) = rows(1e-2);
        let with_zeros = DMatrix::from_fn(40, 5, |r, c| if c % 2 == 0 { full[(r, c / 2)] } else { 0.0 });
        let (factor, right) = reduce(&with_zeros, &residual);
        let (of_full, right_of_full) = reduce(&full, &residual);
        assert_eq!((factor.select_columns(&[0, 2, 4]), right), (of_full, right_of_full));
        assert!(factor.column(1).norm() == 0.0 && factor.column(3).norm() == 0.0);
        assert_eq!(reduce(&DMatrix::zeros(4, 2), &DVector::from_element(4, 1.0)).0.shape(), (0, 2));
    }

    /// Checks for both factorizations that the reduced rows give the solution and the sum of squares of all rows.
    #[test]
    fn the_reduced_rows_have_the_solution_of_all_rows() {
        for (near, squared) in [(1e-2, true), (1e-7, false), (0.0, false)] {
            let (jacobian, residual) = rows(near);
            assert_eq!(by_squares(&jacobian, &residual).is_some(), squared, "{near}");
            let (factor, right) = reduce(&jacobian, &residual);
            assert_eq!(factor.nrows(), 3);
            let slope = jacobian.tr_mul(&residual);
            let reduced = factor.tr_mul(&right);
            for k in 0..3 {
                assert!((slope[k] - reduced[k]).abs() < 1e-9 * jacobian.column(k).norm(), "{near} {k}");
            }
            let (all, few) = (jacobian.tr_mul(&jacobian), factor.tr_mul(&factor));
            for (k, (a, b)) in all.iter().zip(few.iter()).enumerate() {
                let size = jacobian.column(k / 3).norm() * jacobian.column(k % 3).norm();
                assert!((a - b).abs() < 1e-12 * size, "{near} {k}");
            }
        }
    }
}
