//! Tests that code uses every message to the user that the lists of messages declare.
//!
//! The tests of `report` and `gui` check that each message has a text in every language. They also check that no file
//! of a language contains another text.

use dashpot_tests::library::root;
use std::collections::BTreeSet;
use std::path::Path;

/// Lists of messages: file, crates whose code uses the messages, and the text before a message's name in that code.
const LISTS: [(&str, &[&str], &str); 6] = [
    ("src/records/src/messages/phrases.rs", &["records"], "phrases::"),
    ("src/identification/src/phrases.rs", &["identification"], "phrases::"),
    ("src/diagnosis/src/phrases.rs", &["diagnosis"], "phrases::"),
    ("src/dimensions/src/phrases.rs", &["dimensions"], "phrases::"),
    ("src/report/src/words/texts.rs", &["report", "gui", "cli", "python"], "."),
    ("src/gui/src/words/mod.rs", &["gui"], "."),
];

/// Returns the names of the messages that a list declares: in `phrases!` the names before a text, in `interface!` those
/// after the semicolon.
fn declared(list: &str) -> BTreeSet<&str> {
    let is_name = |name: &&str| !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let phrases = list.lines().filter_map(|line| line.strip_prefix("    ")?.split_once(": \"").map(|(name, _)| name));
    let fields = list.split_once("\n        ;\n").map_or("", |(_, fields)| fields);
    let fields = fields.lines().take_while(|line| line.starts_with("        "));
    phrases.chain(fields.filter_map(|line| line.trim().split(['(', ',']).next())).filter(is_name).collect()
}

/// Returns the names of messages that follow the text `before` in code.
fn named<'c>(code: &'c str, before: &str) -> BTreeSet<&'c str> {
    let end = |rest: &str| rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
    code.split(before).skip(1).map(|rest| &rest[..end(rest)]).collect()
}

fn sources(folder: &Path, except: &Path) -> String {
    let mut all = String::new();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            all += &sources(&path, except);
        } else if path.extension().is_some_and(|extension| extension == "rs") && path != except {
            all += &std::fs::read_to_string(&path).expect("a text");
        }
    }
    all
}

#[test]
fn every_message_is_used() {
    for (list, crates, before) in LISTS {
        let file = root().join(list);
        let text = std::fs::read_to_string(&file).expect(list);
        // The part of the list's file before `interface!` is code, too, and may use messages.
        let own = text.split("interface! {").next().filter(|_| before == ".").unwrap_or("");
        let code = crates.iter().map(|name| sources(&root().join(format!("src/{name}/src")), &file));
        let code = code.collect::<String>() + own;
        let (declared, named) = (declared(&text), named(&code, before));
        assert!(declared.len() > 20, "{list}: {declared:?}");
        let unused: Vec<&str> = declared.difference(&named).copied().collect();
        assert!(unused.is_empty(), "{list}: no code uses {unused:?}");
    }
}

#[test]
fn names_are_found_in_lists_and_in_code() {
    let phrases = "phrases! {\n    \"x-\";\n    // Lists.\n    COMMA: \", \";\n    NOTHING: \"no {test}\";\n}\n";
    assert_eq!(declared(phrases), BTreeSet::from(["COMMA", "NOTHING"]));
    let interface = "    struct Words {\n        code: u8,\n        ;\n        // Tables.\n        fit,\n        fill(a b),\n    }\n";
    assert_eq!(declared(interface), BTreeSet::from(["fill", "fit"]));
    assert!(named("w.fit(w.fill, x)", ".").is_superset(&BTreeSet::from(["fill", "fit"])));
}
