//! Step and mass of the host, as options of `dashpot check` and of every export.

use crate::quantity::seconds;
use dashpot_core::Params;
use dashpot_core::family::Definition;
use dashpot_simulation::chatter::{Host, HostError, Ready};

/// Properties of the host that affect chatter.
#[derive(clap::Args, Debug, Clone)]
pub struct HostArgs {
    /// Step of the host, s, for the assessment of chatter
    #[arg(long, value_name = "S", value_parser = seconds, default_value_t = Host::TYPICAL.step, allow_negative_numbers = true)]
    host_step: f64,
    /// Lightest mass that the damper moves, kg
    #[arg(long, value_name = "KG", default_value_t = Host::TYPICAL.mass, allow_negative_numbers = true)]
    wheel_mass: f64,
    /// Replace friction that chatters in a host of this step, s, by presliding friction. The resulting change of force is reported
    #[arg(long, value_name = "S", value_parser = seconds, allow_negative_numbers = true)]
    for_step: Option<f64>,
}

impl HostArgs {
    /// Checks the damper for chatter in the host. With `--for-step`, also replaces friction that chatters.
    pub fn ready(&self, params: &Params) -> Result<Ready, HostError> {
        Ready::prepare(params, self.host_step, self.wheel_mass, self.for_step)
    }
    /// Applies [`HostArgs::ready`] at each setting of an adjustable damper, or once with the setting `None` to an ordinary damper.
    pub fn ready_at_settings(&self, damper: &Definition) -> Result<Vec<(Option<f64>, Ready)>, HostError> {
        Ready::prepare_at_settings(damper, self.host_step, self.wheel_mass, self.for_step)
    }
}
