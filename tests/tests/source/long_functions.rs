//! Tests that no function of the source code is longer than [`LONGEST`] lines, so that a reader can survey it. If a
//! function is longer for a reason, a line `// Long: reason` directly above its signature, attributes or doc comment
//! must state this reason.
//!
//! Unit tests do not count. The length of a function is the number of lines from its signature to its closing brace.

use dashpot_test_support::rust_files;
use dashpot_tests::library::root;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// Longest function, lines.
const LONGEST: usize = 100;
/// Begin of the line that states why a function is long.
const REASON: &str = "// Long: ";

/// Function of a source file.
struct Function {
    name: String,
    /// Number of the function's first line in the file, from 1. This is the first line of the doc comment, an attribute
    /// or the signature.
    begin: usize,
    /// Number of the line with the signature, from 1.
    line: usize,
    /// Lines from the signature to the closing brace.
    lines: usize,
}

/// Visitor that collects the functions of a file, without those of its unit tests.
#[derive(Default)]
struct Reader(Vec<Function>);

fn is_of_tests(attributes: &[syn::Attribute]) -> bool {
    let is_test = |a: &syn::Attribute| a.meta.require_list().is_ok_and(|list| list.tokens.to_string() == "test");
    attributes.iter().any(|a| a.path().is_ident("cfg") && is_test(a) || a.path().is_ident("test"))
}

impl Reader {
    fn add(&mut self, attributes: &[syn::Attribute], signature: &syn::Signature, body: &syn::Block) {
        let line = signature.span().start().line;
        let begin = attributes.iter().map(|a| a.span().start().line).min().unwrap_or(line).min(line);
        let lines = body.span().end().line - line + 1;
        self.0.push(Function { name: signature.ident.to_string(), begin, line, lines });
    }
}

impl<'ast> Visit<'ast> for Reader {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_of_tests(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_impl(&mut self, item: &'ast syn::ItemImpl) {
        if !is_of_tests(&item.attrs) {
            visit::visit_item_impl(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        if !is_of_tests(&item.attrs) {
            self.add(&item.attrs, &item.sig, &item.block);
            visit::visit_item_fn(self, item);
        }
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if !is_of_tests(&item.attrs) {
            self.add(&item.attrs, &item.sig, &item.block);
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        if let Some(body) = &item.default {
            self.add(&item.attrs, &item.sig, body);
        }
        visit::visit_trait_item_fn(self, item);
    }
}

/// Returns the violations in a file, and the number of its functions.
fn violations(file: &str, text: &str) -> (Vec<String>, usize) {
    let mut reader = Reader::default();
    reader.visit_file(&syn::parse_file(text).unwrap_or_else(|error| panic!("{file}: {error}")));
    let lines: Vec<&str> = text.lines().collect();
    let mut found = Vec::new();
    for Function { name, begin, line, lines: length } in &reader.0 {
        // The parser omits ordinary comments, so the line with the reason may be above `begin`.
        let above = lines[..begin - 1].iter().rev().take_while(|text| text.trim().starts_with("//"));
        let within = &lines[begin - 1..line - 1];
        let reason = above.chain(within).find_map(|text| text.trim().strip_prefix(REASON.trim_end()));
        match reason.map(str::trim) {
            None if *length > LONGEST => found.push(format!("{file}:{line}: `{name}` has {length} lines")),
            Some("") => found.push(format!("{file}:{line}: `{name}` states no reason after `{REASON}`")),
            Some(_) if *length <= LONGEST => {
                found.push(format!("{file}:{line}: `{name}` states why it is long, but has {length} lines only"));
            }
            _ => {}
        }
    }
    (found, reader.0.len())
}

#[test]
fn no_function_is_longer_than_a_hundred_lines() {
    let (mut wrong, mut seen) = (Vec::new(), 0);
    for file in rust_files(&root().join("src")).unwrap() {
        let name = file.strip_prefix(root()).unwrap().display().to_string().replace('\\', "/");
        if name.contains("/tests/") || name.contains("/ui_tests/") {
            continue;
        }
        let (found, count) = violations(&name, &std::fs::read_to_string(&file).unwrap());
        wrong.extend(found);
        seen += count;
    }
    assert!(seen > 3000, "only {seen} functions were seen");
    assert!(
        wrong.is_empty(),
        "split these functions into parts that are named by what they compute:\n{}",
        wrong.join("\n")
    );
}

#[test]
fn a_long_function_is_found() {
    let long = |head: &str, lines: usize| format!("{head} {{\n{}}}\n", "    f();\n".repeat(lines - 2));
    let count = |text: &str| violations("file", text).0.len();
    assert_eq!(count(&long("fn a()", LONGEST)), 0);
    assert_eq!(count(&long("fn a()", LONGEST + 1)), 1);
    assert_eq!(count(&format!("impl A {{ {} }}", long("/// Text.\nfn a(&self)", LONGEST + 1))), 1);
    assert_eq!(count(&format!("trait A {{ {} }}", long("fn a(&self)", LONGEST + 1))), 1);
    assert_eq!(count(&format!("fn b() {{ {} }}", long("fn a()", LONGEST + 1))), 2);
    assert_eq!(count(&format!("#[cfg(test)] mod tests {{ {} }}", long("fn a()", LONGEST + 1))), 0);
    assert_eq!(count(&long("// Long: measured.\n/// Text.\n#[inline]\nfn a()", LONGEST + 1)), 0);
    assert_eq!(count(&long("/// Text.\n// Long: measured.\n#[inline]\nfn a()", LONGEST + 1)), 0);
    assert_eq!(count(&long("// Long:\nfn a()", LONGEST + 1)), 1);
    assert_eq!(count(&long("// Long: no more.\nfn a()", LONGEST)), 1);
    assert_eq!(count(&format!("// Long: of b.\n{}{}", long("fn b()", LONGEST + 1), long("fn a()", LONGEST + 1))), 1);
}
