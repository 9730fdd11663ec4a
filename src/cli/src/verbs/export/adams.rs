//! `dashpot export adams`: a run folder for Adams.

use crate::verbs::host_step::HostArgs;
use anyhow::{Context as _, bail};
use dashpot_hosts::adams::folder;
use dashpot_hosts::runtimes;
use dashpot_identification::model_file;
use dashpot_report::replace_file;
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
    /// The library to hand out; if not given, those that this command holds (Linux and Windows), or the one beside it
    #[arg(long, value_name = "FILE")]
    library: Option<PathBuf>,
    #[command(flatten)]
    host: HostArgs,
}

const LIBRARY: &str = if cfg!(windows) { "dashpot_adams.dll" } else { "dashpot_adams.so" };

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    if !(args.length > 0.0 && args.length < 1e5) {
        bail!("--length {} cannot be; give the distance of the damper's markers in mm", args.length);
    }
    let ready = args.host.ready(&model_file::read(&args.model)?.params)?;
    let params = ready.params;
    let model = model_file::prepared(&params)?;
    let notes = ready.notes();
    let libraries = libraries(args.library.as_deref())?;
    let text = match ready.softened {
        Some(_) => model_file::plain(&params, &ready.told()).into_bytes(),
        None => std::fs::read(&args.model).with_context(|| format!("cannot read {}", args.model.display()))?,
    };
    std::fs::create_dir_all(&args.output).with_context(|| format!("making the folder {}", args.output.display()))?;
    let put = |name: &str, bytes: &[u8]| {
        let path = args.output.join(name);
        replace_file(&path, bytes).with_context(|| format!("cannot write {}", path.display()))
    };
    put("damper.toml", &text)?;
    let (files, no_native) = folder::files(&params, &model, "damper.toml", args.length, &Matrix::default());
    for file in files {
        let is_first = file.name == "README.txt";
        let missing =
            if libraries.is_empty() { format!("THE LIBRARY IS NOT HERE. {}\n\n", no_library()) } else { String::new() };
        let text = if is_first { missing + &folder::above(&notes, &file.text) } else { file.text };
        put(file.name, text.as_bytes())?;
    }
    if let Some(reason) = no_native {
        dashpot_output::say(None, &format!("note: no native.adm, because {reason}"))?;
    }
    for (name, content) in &libraries {
        put(name, content)?;
    }
    if libraries.is_empty() {
        dashpot_output::say(None, &format!("note: the library is not in the folder. {}", no_library()))?;
    }
    // Adams solves for the force with its slopes; who couples it to a fixed-step program reads what that does.
    for note in &notes {
        dashpot_output::say(None, &format!("note: {note}"))?;
    }
    dashpot_output::say(None, &format!("{}: start with README.txt", Path::new(&args.output).display()))
}

/// How to come by a library.
fn no_library() -> String {
    format!(
        "This command holds no Adams library and there is no {LIBRARY} beside it: {}; or `make -C adams-usersub` and --library FILE.",
        runtimes::HOW
    )
}

/// Names and contents of the libraries to write.
fn libraries(named: Option<&Path>) -> anyhow::Result<Vec<(String, Vec<u8>)>> {
    let read = |path: &Path| std::fs::read(path).with_context(|| format!("cannot read {}", path.display()));
    if let Some(path) = named {
        let content = read(path)?;
        // A library for Windows keeps its name on Linux too.
        let name = if content.starts_with(b"MZ") { "dashpot_adams.dll" } else { "dashpot_adams.so" };
        return Ok(vec![(name.into(), content)]);
    }
    let held: Vec<(String, Vec<u8>)> = [("linux64", "dashpot_adams.so"), ("win64", "dashpot_adams.dll")]
        .into_iter()
        .filter_map(|(platform, name)| Some((name.to_owned(), runtimes::compiled(platform, name)?.to_vec())))
        .collect();
    if !held.is_empty() {
        return Ok(held);
    }
    match std::env::current_exe().ok().map(|program| program.with_file_name(LIBRARY)).filter(|p| p.is_file()) {
        Some(path) => Ok(vec![(LIBRARY.into(), read(&path)?)]),
        None => Ok(Vec::new()),
    }
}
