//! Input from the host, and the motion between two host steps.

use crate::dual::Real;
use crate::math::pair;

/// Input at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// Damper displacement, m, extension positive. `None` if the host knows only the velocity. The step then integrates
    /// the velocity from the initial position.
    pub displacement: Option<f64>,
    /// Damper velocity, m/s, extension positive.
    pub velocity: f64,
    /// Side force, N; 0 if unknown.
    pub side_force: f64,
    /// Damper temperature, °C.
    pub temperature: f64,
}

impl Input {
    /// Makes an input with a velocity alone, without side force, at 20 °C.
    pub fn velocity(velocity: f64) -> Input {
        Input { displacement: None, velocity, side_force: 0.0, temperature: 20.0 }
    }

    /// Makes an input with displacement and velocity, without side force, at 20 °C.
    pub fn motion(displacement: f64, velocity: f64) -> Input {
        Input { displacement: Some(displacement), ..Input::velocity(velocity) }
    }

    /// Returns whether every number is finite.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        // 0·x is 0 for every finite x and NaN for all others, so one comparison suffices for the sum.
        let x = self.displacement.unwrap_or(0.0);
        (x + self.velocity + self.side_force + self.temperature) * 0.0 == 0.0
    }
}

/// Motion of the moving end over one host step: the cubic through displacement and velocity at both ends.
///
/// Displacement and velocity inside the step come from the same polynomial. The velocity is therefore always the
/// derivative of the displacement.
#[derive(Clone, Copy, Debug)]
pub struct Path {
    x0: f64,
    v0: f64,
    x1: f64,
    v1: f64,
    dt: f64,
    is_integrated: bool,
}

/// A point of a [`Path`], with its derivatives with respect to displacement x1 and velocity v1 at the end of the step.
#[derive(Clone, Copy, Debug)]
pub struct PathPoint {
    /// Displacement, m.
    pub x: f64,
    /// Velocity, m/s.
    pub v: f64,
    /// Derivatives of x with respect to displacement x1 and velocity v1 at the end of the step, [-, s].
    pub x_by_end: [f64; 2],
    /// Derivatives of v with respect to displacement x1 and velocity v1 at the end of the step, [1/s, -].
    pub v_by_end: [f64; 2],
    is_end: bool,
}

impl PathPoint {
    /// Computes the derivatives of `k x + c v` at this point with respect to displacement and velocity at the end of
    /// the step.
    #[inline(always)]
    pub fn drive_by_end(&self, k: f64, c: f64) -> [f64; 2] {
        if self.is_end { [k, c] } else { pair(|i| k * self.x_by_end[i] + c * self.v_by_end[i]) }
    }
}

impl Path {
    /// Makes the path from displacement `x0`, m, and velocity `v0`, m/s, to the input `to` after the time `dt`, s.
    ///
    /// A missing displacement of the input is the integral of a velocity that changes linearly from `v0` to that of the
    /// input.
    #[inline(always)]
    pub fn new(x0: f64, v0: f64, to: &Input, dt: f64) -> Path {
        let v1 = to.velocity;
        let x1 = match to.displacement {
            Some(x1) => x1,
            None => x0 + 0.5 * dt * (v0 + v1),
        };
        Path { x0, v0, x1, v1, dt, is_integrated: to.displacement.is_none() }
    }

    /// Returns the length of the step, s.
    #[inline(always)]
    pub fn length(&self) -> f64 {
        self.dt
    }

    /// Returns whether the displacement at the end is the integral of the velocity, because the host gives no
    /// displacement.
    #[inline(always)]
    pub fn is_integrated(&self) -> bool {
        self.is_integrated
    }

    /// Returns displacement, m, and velocity, m/s, at the end of the step.
    #[inline(always)]
    pub fn end(&self) -> (f64, f64) {
        (self.x1, self.v1)
    }

    /// Returns displacement, m, and velocity, m/s, at the start of the step.
    #[inline(always)]
    pub fn start(&self) -> (f64, f64) {
        (self.x0, self.v0)
    }

    /// Returns the motion of the step with the displacement `x1`, m, and velocity `v1`, m/s, at its end, which may
    /// carry derivatives.
    #[inline(always)]
    pub fn travel<R: Real>(&self, x1: R, v1: R) -> Travel<R> {
        Travel { x0: self.x0, moved: x1.plus(-self.x0), v0: R::constant(self.v0), v1, time: self.dt }
    }

    /// Returns the point of the path at the fraction `theta` of the step, from 0 to 1.
    #[inline(always)]
    pub fn point(&self, theta: f64) -> PathPoint {
        let t2 = theta * theta;
        let t3 = t2 * theta;
        let per_dt = 1.0 / self.dt;
        // The displacement over the fraction θ of the step is x(θ) = x0 + θ (p1 + θ (p2 + θ p3)).
        let (dx, p1, q1) = (self.x1 - self.x0, self.dt * self.v0, self.dt * self.v1);
        let (p2, p3) = (3.0 * dx - 2.0 * p1 - q1, p1 + q1 - 2.0 * dx);
        PathPoint {
            x: self.x0 + theta * (p1 + theta * (p2 + theta * p3)),
            v: (p1 + theta * (2.0 * p2 + theta * (3.0 * p3))) * per_dt,
            x_by_end: [3.0 * t2 - 2.0 * t3, self.dt * (t3 - t2)],
            v_by_end: [6.0 * (theta - t2) * per_dt, 3.0 * t2 - 2.0 * theta],
            is_end: false,
        }
    }

    /// Returns the point at the end of the step, without rounding errors.
    #[inline(always)]
    pub fn last(&self) -> PathPoint {
        PathPoint { x: self.x1, v: self.v1, x_by_end: [1.0, 0.0], v_by_end: [0.0, 1.0], is_end: true }
    }
}

/// Motion of the moving end or of the internal mass over a time, a cubic like [`Path`]. Its numbers may carry
/// derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Travel<R> {
    x0: f64,
    /// Stroke: displacement at the end minus that at the start, m.
    pub moved: R,
    /// Velocity at the start, m/s.
    pub v0: R,
    /// Velocity at the end, m/s.
    pub v1: R,
    /// Duration, s.
    pub time: f64,
}

impl<R: Real> Travel<R> {
    /// Makes a motion at constant acceleration from displacement `x0`, m, and velocity `v0`, m/s, to displacement `x1`
    /// in `time`, s.
    #[inline(always)]
    pub fn accelerated(x0: R, v0: R, x1: R, time: f64) -> Travel<R> {
        let moved = x1 - x0;
        Travel { x0: x0.value(), moved, v0, v1: moved * (2.0 / time) - v0, time }
    }

    /// Returns the coefficients, m/s, of the velocity p_0 + p_1 θ + p_2 θ² over the fraction θ of the time.
    #[inline(always)]
    pub fn velocity(&self) -> [R; 3] {
        let (mean, v0, v1) = (self.moved * (1.0 / self.time), self.v0, self.v1);
        [v0, mean * 6.0 - v0 * 4.0 - v1 * 2.0, (v0 + v1) * 3.0 - mean * 6.0]
    }

    /// Returns the displacement, m, at the fraction `theta` of the time, without the derivatives of the displacement at
    /// the start. `velocity` is the result of [`Travel::velocity`].
    #[inline(always)]
    pub fn place(&self, velocity: &[R; 3], theta: R) -> R {
        let [p0, p1, p2] = *velocity;
        let reached = (p0 + (p1 * 0.5 + p2 * (1.0 / 3.0) * theta) * theta) * theta;
        (reached * self.time).plus(self.x0)
    }
}
