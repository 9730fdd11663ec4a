//! Command-line options that all reports share, and the origin of a report: date, command line and hashes of its files.

use dashpot_report::words::{Language, Words};
use dashpot_report::{Made, Print, made};
use std::path::PathBuf;

/// Options of a report that can be printed in a short form.
#[derive(clap::Args, Debug, Clone, Default)]
pub struct PageArgs {
    /// Language and date.
    #[command(flatten)]
    pub text: TextArgs,
    /// Print the whole report instead of its first two pages only
    #[arg(long)]
    full: bool,
}

/// Language and date of a report.
#[derive(clap::Args, Debug, Clone, Default)]
pub struct TextArgs {
    /// Language of the report and the workbook: en, de, fr or zh
    #[arg(long, value_name = "de|fr|zh|en", default_value = "en")]
    language: Language,
    #[command(flatten)]
    pub date: DateArgs,
}

/// Date of a report.
#[derive(clap::Args, Debug, Clone, Default)]
pub struct DateArgs {
    /// Date to write into the report. Without it, the date of SOURCE_DATE_EPOCH, or no date, so that the same input gives the same report
    #[arg(long, value_name = "DATE")]
    date: Option<String>,
}

impl PageArgs {
    /// Returns the texts in the chosen language, and the extent of the printed report.
    pub fn words_and_print(&self) -> (&'static Words, Print) {
        (self.text.words(), self.print())
    }

    /// Returns the extent of the printed report.
    pub fn print(&self) -> Print {
        if self.full { Print::Whole } else { Print::Brief }
    }
}

impl TextArgs {
    /// Returns the texts in the chosen language.
    pub fn words(&self) -> &'static Words {
        self.language.words()
    }
}

impl DateArgs {
    /// Returns the origin of a report that is based on these files: date, command line, and hashes of the files.
    pub fn made(&self, files: impl IntoIterator<Item = PathBuf>) -> anyhow::Result<Made> {
        let date = made::date(self.date.as_deref())?;
        let files: Vec<PathBuf> = files.into_iter().collect();
        let made = Made::from_files(files.iter().map(PathBuf::as_path));
        Ok(Made { date, command: command(std::env::args().skip(1)), ..made })
    }
}

/// Returns the command line in shell syntax, with all its words as typed.
fn command(arguments: impl Iterator<Item = String>) -> String {
    made::command_line(std::iter::once("dashpot".to_owned()).chain(arguments))
}

#[cfg(test)]
mod tests {
    use super::command;

    #[test]
    fn the_command_has_all_its_words() {
        let of = |line: &[&str]| command(line.iter().map(ToString::to_string));
        assert_eq!(
            of(&["validate", "m.toml", "my data", "--report", "r.html", "--json=-", "--force", "--next-tests=n.csv"]),
            "dashpot validate m.toml 'my data' --report r.html --json=- --force --next-tests=n.csv"
        );
        assert_eq!(of(&["fit", "a*.csv", "-o", "m.toml"]), "dashpot fit 'a*.csv' -o m.toml");
    }
}
