//! Rig records on the command line: paths, units, columns, signs.

use crate::progress::Progress;
use anyhow::{Context as _, bail};
use clap::Args;
use dashpot_lab::records::{Campaign, Options, Positive, Record, SignFinding, assignment, load};
use std::path::PathBuf;

/// How to read records.
#[derive(Args, Debug, Clone)]
pub struct DataArgs {
    /// Record files (CSV, XLSX, MAT v5) or folders of them
    #[arg(required = true, value_name = "DATA")]
    pub data: Vec<PathBuf>,
    /// Which direction the files count positive; worked out from the data if not given
    #[arg(long, value_name = "rebound|compression")]
    positive: Option<Positive>,
    /// Turn the sign of one channel: force or motion (displacement and velocity)
    #[arg(long, value_name = "force|motion")]
    flip: Vec<String>,
    #[command(flatten)]
    columns: ColumnArgs,
    /// Displacement at the first sample, m, where only velocity was recorded
    #[arg(long, value_name = "M", default_value_t = 0.0, allow_negative_numbers = true)]
    initial_position: f64,
}

/// Which column is which channel, and in which unit.
#[derive(Args, Debug, Clone, Default)]
pub struct ColumnArgs {
    /// Unit of a channel whose heading has none, such as force=kN
    #[arg(long, value_name = "CHANNEL=UNIT")]
    unit: Vec<String>,
    /// Heading of a channel's column, such as force="Load Cell 1"
    #[arg(long, value_name = "CHANNEL=HEADING")]
    column: Vec<String>,
    /// Channel to leave unread, such as velocity
    #[arg(long, value_name = "CHANNEL")]
    ignore: Vec<String>,
}

impl ColumnArgs {
    /// As options of the reader; everything else is left to the files.
    pub fn options(&self) -> anyhow::Result<Options> {
        let mut options = Options::default();
        for text in &self.unit {
            let (channel, unit) = assignment(text).map_err(anyhow::Error::msg).context("--unit")?;
            options.units.insert(channel, unit.parse().map_err(anyhow::Error::msg).context("--unit")?);
        }
        for text in &self.column {
            let (channel, heading) = assignment(text).map_err(anyhow::Error::msg).context("--column")?;
            options.columns.insert(channel, heading.to_owned());
        }
        for text in &self.ignore {
            options.ignore.insert(text.parse().map_err(anyhow::Error::msg).context("--ignore")?);
        }
        Ok(options)
    }
}

impl DataArgs {
    /// Records of a folder, read without further options.
    pub fn folder(path: PathBuf) -> DataArgs {
        DataArgs {
            data: vec![path],
            positive: None,
            flip: vec![],
            columns: ColumnArgs::default(),
            initial_position: 0.0,
        }
    }

    fn options(&self) -> anyhow::Result<Options> {
        let mut options =
            Options { positive: self.positive, initial_position: self.initial_position, ..self.columns.options()? };
        for text in &self.flip {
            match text.as_str() {
                "force" => options.flip_force = true,
                "motion" => options.flip_motion = true,
                _ => bail!("--flip takes force or motion, not {text:?}"),
            }
        }
        Ok(options)
    }

    /// Reads and cleans the records.
    pub fn load(&self) -> anyhow::Result<Campaign> {
        let progress = Progress::new("reading");
        Ok(load(&self.data, &self.options()?, &|p| progress.count(p.done, p.total))?)
    }

    /// The paths in words.
    pub fn named(&self) -> String {
        self.data.iter().map(|p| p.display().to_string()).collect::<Vec<_>>().join(", ")
    }
}

/// The sign that was found or given, in a sentence.
pub fn sign_in_words(sign: &SignFinding) -> String {
    let direction = match sign.positive {
        Positive::Rebound => "rebound",
        Positive::Compression => "compression",
    };
    if sign.given {
        return format!("The files count {direction} positive, as given.");
    }
    let reasons = if sign.reasons.is_empty() { String::new() } else { format!(": {}", sign.reasons.join("; ")) };
    format!("The files count {direction} positive ({:.0} % sure){reasons}.", 100.0 * sign.confidence)
}

/// Whether a test's name matches one of the patterns, in which `*` stands for anything and `?` for one character.
pub fn matches(record: &Record, patterns: &[String]) -> bool {
    patterns.iter().any(|p| glob(p.as_bytes(), record.name.as_bytes()))
}

fn glob(pattern: &[u8], name: &[u8]) -> bool {
    match (pattern.split_first(), name.split_first()) {
        (None, None) => true,
        (Some((b'*', rest)), _) => (0..=name.len()).any(|k| glob(rest, &name[k..])),
        (Some((b'?', rest)), Some((_, tail))) => glob(rest, tail),
        (Some((p, rest)), Some((n, tail))) => p == n && glob(rest, tail),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns() {
        for (pattern, name, want) in [
            ("a40*", "a40mm_v0052", true),
            ("a40*", "a4mm", false),
            ("*52*", "a40mm_v0052mm_s", true),
            ("a?0*", "a50mm", true),
            ("slow", "slower", false),
            ("*", "", true),
        ] {
            assert_eq!(glob(pattern.as_bytes(), name.as_bytes()), want, "{pattern} {name}");
        }
    }
}
