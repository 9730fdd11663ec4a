//! RODAS3 (Sandu et al., Atmos. Environ. 31, 1997): a Rosenbrock method of order 3 with an error estimate of order 2.
//!
//! The method is L-stable, so the fast parts of a damper (oil columns, a mount with a small mass, bristles) do not
//! limit the step.

/// A system of differential equations.
pub trait Equations {
    /// Inputs of the equations at an instant.
    type Drive;
    /// Computes the inputs at time `t`, s.
    fn drive(&self, t: f64) -> Self::Drive;
    /// Computes the time derivatives of the states `y`.
    fn rates(&self, drive: &Self::Drive, y: &[f64], rates: &mut [f64]);
    /// Returns the longest step, s, with which the output has a sufficient resolution at these inputs.
    fn longest(&self, _: &Self::Drive) -> f64 {
        f64::INFINITY
    }
    /// Returns the absolute error tolerance of each state per step. The total tolerance also contains
    /// [`Steps::relative`] times the magnitude of the state.
    fn tolerances(&self) -> &[f64];
}

/// Step control: limits of the steps and error tolerances.
#[derive(Debug, Clone, Copy)]
pub struct Steps {
    /// Longest step, s.
    pub longest: f64,
    /// Factor by which [`Equations::longest`] is multiplied.
    pub resolution: f64,
    /// Relative error tolerance of a step.
    pub relative: f64,
    /// Factor by which the absolute error tolerances of the states are multiplied.
    pub absolute: f64,
}

/// Shortest step, s. A step of this length is accepted with any error, because no step resolves a discontinuity.
const SHORTEST: f64 = 1e-7;
const DIAGONAL: f64 = 0.5;
const A: [[f64; 3]; 4] = [[0.0; 3], [0.0; 3], [2.0, 0.0, 0.0], [2.0, 0.0, 1.0]];
const C: [[f64; 3]; 4] = [[0.0; 3], [4.0, 0.0, 0.0], [1.0, -1.0, 0.0], [1.0, -1.0, -8.0 / 3.0]];
const M: [f64; 4] = [2.0, 0.0, 1.0, 1.0];
const GAMMA: [f64; 4] = [0.5, 1.5, 0.0, 0.0];
/// Increment of time for the derivative of the rates with respect to time, as a fraction of the step.
const AHEAD: f64 = 1e-4;
/// Increment of a state for the Jacobian: a multiple of its error tolerance, plus a fraction of its magnitude.
const NUDGE: (f64, f64) = (1e-1, 1e-7);

/// Integrator with adaptive steps and reused buffers.
pub struct Integrator {
    n: usize,
    jacobian: Vec<f64>,
    matrix: Vec<f64>,
    pivots: Vec<usize>,
    rates: Vec<f64>,
    later: Vec<f64>,
    k: [Vec<f64>; 4],
    trial: Vec<f64>,
}

impl Integrator {
    /// Makes an integrator for `n` states.
    pub fn new(n: usize) -> Integrator {
        let row = || vec![0.0; n];
        Integrator {
            n,
            jacobian: vec![0.0; n * n],
            matrix: vec![0.0; n * n],
            pivots: vec![0; n],
            rates: row(),
            later: row(),
            k: [row(), row(), row(), row()],
            trial: row(),
        }
    }

    /// Integrates the states `y` from `start` to `end`, s, and calls `each` with time, inputs and states after every
    /// accepted step.
    ///
    /// Returns false if even the shortest step gives no finite states.
    pub fn run<E: Equations>(
        &mut self,
        equations: &E,
        (start, end): (f64, f64),
        y: &mut [f64],
        steps: &Steps,
        mut each: impl FnMut(f64, &E::Drive, &[f64]),
    ) -> bool {
        let n = self.n;
        let mut t = start;
        let mut h = (steps.longest * 0.01).min(end - start);
        let mut drive = equations.drive(t);
        let mut fresh = true;
        while t < end - 1e-12 {
            h = h.min(steps.longest).min(steps.resolution * equations.longest(&drive)).max(SHORTEST).min(end - t);
            if fresh {
                equations.rates(&drive, y, &mut self.rates);
                self.differentiate(equations, &drive, y);
            }
            let later = t + AHEAD * h;
            let drive_later = equations.drive(later);
            equations.rates(&drive_later, y, &mut self.later);
            for (l, r) in self.later.iter_mut().zip(&self.rates) {
                *l = (*l - r) / (later - t);
            }
            let drive_end = equations.drive(t + h);
            let error = self.attempt(equations, &drive_end, y, h, steps);
            let shortest = h <= SHORTEST;
            if error.is_finite() && (error <= 1.0 || shortest) {
                y.copy_from_slice(&self.trial);
                t += h;
                drive = drive_end;
                fresh = true;
                each(t, &drive, &y[..n]);
                h *= (0.85 * libm::pow(error.max(1e-6), -1.0 / 3.0)).clamp(0.3, 3.0);
            } else {
                if shortest {
                    return false;
                }
                fresh = false;
                let factor = if error.is_finite() { 0.85 * libm::pow(error, -1.0 / 3.0) } else { 0.1 };
                h = (h * factor.clamp(0.1, 0.7)).max(SHORTEST);
            }
        }
        true
    }

    fn differentiate<E: Equations>(&mut self, equations: &E, drive: &E::Drive, y: &mut [f64]) {
        let n = self.n;
        for (column, tolerance) in equations.tolerances().iter().enumerate() {
            let kept = y[column];
            let nudge = NUDGE.0 * tolerance + NUDGE.1 * kept.abs();
            y[column] = kept + nudge;
            equations.rates(drive, y, &mut self.trial);
            y[column] = kept;
            for row in 0..n {
                self.jacobian[row * n + column] = (self.trial[row] - self.rates[row]) / nudge;
            }
        }
    }

    /// Attempts one step of length `h`, s, and stores its result in `trial`. Returns the error relative to the
    /// tolerance, or infinity for a singular matrix.
    fn attempt<E: Equations>(&mut self, e: &E, drive_end: &E::Drive, y: &[f64], h: f64, steps: &Steps) -> f64 {
        let n = self.n;
        for (i, (m, j)) in self.matrix.iter_mut().zip(&self.jacobian).enumerate() {
            *m = -j + if i % (n + 1) == 0 { 1.0 / (h * DIAGONAL) } else { 0.0 };
        }
        if !self.factorise() {
            return f64::INFINITY;
        }
        for stage in 0..4 {
            let (done, rest) = self.k.split_at_mut(stage);
            let k = &mut rest[0];
            if stage < 2 {
                k.copy_from_slice(&self.rates);
            } else {
                for i in 0..n {
                    self.trial[i] = y[i] + done.iter().zip(&A[stage]).map(|(d, a)| a * d[i]).sum::<f64>();
                }
                e.rates(drive_end, &self.trial, k);
            }
            for i in 0..n {
                k[i] += done.iter().zip(&C[stage]).map(|(d, c)| c * d[i]).sum::<f64>() / h
                    + h * GAMMA[stage] * self.later[i];
            }
            solve(&self.matrix, &self.pivots, k);
        }
        let mut sum = 0.0;
        for (i, tolerance) in e.tolerances().iter().enumerate() {
            self.trial[i] = y[i] + (0..4).map(|s| M[s] * self.k[s][i]).sum::<f64>();
            let allowed = steps.absolute * tolerance + steps.relative * y[i].abs().max(self.trial[i].abs());
            sum += (self.k[3][i] / allowed).powi(2);
        }
        (sum / n as f64).sqrt()
    }

    /// Replaces `matrix` by its LU factors with row exchange. Returns false for a singular matrix.
    fn factorise(&mut self) -> bool {
        let (n, m) = (self.n, &mut self.matrix);
        for column in 0..n {
            let mut best = column;
            for row in column + 1..n {
                if m[row * n + column].abs() > m[best * n + column].abs() {
                    best = row;
                }
            }
            self.pivots[column] = best;
            if best != column {
                for i in 0..n {
                    m.swap(column * n + i, best * n + i);
                }
            }
            let pivot = m[column * n + column];
            if pivot == 0.0 || !pivot.is_finite() {
                return false;
            }
            for row in column + 1..n {
                let factor = m[row * n + column] / pivot;
                m[row * n + column] = factor;
                if factor != 0.0 {
                    for i in column + 1..n {
                        m[row * n + i] -= factor * m[column * n + i];
                    }
                }
            }
        }
        true
    }
}

fn solve(m: &[f64], pivots: &[usize], b: &mut [f64]) {
    let n = b.len();
    for (row, pivot) in pivots.iter().enumerate() {
        b.swap(row, *pivot);
    }
    for row in 0..n {
        let known: f64 = (0..row).map(|i| m[row * n + i] * b[i]).sum();
        b[row] -= known;
    }
    for row in (0..n).rev() {
        let known: f64 = (row + 1..n).map(|i| m[row * n + i] * b[i]).sum();
        b[row] = (b[row] - known) / m[row * n + row];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Prothero and Robinson's problem: the first state follows cos t at any stiffness. The other two states are an
    /// undamped nonlinear oscillator that the first state drives.
    struct Stiff(Vec<f64>);

    impl Equations for Stiff {
        type Drive = f64;
        fn drive(&self, t: f64) -> f64 {
            t
        }
        fn rates(&self, t: &f64, y: &[f64], r: &mut [f64]) {
            r[0] = -1e4 * (y[0] - libm::cos(*t)) - libm::sin(*t);
            r[1] = y[2];
            r[2] = -y[1] - 0.1 * y[1].powi(3) + y[0];
        }
        fn tolerances(&self) -> &[f64] {
            &self.0
        }
    }

    fn end(longest: f64, relative: f64) -> Vec<f64> {
        let mut y = vec![1.0, 0.5, 0.0];
        let steps = Steps { longest, resolution: 1.0, relative, absolute: relative / 1e-5 };
        assert!(Integrator::new(3).run(&Stiff(vec![1e-5; 3]), (0.0, 3.0), &mut y, &steps, |_, _, _| ()));
        y
    }

    #[test]
    fn stiff_part_follows_and_the_rest_has_order_three() {
        let exact = end(1e-3, 1e-9);
        assert!((exact[0] - 3f64.cos()).abs() < 1e-6);
        // With this loose tolerance, `longest` alone determines the steps.
        let error = |h: f64| {
            let y = end(h, 1e3);
            libm::hypot(y[1] - exact[1], y[2] - exact[2])
        };
        let orders = [0.1, 0.05].map(|h| libm::log2(error(h) / error(0.5 * h)));
        assert!(orders.iter().all(|order| *order > 2.5), "{orders:?} {}", error(0.1));
    }

    #[test]
    fn tolerance_sets_the_error() {
        let exact = end(1e-3, 1e-9);
        let error = |relative: f64| (end(1.0, relative)[1] - exact[1]).abs();
        assert!(error(1e-3) < 1e-2 && error(1e-6) < 1e-4, "{} {}", error(1e-3), error(1e-6));
    }
}
