//! Preparation of a damper for a host: a check at the host's step and, on request, the replacement of friction that would chatter.

use super::host::Host;
use super::in_host::{Chatter, chatter};
use super::softened::{Softened, softened};
use crate::{followed, stiffness};
use dashpot_core::Params;
use dashpot_core::family::Definition;
use dashpot_identification::model_file::{NoModel, prepared};
use dashpot_messages::format_number;
use serde::Serialize;

/// Reason why a damper cannot be checked in a host.
#[derive(Debug, thiserror::Error)]
pub enum HostError {
    /// The step is outside the range of hosts.
    #[error("{name} is in s and lies between 1e-6 and 0.1, not {}", format_number(*step))]
    Step {
        /// Name of the option.
        name: &'static str,
        /// Given step, s.
        step: f64,
    },
    /// The mass is outside the range of masses that a damper moves.
    #[error("--wheel-mass is in kg and lies between 0.001 and 100000, not {}", format_number(*.0))]
    Mass(f64),
    /// The parameters do not form a valid model.
    #[error(transparent)]
    Model(#[from] NoModel),
    /// The kernel rejects the parameters.
    #[error("{0}")]
    Rejected(&'static str),
    /// The damper depends on a setting, and its friction chatters at one of the settings.
    #[error(
        "at the setting {at} {element} chatters in a host of that step, and --for-step replaces friction of an ordinary damper alone; write that with dashpot setting MODEL {at} -o one.toml, or fit presliding friction",
        at = format_number(*setting)
    )]
    OverSetting {
        /// Setting at which the friction chatters.
        setting: f64,
        /// Element that chatters.
        element: &'static str,
    },
}

/// Damper checked in a host and, on request, prepared for it.
pub struct Ready {
    /// The damper.
    pub params: Params,
    /// The host.
    pub host: Host,
    /// Chatter of the damper in this host.
    pub chatter: Chatter,
    /// Replacements of friction for this host. `None` if no friction was replaced.
    pub softened: Option<Softened>,
    /// Whether the user requested that friction be replaced.
    asked: bool,
}

/// Output of `dashpot check --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Figures {
    host_step_s: f64,
    wheel_mass_kg: f64,
    gain: f64,
    chatters: bool,
    swings: bool,
    velocity_m_s: f64,
    damping_n_s_m: f64,
    stiffness_n_m: f64,
    place_m: f64,
    side_force_n: f64,
    temperature_c: f64,
    quiet_step_s: Option<f64>,
    element: Option<&'static str>,
    turning_force_n: Option<f64>,
    turning_steps: Option<usize>,
    grows: bool,
    calming_series_damping_n_s_m: Option<f64>,
    gain_without_it: Option<f64>,
    softened: Vec<&'static str>,
    rms_error_n: Option<f64>,
    fastest_rate_1_s: f64,
    explicit_step_s: f64,
    followed_step_s: Option<f64>,
    largest_error_n: Option<f64>,
}

impl Ready {
    /// Checks the damper in a host with this step, s, and mass, kg. If `for_step`, s, is given, it is the step of the host, and friction
    /// that chatters at this step is replaced.
    ///
    /// # Errors
    /// Returns a [`HostError`] if the damper cannot be checked.
    pub fn prepare(
        params: &Params,
        host_step: f64,
        wheel_mass: f64,
        for_step: Option<f64>,
    ) -> Result<Ready, HostError> {
        let (name, step) = for_step.map_or(("--host-step", host_step), |step| ("--for-step", step));
        if !(1e-6..=0.1).contains(&step) {
            return Err(HostError::Step { name, step });
        }
        if !(1e-3..=1e5).contains(&wheel_mass) {
            return Err(HostError::Mass(wheel_mass));
        }
        let host = Host { step, mass: wheel_mass };
        prepared(params)?;
        let refused = |fault: dashpot_core::Fault| HostError::Rejected(fault.reason.text());
        let soft = if for_step.is_some() { softened(params, host).map_err(refused)? } else { None };
        let params = soft.as_ref().map_or(*params, |s| s.params);
        let chatter = chatter(&params, host).map_err(refused)?;
        Ok(Ready { params, host, chatter, softened: soft, asked: for_step.is_some() })
    }

    /// Checks the damper at each value of its setting, or once if it is an ordinary damper.
    ///
    /// # Errors
    /// Returns the errors of [`Ready::prepare`]. Also returns [`HostError::OverSetting`] if friction would have to be replaced at a
    /// setting, because a replacement would lose the friction parameters at the other settings.
    pub fn prepare_at_settings(
        definition: &Definition,
        host_step: f64,
        wheel_mass: f64,
        for_step: Option<f64>,
    ) -> Result<Vec<(Option<f64>, Ready)>, HostError> {
        let prepare = |params: &Params| Ready::prepare(params, host_step, wheel_mass, for_step);
        let at = |setting: &f64| {
            let ready = prepare(&definition.params_at(*setting))?;
            let softened = ready.softened.iter().flat_map(|soft| &soft.softer).next();
            match softened {
                Some(one) => Err(HostError::OverSetting { setting: *setting, element: one.element().name() }),
                None => Ok((Some(*setting), ready)),
            }
        };
        match definition.axis.is_some() {
            true => definition.axis.grid().iter().map(at).collect(),
            false => Ok(vec![(None, prepare(&definition.params)?)]),
        }
    }

    /// Describes the replacements of friction, the chatter, and an internal mass whose oscillation the step does not resolve.
    pub fn messages(&self) -> Vec<String> {
        let mut lines = self.replaced();
        lines.push(self.chatter.describe(self.host, self.asked));
        lines.extend(self.unfollowed());
        lines
    }

    /// Describes the replacements of friction.
    pub fn replaced(&self) -> Vec<String> {
        self.softened.iter().map(Softened::describe).collect()
    }

    /// Describes chatter, and an internal mass whose oscillation the step does not resolve. Returns nothing if neither is present.
    pub fn remarks(&self) -> Vec<String> {
        let chatters = self.chatter.rings().then(|| self.chatter.describe(self.host, self.asked));
        chatters.into_iter().chain(self.unfollowed()).collect()
    }

    /// Returns the texts for an export: all [messages](Ready::messages) if friction was replaced, otherwise the [remarks](Ready::remarks).
    pub fn notes(&self) -> Vec<String> {
        match self.softened {
            Some(_) => self.messages(),
            None => self.remarks(),
        }
    }

    /// Describes an internal mass whose oscillation the step does not resolve. Returns `None` if there is none, or if the step resolves the
    /// oscillation.
    fn unfollowed(&self) -> Option<String> {
        prepared(&self.params).ok().and_then(|model| followed::remark(&model, self.host.step))
    }

    /// Describes the stiffness of the damper's states for hosts that integrate the states. Returns `None` if explicit steps of 1 ms are
    /// stable.
    ///
    /// # Errors
    /// Returns an error if the parameters do not form a valid model.
    pub fn stiffness(&self) -> Result<Option<String>, NoModel> {
        Ok(stiffness::remark(&prepared(&self.params)?))
    }

    /// Returns the fastest rate of the damper's states, 1/s.
    ///
    /// # Errors
    /// Returns an error if the parameters do not form a valid model.
    pub fn fastest_rate(&self) -> Result<f64, NoModel> {
        Ok(stiffness::fastest_rate(&prepared(&self.params)?))
    }

    /// Returns the results of the check as numbers.
    ///
    /// # Errors
    /// Returns an error if the parameters do not form a valid model.
    pub fn figures(&self) -> Result<Figures, NoModel> {
        let (chatter, softened) = (&self.chatter, self.softened.as_ref());
        let model = prepared(&self.params)?;
        let rate = stiffness::fastest_rate(&model);
        let followed = model.integration().longest_that_follows();
        Ok(Figures {
            host_step_s: self.host.step,
            wheel_mass_kg: self.host.mass,
            gain: chatter.gain,
            chatters: chatter.rings(),
            swings: chatter.swings(),
            velocity_m_s: chatter.velocity,
            damping_n_s_m: chatter.d_force_d_velocity,
            stiffness_n_m: chatter.d_force_d_displacement,
            place_m: chatter.situation.place,
            side_force_n: chatter.situation.side_force,
            temperature_c: chatter.situation.temperature,
            quiet_step_s: chatter.quiet_step,
            element: chatter.element.map(|e| e.0.name()),
            turning_force_n: chatter.turning.filter(|t| !t.grows()).map(|t| t.force),
            turning_steps: chatter.turning.map(|t| t.steps),
            grows: chatter.turning.is_some_and(|t| t.grows()),
            calming_series_damping_n_s_m: chatter.calming,
            gain_without_it: chatter.element.map(|e| e.1),
            softened: softened.iter().flat_map(|s| &s.softer).map(|s| s.element().name()).collect(),
            rms_error_n: softened.map(|s| s.rms_error),
            fastest_rate_1_s: rate,
            explicit_step_s: stiffness::explicit_step(rate),
            followed_step_s: Some(followed).filter(|step| step.is_finite()),
            largest_error_n: softened.map(|s| s.largest_error),
        })
    }
}
