//! What acts in a stage, and how sharply it bends the forces: the stages of common dampers are compiled for their own.

use super::Paths;
use super::bits::{
    AIR, ANY, BUSHING, CAVITATION, COLUMN, FADE, FREE_PLAY, GROOVE, HEAT, LENGTH, PASSAGE, POSITION, SELECTIVE, SERIES,
    SLOW_BUSHING, SPOOL, VALVE,
};
use super::slots::place;
use crate::tables::Tables;

/// Those that scale the FV curve slowly and do nothing else.
const FACTORS: u32 = FADE | HEAT;

/// Whether the elements of the paths bend the forces more sharply within a step than the plain damper does.
pub(crate) fn is_sharp(e: &Paths<impl Tables>) -> bool {
    e.acting() & !(SERIES | FACTORS) != 0
}

/// How sharply the elements of the paths bend the forces of a damper within a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bends {
    /// Hardly: no element at all, one that scales the FV curve slowly, or a flow or a valve that softens its own knee.
    Little,
    /// Rubber alone.
    Smoothly,
    /// Free play, an even column of oil, position, frequency, or a valve with play or mass alone: a knee in the force.
    Knee,
    /// A void, air, or several elements.
    Several,
    /// A column that turns from soft to hard with the sign of the force, or a column beside other elements.
    Turning,
    /// Friction that turns over behind the series spring.
    Whole,
}

/// How sharply those of an element set do.
pub(crate) fn is_nonlinear(e: &Paths<impl Tables>) -> Bends {
    let turns = !e.aeration.is_even() || !e.oil_compressibility.is_even();
    let acting = e.acting() & !(SERIES | FACTORS | SLOW_BUSHING | LENGTH);
    match acting {
        _ if e.carries_whole() => Bends::Whole,
        _ if turns => Bends::Turning,
        _ if acting & COLUMN != 0 && acting & !(COLUMN | AIR | CAVITATION) != 0 && acting & CAVITATION == 0 => {
            Bends::Turning
        }
        VALVE if e.valve_hysteresis.holds_force() => Bends::Knee,
        0 | GROOVE | PASSAGE | VALVE => Bends::Little,
        BUSHING => Bends::Smoothly,
        FREE_PLAY | COLUMN | POSITION | SELECTIVE => Bends::Knee,
        _ => Bends::Several,
    }
}

/// Elements that only add to others and share the stage compiled for those; the program tests for them at run time.
///
/// That costs at most one in a hundred instructions. For a length that changes, or for two forms of one element, it
/// costs four to eight.
const ADDED: u32 = AIR | HEAT | SPOOL;

/// Whether a stage that is compiled for those `ON` does for an element set.
#[inline(always)]
pub fn is_for<const ON: u32>(e: &Paths<impl Tables>) -> bool {
    let acting = e.acting();
    acting & !ON == 0 && acting & !ADDED == ON & !ADDED
}

/// Whether one acts in a stage that is compiled for those `ON`.
#[inline(always)]
pub fn acts<const ON: u32>(e: &Paths<impl Tables>, bit: u32) -> bool {
    let certain = if ON == ANY { 0 } else { !ADDED };
    ON & bit & certain != 0 || ON & bit & !certain != 0 && e.acting() & bit != 0
}

/// Whether a state moves in a stage that is compiled for those `ON`. All that may are taken to: to add nothing costs less than to ask.
#[inline(always)]
pub fn moves<const ON: u32>(state: usize) -> bool {
    let bit = match state {
        place::X | place::U => SERIES,
        place::BUSHING => BUSHING,
        place::SLOW_BUSHING => SLOW_BUSHING,
        place::COLUMN => COLUMN,
        place::VOID => CAVITATION,
        place::SELECTIVE => SELECTIVE | PASSAGE,
        place::VALVE => VALVE,
        place::VALVE_RATE => SPOOL,
        _ => HEAT,
    };
    ON & bit != 0
}
