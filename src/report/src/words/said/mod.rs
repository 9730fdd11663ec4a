//! What a diagnosis says in other languages: a table a language, by the English text that the diagnosis crate makes.

mod de;
mod fr;
mod zh;

use super::{Language, Words};
use dashpot_diagnosis::Sentence;

impl Language {
    /// Translations of what a diagnosis says; none in English.
    fn said(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Language::English => &[],
            Language::German => de::DE,
            Language::French => fr::FR,
            Language::Chinese => zh::ZH,
        }
    }
}

impl Words {
    fn translated(&self, english: &str) -> Option<&'static str> {
        let language = Language::ALL.iter().find(|(code, _)| *code == self.code)?.1;
        language.said().iter().find(|(text, _)| *text == english).map(|(_, translation)| *translation)
    }

    /// A sentence of a diagnosis in this language.
    pub fn say(&self, sentence: &Sentence) -> String {
        sentence.said(&|english| self.translated(english))
    }

    /// What a path, a family, a form of an effect, or an effect itself is called in this language.
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
    fn every_text_of_a_diagnosis_has_a_translation_with_the_same_figures_and_none_is_left_over() {
        let texts = dashpot_diagnosis::texts();
        for (code, language) in Language::ALL.into_iter().skip(1) {
            let table = language.said();
            let known: BTreeSet<&str> = table.iter().map(|(english, _)| *english).collect();
            assert_eq!(known.len(), table.len(), "{code}: a text stands twice");
            assert_eq!(known, texts.iter().copied().collect(), "{code}");
            for (english, translation) in table {
                assert!(!translation.trim().is_empty(), "{code}: {english}");
                assert_eq!(figures(translation), figures(english), "{code}: {english}");
                let is_sentence = english.split(' ').count() > 3;
                assert!(!is_sentence || translation != english, "{code}: {english}");
            }
        }
    }
}
