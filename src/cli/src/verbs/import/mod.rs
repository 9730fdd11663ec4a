//! `dashpot import`: dampers from other programs and tables.

mod dpr;
mod peaks;

/// Start a model from the files of another program or a table
#[derive(clap::Args)]
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
