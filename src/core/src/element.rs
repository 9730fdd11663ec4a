//! What an element is: the motion that it sees, what it answers, and how it is made ready.

use crate::fault::Fault;
use crate::input::Path;
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

/// Force of an element without memory, and its slopes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Force, N, tension positive.
    pub force: f64,
    /// ∂F/∂x, N/m.
    pub by_x: f64,
    /// ∂F/∂v, N s/m.
    pub by_v: f64,
}

impl Response {
    /// Nothing.
    pub const NONE: Response = Response { force: 0.0, by_x: 0.0, by_v: 0.0 };

    #[inline(always)]
    pub(crate) fn add(&mut self, other: Response) {
        self.force += other.force;
        self.by_x += other.by_x;
        self.by_v += other.by_v;
    }
}

/// Force and state rate of an element with one private state, and their slopes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recall {
    /// Force, N.
    pub force: f64,
    /// ∂F/∂x.
    pub by_x: f64,
    /// ∂F/∂v.
    pub by_v: f64,
    /// ∂F/∂z.
    pub by_memory: f64,
    /// dz/dt.
    pub rate: f64,
    /// ∂(dz/dt)/∂x.
    pub rate_by_x: f64,
    /// ∂(dz/dt)/∂v.
    pub rate_by_v: f64,
    /// ∂(dz/dt)/∂z, at most 0.
    pub rate_by_memory: f64,
}

impl Recall {
    /// Nothing.
    pub const NONE: Recall = Recall {
        force: 0.0,
        by_x: 0.0,
        by_v: 0.0,
        by_memory: 0.0,
        rate: 0.0,
        rate_by_x: 0.0,
        rate_by_v: 0.0,
        rate_by_memory: 0.0,
    };
}

/// What an element with one private state has come to at the end of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// The state z.
    pub memory: f64,
    /// Force there; its slopes are those over displacement and velocity at the end of the step, what z takes of them included.
    pub answer: Response,
}

impl Reached {
    /// From what the element answers at the end, with the slopes of z over displacement and velocity there.
    #[inline(always)]
    pub fn new(memory: f64, by_end: [f64; 2], recall: &Recall) -> Reached {
        let answer = Response {
            force: recall.force,
            by_x: recall.by_x + recall.by_memory * by_end[0],
            by_v: recall.by_v + recall.by_memory * by_end[1],
        };
        Reached { memory, answer }
    }
}

/// How an element is made ready from its parameters.
pub trait Prepare: Describe + Sized {
    /// The element switched off.
    const OFF: Self;
    /// Checks what the bounds of single parameters cannot, and precomputes.
    ///
    /// # Errors
    /// The parameter that does not fit the others.
    fn prepare(parameters: &View<Self>) -> Result<Self, Fault>;

    /// Whether it can be made ready; large elements have one of their own, which takes no room for it.
    ///
    /// # Errors
    /// Whether the element can be prepared from these parameters.
    ///
    /// # Errors
    /// The parameter at fault.
    fn check(parameters: &View<Self>) -> Result<(), Fault> {
        Self::prepare(parameters).map(|_| ())
    }

    /// As [`Prepare::prepare`], where the element is kept; large elements have one of their own.
    ///
    /// # Errors
    /// The same; nothing is changed then.
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
    /// Force and slopes.
    fn force(&self, at: &Motion) -> Response;

    /// The same to the bit where it takes a handful of operations: what most steps of most models need. `None` where it
    /// takes more; [`Force::force`] is then asked, out of the way of the quick.
    #[inline(always)]
    fn at_once(&self, _: &Motion) -> Option<Response> {
        None
    }

    /// Whether it bends so sharply that a straight line may not hold for a stage.
    #[inline(always)]
    fn bends(&self) -> bool {
        false
    }

    /// [`Force::force`] of one that does not.
    #[inline(always)]
    fn unbent(&self, at: &Motion) -> Response {
        self.force(at)
    }
}

/// Where the answer counts the force of an element beside the damper, besides the total.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Share {
    /// Nowhere else.
    Total,
    /// In the friction.
    Friction,
    /// In the gas force.
    Gas,
}

/// An element with one private state z.
pub trait Memory {
    /// Where the answer counts its force.
    fn share(&self) -> Share {
        Share::Total
    }
    /// Force, state rate and all slopes at state `z`.
    fn recall(&self, at: &Motion, z: f64) -> Recall;
    /// The state after the motion has been held long enough.
    fn settled(&self, at: &Motion) -> f64;

    /// The same of one that was `z` where the driven end stood at `from`: another where it keeps at rest what brought it there.
    fn held(&self, _from: f64, _z: f64, at: &Motion) -> f64 {
        self.settled(at)
    }

    /// Whether it does: then it follows the displacement alone, and no velocity that is held for an instant.
    fn keeps(&self, _at: &Motion) -> bool {
        false
    }

    /// State and force after the motion along a path, in closed form (the slopes mean nothing where no `slopes` are asked for).
    /// `None` where there is no such form: the step then integrates the rate.
    fn carried(&self, _path: &Path, _z: f64, _slopes: bool) -> Option<Reached>
    where
        Self: Sized,
    {
        None
    }
}

/// Who is shown elements with memory one by one, each as what it is.
pub trait VisitMemory {
    /// The element whose state has this place.
    fn visit<M: Memory>(&mut self, place: usize, element: &M);
}
