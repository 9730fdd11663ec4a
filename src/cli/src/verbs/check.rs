//! `dashpot check`: chatter of a damper in a host, the element that causes it, and the remedy.

use super::Verdict;
use super::host_step::HostArgs;
use super::model;
use anyhow::bail;
use dashpot_identification::model_file;
use dashpot_identification::setting_energy::energy_remark;
use dashpot_output::Kind;
use dashpot_simulation::chatter::{Figures, Ready};
use serde::Serialize;
use std::path::PathBuf;

/// Check whether a damper chatters in a host that keeps its force constant over a step
///
/// A real-time host computes the force once a step and keeps it constant. If the damper is too steep for the mass that it moves, the force
/// then alternates from step to step. Reports the gain c·h/m, and the result of a simulated host loop with its mass on a tire. Also reports
/// the element that causes chatter, and the longest step without chatter. --for-step writes a damper that does not chatter. Also reports
/// the fastest rate of the damper's states, for hosts that integrate them (model exchange). A note names what of a damper over a setting may
/// do work on the host when the setting changes.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot check damper.toml --host-step 0.001 --wheel-mass 40\n  dashpot check damper.toml --for-step 0.001 -o realtime.toml\n  dashpot check damper.toml --host-step 0.001 --strict || echo \"not for this host\"\n\nIt ends with 0 whatever the gain is; with \
                  --strict with 0 where the damper does not chatter, and with 1 where it does (gain 1 or more, or a force that turns at every step in the loop). 2 says that it could not be \
                  judged."
)]
pub struct Args {
    /// Model file
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    #[command(flatten)]
    host: HostArgs,
    /// Where to write the damper that --for-step prepares
    #[arg(short, long, value_name = "MODEL", requires = "for_step")]
    output: Option<PathBuf>,
    /// Exit with code 1 if the damper chatters, for scripts. With --for-step, only if the new damper still chatters
    #[arg(long)]
    strict: bool,
    /// Figures as JSON; - for standard output
    #[arg(long, value_name = "F")]
    json: Option<PathBuf>,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<Verdict> {
    let (json, out) = (args.json.as_deref(), args.output.as_deref());
    let on_stdout = [out, json].into_iter().flatten().find(|p| dashpot_output::is_stdout(p));
    if out.is_some_and(dashpot_output::is_stdout) && json.is_some_and(dashpot_output::is_stdout) {
        bail!("standard output takes one result: give -o or --json a file");
    }
    dashpot_output::check_kinds([(out, Kind::Model), (json, Kind::Figures)])?;
    let file = model::read_for_check(&args.model)?;
    let of_family = file.axis.is_some();
    if of_family && out.is_some() {
        bail!(
            "{} depends on a setting, and -o writes an ordinary damper made ready for a step; write that of one setting with dashpot setting first",
            args.model.display()
        );
    }
    let dampers = args.host.ready_at_settings(&file.definition())?;
    for (setting, ready) in &dampers {
        let at = setting.map_or_else(String::new, |value| format!("{}: ", model::setting_at(&file.axis, value)));
        for line in ready.messages().into_iter().chain(ready.stiffness()?) {
            dashpot_output::say(on_stdout, &format!("{at}{line}"))?;
        }
    }
    if let Some(remark) = energy_remark(&file.definition()) {
        dashpot_output::say(on_stdout, &format!("note: {remark}"))?;
    }
    if let (Some(path), [(_, ready)]) = (out, dampers.as_slice()) {
        if ready.softened.is_none() {
            dashpot_output::say(on_stdout, "Nothing was replaced: the file is the damper as it was.")?;
        }
        dashpot_output::write(path, model_file::plain(&ready.params, &ready.messages()))?;
    }
    if let Some(path) = json {
        let of =
            |(setting, ready): &(Option<f64>, Ready)| Ok(AtSetting { setting: *setting, figures: ready.figures()? });
        let figures = dampers.iter().map(of).collect::<anyhow::Result<Vec<_>>>()?;
        match figures.as_slice() {
            [only] if !of_family => dashpot_output::json(path, only)?,
            all => dashpot_output::json(path, &all)?,
        }
    }
    let chatters = dampers.iter().any(|(_, ready)| ready.chatter.rings());
    Ok(if args.strict && chatters { Verdict::Failed } else { Verdict::Passed })
}

/// JSON output for a damper, with the setting if it is an adjustable damper.
#[derive(Serialize)]
struct AtSetting {
    #[serde(skip_serializing_if = "Option::is_none")]
    setting: Option<f64>,
    #[serde(flatten)]
    figures: Figures,
}
