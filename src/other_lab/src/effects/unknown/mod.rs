//! Injected effects that no catalog of damper models contains. They occur on real rigs or in dampers. The correct
//! diagnosis is a missing effect without a name.

mod amplifier_switch;
mod cogging;
mod frame_ring;
mod load_cell_loop;
mod resting_gel;
mod scaled_stroke;
mod stick_slip_burst;
mod tilted_head;
mod wear_step;

use super::{Effect, EffectModel, Here, Make, Reading, Unknown, soft_sign};
use crate::draw::Draw;
use crate::plant::Scale;

pub(super) const ALL: &[Unknown] = &[
    Unknown { effect: tilted_head::EFFECT, has_detector: true },
    Unknown { effect: frame_ring::EFFECT, has_detector: true },
    Unknown { effect: load_cell_loop::EFFECT, has_detector: true },
    Unknown { effect: stick_slip_burst::EFFECT, has_detector: false },
    Unknown { effect: resting_gel::EFFECT, has_detector: false },
    Unknown { effect: scaled_stroke::EFFECT, has_detector: false },
    Unknown { effect: wear_step::EFFECT, has_detector: false },
    Unknown { effect: amplifier_switch::EFFECT, has_detector: false },
    Unknown { effect: cogging::EFFECT, has_detector: false },
];
