//! What other crates say in sentences, in every language. The English is theirs, the other languages have it by the ids of the messages.

use super::Words;
use dashpot_messages::{Locale, Reader, Sentence, word_id};
use std::sync::LazyLock;

/// Takes apart the texts that a model file keeps.
static KEPT: LazyLock<Reader> = LazyLock::new(|| {
    let templates = [dashpot_identification::templates(), dashpot_diagnosis::templates()].concat();
    Reader::new(templates, dashpot_identification::words().chain(dashpot_diagnosis::words()))
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

impl Words {
    /// A sentence in this language.
    pub fn say(&self, sentence: &Sentence) -> String {
        self.with_names(&sentence.to_text(self))
    }

    /// A text that a model file keeps in English, in this language.
    pub fn say_kept(&self, english: &str) -> String {
        self.say(&KEPT.read(english))
    }

    /// What is called by a word in a sentence (a path, a form of an effect, a choice), in this language.
    pub fn word<'a>(&self, english: &'a str) -> &'a str {
        word_id(english).and_then(|id| self.catalog.text(&id)).unwrap_or(english)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::words::tests::entries;
    use dashpot_messages::Template;
    use std::collections::{BTreeMap, BTreeSet};

    /// Every message of the other crates.
    pub fn templates() -> Vec<Template> {
        let crates = [
            dashpot_records::templates(),
            dashpot_identification::templates(),
            dashpot_diagnosis::templates(),
            dashpot_dimensions::templates(),
        ];
        crates.concat()
    }

    /// Every word of theirs.
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
                // One of places alone has nothing to translate.
                let words = english.split(' ').filter(|word| !word.contains('{')).count();
                assert!(words <= 3 || entry.text != **english, "{file}: {}", entry.id);
            }
        }
    }

    #[test]
    fn what_a_model_file_keeps_is_said_as_if_it_came_from_the_fit() {
        let made_and_said = [
            (
                "presliding_friction (bends before it slips): 31.4 N rms, 4 % of the force; probability 97 %",
                "Reibung mit Vorgleiten (presliding_friction, biegt sich, bevor es gleitet): 31,4 N effektiv, 4 % der Kraft; \
                 Wahrscheinlichkeit 97 %",
            ),
            (
                "channel_delay: 12.0 N rms, 2 % of the force; probability 88 %",
                "Verzug des Kraftkanals (channel_delay): 12,0 N effektiv, 2 % der Kraft; Wahrscheinlichkeit 88 %",
            ),
            (
                "internal_mass could not be identified from this data; it is held at 0.3000 kg",
                "innere Masse (internal_mass) ließ sich aus diesen Daten nicht identifizieren; der Wert ist auf 0,3000 kg gehalten",
            ),
            (
                "series_damping could not be identified from this data; it is held at 0.0100 N s/m",
                "Reihendämpfung (series_damping) ließ sich aus diesen Daten nicht identifizieren; der Wert ist auf 0,0100 N s/m gehalten",
            ),
            (
                "the force channel comes late by 3.000 ms (95 %: 2.900 to 3.100): taken out here, not in the model; validate and diagnose \
                 take it out of these records too; for other records of this rig give --delay=0.003000, or write it into their \
                 campaign.toml",
                "der Kraftkanal kommt 3,000 ms zu spät (95 %: 2,900 bis 3,100): hier herausgerechnet, nicht im Modell; validate und \
                 diagnose rechnen es aus diesen Messungen ebenfalls heraus; für andere Messungen dieses Prüfstands --delay=0.003000 angeben \
                 oder in ihre campaign.toml schreiben",
            ),
            ("slow tests 60 %, small strokes 40 %", "langsame Versuche 60 %, kleine Hübe 40 %"),
            ("large strokes 97 %", "große Hübe 97 %"),
            (
                "diagnosis: this damper shows aeration (97 % sure, instead of bushing); the residual falls from 3.10 to 1.05 times noise \
                 and curve error",
                "Diagnose: dieser Dämpfer zeigt Luft im Öl (aeration, 97 % sicher, anstelle von Gummilager (bushing)); das Residuum fällt vom \
                 3,10- auf das 1,05-Fache von Rauschen und Kurvenfehler",
            ),
            ("a remark by hand", "a remark by hand"),
        ];
        for (made, said) in made_and_said {
            assert_eq!(super::super::DE.say_kept(made), said);
            let english = super::super::EN.say_kept(made);
            let names = [
                ("presliding friction (presliding_friction, bends", "presliding_friction (bends"),
                ("delay of the force channel (channel_delay)", "channel_delay"),
                ("internal mass (internal_mass)", "internal_mass"),
                ("series damping (series_damping)", "series_damping"),
                ("air in the oil (aeration, 97", "aeration (97"),
                ("rubber bush (bushing)", "bushing"),
            ];
            assert_eq!(names.iter().fold(english, |text, (name, kept)| text.replace(name, kept)), made);
        }
    }
}
