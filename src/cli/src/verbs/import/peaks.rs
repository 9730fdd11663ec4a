//! `dashpot import peaks`: a model to begin with, from a table of peak force over peak velocity.

use anyhow::{Context as _, anyhow, bail};
use dashpot_core::Params;
use dashpot_core::{element, list, number};
use dashpot_identification::model_file;
use dashpot_identification::model_file::prepared;
use dashpot_output::Kind;
use dashpot_records::{Channel, PeakOptions, Peaks, Positive, Stroke, Told, Unit, assignment, read_peaks};
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
    let named = || args.input.display().to_string();
    for (name, value) in [("--gas-force", args.gas_force), ("--friction", args.friction)] {
        if !(value.is_finite() && value >= 0.0) {
            bail!("{name} is {value}; it must be 0 N or more");
        }
    }
    let peaks = read_peaks(&args.input, &args.options()?)?;
    let points = &peaks.points;
    let hydraulic = |force: f64, velocity: f64| force + args.gas_force - args.friction * velocity.signum();
    let mut velocities = vec![0.0];
    let mut forces = vec![0.0];
    for p in points.iter().rev().filter(|p| p.velocity_m_s < 0.0).chain(points.iter().filter(|p| p.velocity_m_s > 0.0))
    {
        let force = hydraulic(p.force_n, p.velocity_m_s);
        let (end, place) = if p.velocity_m_s < 0.0 { (forces[0], 0) } else { (forces[forces.len() - 1], forces.len()) };
        if (force - end) * p.velocity_m_s < 0.0 {
            bail!(
                "{}, line {}: at {} m/s the damper's own force is {force:.1} N and thus weaker than at a lower speed ({end:.1} N); \
                 check the row, or give --gas-force and --friction as they are in the table",
                named(),
                p.line,
                p.velocity_m_s
            );
        }
        velocities.insert(place, p.velocity_m_s);
        forces.insert(place, force);
    }
    let mut params = Params::new();
    params.disable_all();
    params.enable(element!("fv_curve"), true);
    for (list, values) in [(list!("fv_velocity"), &velocities), (list!("fv_force"), &forces)] {
        params.set_list(list, values).map_err(|f| anyhow!("{}: {list} {}", named(), f.reason.text()))?;
    }
    for (element, number, value) in [
        (element!("gas_preload"), number!("gas_force"), args.gas_force),
        (element!("coulomb_friction"), number!("coulomb_force"), args.friction),
    ] {
        if value > 0.0 {
            params.enable(element, true);
            params.set(number, value).map_err(|f| anyhow!("{}: {number} {}", named(), f.reason.text()))?;
        }
    }
    prepared(&params).with_context(named)?;
    let flat = model_file::flat(&params, |row| format!("{}; {}", row.parameter.unit, row.parameter.meaning));
    let file = args.input.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    dashpot_output::write(&args.output, format!("# Read from {}.\n\n{flat}", file.escape_debug()))?;
    dashpot_output::say(
        Some(&args.output).filter(|p| dashpot_output::is_stdout(p)).map(PathBuf::as_path),
        &format!(
            "{} points in {}; {}; {}; hysteresis needs records (dashpot fit)",
            velocities.len(),
            args.output.display(),
            columns(&peaks),
            direction(&peaks)
        ),
    )
}

impl Args {
    /// What is said of the table.
    fn options(&self) -> anyhow::Result<PeakOptions> {
        let mut options = PeakOptions { positive: self.positive, ..PeakOptions::default() };
        for text in &self.unit {
            let (channel, unit) = assignment(text).map_err(anyhow::Error::msg).context("--unit")?;
            if !matches!(channel, Channel::Velocity | Channel::Force) {
                bail!("--unit: a table of peaks has velocity and force, no {channel}");
            }
            let unit: Unit = unit.parse().map_err(anyhow::Error::msg).context("--unit")?;
            if unit.dimension() != channel.dimension() {
                bail!("--unit: {unit} is no unit of {channel}; it may be in {}", channel.units_understood());
            }
            options.units.insert(channel, unit);
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

/// Which columns were taken for what.
fn columns(peaks: &Peaks) -> String {
    let pairs = peaks.pairs.iter().map(|pair| {
        let stroke = pair.stroke.map_or("both strokes", Stroke::name);
        let column = |taken: &dashpot_records::Taken| match taken.heading.as_str() {
            "" => format!("column {} in {}", taken.index + 1, taken.unit),
            heading => format!("'{}' in {}", heading.escape_debug(), taken.unit),
        };
        format!("{stroke} from {} over {}", column(&pair.force), column(&pair.velocity))
    });
    pairs.collect::<Vec<_>>().join(", ")
}

/// Which side was taken as rebound, and whether its forces speak for that.
fn direction(peaks: &Peaks) -> String {
    /// How much stronger the compression must be to be remarked: dampers that resist both alike scatter by less.
    const CLEARLY: f64 = 1.2;
    let taken = match peaks.told {
        Told::Headings => "rebound and compression taken as the headings name them",
        Told::Given(Positive::Rebound) => "positive velocities and forces taken as rebound, as given",
        Told::Given(Positive::Compression) => "negative velocities and forces taken as rebound, as given",
        Told::Assumed => {
            "positive velocities and forces taken as rebound (--positive compression takes the negative ones)"
        }
    };
    let Some((velocity, ratio)) = peaks.asymmetry() else { return taken.to_owned() };
    let found =
        format!("{taken}; at {velocity:.3} m/s the force in rebound is {ratio:.2} times the force in compression");
    if ratio * CLEARLY > 1.0 {
        return found;
    }
    let check = match peaks.told {
        Told::Headings => "check the headings",
        Told::Given(Positive::Compression) => "check whether --positive rebound is right",
        _ => "if the table counts compression positive, give --positive compression",
    };
    format!("{found}. Most dampers resist rebound more: {check}")
}
