//! What acts in a stage of the coupled paths, as bits: the stages of common dampers are compiled for their own.

use super::place;
use crate::elements::Elements;

/// The series compliance.
pub const SERIES: u32 = 1;
/// Free play in it.
pub const FREE_PLAY: u32 = 1 << 1;
/// A bushing in it.
pub const BUSHING: u32 = 1 << 2;
/// The oil column.
pub const COLUMN: u32 = 1 << 3;
/// Air in the oil column.
pub const AIR: u32 = 1 << 4;
/// Cavitation.
pub const CAVITATION: u32 = 1 << 5;
/// Position-dependent damping.
pub const POSITION: u32 = 1 << 6;
/// Temperature fade.
pub const FADE: u32 = 1 << 7;
/// The damper's own heat.
pub const HEAT: u32 = 1 << 8;
/// Frequency-selective damping.
pub const SELECTIVE: u32 = 1 << 9;
/// Valve hysteresis.
pub const VALVE: u32 = 1 << 10;
/// Flow beside the valves through a groove.
pub const GROOVE: u32 = 1 << 11;
/// Flow beside the valves through the passage of frequency-selective damping.
pub const PASSAGE: u32 = 1 << 12;
/// A length of the oil column that depends on the place.
pub const LENGTH: u32 = 1 << 13;
/// A part of the bushing that gives way slowly.
pub const SLOW_BUSHING: u32 = 1 << 14;
/// A valve with mass.
pub const SPOOL: u32 = 1 << 15;
/// Friction and gas on the internal mass.
pub const WHOLE: u32 = 1 << 16;
/// Whatever the model says.
pub const ANY: u32 = u32::MAX;

/// Those that scale the FV curve slowly and do nothing else.
const FACTORS: u32 = FADE | HEAT;

/// The bits of an element set.
pub(crate) fn of(e: &Elements) -> u32 {
    let mut acting = 0;
    for (bit, on) in [
        (SERIES, e.has_series()),
        (FREE_PLAY, e.has_free_play()),
        (BUSHING, e.has_bushing()),
        (SLOW_BUSHING, e.has_slow_bushing()),
        (COLUMN, e.has_column()),
        (AIR, e.has_aeration()),
        (LENGTH, e.has_length()),
        (CAVITATION, e.has_cavitation()),
        (POSITION, e.has_position()),
        (GROOVE, e.has_groove()),
        (PASSAGE, e.has_passage()),
        (FADE, e.has_fade()),
        (HEAT, e.temperature_fade.heats_itself),
        (SELECTIVE, e.has_frequency_selective()),
        (VALVE, e.has_valve()),
        (SPOOL, e.has_spool()),
        (WHOLE, e.carries_whole()),
    ] {
        if on {
            acting |= bit;
        }
    }
    acting
}

/// Whether the elements of the paths bend the forces more sharply within a step than the plain damper does.
pub(crate) fn is_sharp(e: &Elements) -> bool {
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
pub(crate) fn bends(e: &Elements) -> Bends {
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

/// Whether one acts in a stage that is compiled for those `ON`.
#[inline(always)]
pub fn acts<const ON: u32>(e: &Elements, bit: u32) -> bool {
    if ON == ANY { e.acting() & bit != 0 } else { ON & bit != 0 }
}

/// Whether a state moves in a stage that is compiled for those `ON`. Where it is compiled for any, all are taken to: to add
/// nothing costs less than to ask.
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
