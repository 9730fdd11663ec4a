//! Preparation of the elements from a parameter set, common to all elements.

use crate::element::Prepare;
use crate::fault::Fault;
use crate::parameter::Params;
use crate::tables::OwnedElement;

/// Checks whether the element with the group index `place` can be prepared. Not inlined, so that its stack space is
/// freed on return.
#[inline(never)]
pub(crate) fn checked<E: Prepare>(params: &Params, place: usize) -> Result<(), Fault> {
    E::check(&params.view(place))
}

/// Prepares an element whose parameters passed [`checked`], or switches it off if `on` is false.
#[inline(never)]
pub(crate) fn placed<E: Prepare>(element: &mut E, on: bool, params: &Params, place: usize) {
    if !on || element.set(&params.view(place)).is_err() {
        element.clear();
    }
}

/// Mutable access to an element, both to a plain one and to one inside an [`OwnedElement`].
pub(crate) trait Keep<E> {
    /// Returns the element for modification.
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
