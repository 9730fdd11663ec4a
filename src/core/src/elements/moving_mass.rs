//! Moving mass between load cell and damper, or oil in a long passage.
//!
//! In the first case, the eye, the clamp and a tube of the damper move with the load cell. In the second case, the
//! piston accelerates the oil.

use crate::dual::{Dual, Real};
use crate::element::{EndState, OperatingPoint, Prepare, Response, StateResponse, StatefulForce};
use crate::fault::Fault;
use crate::input::Path;
use crate::math::{pair, relaxation};
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Moving mass with the force F = M (v − z)/τ and the state equation dz/dt = (v − z)/τ.
///
/// M is the mass, kg, and v the velocity of the point that moves it, m/s. Hosts give displacement and velocity but no
/// acceleration. Therefore a stiff damper M/τ drives the mass, which has the velocity z. This damper only dissipates
/// energy, and the force lags that of an ideal mass by the time τ, s.
///
/// *Inside*: M moves with the piston, behind the series stiffness, as a part of the internal mass. Oil of mass m in a
/// passage of area a counts as M = m (A/a)² with the piston area A. Without a series stiffness the piston moves with the
/// moving end.
#[derive(Clone, Copy, Debug)]
pub struct MovingMass {
    is_inside: bool,
    /// Mass over its lag, M/τ, N s/m.
    damping: f64,
    /// One over the lag, 1/τ, 1/s.
    per_time: f64,
}

impl Describe for MovingMass {
    const MEANING: &'static str =
        "inertia of a mass between load cell and damper, which the moving end drives, or of one that the piston drives";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("moving_mass", "kg", &[2.0], (0.0, 100.0), "moving mass, M"),
        Parameter::scalar(
            "moving_mass_time",
            "s",
            &[2e-4],
            (1e-4, 1e-2),
            "lag of the inertia force, tau; short compared with the motion",
        ),
        Parameter::choice(
            "moving_mass_place",
            &["driven end", "inside"],
            "point that drives the mass: moving end of the damper, or piston behind the series stiffness",
        ),
    ];
}

impl Prepare for MovingMass {
    const OFF: Self = MovingMass { is_inside: false, damping: 0.0, per_time: 1.0 };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let per_time = 1.0 / p.number(own!("moving_mass_time"));
        Ok(MovingMass {
            is_inside: p.number(own!("moving_mass_place")) == 1.0,
            damping: p.number(own!("moving_mass")) * per_time,
            per_time,
        })
    }
}

impl MovingMass {
    /// Adds a moving mass inside the damper to the `internal` mass, kg; the element then has no force of its own.
    pub(crate) fn join(&mut self, internal: &mut f64) {
        if self.is_inside {
            *internal += self.damping / self.per_time;
            self.damping = 0.0;
        }
    }

    /// Returns the coefficients, m/s, of the velocity p_0 + p_1 θ + p_2 θ² over the fraction θ of a step. The velocity
    /// at both ends of the step is that of the host.
    ///
    /// Inertia follows from velocities. The displacement over the step gives the mean velocity and thus the curvature
    /// p_2. The curvature is limited to the change of the acceleration since the start of the step. At the start, the
    /// acceleration is (v_0 − z)/τ, with the host's velocity v_0, the velocity `z` of the mass and its lag τ. If the
    /// host samples a given motion, the limit does not reduce the order of accuracy. A semi-implicit host advances
    /// displacement with the velocity at one end of the step. Without the limit, that displacement would imply a
    /// curvature of three times the change of velocity. A mass of 2 kg would act as −2 or as 6 kg.
    ///
    /// If the curvature is at most that of 1 nm of displacement, rounding decides whether the limit applies. The
    /// derivatives are then those of a velocity that is linear in time. If the limit is also this small, the
    /// derivatives are those of the limit.
    #[inline(always)]
    fn velocity<R: Real>(&self, path: &Path, z: f64, x1: R, v1: R) -> [R; 3] {
        let [start, _, by_displacement] = path.travel(x1, v1).velocity();
        let change = v1 - start;
        // The displacement of an integrated path is the integral of a linear velocity, so it contains no curvature.
        if path.is_integrated() {
            return [start, change, R::constant(0.0)];
        }
        let growth = change.plus((z - start.value()) * (self.per_time * path.length()));
        let (given, most) = (by_displacement.value(), growth.value());
        let small = NEAR * (6.0 / path.length());
        let curvature = if !(given * most > 0.0) {
            if most.abs() <= small { growth.chain(0.0, 1.0) } else { R::constant(0.0) }
        } else if given.abs() >= most.abs() {
            growth
        } else if given.abs() > small {
            by_displacement
        } else if most.abs() <= small {
            growth.chain(given, 1.0)
        } else {
            R::constant(given)
        };
        [start, change - curvature, curvature]
    }
}

/// Largest difference of displacements, m, that counts as zero. It is below the precision of a host's displacement, and
/// below its change between two iterates of the host's solver.
const NEAR: f64 = 1e-9;

impl StatefulForce for MovingMass {
    fn evaluate(&self, at: &OperatingPoint, z: f64) -> StateResponse {
        let behind = at.velocity - z;
        StateResponse {
            force: self.damping * behind,
            d_force_d_v: self.damping,
            d_force_d_z: -self.damping,
            rate: behind * self.per_time,
            d_rate_d_v: self.per_time,
            d_rate_d_z: -self.per_time,
            ..StateResponse::NONE
        }
    }

    fn equilibrium(&self, at: &OperatingPoint) -> f64 {
        at.velocity
    }

    /// Computes state and force at the end of the path, exactly for the quadratic velocity of [`MovingMass::velocity`].
    fn propagate(&self, path: &Path, z: f64, derivatives: bool) -> Option<EndState> {
        let (kept, takes) = relaxation(path.length() * self.per_time);
        let (x1, v1) = path.end();
        let after = |p: [f64; 3]| takes[0] * p[0] + takes[1] * p[1] + takes[2] * p[2];
        let end = kept * z + after(self.velocity(path, z, x1, v1));
        let mut by_end = [0.0; 2];
        if derivatives {
            let by = self.velocity(path, z, Dual::<2>::along(x1, 0), Dual::along(v1, 1));
            by_end = pair(|k| after(by.map(|p| p.derivatives[k])));
        }
        let response = Response {
            force: self.damping * (v1 - end),
            d_force_d_x: -self.damping * by_end[0],
            d_force_d_v: self.damping - self.damping * by_end[1],
        };
        Some(EndState { z: end, response })
    }
}
