//! What effects, elements, parameters and their choices are called, and what they mean. Their identifiers stand in model files, in `--help`
//! and in what scripts read; a sentence for people names them in words, with the identifier in brackets where it comes first.
//!
//! What they mean is said in English by the kernel and the diagnosis; the Fluent files of the other languages have that too.

use super::{TERMINAL_CODE, Words};
use dashpot_core::parameter;
use std::borrow::Cow;

/// Places of sentences where an identifier is no effect and no parameter.
///
/// Tests and files may be called like one, and what a command takes is listed as it is written.
const OTHER: &[&str] =
    &["at", "column", "file", "folder", "found", "known", "option", "record", "test", "tests", "text", "twin", "unit"];

impl Words {
    /// The short name of an effect, an element or a parameter; `None` for anything else.
    pub fn name_of(&self, identifier: &str) -> Option<&'static str> {
        self.for_people(&id("name-", identifier)).filter(|_| is_identifier(identifier))
    }

    /// What an element or an effect is.
    pub fn meaning_of_element(&self, name: &str) -> &'static str {
        self.catalog.text(&id("element-", name)).unwrap_or_else(|| dashpot_diagnosis::meaning(name))
    }

    /// What a parameter means; nothing for a name that is none.
    pub fn meaning_of_parameter(&self, name: &str) -> &'static str {
        let english = || parameter::find(name).map_or("", |row| row.parameter.meaning);
        self.catalog.text(&id("parameter-", name)).unwrap_or_else(english)
    }

    /// A word that a parameter may be set to.
    pub fn choice<'a>(&self, identifier: &'a str) -> Cow<'a, str> {
        match self.for_people(&id("choice-", identifier)) {
            Some(choice) => Cow::Borrowed(choice),
            None => Cow::Owned(identifier.replace('_', " ")),
        }
    }

    /// A text that the terminal does without: scripts read identifiers there.
    fn for_people(&self, id: &str) -> Option<&'static str> {
        self.catalog.text(id).filter(|_| self.code != TERMINAL_CODE)
    }

    /// The name with its identifier in brackets, for headings and tables.
    pub fn named(&self, identifier: &str) -> String {
        match self.name_of(identifier) {
            Some(name) => self.bracketed(name, identifier),
            None => identifier.to_owned(),
        }
    }

    fn bracketed(&self, name: &str, identifier: &str) -> String {
        if self.code == "zh" { format!("{name}（{identifier}）") } else { format!("{name} ({identifier})") }
    }

    /// Whether what stands at a place of a sentence is an effect, an element or a parameter.
    pub(super) fn is_named(&self, place: &str, text: &str) -> bool {
        !OTHER.contains(&place) && is_identifier(text) && self.catalog.text(&id("name-", text)).is_some()
    }

    /// A sentence in which identifiers stand between [`MARK`]s: each is put in words, at its first place with itself in brackets. Brackets that
    /// follow are drawn into those: "gas force (gas_force, 97 % sure)".
    pub(super) fn with_names(&self, marked: &str) -> String {
        let mut pieces = marked.split(MARK);
        let mut text = pieces.next().unwrap_or("").to_owned();
        let mut told: Vec<&str> = Vec::new();
        while let (Some(identifier), Some(behind)) = (pieces.next(), pieces.next()) {
            let first = !told.contains(&identifier);
            told.push(identifier);
            match self.name_of(identifier).filter(|_| !first) {
                Some(name) => text += &(name.to_owned() + behind),
                None => {
                    let named = self.named(identifier);
                    let [open, close, comma] =
                        if self.code == "zh" { ["（", "）", "，"] } else { [" (", ")", ", "] };
                    match (behind.strip_prefix(open), named.strip_suffix(close)) {
                        (Some(inside), Some(name)) => text += &format!("{name}{comma}{inside}"),
                        _ => text += &(named + behind),
                    }
                }
            }
        }
        text
    }
}

/// Whether a text is written as identifiers are; a sentence in the middle of another is none.
fn is_identifier(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_')
}

/// The id of what is said of an identifier.
fn id(prefix: &str, identifier: &str) -> String {
    prefix.to_owned() + &identifier.replace(['_', ' '], "-")
}

/// Stands before and behind an identifier until the sentence is whole; no text has it.
pub(super) const MARK: char = '\u{1}';

#[cfg(test)]
pub(super) mod tests {
    use super::super::tests::entries;
    use super::super::{DE, EN, FR, Language, TERMINAL, ZH};
    use super::*;
    use dashpot_core::parameter::{GROUPS, Shape};
    use dashpot_diagnosis::EFFECTS;
    use std::collections::BTreeSet;

    /// Numbers and look-alikes of fits and diagnoses that are no rows of the kernel's table, and parts of the FV curve that change as one.
    const NO_ROWS: [&str; 21] = [
        "cylinder_expansion",
        "gain_drift",
        "load_dependent_friction",
        "load_cell_hysteresis",
        "resonance",
        "delay",
        "rig_mass",
        "offset",
        "drift",
        "whole_drift",
        "share",
        "share_across",
        "share_growth",
        "cooling_rate",
        "rebound_curve",
        "compression_curve",
        "rebound_low_speed",
        "compression_low_speed",
        "rebound_high_speed",
        "compression_high_speed",
        "lost_stroke",
    ];

    /// Ids of the names and choices, and of what only the other languages have: the meanings.
    pub fn ids() -> [BTreeSet<String>; 2] {
        let groups = || GROUPS.iter().map(|group| group.name);
        let parameters = || parameter::table().map(|row| row.parameter.name);
        let choices = parameter::table().flat_map(|row| match row.parameter.shape {
            Shape::Choice(words) => words.to_vec(),
            _ => Vec::new(),
        });
        let names = EFFECTS.iter().copied().chain(groups()).chain(parameters()).chain(NO_ROWS);
        let elements = EFFECTS.iter().copied().chain(groups()).map(|name| id("element-", name));
        [
            names.map(|name| id("name-", name)).chain(choices.map(|choice| id("choice-", choice))).collect(),
            elements.chain(parameters().map(|name| id("parameter-", name))).collect(),
        ]
    }

    #[test]
    fn names_and_choices_are_short() {
        for (file, entries) in entries() {
            for entry in entries {
                let letters = entry.text.chars().count();
                let is_name = !entry.id.starts_with("name-") || letters <= 42 && !entry.text.contains([',', '_']);
                // Choices stand in a list of a narrow panel.
                let is_choice = !entry.id.starts_with("choice-") || letters <= 21;
                assert!(is_name && is_choice, "{file}: {}", entry.id);
            }
        }
    }

    #[test]
    fn meanings_keep_their_symbols() {
        // Symbols have an underscore, a power or a bar in them.
        let symbols = |text: &str| -> BTreeSet<String> {
            text.split([' ', ',', ';', ':', '，', '；', '：', '、', '（', '）', '(', ')'])
                .filter(|word| word.contains(['_', '^', '|']))
                .map(str::to_owned)
                .collect()
        };
        for (file, entries) in entries() {
            for entry in entries {
                let english = match entry.id.split_once('-') {
                    Some(("element", name)) => EN.meaning_of_element(&name.replace('-', "_")),
                    Some(("parameter", name)) => EN.meaning_of_parameter(&name.replace('-', "_")),
                    _ => continue,
                };
                assert_eq!(symbols(&entry.text), symbols(english), "{file}: {}", entry.id);
                let is_sentence = english.split(' ').count() > 3;
                assert!(!is_sentence || entry.text != english, "{file}: {}", entry.id);
            }
        }
    }

    #[test]
    fn a_meaning_is_said_in_the_language_of_the_words() {
        let meaning = |language: Language| language.words().meaning_of_element("gas_preload");
        assert_eq!(
            Language::ALL.map(|(_, language)| meaning(language)),
            ["constant gas force", "konstante Gaskraft", "effort du gaz constant", "恒定气体力"]
        );
        assert!(FR.meaning_of_element("moving_mass") != FR.meaning_of_parameter("moving_mass"));
        assert_eq!([&EN, &DE, &FR, &ZH].map(|words| words.choice("groove")), ["groove", "Nut", "rainure", "沟槽"]);
    }

    #[test]
    fn an_identifier_stands_in_brackets_where_it_comes_first() {
        let sentence = "\u{1}gas_force\u{1} 1 N, \u{1}gas_force\u{1} 2 N, \u{1}aeration\u{1} (97 %)";
        assert_eq!(DE.with_names(sentence), "Gaskraft (gas_force) 1 N, Gaskraft 2 N, Luft im Öl (aeration, 97 %)");
        assert_eq!(ZH.with_names("缺少：\u{1}aeration\u{1}（把握 97 %）"), "缺少：油中含气（aeration，把握 97 %）");
        assert_eq!(EN.named("rubber"), "rubber");
        // The terminal keeps what scripts read.
        assert_eq!(TERMINAL.with_names("missing: \u{1}aeration\u{1} (97 % sure)"), "missing: aeration (97 % sure)");
        assert!(!EN.is_named("test", "aeration") && EN.is_named("names", "aeration"));
    }
}
