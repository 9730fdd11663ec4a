//! The cheap step: linearly implicit Euler, in closed form. Pure.
//!
//! Backward Euler with the forces on the mass taken on straight lines, so that nothing is iterated. With the step h,
//! the mass at X with velocity V and the driven end at x, v after the step,
//!
//! ```text
//! x_m = X + h u,   m (u − V) = h [k_s (x − x_m) + c_s (v − u) − F̃_p(x_m) − F̃_d(u)].
//! ```
//!
//! F̃_p is the tangent of the springs where the mass would go at V. F̃_d is a straight line through the FV curve at
//! v̂ = V + v − v_0, where the mass would be if it followed the driven end. Its derivative is the greater of the tangent and
//! the secant to standstill:
//!
//! - by the secant F̃_d(u) = F_d(0) + s u with s ≥ 0: a dashpot, which takes energy whatever s and h are. A digressive
//!   curve's tangent would carry the force of full speed through standstill and push the mass on;
//! - a progressive curve's tangent is the greater: Newton's method from the steep side, which does not overshoot either,
//!   while its secant would fall short and swing.
//!
//! Both agree with F_d to the first order in h, so the method has order 1, and every derivative is explicit.
//!
//! A line says nothing of what lies far beyond the place it was drawn at: where the driven end turns round, v̂ may lie beside
//! standstill or inside a jump of the curve, and a spring of a table has another derivative past its next point. There the step is
//! one that no element makes, and is taken again as backward Euler proper ([`After::holds`]).

use super::reach::{springs, within_reach};
use crate::assembly::Elements;
use crate::element::{Motion, Response};
use crate::input::PathPoint;
use crate::tables::{ForceLaw, Tables};

/// The mass before the step, and what the step is given.
pub(super) struct Before {
    /// Displacement and velocity of the mass.
    pub x: f64,
    pub v: f64,
    /// What the driven end's velocity gains in the step.
    pub gain: f64,
    /// h.
    pub h: f64,
    /// Side force and temperature.
    pub side: (f64, f64),
}

/// What the step came to.
pub(super) struct After {
    /// Displacement and velocity of the mass.
    pub x: f64,
    pub v: f64,
    /// F̃_d.
    pub primary: f64,
    /// F̃_p.
    pub spring: f64,
    /// ∂u/∂(impulse on the mass): 1/(m + h (c_s + s) + h² (k_s + F_p')), 1/kg.
    pub by_impulse: f64,
    /// ∂u/∂v̂: how far the answer leans on the guess.
    pub by_guess: f64,
    /// |F_d(v̂) − F_d(0)|.
    level: f64,
    /// F_d(0).
    offset: f64,
}

/// Speed beside which a secant is not taken any shorter, m/s: far below all that matters.
const STANDSTILL: f64 = 1e-9;

/// How far beyond the force at v̂ the line may lead, as a factor. Less has more steps taken again where the driven end turns
/// round, at the cost of a stage; more lets the force be so many times that of the curve. Not tuned: one value was tried.
const BEYOND: f64 = 2.0;
/// What the springs' tangent may miss, as a part of the forces on the mass: about the error of the method.
const MISSED: f64 = 0.05;

impl After {
    /// Whether the FV curve's line was left near the place it was drawn at.
    #[inline(always)]
    pub fn holds(&self) -> bool {
        (self.primary - self.offset).abs() <= BEYOND * self.level
    }

    /// Derivatives of the springs in a step to `end`.
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
    /// Where the springs on the mass are linearised in a step to `end`.
    #[inline(always)]
    pub fn springs_at(&self, end: &PathPoint) -> Motion {
        Motion {
            displacement: within_reach(self.x + self.h * self.v, end.x),
            velocity: self.v,
            side_force: self.side.0,
            temperature: self.side.1,
        }
    }
}

/// Moves the mass by one step to the driven end at `end`; `springs` are those on the mass at `springs_at`.
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
    // Known to the compiler to be 0 while no element on the mass depends on velocity.
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
        // s = level/speed, with both sides of the balance times the speed: one division in all.
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
