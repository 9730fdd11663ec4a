//! Tests the rules of STYLE.md: standard terms in names and JSON keys, self-contained doc comments, short sentences in
//! all Markdown documents.
//!
//! The test covers a name if another module can use it: `pub`, `pub(crate)`, `pub(super)` and `pub(in ...)`.
//!
//! `ALLOWED` states the remaining violations by crate and document. A count may only fall. The test fails at a higher
//! count, and also at a lower count until the table contains the lower count.

use dashpot_tests::library::root;
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use syn::visit::{self, Visit};

/// Largest mean sentence length of a document, words.
const MEAN_WORDS: usize = 20;
/// Longest sentence of a document, words.
const LONGEST_SENTENCE: usize = 25;
/// Longest first sentence of a doc comment, words.
const LONGEST_SUMMARY: usize = 25;

const NAMES: &str = "names with words that STYLE.md replaces";
const KEYS: &str = "JSON keys with words that STYLE.md replaces";
const OPENINGS: &str = "doc comments that lean on another one";
const SUMMARIES: &str = "doc comments whose first sentence is over 25 words";
const SENTENCES: &str = "sentences over 25 words";
const SURPLUS: &str = "words above a mean of 20 a sentence";

/// Remaining violations: crate or document, rule, count.
///
/// The keys remain, because scripts depend on them: `share` twice, and the value `cannot_tell` of `verdict`.
const ALLOWED: &[(&str, &str, usize)] =
    &[("src/diagnosis", KEYS, 1), ("src/estimation", KEYS, 1), ("src/identification", KEYS, 1)];

/// Words of the left column of the glossary in STYLE.md, which names must not contain. The test splits a name into its
/// words. An entry with several words matches this sequence of words in a name.
const WORDS: &str = "
    slope slopes share shares
    answer answers answered answering
    refuse refuses refused refusal refusals
    told tell tells said
    leaves what_is_left
    place_of driven_end
    settled settle settles drawn drawn_to drawn_back
    memory recall recalls recalled remember remembers
    give gives given take_up give_way
    look looks looked
    held hold_at
    usual unusual strange strangeness implausibility price prices
    gone_through as_read
    bends bent unbent straight
    ground race races sieve rounds
    kept_in_bracket passed_over
    hide hides hidden nameless without_name unnamed_something
    larger smaller
    late early
    beside
    proving worked
    force_by force_by_x by_x by_v by_memory by_velocity by_displacement
    falls most_states
";
/// Words that must not be the whole name of a function or type.
const ALONE: &str = "of at told said given off beside tried looked held";

/// Returns the words of an identifier, in lower case.
fn words(name: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for part in name.split(|c: char| !c.is_alphanumeric()).filter(|part| !part.is_empty()) {
        let letters: Vec<char> = part.chars().collect();
        let mut word = String::new();
        for (i, letter) in letters.iter().enumerate() {
            let begins = letter.is_uppercase()
                && i > 0
                && (letters[i - 1].is_lowercase() || letters.get(i + 1).is_some_and(|next| next.is_lowercase()));
            if begins {
                found.push(std::mem::take(&mut word));
            }
            word.extend(letter.to_lowercase());
        }
        found.push(word);
    }
    found.retain(|word| !word.is_empty());
    found
}

/// Returns the entry of [`ALONE`] that equals the whole name of a function or a type, if any.
fn says_nothing(name: &str) -> Option<&'static str> {
    ALONE.split_whitespace().find(|entry| words(name) == [*entry])
}

/// Returns the entry of [`WORDS`] that a name contains, if any.
fn replaced(name: &str) -> Option<&'static str> {
    let words = words(name);
    let has = |entry: &&str| {
        let entry: Vec<&str> = entry.split('_').collect();
        words.windows(entry.len()).any(|window| window == entry)
    };
    WORDS.split_whitespace().find(has)
}

/// Splits a text into sentences, each with its number of words.
fn sentences(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let (mut length, mut sentence) = (0, String::new());
    let mut tokens = text.split_whitespace().peekable();
    while let Some(token) = tokens.next() {
        length += usize::from(token.chars().any(char::is_alphanumeric));
        sentence += token;
        sentence.push(' ');
        let closed = token.trim_end_matches([')', '"', '\u{201d}', '\'', '*', '_']);
        let ends = closed.ends_with(['.', '!', '?']) && !matches!(closed, "e.g." | "i.e." | "vs." | "cf.");
        let next_begins = tokens.peek().is_none_or(|next| {
            next.trim_start_matches(['(', '"', '\u{201c}', '*', '_']).starts_with(|c: char| !c.is_lowercase())
        });
        if ends && next_begins && length > 0 {
            found.push((length, std::mem::take(&mut sentence)));
            length = 0;
        }
    }
    if length > 0 {
        found.push((length, sentence));
    }
    found
}

/// Returns the lengths of the sentences of a Markdown page, words, and the text of sentences that are too long. Code,
/// tables, headings, targets of links and pictures do not count; inline code is one word.
fn prose(page: &str) -> (Vec<usize>, Vec<String>) {
    let mut blocks: Vec<String> = vec![String::new()];
    let mut skipped = 0;
    for event in Parser::new_ext(page, Options::ENABLE_TABLES) {
        let text = blocks.last_mut().expect("never empty");
        match event {
            Event::Start(
                Tag::CodeBlock(_) | Tag::Table(_) | Tag::Heading { .. } | Tag::Image { .. } | Tag::HtmlBlock,
            ) => skipped += 1,
            Event::End(TagEnd::CodeBlock | TagEnd::Table | TagEnd::Heading(_) | TagEnd::Image | TagEnd::HtmlBlock) => {
                skipped -= 1
            }
            Event::Start(Tag::Paragraph | Tag::Item | Tag::List(_)) | Event::End(TagEnd::Paragraph | TagEnd::Item) => {
                blocks.push(String::new());
            }
            _ if skipped > 0 => {}
            Event::Text(piece) => text.push_str(&piece),
            Event::Code(_) => text.push_str("Code"),
            Event::SoftBreak | Event::HardBreak => text.push(' '),
            _ => {}
        }
    }
    let mut lengths = Vec::new();
    let mut long = Vec::new();
    for block in &blocks {
        for (length, sentence) in sentences(block) {
            if length > LONGEST_SENTENCE {
                long.push(format!("{length} words in: {}", sentence.chars().take(90).collect::<String>()));
            }
            lengths.push(length);
        }
    }
    (lengths, long)
}

/// Violations: crate or document, rule, cases.
#[derive(Default)]
struct Findings(BTreeMap<(String, &'static str), Vec<String>>);

impl Findings {
    fn add(&mut self, part: &str, rule: &'static str, case: String) {
        self.0.entry((part.to_owned(), rule)).or_default().push(case);
    }

    fn check_document(&mut self, name: &str, page: &str) {
        let (lengths, long) = prose(page);
        for case in long {
            self.add(name, SENTENCES, case);
        }
        let total: usize = lengths.iter().sum();
        let mean = total as f64 / lengths.len().max(1) as f64;
        println!("{name}: {} sentences of {mean:.1} words in the mean", lengths.len());
        for _ in MEAN_WORDS * lengths.len()..total {
            self.add(name, SURPLUS, String::new());
        }
    }

    /// Checks a name against a rule: [`NAMES`] or [`KEYS`].
    fn check_name(&mut self, part: &str, rule: &'static str, file: &str, name: &str) {
        if let Some(entry) = replaced(name) {
            self.add(part, rule, format!("{file}: {name} ({entry})"));
        }
    }

    /// Checks the name of a function or a type.
    fn check_item(&mut self, part: &str, file: &str, name: &str) {
        match says_nothing(name) {
            Some(_) => self.add(part, NAMES, format!("{file}: {name} says nothing alone")),
            None => self.check_name(part, NAMES, file, name),
        }
    }

    /// Checks the names in a C header, without its comments and quoted texts.
    fn check_header(&mut self, part: &str, file: &str, text: &str) {
        let mut code = String::new();
        for line in text.lines().filter(|line| !line.trim_start().starts_with(['*', '/'])) {
            let line = line.split("//").next().unwrap_or_default();
            code += &line.split("/*").next().unwrap_or_default().split('"').step_by(2).collect::<String>();
            code.push('\n');
        }
        let names: BTreeSet<&str> = code.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
        for name in names {
            self.check_name(part, NAMES, file, name);
        }
    }

    fn check_source(&mut self, part: &str, file: &str, text: &str, has_interface: bool) {
        let parsed = syn::parse_file(text).unwrap_or_else(|error| panic!("{file}: {error}"));
        let mut reader = Reader::default();
        reader.comments(&parsed.attrs);
        reader.visit_file(&parsed);
        if has_interface {
            reader.names.iter().for_each(|name| self.check_name(part, NAMES, file, name));
            reader.keys.iter().for_each(|name| self.check_name(part, KEYS, file, name));
            reader.items.iter().for_each(|name| self.check_item(part, file, name));
        }
        for comment in &reader.comments {
            let first = comment.split("\n\n").next().unwrap_or_default().trim();
            let opening: String = first.chars().take(60).collect();
            if first.starts_with("The same") || first.starts_with("As [") {
                self.add(part, OPENINGS, format!("{file}: {opening}"));
            }
            if sentences(first).first().is_some_and(|(length, _)| *length > LONGEST_SUMMARY) {
                self.add(part, SUMMARIES, format!("{file}: {opening}"));
            }
        }
    }
}

/// Visitor that collects the names for other modules, the JSON keys and the doc comments of one source file.
#[derive(Default)]
struct Reader {
    /// Names of functions and types.
    items: Vec<String>,
    /// Names of modules, constants, fields and variants.
    names: Vec<String>,
    /// JSON keys, and words of a choice in JSON, that are not the name of a field or variant.
    keys: Vec<String>,
    comments: Vec<String>,
}

/// Returns whether other modules can use an item.
fn is_visible(visibility: &syn::Visibility) -> bool {
    match visibility {
        syn::Visibility::Public(_) => true,
        syn::Visibility::Restricted(inside) => !inside.path.is_ident("self"),
        syn::Visibility::Inherited => false,
    }
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    let in_test = |a: &syn::Attribute| a.meta.require_list().is_ok_and(|list| list.tokens.to_string() == "test");
    attributes.iter().any(|a| a.path().is_ident("cfg") && in_test(a) || a.path().is_ident("test"))
}

/// Returns whether a type is serialized, so that its fields are JSON keys.
fn is_serialized(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|a| {
        a.path().is_ident("derive") && a.meta.require_list().is_ok_and(|l| l.tokens.to_string().contains("Serialize"))
    })
}

/// Returns the names that serde writes instead of the names in the source: `rename`, `tag` and `content`.
fn serialized_names(attributes: &[syn::Attribute]) -> Vec<String> {
    let mut found = Vec::new();
    for attribute in attributes.iter().filter(|a| a.path().is_ident("serde")) {
        // A failure only ends the parsing of an attribute of another form, such as `rename(serialize = "...")`.
        let _ = attribute.parse_nested_meta(|meta| {
            let is_name = ["rename", "tag", "content"].iter().any(|key| meta.path.is_ident(key));
            let Ok(value) = meta.value() else { return Ok(()) };
            match value.parse::<syn::Lit>()? {
                syn::Lit::Str(text) if is_name => found.push(text.value()),
                _ => {}
            }
            Ok(())
        });
    }
    found
}

impl Reader {
    fn comments(&mut self, attributes: &[syn::Attribute]) {
        let mut lines = Vec::new();
        for attribute in attributes.iter().filter(|a| a.path().is_ident("doc")) {
            if let syn::Meta::NameValue(pair) = &attribute.meta {
                if let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = &pair.value {
                    lines.push(text.value().trim().to_owned());
                }
            }
        }
        if !lines.is_empty() {
            self.comments.push(lines.join("\n"));
        }
    }

    fn item(&mut self, visibility: &syn::Visibility, name: &syn::Ident) {
        if is_visible(visibility) {
            self.items.push(name.to_string());
        }
    }

    fn name(&mut self, visibility: &syn::Visibility, name: &syn::Ident) {
        if is_visible(visibility) {
            self.names.push(name.to_string());
        }
    }

    /// Collects the keys in the tokens of `json!`: texts before a colon.
    fn tokens(&mut self, tokens: proc_macro2::TokenStream) {
        let mut last = None;
        for token in tokens {
            match token {
                proc_macro2::TokenTree::Literal(literal) => last = Some(literal.to_string()),
                proc_macro2::TokenTree::Punct(punct) if punct.as_char() == ':' => {
                    self.keys.extend(last.take().filter(|text| text.starts_with('"')));
                }
                proc_macro2::TokenTree::Group(group) => {
                    last = None;
                    self.tokens(group.stream());
                }
                _ => last = None,
            }
        }
    }

    fn fields(&mut self, fields: &syn::Fields, all: bool) {
        for field in fields {
            self.comments(&field.attrs);
            self.keys.extend(serialized_names(&field.attrs));
            if let Some(name) = field.ident.as_ref().filter(|_| all || is_visible(&field.vis)) {
                self.names.push(name.to_string());
            }
        }
    }
}

impl<'ast> Visit<'ast> for Reader {
    fn visit_item(&mut self, item: &'ast syn::Item) {
        match item {
            syn::Item::Mod(i) if is_test(&i.attrs) => return,
            syn::Item::Fn(i) if is_test(&i.attrs) => return self.comments(&i.attrs),
            syn::Item::Mod(i) => (self.name(&i.vis, &i.ident), self.comments(&i.attrs)).1,
            syn::Item::Fn(i) => (self.item(&i.vis, &i.sig.ident), self.comments(&i.attrs)).1,
            syn::Item::Const(i) => (self.name(&i.vis, &i.ident), self.comments(&i.attrs)).1,
            syn::Item::Static(i) => (self.name(&i.vis, &i.ident), self.comments(&i.attrs)).1,
            syn::Item::Type(i) => (self.item(&i.vis, &i.ident), self.comments(&i.attrs)).1,
            syn::Item::Struct(i) => {
                self.item(&i.vis, &i.ident);
                self.comments(&i.attrs);
                self.keys.extend(serialized_names(&i.attrs));
                self.fields(&i.fields, is_serialized(&i.attrs));
            }
            syn::Item::Enum(i) => {
                self.item(&i.vis, &i.ident);
                self.comments(&i.attrs);
                self.keys.extend(serialized_names(&i.attrs));
                let open = is_visible(&i.vis);
                for variant in &i.variants {
                    self.comments(&variant.attrs);
                    self.keys.extend(serialized_names(&variant.attrs));
                    if open {
                        self.names.push(variant.ident.to_string());
                    }
                    self.fields(&variant.fields, open || is_serialized(&i.attrs));
                }
            }
            syn::Item::Trait(i) => {
                self.item(&i.vis, &i.ident);
                self.comments(&i.attrs);
                for item in &i.items {
                    if let syn::TraitItem::Fn(f) = item {
                        self.comments(&f.attrs);
                        if is_visible(&i.vis) {
                            self.items.push(f.sig.ident.to_string());
                        }
                    }
                }
            }
            syn::Item::Macro(i) => self.comments(&i.attrs),
            _ => {}
        }
        visit::visit_item(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.item(&item.vis, &item.sig.ident);
        self.comments(&item.attrs);
        visit::visit_impl_item_fn(self, item);
    }

    fn visit_impl_item_const(&mut self, item: &'ast syn::ImplItemConst) {
        self.name(&item.vis, &item.ident);
        self.comments(&item.attrs);
    }

    fn visit_macro(&mut self, mac: &'ast syn::Macro) {
        if mac.path.segments.last().is_some_and(|segment| segment.ident == "json") {
            self.tokens(mac.tokens.clone());
        }
    }
}

/// Lists files with an extension below a folder, sorted, without hidden folders and those of builds.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut entries: Vec<PathBuf> = match std::fs::read_dir(folder) {
        Ok(entries) => entries.map(|entry| entry.expect("an entry").path()).collect(),
        Err(_) => return found,
    };
    entries.sort();
    for path in entries {
        let name = path.file_name().map(|name| name.to_string_lossy()).unwrap_or_default();
        if path.is_dir() && name != "target" && !name.starts_with('.') {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|e| e == ending) {
            found.push(path);
        }
    }
    found
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn relative(path: &Path) -> String {
    path.strip_prefix(root()).unwrap_or(path).to_string_lossy().replace('\\', "/")
}

fn findings() -> Findings {
    let mut findings = Findings::default();
    let mut crates: Vec<PathBuf> = std::fs::read_dir(root().join("src")).unwrap().map(|e| e.unwrap().path()).collect();
    crates.push(root().join("tests"));
    crates.sort();
    for folder in crates {
        let part = relative(&folder);
        for path in files(&folder, "rs") {
            let has_interface = path.starts_with(folder.join("src"));
            findings.check_source(&part, &relative(&path), &read(&path), has_interface);
        }
    }
    for header in ["include/dashpot.h", "vi-crt-bridge/bridge/dashpot_bridge.h"] {
        findings.check_header(header, header, &read(&root().join(header)));
    }
    for path in files(&root(), "md") {
        findings.check_document(&relative(&path), &read(&path));
    }
    findings
}

#[test]
fn nothing_falls_short_by_more_than_is_stated() {
    let Findings(found) = findings();
    let stated: BTreeMap<(String, &str), usize> =
        ALLOWED.iter().map(|(part, rule, count)| (((*part).to_owned(), *rule), *count)).collect();
    assert_eq!(stated.len(), ALLOWED.len(), "a row of ALLOWED stands twice");
    let keys: BTreeSet<&(String, &str)> = found.keys().chain(stated.keys()).collect();
    let mut wrong = Vec::new();
    for key in keys {
        let cases = found.get(key).map_or(&[][..], Vec::as_slice);
        let allowed = stated.get(key).copied().unwrap_or(0);
        let (part, rule) = key;
        let places: String = cases.iter().filter(|case| !case.is_empty()).map(|case| format!("\n    {case}")).collect();
        println!("{part}: {} {rule}{places}", cases.len());
        match cases.len().cmp(&allowed) {
            std::cmp::Ordering::Greater => {
                wrong.push(format!("{part}: {} {rule}, allowed {allowed}{places}", cases.len()));
            }
            std::cmp::Ordering::Less => wrong.push(format!("{part}: {rule}: lower it to {}", cases.len())),
            std::cmp::Ordering::Equal => {}
        }
    }
    assert!(wrong.is_empty(), "see STYLE.md:\n{}", wrong.join("\n"));
}

#[test]
fn each_rule_finds_what_breaks_it() {
    let mut findings = Findings::default();
    let source = "//! The same as before.\n\
         /// As [`x`], but more.\n pub fn told() {}\n\
         pub struct S { pub force_by_x: f64, slope: f64 }\n\
         #[derive(Serialize)] struct Keys { usual: f64 }\n\
         fn f() { json!({\"hidden\": [1, {\"fine\": 2}]}) }\n\
         pub(crate) fn beside_it() {}\n\
         impl S { pub(in crate::s) fn is_held(&self) {} fn shares(&self) {} pub(self) fn slopes(&self) {} }\n\
         struct Written { #[serde(default, rename = \"price\")] p: f64 }\n\
         #[serde(tag = \"told\", rename_all = \"snake_case\")] enum Tagged { #[serde(rename = \"late\")] A }\n\
         #[cfg(test)] mod tests { pub fn refused() {} }";
    findings.check_source("crate", "file", source, true);
    findings.check_header("headers", "h", "// told\n#define DASHPOT_FALLS -18 /* said */\nint fine; // slope\n");
    let long = "word ".repeat(LONGEST_SENTENCE + 1);
    findings.check_document("page", &format!("# {long}\n\n| a |\n|---|\n| {long} |\n\n- {long}\n\n```\n{long}\n```\n"));
    let count = |part: &str, rule| findings.0.get(&(part.to_owned(), rule)).map_or(0, Vec::len);
    // The names: told, force_by_x, usual, beside_it, is_held. The keys: hidden, price, told, late.
    assert_eq!((count("crate", NAMES), count("crate", KEYS)), (5, 4), "{:?}", findings.0);
    assert_eq!(count("crate", OPENINGS), 2);
    assert_eq!(count("headers", NAMES), 1);
    assert_eq!((count("page", SENTENCES), count("page", SURPLUS)), (1, LONGEST_SENTENCE + 1 - MEAN_WORDS));
}

#[test]
fn names_and_sentences_are_taken_apart() {
    assert_eq!(words("DASHPOT_FALLS"), ["dashpot", "falls"]);
    assert_eq!(words("HTTPRefusedBy2"), ["http", "refused", "by2"]);
    assert_eq!(replaced("is_off"), None);
    assert_eq!((replaced("at"), says_nothing("Off"), says_nothing("at_rest")), (None, Some("off"), None));
    let parts = sentences("It is 0.5 mm, e.g. here. Then (so it is.) `x` ends! no");
    let lengths: Vec<usize> = parts.iter().map(|(length, _)| *length).collect();
    assert_eq!((lengths, parts[1].1.as_str()), (vec![6, 4, 3], "Then (so it is.) "));
    let (lengths, _) = prose("One [two](three). Five `six seven`.\n\n1. Eight nine\n2. Ten.\n");
    assert_eq!(lengths, [2, 2, 2, 1]);
}
