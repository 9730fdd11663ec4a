//! Names and meanings of effects, elements, parameters and their choices. Model files, `--help` and outputs for scripts contain
//! identifiers. A sentence for people contains names instead, with the identifier in brackets at the first occurrence.
//!
//! The English meanings are in the code of the kernel and the diagnosis. The Fluent files of the other languages contain the translations.

use super::french::{add_article, without_markers};
use super::{TERMINAL_CODE, Words};
use dashpot_core::parameter;
use std::borrow::Cow;

/// Names of message arguments whose value is never taken for the identifier of an effect or a parameter.
///
/// The name of a test or a file may look like an identifier. Values that a command accepts stay as users type them.
const OTHER: &[&str] =
    &["at", "column", "file", "folder", "found", "known", "option", "record", "test", "tests", "text", "twin", "unit"];

impl Words {
    /// Returns the short name of an effect, an element or a parameter. Returns `None` for any other text, and for the terminal.
    pub fn name_of(&self, identifier: &str) -> Option<&'static str> {
        self.for_people(&id("name-", identifier)).filter(|_| is_identifier(identifier))
    }

    /// Returns the meaning of an element or an effect.
    pub fn meaning_of_element(&self, name: &str) -> &'static str {
        self.catalog.text(&id("element-", name)).unwrap_or_else(|| dashpot_diagnosis::meaning(name))
    }

    /// Returns the meaning of a parameter, or an empty text if no parameter has this name.
    pub fn meaning_of_parameter(&self, name: &str) -> &'static str {
        let english = || parameter::find(name).map_or("", |row| row.parameter.meaning);
        self.catalog.text(&id("parameter-", name)).unwrap_or_else(english)
    }

    /// Returns the name of a choice, which is a word that a parameter may be set to.
    pub fn choice<'a>(&self, identifier: &'a str) -> Cow<'a, str> {
        match self.for_people(&id("choice-", identifier)) {
            Some(choice) => Cow::Borrowed(choice),
            None => Cow::Owned(identifier.replace('_', " ")),
        }
    }

    /// Returns a text of the catalog, or `None` for the terminal, because scripts read identifiers from its output.
    fn for_people(&self, id: &str) -> Option<&'static str> {
        self.catalog.text(id).filter(|_| self.code != TERMINAL_CODE)
    }

    /// Returns the name of an effect, an element or a parameter with the identifier in brackets, for headings and tables. Returns any other
    /// text unchanged.
    pub fn named(&self, identifier: &str) -> String {
        match self.name_of(identifier) {
            Some(name) => self.bracketed(name, identifier),
            None => identifier.to_owned(),
        }
    }

    fn bracketed(&self, name: &str, identifier: &str) -> String {
        if self.code == "zh" { format!("{name}（{identifier}）") } else { format!("{name} ({identifier})") }
    }

    /// Returns whether the value of the message argument `place` is the identifier of an effect, an element or a parameter.
    pub(super) fn is_named(&self, place: &str, text: &str) -> bool {
        !OTHER.contains(&place) && is_identifier(text) && self.catalog.text(&id("name-", text)).is_some()
    }

    /// Replaces identifiers between [`MARK`]s by names. The first occurrence of a name is followed by its identifier in brackets. If the
    /// text continues with brackets of its own, both are merged: "gas force (gas_force, 97 % sure)".
    pub(super) fn with_names(&self, marked: &str) -> String {
        let mut pieces = marked.split(MARK);
        let mut text = pieces.next().unwrap_or("").to_owned();
        let mut told: Vec<&str> = Vec::new();
        while let (Some(identifier), Some(behind)) = (pieces.next(), pieces.next()) {
            let first = !told.contains(&identifier);
            told.push(identifier);
            if let Some(name) = self.name_of(identifier) {
                add_article(&mut text, name);
            }
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
        without_markers(text)
    }
}

/// Returns whether a text has the form of an identifier: lowercase letters, digits and underscores.
fn is_identifier(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_')
}

/// Returns the id of the message about an identifier.
fn id(prefix: &str, identifier: &str) -> String {
    prefix.to_owned() + &identifier.replace(['_', ' '], "-")
}

/// Character that marks the beginning and the end of an identifier until the sentence is complete. No text contains it.
pub(super) const MARK: char = '\u{1}';

#[cfg(test)]
pub(super) mod tests {
    use super::super::tests::entries;
    use super::super::{DE, EN, FR, Language, TERMINAL, ZH};
    use super::*;
    use dashpot_core::parameter::{GROUPS, Shape};
    use dashpot_diagnosis::EFFECTS;
    use std::collections::BTreeSet;

    /// Quantities and alternative causes in fits and diagnoses that are not in the kernel's parameter table. Parts of the FV curve that
    /// change together are included.
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

    /// Returns the ids of names and choices, and the ids of meanings. Only the files of languages other than English contain the meanings.
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
                // A choice must be short, because a narrow panel lists the choices.
                let is_choice = !entry.id.starts_with("choice-") || letters <= 21;
                assert!(
                    is_name && is_choice,
                    "{file}: {} has {letters} letters: a name has at most 42, without comma and underscore, a choice at most 21",
                    entry.id
                );
            }
        }
    }

    #[test]
    fn meanings_keep_their_symbols() {
        // A word counts as a symbol if it contains an underscore, a power or a vertical bar.
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
        // The terminal keeps identifiers, because scripts read them.
        assert_eq!(TERMINAL.with_names("missing: \u{1}aeration\u{1} (97 % sure)"), "missing: aeration (97 % sure)");
        assert!(!EN.is_named("test", "aeration") && EN.is_named("names", "aeration"));
    }
}
