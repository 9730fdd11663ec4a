//! Under way.
/// Under way
#[derive(clap::Args)]
pub struct Args {}
/// Runs the verb.
pub fn run(_: &Args) -> anyhow::Result<()> { anyhow::bail!("under way") }
