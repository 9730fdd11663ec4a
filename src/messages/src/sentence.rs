//! Sentences in any language: a message with its English text, and values for its placeholders.
//!
//! Scripts and the terminal show the English text. Reports use a [`Locale`], which finds the message by its id and inserts the same values.
//! A file stores message and values of a sentence in addition to its English text ([`Kept`](crate::Kept)).

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

/// A message with its English text, which has `{name}` where a value stands.
///
/// Only [`phrases!`](crate::phrases) makes them, so that its list holds every one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Template {
    id: &'static str,
    english: &'static str,
}

impl Template {
    /// For [`phrases!`](crate::phrases) alone: a template that is in no list is in no test of the translations.
    #[doc(hidden)]
    pub const fn listed(id: &'static str, english: &'static str) -> Template {
        Template { id, english }
    }

    /// The id by which other languages have it.
    pub fn id(self) -> &'static str {
        self.id
    }

    /// The English text.
    pub fn english(self) -> &'static str {
        self.english
    }

    /// The names of its places, as often as they stand in it.
    pub fn places(self) -> impl Iterator<Item = &'static str> {
        self.english.split('{').skip(1).filter_map(|rest| rest.split_once('}').map(|(name, _)| name))
    }

    /// The English text with these values.
    fn format(self, values: &[(&str, String)]) -> String {
        let (mut text, mut rest) = (String::new(), self.english);
        while let Some((before, after)) = rest.split_once('{') {
            text += before;
            let (name, behind) = after.split_once('}').unwrap_or((after, ""));
            text += values.iter().find(|(n, _)| *n == name).map_or("", |(_, value)| value);
            rest = behind;
        }
        text + rest
    }
}

/// How a language writes sentences.
pub trait Locale {
    /// The text of a message with its arguments; `None` where the language has none but the English one.
    fn message(&self, id: &str, arguments: &[(&str, String)]) -> Option<String>;

    /// The text of a word; `None` where it is the same as in English.
    fn word(&self, english: &str) -> Option<&str>;

    /// A value, from the name of its place and the value itself.
    fn value(&self, place: &str, value: &str) -> String;
}

/// English as the crates write it.
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

/// The id of a word: `word-` and its letters and figures; `None` for an identifier such as `gas_force`, which no language translates.
pub fn word_id(english: &str) -> Option<String> {
    let is_identifier = english.contains('_') && !english.contains(' ');
    let parts = english.split(|c: char| !c.is_ascii_alphanumeric()).filter(|part| !part.is_empty());
    (!is_identifier).then(|| parts.fold("word".to_owned(), |id, part| id + "-" + &part.to_ascii_lowercase()))
}

/// The messages of a crate: a prefix of their ids, then `NAME: "English with {places}";`, each a constant; `TEMPLATES` has all of them.
///
/// The id is the prefix and the name in kebab-case.
#[macro_export]
macro_rules! phrases {
    ($prefix:literal; $($name:ident: $text:literal;)*) => {
        $(pub(crate) const $name: $crate::Template = $crate::Template::listed($crate::id!($prefix, $name), $text);)*
        /// Every message.
        pub(crate) const TEMPLATES: &[$crate::Template] = &[$($name),*];
    };
}

/// Places where a name stands, and a name may look like a number: a test may be called 2.5.
const NAMES: &[&str] =
    &["at", "column", "file", "folder", "name", "names", "record", "test", "tests", "text", "twin", "version"];

/// Whether what stands at a place of a sentence is a number, which every language writes in its own way.
///
/// A number alone, with a sign, or with a unit behind it. A name, an option of the command or a version is none.
pub fn is_number(place: &str, text: &str) -> bool {
    let unsigned = text.trim_start_matches(['+', '-', '±', '\u{2212}']);
    let (figures, unit) = unsigned.split_once(char::is_whitespace).unwrap_or((unsigned, ""));
    let is_unit = unit.chars().all(|c| !c.is_ascii_digit()) && unit.chars().count() <= LONGEST_UNIT;
    let figures = figures.trim_end_matches('%');
    is_unit
        && !NAMES.contains(&place)
        && figures.starts_with(|c: char| c.is_ascii_digit())
        && figures.parse::<f64>().is_ok()
}

/// Longest unit, letters: `N s²/m²` and the like.
const LONGEST_UNIT: usize = 10;

/// What stands at a place of a sentence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Value {
    /// A number ([`is_number`]), or a unit, a name of a test or an effect, which are the same in every language.
    AsIs(String),
    /// A word, such as a path; the same in every language where it is no word but a name.
    Word(String),
    /// A text of the system, of another library or of a reader of one file format, in whatever language it comes.
    Foreign(String),
    /// A sentence in the sentence.
    Said(Sentence),
    /// Several, with the text between them.
    List(Vec<Value>, Template),
}

/// A sentence. Serialized and shown, it is the English text; read back from that alone, it stays English.
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

/// What may be put into a sentence.
impl Sentence {
    /// A text that nobody can translate.
    pub(crate) const AS_IT_IS: Template = Template::listed("", "{text}");

    /// With a number or a name.
    pub fn with(self, name: &'static str, value: impl ToString) -> Self {
        self.and(name, Value::AsIs(value.to_string()))
    }

    /// With a text of the system, of another library or of a reader of one file format, which nobody translates.
    pub fn with_foreign(self, name: &'static str, text: impl ToString) -> Self {
        self.and(name, Value::Foreign(text.to_string()))
    }

    /// With a word.
    pub fn with_word(self, name: &'static str, word: &str) -> Self {
        self.and(name, Value::Word(word.to_owned()))
    }

    /// With another sentence.
    pub fn with_sentence(self, name: &'static str, sentence: impl Into<Sentence>) -> Self {
        self.and(name, Value::Said(sentence.into()))
    }

    /// With another sentence where there is one; its place stays empty otherwise.
    pub fn with_any(self, name: &'static str, sentence: Option<Sentence>) -> Self {
        match sentence {
            Some(sentence) => self.with_sentence(name, sentence),
            None => self,
        }
    }

    /// With names.
    pub fn with_names<T: ToString>(
        self,
        name: &'static str,
        names: impl IntoIterator<Item = T>,
        between: Template,
    ) -> Self {
        let list = names.into_iter().map(|n| Value::AsIs(n.to_string())).collect();
        self.and(name, Value::List(list, between))
    }

    /// With several sentences.
    pub fn with_list(self, name: &'static str, list: Vec<Sentence>, between: Template) -> Self {
        self.and(name, Value::List(list.into_iter().map(Value::Said).collect(), between))
    }

    /// Several sentences in one.
    pub fn list(list: Vec<Sentence>, between: Template) -> Self {
        Sentence::from(Sentence::AS_IT_IS).with_list("text", list, between)
    }

    /// A text that stays as it is in every language.
    pub fn as_it_is(text: impl ToString) -> Self {
        Sentence::from(Sentence::AS_IT_IS).with("text", text)
    }

    /// The text that it was made of.
    pub fn template(&self) -> Template {
        self.template
    }

    /// One of a message with these values.
    pub(crate) fn of(template: Template, values: Vec<(&'static str, Value)>) -> Self {
        Sentence { template, values }
    }

    /// What stands at its places.
    pub(crate) fn values(&self) -> &[(&'static str, Value)] {
        &self.values
    }

    fn and(mut self, name: &'static str, value: Value) -> Self {
        debug_assert!(self.template.places().any(|place| place == name), "no place for {name} in {:?}", self.template);
        self.values.push((name, value));
        self
    }

    /// Formats the sentence in a language; what that has no text for stays English. A place without a value is left empty.
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
            Value::Said(sentence) => sentence.to_text(locale),
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

    /// German of these texts, with a decimal comma.
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
        // A name with braces is no place.
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
