//! Sentences in any language: a message with its English text, and values for its placeholders.
//!
//! Scripts and the terminal show the English text. Reports use a [`Locale`], which finds the message by its id and
//! inserts the same values. A file stores message and values of a sentence in addition to its English text
//! ([`Kept`](crate::Kept)).

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

/// Message with its English text, which contains `{name}` as the placeholder of a value.
///
/// `{name|one|other}` is a text that depends on a count: the second part if the value is 1, else the third. The character `#` in this text
/// stands for the count.
///
/// Only [`phrases!`](crate::phrases) makes templates, so that its list contains all of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Template {
    id: &'static str,
    english: &'static str,
}

impl Template {
    /// Makes a template. Only [`phrases!`](crate::phrases) may call this function, because the test of the translations
    /// covers only templates in its list.
    #[doc(hidden)]
    pub const fn listed(id: &'static str, english: &'static str) -> Template {
        Template { id, english }
    }

    /// Returns the id by which the files of other languages refer to the message.
    pub fn id(self) -> &'static str {
        self.id
    }

    /// Returns the English text, with placeholders.
    pub fn english(self) -> &'static str {
        self.english
    }

    /// Returns the names of the placeholders, in the order of the text and with repetitions.
    pub fn places(self) -> impl Iterator<Item = &'static str> {
        let inside = self.english.split('{').skip(1).filter_map(|rest| rest.split_once('}').map(|(inside, _)| inside));
        inside.map(|inside| inside.split('|').next().unwrap_or(inside))
    }

    /// Formats the English text with these values.
    fn format(self, values: &[(&str, String)]) -> String {
        let (mut text, mut rest) = (String::new(), self.english);
        while let Some((before, after)) = rest.split_once('{') {
            text += before;
            let (inside, behind) = after.split_once('}').unwrap_or((after, ""));
            let mut parts = inside.split('|');
            let name = parts.next().unwrap_or(inside);
            let value = values.iter().find(|(n, _)| *n == name).map_or("", |(_, value)| value);
            text += &match (parts.next(), parts.next()) {
                (Some(one), Some(other)) => (if value == "1" { one } else { other }).replace('#', value),
                _ => value.to_owned(),
            };
            rest = behind;
        }
        text + rest
    }
}

/// Language in which sentences are formatted.
pub trait Locale {
    /// Formats a message with its arguments. Returns `None` if the language has no text for it; the English text is
    /// then used.
    fn message(&self, id: &str, arguments: &[(&str, String)]) -> Option<String>;

    /// Returns the translation of a word, or `None` if the English word is used.
    fn word(&self, english: &str) -> Option<&str>;

    /// Formats a value of the placeholder `place`, for example a number with a decimal comma.
    fn value(&self, place: &str, value: &str) -> String;
}

/// English, in which templates, words and values stay unchanged.
struct English;

impl Locale for English {
    fn message(&self, _: &str, _: &[(&str, String)]) -> Option<String> {
        None
    }

    fn word(&self, _: &str) -> Option<&str> {
        None
    }

    fn value(&self, _: &str, value: &str) -> String {
        value.to_owned()
    }
}

/// Returns the id of a word: `word-` followed by its letters and digits. Returns `None` for an identifier such as
/// `gas_force`, which no language translates.
pub fn word_id(english: &str) -> Option<String> {
    let is_identifier = english.contains('_') && !english.contains(' ');
    let parts = english.split(|c: char| !c.is_ascii_alphanumeric()).filter(|part| !part.is_empty());
    (!is_identifier).then(|| parts.fold("word".to_owned(), |id, part| id + "-" + &part.to_ascii_lowercase()))
}

/// Defines the messages of a crate as constants: a prefix of the ids, then lines of the form `NAME: "English with
/// {places}";`. The constant `TEMPLATES` contains all of them.
///
/// The id of a message is the prefix followed by the name in kebab-case.
#[macro_export]
macro_rules! phrases {
    ($prefix:literal; $($name:ident: $text:literal;)*) => {
        $(pub(crate) const $name: $crate::Template = $crate::Template::listed($crate::id!($prefix, $name), $text);)*
        /// All messages of the crate.
        pub(crate) const TEMPLATES: &[$crate::Template] = &[$($name),*];
    };
}

/// Placeholders whose values are names, never numbers. A name may look like a number: a test may have the name 2.5.
const NAMES: &[&str] =
    &["at", "column", "file", "folder", "name", "names", "record", "test", "tests", "text", "twin", "version"];

/// Returns whether the value of a placeholder is a number, which each language formats differently.
///
/// A number may have a sign, and a unit after it. Names, options of the command and versions are not numbers.
pub fn is_number(place: &str, text: &str) -> bool {
    let unsigned = text.trim_start_matches(['+', '-', '±', '\u{2212}']);
    let (figures, unit) = unsigned.split_once(char::is_whitespace).unwrap_or((unsigned, ""));
    let is_unit = unit.chars().all(|c| !c.is_ascii_digit()) && unit.chars().count() <= LONGEST_UNIT;
    let figures = figures.trim_end_matches('%');
    // A power of ten follows the mantissa of a very large or small number.
    let figures = figures.split_once("\u{b7}10").map_or(figures, |(mantissa, _)| mantissa);
    is_unit
        && !NAMES.contains(&place)
        && figures.starts_with(|c: char| c.is_ascii_digit())
        && figures.parse::<f64>().is_ok()
}

/// Largest length of a unit in characters, for example `N s²/m²`.
const LONGEST_UNIT: usize = 10;

/// Value of a placeholder in a sentence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Value {
    /// A number ([`is_number`]), or a text that is equal in every language: a unit, or the name of a test or an effect.
    AsIs(String),
    /// A word that a language may translate, such as the name of a force path. Other words stay unchanged.
    Word(String),
    /// A text of the system, of another library or of a reader of one file format. It is not translated.
    Foreign(String),
    /// A sentence within the sentence.
    Sentence(Sentence),
    /// Several values, with the template of the text between them.
    List(Vec<Value>, Template),
}

/// Message with the values of its placeholders. It is serialized and displayed as English text. A sentence that is
/// deserialized from that text stays English.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Sentence {
    template: Template,
    values: Vec<(&'static str, Value)>,
}

impl From<Template> for Sentence {
    fn from(template: Template) -> Self {
        Sentence { template, values: Vec::new() }
    }
}

/// Construction, access and formatting.
impl Sentence {
    /// Template of a text that is not translated.
    pub(crate) const AS_IT_IS: Template = Template::listed("", "{text}");

    /// Adds a number or a name as the value of a placeholder.
    pub fn with(self, name: &'static str, value: impl ToString) -> Self {
        self.and(name, Value::AsIs(value.to_string()))
    }

    /// Adds a text of the system, of another library or of a reader of one file format as the value of a placeholder. The text is not
    /// translated.
    pub fn with_foreign(self, name: &'static str, text: impl ToString) -> Self {
        self.and(name, Value::Foreign(text.to_string()))
    }

    /// Adds a word, which a language may translate, as the value of a placeholder.
    pub fn with_word(self, name: &'static str, word: &str) -> Self {
        self.and(name, Value::Word(word.to_owned()))
    }

    /// Adds another sentence as the value of a placeholder.
    pub fn with_sentence(self, name: &'static str, sentence: impl Into<Sentence>) -> Self {
        self.and(name, Value::Sentence(sentence.into()))
    }

    /// Adds another sentence, if there is one, as the value of a placeholder. Otherwise, the placeholder becomes empty.
    pub fn with_any(self, name: &'static str, sentence: Option<Sentence>) -> Self {
        match sentence {
            Some(sentence) => self.with_sentence(name, sentence),
            None => self,
        }
    }

    /// Adds a list of names as the value of a placeholder, with the text of `between` between them.
    pub fn with_names<T: ToString>(
        self,
        name: &'static str,
        names: impl IntoIterator<Item = T>,
        between: Template,
    ) -> Self {
        let list = names.into_iter().map(|n| Value::AsIs(n.to_string())).collect();
        self.and(name, Value::List(list, between))
    }

    /// Adds a list of sentences as the value of a placeholder, with the text of `between` between them.
    pub fn with_list(self, name: &'static str, list: Vec<Sentence>, between: Template) -> Self {
        self.and(name, Value::List(list.into_iter().map(Value::Sentence).collect(), between))
    }

    /// Makes one sentence from several, with the text of `between` between them.
    pub fn list(list: Vec<Sentence>, between: Template) -> Self {
        Sentence::from(Sentence::AS_IT_IS).with_list("text", list, between)
    }

    /// Makes a sentence from a text that stays unchanged in every language.
    pub fn as_it_is(text: impl ToString) -> Self {
        Sentence::from(Sentence::AS_IT_IS).with("text", text)
    }

    /// Returns the template of the sentence.
    pub fn template(&self) -> Template {
        self.template
    }

    /// Makes a sentence from a template and the values of its placeholders.
    pub(crate) fn from_parts(template: Template, values: Vec<(&'static str, Value)>) -> Self {
        Sentence { template, values }
    }

    /// Returns the values of the placeholders with their names.
    pub(crate) fn values(&self) -> &[(&'static str, Value)] {
        &self.values
    }

    fn and(mut self, name: &'static str, value: Value) -> Self {
        debug_assert!(self.template.places().any(|place| place == name), "no place for {name} in {:?}", self.template);
        self.values.push((name, value));
        self
    }

    /// Formats the sentence in a language. Messages and words without a translation stay English. A placeholder without
    /// a value becomes empty.
    pub fn to_text(&self, locale: &dyn Locale) -> String {
        let mut values: Vec<(&str, String)> = Vec::new();
        for place in self.template.places() {
            if values.iter().all(|(name, _)| *name != place) {
                let value = self.values.iter().find(|(name, _)| *name == place);
                values.push((place, value.map_or_else(String::new, |(_, value)| value.to_text(place, locale))));
            }
        }
        locale.message(self.template.id, &values).unwrap_or_else(|| self.template.format(&values))
    }
}

impl Value {
    fn to_text(&self, place: &str, locale: &dyn Locale) -> String {
        match self {
            Value::AsIs(text) => locale.value(place, text),
            Value::Word(word) => locale.word(word).unwrap_or(word).to_owned(),
            Value::Foreign(text) => text.clone(),
            Value::Sentence(sentence) => sentence.to_text(locale),
            Value::List(values, between) => {
                let all: Vec<String> = values.iter().map(|value| value.to_text(place, locale)).collect();
                all.join(&locale.message(between.id, &[]).unwrap_or_else(|| between.english.to_owned()))
            }
        }
    }
}

impl fmt::Display for Sentence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.to_text(&English))
    }
}

impl Serialize for Sentence {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Sentence {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        Ok(Sentence::as_it_is(String::deserialize(from)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO: Template = Template::listed("two", "{names} in {place}{note}");
    const NOTE: Template = Template::listed("x", ", {what}");
    const AND: Template = Template::listed("and", " and ");

    /// Locale with German translations of this test's messages, and with a decimal comma.
    struct German;

    impl Locale for German {
        fn message(&self, id: &str, arguments: &[(&str, String)]) -> Option<String> {
            let german = match id {
                "two" => "in {place}: {names}{note}",
                "and" => " und ",
                _ => return None,
            };
            Some(Template::listed("", german).format(arguments))
        }

        fn word(&self, english: &str) -> Option<&str> {
            (english == "rig").then_some("Prüfstand")
        }

        fn value(&self, place: &str, value: &str) -> String {
            if is_number(place, value) { value.replace('.', ",") } else { value.to_owned() }
        }
    }

    #[test]
    fn a_count_selects_a_part_of_an_english_text() {
        const READ: Template = Template::listed("r", "{n|# test was|# tests were} read {all|at once|in # parts}{n}");
        let of = |n: usize, all: &str| Sentence::from(READ).with("n", n).with("all", all).to_string();
        assert_eq!(of(1, "1"), "1 test was read at once1");
        assert_eq!(of(12, "0"), "12 tests were read in 0 parts12");
        assert_eq!(READ.places().collect::<Vec<_>>(), ["n", "all", "n"]);
    }

    #[test]
    fn numbers_are_told_from_names_options_and_versions() {
        for number in ["1.048", "-12.5", "+130", "±0.05", "97 %", "97\u{a0}%", "\u{2212}3", "1.2e5", "0.3 N s/m"] {
            assert!(is_number("value", number), "{number}");
        }
        for other in [
            "",
            "-",
            "%",
            "0.2.1",
            "a01mm",
            "--delay=0.0065",
            "2.5.csv",
            "inf",
            "NaN",
            "2026-01-05",
            "2.5 of all of them",
        ] {
            assert!(!is_number("value", other), "{other}");
        }
        assert!(!is_number("test", "2.5"));
        const AT: Template = Template::listed("x", "{test}: {value} {unit} at {names}");
        let said = Sentence::from(AT).with("test", "2.5").with("value", "1.5").with("unit", "N");
        let said = said.with_names("names", ["0.1", "0.2"], NOTE);
        assert_eq!(said.to_text(&German), "2.5: 1,5 N at 0.1, {what}0.2");
        assert_eq!(said.to_string(), "2.5: 1.5 N at 0.1, {what}0.2");
    }

    #[test]
    fn values_keep_their_places_in_every_language() {
        let sentence = Sentence::from(TWO).with_names("names", ["a", "{place}"], AND).with_word("place", "rig");
        // A value with braces is not a placeholder.
        assert_eq!(sentence.to_string(), "a and {place} in rig");
        assert_eq!(sentence.to_text(&German), "in Prüfstand: a und {place}");
        let noted = sentence.with_sentence("note", Sentence::from(NOTE).with("what", 3));
        assert_eq!(noted.to_string(), "a and {place} in rig, 3");
        assert_eq!(noted.to_text(&German), "in Prüfstand: a und {place}, 3");
    }

    #[test]
    fn texts_of_others_stay_as_they_are() {
        const CANNOT: Template = Template::listed("x", "cannot read {file}: {cause}");
        let sentence = Sentence::from(CANNOT).with("file", "a.csv").with_foreign("cause", "1.5");
        assert_eq!(sentence.to_text(&German), "cannot read a.csv: 1.5");
    }

    #[test]
    fn a_word_has_an_id_and_an_identifier_has_none() {
        assert_eq!(word_id("% at 1.013 bar absolute").as_deref(), Some("word-at-1-013-bar-absolute"));
        assert_eq!(word_id("gas_stiffness"), None);
        assert_eq!(word_id("fv_force at a fast speed").as_deref(), Some("word-fv-force-at-a-fast-speed"));
    }
}
