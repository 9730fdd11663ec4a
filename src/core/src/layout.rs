//! Which private states the memory of a state holds, so that a state outlives a switch of elements.
//!
//! The states of the elements that are on lie in memory one after the other, in an order that never changes. A layout is a bit for each
//! kind of state that is there; the place of a state follows from the bits below its own.

use crate::assembly::Elements;
use crate::paths::place;
use crate::state::MAX_INTERNAL;

/// Tells a layout from a number that nobody wrote; no model is without it. Above all kinds, below what a double holds exactly.
pub(crate) const MARK: u64 = 1 << 40;
/// Kinds of states of the paths: places, of which two hold different things in different forms.
const IN_PATHS: u32 = 11;

/// Kinds of states of the actuator of a family, behind all others.
pub(crate) const LAG: u64 = 1 << 30;
/// See [`LAG`].
pub(crate) const HYSTERESIS: u64 = 1 << 31;

/// A layout with the states of an actuator.
pub(crate) fn with_actuator(layout: f64, lag: bool, hysteresis: bool) -> f64 {
    let own = if lag { LAG } else { 0 } | if hysteresis { HYSTERESIS } else { 0 };
    (layout as u64 | own) as f64
}

/// The layout of an element set.
pub(crate) fn of(e: &Elements) -> f64 {
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

/// The bits of a layout that a state bears; nothing where it is none.
pub(crate) fn bits(layout: f64) -> Option<u64> {
    let bits = layout as u64;
    (bits & MARK != 0 && bits < 2 * MARK && bits as f64 == layout).then_some(bits)
}

/// Where a kind of state lies in memory, if it is there.
pub(crate) fn slot(bits: u64, kind: u32) -> Option<usize> {
    let (own, below) = (1 << kind, (1 << kind) - 1);
    let slot = (bits & below).count_ones() as usize;
    (bits & own != 0 && slot < MAX_INTERNAL).then_some(slot)
}
