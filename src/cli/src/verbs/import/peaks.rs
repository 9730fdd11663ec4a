//! `dashpot import peaks`: initial model from a table of peak force over peak velocity.

use crate::quantity::newtons;
use anyhow::{Context as _, bail};
use dashpot_core::family::LARGEST_SETTING;
use dashpot_identification::of_peaks::{Begun, family_of_peaks, of_peaks};
use dashpot_output::Kind;
use dashpot_records::{PeakOptions, Positive, assignment, peak_clicks};
use std::path::{Path, PathBuf};

/// Make a model file from a table of peak forces over peak velocities (PVP, CVP), CSV or Excel
///
/// Columns are velocity and force with their units, rebound positive and compression negative unless --positive says otherwise. A table may
/// instead have a velocity column, a rebound column and a compression column. Each stroke may have its own velocity (Comp Vel, Comp Force,
/// Reb Vel, Reb Force; V-C, C, V-R, R). Columns are recognized by heading or unit. An ambiguous column must be named with --column. The
/// forces of such a table include gas force and friction. If --gas-force and --friction are given, they are subtracted.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot import peaks pvp.csv -o damper.toml --gas-force 150 --friction 40\n  dashpot import peaks clicks.csv -o adjuster.toml --clicks family\n  dashpot import peaks dyno.csv -o damper.toml --unit velocity=in/s --unit force=lbf --column rebound_force=\"RO\"\n\nThe model is a start, to be drawn, run or exported; dashpot fit identifies one from records."
)]
pub struct Args {
    /// Table
    #[arg(value_name = "TABLE")]
    input: PathBuf,
    /// Where to write; - for standard output
    #[arg(short, long, value_name = "MODEL")]
    output: PathBuf,
    /// Direction that is positive in a table with signs; rebound if not given
    #[arg(long, value_name = "rebound|compression")]
    positive: Option<Positive>,
    /// Unit of velocity or force if the headings state none or a wrong one, such as force=lbf
    #[arg(long, value_name = "CHANNEL=UNIT")]
    unit: Vec<String>,
    /// Heading of a column, with or without its unit, or its number from 1. The columns are velocity and force. For a single stroke they
    /// are rebound_velocity, rebound_force, compression_velocity and compression_force
    #[arg(long, value_name = "COLUMN=HEADING")]
    column: Vec<String>,
    /// Click of an adjustable damper to read. A number reads one click. The word all makes a model of each click, with the click at the end
    /// of its file name. The word family makes one model over the clicks
    #[arg(long, value_name = "N|all|family")]
    clicks: Option<String>,
    /// Gas force that the table's forces include, N
    #[arg(long, value_name = "N", value_parser = newtons, default_value_t = 0.0, allow_negative_numbers = true)]
    gas_force: f64,
    /// Friction that the table's forces include, N
    #[arg(long, value_name = "N", value_parser = newtons, default_value_t = 0.0, allow_negative_numbers = true)]
    friction: f64,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let models: Vec<(Option<f64>, PathBuf)> = match args.clicks.as_deref() {
        None | Some("family") => vec![(None, args.output.clone())],
        Some("all") => {
            if dashpot_output::is_stdout(&args.output) {
                bail!("--clicks all writes several models: give -o a file name");
            }
            let clicks = peak_clicks(&args.input)?;
            if clicks.is_empty() {
                bail!("{}: has no column that names clicks; leave --clicks out", args.input.display());
            }
            clicks.into_iter().map(|click| (Some(click), of_click(&args.output, click))).collect()
        }
        Some(text) => {
            let click = text.parse().ok().filter(|c: &f64| c.abs() <= LARGEST_SETTING);
            let click = click
                .with_context(|| format!("--clicks takes a number from -1e9 to 1e9, all or family, not {text:?}"))?;
            vec![(Some(click), args.output.clone())]
        }
    };
    dashpot_output::check_kinds(models.iter().map(|(_, path)| (Some(path.as_path()), Kind::Model)))?;
    for (clicks, path) in &models {
        one(args, *clicks, path)?;
    }
    Ok(())
}

/// Returns the model file of a click: `damper.toml` becomes `damper_10.toml`.
fn of_click(output: &Path, click: f64) -> PathBuf {
    let stem = output.file_stem().unwrap_or_default().to_string_lossy();
    let ending = output.extension().map_or_else(String::new, |ending| format!(".{}", ending.to_string_lossy()));
    output.with_file_name(format!("{stem}_{click}{ending}"))
}

/// Makes and writes one model file.
fn one(args: &Args, clicks: Option<f64>, output: &Path) -> anyhow::Result<()> {
    let options = PeakOptions { clicks, ..args.options()? };
    let make = if args.clicks.as_deref() == Some("family") { family_of_peaks } else { of_peaks };
    let begun: Begun = make(&args.input, &options, args.gas_force, args.friction)?;
    dashpot_output::write(output, &begun.text)?;
    begun.notes().iter().try_for_each(|note| dashpot_output::say(Some(output), &format!("note: {note}")))?;
    dashpot_output::say(
        Some(output).filter(|p| dashpot_output::is_stdout(p)),
        &format!(
            "{} points in {}; {}; {}; hysteresis needs records (dashpot fit)",
            begun.points,
            output.display(),
            begun.columns,
            begun.direction
        ),
    )
}

impl Args {
    /// Converts the arguments to options for reading the table.
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
