//! What an element is: the motion that it sees, its force and state derivative, and how it is prepared.

use crate::dual::Dual;
use crate::fault::Fault;
use crate::input::{Path, Travel};
use crate::schema::{Describe, View};

/// The motion that an element sees, and what surrounds it.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
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
    /// ∂F/∂x, N/m.
    pub d_force_d_x: f64,
    /// ∂F/∂v, N s/m.
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
    /// ∂F/∂x.
    pub d_force_d_x: f64,
    /// ∂F/∂v.
    pub d_force_d_v: f64,
    /// ∂F/∂z.
    pub d_force_d_z: f64,
    /// dz/dt.
    pub rate: f64,
    /// ∂(dz/dt)/∂x.
    pub d_rate_d_x: f64,
    /// ∂(dz/dt)/∂v.
    pub d_rate_d_v: f64,
    /// ∂(dz/dt)/∂z, at most 0.
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
    /// The state z.
    pub z: f64,
    /// Force, with total derivatives over displacement and velocity at the end of the step: they include the change of z.
    pub response: Response,
}

impl EndState {
    /// Combines the response at the end with the derivatives of z over displacement and velocity there.
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

/// Prepares an element from its parameters.
pub trait Prepare: Describe + Sized {
    /// The element switched off.
    const OFF: Self;
    /// Checks what the bounds of single parameters cannot, and precomputes.
    ///
    /// # Errors
    /// The parameter that does not fit the others.
    fn prepare(parameters: &View<Self>) -> Result<Self, Fault>;

    /// Whether the element can be prepared from these parameters; large elements override this to need no memory for it.
    ///
    /// # Errors
    /// The parameter at fault.
    fn check(parameters: &View<Self>) -> Result<(), Fault> {
        Self::prepare(parameters).map(|_| ())
    }

    /// Prepares the element in place; large elements override this to avoid a copy.
    ///
    /// # Errors
    /// The parameter that does not fit the others; nothing is changed then.
    fn set(&mut self, parameters: &View<Self>) -> Result<(), Fault> {
        *self = Self::prepare(parameters)?;
        Ok(())
    }

    /// Switches it off.
    fn clear(&mut self) {
        *self = Self::OFF;
    }
}

/// An element whose force depends on the present motion alone.
pub trait Force {
    /// Force and derivatives.
    fn force(&self, at: &Motion) -> Response;

    /// [`Force::force`] to the bit, if that is a handful of operations; `None` otherwise.
    ///
    /// Most steps of most models need no more, and the long code stays out of their way.
    #[inline(always)]
    fn at_once(&self, _: &Motion) -> Option<Response> {
        None
    }

    /// Whether the force is so nonlinear that a line may not hold for a stage.
    #[inline(always)]
    fn is_nonlinear(&self) -> bool {
        false
    }

    /// Equals [`Force::force`] if [`Force::is_nonlinear`] is false.
    #[inline(always)]
    fn linear_force(&self, at: &Motion) -> Response {
        self.force(at)
    }
}

/// The component of the output that the force of an element adds to, besides the total.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForceComponent {
    /// The total alone.
    Total,
    /// The friction.
    Friction,
    /// The gas force.
    Gas,
}

/// An element with one internal state z.
pub trait StatefulForce {
    /// The component of the output that its force adds to.
    fn component(&self) -> ForceComponent {
        ForceComponent::Total
    }
    /// Force, state derivative and all partial derivatives at state `z`.
    fn evaluate(&self, at: &Motion, z: f64) -> StateResponse;
    /// The steady state at constant motion.
    fn equilibrium(&self, at: &Motion) -> f64;

    /// The steady state of an element that was in state `z` with its moving end at `from`.
    ///
    /// It differs from [`StatefulForce::equilibrium`] where [`StatefulForce::is_path_dependent`].
    fn equilibrium_from(&self, _from: f64, _z: f64, at: &Motion) -> f64 {
        self.equilibrium(at)
    }

    /// Whether the state at rest depends on the displacement that led there, and not on the velocity of an instant.
    fn is_path_dependent(&self, _at: &Motion) -> bool {
        false
    }

    /// Whether it acts on the internal mass where the series compliance carries the whole. Beside the damper otherwise.
    fn acts_on_mass(&self) -> bool {
        false
    }

    /// State and force at the end of a travel of the mass that began at `_from`. Asked only where
    /// [`StatefulForce::acts_on_mass`].
    ///
    /// The two directions are what the caller chooses. The force must not fall as the end moves on: a stage then has one answer.
    fn propagate_on_mass(&self, _from: Dual<2>, _travel: &Travel<Dual<2>>, z: Dual<2>) -> [Dual<2>; 2] {
        [z, Dual::new(0.0, [0.0; 2])]
    }

    /// State and force after the motion along a path, in closed form. The derivatives are undefined unless requested.
    ///
    /// `None` if there is no such form: the step then integrates the state derivative.
    fn propagate(&self, _path: &Path, _z: f64, _derivatives: bool) -> Option<EndState>
    where
        Self: Sized,
    {
        None
    }
}

/// Visits the elements with an internal state one by one, each with its own type.
pub trait StateVisitor {
    /// Visits the element whose state has this index.
    fn visit<M: StatefulForce>(&mut self, index: usize, element: &M);
}
