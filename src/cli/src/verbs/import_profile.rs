//! `dashpot import-profile`: storage of the options for reading records in a file in their folder.

use super::data::DataArgs;
use crate::plural::count_tests;
use anyhow::bail;
use dashpot_output::Kind;
use dashpot_records::{Profile, profile};
use dashpot_report::reading;
use dashpot_report::words::TERMINAL;
use std::path::PathBuf;

/// Store the options for reading records in their folder, so that every verb uses them
///
/// Uses the options of the other verbs, and reads the records with these options. Writes the options to campaign.toml in the folder of the
/// records. Existing entries of campaign.toml stay unless an option replaces them.
#[derive(clap::Args)]
#[command(
    after_help = "Example:\n  dashpot import-profile records/ --column time=Zeit --column force=\"Kanal 3\" --unit force=kN --positive compression --exclude 'warmup*'"
)]
pub struct Args {
    #[command(flatten)]
    data: DataArgs,
    /// Another file to write instead
    #[arg(short, long, value_name = "F.toml")]
    output: Option<PathBuf>,
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    let mut folders: Vec<PathBuf> = args.data.data.iter().map(|p| profile::folder_of(p)).collect();
    folders.dedup();
    let [folder] = &folders[..] else {
        bail!("the records lie in {} folders; write one profile for each", folders.len());
    };
    let path = args.output.clone().unwrap_or_else(|| folder.join(profile::FILE));
    dashpot_output::check_kinds([(Some(path.as_path()), Kind::Profile)])?;
    let campaign = args.data.load()?;
    let mut options = args.data.options()?;
    if let Some(earlier) = Profile::read(folder)? {
        options = options.over(&earlier.options().map_err(anyhow::Error::msg)?);
        options.exclude.sort();
        options.exclude.dedup();
    }
    dashpot_output::write(&path, Profile::from_options(&options).text())?;
    let to = Some(path.as_path());
    dashpot_output::say(to, &reading::sign_in_words(&campaign.sign, &TERMINAL))?;
    for note in campaign.notes.iter().filter(|n| !super::data::is_shown_first(n)) {
        dashpot_output::say(to, &format!("note: {}", note.text))?;
    }
    dashpot_output::say(
        to,
        &format!("{} can be read so; said in {}", count_tests(campaign.records.len()), path.display()),
    )
}
