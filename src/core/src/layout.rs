//! Which private states the memory of a state holds, so that a state outlives a switch of elements.
//!
//! The states of the elements that are on lie in memory one after the other, in an order that never changes. A layout is a bit for each
//! kind of state that is there; the place of a state follows from the bits below its own.

use crate::elements::{Elements, MAX_MEMORY};
use crate::input::Input;
use crate::model::Model;
use crate::paths::place;
use crate::state::State;

/// Tells a layout from a number that nobody wrote; no model is without it. Above all kinds, below what a double holds exactly.
const MARK: u64 = 1 << 40;
/// Kinds of states of the paths: places, of which two hold different things in different forms.
const IN_PATHS: u32 = 11;

/// The layout of an element set.
pub(crate) fn of(e: &Elements) -> f64 {
    let has = |place: usize| e.slots().of(place).is_some();
    let selective = e.frequency_selective_damping.holds_force();
    let valve = e.valve_hysteresis.holds_force();
    let kinds: [bool; IN_PATHS as usize] = [
        has(place::BUSHING),
        has(place::SLOW_BUSHING),
        has(place::COLUMN),
        has(place::VOID),
        has(place::SELECTIVE) && !selective && !e.has_passage(),
        has(place::SELECTIVE) && selective && !e.has_passage(),
        has(place::SELECTIVE) && e.has_passage(),
        has(place::VALVE) && !valve,
        has(place::VALVE) && valve,
        has(place::VALVE_RATE),
        has(place::HEAT),
    ];
    let in_paths = kinds.iter().rev().fold(0, |bits, on| bits << 1 | u64::from(*on));
    (MARK | e.memory_bits() << IN_PATHS | in_paths) as f64
}

/// The bits of a layout that a state bears; nothing where it is none.
fn bits(layout: f64) -> Option<u64> {
    let bits = layout as u64;
    (bits & MARK != 0 && bits < 2 * MARK && bits as f64 == layout).then_some(bits)
}

/// Where a kind of state lies in memory, if it is there.
fn slot(bits: u64, kind: u32) -> Option<usize> {
    let (own, below) = (1 << kind, (1 << kind) - 1);
    let slot = (bits & below).count_ones() as usize;
    (bits & own != 0 && slot < MAX_MEMORY).then_some(slot)
}

impl Model {
    /// Whether the private states of a state are those of this model.
    #[inline(always)]
    pub(crate) fn has_laid_out(&self, state: &State) -> bool {
        state.layout == self.layout
    }

    /// A state as this model has it: what an element remembers goes with it, and an element that was off begins settled where the
    /// driven end is. A state whose layout nobody wrote is taken for one of this model.
    #[cold]
    #[inline(never)]
    pub fn laid_out(&self, state: &State) -> State {
        let own = State { layout: self.layout, ..*state };
        let (Some(before), Some(now)) = (bits(state.layout), bits(self.layout)) else { return own };
        if before == now {
            return own;
        }
        let mut memory = self.settled(&Input::motion(state.displacement, state.velocity)).memory;
        for kind in 0..MARK.trailing_zeros() {
            if let (Some(from), Some(to)) = (slot(before, kind), slot(now, kind))
                && let (Some(from), Some(to)) = (state.memory.get(from), memory.get_mut(to))
            {
                *to = *from;
            }
        }
        State { memory, ..own }
    }
}
