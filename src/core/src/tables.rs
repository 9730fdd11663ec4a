//! The large tables that elements read, and their owners.
//!
//! A model owns its tables. A model at a setting between two grid values exists for one step. It borrows the tables
//! from the family and stores nothing large: see [`crate::family`]. The formulas of the elements are the same for both
//! kinds of model.

use crate::curve::{Above, Value};
use core::fmt::Debug;
use core::ops::{Deref, DerefMut};

/// A force that does not decrease with velocity: the FV curve.
pub trait ForceLaw: Copy + Debug {
    /// Returns force and derivative at a velocity.
    fn evaluate(&self, u: f64) -> Value;

    /// Returns the force relative to that at standstill, with derivative and curvature.
    fn above_zero(&self, u: f64) -> Above;

    /// Returns the force at standstill.
    fn at_zero(&self) -> f64;

    /// Returns the velocity u with `a u + f(u) = r` for `a > 0`, with force and derivative there.
    ///
    /// See [`crate::curve::Curve::solve`].
    fn solve<const STEPS: usize>(&self, a: f64, r: f64) -> (f64, Value);

    /// Returns the first and the last velocity of the points.
    fn range(&self) -> (f64, f64);
}

/// A table that is only evaluated.
pub trait Lookup: Copy + Debug {
    /// Returns value and derivative at a position.
    fn lookup(&self, u: f64) -> Value;
}

/// Conductance of a valve passage at one force.
#[derive(Clone, Copy, Debug)]
pub struct Conducted {
    /// Conductance g = W²/h, m²/(N s²), where W is the velocity at which the FV curve has the force h.
    pub g: f64,
    /// Derivative dg/dh.
    pub by_h: f64,
}

/// Conductance of a valve passage as a function of the force.
pub trait Conduction: Copy + Debug {
    /// Returns g at the force h along a stroke; `stroke` is the sign of the stroke.
    fn conducted(&self, curve: &impl ForceLaw, h: f64, stroke: f64) -> Conducted;
}

/// Owner of the tables of a model.
pub trait Tables: Copy + Debug {
    /// Whether each common set of elements has its own compiled stages. Otherwise all sets share one compiled stage,
    /// which makes the library smaller and the steps slower.
    const HAS_STAGES_OF_ITS_OWN: bool;
    /// The FV curve.
    type Fv: ForceLaw;
    /// The table of a spring.
    type Spring: Lookup;
    /// The conductance of a lagging valve.
    type Conductance: Conduction;
    /// A small element `E`, owned by the model or borrowed from the family.
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

/// The model itself as the owner.
#[derive(Clone, Copy, Debug)]
pub struct Owned;
