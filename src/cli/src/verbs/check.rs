//! `dashpot check`: chatter of a damper in a host, the element that causes it, and the remedy.

use super::Verdict;
use super::host_step::HostArgs;
use super::model::{self, setting_at};
use anyhow::bail;
use dashpot_core::family::Axis;
use dashpot_identification::model_file;
use dashpot_identification::setting_energy::energy_remark;
use dashpot_output::Kind;
use dashpot_records::setting_in_words;
use dashpot_simulation::chatter::{Figures, Ready};
use serde::Serialize;
use std::path::PathBuf;

/// Check whether a damper chatters in a host that keeps its force constant over a step
///
/// A real-time host computes the force once a step and keeps it constant. If the damper is too steep for the mass that it moves, the force
/// then alternates from step to step. Reports the gain c·h/m, and the result of a simulated host loop with its mass on a tire. Also reports
/// the element that causes chatter, and the longest step without chatter. --for-step writes a damper that does not chatter. Also reports
/// the fastest rate of the damper's states, for hosts that integrate them (model exchange). A damper over a setting is checked at every
/// setting, and the largest gain is described. A note names what of it may do work on the host when the setting changes.
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
    for line in lines(&dampers, &file.axis)? {
        dashpot_output::say(on_stdout, &line)?;
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

/// Returns the printed lines. For a damper over a setting, they are the messages at the setting with the largest gain, and the remarks at
/// all other settings. The fastest rate over all settings follows.
fn lines(dampers: &[(Option<f64>, Ready)], axis: &Axis) -> anyhow::Result<Vec<String>> {
    let at = |setting: Option<f64>| setting.map_or_else(String::new, |value| format!("{}: ", setting_at(axis, value)));
    let gain = |ready: &Ready| ready.chatter.gain;
    let worst = dampers.iter().max_by(|(_, a), (_, b)| gain(a).total_cmp(&gain(b)));
    let mut lines = Vec::new();
    if let ([_, _, ..], Some((Some(setting), ready))) = (dampers, worst) {
        let least = dampers.iter().map(|(_, ready)| gain(ready)).fold(f64::INFINITY, f64::min);
        lines.push(format!(
            "gain {least:.2} to {:.2} over {} settings, the largest at {}; it chatters at {} of them",
            gain(ready),
            dampers.len(),
            setting_in_words(*setting, axis.unit()),
            dampers.iter().filter(|(_, ready)| ready.chatter.rings()).count()
        ));
    }
    let is_worst = |setting: &Option<f64>| worst.is_some_and(|(of, _)| of == setting);
    for (setting, ready) in dampers {
        let of = if is_worst(setting) { ready.messages() } else { ready.remarks() };
        lines.extend(of.iter().map(|line| format!("{}{line}", at(*setting))));
    }
    let rates = dampers.iter().map(|(setting, ready)| Ok((ready.fastest_rate()?, setting, ready)));
    let rates = rates.collect::<anyhow::Result<Vec<_>>>()?;
    if let Some((_, setting, fastest)) = rates.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)) {
        lines.extend(fastest.stiffness()?.map(|line| format!("{}{line}", at(*setting))));
    }
    Ok(lines)
}

/// JSON output for a damper, with the setting if it is an adjustable damper.
#[derive(Serialize)]
struct AtSetting {
    #[serde(skip_serializing_if = "Option::is_none")]
    setting: Option<f64>,
    #[serde(flatten)]
    figures: Figures,
}
