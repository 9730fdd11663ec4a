//! Implicit integration with error control for the stiff motion of the damper.
//!
//! Oil chambers and bristles have time constants below a millisecond, but a slow test lasts minutes. An explicit method
//! would require millions of steps.
//!
//! The method is the L-stable, stiffly accurate six-stage ESDIRK of order 4 with an embedded third order: Kennedy &
//! Carpenter, *Additive Runge-Kutta schemes for convection-diffusion-reaction equations*, Appl. Numer. Math. 44 (2003),
//! ARK4(3)6L\[2\]SA. A test verifies the coefficients by their order conditions.

// Matrices and vectors of a few components are easiest to read with explicit indices.
#![allow(clippy::needless_range_loop)]

const STAGES: usize = 6;
const GAMMA: f64 = 0.25;
const NODES: [f64; STAGES] = [0.0, 0.5, 83.0 / 250.0, 31.0 / 50.0, 17.0 / 20.0, 1.0];
/// Runge-Kutta coefficients below the diagonal; the last row contains the fourth-order weights.
const WEIGHTS: [[f64; STAGES - 1]; STAGES] = [
    [0.0; 5],
    [0.25, 0.0, 0.0, 0.0, 0.0],
    [8611.0 / 62500.0, -1743.0 / 31250.0, 0.0, 0.0, 0.0],
    [5012029.0 / 34652500.0, -654441.0 / 2922500.0, 174375.0 / 388108.0, 0.0, 0.0],
    [15267082809.0 / 155376265600.0, -71443401.0 / 120774400.0, 730878875.0 / 902184768.0, 2285395.0 / 8070912.0, 0.0],
    [82889.0 / 524892.0, 0.0, 15625.0 / 83664.0, 69875.0 / 102672.0, -2260.0 / 8211.0],
];
/// Third-order weights for the error estimate.
const EMBEDDED: [f64; STAGES] = [
    4586570599.0 / 29645900160.0,
    0.0,
    178811875.0 / 945068544.0,
    814220225.0 / 1159782912.0,
    -3700637.0 / 11593932.0,
    61727.0 / 225920.0,
];

const NEWTON_ITERATIONS: usize = 7;
/// Estimated remaining error, as a fraction of the error tolerance, at which the Newton iteration stops.
const NEWTON_TOLERANCE: f64 = 0.01;
/// Ratio of successive Newton updates above which a new Jacobian is computed.
const NEWTON_SLOW: f64 = 0.3;
const SMALLEST_STEP_S: f64 = 1e-12;

/// Error tolerance per step of each component y of the state: `absolute + relative |y|`.
#[derive(Debug, Clone, Copy)]
pub struct Tolerance<const N: usize> {
    /// Absolute tolerance in the unit of the component; also the scale of the equations.
    pub absolute: [f64; N],
    /// Relative tolerance.
    pub relative: f64,
}

/// Error of a stopped integration.
#[derive(Debug, Clone, PartialEq)]
pub struct Stuck {
    /// Time that the integration reached, s.
    pub time_s: f64,
    /// Reason why the integration stopped.
    pub reason: &'static str,
}

/// Solver of the initial value problem `y' = rates(t, y)` with time t, s, and state y.
pub struct Integrator<const N: usize, F> {
    rates: F,
    tolerance: Tolerance<N>,
    time: f64,
    state: [f64; N],
    /// Derivative of the state at `time`. It is evaluated after each step, because the derivative of the last stage
    /// would amplify errors of stiff components.
    rate: [f64; N],
    step: f64,
    jacobian: [[f64; N]; N],
    jacobian_is_fresh: bool,
    /// Step `h`, s, and the LU factors of `1 - gamma h J` for this step. J is the Jacobian and gamma the diagonal
    /// coefficient [`GAMMA`].
    factors: Option<(f64, Factors<N>)>,
}

impl<const N: usize, F: Fn(f64, &[f64; N]) -> [f64; N]> Integrator<N, F> {
    /// Starts at `time`, s, from `state` with a first step of 1e-5 s.
    pub fn new(rates: F, time: f64, state: [f64; N], tolerance: Tolerance<N>) -> Self {
        let rate = rates(time, &state);
        let mut integrator = Self {
            rates,
            tolerance,
            time,
            state,
            rate,
            step: 1e-5,
            jacobian: [[0.0; N]; N],
            jacobian_is_fresh: false,
            factors: None,
        };
        integrator.renew_jacobian();
        integrator
    }

    /// Returns the current state.
    pub fn state(&self) -> &[f64; N] {
        &self.state
    }

    /// Integrates exactly up to the time `end`, s.
    ///
    /// # Errors
    /// [`Stuck`] if no step size meets the tolerance.
    pub fn advance_to(&mut self, end: f64) -> Result<(), Stuck> {
        while self.time < end {
            let remaining = end - self.time;
            // If more than half of the remaining time fits into one step, two equal steps avoid a very short last step.
            let (step, is_last) = if self.step >= remaining {
                (remaining, true)
            } else if self.step > 0.5 * remaining {
                (0.5 * remaining, false)
            } else {
                (self.step, false)
            };
            let Some((stages, filtered)) = self.try_step(step) else {
                if self.jacobian_is_fresh {
                    self.step = 0.25 * step;
                    self.check_step()?;
                } else {
                    self.renew_jacobian();
                }
                continue;
            };
            let error = self.norm(&filtered, &stages.state);
            // The error of the embedded third-order method is proportional to the fourth power of the step, hence the
            // fourth root.
            let factor = (0.9 * libm::pow(error.max(1e-10), -0.25)).clamp(0.2, 4.0);
            if error.is_nan() || error > 1.0 {
                self.step = step * if error.is_nan() { 0.2 } else { factor.min(0.9) };
                self.check_step()?;
                continue;
            }
            self.time = if is_last { end } else { self.time + step };
            self.state = stages.state;
            self.rate = stages.rate;
            self.jacobian_is_fresh = false;
            if stages.slow_newton {
                self.renew_jacobian();
            }
            let proposal = step * factor;
            // If `end` shortened this step, the next step may be as long as the step before this shortening. It is at
            // most four times the new proposal.
            self.step = if step < self.step { proposal.max(self.step.min(4.0 * proposal)) } else { proposal };
        }
        Ok(())
    }

    fn check_step(&self) -> Result<(), Stuck> {
        if self.step > SMALLEST_STEP_S {
            return Ok(());
        }
        Err(Stuck { time_s: self.time, reason: "no step is small enough for the accuracy asked for" })
    }

    /// Returns the largest ratio of a component of `change` to its tolerance, or NaN if any component is NaN.
    fn norm(&self, change: &[f64; N], state: &[f64; N]) -> f64 {
        let mut largest = 0.0;
        for i in 0..N {
            let allowed =
                self.tolerance.absolute[i] + self.tolerance.relative * self.state[i].abs().max(state[i].abs());
            let share = (change[i] / allowed).abs();
            if share.is_nan() {
                return f64::NAN;
            }
            largest = f64::max(largest, share);
        }
        largest
    }

    /// Computes the Jacobian by forward differences, in components scaled by the absolute tolerances.
    fn renew_jacobian(&mut self) {
        for column in 0..N {
            let mut shifted = self.state;
            // The increment of the state is large compared with rounding errors, and small compared with the tolerance.
            shifted[column] += 1e-7 * self.state[column].abs() + 1e-3 * self.tolerance.absolute[column];
            let increment = shifted[column] - self.state[column];
            let rate = (self.rates)(self.time, &shifted);
            for row in 0..N {
                self.jacobian[row][column] = (rate[row] - self.rate[row]) / increment
                    * (self.tolerance.absolute[column] / self.tolerance.absolute[row]);
            }
        }
        self.jacobian_is_fresh = true;
        self.factors = None;
    }

    /// Computes the stages of one step and its filtered error. Returns `None` if the Newton iteration does not
    /// converge.
    fn try_step(&mut self, step: f64) -> Option<(Attempt<N>, [f64; N])> {
        if self.factors.as_ref().is_none_or(|(h, _)| *h != step) {
            let mut matrix = [[0.0; N]; N];
            for row in 0..N {
                for column in 0..N {
                    matrix[row][column] =
                        f64::from(u8::from(row == column)) - GAMMA * step * self.jacobian[row][column];
                }
            }
            self.factors = Some((step, Factors::of(matrix)?));
        }
        let (_, factors) = self.factors.as_ref()?;
        let scale = &self.tolerance.absolute;
        let solve = |mut vector: [f64; N]| {
            for i in 0..N {
                vector[i] /= scale[i];
            }
            let mut solved = factors.solve(vector);
            for i in 0..N {
                solved[i] *= scale[i];
            }
            solved
        };

        let mut rates = [[0.0; N]; STAGES];
        rates[0] = self.rate;
        let mut value = self.state;
        let mut slow_newton = false;
        for stage in 1..STAGES {
            let mut base = self.state;
            for (earlier, rate) in rates.iter().enumerate().take(stage) {
                let weight = step * WEIGHTS[stage][earlier];
                for i in 0..N {
                    base[i] += weight * rate[i];
                }
            }
            let time = self.time + NODES[stage] * step;
            for i in 0..N {
                value[i] = base[i] + step * GAMMA * rates[stage - 1][i];
            }
            let mut last_norm = f64::INFINITY;
            let mut converged = false;
            for _ in 0..NEWTON_ITERATIONS {
                let rate = (self.rates)(time, &value);
                let mut residual = [0.0; N];
                for i in 0..N {
                    residual[i] = base[i] + step * GAMMA * rate[i] - value[i];
                }
                let change = solve(residual);
                let norm = self.norm(&change, &value);
                if norm.is_nan() {
                    return None;
                }
                for i in 0..N {
                    value[i] += change[i];
                }
                let ratio = norm / last_norm;
                if ratio > 0.95 && norm > NEWTON_TOLERANCE {
                    return None;
                }
                slow_newton |= ratio > NEWTON_SLOW && norm > NEWTON_TOLERANCE;
                // The convergence ratio gives an estimate of the change by all further iterations.
                let rest = if last_norm.is_finite() { norm * ratio / (1.0 - ratio.min(0.95)) } else { norm };
                last_norm = norm;
                if rest <= NEWTON_TOLERANCE {
                    converged = true;
                    break;
                }
            }
            if !converged {
                return None;
            }
            // With the derivative from the stage equation instead of `rates`, stiff components stay damped within the
            // step.
            for i in 0..N {
                rates[stage][i] = (value[i] - base[i]) / (step * GAMMA);
            }
        }
        let mut error = [0.0; N];
        for (stage, rate) in rates.iter().enumerate() {
            let weight = if stage == STAGES - 1 { GAMMA } else { WEIGHTS[STAGES - 1][stage] };
            for i in 0..N {
                error[i] += step * (weight - EMBEDDED[stage]) * rate[i];
            }
        }
        // Without this filter by the inverse of `1 - gamma h J`, the error estimate is too large for stiff components,
        // which the method itself damps.
        let filtered = solve(error);
        Some((Attempt { state: value, rate: (self.rates)(self.time + step, &value), slow_newton }, filtered))
    }
}

/// Result of one attempted step.
struct Attempt<const N: usize> {
    state: [f64; N],
    rate: [f64; N],
    slow_newton: bool,
}

/// LU factors with row permutation.
struct Factors<const N: usize> {
    lu: [[f64; N]; N],
    rows: [usize; N],
}

impl<const N: usize> Factors<N> {
    /// Factorizes a matrix. Returns `None` if it is singular or not finite.
    fn of(mut lu: [[f64; N]; N]) -> Option<Self> {
        let mut rows = [0; N];
        for (index, row) in rows.iter_mut().enumerate() {
            *row = index;
        }
        for pivot in 0..N {
            let best = (pivot..N).max_by(|a, b| lu[*a][pivot].abs().total_cmp(&lu[*b][pivot].abs()))?;
            if !(lu[best][pivot].abs() > 0.0 && lu[best][pivot].is_finite()) {
                return None;
            }
            lu.swap(pivot, best);
            rows.swap(pivot, best);
            for row in pivot + 1..N {
                let factor = lu[row][pivot] / lu[pivot][pivot];
                lu[row][pivot] = factor;
                for column in pivot + 1..N {
                    lu[row][column] -= factor * lu[pivot][column];
                }
            }
        }
        Some(Self { lu, rows })
    }

    fn solve(&self, vector: [f64; N]) -> [f64; N] {
        let mut solution = [0.0; N];
        for row in 0..N {
            solution[row] = vector[self.rows[row]];
            for column in 0..row {
                solution[row] -= self.lu[row][column] * solution[column];
            }
        }
        for row in (0..N).rev() {
            for column in row + 1..N {
                solution[row] -= self.lu[row][column] * solution[column];
            }
            solution[row] /= self.lu[row][row];
        }
        solution
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the coefficients of a stage of the method, including the diagonal.
    fn row(stage: usize) -> [f64; STAGES] {
        let mut row = [0.0; STAGES];
        row[..5].copy_from_slice(&WEIGHTS[stage]);
        if stage > 0 {
            row[stage] = GAMMA;
        }
        row
    }

    fn dot(a: &[f64; STAGES], b: impl Fn(usize) -> f64) -> f64 {
        (0..STAGES).map(|i| a[i] * b(i)).sum()
    }

    #[test]
    fn coefficients_meet_the_order_conditions() {
        for (stage, node) in NODES.iter().enumerate() {
            assert!((dot(&row(stage), |_| 1.0) - node).abs() < 1e-14, "row {stage}");
        }
        let c = |i: usize| NODES[i];
        let ac = |i: usize| dot(&row(i), c);
        let acc = |i: usize| dot(&row(i), |j| c(j) * c(j));
        let aac = |i: usize| dot(&row(i), ac);
        let weights = row(STAGES - 1);
        let third = |b: &[f64; STAGES]| {
            [dot(b, |_| 1.0) - 1.0, dot(b, c) - 1.0 / 2.0, dot(b, |i| c(i) * c(i)) - 1.0 / 3.0, dot(b, ac) - 1.0 / 6.0]
        };
        let fourth = [
            dot(&weights, |i| c(i).powi(3)) - 1.0 / 4.0,
            dot(&weights, |i| c(i) * ac(i)) - 1.0 / 8.0,
            dot(&weights, acc) - 1.0 / 12.0,
            dot(&weights, aac) - 1.0 / 24.0,
        ];
        for defect in third(&weights).into_iter().chain(third(&EMBEDDED)).chain(fourth) {
            assert!(defect.abs() < 1e-14, "{defect}");
        }
        // The embedded weights must violate a fourth-order condition. Otherwise, the error estimate would vanish, and
        // step control would be ineffective.
        assert!((dot(&EMBEDDED, |i| c(i).powi(3)) - 0.25).abs() > 1e-4);
    }

    /// Solves the stiff problem of Prothero & Robinson, with a fast relaxation toward cos t. Returns the largest error
    /// of the solution at t = 5.
    fn stiff_error(relative: f64) -> f64 {
        let rates = |t: f64, y: &[f64; 2]| [-1e5 * (y[0] - libm::cos(t)) - libm::sin(t), -y[1] * y[0]];
        let mut integrator = Integrator::new(rates, 0.0, [1.0, 1.0], Tolerance { absolute: [relative; 2], relative });
        integrator.advance_to(5.0).unwrap();
        let state = integrator.state();
        // The solution of y1' = -y1 cos t is exp(-sin t).
        (state[0] - libm::cos(5f64)).abs().max((state[1] - libm::exp(-(libm::sin(5f64)))).abs())
    }

    #[test]
    fn stiff_problem_with_known_solution_converges_with_the_tolerance() {
        let coarse = stiff_error(1e-4);
        let fine = stiff_error(1e-8);
        assert!(coarse < 1e-3, "{coarse}");
        assert!(fine < 1e-6 && fine < 1e-2 * coarse, "{fine} after {coarse}");
    }

    #[test]
    fn fixed_steps_converge_with_fourth_order() {
        // For a linear oscillator, every step meets this loose tolerance, so the calls of `advance_to` determine the
        // steps.
        let error = |steps: u32| {
            let rates = |_: f64, y: &[f64; 2]| [y[1], -y[0]];
            let loose = Tolerance { absolute: [1e-3; 2], relative: 0.0 };
            let mut integrator = Integrator::new(rates, 0.0, [1.0, 0.0], loose);
            integrator.step = 1.0;
            for step in 1..=steps {
                integrator.advance_to(2.0 * f64::from(step) / f64::from(steps)).unwrap();
            }
            libm::hypot(integrator.state()[0] - libm::cos(2f64), integrator.state()[1] + libm::sin(2f64))
        };
        let order = libm::log2(error(10) / error(20));
        assert!((3.7..5.0).contains(&order), "order {order}");
    }

    #[test]
    fn impossible_rates_are_reported() {
        let mut integrator = Integrator::new(
            |t, _: &[f64; 1]| [if t > 0.5 { f64::NAN } else { 1.0 }],
            0.0,
            [0.0],
            Tolerance { absolute: [1e-6], relative: 1e-6 },
        );
        let stuck = integrator.advance_to(1.0).unwrap_err();
        assert!((stuck.time_s - 0.5).abs() < 1e-3, "{stuck:?}");
    }
}
