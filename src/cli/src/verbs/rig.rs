//! `dashpot rig`: a campaign measured on the virtual rig.

use crate::progress::Progress;
use dashpot_rig::{Campaign, Matrix, Options};
use std::path::PathBuf;

/// Measure a campaign on the virtual rig: a physical damper that shares nothing with the model
///
/// Two compressible oil chambers, bleed and blow-off valves, a gas chamber behind a floating piston, bristle friction.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  dashpot rig -o campaign --seed 7 --noise 0.5 --matrix matrix.csv")]
pub struct Args {
    /// Folder for the records, one CSV per test
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Which damper, and which noise; 0 is the default damper
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// Noise of the force, percent of each test's root-mean-square force; 0 makes every sensor ideal
    #[arg(long, value_name = "PERCENT", default_value_t = 1.0, allow_negative_numbers = true)]
    noise: f64,
    /// Test matrix (see `dashpot matrix`); the thesis's if not given
    #[arg(long, value_name = "F.csv")]
    matrix: Option<PathBuf>,
    /// Samples per second; chosen by frequency if not given
    #[arg(long, value_name = "HZ", allow_negative_numbers = true)]
    sample_rate: Option<f64>,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let matrix = match &args.matrix {
        Some(file) => Matrix::read(file)?,
        None => Matrix::default(),
    };
    let options =
        Options { seed: args.seed, noise_percent: args.noise, sample_rate_hz: args.sample_rate, ..Options::default() };
    let progress = Progress::new("measuring");
    let campaign = Campaign::run(&matrix, &options, |done, total| progress.count(done, total))?;
    campaign.write(&args.output)?;
    drop(progress);
    super::output::say(None, &format!("{} tests in {}", campaign.records.len(), args.output.display()))
}
