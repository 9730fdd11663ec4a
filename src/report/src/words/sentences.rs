//! Sentences of other crates in every language. Their code contains the English text, and the Fluent files contain the translations by the
//! ids of the messages.

use super::Words;
use dashpot_messages::{Kept, Locale, Restorer, Sentence, is_number, word_id};
use std::sync::LazyLock;

/// Finder of the messages of English sentences that a model file contains, so that the sentences can be translated.
static KEPT: LazyLock<Restorer> = LazyLock::new(|| {
    let crates = [dashpot_records::templates(), dashpot_identification::templates(), dashpot_diagnosis::templates()];
    Restorer::new(crates.concat())
});

impl Locale for Words {
    fn message(&self, id: &str, arguments: &[(&str, String)]) -> Option<String> {
        self.catalog.format(id, arguments)
    }

    fn word(&self, english: &str) -> Option<&str> {
        self.catalog.text(&word_id(english)?)
    }

    fn value(&self, place: &str, value: &str) -> String {
        self.at_place(place, value)
    }
}

/// Character on either side of a value in a sentence of [`Words::say_with_marks`].
pub const VALUE: char = '\u{2}';

/// A language whose sentences have a mark on either side of every number and of every unit.
struct Marked<'a>(&'a Words);

impl Locale for Marked<'_> {
    fn message(&self, id: &str, arguments: &[(&str, String)]) -> Option<String> {
        Locale::message(self.0, id, arguments)
    }

    fn word(&self, english: &str) -> Option<&str> {
        Locale::word(self.0, english)
    }

    fn value(&self, place: &str, value: &str) -> String {
        let text = Locale::value(self.0, place, value);
        let is_quantity = is_number(place, value) || ["unit", "speed_unit"].contains(&place);
        if is_quantity { format!("{VALUE}{text}{VALUE}") } else { text }
    }
}

impl Words {
    /// Formats a sentence in this language, with [`VALUE`] before and after its numbers and units. A program that shows other units
    /// converts only these numbers and does not change names and fixed words.
    pub fn say_with_marks(&self, sentence: &Sentence) -> String {
        self.with_names(&sentence.to_text(&Marked(self)))
    }

    /// Formats a sentence in this language.
    pub fn say(&self, sentence: &Sentence) -> String {
        self.with_names(&sentence.to_text(self))
    }

    /// Translates a text that a model file contains in English. Returns it unchanged if the file does not contain its message.
    pub fn say_kept(&self, english: &str, messages: &[Kept]) -> String {
        self.say(&KEPT.find(english, messages))
    }

    /// Translates a word of a sentence, such as a force path, a form of an effect or a choice. Returns it unchanged without a translation.
    pub fn word<'a>(&self, english: &'a str) -> &'a str {
        word_id(english).and_then(|id| self.catalog.text(&id)).unwrap_or(english)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::words::tests::entries;
    use dashpot_messages::{Message, Template};
    use std::collections::{BTreeMap, BTreeSet};

    /// Returns every message of the other crates.
    pub fn templates() -> Vec<Template> {
        let crates = [
            dashpot_records::templates(),
            dashpot_identification::templates(),
            dashpot_diagnosis::templates(),
            dashpot_dimensions::templates(),
        ];
        crates.concat()
    }

    /// Returns every word of the other crates that has a translation.
    pub fn words() -> BTreeSet<&'static str> {
        let of_fits = dashpot_records::words().chain(dashpot_identification::words());
        of_fits.chain(dashpot_diagnosis::words()).chain(dashpot_dimensions::words()).collect()
    }

    #[test]
    fn no_two_messages_or_words_have_one_id() {
        let templates = templates();
        let ids: BTreeSet<&str> = templates.iter().map(|template| template.id()).collect();
        assert_eq!(ids.len(), templates.len());
        let of_words: BTreeSet<String> = words().into_iter().filter_map(word_id).collect();
        assert_eq!(of_words.len(), words().len());
    }

    #[test]
    fn sentences_of_the_crates_are_translated_and_not_copied() {
        let english: BTreeMap<String, &str> =
            templates().iter().map(|template| (template.id().to_owned(), template.english())).collect();
        for (file, entries) in entries() {
            for entry in entries {
                let Some(english) = english.get(&entry.id) else { continue };
                // A sentence that consists mostly of arguments may be equal in two languages.
                let words = english.split(' ').filter(|word| !word.contains('{')).count();
                assert!(words <= 3 || entry.text != **english, "{file}: {}", entry.id);
            }
        }
    }

    /// Nouns that a count of one must not precede, in English, German and French.
    const PLURALS: &[&str] = &[
        "tests",
        "files",
        "rows",
        "samples",
        "cycles",
        "limits",
        "pieces",
        "columns",
        "lines",
        "blocks",
        "values",
        "fields",
        "stretches",
        "Versuche",
        "Versuchen",
        "Dateien",
        "Zeilen",
        "Messwerte",
        "Messwerten",
        "Zyklen",
        "Grenzwerte",
        "Grenzwerten",
        "Stücke",
        "Spalten",
        "Blöcke",
        "Blöcken",
        "Werte",
        "Felder",
        "Abschnitte",
        "Abschnitten",
        "essais",
        "fichiers",
        "lignes",
        "échantillons",
        "limites",
        "morceaux",
        "colonnes",
        "blocs",
        "valeurs",
        "champs",
        "tronçons",
        "autres",
    ];

    /// Messages that need no text for a count of one. Their counts are always at least two, or their only number before such a noun is not
    /// a count.
    const SEVERAL: &[&str] = &[
        "records-at-speeds",
        "records-at-settings",
        "records-at-rests",
        "records-differentiated",
        "records-too-many-columns",
        "records-unknown-type",
        "single-most",
        "identification-selected",
        "identification-family-selected",
        "identification-family-too-many",
    ];

    /// Words between a count and a total, such as "1 of 3". Messages with a total of one have a separate text where this can occur.
    const OF: &[&str] = &["of", "von", "des", "der", "sur"];

    #[test]
    fn one_is_no_plural_in_any_language() {
        let is_wrong = |text: &str| {
            let words: Vec<&str> = text.split(' ').collect();
            (0..words.len()).any(|k| {
                let noun =
                    |k: usize| words.get(k).map_or("", |word| word.trim_end_matches(|c: char| !c.is_alphanumeric()));
                let is_one = words[k].trim_start_matches('(') == "1"
                    && !k.checked_sub(1).is_some_and(|k| OF.contains(&words[k]));
                let is_adjective =
                    |word: &str| !word.is_empty() && word.chars().all(char::is_lowercase) && !OF.contains(&word);
                is_one
                    && (PLURALS.contains(&noun(k + 1)) || is_adjective(noun(k + 1)) && PLURALS.contains(&noun(k + 2)))
            })
        };
        assert!(is_wrong("in all 1 tests") && is_wrong("(1 Dateien)") && is_wrong("1 autres") && !is_wrong("11 tests"));
        let mut wrong = Vec::new();
        // The texts of the diagnosis come from another crate, which has separate tests for them.
        for template in templates().into_iter().filter(|template| !template.id().starts_with("diagnosis-")) {
            let ones = template.places().fold(Sentence::from(template), |sentence, place| sentence.with(place, "1"));
            let texts = [&*crate::words::EN, &crate::words::DE, &crate::words::FR].map(|words| ones.to_text(words));
            wrong.extend(
                texts
                    .into_iter()
                    .filter(|text| is_wrong(text) && !SEVERAL.contains(&template.id()))
                    .map(|text| format!("{}: {text}", template.id())),
            );
        }
        for (id, places) in Words::MESSAGES {
            let ones: Vec<(&str, &str)> = places.iter().map(|place| (*place, "1")).collect();
            let texts =
                [&*crate::words::EN, &crate::words::DE, &crate::words::FR].map(|words| words.fill(Message(id), &ones));
            wrong.extend(
                texts
                    .into_iter()
                    .filter(|text| is_wrong(text) && !SEVERAL.contains(id))
                    .map(|text| format!("{id}: {text}")),
            );
        }
        assert!(wrong.is_empty(), "{wrong:#?}");
    }

    #[test]
    fn what_a_model_file_keeps_is_said_as_if_it_came_from_the_fit() {
        let held = |name: &str, value: &str| {
            format!("{{ id = \"identification-held\", name = \"{name}\", value = \"{value}\" }}")
        };
        let share = |tests: &str, percent: &str| {
            format!("{{ id = \"identification-share-of\", tests = {{ word = \"{tests}\" }}, percent = \"{percent}\" }}")
        };
        let all = format!("[{}, {}]", share("slow tests", "60"), share("small strokes", "40"));
        let kept_and_said = [
            (
                held("internal_mass", "0.3000 kg"),
                "internal_mass could not be identified from this data; it is held at 0.3000 kg",
                "innere Masse (internal_mass) ließ sich aus diesen Daten nicht identifizieren; der Wert ist auf 0,3000 kg gehalten",
            ),
            (
                format!("{{ id = \"\", text = {{ between = \"identification-comma\", list = {all} }} }}"),
                "slow tests 60 %, small strokes 40 %",
                "langsame Versuche 60 %, kleine Hübe 40 %",
            ),
            (
                "{ id = \"identification-carries-in-form\", effect = \"presliding_friction\", form = { word = \"bends before it slips\" }, \
                 force = \"31.4\", share = \"4 %\", probability = \"97 %\" }"
                    .to_owned(),
                "presliding_friction (bends before it slips): 31.4 N rms, 4 % of the force; probability 97 %",
                "Reibung mit Vorgleiten (presliding_friction, biegt sich, bevor es gleitet): 31,4 N effektiv, 4 % der Kraft; \
                 Wahrscheinlichkeit 97 %",
            ),
        ];
        #[derive(serde::Deserialize)]
        struct File {
            messages: Vec<Kept>,
        }
        let kept: Vec<&str> = kept_and_said.iter().map(|(kept, ..)| kept.as_str()).collect();
        let file: File = toml::from_str(&format!("messages = [{}]", kept.join(", "))).unwrap();
        let [german, terminal] = [&crate::words::DE, &crate::words::TERMINAL];
        for (_, english, said) in &kept_and_said {
            assert_eq!(german.say_kept(english, &file.messages), *said);
            assert_eq!(terminal.say_kept(english, &file.messages), *english);
            // A model file of an earlier version contains only the English text.
            assert_eq!(german.say_kept(english, &[]), *english);
        }
        assert_eq!(german.say_kept("a remark by hand", &file.messages), "a remark by hand");
    }
}
