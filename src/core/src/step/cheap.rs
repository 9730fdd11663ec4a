//! The cheap step: linearly implicit Euler, in closed form and without side effects.
//!
//! The method is backward Euler with linearized forces on the mass, so it needs no iteration. h is the length of the
//! step. The mass m is at X with velocity V before the step, and at x_m with u after it. The moving end is at x with
//! velocity v after the step. Then
//!
//! ```text
//! x_m = X + h u,   m (u − V) = h [k_s (x − x_m) + c_s (v − u) − F̃_p(x_m) − F̃_d(u)].
//! ```
//!
//! k_s and c_s are stiffness and damping of the series compliance. F̃_p is the tangent of the springs on the mass at
//! the displacement that the mass would reach at V. v_0 is the velocity of the moving end before the step. F̃_d is a
//! line through the FV curve F_d at v̂ = V + v − v_0, the velocity of a mass that follows the moving end. F̃_d is the
//! tangent there or the secant to standstill, whichever is steeper:
//!
//! - The secant F̃_d(u) = F_d(0) + s u with s ≥ 0 is a linear dashpot, which dissipates energy for all s and h. With a
//!   digressive curve, the tangent would still have a large force at standstill and accelerate the mass.
//! - With a progressive curve, the tangent is steeper. It gives a step of Newton's method from the steep side, which
//!   does not overshoot. The secant would be too flat, and the solution would oscillate.
//!
//! Both lines differ from F_d(u) by at most O(h), because u − v̂ is O(h). The force acts over h, so the method is of
//! first order. Both lines are linear in u, so the step and its derivatives have closed forms.
//!
//! A linearization is inaccurate far from its position. When the moving end reverses, v̂ may lie near standstill or
//! inside a jump of the curve. A spring with a table has another derivative beyond its next point. In such cases the
//! step would be unphysical, so backward Euler without linearization repeats it ([`After::holds`]).

use super::reach::{springs, within_reach};
use crate::assembly::Elements;
use crate::element::{OperatingPoint, Response};
use crate::input::PathPoint;
use crate::tables::{ForceLaw, Tables};

/// State of the mass before the step, and inputs of the step.
pub(super) struct Before {
    /// Displacement, m, and velocity, m/s, of the mass.
    pub x: f64,
    pub v: f64,
    /// Increase of the moving end's velocity in the step, m/s.
    pub gain: f64,
    /// Length of the step, s.
    pub h: f64,
    /// Side force, N, and temperature, °C, from the host.
    pub side: (f64, f64),
}

/// Result of the step.
pub(super) struct After {
    /// Displacement, m, and velocity, m/s, of the mass.
    pub x: f64,
    pub v: f64,
    /// Force of the linearized FV curve, N.
    pub primary: f64,
    /// Force of the linearized springs on the mass, N.
    pub spring: f64,
    /// Derivative of the new velocity of the mass with respect to an impulse on it, 1/kg. It is 1/(m + h (c_s + s) + h²
    /// (k_s + F_p')), with mass m, step h, and series damping c_s and stiffness k_s. s is the slope of the linearized
    /// FV curve, and F_p' the stiffness of the springs on the mass.
    pub by_impulse: f64,
    /// Derivative of the new velocity of the mass with respect to the velocity about which the FV curve was linearized.
    pub by_guess: f64,
    /// Magnitude of the FV force at the velocity of its linearization, relative to that at standstill, N.
    level: f64,
    /// Force of the FV curve at standstill, N.
    offset: f64,
}

/// Speed, m/s, added to that of the FV curve's linearization to avoid a division by zero. It is far below all relevant
/// speeds.
const STANDSTILL: f64 = 1e-9;

/// Largest force of the linearized FV curve, relative to the curve's force at the velocity of the linearization, at
/// which a cheap step is accepted. With a smaller value, more steps around a reversal are repeated, each at the cost of
/// a stage. A larger value accepts forces that exceed the curve by that factor. The value is not tuned: no other value
/// was tried.
const BEYOND: f64 = 2.0;
/// Largest error of the springs' tangent, relative to the forces on the mass, at which a cheap step is accepted. It is
/// about as large as the error of the cheap method itself.
const MISSED: f64 = 0.05;

impl After {
    /// Returns whether the force of the linearized FV curve is within [`BEYOND`] times the curve's force at the
    /// velocity of the linearization.
    #[inline(always)]
    pub fn holds(&self) -> bool {
        (self.primary - self.offset).abs() <= BEYOND * self.level
    }

    /// Returns whether the tangent of the springs on the mass is accurate within [`MISSED`] after a step to `end`.
    #[inline(always)]
    pub fn springs_hold(&self, elements: &Elements<impl Tables>, end: &PathPoint, side: (f64, f64)) -> bool {
        if !elements.is_nonlinear() {
            return true;
        }
        let made = springs(elements, self.x, self.v, end.x, side).1;
        (made - self.spring).abs() <= MISSED * (made.abs() + self.primary.abs())
    }
}

impl Before {
    /// Returns the motion about which the springs on the mass are linearized in a step to `end`.
    #[inline(always)]
    pub fn springs_at(&self, end: &PathPoint) -> OperatingPoint {
        OperatingPoint {
            displacement: within_reach(self.x + self.h * self.v, end.x),
            velocity: self.v,
            side_force: self.side.0,
            temperature: self.side.1,
        }
    }
}

/// Advances the mass by one step, after which the moving end is at `end`. `springs` is the springs' force on a mass at
/// the displacement `springs_at`, m.
#[inline(always)]
pub(super) fn take(
    elements: &Elements<impl Tables>,
    before: &Before,
    end: &PathPoint,
    springs_at: f64,
    springs: Response,
) -> After {
    let e = &elements.paths.series_compliance;
    let h = before.h;
    let mut held = springs.force + springs.d_force_d_x * (before.x - springs_at);
    let mut spring_derivative = h * springs.d_force_d_x;
    // As long as no element on the mass depends on velocity, the compiler knows that this derivative is 0 and omits the
    // branch.
    if springs.d_force_d_v != 0.0 {
        held -= springs.d_force_d_v * before.v;
        spring_derivative += springs.d_force_d_v;
    }
    let inertia = e.mass + h * (e.damping + spring_derivative + h * e.stiffness);
    let drive = e.stiffness * (end.x - before.x) + e.damping * end.v;
    let offset = elements.paths.fv_curve.at_zero();
    let impulse = e.mass * before.v + h * (drive - held - offset);

    let guess = before.v + before.gain;
    let curve = elements.paths.fv_curve.above_zero(guess);
    let (speed, level) = (guess.abs() + STANDSTILL, curve.value.abs());
    let (u, primary, by_impulse, by_guess);
    if curve.derivative * speed <= level {
        // The slope of the secant is level/speed. Both sides of the balance are multiplied by the speed, so that one
        // division is enough.
        let divide = 1.0 / (inertia * speed + h * level);
        let share = impulse * divide;
        u = share * speed;
        primary = level * share;
        by_impulse = speed * divide;
        let lean = h * (level - curve.derivative * speed) * (share * divide);
        by_guess = lean * 1.0f64.copysign(guess);
    } else {
        let divide = 1.0 / (inertia + h * curve.derivative);
        u = (impulse + h * (curve.derivative * guess - curve.value)) * divide;
        primary = curve.value + curve.derivative * (u - guess);
        by_impulse = divide;
        by_guess = h * curve.curvature * (guess - u) * divide;
    }
    After {
        x: before.x + h * u,
        v: u,
        primary: offset + primary,
        spring: held + spring_derivative * u,
        by_impulse,
        by_guess,
        level: curve.value.abs(),
        offset,
    }
}
