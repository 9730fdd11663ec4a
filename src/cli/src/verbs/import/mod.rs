//! `dashpot import`: dampers from other programs.

mod dpr;

/// Start a model from the files of another program
#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    form: Form,
}

#[derive(clap::Subcommand)]
enum Form {
    Dpr(dpr::Args),
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    match &args.form {
        Form::Dpr(args) => dpr::run(args),
    }
}
