//! Building blocks of a report: sections of paragraphs, tables and figures, without markup.
//!
//! All texts are plain text. The renderer of the page escapes them for HTML.

use crate::cells::Cell;
use dashpot_identification::limits::Overall;

/// A titled part of the report.
#[derive(Debug, Clone)]
pub struct Section {
    /// HTML anchor, unique in the page: letters, digits and hyphens.
    pub id: String,
    /// Heading.
    pub title: String,
    /// Contents in reading order.
    pub blocks: Vec<Block>,
    /// Alternative parts, such as the single tests. The reader selects one at a time. Most sections have none.
    pub choices: Vec<Section>,
    /// Whether the brief print omits the section and only the complete print includes it.
    pub beyond: bool,
    /// Whether the section is collapsed until the reader clicks its title.
    pub folded: bool,
}

/// One piece of a section.
#[derive(Debug, Clone)]
pub enum Block {
    /// Main sentences of a section, in a larger font.
    Lead(String),
    /// Verdict on limits, and the sentence that explains it.
    Verdict(Overall, String),
    /// A heading inside the section.
    Heading(String),
    /// Plain text.
    Paragraph(String),
    /// A warning about the reliability of the results.
    Warning(String),
    /// A list of remarks.
    List(Vec<String>),
    /// A table.
    Table(Table),
    /// A table that is collapsed until the reader clicks its title.
    Folded(String, Table),
    /// Figures side by side, as many as fit into the width of the page.
    Figures(Vec<Figure>),
    /// One figure at its own width.
    Wide(Figure),
}

/// A figure.
#[derive(Debug, Clone)]
pub struct Figure {
    /// File name without extension, unique in the report.
    pub file: String,
    /// The drawing, a complete SVG document.
    pub svg: String,
    /// Text below the drawing; may be empty.
    pub caption: String,
}

/// A table.
#[derive(Debug, Clone)]
pub struct Table {
    /// What the numbers of the table mean, and how they are calculated.
    pub caption: String,
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows, each as long as `columns`.
    pub rows: Vec<Vec<Cell>>,
    /// Whether a click on a heading sorts the rows.
    pub sortable: bool,
}

/// A column of a table.
#[derive(Debug, Clone)]
pub struct Column {
    /// Heading that neighboring columns of one group share; empty without a group.
    pub group: &'static str,
    /// Heading with unit.
    pub heading: &'static str,
    /// Whether the cells are numbers, which are aligned right.
    pub figures: bool,
    /// Whether the cells are sentences, which may wrap.
    pub wraps: bool,
}

impl Section {
    /// Creates a section without alternative parts.
    pub fn new(id: impl Into<String>, title: impl Into<String>, blocks: Vec<Block>) -> Self {
        Self { id: id.into(), title: title.into(), blocks, choices: Vec::new(), beyond: false, folded: false }
    }

    /// Excludes the section from the brief print.
    pub fn beyond(self) -> Self {
        Self { beyond: true, ..self }
    }

    /// Collapses the section and excludes it from the brief print.
    pub fn folded(self) -> Self {
        Self { folded: true, ..self.beyond() }
    }

    /// Iterates over the section and its alternative parts in reading order.
    pub fn parts(&self) -> impl Iterator<Item = &Section> {
        std::iter::once(self).chain(&self.choices)
    }

    /// Returns all figures in reading order.
    pub fn figures(&self) -> Vec<&Figure> {
        let mut figures: Vec<&Figure> = Vec::new();
        for block in &self.blocks {
            match block {
                Block::Figures(some) => figures.extend(some),
                Block::Wide(one) => figures.push(one),
                _ => {}
            }
        }
        figures.extend(self.choices.iter().flat_map(Section::figures));
        figures
    }
}

impl Figure {
    /// Creates a figure without caption.
    pub fn new(file: impl Into<String>, svg: String) -> Self {
        Self { file: file.into(), svg, caption: String::new() }
    }

    /// Adds a caption to the figure.
    pub fn saying(self, caption: impl Into<String>) -> Self {
        Self { caption: caption.into(), ..self }
    }
}

impl Column {
    /// Creates a column of words.
    pub fn words(heading: &'static str) -> Self {
        Self { group: "", heading, figures: false, wraps: false }
    }

    /// Creates a column of numbers.
    pub fn figures(heading: &'static str) -> Self {
        Self { group: "", heading, figures: true, wraps: false }
    }

    /// Creates a column of sentences.
    pub fn sentences(heading: &'static str) -> Self {
        Self { wraps: true, ..Self::words(heading) }
    }

    /// Puts the column under a group heading.
    pub fn in_group(self, group: &'static str) -> Self {
        Self { group, ..self }
    }
}
