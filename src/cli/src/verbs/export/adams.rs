//! `dashpot export adams`: a run folder for Adams.

use crate::verbs::host_step::HostArgs;
use crate::verbs::model;
use anyhow::Context as _;
use dashpot_hosts::adams::folder::SineTest;
use dashpot_hosts::damper_length::in_millimetres;
use dashpot_hosts::exports::{self, RunFolderInput};
use dashpot_identification::model_file;
use dashpot_report::replace_file;
use dashpot_rig::{Matrix, TestPoint};
use std::path::{Path, PathBuf};

/// Write the files of an Adams run folder: model file, library, commands, a test rig
#[derive(clap::Args)]
#[command(after_help = "Example:\n  dashpot export adams damper.toml -o run --length 412.5")]
pub struct Args {
    /// Model file
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// Folder to write to; created if it does not exist
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Distance of the damper's markers at zero displacement, in mm, or with its unit: 412.5, 412.5mm, 0.4125m.
    /// If not given, 400 mm
    #[arg(long, value_name = "MM", value_parser = in_millimetres, allow_negative_numbers = true)]
    length: Option<f64>,
    /// Library to copy. If not given, the libraries embedded in this command (Linux and Windows), or the one in its folder
    #[arg(long, value_name = "FILE")]
    library: Option<PathBuf>,
    #[command(flatten)]
    host: HostArgs,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let ready = args.host.ready(&model::read(&args.model)?.params)?;
    let params = ready.params;
    let model = model_file::prepared(&params)?;
    let libraries = exports::adams_libraries(args.library.as_deref())?;
    let text = match ready.softened {
        Some(_) => model_file::plain(&params, &ready.messages()).into_bytes(),
        None => {
            dashpot_records::read_small(&args.model).with_context(|| format!("cannot read {}", args.model.display()))?
        }
    };
    dashpot_output::make_folder(&args.output)?;
    let put = |name: &str, bytes: &[u8]| {
        let path = args.output.join(name);
        replace_file(&path, bytes).with_context(|| format!("cannot write {}", path.display()))
    };
    let sine = |p: &TestPoint| SineTest { amplitude_m: p.amplitude_m, frequency_hz: p.frequency_hz };
    let tests: Vec<SineTest> = Matrix::default().points().iter().map(sine).collect();
    let folder = exports::run_folder(RunFolderInput {
        params: &params,
        model: &model,
        text: &text,
        length: args.length,
        tests: &tests,
        libraries,
        replaced: ready.replaced(),
        chatters: ready.remarks(),
    });
    folder.files.iter().try_for_each(|(name, content)| put(name, content))?;
    let notes = folder.notes(&args.output).into_iter().map(|note| format!("note: {note}"));
    let coupled = folder.if_coupled().map(|note| format!("note, {note}"));
    notes.chain(coupled).try_for_each(|note| dashpot_output::say(None, &note))?;
    dashpot_output::say(None, &format!("{}: start with README.txt", Path::new(&args.output).display()))
}
