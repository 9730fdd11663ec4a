//! `dashpot export fmu`: a model in the form that most simulators import.

use super::super::{output, validate};
use crate::fmu::{self, Binary, Scales, Version};
use crate::report::replace_file;
use anyhow::{Context as _, bail};
use dashpot_core::Params;
use dashpot_lab::model_file;
use std::path::{Path, PathBuf};

/// A functional mock-up unit: co-simulation and model exchange in one file
///
/// One model file makes an FMU of one damper (displacement and velocity in extension, force in tension). Two (front and
/// rear) or four (L1, R1, L2, R2) make a vehicle's: Damper_Jounce_L1 and Damper_Jounce_Rate_L1 in compression,
/// Damper_Force_L1 positive where the damper pushes. Signs, units and motion ratio are parameters of the FMU. It is
/// compiled on this computer, for this computer; its sources are inside.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot export fmu damper.toml -o damper.fmu\n  dashpot export fmu front.toml rear.toml -o car.fmu"
)]
pub struct Args {
    /// Model files: one, two (front, rear) or four (L1, R1, L2, R2)
    #[arg(value_name = "MODEL", required = true, num_args = 1..=4)]
    models: Vec<PathBuf>,
    /// Where to write
    #[arg(short, long, value_name = "OUT.fmu")]
    output: PathBuf,
    /// FMI version
    #[arg(long, value_name = "N", default_value = "2", value_parser = ["2", "3"])]
    fmi: String,
    /// Four corners from a single model file
    #[arg(long)]
    four: bool,
    /// Damper extension in m per unit of the host's motion [default: 1 for one damper, -1 for a vehicle]
    #[arg(long, value_name = "F", allow_negative_numbers = true)]
    motion_scale: Option<f64>,
    /// The host's force per N of tension [default: 1 for one damper, -1 for a vehicle]
    #[arg(long, value_name = "F", allow_negative_numbers = true)]
    force_scale: Option<f64>,
    /// The static library of dashpot [default: libdashpot.a beside this command]
    #[arg(long, value_name = "FILE")]
    library: Option<PathBuf>,
    /// The binary for one more platform, such as win64, compiled from this FMU's own sources
    #[arg(long, value_name = "PLATFORM=FILE")]
    binary: Vec<String>,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    if output::is_stdout(&args.output) {
        bail!("-o needs a file name: an FMU is a zip archive");
    }
    output::check([args.output.as_path()])?;
    let models: Vec<Params> = args
        .models
        .iter()
        .map(|path| {
            let file = model_file::read(path)?;
            validate::prepared(&file.params).with_context(|| path.display().to_string())?;
            Ok(file.params)
        })
        .collect::<anyhow::Result<_>>()?;
    let corners: Vec<Params> = match (&models[..], args.four) {
        ([one], false) => vec![*one],
        ([one], true) => vec![*one; 4],
        ([front, rear], _) => vec![*front, *front, *rear, *rear],
        ([_, _, _, _], _) => models.clone(),
        _ => bail!("give one model file, two (front, rear) or four (L1, R1, L2, R2)"),
    };
    let usual = if corners.len() == 1 { 1.0 } else { -1.0 };
    let scales = Scales { motion: args.motion_scale.unwrap_or(usual), force: args.force_scale.unwrap_or(usual) };
    for (name, scale) in [("--motion-scale", scales.motion), ("--force-scale", scales.force)] {
        if !scale.is_finite() || scale == 0.0 {
            bail!("{name} must be finite and not 0");
        }
    }
    let version = if args.fmi == "2" { Version::Two } else { Version::Three };
    let more: Vec<Binary> = args.binary.iter().map(|text| binary(text)).collect::<anyhow::Result<_>>()?;
    let bytes = fmu::fmu(&corners, version, scales, &library(args.library.as_deref())?, &more)?;
    replace_file(&args.output, &bytes).with_context(|| format!("cannot write {}", args.output.display()))?;
    let corners = if corners.len() == 1 { "one corner" } else { "four corners" };
    output::say(None, &format!("{}: FMI {}.0, {corners}", args.output.display(), args.fmi))
}

/// A binary for another platform, from PLATFORM=FILE.
fn binary(text: &str) -> anyhow::Result<Binary> {
    let Some((platform, file)) = text.split_once('=') else {
        bail!("--binary is given as PLATFORM=FILE, such as win64=dashpot_damper.dll, not {text}");
    };
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if platform.is_empty() || !platform.chars().all(plain) {
        bail!(
            "--binary: {platform:?} is no platform; FMI 2.0 has win64, linux64 and darwin64, FMI 3.0 x86_64-windows and so on"
        );
    }
    let content = std::fs::read(file).with_context(|| format!("--binary: cannot read {file}"))?;
    Ok(Binary { platform: platform.to_owned(), content })
}

/// The static library: as named, or where cargo puts it.
fn library(named: Option<&Path>) -> anyhow::Result<PathBuf> {
    let beside = std::env::current_exe()?.with_file_name("libdashpot.a");
    let path = named.map_or(beside, Path::to_path_buf);
    if !path.is_file() {
        bail!(
            "there is no {}; build it with `cargo build --release -p dashpot-dll`, or name it with --library",
            path.display()
        );
    }
    Ok(path)
}
