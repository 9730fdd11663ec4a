//! All texts of the reports, in every language of the reports.
//!
//! The texts are in `src/report/locales`, with one Fluent file per language. [`Words`] contains the texts of one language as fields. A text
//! with arguments is a [`Message`], which [`Words::fill`] formats. The crates for records, fit and diagnosis make their sentences in
//! English. The reports find the translations by the ids of the messages ([`sentences`]).

use dashpot_messages::{Catalog, Message, is_number};
use names::MARK;
use std::sync::LazyLock;

mod french;
mod names;
mod sentences;
mod texts;

pub use sentences::VALUE;
pub use texts::Words;

/// Texts of the reports in English.
pub static EN: LazyLock<Words> = LazyLock::new(|| read("en", include_str!("../../locales/en.ftl")));
/// Texts of the reports in German.
pub static DE: LazyLock<Words> = LazyLock::new(|| read("de", include_str!("../../locales/de.ftl")));
/// Texts of the reports in French.
pub static FR: LazyLock<Words> = LazyLock::new(|| read("fr", include_str!("../../locales/fr.ftl")));
/// Texts of the reports in simplified Chinese.
pub static ZH: LazyLock<Words> = LazyLock::new(|| read("zh", include_str!("../../locales/zh.ftl")));

fn read(code: &'static str, source: &str) -> Words {
    let catalog = Catalog::keep(code, source);
    Words::read(catalog, code, catalog)
}

/// Texts for the terminal: English, with identifiers instead of names and with the ASCII minus sign, because scripts read the terminal
/// output.
pub static TERMINAL: LazyLock<Words> = LazyLock::new(|| Words { code: TERMINAL_CODE, ..*EN });
const TERMINAL_CODE: &str = "terminal";

/// A language of the reports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// German.
    German,
    /// French.
    French,
    /// Chinese, simplified.
    Chinese,
}

impl Language {
    /// All languages, with the codes that users write.
    pub const ALL: [(&'static str, Language); 4] =
        [("en", Language::English), ("de", Language::German), ("fr", Language::French), ("zh", Language::Chinese)];

    /// Returns the texts of the language.
    pub fn words(self) -> &'static Words {
        match self {
            Language::English => &EN,
            Language::German => &DE,
            Language::French => &FR,
            Language::Chinese => &ZH,
        }
    }
}

impl std::str::FromStr for Language {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Self::ALL.iter().find(|(code, _)| code.eq_ignore_ascii_case(text.trim()));
        found
            .map(|(_, language)| *language)
            .ok_or_else(|| format!("reports are written in en, de, fr and zh, not {text:?}"))
    }
}

impl Words {
    /// Formats a text of one or several numbers with units for this language. In `plain`, the numbers have a decimal point and an ASCII
    /// minus sign. Do not pass options, names or versions, because users copy them from a report into a command or a file.
    pub fn number(&self, plain: &str) -> String {
        let letters: Vec<char> = plain.chars().collect();
        let is_digit = |k: Option<usize>| k.and_then(|k| letters.get(k)).is_some_and(char::is_ascii_digit);
        let written = letters.iter().enumerate().map(|(k, letter)| match letter {
            '.' if is_digit(k.checked_sub(1)) && is_digit(Some(k + 1)) => self.decimal_sign.to_owned(),
            // Texts use the typographic minus sign, U+2212, as the plotted figures do, except in the terminal.
            '-' if self.code != TERMINAL_CODE
                && is_digit(Some(k + 1))
                && (k == 0 || letters[k - 1].is_whitespace()) =>
            {
                "\u{2212}".to_owned()
            }
            other => other.to_string(),
        });
        written.collect()
    }

    /// Formats a message with its arguments by name. Numbers have the format of this language, and identifiers of effects and parameters
    /// become names.
    pub fn fill(&self, message: Message, figures: &[(&str, &str)]) -> String {
        self.fill_from(self.catalog, message, figures)
    }

    /// Formats a message from `catalog`, another catalog of this language, with the arguments formatted as in [`Words::fill`].
    pub fn fill_from(&self, catalog: &Catalog, message: Message, figures: &[(&str, &str)]) -> String {
        let figures: Vec<(&str, String)> =
            figures.iter().map(|(place, value)| (*place, self.at_place(place, value))).collect();
        self.with_names(&format(catalog, message, &figures))
    }

    /// Formats a message with unchanged arguments by name.
    pub(crate) fn fill_as_is(&self, message: Message, figures: &[(&str, &str)]) -> String {
        let figures: Vec<(&str, String)> = figures.iter().map(|(place, value)| (*place, (*value).to_owned())).collect();
        format(self.catalog, message, &figures)
    }

    /// Formats the value of an argument in this language. An identifier gets marks for [`Words::with_names`].
    fn at_place(&self, place: &str, value: &str) -> String {
        match () {
            () if is_number(place, value) => self.number(value),
            () if self.is_named(place, value) => format!("{MARK}{value}{MARK}"),
            () => value.to_owned(),
        }
    }
}

/// Formats a message from a catalog. If the catalog lacks the message, returns the id of the message.
fn format(catalog: &Catalog, message: Message, figures: &[(&str, String)]) -> String {
    catalog.format(message.0, figures).unwrap_or_else(|| message.0.to_owned())
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use dashpot_messages::file::{self, Entry};
    use dashpot_messages::{Template, word_id};
    use std::collections::{BTreeMap, BTreeSet};

    /// Name and text of the Fluent file of each language.
    const FILES: [(&str, &str); 4] = [
        ("src/report/locales/en.ftl", include_str!("../../locales/en.ftl")),
        ("src/report/locales/de.ftl", include_str!("../../locales/de.ftl")),
        ("src/report/locales/fr.ftl", include_str!("../../locales/fr.ftl")),
        ("src/report/locales/zh.ftl", include_str!("../../locales/zh.ftl")),
    ];

    /// Returns the name and the messages of every Fluent file.
    pub fn entries() -> [(&'static str, Vec<Entry>); 4] {
        FILES.map(|(name, source)| (name, file::read(source)))
    }

    /// Returns the id of every message that the code uses from a Fluent file, with the names of its arguments. The English file needs no
    /// messages of other crates, because their code contains the English text.
    fn used(is_english: bool) -> BTreeMap<String, BTreeSet<String>> {
        let of_pages = Words::MESSAGES.iter().map(|(id, arguments)| (id.to_string(), *arguments));
        let of_pages = of_pages.map(|(id, arguments)| (id, arguments.iter().map(ToString::to_string).collect()));
        let [names, meanings] = super::names::tests::ids();
        let plain = |ids: BTreeSet<String>| ids.into_iter().map(|id| (id, BTreeSet::new()));
        let mut used: BTreeMap<String, BTreeSet<String>> = of_pages.chain(plain(names)).collect();
        if !is_english {
            let places = |template: &Template| template.places().map(str::to_owned).collect();
            used.extend(sentences::tests::templates().iter().map(|t| (t.id().to_owned(), places(t))));
            used.extend(plain(meanings));
            used.extend(plain(sentences::tests::words().into_iter().filter_map(word_id).collect()));
        }
        used
    }

    #[test]
    fn every_file_has_every_message_that_the_code_uses_and_no_other() {
        let of_file = |(name, source): &(&str, &str)| file::faults(name, source, &used(name.ends_with("en.ftl")));
        let faults: Vec<String> = FILES.iter().flat_map(of_file).collect();
        assert!(faults.is_empty(), "{}", faults.join("\n"));
    }

    #[test]
    fn sentences_are_translated_and_not_copied() {
        let [(_, english), others @ ..] = entries();
        let english: BTreeMap<String, String> = english.into_iter().map(|entry| (entry.id, entry.text)).collect();
        for (name, entries) in others {
            for Entry { id, text, .. } in entries {
                let Some(english) = english.get(&id) else { continue };
                assert!(english.split(' ').count() <= 3 || text != *english, "{name}: {id}");
            }
        }
    }

    #[test]
    fn titles_of_axes_end_with_their_unit() {
        // The script of the HTML page shows values under the cursor. It reads the name and the unit of an axis from its title, separated by
        // a comma.
        for (name, entries) in entries() {
            for Entry { id, text, .. } in entries.into_iter().filter(|entry| entry.id.starts_with("axis-")) {
                assert!(text.contains(", "), "{name}: {id} is {text:?}");
            }
        }
    }

    #[test]
    fn languages_are_asked_for_by_their_code() {
        assert_eq!("DE".parse(), Ok(Language::German));
        assert!("klingon".parse::<Language>().unwrap_err().contains("en, de, fr and zh"));
        assert!(Language::ALL.iter().all(|(code, language)| language.words().code == *code));
    }

    #[test]
    fn numbers_are_written_as_the_language_does() {
        for (words, expected) in [(&EN, "−1.048 … 2.5 N/mm"), (&DE, "−1,048 … 2,5 N/mm"), (&FR, "−1,048 … 2,5 N/mm")]
        {
            assert_eq!(words.number("-1.048 … 2.5 N/mm"), expected);
        }
        assert_eq!(TERMINAL.number("-1.048"), "-1.048");
        assert_eq!(DE.number("2.50·10⁻⁸"), "2,50·10⁻⁸");
        assert_eq!(DE.number("1.2e-5"), "1,2e-5");
        assert_eq!(DE.fill(DE.row_amplitude, &[("value", "1.5")]), "1,5 mm Amplitude");
        // An option of a command and the name of a test keep their decimal point.
        let catalog = Catalog::new("de", "made = { $value } { $option } { $test }");
        let figures = [("value", "1.5"), ("option", "--delay=0.0065"), ("test", "2.5")];
        assert_eq!(DE.fill_from(&catalog, Message("made"), &figures), "1,5 --delay=0.0065 2.5");
    }

    #[test]
    fn numbers_in_german_and_french_texts_have_a_decimal_comma() {
        for (name, entries) in &entries()[1..3] {
            for Entry { id, text, .. } in entries {
                let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
                let parts: Vec<&str> = text.split('.').collect();
                let point = parts.windows(2).any(|p| digit(p[0].chars().last()) && digit(p[1].chars().next()));
                assert!(!point, "{name}: {id}");
            }
        }
    }

    #[test]
    fn every_velocity_is_in_millimeters_a_second() {
        // The figures of a report are in mm, mm/s and N, so a velocity in m/s would mix two unit systems. Meanings of parameters are
        // exempt, because the model file is in SI.
        for (name, entries) in entries() {
            for Entry { id, text, .. } in entries.into_iter().filter(|entry| !entry.id.starts_with("parameter-")) {
                let in_meters = text.match_indices("m/s").filter(|(at, _)| {
                    let before = text[..*at].chars().next_back();
                    let is_acceleration = text[at + 3..].starts_with(['²', '^']);
                    !is_acceleration && before.is_some_and(|c| c.is_whitespace() || c.is_ascii_digit() || c == '}')
                });
                assert_eq!(in_meters.count(), 0, "{name}: {id} has a velocity in m/s: write it in mm/s");
            }
        }
    }
}
