//! The large tables that elements read, and their owners.
//!
//! A model owns its tables. A model at a setting between two grid values exists for one step. It borrows the tables
//! from the family and stores nothing large: see [`crate::family`]. Both kinds of model use the same formulas of the
//! elements.

use crate::curve::{Above, Value};
use core::fmt::Debug;
use core::ops::{Deref, DerefMut};

/// A force that does not decrease with velocity: the FV (force–velocity) curve.
pub trait ForceLaw: Copy + Debug {
    /// Returns force, N, and derivative, N s/m, at the velocity `u`, m/s.
    fn evaluate(&self, u: f64) -> Value;

    /// Returns the force relative to that at standstill, N, with derivative and curvature, at the velocity `u`, m/s.
    fn above_zero(&self, u: f64) -> Above;

    /// Returns the force at zero velocity, N.
    fn at_zero(&self) -> f64;

    /// Returns the velocity u, m/s, with `a u + f(u) = r` for `a > 0`, with the force f and its derivative there.
    ///
    /// See [`crate::curve::Curve::solve`].
    fn solve<const STEPS: usize>(&self, a: f64, r: f64) -> (f64, Value);

    /// Returns the first and the last velocity of the curve's points, m/s.
    fn range(&self) -> (f64, f64);
}

/// A lookup table of a spring force, which is only evaluated.
pub trait Lookup: Copy + Debug {
    /// Returns the force, N, and its derivative, N/m, at the displacement `u`, m.
    fn lookup(&self, u: f64) -> Value;
}

/// Conductance of a valve passage at one force.
#[derive(Clone, Copy, Debug)]
pub struct Conducted {
    /// Conductance g = W²/h, m²/(N s²), where W is the velocity at which the FV curve has the force h.
    pub g: f64,
    /// Derivative dg/dh of the conductance with respect to the force.
    pub by_h: f64,
}

/// Conductance of a valve passage as a function of the force.
pub trait Conduction: Copy + Debug {
    /// Returns the conductance at the force `h`, N, along a stroke; `stroke` is 1 for rebound and −1 for compression.
    fn conducted(&self, curve: &impl ForceLaw, h: f64, stroke: f64) -> Conducted;
}

/// Owner of the tables of a model.
pub trait Tables: Copy + Debug {
    /// Whether each common set of elements has its own compiled stages. If false, all sets share one compiled stage,
    /// which makes the library smaller and the steps slower.
    const HAS_STAGES_OF_ITS_OWN: bool;
    /// The FV curve.
    type Fv: ForceLaw;
    /// The table of a spring.
    type Spring: Lookup;
    /// The conductance of a lagging valve.
    type Conductance: Conduction;
    /// A small element `E`, owned by the model or borrowed from a family of dampers.
    type Kept<E: Copy + Debug + 'static>: Deref<Target = E> + Copy + Debug;
}

/// An element that a model owns.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct OwnedElement<E>(pub E);

impl<E> Deref for OwnedElement<E> {
    type Target = E;

    #[inline(always)]
    fn deref(&self) -> &E {
        &self.0
    }
}

impl<E> DerefMut for OwnedElement<E> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut E {
        &mut self.0
    }
}

/// Marker of a model that owns its tables itself.
#[derive(Clone, Copy, Debug)]
pub struct Owned;
