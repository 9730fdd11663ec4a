//! `dashpot export adams`: a run folder for Adams.

use crate::adams::folder;
use crate::report::replace_file;
use crate::verbs::output;
use crate::verbs::validate::prepared;
use anyhow::{Context as _, bail};
use dashpot_lab::model_file;
use dashpot_rig::Matrix;
use std::path::{Path, PathBuf};

/// Write everything that a run folder of Adams needs: model file, library, commands, a test rig
#[derive(clap::Args)]
#[command(after_help = "Example:\n  dashpot export adams damper.toml -o run --length 412.5")]
pub struct Args {
    /// Model file
    #[arg(value_name = "MODEL")]
    model: PathBuf,
    /// Folder to write to; made if it is not there
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Distance of the damper's markers at zero displacement, mm
    #[arg(long, value_name = "MM", default_value_t = 400.0)]
    length: f64,
    /// The built library; if not given, the one beside this program
    #[arg(long, value_name = "FILE")]
    library: Option<PathBuf>,
}

const LIBRARY: &str = if cfg!(windows) { "dashpot_adams.dll" } else { "dashpot_adams.so" };

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    if !(args.length > 0.0 && args.length < 1e5) {
        bail!("--length {} cannot be; give the distance of the damper's markers in mm", args.length);
    }
    let params = model_file::read(&args.model)?.params;
    let model = prepared(&params)?;
    let beside = std::env::current_exe().ok().map(|program| program.with_file_name(LIBRARY)).filter(|p| p.is_file());
    let library = match args.library.clone().or(beside) {
        Some(path) => Some(std::fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?),
        None => None,
    };
    let text = std::fs::read(&args.model).with_context(|| format!("cannot read {}", args.model.display()))?;
    std::fs::create_dir_all(&args.output).with_context(|| format!("making the folder {}", args.output.display()))?;
    let put = |name: &str, bytes: &[u8]| {
        let path = args.output.join(name);
        replace_file(&path, bytes).with_context(|| format!("cannot write {}", path.display()))
    };
    put("damper.toml", &text)?;
    let (files, no_native) = folder::files(&params, &model, "damper.toml", args.length, &Matrix::default());
    for file in files {
        put(file.name, file.text.as_bytes())?;
    }
    if let Some(reason) = no_native {
        output::say(None, &format!("note: no native.adm, because {reason}"))?;
    }
    match library {
        Some(bytes) => put(LIBRARY, &bytes)?,
        None => output::say(
            None,
            &format!(
                "note: no {LIBRARY} beside this program; build it with `make -C adams-usersub` and give --library"
            ),
        )?,
    }
    output::say(None, &format!("{}: start with README.txt", Path::new(&args.output).display()))
}
