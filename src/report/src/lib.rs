//! The validation report: one self-contained HTML file that opens without a network and prints.
//!
//! [`diagnosis`] writes the report of `dashpot diagnose` with the same blocks.
//!
//! A report is a list of [`Section`]s made of a few kinds of [`Block`]. Every section builder lives in its own file
//! and knows nothing of HTML; [`page`] knows HTML and nothing of dampers. A further section (before/after pictures, a
//! diagnosis) is a [`Section`] put into [`ReportInput::extra`]; its figures are written by [`svgs`] too.
//!
//! The same input gives the same bytes: no clock, no random name, no machine. All text is in [`words`], one file a language.

pub mod against;
pub mod blocks;
pub mod cells;
pub mod certificate;
pub mod diagnosis;
mod each_test;
mod errors;
pub mod family;
pub mod fit;
pub mod groups;
mod hysteresis;
pub mod inventory;
pub mod made;
pub mod manoeuvre;
pub mod numbers;
mod page;
pub mod parameters;
pub mod plot;
pub mod quality;
pub mod reading;
mod subject;
mod summary;
pub mod whole_records;
pub mod words;
mod workbook;

pub use blocks::{Block, Figure, Section};
pub use cells::Cell;
pub use dashpot_output::replace_file;
pub use family::FamilyReport;
pub use made::{Made, MadeFrom};
pub use page::Print;
pub use parameters::ParameterRow;
pub use workbook::{Workbook, write_workbook};

use crate::plot::peaks;
use crate::words::Words;
use anyhow::Context as _;
use dashpot_identification::model_file::{ModelFile, prepared};
use dashpot_identification::validation::{Compared, Validation};
use dashpot_records::Campaign;
use dashpot_simulation::comparison;
use std::path::{Path, PathBuf};

/// Everything a report tells.
#[derive(Debug, Clone)]
pub struct ReportInput<'a> {
    /// Language of the report.
    pub words: &'static Words,
    /// What a printer puts on paper.
    pub print: Print,
    /// What it is made from.
    pub made: Made,
    /// Force of the model at constant velocity, m/s and N.
    pub curve: Vec<[f64; 2]>,
    /// Name of the model file compared.
    pub model_file: String,
    /// Name of the data folder or file compared with.
    pub data: String,
    /// Figures of the comparison.
    pub validation: &'a Validation,
    /// The tests compared, in the order of `validation.tests`; they supply the plots and cleaning notes.
    pub tests: &'a [Compared<'a>],
    /// Parameters of the model; the section is left out when empty.
    pub parameters: Vec<ParameterRow>,
    /// How the model was identified: [`Block::Paragraph`], [`Block::Warning`], tables; left out when empty.
    pub identification: Vec<Block>,
    /// Further sections, placed before the single tests.
    pub extra: Vec<Section>,
    /// The damper over a setting, whose curves come first; absent for an ordinary damper.
    pub family: Option<FamilyReport<'a>>,
}

impl<'a> ReportInput<'a> {
    /// All that a model file, the records it was compared with and the comparison have to tell, in full.
    ///
    /// # Errors
    /// When no step can be taken with the model's parameters.
    pub fn from_validation(
        model: &ModelFile,
        campaign: &Campaign,
        tests: &'a [Compared<'a>],
        validation: &'a Validation,
        words: &'static Words,
    ) -> anyhow::Result<ReportInput<'a>> {
        Ok(ReportInput {
            words,
            print: Print::Whole,
            made: Made::default(),
            curve: comparison::at_constant_velocity(&prepared(&model.params)?, validation),
            model_file: String::new(),
            data: String::new(),
            validation,
            tests,
            parameters: parameters::of_model(model, words),
            identification: reading::blocks(campaign, model, words),
            extra: Vec::new(),
            family: None,
        })
    }
}

/// The tables of the report as a workbook.
pub fn workbook<'a>(input: &ReportInput<'a>) -> Workbook<'a> {
    Workbook {
        title: input.words.title_validation.to_owned(),
        subtitle: subtitle(input),
        sections: sections(input),
        made: input.made.clone(),
        words: input.words,
    }
}

/// The report as one HTML document.
pub fn render(input: &ReportInput<'_>) -> String {
    page::page(input.words.title_validation, &subtitle(input), &sections(input), input.words, input.print)
}

/// A report of other sections, in the same format.
pub fn render_sections(title: &str, subtitle: &str, sections: &[Section], words: &Words) -> String {
    page::page(title, subtitle, sections, words, Print::Whole)
}

/// Writes the report, replacing an older one only when the new one is complete.
///
/// # Errors
/// When the folder does not exist or cannot be written; the older report then stays.
pub fn write_atomic(input: &ReportInput<'_>, path: &Path) -> anyhow::Result<()> {
    write_page(&render(input), path)
}

fn write_page(page: &str, path: &Path) -> anyhow::Result<()> {
    replace_file(path, page.as_bytes()).with_context(|| format!("writing the report {}", path.display()))
}

/// Writes every figure of the report as a file of its own into a folder, which is made if missing. Returns the paths in
/// the order of the report.
///
/// # Errors
/// When the folder or a file cannot be written.
pub fn svgs(input: &ReportInput<'_>, folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    write_figures(&sections(input), folder)
}

fn write_figures(sections: &[Section], folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    std::fs::create_dir_all(folder).with_context(|| format!("making the folder {}", folder.display()))?;
    let mut written = Vec::new();
    for figure in sections.iter().flat_map(Section::figures) {
        let path = folder.join(format!("{}.svg", figure.file));
        replace_file(&path, figure.svg.as_bytes()).with_context(|| format!("writing the figure {}", path.display()))?;
        written.push(path);
    }
    Ok(written)
}

/// All sections in reading order: the answer, the pictures that it rests on, then every test and every table.
fn sections(input: &ReportInput<'_>) -> Vec<Section> {
    let (validation, words) = (input.validation, input.words);
    let mut sections = Vec::new();
    let limits = validation.limits.as_ref().map(|found| certificate::section(found, words));
    let limits_id = limits.as_ref().map(|section| section.id.clone());
    let mut answer = summary::section(validation, words);
    // The verdict is the first sentence; its table follows the first picture, and is printed by the certificate.
    if let Some(Block::Verdict(passed, text)) = limits.as_ref().and_then(|section| section.blocks.first()) {
        answer.blocks.insert(0, Block::Verdict(*passed, text.clone()));
    }
    let family = input.family.map(|family| family.sections(validation, input.tests, words));
    sections.push(answer);
    let first = sections.len() + family.as_ref().map_or(0, Vec::len);
    sections.extend(family.into_iter().flatten());
    if let Some(svg) = peaks::force_at_peak(validation, &input.curve, words) {
        // A family has a line for each setting, in its own figure.
        let caption = if input.family.is_some() { words.fv_caption_by_setting } else { words.fv_caption };
        let figure = Figure::new("force-at-peak", svg).saying(caption);
        sections.push(Section::new("peaks", words.fv_section, vec![Block::Wide(figure)]));
    }
    sections.extend(limits.map(Section::beyond));
    let worst = summary::worst(validation);
    sections.extend(worst.map(|index| each_test::worst(validation, input.tests, index, words)));
    sections.push(errors::pictures(validation, words));
    sections.push(each_test::section(validation, input.tests, words).beyond());
    let mut figures = summary::figures(validation, words);
    figures.blocks.extend(errors::rows(validation, words));
    sections.push(figures.beyond());
    sections.push(errors::tests(validation, words).beyond());
    sections.extend(hysteresis::section(validation, words).map(Section::beyond));
    sections.extend(input.extra.iter().cloned().map(Section::beyond));
    if !input.identification.is_empty() {
        let blocks = input.identification.clone();
        sections.push(Section::new("identification", words.identification_section, blocks).beyond());
    }
    sections.extend(input.family.and_then(|family| family.tables(words)).map(Section::beyond));
    sections.extend(parameters::section(&input.parameters, words).map(Section::beyond));
    sections.push(made::section(&input.made, words).beyond());
    if input.family.is_some() {
        // Curves, errors and loops by setting are the report; a verdict on limits is one too.
        let kept = limits_id.as_deref();
        for section in sections.iter_mut().skip(first).filter(|section| Some(section.id.as_str()) != kept) {
            *section = section.clone().folded();
        }
    }
    sections
}

/// What was compared with what.
fn subtitle(input: &ReportInput<'_>) -> String {
    let text =
        input.words.fill(input.words.subtitle_validation, &[("model", &input.model_file), ("data", &input.data)]);
    match &input.made.date {
        Some(date) => format!("{text} · {date}"),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::of_test::tests::{compared, record};
    use dashpot_identification::validation::validate;
    use dashpot_messages::Sentence;
    use dashpot_records::{Note, Record};
    use std::collections::BTreeSet;

    fn with_input<T>(records: &[Record], check: impl FnOnce(&ReportInput<'_>) -> T) -> T {
        let tests: Vec<_> = records.iter().map(compared).collect();
        let validation = validate(&tests).unwrap();
        check(&ReportInput {
            words: &words::EN,
            print: Print::Brief,
            made: Made { version: "9.9".into(), command: "dashpot validate <x>".into(), ..Made::default() },
            curve: vec![[-0.3, -800.0], [0.3, 900.0]],
            model_file: "front.toml".into(),
            data: "rig/front".into(),
            validation: &validation,
            tests: &tests,
            parameters: vec![],
            identification: vec![Block::Warning("mass was not identifiable".into())],
            extra: vec![Section::new("later", "Later", vec![Block::Paragraph("to come".into())])],
            family: None,
        })
    }

    fn records() -> Vec<Record> {
        let mut noted = record(3, true);
        noted.notes.push(Note { kind: "trimmed", text: Sentence::as_it_is("12 samples before the first cycle") });
        vec![noted, record(2, false), record(1, true)]
    }

    #[test]
    fn the_page_holds_every_section_and_asks_nobody() {
        let html = with_input(&records(), render);
        for expected in [
            "Damper model against",
            "front.toml",
            "dashpot 9.9",
            "mass was not identifiable",
            "to come",
            "12 samples before",
        ] {
            assert!(html.contains(expected), "{expected}");
        }
        // The only address allowed is the name of the SVG language.
        let addresses = html.matches("http").count();
        assert_eq!(addresses, html.matches("xmlns=\"http://www.w3.org/2000/svg\"").count());
        assert!(!html.contains(" src=") && !html.contains("@import") && !html.contains("url("));
        assert!(html.contains("50 mm &lt;5 Hz&gt;") && !html.contains("<5 Hz>"));
        assert!(!html.replace("isNaN", "").contains("NaN"));
    }

    #[test]
    fn links_inside_the_page_lead_somewhere_and_ids_are_unique() {
        let html = with_input(&records(), render);
        let after = |mark: &str| -> Vec<String> {
            html.split(mark).skip(1).map(|rest| rest.split('"').next().unwrap().to_owned()).collect()
        };
        let ids = after(" id=\"");
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len(), "{ids:?}");
        for link in after("href=\"#") {
            assert!(ids.contains(&link), "{link}");
        }
    }

    #[test]
    fn tags_are_balanced() {
        let html = with_input(&records(), render);
        for tag in ["section", "table", "thead", "tbody", "tr", "figure", "svg", "ul", "li", "p", "div", "h2", "h3"] {
            let open = html.matches(&format!("<{tag}>")).count() + html.matches(&format!("<{tag} ")).count();
            assert_eq!(open, html.matches(&format!("</{tag}>")).count(), "{tag}");
        }
    }

    #[test]
    fn the_same_input_gives_the_same_bytes() {
        assert_eq!(with_input(&records(), render), with_input(&records(), render));
    }

    #[test]
    fn a_picture_comes_before_any_table_and_the_worst_test_first() {
        with_input(&records(), |input| {
            let html = render(input);
            let body = &html[html.find("<main>").unwrap()..];
            assert!(body.find("<svg").unwrap() < body.find("<table").unwrap());
            let worst = summary::worst(input.validation).unwrap() + 1;
            let first = body.split("class=\"choice\" id=\"").nth(1).unwrap().split('"').next().unwrap();
            assert_eq!(first, format!("test-{worst}"));
        });
    }

    #[test]
    fn a_report_is_written_in_every_language() {
        for (code, language) in words::Language::ALL {
            let html =
                with_input(&records(), |input| render(&ReportInput { words: language.words(), ..input.clone() }));
            assert!(html.contains(&format!("<html lang=\"{code}\">")) && html.contains(language.words().axis_force));
            // Nothing of another language slips in where a text exists.
            if language != words::Language::English {
                for english in
                    [words::EN.axis_velocity, words::EN.fv_caption, words::EN.tests_caption, words::EN.key_section]
                {
                    assert!(!html.contains(english), "{code}: {english}");
                }
            }
            assert!(!html.contains('{') || !html.contains("{error}"), "{code}: a figure was not put in");
        }
    }

    #[test]
    fn report_and_figures_are_written_side_by_side_without_leftovers() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("report.html");
        with_input(&records(), |input| {
            write_atomic(input, &path).unwrap();
            write_atomic(input, &path).unwrap();
            assert_eq!(std::fs::read_to_string(&path).unwrap(), render(input));
            let figures = svgs(input, &folder.path().join("figures")).unwrap();
            let distinct: BTreeSet<_> = figures.iter().collect();
            assert_eq!(distinct.len(), figures.len());
            let svgs_inside = render(input).matches("<svg xmlns").count();
            assert_eq!(figures.len(), svgs_inside);
        });
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
    }

    #[test]
    fn a_missing_folder_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("nowhere").join("report.html");
        let error = with_input(&records(), |input| write_atomic(input, &path)).unwrap_err();
        assert!(format!("{error:#}").contains("nowhere"));
    }
}
