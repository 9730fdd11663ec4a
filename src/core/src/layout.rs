//! Layout of the internal states, so that a state survives when elements are switched on or off.
//!
//! The internal states of the elements that are on are stored consecutively, in an order that never changes. A layout
//! has one bit for each kind of state. The index of a state is the number of set bits below its own bit.

use crate::assembly::Elements;
use crate::paths::place;
use crate::state::MAX_INTERNAL;

/// Bit that every layout contains, to detect uninitialized numbers. It is higher than the bits of all kinds of states,
/// and a double represents it exactly.
pub(crate) const MARK: u64 = 1 << 40;
/// Number of kinds of internal states in the force path. If the form of an element determines the physical quantity of
/// its state, each quantity is a kind of its own.
const IN_PATHS: u32 = 11;

/// Bit of the lag state of a setting's actuator in the layout of a family, above the bits of all elements.
pub(crate) const LAG: u64 = 1 << 30;
/// Bit of the hysteresis state of a setting's actuator in the layout of a family.
pub(crate) const HYSTERESIS: u64 = 1 << 31;

/// Adds the states of an actuator to a layout: of its `lag`, and of its `hysteresis`.
pub(crate) fn with_actuator(layout: f64, lag: bool, hysteresis: bool) -> f64 {
    let own = if lag { LAG } else { 0 } | if hysteresis { HYSTERESIS } else { 0 };
    (layout as u64 | own) as f64
}

/// Computes the layout of an element set.
pub(crate) fn from_elements(e: &Elements) -> f64 {
    let paths = &e.paths;
    let has = |place: usize| paths.slots().slot(place).is_some();
    let selective = paths.frequency_selective_damping.holds_force();
    let valve = paths.valve_hysteresis.holds_force();
    let kinds: [bool; IN_PATHS as usize] = [
        has(place::BUSHING),
        has(place::SLOW_BUSHING),
        has(place::COLUMN),
        has(place::VOID),
        has(place::SELECTIVE) && !selective && !paths.has_passage(),
        has(place::SELECTIVE) && selective && !paths.has_passage(),
        has(place::SELECTIVE) && paths.has_passage(),
        has(place::VALVE) && !valve,
        has(place::VALVE) && valve,
        has(place::VALVE_RATE),
        has(place::HEAT),
    ];
    let in_paths = kinds.iter().rev().fold(0, |bits, on| bits << 1 | u64::from(*on));
    (MARK | e.memory_bits() << IN_PATHS | in_paths) as f64
}

/// Returns the bits of the layout number of a state; `None` if the number is not a layout.
pub(crate) fn bits(layout: f64) -> Option<u64> {
    let bits = layout as u64;
    (bits & MARK != 0 && bits < 2 * MARK && bits as f64 == layout).then_some(bits)
}

/// Returns the index of a kind of state among the internal states. `None` if the layout does not contain the kind, or
/// if the index is beyond the internal states.
pub(crate) fn slot(bits: u64, kind: u32) -> Option<usize> {
    let (own, below) = (1 << kind, (1 << kind) - 1);
    let slot = (bits & below).count_ones() as usize;
    (bits & own != 0 && slot < MAX_INTERNAL).then_some(slot)
}
