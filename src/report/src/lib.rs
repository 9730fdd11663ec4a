//! The validation report: one self-contained HTML file that needs no network and can be printed.
//!
//! [`diagnosis`] writes the report of `dashpot diagnose` with the same kinds of [`Block`].
//!
//! A report is a list of [`Section`]s with a few kinds of [`Block`]. Every section builder has its own file and does not contain HTML.
//! [`page`] writes the HTML and does not depend on dampers. [`ReportInput::extra`] adds further sections, such as before/after pictures or
//! a diagnosis. [`svgs`] writes the figures of all sections.
//!
//! Equal input gives equal bytes: the report contains no clock time, no random name and no machine name. All text is in
//! [`words`], one file per language.

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

/// Contents of a validation report.
#[derive(Debug, Clone)]
pub struct ReportInput<'a> {
    /// Language of the report.
    pub words: &'static Words,
    /// Extent of the printed report.
    pub print: Print,
    /// Origin of the report.
    pub made: Made,
    /// Points of the model's FV curve: constant velocity, m/s, and force, N.
    pub curve: Vec<[f64; 2]>,
    /// Name of the validated model file.
    pub model_file: String,
    /// Name of the data folder or file.
    pub data: String,
    /// Results of the comparison of model and records.
    pub validation: &'a Validation,
    /// Records with the computed forces, in the order of `validation.tests`. They supply the plots and cleaning notes.
    pub tests: &'a [Compared<'a>],
    /// Parameters of the model. Without parameters, the report omits the section.
    pub parameters: Vec<ParameterRow>,
    /// Description of the identification as paragraphs, warnings and tables. The report omits an empty description.
    pub identification: Vec<Block>,
    /// Further sections, placed after the tables of errors and hysteresis.
    pub extra: Vec<Section>,
    /// The adjustable damper, whose curves come first, or `None` for an ordinary damper.
    pub family: Option<FamilyReport<'a>>,
}

impl<'a> ReportInput<'a> {
    /// Collects the complete report of a model file, its records and their comparison.
    ///
    /// # Errors
    /// The simulation cannot compute time steps with the model's parameters.
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

/// Returns the tables of the report as a workbook.
pub fn workbook<'a>(input: &ReportInput<'a>) -> Workbook<'a> {
    Workbook {
        title: input.words.title_validation.to_owned(),
        subtitle: subtitle(input),
        sections: sections(input),
        made: input.made.clone(),
        words: input.words,
    }
}

/// Renders the report as one HTML document.
pub fn render(input: &ReportInput<'_>) -> String {
    page::page(input.words.title_validation, &subtitle(input), &sections(input), input.words, input.print)
}

/// Renders the given sections as one HTML document in the format of the validation report.
pub fn render_sections(title: &str, subtitle: &str, sections: &[Section], words: &Words) -> String {
    page::page(title, subtitle, sections, words, Print::Whole)
}

/// Writes the report. An older report is replaced only when the new report is complete.
///
/// # Errors
/// The folder does not exist or is not writable. The older report then stays.
pub fn write_atomic(input: &ReportInput<'_>, path: &Path) -> anyhow::Result<()> {
    write_page(&render(input), path)
}

fn write_page(page: &str, path: &Path) -> anyhow::Result<()> {
    replace_file(path, page.as_bytes()).with_context(|| format!("writing the report {}", path.display()))
}

/// Writes every figure of the report as a file into a folder, and creates the folder if it is missing.
///
/// Returns the paths in the order of the report.
///
/// # Errors
/// The folder or a file is not writable.
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

/// Returns all sections in reading order: the result, figures of the result, then every test and every table.
fn sections(input: &ReportInput<'_>) -> Vec<Section> {
    let (validation, words) = (input.validation, input.words);
    let mut sections = Vec::new();
    let limits = validation.limits.as_ref().map(|found| certificate::section(found, words));
    let limits_id = limits.as_ref().map(|section| section.id.clone());
    let mut answer = summary::section(validation, words);
    // The verdict on the limits comes first. The table of the limits follows later, because the separate certificate also contains it.
    if let Some(Block::Verdict(passed, text)) = limits.as_ref().and_then(|section| section.blocks.first()) {
        answer.blocks.insert(0, Block::Verdict(*passed, text.clone()));
    }
    answer.blocks.extend(input.family.into_iter().flat_map(|family| family.doubts(validation, words)));
    let family = input.family.map(|family| family.sections(validation, input.tests, words));
    sections.push(answer);
    let first = sections.len() + family.as_ref().map_or(0, Vec::len);
    sections.extend(family.into_iter().flatten());
    if let Some(svg) = peaks::force_at_peak(validation, &input.curve, words) {
        // For a family, a separate figure has a line for each setting.
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
        // For an adjustable damper, all sections are collapsed, except curves, errors and loops by setting, and the table of limits.
        let kept = limits_id.as_deref();
        for section in sections.iter_mut().skip(first).filter(|section| Some(section.id.as_str()) != kept) {
            *section = section.clone().folded();
        }
    }
    sections
}

/// Formats the names of the model and the data that were compared.
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
        // The only allowed address is the SVG namespace.
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
            // No text of another language may appear where a translation exists.
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
