//! Finds a wrong unit that explains the deviation of a test from the reference.
//!
//! The reference is the largest set of agreeing tests at one setting.

use super::Seen;
use super::reference::Reference;
use crate::numbers::median;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use crate::tuning::deviating_tests::{AS_LIKELY, BEYOND_DAMPERS, CLOSE, CLOSE_BEYOND, FEWEST, OFF};
use crate::tuning::plausibility::LARGEST_AMPLITUDE;

/// Units that a channel of a test may have instead of the one that the file states.
#[derive(Debug, PartialEq)]
pub(super) struct WrongUnit {
    /// Root mean square residual with the best of the units `likely`, as a natural logarithm of the force ratio.
    pub(super) left: f64,
    pub(super) channel: Channel,
    pub(super) written: Unit,
    /// Units that are about equally likely, in the order of [`Unit`].
    pub(super) likely: Vec<Unit>,
}

/// Another unit of a channel that makes a test agree with the reference.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    /// Root mean square residual with the unit `likely`, as a natural logarithm of the force ratio.
    left: f64,
    channel: Channel,
    written: Unit,
    likely: Unit,
}

/// Returns the channel whose unit is likely wrong, with its likely units. Returns `None` if a damper may cause the
/// deviation (below [`OFF`]), or if the user gave the unit. Also returns `None` if no other unit makes the test agree
/// with the reference.
pub(super) fn find_wrong_unit(test: &Seen<'_>, reference: &Reference<'_>) -> Option<WrongUnit> {
    let mut as_read: Vec<f64> = reference.deviations(test, 1.0, 1.0).iter().map(|off| off.abs()).collect();
    if as_read.len() >= FEWEST && median(&mut as_read) < OFF {
        return None;
    }
    let motion = if test.unit(Channel::Displacement).is_some() { Channel::Displacement } else { Channel::Velocity };
    let mut candidates: Vec<Candidate> = Vec::new();
    for channel in [Channel::Force, motion, Channel::Time] {
        let Some(written) = test.unit(channel).filter(|_| !test.reading.options.units.contains_key(&channel)) else {
            continue;
        };
        let units = Unit::ALL.into_iter().filter(|u| u.dimension() == written.dimension() && *u != written);
        candidates.extend(units.filter_map(|likely| evaluate(test, reference, channel, written, likely)));
    }
    let best = candidates.iter().copied().min_by(|a, b| a.left.total_cmp(&b.left))?;
    let as_likely = candidates.iter().filter(|s| s.channel == best.channel && s.left < best.left + AS_LIKELY);
    let mut likely: Vec<Unit> = as_likely.map(|s| s.likely).collect();
    likely.sort();
    Some(WrongUnit { left: best.left, channel: best.channel, written: best.written, likely })
}

/// Evaluates another unit of a channel. Returns `None` unless the test agrees with the reference in that unit and the
/// unit is plausible.
fn evaluate(
    test: &Seen<'_>,
    reference: &Reference<'_>,
    channel: Channel,
    written: Unit,
    likely: Unit,
) -> Option<Candidate> {
    let factor = likely.to_si(1.0) / written.to_si(1.0);
    let (of_force, of_velocity) = match channel {
        Channel::Force => (factor, 1.0),
        Channel::Time => (1.0, 1.0 / factor),
        _ => (1.0, factor),
    };
    let off = reference.deviations(test, of_force, of_velocity);
    // The other tests must cover most velocities of the rescaled test, because only common velocities allow a
    // comparison.
    if off.len() < FEWEST || 2 * off.len() < test.levels.len() {
        return None;
    }
    let left = (off.iter().map(|o| o * o).sum::<f64>() / off.len() as f64).sqrt();
    let beyond = factor.max(1.0 / factor) >= BEYOND_DAMPERS;
    let amplitude =
        if channel == Channel::Displacement { factor * test.record.amplitude } else { test.record.amplitude };
    let steps = reference.tests.iter().map(|t| libm::log(t.step()));
    let usual_step = median(&mut steps.collect::<Vec<_>>());
    let step = libm::log(test.step());
    let fits = match channel {
        // No setting of a damper and no gas force explains a factor beyond all dampers.
        Channel::Force => beyond || !reference.gas_speaks_against(test, factor),
        // A wrong unit of time also changes the sampling, so the right unit moves the time step toward that of the
        // other tests. A wrong unit of displacement does not change the time step.
        Channel::Time => (step + libm::log(factor) - usual_step).abs() < (step - usual_step).abs(),
        _ => amplitude < LARGEST_AMPLITUDE,
    };
    let close = if beyond { CLOSE_BEYOND } else { CLOSE };
    (left < close && fits && (beyond || reference.are_as_short(test, amplitude))).then_some(Candidate {
        left,
        channel,
        written,
        likely,
    })
}
