//! Rendering of sections as one HTML page: all markup, style and script of the report.

use super::blocks::{Block, Column, Figure, Section, Table};
use super::cells::{Cell, Value};
use crate::plot::palette;
use crate::plot::svg::escape;
use crate::words::Words;
use dashpot_identification::limits::Overall;
use dashpot_output::GENERATOR;
use std::fmt::Write as _;

/// Extent of the printed page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Print {
    /// The result and its evidence on two pages, without the sections that have `beyond` set.
    #[default]
    Brief,
    /// All sections.
    Whole,
    /// One page with all contents except the list of files.
    Certificate,
}

/// CSS rule of collapsed sections. Only a page with such a section includes it.
const FOLDED_CSS: &str =
    "details.folded > summary > h2 { display: inline-block; margin: 12px 0; border: 0; color: var(--link); }\n";

/// Renders the whole HTML document.
pub fn page(title: &str, subtitle: &str, sections: &[Section], words: &Words, print: Print) -> String {
    let mut html = String::new();
    let title = escape(title);
    let _ = write!(
        html,
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n{GENERATOR}\n<title>{title}</title>\n\
         <style>\n{}{}{}</style>\n</head>\n<body{}{}>\n<header>\n<h1>{title}</h1>\n<p class=\"subtitle\">{}</p>\n<nav>",
        words.code,
        include_str!("page.css"),
        palette::page_css(),
        if sections.iter().any(|part| part.folded) { FOLDED_CSS } else { "" },
        match print {
            Print::Brief => "",
            Print::Whole => " class=\"whole\"",
            Print::Certificate => " class=\"whole certificate\"",
        },
        texts_of_script(words),
        escape(subtitle),
    );
    for part in sections {
        let _ = write!(html, "<a href=\"#{}\">{}</a> ", escape(&part.id), escape(&part.title));
    }
    let _ = write!(html, "</nav>\n<p class=\"help\">{}</p>\n</header>\n<main>\n", escape(words.figure_help));
    for part in sections {
        section(&mut html, part, (words, print));
    }
    if print == Print::Brief {
        let _ = writeln!(html, "<p class=\"brief\">{}</p>", escape(words.printed_brief));
    }
    let unfolds = if sections.iter().any(|part| part.folded) { include_str!("unfold.js") } else { "" };
    let _ = write!(html, "</main>\n<script>\n{}{unfolds}</script>\n</body>\n</html>\n", include_str!("page.js"));
    html
}

/// Formats the labels of the buttons that the page's script creates as `data-` attributes of the HTML `body`.
fn texts_of_script(words: &Words) -> String {
    let texts = [
        ("all", words.all_tests_shown),
        ("previous", words.previous),
        ("next", words.next),
        ("shown", words.test_shown),
        ("reset", words.zoom_reset),
        ("save", words.save_table),
        ("about", words.save_about),
        ("decimal", words.decimal_sign),
    ];
    texts.iter().map(|(name, text)| format!(" data-{name}=\"{}\"", escape(text))).collect()
}

fn section(html: &mut String, section: &Section, (words, print): (&Words, Print)) {
    let class = if section.beyond { " class=\"beyond\"" } else { "" };
    let (id, title) = (escape(&section.id), escape(&section.title));
    if section.folded {
        // A printed section cannot be expanded, so the complete print expands all sections.
        let open = if print == Print::Whole { " open" } else { "" };
        let _ = writeln!(
            html,
            "<section id=\"{id}\"{class}>\n<details class=\"folded\"{open}><summary><h2>{title}</h2></summary>"
        );
    } else {
        let _ = writeln!(html, "<section id=\"{id}\"{class}>\n<h2>{title}</h2>");
    }
    section.blocks.iter().for_each(|part| block(html, part, words));
    if !section.choices.is_empty() {
        html.push_str("<div class=\"choices\">\n");
        for choice in &section.choices {
            let _ = writeln!(
                html,
                "<section class=\"choice\" id=\"{}\">\n<h3>{}</h3>",
                escape(&choice.id),
                escape(&choice.title)
            );
            choice.blocks.iter().for_each(|part| block(html, part, words));
            html.push_str("</section>\n");
        }
        html.push_str("</div>\n");
    }
    html.push_str(if section.folded { "</details>\n</section>\n" } else { "</section>\n" });
}

fn block(html: &mut String, block: &Block, words: &Words) {
    let _ = match block {
        Block::Lead(text) => writeln!(html, "<p class=\"lead\">{}</p>", escape(text)),
        Block::Verdict(overall, text) => {
            let class = match overall {
                Overall::Pass => "pass",
                Overall::Fail => "fail",
                Overall::Incomplete => "incomplete",
            };
            writeln!(html, "<p class=\"lead verdict {class}\">{}</p>", escape(text))
        }
        Block::Heading(text) => writeln!(html, "<h3>{}</h3>", escape(text)),
        Block::Paragraph(text) => writeln!(html, "<p>{}</p>", escape(text)),
        Block::Warning(text) => {
            writeln!(html, "<p class=\"warning\"><strong>{}</strong> {}</p>", escape(words.note), escape(text))
        }
        Block::List(items) => {
            let items: String = items.iter().map(|item| format!("<li>{}</li>", escape(item))).collect();
            writeln!(html, "<ul>{items}</ul>")
        }
        Block::Table(part) => {
            table(html, part, words);
            Ok(())
        }
        Block::Folded(title, part) => {
            let _ = writeln!(html, "<details><summary>{} ({})</summary>", escape(title), part.rows.len());
            table(html, part, words);
            writeln!(html, "</details>")
        }
        Block::Figures(figures) => {
            html.push_str("<div class=\"figures\">\n");
            figures.iter().for_each(|part| figure(html, part, ""));
            writeln!(html, "</div>")
        }
        Block::Wide(part) => {
            figure(html, part, " class=\"wide\"");
            Ok(())
        }
    };
}

fn figure(html: &mut String, figure: &Figure, class: &str) {
    let _ = write!(html, "<figure{class}>{}", figure.svg);
    if !figure.caption.is_empty() {
        let _ = write!(html, "<figcaption>{}</figcaption>", escape(&figure.caption));
    }
    html.push_str("</figure>\n");
}

fn table(html: &mut String, table: &Table, words: &Words) {
    let class = if table.sortable { " class=\"sortable\"" } else { "" };
    if !table.caption.is_empty() {
        // A <caption> element would be as wide as the table and scroll with it. Therefore, the caption is a paragraph.
        let sorts = if table.sortable {
            format!(" <span class=\"sorts\">{}</span>", escape(words.sort_help))
        } else {
            String::new()
        };
        let _ = writeln!(html, "<p class=\"caption\">{}{sorts}</p>", escape(&table.caption));
    }
    let _ = write!(html, "<div class=\"table\">\n<table{class}>\n");
    html.push_str("<thead>\n");
    groups(html, &table.columns);
    html.push_str("<tr class=\"headings\">");
    for (i, column) in table.columns.iter().enumerate() {
        let _ = write!(html, "<th{}>{}</th>", class_of(&table.columns, i), escape(column.heading));
    }
    html.push_str("</tr>\n</thead>\n<tbody>\n");
    for row in &table.rows {
        html.push_str("<tr>");
        for (i, cell) in row.iter().enumerate() {
            let _ = write!(html, "<td{}>{}</td>", class_of(&table.columns, i), escape(&cell_text(cell, words)));
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n</table>\n</div>\n");
}

/// Returns the text of a cell, with numbers in the format of the page's language.
fn cell_text(cell: &Cell, words: &Words) -> String {
    if cell.value == Value::Words { cell.text.clone() } else { words.number(&cell.text) }
}

/// Writes the row of group headings if any column has a group.
fn groups(html: &mut String, columns: &[Column]) {
    if columns.iter().all(|column| column.group.is_empty()) {
        return;
    }
    html.push_str("<tr>");
    for group in columns.chunk_by(|a, b| a.group == b.group) {
        let (name, span) = (group[0].group, group.len());
        let class = if name.is_empty() { "" } else { " class=\"group\"" };
        let _ = write!(html, "<th{class} colspan=\"{span}\">{}</th>", escape(name));
    }
    html.push_str("</tr>\n");
}

/// Returns the CSS class attribute of a column. Numbers align right, and a line precedes the first column of a group.
fn class_of(columns: &[Column], index: usize) -> &'static str {
    let Some(column) = columns.get(index) else {
        return "";
    };
    let first = index > 0 && !column.group.is_empty() && columns[index - 1].group != column.group;
    match (column.figures, first) {
        (true, true) => " class=\"n first\"",
        (true, false) => " class=\"n\"",
        (false, true) => " class=\"first\"",
        (false, false) if column.wraps => " class=\"w\"",
        (false, false) => "",
    }
}
