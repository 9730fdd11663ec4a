//! What the rig adds to a record that the damper did not do: skew between channels, load-cell zero, drift.
//!
//! These belong to the measurement. They are taken out of the comparison and never put into the model.

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

/// An artefact of the measurement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Artefact {
    /// The force channel lags the motion channels, s.
    Delay,
    /// It passes a low-pass filter that makes it late by so much, s.
    LowPass,
    /// A mass between load cell and damper moves with the damper's end, kg.
    Mass,
    /// The gain of the load cell moves with the campaign's clock, 1/s.
    GainDrift,
    /// The load cell does not read zero without load, N.
    Offset,
    /// Its zero was set anew after this time on the campaign's clock, s: a step, N.
    Step(u32),
    /// The zero of the load cell moves with the campaign's clock, N/s.
    Drift,
    /// It settles while the rig warms up, within this time on the campaign's clock, s: the whole way, N.
    WarmUp(u32),
    /// Friction as a share of the force, as of a tilted cross-head that loads the guides.
    Guide(Load),
    /// The growth of that share with displacement, 1/m.
    GuideAlong(Load),
    /// A rate-independent loop over force, as a fraction of the force.
    ///
    /// The load cell reverses within this force, N.
    Loop(u32),
    /// A resonance at this frequency, Hz, in phase with the force and across, as shares of it.
    Ring(u32),
    /// A resonance at this frequency, Hz, in quadrature: in phase with the rate of the force, as a fraction of it.
    RingAcross(u32),
}

impl Artefact {
    /// Name in the vocabulary; a gain that drifts is looked for in fits alone.
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

    /// Name of its one number.
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

    /// Unit of its number.
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

    /// Sizes that a rig shows.
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

    /// Position between the damper and the record: mechanical parts, then the load cell, then its gain, then its zero.
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
    /// A delay is the force of an earlier motion ([`earlier`]); a filter is [`low_pass`] at finer steps.
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

    /// Force that one unit of its number adds all through a test; `None` where it is no constant.
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
