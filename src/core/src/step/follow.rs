//! The stages of a step as passed to observers, and the derivatives of the output computed from the stages.

use super::tableau::MOST_STAGES;
use crate::assembly::Elements;
use crate::element::Response;
use crate::input::PathPoint;
use crate::math::pair;
use crate::tables::{Owned, Tables};

/// Values of one stage that are necessary for derivatives of the step.
#[derive(Clone, Copy, Debug)]
pub struct Stage<'a> {
    /// Index of the stage in its substep.
    pub index: usize,
    /// Whether the stage ends the substep.
    pub last: bool,
    /// γh of the stage, s.
    pub g: f64,
    /// Weights of the gains, g × rate, of the previous stages.
    pub row: &'a [f64],
    /// Motion of the moving end.
    pub path: PathPoint,
    /// Known part of the velocity of the mass, V.
    pub known_velocity: f64,
    /// Displacement of the mass after the stage.
    pub x_m: f64,
    /// Velocity of the mass after the stage.
    pub u: f64,
    /// a + g F_d', the denominator of every derivative of u.
    pub denominator: f64,
    /// The `denominator` divided by g, N s/m.
    pub resistance: f64,
    /// Linearized force of the springs on the mass.
    pub inner: Response,
    /// Position about which the springs on the mass were linearized.
    pub inner_at: f64,
    /// ∂u/∂v̂, where the FV curve was linearized about the velocity v̂; 0 if the curve itself was solved.
    pub by_guess: f64,
    /// Derivatives of v̂ with respect to displacement and velocity at the end of the step, through the motion of the
    /// moving end.
    pub guess_by_end: [f64; 2],
    /// Derivative of the linearized spring force with respect to the position of its linearization.
    pub line: Line,
}

/// Derivative of the linearized spring force at the mass with respect to the position x̂ of its linearization.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// ∂F̃_p/∂x̂ = F_p''(x̂) (x_m − x̂), N/m; 0 for a linear spring, and where no derivative is requested.
    pub by_place: f64,
    /// Quantity on which x̂ depends.
    pub origin: LineOrigin,
}

/// Quantity on which the position of the springs' linearization depends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineOrigin {
    /// The known displacement plus γh times the velocity of the previous stage.
    Predicted,
    /// The moving end, because the prediction lies beyond the reach of the series spring.
    Reach,
    /// The solution, because the springs were linearized again until the tangent was accurate.
    Solution,
}

impl Line {
    /// The line of a linear spring.
    pub const CONSTANT: Line = Line { by_place: 0.0, origin: LineOrigin::Predicted };
}

/// Observer of the stages of a step, used for derivatives. The observer does not affect the step.
pub trait Follow<T: Tables = Owned> {
    /// Returns whether the derivatives of the output are requested.
    #[inline(always)]
    fn wants_derivatives(&self) -> bool {
        false
    }

    /// Called after every stage.
    fn stage(&mut self, elements: &Elements<T>, stage: &Stage);

    /// Returns the derivatives of k_s x_m + c_s v_m with respect to displacement and velocity at the end of the step.
    /// The motion of the mass reduces the derivatives of the series force by these values. They are 0 if the output
    /// treats the mass as fixed.
    #[inline(always)]
    fn yields(&self) -> [f64; 2] {
        [0.0; 2]
    }
}

/// Derivatives of the mass's motion with respect to displacement and velocity at the end of the step.
pub(super) struct ByEnd {
    /// Whether the derivatives are requested.
    wanted: bool,
    /// Whether any state depends on the end of the step; false before the first substep ends.
    moved: bool,
    x: [f64; 2],
    v: [f64; 2],
    /// Derivatives of k_s x_m + c_s v_m, by which the motion of the mass reduces the derivatives of the series force.
    yields: [f64; 2],
    /// Derivatives of the previous stage's velocity, from which the next stage predicts its position.
    predicted: [f64; 2],
    /// Derivatives of g × velocity and g × acceleration, for each stage of the substep.
    gains: [[[f64; 2]; 2]; MOST_STAGES],
}

impl ByEnd {
    #[inline(always)]
    pub fn new(wanted: bool) -> ByEnd {
        let zero = [0.0; 2];
        ByEnd { wanted, moved: false, x: zero, v: zero, yields: zero, predicted: zero, gains: [[zero; 2]; MOST_STAGES] }
    }
}

impl<T: Tables> Follow<T> for ByEnd {
    #[inline(always)]
    fn wants_derivatives(&self) -> bool {
        self.wanted
    }

    #[inline(always)]
    fn stage(&mut self, elements: &Elements<T>, s: &Stage) {
        if !self.wanted {
            return;
        }
        let e = &elements.paths.series_compliance;
        let divide = 1.0 / s.resistance;
        let follows = e.damping + s.g * e.stiffness;
        let drive = s.path.drive_by_end(e.stiffness, e.damping);
        let (mut x, mut v) = ([0.0; 2], [0.0; 2]);
        let mut u = drive.map(|d| d * divide);
        let mut yields = [0.0; 2];
        // The start of a first stage does not depend on the end of the step.
        if s.index > 0 || self.moved {
            (x, v) = (self.x, self.v);
            for (a, [moved, push]) in s.row.iter().zip(&self.gains).take(s.index) {
                x = pair(|k| x[k] + a * moved[k]);
                v = pair(|k| v[k] + a * push[k]);
            }
            let (mass_rate, stiffness) = (e.mass / s.g, e.stiffness + s.inner.d_force_d_x);
            u = pair(|k| (mass_rate * v[k] + (drive[k] - stiffness * x[k])) * divide);
        }
        if s.line.by_place != 0.0 {
            let by_place = s.line.by_place;
            u = match s.line.origin {
                LineOrigin::Predicted => pair(|k| u[k] - by_place * (x[k] + s.g * self.predicted[k]) * divide),
                LineOrigin::Reach => pair(|k| u[k] - by_place * s.path.x_by_end[k] * divide),
                // The linearization is about the solution, x + g u.
                LineOrigin::Solution => {
                    let share = 1.0 / (s.resistance + s.g * by_place);
                    pair(|k| (s.resistance * u[k] - by_place * x[k]) * share)
                }
            };
        }
        if s.by_guess != 0.0 {
            u = pair(|k| u[k] + s.by_guess * (v[k] + s.guess_by_end[k]));
        }
        if s.last {
            yields = pair(|k| e.stiffness * x[k] + follows * u[k]);
        }
        self.predicted = u;
        let moved = u.map(|u| s.g * u);
        if s.last {
            self.x = pair(|k| x[k] + moved[k]);
            self.v = u;
            self.yields = yields;
            self.moved = true;
        } else if let Some(gains) = self.gains.get_mut(s.index) {
            *gains = [moved, pair(|k| u[k] - v[k])];
        }
    }

    #[inline(always)]
    fn yields(&self) -> [f64; 2] {
        self.yields
    }
}
