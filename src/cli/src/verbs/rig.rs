//! `dashpot rig`: measurement of a campaign on the virtual rig.

use crate::progress::Progress;
use crate::quantity::newtons;
use anyhow::Context as _;
use dashpot_output::FolderLock;
use dashpot_rig::{Campaign, EFFECTS, InjectedCase, Matrix, NOTHING, Options, PLANS, Plan, UNKNOWN_EFFECTS};
use dashpot_severity::request::{Numbers, RequestedEffects, strengths};
use std::path::PathBuf;

/// Measure a campaign on the virtual rig: a physical damper that shares no code with the model
///
/// The damper has two compressible oil chambers, bleed and blow-off valves, a gas chamber behind a floating piston, and bristle friction.
/// With `--hide`, the rig measures a neutral damper with injected effects instead. Its topology is that of the model. `sealed/truth.toml`
/// in the folder of the records lists the effects.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot rig -o campaign --seed 7 --noise 0.5 --matrix matrix.csv\n  dashpot rig -o riddle --seed 3 --noise 2 --hide cavitation,free_play=0.5 --plan diagnosis\n  dashpot rig -o neutral --seed 3 --hide nothing\n  dashpot rig -o worn --seed 3 --noise-seed 4 --hide free_play"
)]
pub struct Args {
    /// Folder for the records, one CSV per test
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Seed of damper and noise; 0 is the default damper. Two campaigns of one seed have the same noise, sample by sample
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// Seed of the noise alone, for a second measurement of the same damper; --seed if not given
    #[arg(long, value_name = "N")]
    noise_seed: Option<u64>,
    /// Noise of the force, percent of each test's root-mean-square force; 0 makes every sensor ideal
    #[arg(long, value_name = "PERCENT", default_value_t = 1.0, allow_negative_numbers = true)]
    noise: f64,
    /// Test matrix (see `dashpot matrix`); the thesis's matrix if not given
    #[arg(long, value_name = "F.csv")]
    matrix: Option<PathBuf>,
    /// Samples per second; chosen by frequency if not given
    #[arg(long, value_name = "HZ", allow_negative_numbers = true)]
    sample_rate: Option<f64>,
    #[arg(long, value_name = "NAME[=SEVERITY]", value_delimiter = ',', long_help = hide_help(),
        help = "Hide an effect in a neutral damper; several with commas or by repeating; 'nothing' for none")]
    hide: Vec<String>,
    /// Use the numbers of --hide as physical strengths; 1 is a typical strong case
    #[arg(long, requires = "hide")]
    strength: bool,
    #[arg(long, value_name = "NAME", conflicts_with = "matrix", help = plan_help())]
    plan: Option<String>,
    /// Correlation of the force noise from one sample to the next; 0 is white
    #[arg(long, value_name = "R", default_value_t = 0.0, allow_negative_numbers = true)]
    noise_colour: f64,
    /// Amplitude of mains hum on the force, N
    #[arg(long, value_name = "N", value_parser = newtons, default_value_t = 0.0, allow_negative_numbers = true)]
    hum: f64,
    /// Bits of the force channel's converter; no rounding if not given
    #[arg(long, value_name = "N")]
    bits: Option<u32>,
    /// Omit the side force from the records
    #[arg(long)]
    no_side_force: bool,
    /// Omit the temperature of the damper's body from the records
    #[arg(long)]
    no_temperature: bool,
    /// Temperature of the damper before the first test, °C; if not given, the temperature of the laboratory, 22 °C
    #[arg(long, value_name = "C", allow_negative_numbers = true, requires = "hide")]
    start_temperature: Option<f64>,
    /// Seed of the order of the plan's tests, which determines the thermal history; --seed if not given
    #[arg(long, value_name = "N", requires = "hide")]
    order: Option<u64>,
}

fn hide_help() -> String {
    format!(
        "Hide an effect in a neutral damper; several with commas or by repeating; '{NOTHING}' for none. Severity is what \
         refitting the model cannot absorb of it, in units of the noise: 0.5 is weak, 4 strong; the strength that makes it \
         is searched for. Without a number, a typical strong case. NAME:FORM asks for one physical form; otherwise the \
         seed chooses.\n\nEffects: {}.\n\nIn no catalogue: {}.",
        EFFECTS.join(", "),
        UNKNOWN_EFFECTS.join(", ")
    )
}

fn plan_help() -> String {
    format!("Tests: one of {}; with --hide, diagnosis if not given", PLANS.join(", "))
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let options = Options {
        seed: args.seed,
        noise_seed: args.noise_seed,
        noise_percent: args.noise,
        sample_rate_hz: args.sample_rate,
        noise_colour: args.noise_colour,
        hum_n: args.hum,
        bits: args.bits,
        side_force_channel: !args.no_side_force,
        temperature_channel: !args.no_temperature,
        start_temperature_c: args.start_temperature,
        order: args.order,
        ..Options::default()
    };
    let plan = args.plan.as_deref().map(Plan::named).transpose()?;
    let matrix = args.matrix.as_deref().map(Matrix::read).transpose()?;
    let order = args.order.unwrap_or(args.seed);
    let _held = FolderLock::take(&args.output)?;
    let progress = Progress::new("measuring");
    let tests = if args.hide.is_empty() {
        let matrix = matrix.or_else(|| plan.map(|plan| plan.matrix(order))).unwrap_or_default();
        let campaign = Campaign::run(&matrix, &options, |done, total| progress.count(done, total))?;
        campaign.write(&args.output)?;
        campaign.records.len()
    } else {
        let numbers = if args.strength { Numbers::Strengths } else { Numbers::Severities };
        // A test matrix of the user replaces the plan. Then [`strengths`] rejects severities, because the strength of a
        // severity is searched over the tests of a plan.
        let searched = matrix.is_none().then(|| plan.unwrap_or_default());
        let effects = strengths(effects(&args.hide)?, numbers, searched, &options, &|_, _| ())?;
        let matrix = matrix.unwrap_or_else(|| plan.unwrap_or_default().matrix(order));
        let case = InjectedCase { effects, plan: Plan::default(), options };
        let outcome = case.run_matrix(&matrix, |done, total| progress.count(done, total))?;
        outcome.write(&args.output)?;
        outcome.campaign.records.len()
    };
    drop(progress);
    dashpot_output::say(None, &format!("{tests} tests in {}", args.output.display()))
}

/// Splits the values of `--hide` into names and numbers.
fn effects(texts: &[String]) -> anyhow::Result<RequestedEffects> {
    texts
        .iter()
        .map(|text| {
            let Some((name, number)) = text.split_once('=') else {
                return Ok((text.clone(), None));
            };
            let number: f64 = number
                .parse()
                .with_context(|| format!("option hide: '{number}' is no severity of '{name}'; give a number"))?;
            Ok((name.to_owned(), Some(number)))
        })
        .collect()
}
