//! Measurement errors that the rig adds to a record, for example skew between channels, a load-cell zero, drift.
//!
//! For the comparison with the record, these errors are added to the computed forces. The model of the damper does not
//! contain them.

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

/// Measurement error of the rig. Each variant states the parameter of the error and its unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Artefact {
    /// Lag of the force channel relative to the motion channels, s.
    Delay,
    /// Delay by a low-pass filter of the force channel, s.
    LowPass,
    /// Mass between load cell and damper that moves with the damper's end, kg.
    Mass,
    /// Drift of the load cell's gain with the campaign's clock, 1/s.
    GainDrift,
    /// Reading of the load cell without load, N.
    Offset,
    /// Step of the load cell's zero, N, because it was set again. The number of the variant is the time of the step on
    /// the campaign's clock, s.
    Step(u32),
    /// Drift of the load cell's zero with the campaign's clock, N/s.
    Drift,
    /// Final drift of the load cell's zero, N, which the drift approaches exponentially while the rig warms up. The
    /// number of the variant is the time constant on the campaign's clock, s.
    WarmUp(u32),
    /// Friction as a fraction of the force, for example because a tilted cross-head loads the guides.
    Guide(Load),
    /// Increase of the friction fraction with displacement, 1/m.
    GuideAlong(Load),
    /// Rate-independent hysteresis of the load cell, as a fraction of the force.
    ///
    /// The number of the variant is the force range, N, over which the sign of the added force changes after a
    /// reversal.
    Loop(u32),
    /// Factor on y''/ω², which is added to the force. The output y of a resonance follows the force, and ω is its
    /// natural frequency, rad/s. Below the resonance, y'' is in phase opposition to the force. The number of the
    /// variant is the frequency of the resonance, Hz.
    Ring(u32),
    /// Factor on y'/ω, which is added to the force. The output y of a resonance follows the force, and ω is its natural
    /// frequency, rad/s. Below the resonance, y' is in phase with the rate of the force. The number of the variant is
    /// the frequency of the resonance, Hz.
    RingAcross(u32),
}

impl Artefact {
    /// Returns the name of the error. A diagnosis reports all names except `gain_drift`, which only fits identify, and
    /// those of unnamed errors.
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

    /// Returns the range of values that occur on rigs, in the unit of the error's parameter.
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

    /// Returns the position of the error between the damper and the record. The order is mechanical parts, load cell,
    /// gain, zero, delay.
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

    /// Applies the measurement error to the forces, N, at the samples of a test. `value` is the parameter of the error.
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

    /// Returns the constant force, N, per unit of the parameter in a test, or `None` if the force is not constant.
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
