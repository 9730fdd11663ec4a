//! What other crates say in sentences, in every language: one list a crate, by the English text that the crate makes.

mod diagnosis;
mod dimensions;
mod identification;
mod records;

use super::{Language, Words};
use dashpot_records::Sentence;
use dashpot_records::sentence::{Reader, Template};
use std::collections::HashMap;
use std::sync::LazyLock;

/// One text: English, German, French, Chinese, as in [`Language::ALL`].
type Said = [&'static str; 4];

/// All texts by their English.
static SAID: LazyLock<HashMap<&'static str, &'static Said>> = LazyLock::new(|| {
    let all = [records::ALL, identification::ALL, diagnosis::ALL, dimensions::ALL].into_iter().flatten();
    all.map(|said| (said[0], said)).collect()
});

/// Takes apart the texts that a model file keeps.
static KEPT: LazyLock<Reader> = LazyLock::new(|| {
    let crates = [dashpot_identification::templates(), dashpot_diagnosis::templates()];
    let templates: Vec<Template> = crates.into_iter().flatten().copied().collect();
    let texts = dashpot_identification::texts().into_iter().chain(dashpot_diagnosis::texts());
    let words: Vec<&str> = texts.filter(|text| templates.iter().all(|t| t.english() != *text)).collect();
    Reader::new(templates, words)
});

impl Words {
    fn translated(&self, english: &str) -> Option<&'static str> {
        let language = Language::ALL.iter().position(|(code, _)| *code == self.code)?;
        SAID.get(english).map(|said| said[language])
    }

    /// A sentence in this language.
    pub fn say(&self, sentence: &Sentence) -> String {
        self.with_names(
            &sentence.to_text(&|english| self.translated(english), &|place, value| self.at_place(place, value)),
        )
    }

    /// A text that a model file keeps in English, in this language.
    pub fn say_kept(&self, english: &str) -> String {
        self.say(&KEPT.read(english))
    }

    /// What is called by a word in a sentence (a path, a form of an effect, a choice), or an effect itself, in this language.
    pub fn word(&self, english: &'static str) -> &'static str {
        self.translated(english).unwrap_or(english)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::tests::figures;
    use std::collections::BTreeSet;

    #[test]
    fn every_text_has_a_translation_with_the_same_figures_and_none_is_left_over() {
        let lists = [records::ALL, identification::ALL, diagnosis::ALL, dimensions::ALL];
        let all: Vec<&Said> = lists.into_iter().flatten().collect();
        let known: BTreeSet<&str> = all.iter().map(|said| said[0]).collect();
        assert_eq!(known.len(), all.len(), "a text stands twice");
        let made = [
            dashpot_records::texts(),
            dashpot_identification::texts(),
            dashpot_diagnosis::texts(),
            dashpot_dimensions::texts(),
        ];
        assert_eq!(known, made.into_iter().flatten().collect());
        for said in all {
            for (k, (code, _)) in Language::ALL.iter().enumerate() {
                assert!(!said[k].trim().is_empty(), "{code}: {said:?}");
                assert_eq!(figures(said[k]), figures(said[0]), "{code}: {said:?}");
                // Sentences are translated, not copied; one of places alone has nothing to translate.
                let words = said[0].split(' ').filter(|word| !word.contains('{')).count();
                assert!(k == 0 || words <= 3 || said[k] != said[0], "{code}: {said:?}");
            }
        }
    }

    #[test]
    fn every_velocity_is_in_millimeters_a_second() {
        // The figures of a report are in mm, mm/s and N. A velocity in m/s would be a second unit system.
        let said = [records::ALL, identification::ALL, diagnosis::ALL].into_iter().flatten().flatten().copied();
        for text in said {
            let in_meters = text.match_indices("m/s").filter(|(at, _)| {
                let before = text[..*at].chars().next_back();
                let is_acceleration = text[at + 3..].starts_with(['²', '^']);
                !is_acceleration && before.is_some_and(|c| c.is_whitespace() || c.is_ascii_digit() || c == '}')
            });
            assert_eq!(in_meters.count(), 0, "{text}");
        }
    }

    #[test]
    fn numbers_in_german_and_french_texts_have_a_decimal_comma() {
        for said in [records::ALL, identification::ALL, diagnosis::ALL, dimensions::ALL].into_iter().flatten() {
            for text in &said[1..3] {
                let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
                let parts: Vec<&str> = text.split('.').collect();
                let point = parts.windows(2).any(|p| digit(p[0].chars().last()) && digit(p[1].chars().next()));
                assert!(!point, "{text}");
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
