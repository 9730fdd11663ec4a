//! A damper made ready for a host: judged at its step and, where that is asked for, with friction that would chatter replaced.

use super::host::Host;
use super::in_host::{Chatter, chatter};
use super::softened::{Softened, softened};
use crate::{followed, stiffness};
use dashpot_core::Params;
use dashpot_core::family::Definition;
use dashpot_identification::model_file::{NoModel, prepared};
use serde::Serialize;

/// Why a damper cannot be judged in a host.
#[derive(Debug, thiserror::Error)]
pub enum HostError {
    /// No step of a host.
    #[error("{name} is in s and lies between 1e-6 and 0.1, not {step}")]
    Step {
        /// Which option gave it.
        name: &'static str,
        /// What was given.
        step: f64,
    },
    /// No mass that a damper moves.
    #[error("--wheel-mass is in kg and lies between 0.001 and 100000, not {0}")]
    Mass(f64),
    /// The parameters do not make a model.
    #[error(transparent)]
    Model(#[from] NoModel),
    /// What the kernel refuses.
    #[error("{0}")]
    Rejected(&'static str),
    /// Friction of a damper over a setting that would have to be replaced.
    #[error(
        "at the setting {setting} {element} chatters in a host of that step, and --for-step replaces friction of an ordinary damper alone; write that with dashpot setting MODEL {setting} -o one.toml, or fit presliding friction"
    )]
    OverSetting {
        /// The setting.
        setting: f64,
        /// The element.
        element: &'static str,
    },
}

/// A damper for a host.
pub struct Ready {
    /// The damper.
    pub params: Params,
    /// The host.
    pub host: Host,
    /// What it does there.
    pub chatter: Chatter,
    /// What was replaced for it.
    pub softened: Option<Softened>,
    /// Whether replacing was asked for.
    asked: bool,
}

/// What `dashpot check --json` writes.
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
    /// The damper in a host of a step, s, and a mass, kg; in that of `for_step`, where one is given, made ready for it.
    ///
    /// # Errors
    /// [`HostError`].
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

    /// The damper at each value of its setting; an ordinary damper as it is.
    ///
    /// # Errors
    /// The errors of [`Ready::prepare`]; [`HostError::OverSetting`] where friction would have to be replaced at a setting, for then its numbers
    /// over the setting would be lost.
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

    /// In sentences.
    pub fn messages(&self) -> Vec<String> {
        let mut lines = self.replaced();
        lines.push(self.chatter.describe(self.host, self.asked));
        lines.extend(self.unfollowed());
        lines
    }

    /// What was replaced, in sentences.
    pub fn replaced(&self) -> Vec<String> {
        self.softened.iter().map(Softened::describe).collect()
    }

    /// Chatter, where there is some, and a mass that the step does not follow.
    pub fn remarks(&self) -> Vec<String> {
        let chatters = self.chatter.rings().then(|| self.chatter.describe(self.host, self.asked));
        chatters.into_iter().chain(self.unfollowed()).collect()
    }

    /// What must be known beside an export: what was replaced, and what is to be remarked where there is something.
    pub fn notes(&self) -> Vec<String> {
        match self.softened {
            Some(_) => self.messages(),
            None => self.remarks(),
        }
    }

    /// A mass that the step does not follow, in a sentence.
    fn unfollowed(&self) -> Option<String> {
        prepared(&self.params).ok().and_then(|model| followed::remark(&model, self.host.step))
    }

    /// How fast its states are for a host that integrates them itself, in a sentence where that is to be known.
    ///
    /// # Errors
    /// Where the parameters make no model.
    pub fn stiffness(&self) -> Result<Option<String>, NoModel> {
        Ok(stiffness::remark(&prepared(&self.params)?))
    }

    /// The figures.
    ///
    /// # Errors
    /// Where the parameters make no model.
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
