//! `dashpot`: from rig records to a damper that a simulator can run.

mod adams;
mod fmu;
mod plot;
mod progress;
mod report;
mod verbs;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Identify a suspension damper from rig records, validate the model, and run it.
///
/// Units are SI; extension (rebound) velocity and tension force are positive everywhere but in your own files.
#[derive(Parser)]
#[command(
    version,
    arg_required_else_help = true,
    after_help = "First steps:\n  dashpot demo                         everything once, on a virtual rig\n  dashpot fit RECORDS/ -o damper.toml  your own records\n  dashpot validate damper.toml RECORDS/ --report report.html"
)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    Fit(verbs::fit::Args),
    Validate(verbs::validate::Args),
    Diagnose(verbs::diagnose::Args),
    Simulate(verbs::simulate::Args),
    Matrix(verbs::matrix::Args),
    Rig(verbs::rig::Args),
    Demo(verbs::demo::Args),
    Bench(verbs::bench::Args),
    Export(verbs::export::Args),
    Import(verbs::import::Args),
    Manoeuvre(verbs::manoeuvre::Args),
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    let done = match cli.verb {
        Verb::Fit(args) => verbs::fit::run(&args),
        Verb::Validate(args) => verbs::validate::run(&args),
        Verb::Diagnose(args) => verbs::diagnose::run(&args),
        Verb::Simulate(args) => verbs::simulate::run(&args),
        Verb::Matrix(args) => verbs::matrix::run(&args),
        Verb::Rig(args) => verbs::rig::run(&args),
        Verb::Demo(args) => verbs::demo::run(&args),
        Verb::Bench(args) => verbs::bench::run(&args),
        Verb::Export(args) => verbs::export::run(&args),
        Verb::Import(args) => verbs::import::run(&args),
        Verb::Manoeuvre(args) => verbs::manoeuvre::run(&args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        // A reader that has read enough, such as `head`, is no error.
        Err(error) if is_closed_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("dashpot: {}", told_once(&error));
            ExitCode::from(2)
        }
    }
}

/// The error with its causes, without those that it already names.
fn told_once(error: &anyhow::Error) -> String {
    error.chain().fold(String::new(), |told, cause| match cause.to_string() {
        cause if told.contains(&cause) => told,
        cause if told.is_empty() => cause,
        cause => format!("{told}: {cause}"),
    })
}

fn is_closed_pipe(error: &anyhow::Error) -> bool {
    error.chain().filter_map(|e| e.downcast_ref::<std::io::Error>()).any(|e| e.kind() == std::io::ErrorKind::BrokenPipe)
}
