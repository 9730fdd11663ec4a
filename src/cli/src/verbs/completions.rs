//! `dashpot completions`: completion of verbs and options for a shell.

use clap_complete::Shell;
use std::path::PathBuf;

/// Print the completions of verbs and options for a shell
///
/// They come from the command's own options, so they match this version.
#[derive(clap::Args)]
#[command(
    after_help = "Example, bash:\n  dashpot completions bash -o ~/.local/share/bash-completion/completions/dashpot\nPowerShell, for this window:\n  dashpot completions powershell | Out-String | Invoke-Expression"
)]
pub struct Args {
    /// The shell
    #[arg(value_name = "SHELL")]
    shell: Shell,
    /// Where to write; standard output if not given
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    output: PathBuf,
}

/// Runs the verb. `command` defines all verbs and options.
pub fn run(args: &Args, mut command: clap::Command) -> anyhow::Result<()> {
    dashpot_output::check([args.output.as_path()])?;
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut command, "dashpot", &mut text);
    dashpot_output::write(&args.output, text)
}
