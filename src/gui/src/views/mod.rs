//! The views, one file each. A view reads the session and calls its functions; it stores only the state of the display.
//!
//! | file | view |
//! |---|---|
//! | [`bar`] | menus, and the buttons that fit, validate and diagnose, at the top |
//! | [`fit`] | the button that fits a model |
//! | [`status`] | progress, cancel and the last message, at the bottom |
//! | [`tests`] | the tests with their notes |
//! | [`test_setting`] | the field for the setting of a test |
//! | [`plots`], [`lines`], [`legend`] | loops, force over time, peak forces with the draggable curve |
//! | [`matrix`] | the error matrix |
//! | [`tables`] | forces at peak velocities and at given velocities |
//! | [`tune`] | elements and sliders |
//! | [`results`] | results of fit, validation and diagnosis |
//! | [`records`] | options of reading |
//! | [`study`] | variation of one parameter, and preview of an effect |
//! | [`valve`] | response of an adjustable damper's valve to a step |
//! | [`drawing`] | physical quantities from the dimensions of the damper |
//! | [`choosing`] | choice of a file or folder if the system shows no dialogs |
//! | [`closing`], [`replacing`] | confirmation before a loss of data |

pub mod bar;
pub mod choosing;
pub mod closing;
pub mod drawing;
pub mod fit;
mod grid;
mod legend;
pub mod lines;
pub mod matrix;
pub mod plots;
pub mod records;
pub mod replacing;
pub mod results;
pub mod status;
pub mod study;
pub mod tables;
mod test_setting;
pub mod tests;
pub mod tune;
pub mod valve;

use crate::dialogs::Ask;
use crate::format::Format;
use crate::session::matrix::Across;
use crate::units::Units;
use crate::words::{self, Language, Words};
use dashpot_core::parameter::Element;
use eframe::egui::{self, Color32};

/// Panel on the right-hand side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Side {
    /// Elements and sliders of the model.
    #[default]
    Tune,
    /// Results of fit, validation and diagnosis.
    Result,
    /// Options of reading.
    Records,
    /// Variation of one parameter, and preview of an effect.
    Study,
    /// The valve of an adjustable damper.
    Valve,
    /// The dimensions of the damper.
    Drawing,
}

/// Contents of the area at the lower right.
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
    /// Loops of one test for several values of a parameter.
    Study,
}

/// State of the display.
#[derive(Default)]
pub struct View {
    /// Language of all texts.
    pub language: Language,
    /// Filter of the list of tests: names must contain this text.
    pub filter: String,
    /// Index of a test and the text in the field of its setting, while the user types.
    pub typed_setting: Option<(usize, String)>,
    /// Index of the test that was clicked last. A range of tests begins at this test.
    pub anchor: Option<usize>,
    /// Panel on the right-hand side.
    pub side: Side,
    /// Whether the panel of the results is to show its beginning in the next frame.
    pub is_result_new: bool,
    /// Contents of the area at the lower right.
    pub corner: Corner,
    /// Quantity of the columns of the error matrix.
    pub across: Across,
    /// Lines of the plots, which are cached until their inputs change.
    pub lines: lines::Cache,
    /// Index of the point of the FV curve that the pointer drags.
    pub grabbed: Option<usize>,
    /// Reason why the dragged point does not follow the pointer.
    pub stopped: Option<plots::Stop>,
    /// Units of plots, sliders and tables.
    pub units: Units,
    /// Input of the study.
    pub question: study::Form,
    /// Previewed effect and its strength.
    pub effect: Option<(Element, f64)>,
    /// Pending requests to the user.
    pub asks: Vec<Ask>,
    /// An open dialog for a file or folder inside the window.
    pub choosing: Option<choosing::Choosing>,
    /// Completed choices of the dialogs inside the window.
    pub chosen: Vec<(Ask, Vec<std::path::PathBuf>)>,
    /// Whether the confirmation to close is open.
    pub closing: bool,
    /// Whether the window may close.
    pub may_close: bool,
}

impl View {
    /// Returns the texts of the window in the selected language.
    pub fn words(&self) -> &'static Words {
        words::texts(self.language)
    }

    /// Returns the selected language and units.
    pub fn format(&self) -> Format {
        Format { language: self.language, units: self.units }
    }
}

/// Returns the width of a text in one line, px.
pub fn text_width(ui: &egui::Ui, text: &str, style: egui::TextStyle) -> f32 {
    let font = style.resolve(ui.style());
    ui.painter().layout_no_wrap(text.to_owned(), font, Color32::WHITE).size().x
}

/// Formats an error in percent. A provisional error has a mark.
pub fn percent(value: f64, is_provisional: bool, w: &Words) -> String {
    let mark = if is_provisional { "≈\u{a0}" } else { "" };
    format!("{mark}{}\u{a0}%", w.fixed(value, 2))
}

/// Adds the reason of the mark to a provisional number.
pub fn explain_provisional(response: egui::Response, is_provisional: bool, w: &Words) {
    if is_provisional {
        response.on_hover_text(w.provisional);
    }
}

/// Returns the display name of an element or a parameter, as in the reports. Without such a name, returns the identifier with spaces.
pub fn translate_name(identifier: &str, words: &dashpot_report::words::Words) -> String {
    words.name_of(identifier).map_or_else(|| identifier.replace('_', " "), str::to_owned)
}

/// Returns the name of a setting, translated if the reports contain a translation.
pub fn setting_name<'a>(name: &'a str, words: &dashpot_report::words::Words) -> &'a str {
    match name {
        "current" => words.word("current"),
        "clicks" => words.word("clicks"),
        "voltage" => words.word("voltage"),
        "pressure" => words.word("pressure"),
        _ => name,
    }
}

/// Parses a `#rrggbb` color of the report's palette. An invalid text gives gray.
pub fn colour(hex: &str) -> Color32 {
    Color32::from_hex(hex).unwrap_or(Color32::GRAY)
}

/// Hues of the measured tests, on dark and on light backgrounds.
///
/// The first six are from Okabe & Ito, *Color Universal Design*, 2008, so that color-blind readers can distinguish them. Olive and violet
/// are additions.
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

/// Returns the color of the selected test with index `k`.
pub fn hue(k: usize) -> Color32 {
    HUES[k % HUES.len()]
}

/// Gives a drop-down list an accessible name.
pub fn named_list<R>(list: egui::InnerResponse<R>, name: &str) -> egui::Response {
    list.response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::ComboBox, true, name));
    list.response
}
