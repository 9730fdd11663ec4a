//! Elements of the force path that act in a stage of the step, and the nonlinearity of their forces. The stages of
//! common sets of elements are compiled separately.

use super::Paths;
use super::bits::{
    AIR, ANY, BUSHING, CAVITATION, COLUMN, FADE, FREE_PLAY, GROOVE, HEAT, LENGTH, PASSAGE, POSITION, SELECTIVE, SERIES,
    SLOW_BUSHING, SPOOL, VALVE,
};
use super::slots::place;
use crate::tables::Tables;

/// Elements that only scale the FV curve, by a factor that changes slowly: fade and self-heating.
const FACTORS: u32 = FADE | HEAT;

/// Returns whether an element is on that makes the force more nonlinear within a step than the FV curve and the series
/// compliance alone.
pub(crate) fn is_sharp(e: &Paths<impl Tables>) -> bool {
    e.acting() & !(SERIES | FACTORS) != 0
}

/// Nonlinearity that the elements of the force paths cause within a step, in ascending order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Nonlinearity {
    /// Little: only the FV curve and the series compliance, with or without fade. A bypass flow counts as little, too.
    /// So does a lagging valve whose state is its opening, because the lag smooths the knee of the valve.
    Little,
    /// A bushing alone.
    Smoothly,
    /// A knee: free play, a symmetric oil column, position or frequency dependence, or a valve with play alone.
    Knee,
    /// A void, air, a valve with mass, or several elements.
    Several,
    /// An oil column whose stiffness changes with the sign of the force, or an oil column together with an element
    /// other than air and void.
    Turning,
    /// Friction behind the series spring, which reverses within a short displacement.
    Whole,
}

/// Returns the nonlinearity of an element set.
pub(crate) fn nonlinearity(e: &Paths<impl Tables>) -> Nonlinearity {
    let turns = !e.aeration.is_even() || !e.oil_compressibility.is_even();
    let acting = e.acting() & !(SERIES | FACTORS | SLOW_BUSHING | LENGTH);
    match acting {
        _ if e.carries_whole() => Nonlinearity::Whole,
        _ if turns => Nonlinearity::Turning,
        _ if acting & COLUMN != 0 && acting & !(COLUMN | AIR | CAVITATION) != 0 && acting & CAVITATION == 0 => {
            Nonlinearity::Turning
        }
        VALVE if e.valve_hysteresis.holds_force() => Nonlinearity::Knee,
        0 | GROOVE | PASSAGE | VALVE => Nonlinearity::Little,
        BUSHING => Nonlinearity::Smoothly,
        FREE_PLAY | COLUMN | POSITION | SELECTIVE => Nonlinearity::Knee,
        _ => Nonlinearity::Several,
    }
}

/// Elements that only modify other elements and have no compiled stage of their own. The program tests for them at run
/// time.
///
/// The test costs at most 1 % more instructions in a step. For the length of the oil column, or for two forms of one
/// element, a test would cost 4 to 8 %.
const ADDED: u32 = AIR | HEAT | SPOOL;

/// Returns whether a stage compiled for the elements `ON` fits an element set.
#[inline(always)]
pub fn is_for<const ON: u32>(e: &Paths<impl Tables>) -> bool {
    let acting = e.acting();
    acting & !ON == 0 && acting & !ADDED == ON & !ADDED
}

/// Returns whether an element with one of the bits `bit` acts in a stage compiled for the elements `ON`.
#[inline(always)]
pub fn acts<const ON: u32>(e: &Paths<impl Tables>, bit: u32) -> bool {
    let certain = if ON == ANY { 0 } else { !ADDED };
    ON & bit & certain != 0 || ON & bit & !certain != 0 && e.acting() & bit != 0
}

/// Returns whether a state can change in a stage compiled for the elements `ON`. The result ignores whether the element
/// is on, because adding zero costs less than a test at run time.
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
