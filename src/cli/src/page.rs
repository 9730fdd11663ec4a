//! Options that every report has, and what a report was made from.

use anyhow::Context as _;
use dashpot_report::words::{Language, Words};
use dashpot_report::{Made, MadeFrom, Print, made};
use std::path::PathBuf;

/// How a report is written.
#[derive(clap::Args, Debug, Clone, Default)]
pub struct PageArgs {
    /// Language of the report: en, de, fr or zh
    #[arg(long, value_name = "de|fr|zh|en", default_value = "en")]
    language: Language,
    /// Print all of the report, not its first two pages alone
    #[arg(long)]
    full: bool,
    /// Date to write into the report; without it that of SOURCE_DATE_EPOCH, or none, so that the same input gives the same
    /// report
    #[arg(long, value_name = "DATE")]
    date: Option<String>,
}

/// Options that name outputs, with their values: they say where a result went, not how it came about.
const OUTPUTS: [&str; 7] = ["--report", "--json", "--svg", "--certificate", "--output", "-o", "--date"];

impl PageArgs {
    /// The texts.
    pub fn words(&self) -> &'static Words {
        self.language.words()
    }

    /// What goes on paper.
    pub fn print(&self) -> Print {
        if self.full { Print::Whole } else { Print::Brief }
    }

    /// What a report of these files is made from.
    pub fn made(&self, files: impl IntoIterator<Item = PathBuf>) -> anyhow::Result<Made> {
        let date = match (&self.date, std::env::var("SOURCE_DATE_EPOCH")) {
            (Some(date), _) => Some(date.clone()),
            (None, Ok(text)) => {
                let seconds = text.trim().parse();
                Some(made::day_of(
                    seconds.with_context(|| format!("SOURCE_DATE_EPOCH is {text:?}, not seconds since 1970"))?,
                ))
            }
            (None, Err(_)) => None,
        };
        Ok(Made {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            date,
            command: command(std::env::args().skip(1)),
            files: files.into_iter().filter_map(|file| MadeFrom::of(&file)).collect(),
        })
    }
}

/// The command line without its outputs, as a shell takes it.
fn command(arguments: impl Iterator<Item = String>) -> String {
    let mut words = vec!["dashpot".to_owned()];
    let mut skip = false;
    for argument in arguments {
        if std::mem::take(&mut skip) {
            continue;
        }
        if OUTPUTS.contains(&argument.as_str()) {
            skip = true;
            continue;
        }
        if argument == "--force" || OUTPUTS.iter().any(|o| argument.strip_prefix(o).is_some_and(|r| r.starts_with('=')))
        {
            continue;
        }
        let plain = |c: char| c.is_alphanumeric() || "-_./=,:+%@".contains(c);
        words.push(if !argument.is_empty() && argument.chars().all(plain) {
            argument
        } else {
            format!("'{}'", argument.replace('\'', "'\\''"))
        });
    }
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::command;

    #[test]
    fn the_command_is_told_without_its_outputs() {
        let of = |line: &[&str]| command(line.iter().map(ToString::to_string));
        assert_eq!(
            of(&["validate", "m.toml", "my data", "--report", "r.html", "--json=-", "--limits", "l.csv", "--force"]),
            "dashpot validate m.toml 'my data' --limits l.csv"
        );
        assert_eq!(of(&["fit", "a*.csv", "-o", "m.toml"]), "dashpot fit 'a*.csv'");
    }
}
