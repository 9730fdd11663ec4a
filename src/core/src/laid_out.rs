//! Conversion of a state after elements were switched on or off: see [`crate::layout`].

use crate::input::Input;
use crate::layout::{MARK, bits, slot};
use crate::model::Model;
use crate::state::State;
use crate::tables::Tables;

impl<T: Tables> Model<T> {
    /// Returns whether a state has the layout of this model.
    #[inline(always)]
    pub(crate) fn has_laid_out(&self, state: &State) -> bool {
        state.layout == self.layout
    }

    /// Converts a state to the layout of this model, as [`Model::laid_out`] does.
    #[cold]
    #[inline(never)]
    pub(crate) fn converted(&self, state: &State) -> State {
        let own = State { layout: self.layout, ..*state };
        let (Some(before), Some(now)) = (bits(state.layout), bits(self.layout)) else { return own };
        if before == now {
            return own;
        }
        let mut internal = self.equilibrium(&Input::motion(state.displacement, state.velocity)).internal;
        for kind in 0..MARK.trailing_zeros() {
            if let (Some(from), Some(to)) = (slot(before, kind), slot(now, kind))
                && let (Some(from), Some(to)) = (state.internal.get(from), internal.get_mut(to))
            {
                *to = *from;
            }
        }
        State { internal, ..own }
    }
}

impl Model {
    /// Converts a state to this model's layout.
    ///
    /// Each internal state moves to the new index of its element. An element that was off begins in equilibrium with
    /// the motion of the moving end. A state without a layout counts as a state of this model.
    #[cold]
    #[inline(never)]
    pub fn laid_out(&self, state: &State) -> State {
        self.converted(state)
    }
}
