//! `dashpot import`: import of dampers from other programs and tables.

mod dpr;
mod peaks;

/// Start a model from the files of another program or a table
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot import peaks pvp.csv -o damper.toml --gas-force 150\n  dashpot import dpr mdi_0001.dpr -o damper.toml"
)]
pub struct Args {
    #[command(subcommand)]
    form: Form,
}

#[derive(clap::Subcommand)]
enum Form {
    Dpr(dpr::Args),
    Peaks(peaks::Args),
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    match &args.form {
        Form::Dpr(args) => dpr::run(args),
        Form::Peaks(args) => peaks::run(args),
    }
}
