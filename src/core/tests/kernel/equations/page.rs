//! Headings and constants of the book's page of equations (`equations.md`).

use super::exchange::Constant;
use std::path::{Path, PathBuf};

/// Returns the path of the book's page of equations.
pub fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/book/src/equations.md")
}

/// Reads the whole page of equations.
pub fn text() -> String {
    std::fs::read_to_string(path()).expect("the page of the equations")
}

/// Returns the part of the page under the heading that names an element, up to the next heading. Returns `None` if the
/// page has no such heading.
pub fn section<'a>(page: &'a str, element: &str) -> Option<&'a str> {
    let (_, rest) = page.split_once(&format!("\n### `{element}`\n"))?;
    Some(rest.split("\n#").next().unwrap_or(rest))
}

/// Returns section and name of each constant in the page's tables of constants.
pub fn constants(page: &str) -> Vec<Constant> {
    let (mut section, mut found) = ("", Vec::new());
    for line in page.lines() {
        if line.starts_with('#') {
            section = line.trim_start_matches('#').trim().trim_matches('`');
        }
        let name = line.strip_prefix("| `").and_then(|rest| rest.split_once("` | "));
        if let Some((name, _)) = name
            && name.bytes().all(|b| b.is_ascii_uppercase() || b == b'_')
        {
            found.push((section.to_owned(), name.to_owned()));
        }
    }
    found
}
