//! Comparison of the messages of a Fluent file with the messages of the code.

use fluent_bundle::FluentResource;
use fluent_syntax::ast::{Entry as Parsed, Expression, InlineExpression, Pattern, PatternElement};
use std::collections::{BTreeMap, BTreeSet};

/// Message of a Fluent file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// Id of the message.
    pub id: String,
    /// Text of the message, with `{name}` for an argument. The texts of all variants are concatenated.
    pub text: String,
    /// Names of the arguments of the message.
    pub arguments: BTreeSet<String>,
}

/// Returns the messages of a Fluent file, in the order of the file.
pub fn read(source: &str) -> Vec<Entry> {
    entries(&FluentResource::try_new(source.to_owned()).unwrap_or_else(|(readable, _)| readable))
}

pub(crate) fn entries(resource: &FluentResource) -> Vec<Entry> {
    let messages = resource.entries().filter_map(|entry| match entry {
        Parsed::Message(message) => Some(message),
        _ => None,
    });
    messages
        .map(|message| {
            let mut entry = Entry { id: message.id.name.to_owned(), text: String::new(), arguments: BTreeSet::new() };
            if let Some(pattern) = &message.value {
                read_pattern(pattern, &mut entry);
            }
            entry
        })
        .collect()
}

fn read_pattern(pattern: &Pattern<&str>, entry: &mut Entry) {
    for element in &pattern.elements {
        match element {
            PatternElement::TextElement { value } => entry.text += value,
            PatternElement::Placeable { expression } => read_expression(expression, entry),
        }
    }
}

fn read_expression(expression: &Expression<&str>, entry: &mut Entry) {
    match expression {
        Expression::Inline(inline) => read_inline(inline, entry),
        Expression::Select { selector, variants } => {
            if let InlineExpression::VariableReference { id } = selector {
                entry.arguments.insert(id.name.to_owned());
            }
            variants.iter().for_each(|variant| read_pattern(&variant.value, entry));
        }
    }
}

fn read_inline(inline: &InlineExpression<&str>, entry: &mut Entry) {
    match inline {
        InlineExpression::StringLiteral { value } | InlineExpression::NumberLiteral { value } => entry.text += value,
        InlineExpression::VariableReference { id } => {
            entry.text += &format!("{{{}}}", id.name);
            entry.arguments.insert(id.name.to_owned());
        }
        InlineExpression::Placeable { expression } => read_expression(expression, entry),
        // A function, a term or a reference to another message has no text of its own.
        _ => {}
    }
}

/// Returns the faults of a Fluent file. Each fault contains the name of the file, and the id of the message or the
/// line.
///
/// Faults are unreadable lines, and messages that are unused, missing, empty or duplicate, or whose arguments differ
/// from those of the code. `used` contains the ids of the code with their arguments.
pub fn faults(file: &str, source: &str, used: &BTreeMap<String, BTreeSet<String>>) -> Vec<String> {
    let mut faults = Vec::new();
    if let Err((_, errors)) = FluentResource::try_new(source.to_owned()) {
        let line = |at: usize| source[..at].lines().count().max(1);
        faults.extend(errors.iter().map(|error| format!("{file}, line {}: {error}", line(error.pos.start))));
    }
    let mut known = BTreeSet::new();
    for Entry { id, text, arguments } in read(source) {
        match used.get(&id) {
            None => faults.push(format!("{file}: {id} is not used")),
            Some(given) if *given != arguments => {
                faults.push(format!("{file}: {id} has the arguments {arguments:?}, the code gives {given:?}"));
            }
            Some(_) if text.is_empty() => faults.push(format!("{file}: {id} is empty")),
            Some(_) => {}
        }
        if !known.insert(id.clone()) {
            faults.push(format!("{file}: {id} stands twice"));
        }
    }
    let missing = used.keys().filter(|id| !known.contains(*id));
    faults.extend(missing.map(|id| format!("{file}: {id} is missing")));
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_fault_of_a_file_names_file_and_id() {
        let of = |names: &[&str]| names.iter().map(ToString::to_string).collect::<BTreeSet<_>>();
        let used = BTreeMap::from([
            ("a".to_owned(), of(&[])),
            ("b".to_owned(), of(&["n"])),
            ("c".to_owned(), of(&["n"])),
            ("d".to_owned(), of(&[])),
        ]);
        assert!(faults("x.ftl", "a = A\nb = { $n } B\nc = C{ $n }\nd = { \" \" }\n", &used).is_empty());
        let found = faults("x.ftl", "a = A\nb = { $m }\nc = { $n\nb = { $n }\ne = E\nd = D\n", &used);
        assert_eq!(found.len(), 5, "{found:?}");
        assert!(found[0].starts_with("x.ftl, line 3: "), "{found:?}");
        assert_eq!(
            found[1..],
            [
                "x.ftl: b has the arguments {\"m\"}, the code gives {\"n\"}",
                "x.ftl: b stands twice",
                "x.ftl: e is not used",
                "x.ftl: c is missing"
            ]
        );
    }

    #[test]
    fn arguments_are_found_in_every_variant() {
        let read = read("a = { $n ->\n    [one] { $what }\n   *[other] { $n } { $all }\n }\n");
        assert_eq!(read[0].arguments.iter().collect::<Vec<_>>(), ["all", "n", "what"]);
    }
}
