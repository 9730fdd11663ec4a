//! Interface of an element of the damper model: the motion that acts on it, its force and state derivative, and its
//! preparation.

use crate::dual::Dual;
use crate::fault::Fault;
use crate::input::{Path, Travel};
use crate::schema::{Describe, View};

/// The motion, the side force and the temperature that act on an element.
#[derive(Clone, Copy, Debug)]
pub struct OperatingPoint {
    /// Displacement, m, extension positive.
    pub displacement: f64,
    /// Velocity, m/s, extension positive.
    pub velocity: f64,
    /// Side force, N.
    pub side_force: f64,
    /// Damper temperature, °C.
    pub temperature: f64,
}

/// Force of an element without internal state, and its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Force, N, tension positive.
    pub force: f64,
    /// Derivative of the force with respect to displacement x, N/m.
    pub d_force_d_x: f64,
    /// Derivative of the force with respect to velocity v, N s/m.
    pub d_force_d_v: f64,
}

impl Response {
    /// No force.
    pub const NONE: Response = Response { force: 0.0, d_force_d_x: 0.0, d_force_d_v: 0.0 };

    #[inline(always)]
    pub(crate) fn add(&mut self, other: Response) {
        self.force += other.force;
        self.d_force_d_x += other.d_force_d_x;
        self.d_force_d_v += other.d_force_d_v;
    }
}

/// Force and state derivative of an element with one internal state z, and their partial derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateResponse {
    /// Force, N.
    pub force: f64,
    /// Derivative of the force with respect to displacement x, N/m.
    pub d_force_d_x: f64,
    /// Derivative of the force with respect to velocity v, N s/m.
    pub d_force_d_v: f64,
    /// Derivative of the force with respect to the internal state z, N per unit of z.
    pub d_force_d_z: f64,
    /// Time derivative of the internal state, dz/dt, unit of z per s.
    pub rate: f64,
    /// Derivative of dz/dt with respect to displacement x.
    pub d_rate_d_x: f64,
    /// Derivative of dz/dt with respect to velocity v.
    pub d_rate_d_v: f64,
    /// Derivative of dz/dt with respect to the internal state z, 1/s, at most 0.
    pub d_rate_d_z: f64,
}

impl StateResponse {
    /// No force and a constant state.
    pub const NONE: StateResponse = StateResponse {
        force: 0.0,
        d_force_d_x: 0.0,
        d_force_d_v: 0.0,
        d_force_d_z: 0.0,
        rate: 0.0,
        d_rate_d_x: 0.0,
        d_rate_d_v: 0.0,
        d_rate_d_z: 0.0,
    };
}

/// State and force of an element with one internal state at the end of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndState {
    /// The internal state z at the end of the step, in its own unit.
    pub z: f64,
    /// Force, N, with total derivatives with respect to final displacement and velocity, which include the change of z.
    pub response: Response,
}

impl EndState {
    /// Computes the total derivatives of the force from the response at the end of the step. `by_end` are the
    /// derivatives of the state `z` with respect to displacement and velocity at the end of the step.
    #[inline(always)]
    pub fn new(z: f64, by_end: [f64; 2], end: &StateResponse) -> EndState {
        let response = Response {
            force: end.force,
            d_force_d_x: end.d_force_d_x + end.d_force_d_z * by_end[0],
            d_force_d_v: end.d_force_d_v + end.d_force_d_z * by_end[1],
        };
        EndState { z, response }
    }
}

/// Preparation of an element from its parameters.
pub trait Prepare: Describe + Sized {
    /// The element switched off.
    const OFF: Self;
    /// Prepares the element, and checks the conditions between its parameters that bounds of single parameters cannot
    /// express.
    ///
    /// # Errors
    /// Returns the parameter that does not fit the others.
    fn prepare(parameters: &View<Self>) -> Result<Self, Fault>;

    /// Checks whether the element can be prepared from these parameters. Large elements override it to avoid a copy in
    /// memory.
    ///
    /// # Errors
    /// Returns the parameter at fault.
    fn check(parameters: &View<Self>) -> Result<(), Fault> {
        Self::prepare(parameters).map(|_| ())
    }

    /// Prepares the element in place; large elements override this to avoid a copy.
    ///
    /// # Errors
    /// Returns the parameter that does not fit the others; the element then stays unchanged.
    fn set(&mut self, parameters: &View<Self>) -> Result<(), Fault> {
        *self = Self::prepare(parameters)?;
        Ok(())
    }

    /// Switches the element off.
    fn clear(&mut self) {
        *self = Self::OFF;
    }
}

/// An element whose force depends on the present [`OperatingPoint`] alone, without internal state.
pub trait Force {
    /// Computes the force, N, at the motion `at`, with its derivatives with respect to displacement and velocity.
    fn force(&self, at: &OperatingPoint) -> Response;

    /// Computes the result of [`Force::force`], equal bit by bit, if a few operations suffice; returns `None`
    /// otherwise.
    ///
    /// This short form suffices for most steps of most models, so [`Force::force`] rarely runs.
    #[inline(always)]
    fn at_once(&self, _: &OperatingPoint) -> Option<Response> {
        None
    }

    /// Returns whether the force may be too nonlinear for a single linearization in each implicit stage of a step.
    #[inline(always)]
    fn is_nonlinear(&self) -> bool {
        false
    }

    /// Computes the result of [`Force::force`]; requires that [`Force::is_nonlinear`] is false.
    #[inline(always)]
    fn linear_force(&self, at: &OperatingPoint) -> Response {
        self.force(at)
    }
}

/// The output, besides the total force, to which the force of an element is added.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForceComponent {
    /// No output besides the total force.
    Total,
    /// The friction force of the output.
    Friction,
    /// The gas force of the output.
    Gas,
}

/// An element with one internal state z.
pub trait StatefulForce {
    /// Returns the output, besides the total force, to which the element's force is added.
    fn component(&self) -> ForceComponent {
        ForceComponent::Total
    }
    /// Computes force, state derivative and their partial derivatives at the motion `at` and the internal state `z`.
    fn evaluate(&self, at: &OperatingPoint, z: f64) -> StateResponse;
    /// Computes the internal state z at which dz/dt is 0 under the constant motion `at`.
    fn equilibrium(&self, at: &OperatingPoint) -> f64;

    /// Computes the steady state under the motion `at` of an element that had the internal state `_z` at displacement
    /// `_from`, m.
    ///
    /// It differs from [`StatefulForce::equilibrium`] if [`StatefulForce::is_path_dependent`] is true.
    fn equilibrium_from(&self, _from: f64, _z: f64, at: &OperatingPoint) -> f64 {
        self.equilibrium(at)
    }

    /// Returns whether the steady state depends on the preceding displacements instead of the velocity, as that of a
    /// friction contact at rest.
    fn is_path_dependent(&self, _at: &OperatingPoint) -> bool {
        false
    }

    /// Returns whether the element acts on the internal mass if the series compliance carries the whole force. If the
    /// result is false, the element is always parallel to the damper.
    fn acts_on_mass(&self) -> bool {
        false
    }

    /// Computes state and force at the end of a motion of the internal mass that began at displacement `_from`, m.
    /// Called only if [`StatefulForce::acts_on_mass`] is true.
    ///
    /// The caller chooses the two variables of the derivatives. The force must not decrease with the final
    /// displacement, so that an implicit stage of the step has a unique solution. The result is [state, force in N].
    fn propagate_on_mass(&self, _from: Dual<2>, _travel: &Travel<Dual<2>>, z: Dual<2>) -> [Dual<2>; 2] {
        [z, Dual::new(0.0, [0.0; 2])]
    }

    /// Computes state and force at the end of the motion `_path` from the initial state `_z`, in closed form. The
    /// derivatives are undefined unless `_derivatives` is true.
    ///
    /// Returns `None` if there is no closed form. The step then integrates the state derivative.
    fn propagate(&self, _path: &Path, _z: f64, _derivatives: bool) -> Option<EndState>
    where
        Self: Sized,
    {
        None
    }
}

/// Visitor of the elements with an internal state, each with its own type.
pub trait StateVisitor {
    /// Visits an element; `index` is the index of its state in [`crate::State::internal`].
    fn visit<M: StatefulForce>(&mut self, index: usize, element: &M);
}
