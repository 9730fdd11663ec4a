//! `dashpot`: from rig records to a damper that a simulator can run.

mod inputs;
mod limits;
mod page;
mod plural;
mod progress;
mod quantity;
mod verbs;

use clap::{CommandFactory as _, FromArgMatches as _, Parser, Subcommand};
use dashpot_abi::version::DASHPOT_ABI_VERSION;
use std::process::ExitCode;
use std::sync::LazyLock;

/// Identify a suspension damper from rig records, validate the model, and run it.
///
/// Units are SI. Extension (rebound) velocity and tension force are positive everywhere, except in your own files.
#[derive(Parser)]
#[command(
    name = "dashpot",
    version,
    arg_required_else_help = true,
    after_help = "First steps:\n  dashpot demo                         everything once, on a virtual rig\n  dashpot fit RECORDS/ -o damper.toml  your own records\n  dashpot validate damper.toml RECORDS/ --report report.html\n  dashpot open RECORDS/                the window"
)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
    /// Let results replace inputs, files of another kind and write-protected files
    #[arg(long, global = true)]
    force: bool,
}

#[derive(Subcommand)]
enum Verb {
    Fit(verbs::fit::Args),
    Validate(verbs::validate::Args),
    Check(verbs::check::Args),
    Diagnose(verbs::diagnose::Args),
    Explain(verbs::explain::Args),
    Setting(verbs::setting::Args),
    Simulate(verbs::simulate::Args),
    Matrix(verbs::matrix::Args),
    Rig(verbs::rig::Args),
    Demo(verbs::demo::Args),
    Bench(verbs::bench::Args),
    Export(verbs::export::Args),
    Import(verbs::import::Args),
    ImportProfile(verbs::import_profile::Args),
    Manoeuvre(verbs::manoeuvre::Args),
    Open(verbs::open::Args),
    Completions(verbs::completions::Args),
    Man(verbs::man::Args),
}

/// Version of the command and of its C interface, for bug reports.
static VERSION: LazyLock<String> =
    LazyLock::new(|| format!("{} (interface version {DASHPOT_ABI_VERSION})", env!("CARGO_PKG_VERSION")));

/// Returns the definition of the command line: all verbs and options.
fn command() -> clap::Command {
    Cli::command().version(VERSION.as_str())
}

fn main() -> ExitCode {
    // A command without arguments whose console belongs to it alone was started by a double click.
    if std::env::args_os().len() == 1 && verbs::open::was_double_clicked() {
        let code = ended(verbs::open::start());
        if code != ExitCode::SUCCESS {
            // The console and its messages disappear when the command ends, so the command waits for the user.
            dashpot_output::warn("Press Enter to close.");
            let _ = std::io::stdin().read_line(&mut String::new());
        }
        return code;
    }
    let parsed = command().try_get_matches();
    let parsed = parsed.and_then(|matches| Cli::from_arg_matches(&matches).map(|cli| (cli, matches)));
    let (cli, matches) = match parsed {
        Ok(parsed) => parsed,
        Err(told) => return tell_usage(&told),
    };
    dashpot_output::set_force(cli.force);
    dashpot_output::register_inputs(inputs::named(&matches));
    if let Some(error) = dashpot_output::stdout_closed() {
        dashpot_output::warn(&format!("dashpot: {error}"));
        return ExitCode::from(2);
    }
    let done = match cli.verb {
        Verb::Fit(args) => verbs::fit::run(&args),
        Verb::Validate(args) => return judged(verbs::validate::run(&args)),
        Verb::Check(args) => return judged(verbs::check::run(&args)),
        Verb::Diagnose(args) => verbs::diagnose::run(&args),
        Verb::Explain(args) => verbs::explain::run(&args),
        Verb::Setting(args) => verbs::setting::run(&args),
        Verb::Simulate(args) => verbs::simulate::run(&args),
        Verb::Matrix(args) => verbs::matrix::run(&args),
        Verb::Rig(args) => verbs::rig::run(&args),
        Verb::Demo(args) => verbs::demo::run(&args),
        Verb::Bench(args) => verbs::bench::run(&args),
        Verb::Export(args) => verbs::export::run(&args),
        Verb::Import(args) => verbs::import::run(&args),
        Verb::ImportProfile(args) => verbs::import_profile::run(&args),
        Verb::Manoeuvre(args) => verbs::manoeuvre::run(&args),
        Verb::Open(args) => verbs::open::run(&args),
        Verb::Completions(args) => verbs::completions::run(&args, command()),
        Verb::Man(args) => verbs::man::run(&args, command()),
    };
    ended(done)
}

/// Returns the exit code of a verb with a verdict: 1 if the verdict is [`verbs::Verdict::Failed`], 2 for an error, else
/// 0. `validate` fails if a limit is violated or could not be tested. `check --strict` fails if the damper chatters.
fn judged(found: anyhow::Result<verbs::Verdict>) -> ExitCode {
    match found {
        Ok(verbs::Verdict::Failed) => ExitCode::FAILURE,
        other => ended(other.map(|_| ())),
    }
}

/// Returns the exit code of a result: 2 for an error, which is also printed.
fn ended(done: anyhow::Result<()>) -> ExitCode {
    match done {
        Ok(()) => ExitCode::SUCCESS,
        // A reader that closes the pipe early, such as `head`, is no error.
        Err(error) if is_closed_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            dashpot_output::warn(&format!("dashpot: {}", dashpot_output::format_once(&error)));
            ExitCode::from(2)
        }
    }
}

/// Prints requested help, the version, or an error of the command line. Returns the exit code.
fn tell_usage(told: &clap::Error) -> ExitCode {
    let text = told.render().to_string();
    let shown = dashpot_output::printable(&text);
    if shown != text {
        // The message quotes the user's input, which may contain characters that affect the terminal. clap would print
        // them unescaped. Therefore, the escaped text is printed, without colors.
        dashpot_output::warn(&shown);
        return ExitCode::from(u8::try_from(told.exit_code()).unwrap_or(2));
    }
    let printed = told.print().and_then(|()| std::io::Write::flush(&mut std::io::stdout()));
    let code = match printed {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => 2,
        _ if dashpot_output::stdout_closed().is_some() => 2,
        _ => told.exit_code(),
    };
    ExitCode::from(u8::try_from(code).unwrap_or(2))
}

fn is_closed_pipe(error: &anyhow::Error) -> bool {
    error.chain().filter_map(|e| e.downcast_ref::<std::io::Error>()).any(|e| e.kind() == std::io::ErrorKind::BrokenPipe)
}
