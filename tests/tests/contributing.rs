//! The instructions in CONTRIBUTING.md are valid: the files exist, and the quoted lines are in them.

use dashpot_tests::library::root;

fn page() -> String {
    std::fs::read_to_string(root().join("CONTRIBUTING.md")).expect("CONTRIBUTING.md")
}

/// Returns texts between single backticks outside of code blocks.
fn quoted(page: &str) -> Vec<String> {
    let prose: Vec<&str> = page.split("```").step_by(2).collect();
    prose.iter().flat_map(|part| part.split('`').skip(1).step_by(2)).map(str::to_owned).collect()
}

#[test]
fn every_file_named_exists() {
    let names = quoted(&page());
    let paths: Vec<&String> = names.iter().filter(|name| name.contains('/') && !name.contains(' ')).collect();
    assert!(paths.len() > 20, "{names:?}");
    let missing: Vec<_> = paths.iter().filter(|path| !root().join(path).exists()).collect();
    assert!(missing.is_empty(), "CONTRIBUTING.md names what is not there: {missing:?}");
}

#[test]
fn every_quoted_line_stands_in_its_file_and_in_this_order() {
    let page = page();
    let mut blocks = 0;
    for block in page.split("```").skip(1).step_by(2) {
        let mut lines = block.lines().skip(1).map(str::trim).filter(|line| !line.is_empty());
        let path = lines.next().and_then(|line| line.strip_prefix("// in ")).expect("a block begins with its file");
        let source = std::fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
        let mut rest = source.lines().map(str::trim);
        for line in lines {
            assert!(rest.any(|found| found == line), "{path} has no such line, or not in this order: {line}");
        }
        blocks += 1;
    }
    assert!(blocks > 8, "{blocks} blocks");
}
