//! `dashpot export fmu`: export of a model as a functional mock-up unit (FMU), the format that most simulators import.

use super::super::host_step::HostArgs;
use crate::quantity::metres;
use crate::verbs::model;
use anyhow::{Context as _, bail};
use dashpot_core::family::Definition;
use dashpot_hosts::damper_length::in_metres;
use dashpot_hosts::fmu::{self, Binary, Inputs, Scales, Version};
use dashpot_hosts::plain_curve::PlainCurve;
use dashpot_hosts::{exports, runtimes};
use dashpot_identification::model_file;
use dashpot_output::Kind;
use dashpot_report::replace_file;
use dashpot_simulation::stiffness;
use std::path::{Path, PathBuf};

/// Write a functional mock-up unit: co-simulation and model exchange in one file
///
/// One model file gives an FMU of one damper (displacement and velocity in extension, force in tension). Two files (front and rear) or four
/// (L1, R1, L2, R2) give the FMU of a vehicle. Its inputs, such as Damper_Jounce_L1 and Damper_Jounce_Rate_L1, are positive in compression.
/// Its outputs, such as Damper_Force_L1, are positive if the damper pushes. Signs, units, motion ratio and the distance between the zeros
/// of rig and vehicle are parameters of the FMU. No compiler is needed: the FMU contains a runtime that reads the model from its resources,
/// and the sources of runtime and kernel.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot export fmu damper.toml -o damper.fmu\n  dashpot export fmu front.toml rear.toml -o car.fmu\n  \
                  dashpot export fmu damper.toml -o front.fmu --carmaker 0.4125"
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
    /// Use a single model file for four corners
    #[arg(long)]
    four: bool,
    /// Damper extension in m per unit of the host's motion, such as 0.001 for mm. The FMU declares the unit of this factor, or no unit if
    /// the factor includes a motion ratio [default: 1 for one damper, -1 for a vehicle]
    #[arg(long, value_name = "F", allow_negative_numbers = true)]
    motion_scale: Option<f64>,
    /// The host's force per N of tension, such as 0.001 for kN. The FMU declares the unit of this factor, or no unit if the factor includes
    /// a motion ratio [default: 1 for one damper, -1 for a vehicle]
    #[arg(long, value_name = "F", allow_negative_numbers = true)]
    force_scale: Option<f64>,
    /// Damper extension from the rig's zero, in m, at zero displacement of the host
    #[arg(long, value_name = "M", value_parser = metres, default_value_t = 0.0, allow_negative_numbers = true)]
    position_offset: f64,
    /// Instant at which your importer sets the inputs of a co-simulation step: its beginning or its end. FMPy and most masters set the
    /// inputs at the beginning of a step. The FMU then extrapolates, which avoids a delay of one step [default: zero-order hold, which
    /// delays the force by one step for such masters]
    #[arg(long, value_name = "INSTANT", value_parser = ["begin", "end"])]
    inputs: Option<String>,
    /// For IPG CarMaker: signs and zero of the model class Susp_Damper. Also writes the .pluginfo file with which CarMaker loads the FMU.
    /// LENGTH is the damper length at zero displacement of the records, in m or with its unit: 0.4125, 0.4125m, 412.5mm
    #[arg(long, value_name = "LENGTH", value_parser = in_metres, allow_negative_numbers = true, conflicts_with_all = ["four", "motion_scale", "force_scale", "position_offset"])]
    carmaker: Option<f64>,
    /// With --carmaker: the model's own curve, without friction, for the damper of CarMaker's equilibrium search. Takes precedence over the
    /// plain FV curve that the fit stored in the model file
    #[arg(long, requires = "carmaker")]
    model_curve: bool,
    /// Omit the sources of kernel and FMU; the model itself stays readable in the FMU's resources
    #[arg(long)]
    no_sources: bool,
    /// Hide the identified numbers: the parameters are not variables of the FMU, so hosts neither show nor change them. The model in its
    /// resources is obfuscated, not encrypted. Dashpot's sources can decode it, a saved state contains the numbers, and a model can be
    /// fitted to the computed forces
    #[arg(long)]
    hide_parameters: bool,
    /// Compile the binary with the model inside, for this computer only (needs a C compiler: cc, or CC)
    #[arg(long)]
    from_source: bool,
    /// With --from-source: the static library of dashpot [default: libdashpot.a in the folder of this command, or in ../lib]
    #[arg(long, value_name = "FILE", requires = "from_source")]
    library: Option<PathBuf>,
    /// Binary for one more platform, such as darwin64, compiled from this FMU's own sources
    #[arg(long, value_name = "PLATFORM=FILE")]
    binary: Vec<String>,
    #[command(flatten)]
    host: HostArgs,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    if dashpot_output::is_stdout(&args.output) {
        bail!("-o needs a file name: an FMU is a zip archive");
    }
    let plug_info = args.carmaker.map(|_| args.output.with_extension("pluginfo"));
    dashpot_output::check_kinds([(Some(args.output.as_path()), Kind::Fmu), (plug_info.as_deref(), Kind::PlugInfo)])?;
    if args.carmaker.is_some() && args.models.len() > 1 {
        bail!("--carmaker takes one model: CarMaker has one FMU for each kind of damper");
    }
    let Dampers { models, curve, mut notes, remarks } = Dampers::read(args)?;
    let corners = fmu::corners(&models, args.four)?;
    let scales = match args.carmaker {
        Some(length) => Scales::carmaker(length)?,
        None => Scales::checked(corners.len(), args.motion_scale, args.force_scale, args.position_offset)?,
    };
    let inputs = match args.inputs.as_deref() {
        Some("begin") => Inputs::Begin,
        Some(_) => Inputs::End,
        None => Inputs::Unspecified,
    };
    if inputs == Inputs::Unspecified {
        notes.push(fmu::INPUTS_HAVE_ZERO_ORDER_HOLD.to_owned());
    }
    let version = if args.fmi == "2" { Version::Two } else { Version::Three };
    let more: Vec<Binary> = args.binary.iter().map(|text| binary(text)).collect::<anyhow::Result<_>>()?;
    let library = library_to_compile(args)?;
    let name = exports::fmu_name(&args.models[0], corners.len() > 1);
    let made = fmu::fmu(
        &corners,
        &fmu::Options {
            version,
            scales,
            inputs,
            explicit_step: stiffness::longest_explicit_step(&corners),
            name: &name,
            from_source: library.as_deref(),
            sources: !args.no_sources,
            conceal_parameters: args.hide_parameters,
            more: &more,
            remarks: &remarks,
        },
    )?;
    // The text of the pluginfo file is formatted before any file is written, because the formatting can fail.
    let plug_info = plug_info.map(|path| -> anyhow::Result<_> {
        let name = args.output.file_stem().unwrap_or_default().to_string_lossy();
        let named = args.models[0].file_name().unwrap_or_default().to_string_lossy();
        let written =
            format!("{}{} from {named}. It belongs to {name}.fmu.", dashpot_output::WRITTEN, env!("CARGO_PKG_VERSION"));
        let has_setting = models.iter().any(|model| model.axis.is_some());
        Ok((path, fmu::plug_info((&name, &made.guid), has_setting, curve.as_ref(), &written)?))
    });
    let plug_info = plug_info.transpose()?;
    replace_file(&args.output, &made.bytes).with_context(|| format!("cannot write {}", args.output.display()))?;
    if let Some((path, text)) = &plug_info {
        dashpot_output::write(path, text)?;
    }
    let corners = if corners.len() == 1 { "one corner" } else { "four corners" };
    let platforms = made.platforms.join(", ");
    dashpot_output::say(None, &format!("{}: FMI {}.0, {corners}, for {platforms}", args.output.display(), args.fmi))?;
    if let Some((path, _)) = &plug_info {
        print_carmaker(path, curve.as_ref())?;
    }
    notes.iter().try_for_each(|note| dashpot_output::say(None, note))
}

/// Dampers of the FMU, as the model files define them.
#[derive(Default)]
struct Dampers {
    models: Vec<Definition>,
    /// Curve for CarMaker's computation of equilibrium. It stays `None` for a model without an FV curve.
    curve: Option<PlainCurve>,
    /// Notes for the user.
    notes: Vec<String>,
    /// Remarks that the FMU contains.
    remarks: Vec<String>,
}

impl Dampers {
    fn read(args: &Args) -> anyhow::Result<Dampers> {
        let mut dampers = Dampers::default();
        args.models.iter().try_for_each(|path| dampers.add(args, path))?;
        Ok(dampers)
    }

    /// Adds the damper of a model file.
    fn add(&mut self, args: &Args, path: &Path) -> anyhow::Result<()> {
        let file = model::read_family(path)?;
        if args.carmaker.is_some() && file.axis.is_some() {
            self.notes.push(format!(
                "note: {}: the .pluginfo file links the setting to CarMaker's CtrlIn, one to one, in the unit of the model file; at rest CtrlIn is 0",
                path.display()
            ));
        }
        if args.carmaker.is_some() && !args.hide_parameters {
            self.curve =
                PlainCurve::from_model_file(&file, args.model_curve).with_context(|| path.display().to_string())?;
        }
        model_file::prepared(&file.params).with_context(|| path.display().to_string())?;
        let dampers = args.host.ready_at_settings(&file.definition()).with_context(|| path.display().to_string())?;
        for (setting, ready) in &dampers {
            let at = setting.map_or_else(String::new, |value| format!("{}: ", model::setting_at(&file.axis, value)));
            let told: Vec<String> = ready.notes().into_iter().map(|note| format!("{at}{note}")).collect();
            self.notes.extend(told.iter().map(|note| format!("note: {}: {note}", path.display())));
            self.remarks.extend(told);
            self.remarks.extend(stiffness::remarks(&ready.params).into_iter().map(|remark| format!("{at}{remark}")));
        }
        self.models.push(match dampers.as_slice() {
            [(None, ready)] => Definition { params: ready.params, axis: file.axis },
            _ => file.definition(),
        });
        Ok(())
    }
}

/// Returns the static library from which the binary of this platform is compiled, or `None` if an embedded runtime is used. A command
/// without an embedded runtime compiles one on this computer, if possible.
fn library_to_compile(args: &Args) -> anyhow::Result<Option<PathBuf>> {
    let holds_one = runtimes::compiled("linux64", "dashpot_damper.so").is_some();
    let compiles = args.from_source || !holds_one && library(None).is_ok();
    if compiles && !args.from_source {
        dashpot_output::warn(&format!(
            "note: this command holds no compiled FMU runtime, so it is compiled here for this platform alone; {}",
            runtimes::HOW
        ));
    }
    compiles.then(|| library(args.library.as_deref())).transpose()
}

/// Prints how CarMaker uses the FMU, with the curve of its computation of equilibrium.
fn print_carmaker(plug_info: &Path, curve: Option<&PlainCurve>) -> anyhow::Result<()> {
    dashpot_output::say(
        None,
        &format!("{}: how CarMaker takes it; both go to its Plugins folder", plug_info.display()),
    )?;
    if let Some(curve) = curve {
        dashpot_output::say(None, &format!("  for its equilibrium: {}", curve.note()))?;
        if let Some(left_out) = fmu::not_in_the_equilibrium(curve) {
            dashpot_output::say(None, &format!("  {left_out}"))?;
        }
    }
    Ok(())
}

/// Reads a binary for another platform, from PLATFORM=FILE.
fn binary(text: &str) -> anyhow::Result<Binary> {
    let Some((platform, file)) = text.split_once('=') else {
        bail!("--binary is given as PLATFORM=FILE, such as win64=dashpot_damper.dll, not {text}");
    };
    Binary::read(platform, Path::new(file)).context("--binary")
}

/// Returns the path of dashpot's static library: the given library, or the library that cargo or a package installed.
/// Returns an error if there is no such file.
fn library(named: Option<&Path>) -> anyhow::Result<PathBuf> {
    let path = named.map_or_else(exports::static_library, |named| Ok(named.to_path_buf()))?;
    if !path.is_file() {
        let nor = if named.is_none() { ", nor one in ../lib" } else { "" };
        bail!(
            "there is no {}{nor}; build it with `cargo build --release -p dashpot-dll`, or name it with --library",
            path.display()
        );
    }
    Ok(path)
}
