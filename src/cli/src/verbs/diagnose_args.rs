//! Arguments of `dashpot diagnose`.

use super::data::DataArgs;
use crate::page::PageArgs;
use std::path::PathBuf;

/// Find where a model and the records of its damper disagree, name the missing effect, and add it
///
/// Every effect in question is added and everything is refitted with it. What is named has to explain tests that no refit
/// has seen; where two effects explain the records as well, or none does, the answer says so.
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
    /// Every table as a sheet of one Excel workbook, numbers as numbers
    #[arg(long, value_name = "F.xlsx")]
    pub excel: Option<PathBuf>,
    /// The tests that would tell more, as a test matrix for the rig
    #[arg(long, value_name = "F.csv")]
    pub next_tests: Option<PathBuf>,
    /// Folder for every figure of the report as an SVG file
    #[arg(long, value_name = "DIR")]
    pub svg: Option<PathBuf>,
    /// Tests that no refit sees, by name; * stands for anything. Chosen over all amplitudes and speeds if not given
    #[arg(long, value_name = "GLOB", value_delimiter = ',')]
    pub hold_out: Vec<String>,
    /// Most effects to add
    #[arg(long, value_name = "N", default_value_t = 3, allow_negative_numbers = true)]
    pub max_effects: usize,
    /// Effects that may be named, separated by commas; all if not given
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    pub candidates: Option<Vec<String>>,
    /// Records of the same tests on a damper known to be good: a folder or file; may be given several times. The question is then what
    /// changed, and what the model's form leaves on both dampers alike is taken out of it: the surest way wherever there is one
    #[arg(long, value_name = "GOOD")]
    pub reference: Vec<PathBuf>,
    /// Many dampers or settings at once, each compared with the reference, or with the first where none is given. The word folders: every
    /// folder in DATA is one. Or a pattern of the tests' names with {} where the group stands, such as '*_c{}_*'. Or a list (CSV with a heading,
    /// tests or folders in its first column) and the column that tells the groups apart, such as tests.csv:clicks
    #[arg(long, value_name = "BY", conflicts_with_all = ["output", "svg", "hold_out", "next_tests"])]
    pub group: Option<String>,
    /// Compare each group with the one before it, in their order: what one click of an adjuster, or one stage of wear, changes
    #[arg(long, requires = "group")]
    pub chain: bool,
    /// Dimensions of the damper, a TOML file with the unit in every key: they make priors of what follows from them
    #[arg(long, value_name = "D.toml")]
    pub dimensions: Option<PathBuf>,
    /// Of a damper over a setting: the setting of tests that say none. Without a model, the name of the setting (current, clicks): the
    /// damper over it is fitted to DATA first
    #[arg(long, value_name = "VALUE|NAME", allow_hyphen_values = true)]
    pub setting: Option<String>,
    /// Chooses which tests are left out
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    pub seed: u64,
    #[command(flatten)]
    pub page: PageArgs,
}
