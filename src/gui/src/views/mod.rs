//! What is drawn, one file a view. A view reads the session, calls what it can do, and keeps nothing but how it is looked at.
//!
//! | file | view |
//! |---|---|
//! | [`bar`] | menus and verbs at the top |
//! | [`fit`] | the button that fits a model |
//! | [`status`] | progress, cancel and what was said last, at the bottom |
//! | [`tests`] | the tests with what was noticed about each |
//! | [`plots`], [`lines`] | loops, force over time, peak forces with the curve that is dragged |
//! | [`matrix`] | the error matrix |
//! | [`tables`] | forces at peak velocities and at given ones |
//! | [`tune`] | elements and sliders |
//! | [`answer`] | what fit, validation and diagnosis found |
//! | [`records`] | how the records are read, corrected by hand |
//! | [`study`] | one number at several values, and what an effect would look like |
//! | [`valve`] | how the valve of a damper over a setting answers a step |
//! | [`drawing`] | what the model says of gas, oil and valves by the drawing |
//! | [`choosing`] | a file or folder, where the system shows no dialogs |
//! | [`closing`], [`replacing`] | asked before anything is lost |

pub mod bar;
pub mod choosing;
pub mod closing;
pub mod drawing;
pub mod fit;
mod grid;
pub mod lines;
pub mod matrix;
pub mod plots;
pub mod records;
pub mod replacing;
pub mod results;
pub mod status;
pub mod study;
pub mod tables;
pub mod tests;
pub mod tune;
pub mod valve;

use crate::dialogs::Ask;
use crate::session::matrix::Across;
use crate::units::Units;
use crate::words::{self, Language, Words};
use dashpot_core::parameter::Element;
use eframe::egui::{self, Color32};

/// What the right-hand side shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Side {
    /// Sliders.
    #[default]
    Tune,
    /// Answers of the verbs.
    Result,
    /// How records are read.
    Records,
    /// Families of loops.
    Study,
    /// The valve of a damper over a setting.
    Valve,
    /// The drawing of the damper.
    Drawing,
}

/// What the place at the lower right shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Corner {
    /// The error matrix.
    #[default]
    Matrix,
    /// Force over time.
    Time,
    /// Gas and drag over displacement.
    GasAndDrag,
    /// Forces at peak and at given velocities, as tables.
    Tables,
    /// Temperature over time.
    Temperature,
    /// The family of loops.
    Study,
}

/// How the session is looked at.
#[derive(Default)]
pub struct View {
    /// Language of all texts.
    pub language: Language,
    /// Tests whose names hold this are listed.
    pub filter: String,
    /// The test that was clicked last: a range begins there.
    pub anchor: Option<usize>,
    /// Right-hand side.
    pub side: Side,
    /// Lower right.
    pub corner: Corner,
    /// What runs across the error matrix.
    pub across: Across,
    /// Lines of the plots, kept until something changes.
    pub lines: lines::Cache,
    /// Point of the FV curve that is being dragged.
    pub grabbed: Option<usize>,
    /// Why it does not follow the pointer.
    pub stopped: Option<plots::Stop>,
    /// Units of plots, sliders and tables.
    pub units: Units,
    /// What the study asks.
    pub question: study::Form,
    /// Effect that is looked at, and its strength.
    pub effect: Option<(Element, f64)>,
    /// Questions to put to the user.
    pub asks: Vec<Ask>,
    /// A file or folder that is chosen in the window itself.
    pub choosing: Option<choosing::Choosing>,
    /// What was chosen so.
    pub chosen: Vec<(Ask, Vec<std::path::PathBuf>)>,
    /// Whether the user is being asked whether to close.
    pub closing: bool,
    /// Whether the window may close.
    pub may_close: bool,
}

impl View {
    /// All texts.
    pub fn words(&self) -> &'static Words {
        words::texts(self.language)
    }
}

/// The name of an element or a parameter as the reports have it, without the identifier, which stands under the pointer.
pub fn translate_name(identifier: &str, words: &dashpot_report::words::Words) -> String {
    words.name_of(identifier).map_or_else(|| identifier.replace('_', " "), str::to_owned)
}

/// The name of a setting, translated where the reports know it.
pub fn setting_name<'a>(name: &'a str, words: &dashpot_report::words::Words) -> &'a str {
    match name {
        "current" => words.word("current"),
        "clicks" => words.word("clicks"),
        "voltage" => words.word("voltage"),
        "pressure" => words.word("pressure"),
        _ => name,
    }
}

/// Colour of a `#rrggbb` text of the report's palette.
pub fn colour(hex: &str) -> Color32 {
    Color32::from_hex(hex).unwrap_or(Color32::GRAY)
}

/// Hues of the measured tests.
///
/// After Okabe & Ito, *Color Universal Design*, 2008, apart for colour-blind readers too; a dark and a light
/// background take the same.
const HUES: [Color32; 8] = [
    Color32::from_rgb(0, 114, 178),
    Color32::from_rgb(230, 159, 0),
    Color32::from_rgb(0, 158, 115),
    Color32::from_rgb(204, 121, 167),
    Color32::from_rgb(86, 180, 233),
    Color32::from_rgb(213, 94, 0),
    Color32::from_rgb(140, 140, 60),
    Color32::from_rgb(130, 110, 200),
];

/// Colour of the so manyeth selected test.
pub fn hue(k: usize) -> Color32 {
    HUES[k % HUES.len()]
}

/// Tells a screen reader what a drop-down list is for.
pub fn named_list<R>(list: egui::InnerResponse<R>, name: &str) -> egui::Response {
    list.response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::ComboBox, true, name));
    list.response
}
