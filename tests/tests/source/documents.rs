//! Tests that the documents of the project are consistent.
//!
//! Every relative link leads to a file, and the book's table of contents lists every page. If mdBook is installed, the
//! book builds.

use dashpot_test_support::skipped;
use dashpot_tests::library::root;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Collects the Markdown pages below a folder.
fn pages(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())) {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            pages(&path, found);
        } else if path.extension().is_some_and(|e| e == "md") {
            found.push(path);
        }
    }
}

/// Returns the targets of links and pictures on a Markdown page, outside of code.
fn links(text: &str) -> Vec<String> {
    let prose: String = text.split("```").step_by(2).collect();
    let prose: String = prose.split('`').step_by(2).collect::<Vec<_>>().join("``");
    prose.split("](").skip(1).filter_map(|rest| Some(rest.split_once(')')?.0.to_owned())).collect()
}

/// Returns the anchors of the headings of a Markdown page, which are possible targets of links.
fn anchors(text: &str) -> Vec<String> {
    let prose: String = text.split("```").step_by(2).collect();
    let headings = prose
        .lines()
        .filter_map(|line| line.strip_prefix('#'))
        .map(|line| line.trim_start_matches('#').trim().to_lowercase());
    let kept = |c: &char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_');
    headings.map(|h| h.chars().filter(kept).map(|c| if c == ' ' { '-' } else { c }).collect()).collect()
}

#[test]
fn every_relative_link_leads_somewhere() {
    let mut all = Vec::new();
    for page in ["README", "ARCHITECTURE", "CONTRIBUTING", "CHANGELOG", "VERSIONING", "SECURITY"] {
        all.push(root().join(format!("{page}.md")));
    }
    for folder in ["docs", "dist", "examples", "vi-crt-bridge", "adams-usersub"] {
        pages(&root().join(folder), &mut all);
    }
    let (mut followed, mut broken) = (0, Vec::new());
    for page in &all {
        let text = std::fs::read_to_string(page).unwrap_or_else(|e| panic!("{}: {e}", page.display()));
        for link in links(&text) {
            if link.contains("://") || link.starts_with("mailto:") {
                continue;
            }
            let (file, anchor) = link.split_once('#').unwrap_or((&link, ""));
            let target = if file.is_empty() { page.clone() } else { page.parent().expect("a folder").join(file) };
            followed += 1;
            let leads = match std::fs::read_to_string(&target) {
                Ok(text) if !anchor.is_empty() => anchors(&text).iter().any(|a| a == anchor),
                _ => target.exists(),
            };
            if !leads {
                broken.push(format!("{}: {link}", page.strip_prefix(root()).unwrap_or(page).display()));
            }
        }
    }
    assert!(followed > 40, "{followed}");
    assert!(broken.is_empty(), "links that lead nowhere:\n{}", broken.join("\n"));
}

/// Checks that the table of contents lists every page, and that relative links stay inside the book. Links must not
/// leave the book, because readers have the book without the surrounding folders.
#[test]
fn the_book_lists_its_pages_and_keeps_to_itself() {
    let source = root().join("docs/book/src");
    let list = std::fs::read_to_string(source.join("SUMMARY.md")).expect("the list of pages");
    let mut all = Vec::new();
    pages(&source, &mut all);
    assert!(all.len() > 8);
    for page in all.iter().filter(|p| p.file_name().is_some_and(|n| n != "SUMMARY.md")) {
        let name = page.file_name().expect("a name").to_string_lossy();
        assert!(list.contains(&format!("({name})")), "SUMMARY.md does not list {name}");
        for link in links(&std::fs::read_to_string(page).unwrap()) {
            assert!(!link.starts_with("../"), "{name}: {link} leads out of the book");
        }
    }
}

#[test]
fn the_book_builds() {
    let folder = tempfile::tempdir().unwrap();
    let mut build = Command::new("mdbook");
    build.arg("build").arg(root().join("docs/book")).arg("--dest-dir").arg(folder.path());
    match build.output() {
        Err(_) => skipped("no mdbook (cargo install mdbook --no-default-features)"),
        Ok(out) => {
            let told = String::from_utf8_lossy(&out.stderr);
            assert!(out.status.success() && !told.contains("[ERROR]") && !told.contains("[WARN]"), "{told}");
            let model = std::fs::read_to_string(folder.path().join("model.html")).expect("the page of the model");
            assert!(
                model.contains("figures/element-free_play.svg")
                    && folder.path().join("figures/element-free_play.svg").is_file()
            );
            // mdBook must have inserted the files from outside the book that pages include.
            let parameters =
                std::fs::read_to_string(folder.path().join("parameters.html")).expect("the page of parameters");
            assert!(parameters.contains("free_play_gap") && !parameters.contains("{{#"));
        }
    }
}
