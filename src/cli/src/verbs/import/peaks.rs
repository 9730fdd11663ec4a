//! `dashpot import peaks`: a model to begin with, from a table of peak force over peak velocity.

use anyhow::Context as _;
use dashpot_identification::of_peaks::of_peaks;
use dashpot_output::Kind;
use dashpot_records::{PeakOptions, Positive, assignment};
use std::path::PathBuf;

/// Make a model file from a table of peak forces over peak velocities (PVP, CVP), CSV or Excel
///
/// Columns are velocity and force with their units, rebound positive and compression negative unless --positive says otherwise, or
/// velocity with a column for rebound and one for compression; each of them may have a velocity of its own (Comp Vel, Comp Force, Reb Vel, Reb Force; V-C, C, V-R, R). Each is known by its words or its unit; what may be two things is asked for by name (--column). Gas force and friction, which such a table holds without naming them, are taken out where they are given.
#[derive(clap::Args)]
#[command(
    after_help = "Example:\n  dashpot import peaks pvp.csv -o damper.toml --gas-force 150 --friction 40\n  dashpot import peaks dyno.csv -o damper.toml --unit velocity=in/s --unit force=lbf --column rebound_force=\"RO\"\n\nThe model is a start, to be drawn, run or exported; dashpot fit identifies one from records."
)]
pub struct Args {
    /// Table
    #[arg(value_name = "TABLE")]
    input: PathBuf,
    /// Where to write; - for standard output
    #[arg(short, long, value_name = "MODEL")]
    output: PathBuf,
    /// Which direction a table with signs counts positive; rebound if not given
    #[arg(long, value_name = "rebound|compression")]
    positive: Option<Positive>,
    /// Unit of velocity or force where the headings have none or a wrong one, such as force=lbf
    #[arg(long, value_name = "CHANNEL=UNIT")]
    unit: Vec<String>,
    /// Heading of a column, with or without its unit, or its number from 1; columns are velocity and force, and of one stroke rebound_velocity, rebound_force, compression_velocity and compression_force
    #[arg(long, value_name = "COLUMN=HEADING")]
    column: Vec<String>,
    /// Gas force in the table's forces, N
    #[arg(long, value_name = "N", default_value_t = 0.0)]
    gas_force: f64,
    /// Friction in the table's forces, N
    #[arg(long, value_name = "N", default_value_t = 0.0)]
    friction: f64,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    dashpot_output::check_kinds([(Some(args.output.as_path()), Kind::Model)])?;
    let begun = of_peaks(&args.input, &args.options()?, args.gas_force, args.friction)?;
    dashpot_output::write(&args.output, &begun.text)?;
    dashpot_output::say(
        Some(&args.output).filter(|p| dashpot_output::is_stdout(p)).map(PathBuf::as_path),
        &format!(
            "{} points in {}; {}; {}; hysteresis needs records (dashpot fit)",
            begun.points,
            args.output.display(),
            begun.columns,
            begun.direction
        ),
    )
}

impl Args {
    /// What is said of the table.
    fn options(&self) -> anyhow::Result<PeakOptions> {
        let mut options = PeakOptions { positive: self.positive, ..PeakOptions::default() };
        for text in &self.unit {
            let (channel, unit) = assignment(text).map_err(anyhow::Error::msg).context("--unit")?;
            options.unit_of(channel, unit).map_err(anyhow::Error::msg).context("--unit")?;
        }
        for text in &self.column {
            let (column, heading) = text.split_once('=').with_context(|| {
                format!("--column: '{text}' should read column=heading, for example rebound_force=\"R Avg\"")
            })?;
            let column = column.parse().map_err(anyhow::Error::msg).context("--column")?;
            options.columns.insert(column, heading.trim().trim_matches('"').to_owned());
        }
        Ok(options)
    }
}
