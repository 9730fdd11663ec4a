//! Catalog of the texts of one language, read from its Fluent file.

use crate::file;
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use std::collections::HashMap;
use std::fmt;

/// Texts of a language by the ids of their messages.
///
/// A program makes one catalog for each language. Texts without arguments are formatted when the file is read.
pub struct Catalog {
    bundle: FluentBundle<FluentResource>,
    plain: HashMap<String, String>,
}

impl fmt::Debug for Catalog {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Catalog").field("plain", &self.plain).finish_non_exhaustive()
    }
}

impl Catalog {
    /// Reads a Fluent file in a language, such as `de`. Unreadable entries are omitted; [`file::faults`] names them.
    pub fn new(language: &str, source: &str) -> Catalog {
        let resource = FluentResource::try_new(source.to_owned()).unwrap_or_else(|(readable, _)| readable);
        let entries = file::entries(&resource);
        let mut bundle = FluentBundle::new_concurrent(vec![language.parse().unwrap_or_default()]);
        // Arguments are not enclosed in Unicode isolation marks: texts have one direction, and reports are searched and
        // compared as plain text.
        bundle.set_use_isolating(false);
        // If an id has a second text, the bundle rejects it and retains the first text.
        _ = bundle.add_resource(resource);
        let mut catalog = Catalog { bundle, plain: HashMap::new() };
        for entry in entries.into_iter().filter(|entry| entry.arguments.is_empty()) {
            if let Some(text) = catalog.format(&entry.id, &[]) {
                catalog.plain.insert(entry.id, text);
            }
        }
        catalog
    }

    /// Reads a Fluent file into a catalog that exists until the program ends.
    pub fn keep(language: &str, source: &str) -> &'static Catalog {
        Box::leak(Box::new(Catalog::new(language, source)))
    }

    /// Returns a text without arguments, or `None` if the language has no such text with this id.
    pub fn text(&self, id: &str) -> Option<&str> {
        self.plain.get(id).map(String::as_str)
    }

    /// Formats a text with its arguments. Returns `None` if the language has no text with this id.
    pub fn format(&self, id: &str, arguments: &[(&str, String)]) -> Option<String> {
        let pattern = self.bundle.get_message(id)?.value()?;
        let arguments: FluentArgs<'_> = arguments.iter().map(|(name, text)| (*name, value(text))).collect();
        let mut faults = Vec::new();
        let text = self.bundle.format_pattern(pattern, Some(&arguments), &mut faults).into_owned();
        debug_assert!(faults.is_empty(), "{id}: {faults:?}");
        Some(text)
    }
}

/// Largest number of digits of an argument that is a count. A count of so many digits is exact as a floating-point
/// number; a longer one is inserted as text.
const DIGITS: usize = 15;

/// Converts an argument. A count becomes a number, so that a text may depend on the singular or plural. Any other text is
/// inserted as it is.
fn value(text: &str) -> FluentValue<'_> {
    let is_count = text.len() <= DIGITS && text.bytes().all(|b| b.is_ascii_digit()) && !text.starts_with('0');
    match text.parse::<u64>() {
        Ok(count) if is_count => FluentValue::from(count),
        _ => FluentValue::from(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments_stand_in_the_text_as_they_are() {
        let catalog = Catalog::new("de", "off = um { $error } N\nlist = { \", \" }\nfit = Anpassung\n");
        let error = |text: &str| catalog.format("off", &[("error", text.to_owned())]);
        assert_eq!(error("2,50").as_deref(), Some("um 2,50 N"));
        // A value with braces is inserted unchanged.
        assert_eq!(error("{ $error }").as_deref(), Some("um { $error } N"));
        assert_eq!((catalog.text("list"), catalog.text("fit")), (Some(", "), Some("Anpassung")));
        assert_eq!((catalog.text("off"), catalog.format("none", &[])), (None, None));
    }

    #[test]
    fn a_count_selects_singular_or_plural_and_keeps_its_digits() {
        let catalog = Catalog::new("en", "n = { $n ->\n    [one] one test\n   *[other] { $n } tests\n  }\n");
        let of = |n: &str| catalog.format("n", &[("n", n.to_owned())]);
        assert_eq!(of("1").as_deref(), Some("one test"));
        for n in ["0", "2", "007", "120000", "999999999999999", "12345678901234567890", "2.50", "2,5"] {
            assert_eq!(of(n), Some(format!("{n} tests")));
        }
    }

    #[test]
    fn a_fault_in_a_file_costs_its_own_message_only() {
        let catalog = Catalog::new("fr", "a = un\nb = { $\na = deux\nc = trois\n");
        assert_eq!(["a", "b", "c"].map(|id| catalog.text(id)), [Some("un"), None, Some("trois")]);
    }
}
