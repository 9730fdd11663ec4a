//! The host's step and mass, as options of `dashpot check` and of every export, and what is said of chatter beside each.

use anyhow::{anyhow, bail};
use dashpot_core::Params;
use dashpot_identification::model_file;
use dashpot_simulation::chatter::{Chatter, Host, Softened, chatter, softened};

/// What is said of the host.
#[derive(clap::Args, Debug, Clone)]
pub struct HostArgs {
    /// Step of the host, s, at which chatter is judged
    #[arg(long, value_name = "S", default_value_t = Host::USUAL.step)]
    host_step: f64,
    /// The lightest mass that the damper moves, kg
    #[arg(long, value_name = "KG", default_value_t = Host::USUAL.mass)]
    wheel_mass: f64,
    /// Replace friction that chatters in a host of this step, s, by presliding friction; what that changes is said
    #[arg(long, value_name = "S")]
    for_step: Option<f64>,
}

impl HostArgs {
    /// The host.
    pub fn host(&self) -> anyhow::Result<Host> {
        let step = self.for_step.unwrap_or(self.host_step);
        let name = if self.for_step.is_some() { "--for-step" } else { "--host-step" };
        if !(1e-6..=0.1).contains(&step) {
            bail!("{name} is in s and lies between 1e-6 and 0.1, not {step}");
        }
        if !(1e-3..=1e5).contains(&self.wheel_mass) {
            bail!("--wheel-mass is in kg and lies between 0.001 and 100000, not {}", self.wheel_mass);
        }
        Ok(Host { step, mass: self.wheel_mass })
    }

    /// The damper as the host gets it, and what is to be said of it there.
    pub fn ready(&self, params: &Params) -> anyhow::Result<Ready> {
        let host = self.host()?;
        model_file::prepared(params)?;
        let refused = |fault: dashpot_core::Fault| anyhow!("{}", fault.reason.text());
        let soft = if self.for_step.is_some() { softened(params, host).map_err(refused)? } else { None };
        let params = soft.as_ref().map_or(*params, |s| s.params);
        let chatter = chatter(&params, host).map_err(refused)?;
        Ok(Ready { params, host, chatter, softened: soft, asked: self.for_step.is_some() })
    }
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
    /// Whether `--for-step` was asked for.
    asked: bool,
}

impl Ready {
    /// In sentences.
    pub fn told(&self) -> Vec<String> {
        let mut lines: Vec<String> = self.softened.iter().map(Softened::told).collect();
        lines.push(self.chatter.told(self.host, self.asked));
        lines
    }

    /// What was replaced, in sentences.
    pub fn replaced(&self) -> Vec<String> {
        self.softened.iter().map(Softened::told).collect()
    }

    /// Chatter, where there is some.
    pub fn chatters(&self) -> Vec<String> {
        self.chatter.rings().then(|| self.chatter.told(self.host, self.asked)).into_iter().collect()
    }

    /// What must be known beside an export: what was replaced, and chatter where there is some.
    pub fn notes(&self) -> Vec<String> {
        match self.softened {
            Some(_) => self.told(),
            None => self.chatters(),
        }
    }
}
