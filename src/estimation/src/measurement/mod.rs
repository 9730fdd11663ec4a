//! Measurement errors that the rig adds to a record: skew between channels, load-cell zero, drift.
//!
//! The comparison of forces corrects these errors. The model of the damper does not contain them.

mod force_loop;
mod guide;
mod inertia;
mod low_pass;
mod motion;
mod resonance;
mod second_order;

use super::segment::Segment;
use force_loop::loop_over_force;
pub use guide::Load;
use guide::guide;
use inertia::inertia;
pub use low_pass::low_pass;
pub use motion::{earlier, finer};
use resonance::resonance;

/// A measurement error of the rig.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Artefact {
    /// The force channel lags the motion channels, s.
    Delay,
    /// A low-pass filter delays the force channel by this time, s.
    LowPass,
    /// A mass between load cell and damper moves with the damper's end, kg.
    Mass,
    /// The gain of the load cell drifts with the campaign's clock, 1/s.
    GainDrift,
    /// The reading of the load cell without load differs from zero, N.
    Offset,
    /// The zero changed by a step, N, at this time on the campaign's clock, s, because it was set again.
    Step(u32),
    /// The zero of the load cell drifts with the campaign's clock, N/s.
    Drift,
    /// The zero drifts exponentially by a total drift, N, while the rig warms up. This is the time constant on the
    /// campaign's clock, s.
    WarmUp(u32),
    /// Friction as a fraction of the force, for example because a tilted cross-head loads the guides.
    Guide(Load),
    /// Increase of the friction fraction with displacement, 1/m.
    GuideAlong(Load),
    /// Rate-independent hysteresis of the load cell, as a fraction of the force.
    ///
    /// After a reversal, the sign of the added force changes over this force range, N.
    Loop(u32),
    /// A resonance at this frequency, Hz, in phase with the force, as a fraction of the force.
    Ring(u32),
    /// A resonance at this frequency, Hz, in quadrature with the force: in phase with the rate of the force, and a
    /// fraction of that rate.
    RingAcross(u32),
}

impl Artefact {
    /// Returns the name of the error in the vocabulary. Only fits search for a gain drift.
    pub fn name(self) -> &'static str {
        match self {
            Artefact::Delay | Artefact::LowPass => "channel_delay",
            Artefact::Mass => "moving_mass",
            Artefact::GainDrift => "gain_drift",
            Artefact::Offset | Artefact::Step(_) => "force_offset",
            Artefact::Drift | Artefact::WarmUp(_) => "force_drift",
            Artefact::Guide(_) | Artefact::GuideAlong(_) => "load_dependent_friction",
            Artefact::Loop(_) => "load_cell_hysteresis",
            Artefact::Ring(_) | Artefact::RingAcross(_) => "resonance",
        }
    }

    /// Returns the name of the error's parameter.
    pub fn parameter(self) -> &'static str {
        match self {
            Artefact::Delay | Artefact::LowPass => "delay",
            Artefact::Mass => "rig_mass",
            Artefact::GainDrift => "gain_drift",
            Artefact::Offset | Artefact::Step(_) => "offset",
            Artefact::Drift => "drift",
            Artefact::WarmUp(_) => "whole_drift",
            Artefact::Guide(_) | Artefact::Loop(_) | Artefact::Ring(_) => "share",
            Artefact::RingAcross(_) => "share_across",
            Artefact::GuideAlong(_) => "share_growth",
        }
    }

    /// Returns the unit of the error's parameter.
    pub fn unit(self) -> &'static str {
        match self {
            Artefact::Delay | Artefact::LowPass => "s",
            Artefact::Mass => "kg",
            Artefact::GainDrift => "1/s",
            Artefact::Offset | Artefact::Step(_) | Artefact::WarmUp(_) => "N",
            Artefact::Drift => "N/s",
            Artefact::Guide(_) | Artefact::Loop(_) | Artefact::Ring(_) | Artefact::RingAcross(_) => "-",
            Artefact::GuideAlong(_) => "1/m",
        }
    }

    /// Returns the range of values that occur on rigs.
    pub fn bounds(self) -> (f64, f64) {
        let most = match self {
            Artefact::Delay | Artefact::LowPass => 5e-3,
            Artefact::Mass => 30.0,
            Artefact::GainDrift => 1e-3,
            Artefact::Offset | Artefact::Step(_) | Artefact::WarmUp(_) => 500.0,
            Artefact::Drift => 1.0,
            Artefact::Guide(_) | Artefact::Loop(_) | Artefact::Ring(_) | Artefact::RingAcross(_) => 0.5,
            Artefact::GuideAlong(_) => 10.0,
        };
        (if matches!(self, Artefact::LowPass | Artefact::Mass) { 0.0 } else { -most }, most)
    }

    /// Returns the position between the damper and the record: mechanical parts, then the load cell, then its gain, then its zero.
    pub fn position_in_channel(self) -> u8 {
        match self {
            Artefact::Mass | Artefact::Guide(_) | Artefact::GuideAlong(_) => 0,
            Artefact::Ring(_) | Artefact::RingAcross(_) => 1,
            Artefact::Loop(_) => 2,
            Artefact::GainDrift => 3,
            Artefact::Offset | Artefact::Step(_) | Artefact::Drift | Artefact::WarmUp(_) => 4,
            Artefact::Delay | Artefact::LowPass => 5,
        }
    }

    /// Applies the measurement error to the forces at the samples of a test.
    ///
    /// A delay and a filter are excluded: a delay uses the force of an earlier motion ([`earlier`]), a filter uses
    /// [`low_pass()`] at finer steps.
    pub fn apply(self, value: f64, segment: &Segment, forces: &mut [f64]) {
        match self {
            Artefact::Delay | Artefact::LowPass => {}
            Artefact::Mass => inertia(value, &segment.dt, &segment.input, forces),
            Artefact::GainDrift => forces.iter_mut().for_each(|f| *f *= 1.0 + value * segment.clock),
            Artefact::Guide(load) => guide(value, false, load, &segment.input, forces),
            Artefact::GuideAlong(load) => guide(value, true, load, &segment.input, forces),
            Artefact::Ring(hz) => resonance(value, f64::from(hz), false, &segment.dt, forces),
            Artefact::RingAcross(hz) => resonance(value, f64::from(hz), true, &segment.dt, forces),
            Artefact::Loop(width) => loop_over_force(value, f64::from(width), forces),
            Artefact::Offset | Artefact::Step(_) | Artefact::Drift | Artefact::WarmUp(_) => {
                let added = value * self.per_value(segment).unwrap_or(0.0);
                forces.iter_mut().for_each(|f| *f += added);
            }
        }
    }

    /// Returns the constant force per unit of the parameter in a test, or `None` if the force is not constant.
    pub fn per_value(self, segment: &Segment) -> Option<f64> {
        match self {
            Artefact::Delay
            | Artefact::LowPass
            | Artefact::Mass
            | Artefact::GainDrift
            | Artefact::Guide(_)
            | Artefact::GuideAlong(_)
            | Artefact::Loop(_)
            | Artefact::Ring(_)
            | Artefact::RingAcross(_) => None,
            Artefact::Offset => Some(1.0),
            Artefact::Step(after) => Some(f64::from(u8::from(segment.clock > f64::from(after)))),
            Artefact::Drift => Some(segment.clock),
            Artefact::WarmUp(time) => Some(1.0 - libm::exp(-segment.clock / f64::from(time))),
        }
    }
}
