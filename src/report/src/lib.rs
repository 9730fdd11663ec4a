//! The validation report: one self-contained HTML file that opens without a network and prints.
//!
//! [`diagnosis`] writes the report of `dashpot diagnose` with the same blocks.
//!
//! A report is a list of [`Section`]s made of a few kinds of [`Block`]. Every section builder lives in its own file
//! and knows nothing of HTML; [`page`] knows HTML and nothing of dampers. A further section (before/after pictures, a
//! diagnosis) is a [`Section`] put into [`ReportInput::extra`]; its figures are written by [`svgs`] too.
//!
//! The same input gives the same bytes: no date, no random name, no machine.

pub mod against;
pub mod blocks;
pub mod diagnosis;
mod each_test;
mod errors;
mod hysteresis;
pub mod numbers;
mod page;
mod parameters;
pub mod plot;
mod summary;

pub use blocks::{Block, Section};
pub use dashpot_output::replace_file;
pub use parameters::ParameterRow;

use anyhow::Context as _;
use dashpot_identification::validation::{Compared, Validation};
use std::path::{Path, PathBuf};

/// Everything a report tells.
#[derive(Debug, Clone)]
pub struct ReportInput<'a> {
    /// Title of the report.
    pub title: String,
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
    /// What `low` and `high` of a parameter mean (bounds, confidence interval), one sentence.
    pub parameter_range: String,
    /// How the model was identified: [`Block::Paragraph`], [`Block::Warning`], tables; left out when empty.
    pub identification: Vec<Block>,
    /// Further sections, placed before the single tests.
    pub extra: Vec<Section>,
}

/// The report as one HTML document.
pub fn render(input: &ReportInput<'_>) -> String {
    page::page(&input.title, &subtitle(input), &sections(input))
}

/// A report of other sections, in the same format.
pub fn render_sections(title: &str, subtitle: &str, sections: &[Section]) -> String {
    page::page(title, subtitle, sections)
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

/// All sections in reading order: the answer first, the evidence after it.
fn sections(input: &ReportInput<'_>) -> Vec<Section> {
    let mut sections = vec![summary::section(input.validation), errors::section(input.validation)];
    sections.extend(hysteresis::section(input.validation));
    if !input.identification.is_empty() {
        sections.push(Section::new("identification", "Identification", input.identification.clone()));
    }
    sections.extend(parameters::section(&input.parameters, &input.parameter_range));
    sections.extend(input.extra.iter().cloned());
    sections.push(errors::tests(input.validation));
    sections.push(each_test::section(input.validation, input.tests));
    sections
}

/// What was compared with what.
fn subtitle(input: &ReportInput<'_>) -> String {
    format!("Model {} against the rig data in {}", input.model_file, input.data)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::of_test::tests::{compared, record};
    use dashpot_identification::validation::validate;
    use dashpot_records::{Note, Record};
    use std::collections::BTreeSet;

    fn with_input<T>(records: &[Record], check: impl FnOnce(&ReportInput<'_>) -> T) -> T {
        let tests: Vec<_> = records.iter().map(compared).collect();
        let validation = validate(&tests).unwrap();
        check(&ReportInput {
            title: "Front damper".into(),
            model_file: "front.toml".into(),
            data: "rig/front".into(),
            validation: &validation,
            tests: &tests,
            parameters: vec![],
            parameter_range: String::new(),
            identification: vec![Block::Warning("mass was not identifiable".into())],
            extra: vec![Section::new("later", "Later", vec![Block::Paragraph("to come".into())])],
        })
    }

    fn records() -> Vec<Record> {
        let mut noted = record(3, true);
        noted.notes.push(Note { kind: "trimmed", text: "12 samples before the first cycle".into() });
        vec![noted, record(2, false), record(1, true)]
    }

    #[test]
    fn the_page_holds_every_section_and_asks_nobody() {
        let html = with_input(&records(), render);
        for expected in ["Front damper", "front.toml", "mass was not identifiable", "to come", "12 samples before"] {
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
            let svgs_inside = render(input).matches("<svg").count();
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
