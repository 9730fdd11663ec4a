//! Tests the documentation of the tuning constants, which are in one file per crate, `tuning.rs`. The documentation of
//! each constant must end with the name of a test that fails if the value changes, or with "none".

use dashpot_test_support::rust_files;
use dashpot_tests::library::root;
use std::collections::BTreeSet;
use std::path::Path;

/// Crates with a file `tuning.rs`, and the number of constants in this file that no test covers. The number may only
/// fall.
const UNNOTICED: &[(&str, usize)] = &[("records", 0)];

/// A constant with its documentation.
struct Entry {
    name: String,
    /// Lines of the documentation, trimmed.
    documentation: Vec<String>,
}

/// Collects the constants of a file, including those in its modules.
fn entries(items: &[syn::Item], found: &mut Vec<Entry>) {
    for item in items {
        match item {
            syn::Item::Mod(item) => entries(item.content.as_ref().map_or(&[], |(_, items)| items), found),
            syn::Item::Const(item) => {
                let line = |attribute: &syn::Attribute| match &attribute.meta {
                    syn::Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
                        syn::Expr::Lit(literal) => match &literal.lit {
                            syn::Lit::Str(text) => Some(text.value().trim().to_owned()),
                            _ => None,
                        },
                        _ => None,
                    },
                    _ => None,
                };
                let documentation = item.attrs.iter().filter_map(line).collect();
                found.push(Entry { name: item.ident.to_string(), documentation });
            }
            _ => {}
        }
    }
}

/// Returns the names of all functions in the Rust files of a crate.
fn functions(folder: &Path) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for file in rust_files(folder).unwrap() {
        let text = std::fs::read_to_string(&file).unwrap();
        for part in text.split("fn ").skip(1) {
            found.insert(part.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect());
        }
    }
    found
}

#[test]
fn every_number_has_a_reason_and_a_test_that_exists() {
    let mut wrong = String::new();
    for (part, allowed) in UNNOTICED {
        let folder = root().join("src").join(part);
        let text = std::fs::read_to_string(folder.join("src/tuning.rs")).unwrap();
        let mut found = Vec::new();
        entries(&syn::parse_file(&text).unwrap().items, &mut found);
        assert!(!found.is_empty(), "{part} has no numbers");
        let functions = functions(&folder);
        let mut unnoticed = 0;
        for Entry { name, documentation } in &found {
            let (last, reason) = documentation.split_last().map_or(("", &[][..]), |(last, rest)| (last.as_str(), rest));
            if reason.iter().all(String::is_empty) {
                wrong += &format!("{part}: {name} has no reason\n");
            }
            match last.strip_prefix("Test: ") {
                Some("none.") => unnoticed += 1,
                Some(test) if functions.contains(test.trim_matches(['`', '.'])) => {}
                Some(test) => wrong += &format!("{part}: {name} names {test}, which there is not\n"),
                None => wrong += &format!("{part}: {name} names no test\n"),
            }
        }
        if unnoticed != *allowed {
            wrong += &format!("{part}: {unnoticed} numbers that no test notices, stated {allowed}\n");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}
