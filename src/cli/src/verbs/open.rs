//! `dashpot open`: the window.

use anyhow::{Context as _, bail};
use std::path::PathBuf;
use std::process::Command;

/// Open the window: look at records, tune a model by hand, fit, diagnose and export with the mouse
///
/// The window is a program of its own beside this command, dashpot-window.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  dashpot open campaign/ damper.toml")]
pub struct Args {
    /// Folder of records, or record files
    #[arg(value_name = "CAMPAIGN")]
    campaign: Option<PathBuf>,
    /// Model file
    #[arg(value_name = "MODEL")]
    model: Option<PathBuf>,
}

const WINDOW: &str = if cfg!(windows) { "dashpot-window.exe" } else { "dashpot-window" };

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let paths: Vec<&PathBuf> = args.campaign.iter().chain(&args.model).collect();
    if let Some(missing) = paths.iter().find(|p| !p.exists()) {
        bail!("{}: there is no such file or folder; check the path", missing.display());
    }
    let window = std::env::current_exe()?.with_file_name(WINDOW);
    if !window.is_file() {
        bail!("there is no {}; build it with `cargo build --release -p dashpot-bench`", window.display());
    }
    let status =
        Command::new(&window).args(paths).status().with_context(|| format!("cannot start {}", window.display()))?;
    if !status.success() {
        bail!("the window ended with {status}");
    }
    Ok(())
}
