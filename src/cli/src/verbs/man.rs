//! `dashpot man`: manual pages.

use anyhow::Context as _;
use clap_mangen::Man;
use std::path::PathBuf;

/// Write the manual pages, one for the command and one for each verb, into a folder
///
/// They contain the text of --help in the format of man.
#[derive(clap::Args)]
#[command(after_help = "Example:\n  dashpot man man1 && man -l man1/dashpot-fit.1")]
pub struct Args {
    /// Folder to write to; created if it does not exist
    #[arg(value_name = "DIR")]
    output: PathBuf,
}

/// Runs the verb. `command` defines all verbs and options.
pub fn run(args: &Args, command: clap::Command) -> anyhow::Result<()> {
    let mut command = command.disable_help_subcommand(true);
    command.build();
    let mut pages = Vec::new();
    collect(&command, command.get_version().unwrap_or_default(), &mut pages)?;
    let folder = &args.output;
    std::fs::create_dir_all(folder).with_context(|| format!("making the folder {}", folder.display()))?;
    let paths: Vec<PathBuf> = pages.iter().map(|(name, _)| folder.join(name)).collect();
    dashpot_output::check(paths.iter().map(PathBuf::as_path))?;
    for (path, (_, text)) in paths.iter().zip(&pages) {
        dashpot_output::write(path, text)?;
    }
    dashpot_output::say(None, &format!("{} pages in {}", pages.len(), folder.display()))
}

/// Collects the pages of a command and its subcommands: file name and text.
fn collect(command: &clap::Command, version: &str, pages: &mut Vec<(String, Vec<u8>)>) -> anyhow::Result<()> {
    let name = command.get_display_name().unwrap_or_else(|| command.get_name()).to_owned();
    let page = Man::new(command.clone()).title(&name).source(format!("dashpot {version}"));
    let mut text = Vec::new();
    page.render(&mut text)?;
    pages.push((format!("{name}.1"), text));
    command.get_subcommands().try_for_each(|below| collect(below, version, pages))
}
