//! `dashpot export`: export of a damper for other programs.

mod adams;
mod adm;
mod dpr;
mod fmu;

/// Write a damper for another program
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  dashpot export fmu damper.toml -o damper.fmu\n  dashpot export adams damper.toml -o run --length 412.5"
)]
pub struct Args {
    #[command(subcommand)]
    form: Form,
}

#[derive(clap::Subcommand)]
enum Form {
    Adams(adams::Args),
    Adm(adm::Args),
    Dpr(dpr::Args),
    Fmu(fmu::Args),
}

/// Runs the verb.
pub fn run(args: &Args) -> anyhow::Result<()> {
    match &args.form {
        Form::Adams(args) => adams::run(args),
        Form::Adm(args) => adm::run(args),
        Form::Dpr(args) => dpr::run(args),
        Form::Fmu(args) => fmu::run(args),
    }
}
