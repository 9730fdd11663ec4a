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
    /// Weight g of the rates in the stage, s: the diagonal coefficient of the method times the length of the substep.
    pub g: f64,
    /// Weights of the gains (g times rate) of the previous stages in the known parts of this stage.
    pub row: &'a [f64],
    /// Motion of the moving end at the stage.
    pub path: PathPoint,
    /// Known part V of the velocity of the mass, m/s.
    pub known_velocity: f64,
    /// Displacement of the mass after the stage, m.
    pub x_m: f64,
    /// Velocity of the mass after the stage, u, m/s.
    pub u: f64,
    /// Derivative of the left side of the stage equation, a u + g F_d(u) = r, with respect to the velocity u of the
    /// mass, kg. It is the denominator of every derivative of u.
    pub denominator: f64,
    /// The `denominator` divided by g, N s/m.
    pub resistance: f64,
    /// Force of the springs on the mass and its derivatives at the position of the linearization.
    pub inner: Response,
    /// Position about which the springs on the mass were linearized, m.
    pub inner_at: f64,
    /// Derivative of the solution u with respect to the velocity v̂ about which the FV curve was linearized; 0 if the
    /// curve itself was solved.
    pub by_guess: f64,
    /// Derivatives of the linearization's velocity v̂ with respect to displacement and velocity at the end of the step.
    /// They contain only the effect of the moving end's motion.
    pub guess_by_end: [f64; 2],
    /// Derivative of the linearized spring force with respect to the position of its linearization.
    pub line: Line,
}

/// Derivative of the linearized spring force at the mass with respect to the position x̂ of its linearization.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// Derivative of the tangent's force at the mass with respect to x̂, N/m. It is F_p''(x̂) (x_m − x̂) for the spring
    /// force F_p and the position x_m of the mass. It is 0 for a linear spring, and if no derivatives are requested.
    pub by_place: f64,
    /// Quantity on which the position x̂ of the linearization depends.
    pub origin: LineOrigin,
}

/// Quantity on which the position of the springs' linearization depends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineOrigin {
    /// The prediction: the known displacement plus the weight g of the stage times the velocity of the previous stage.
    Predicted,
    /// The moving end, because the prediction lies beyond the reach of the series spring.
    Reach,
    /// The solution, because the springs were linearized again until the tangent was accurate.
    Solution,
}

impl Line {
    /// The linearization of a linear spring, whose tangent does not depend on the position.
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

    /// Returns the derivatives of k_s x_m + c_s v_m with respect to displacement and velocity of the moving end at the
    /// end of the step. Here k_s and c_s are series stiffness and damping, x_m and v_m the motion of the internal mass.
    /// The derivatives of the series force are reduced by these values. They are 0 if the output treats the mass as
    /// fixed.
    #[inline(always)]
    fn yields(&self) -> [f64; 2] {
        [0.0; 2]
    }
}

/// Derivatives of the mass's motion with respect to displacement and velocity at the end of the step.
pub(super) struct ByEnd {
    /// Whether the derivatives are requested.
    wanted: bool,
    /// Whether the motion of the mass already depends on the end of the step; false before the first substep ends.
    moved: bool,
    x: [f64; 2],
    v: [f64; 2],
    /// Derivatives of the mass's part of the series force, k_s x_m + c_s v_m, with respect to displacement and velocity
    /// at the end of the step. They are subtracted from the derivatives of the series force at a fixed mass. Here x_m
    /// and v_m are the motion of the mass, k_s and c_s series stiffness and damping.
    yields: [f64; 2],
    /// Derivatives of the previous stage's velocity, from which the next stage predicts its position.
    predicted: [f64; 2],
    /// Derivatives of the gains (g × velocity and g × acceleration of the mass) of each stage of the substep, with the
    /// weight g of the stage.
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
        // The start of the first stage of a step does not depend on the end of the step.
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
                // The linearization is about the solution, the position x + g u of the mass.
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
