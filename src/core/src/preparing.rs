//! Elements made ready from a parameter set, one like the other.

use crate::element::Prepare;
use crate::fault::Fault;
use crate::parameter::Params;
use crate::tables::OwnedElement;

/// Whether an element can be prepared. Not inlined: each takes its room on the stack and gives it back.
#[inline(never)]
pub(crate) fn checked<E: Prepare>(params: &Params, place: usize) -> Result<(), Fault> {
    E::check(&params.view(place))
}

/// Prepares an element that [`checked`] accepted.
#[inline(never)]
pub(crate) fn placed<E: Prepare>(element: &mut E, on: bool, params: &Params, place: usize) {
    if !on || element.set(&params.view(place)).is_err() {
        element.clear();
    }
}

/// Where an element is kept, small or large.
pub(crate) trait Keep<E> {
    /// The element, to be changed.
    fn kept(&mut self) -> &mut E;
}

impl<E: Prepare> Keep<E> for E {
    #[inline(always)]
    fn kept(&mut self) -> &mut E {
        self
    }
}

impl<E: Prepare> Keep<E> for OwnedElement<E> {
    #[inline(always)]
    fn kept(&mut self) -> &mut E {
        &mut self.0
    }
}
