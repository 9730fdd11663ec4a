//! Injected effects that no catalog of damper models contains. They occur on real rigs or in dampers. The correct
//! diagnosis is a missing effect without a name.

mod crosshead_tilt;
mod hose_resonance;
mod load_cell_hysteresis;
mod position_lag_loop;
mod rig_resonance;
mod self_pumping;
mod shear_softening;
mod start_up_memory;
mod stick_slip_bursts;
mod third_harmonic;
mod wear_step;

use super::{DamperEffect, Recipe};

/// Draws the effect with a given name, which the caller has verified.
pub(super) fn draw(name: &str, recipe: &mut Recipe) -> Box<dyn DamperEffect> {
    match name {
        "unknown_shear_softening" => shear_softening::draw(recipe),
        "unknown_rig_resonance" => rig_resonance::draw(recipe),
        "unknown_crosshead_tilt" => crosshead_tilt::draw(recipe),
        "unknown_load_cell_hysteresis" => load_cell_hysteresis::draw(recipe),
        "unknown_start_up_memory" => start_up_memory::draw(recipe),
        "unknown_position_lag_loop" => position_lag_loop::draw(recipe),
        "unknown_third_harmonic" => third_harmonic::draw(recipe),
        "unknown_stick_slip_bursts" => stick_slip_bursts::draw(recipe),
        "unknown_hose_resonance" => hose_resonance::draw(recipe),
        "unknown_wear_step" => wear_step::draw(recipe),
        _ => self_pumping::draw(recipe),
    }
}
