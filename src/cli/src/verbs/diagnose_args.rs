//! Arguments of `dashpot diagnose`.

use super::data::DataArgs;
use crate::page::PageArgs;
use std::path::PathBuf;

/// Find where a model and the records of its damper disagree, name the missing effect, and add it
///
/// Each candidate effect is added in turn, and the whole model is refitted with it. A named effect must explain tests that no refit used.
/// If two effects explain the records equally well, or none explains them, the verdict says so.
#[derive(clap::Args)]
#[command(
    mut_arg("data", |data| data.required(false).required_unless_present("setting")),
    after_help = "Examples:\n  dashpot diagnose damper.toml campaign/ -o improved.toml --report diagnosis.html --json diagnosis.json --excel diagnosis.xlsx\n  dashpot diagnose damper.toml fleet/ --group folders --reference good/ --report fleet.html\n  dashpot diagnose family.toml campaign/ --json diagnosis.json\n  dashpot diagnose campaign/ --setting current --report diagnosis.html"
)]
pub struct Args {
    /// Model file
    #[arg(value_name = "MODEL")]
    pub model: PathBuf,
    #[command(flatten)]
    pub data: DataArgs,
    /// Model file to write, with the named effects added
    #[arg(short, long, value_name = "MODEL")]
    pub output: Option<PathBuf>,
    /// Findings as JSON; - for standard output
    #[arg(long, value_name = "F")]
    pub json: Option<PathBuf>,
    /// Report for people, one HTML file
    #[arg(long, value_name = "F.html")]
    pub report: Option<PathBuf>,
    /// Every table as a sheet of one Excel workbook, with numeric cells
    #[arg(long, value_name = "F.xlsx")]
    pub excel: Option<PathBuf>,
    /// Proposed tests that give more information, as a test matrix for the rig
    #[arg(long, value_name = "F.csv")]
    pub next_tests: Option<PathBuf>,
    /// Folder for every figure of the report as an SVG file
    #[arg(long, value_name = "DIR")]
    pub svg: Option<PathBuf>,
    /// Tests that no refit uses, by name; * stands for any characters. If not given, tests are chosen over all amplitudes and speeds
    #[arg(long, value_name = "GLOB", value_delimiter = ',')]
    pub hold_out: Vec<String>,
    /// Largest number of effects to add
    #[arg(long, value_name = "N", default_value_t = 3, allow_negative_numbers = true)]
    pub max_effects: usize,
    /// Effects that the diagnosis may name, separated by commas; all if not given
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    pub candidates: Option<Vec<String>>,
    /// Records of the same tests on a damper known to be good: a folder or file; may be given several times. The diagnosis then searches
    /// for changes. The form error of the model, which both dampers share, is corrected. Use a reference whenever one is available
    #[arg(long, value_name = "GOOD")]
    pub reference: Vec<PathBuf>,
    /// Many dampers or settings at once, each compared with the reference, or with the first group if no reference is given. BY is the word
    /// folders (each folder in DATA is a group), a pattern of test names, or a list. A pattern has {} at the position of the group, such as
    /// '*_c{}_*'. A list is a CSV file with a heading and its group column, such as tests.csv:clicks. Its first column contains tests or
    /// folders
    #[arg(long, value_name = "BY", conflicts_with_all = ["output", "svg", "hold_out", "next_tests"])]
    pub group: Option<String>,
    /// Compare each group with the preceding one. This shows the change per click of an adjuster or per stage of wear
    #[arg(long, requires = "group")]
    pub chain: bool,
    /// Dimensions of the damper, a TOML file with the unit in every key. The fit derives priors of parameters from them
    #[arg(long, value_name = "D.toml")]
    pub dimensions: Option<PathBuf>,
    /// For a damper over a setting: setting of tests that state none. Without a model: name of the setting (current, clicks). The damper
    /// over that setting is first fitted to DATA
    #[arg(long, value_name = "VALUE|NAME", allow_hyphen_values = true)]
    pub setting: Option<String>,
    /// Seed of the choice of the left-out tests
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    pub seed: u64,
    #[command(flatten)]
    pub page: PageArgs,
}
