//! `dashpot open`: graphical user interface.

use anyhow::{Context as _, bail};
use std::path::PathBuf;
use std::process::Command;

/// Open the window: look at records, tune a model by hand, fit, diagnose and export with the mouse
///
/// The window is a separate program, dashpot-window, in the folder of this command.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot open campaign/ damper.toml\n  dashpot open campaign/ damper.toml dimensions.toml\n  dashpot open semi_active/ family.toml --subfolders"
)]
pub struct Args {
    /// Folder of records, or record files
    #[arg(value_name = "CAMPAIGN")]
    campaign: Option<PathBuf>,
    /// Model file
    #[arg(value_name = "MODEL")]
    model: Option<PathBuf>,
    /// Dimensions of the damper
    #[arg(value_name = "D.toml")]
    dimensions: Option<PathBuf>,
    /// Read the records in subfolders as tests of the same campaign
    #[arg(long)]
    subfolders: bool,
}

const WINDOW: &str = if cfg!(windows) { "dashpot-window.exe" } else { "dashpot-window" };

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let paths: Vec<&PathBuf> = args.campaign.iter().chain(&args.model).chain(&args.dimensions).collect();
    if let Some(missing) = paths.iter().find(|p| !p.exists()) {
        bail!("{}: there is no such file or folder; check the path", missing.display());
    }
    let window = window()?;
    let status = Command::new(&window)
        .args(args.subfolders.then_some("--subfolders"))
        .args(paths)
        .status()
        .with_context(|| format!("cannot start {}", window.display()))?;
    if !status.success() {
        bail!("the window ended with {status}");
    }
    Ok(())
}

fn window() -> anyhow::Result<PathBuf> {
    let window = std::env::current_exe()?.with_file_name(WINDOW);
    if !window.is_file() {
        bail!("there is no {}; build it with `cargo build --release -p dashpot-gui`", window.display());
    }
    Ok(window)
}

/// Starts the empty user interface without waiting for its end. So the console of a double-clicked command closes at once.
pub fn start() -> anyhow::Result<()> {
    let window = window()?;
    Command::new(&window).spawn().with_context(|| format!("cannot start {}", window.display()))?;
    Ok(())
}

/// Returns whether the command was started from the desktop. In that case, Windows created a console to which only this process is
/// attached.
#[cfg(windows)]
pub fn was_double_clicked() -> bool {
    let mut processes = [0u32; 2];
    // SAFETY: the array has 2 elements, as the second argument states, and the function writes no more.
    let count = unsafe { windows_sys::Win32::System::Console::GetConsoleProcessList(processes.as_mut_ptr(), 2) };
    count == 1
}

/// Returns `false`, because desktops other than Windows start the user interface directly.
#[cfg(not(windows))]
pub fn was_double_clicked() -> bool {
    false
}
