//! `dashpot matrix`: test matrix of the rig as CSV.

use dashpot_rig::{Matrix, MatrixOptions};
use std::path::PathBuf;

/// Print the rig's test matrix as CSV; the thesis's matrix by default
///
/// The matrix has each amplitude at each peak velocity up to the frequency limit, then slow cycles for friction.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  dashpot matrix --amplitudes 50,25,10,2 --frequency-limit 20 -o matrix.csv")]
pub struct Args {
    /// Where to write; standard output if not given
    #[arg(short, long, value_name = "F.csv", default_value = "-")]
    output: PathBuf,
    /// Amplitudes, mm, separated by commas
    #[arg(long, value_name = "MM", allow_negative_numbers = true, value_delimiter = ',')]
    amplitudes: Option<Vec<f64>>,
    /// Peak velocities, mm/s, separated by commas
    #[arg(long, value_name = "MM/S", allow_negative_numbers = true, value_delimiter = ',')]
    peak_velocities: Option<Vec<f64>>,
    /// Highest frequency the rig can run, Hz
    #[arg(long, value_name = "HZ", allow_negative_numbers = true)]
    frequency_limit: Option<f64>,
    /// Leave out the slow cycles for friction and gas force
    #[arg(long)]
    no_slow: bool,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let mut options = MatrixOptions { slow_tests: !args.no_slow, ..MatrixOptions::default() };
    let metres = |mm: &Vec<f64>| mm.iter().map(|v| 1e-3 * v).collect();
    if let Some(mm) = &args.amplitudes {
        options.amplitudes_m = metres(mm);
    }
    if let Some(mm) = &args.peak_velocities {
        options.peak_velocities_m_s = metres(mm);
    }
    if let Some(limit) = args.frequency_limit {
        options.frequency_limit_hz = limit;
    }
    let matrix = Matrix::thesis(&options)?;
    dashpot_output::check([args.output.as_path()])?;
    dashpot_output::write(&args.output, matrix.to_csv())
}
