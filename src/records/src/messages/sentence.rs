//! Translatable sentences: an English text with placeholders, and the values of the placeholders.
//!
//! Scripts and the terminal use the English text. A user interface looks up the text in another language and inserts
//! the same values. [`Reader`] converts an English text back to the sentence and templates from which it was made.

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::{BTreeSet, HashSet};
use std::fmt;

/// A text with a placeholder `{name}` for each value. Only [`phrases!`](super::phrases) makes templates, so that its
/// list is complete.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Template(&'static str);

impl Template {
    /// Makes a template. Only [`phrases!`](super::phrases) may call this function, because the test of the translations
    /// covers only its list.
    #[doc(hidden)]
    pub const fn listed(english: &'static str) -> Template {
        Template(english)
    }

    /// Returns the English text.
    pub fn english(self) -> &'static str {
        self.0
    }
}

/// A template split at its placeholders.
#[derive(Debug)]
struct Pieces {
    template: Template,
    /// The text before the first placeholder.
    first: &'static str,
    /// Each placeholder with the text that follows it.
    places: Vec<(&'static str, &'static str)>,
    /// Number of bytes of the template's own text. A match is more certain if this number is larger.
    own: usize,
    /// Whether the template's own text contains a word.
    speaks: bool,
}

impl Pieces {
    fn new(template: Template) -> Self {
        let mut pieces = template.0.split('{');
        let first = pieces.next().unwrap_or("");
        let places: Vec<_> = pieces.map(|piece| piece.split_once('}').unwrap_or((piece, ""))).collect();
        let own = first.len() + places.iter().map(|(_, behind)| behind.len()).sum::<usize>();
        let mut texts = std::iter::once(first).chain(places.iter().map(|(_, behind)| *behind));
        let speaks = texts.any(|own| own.chars().any(char::is_alphabetic));
        Pieces { template, first, places, own, speaks }
    }

    /// Returns whether a text has the beginning and the end of this template.
    fn may_enclose(&self, text: &str) -> bool {
        text.starts_with(self.first) && self.places.last().is_none_or(|(_, behind)| text.ends_with(behind))
    }

    /// Extracts the values of the placeholders from a text that was made with this template.
    ///
    /// If the text between two placeholders occurs several times, the first occurrence counts. Before the last
    /// placeholder, the last occurrence counts, so that the name in `{name} {figure}` may contain spaces. If there is
    /// no text between two placeholders, the second value begins where another sentence begins (`begins`), or is empty.
    fn taken_apart<'t>(&self, text: &'t str, begins: &dyn Fn(&str) -> bool) -> Option<Vec<(&'static str, &'t str)>> {
        let Some((last, between)) = self.places.split_last() else {
            return (text == self.first).then(Vec::new);
        };
        let mut rest = text.strip_prefix(self.first)?.strip_suffix(last.1)?;
        let mut values = Vec::with_capacity(self.places.len());
        for (k, (name, behind)) in between.iter().enumerate() {
            let at = match (behind.is_empty(), k + 1 == between.len()) {
                (true, _) => {
                    rest.char_indices().map(|(at, _)| at).find(|at| begins(&rest[*at..])).unwrap_or(rest.len())
                }
                (false, true) => rest.rfind(behind)?,
                (false, false) => rest.find(behind)?,
            };
            values.push((*name, &rest[..at]));
            rest = &rest[at + behind.len()..];
        }
        values.push((last.0, rest));
        Some(values)
    }
}

/// Defines the templates of a crate: each `NAME: "text with {places}";` is a constant, and `TEMPLATES` contains all of
/// them.
#[macro_export]
macro_rules! phrases {
    ($($name:ident: $text:literal;)*) => {
        $(pub(crate) const $name: $crate::sentence::Template = $crate::sentence::Template::listed($text);)*
        /// Every text with placeholders for values.
        pub(crate) const TEMPLATES: &[$crate::sentence::Template] = &[$($name),*];
    };
}

/// Returns the English texts of templates and the words, without duplicates.
pub fn each_once(templates: &[Template], words: impl IntoIterator<Item = &'static str>) -> Vec<&'static str> {
    let mut known = BTreeSet::new();
    let all = templates.iter().map(|template| template.english()).chain(words);
    all.filter(|text| known.insert(*text)).collect()
}

/// Template of a text without a translation.
const AS_IT_IS: Template = Template("{text}");

/// Placeholders of names. A name may look like a number: the name of a test may be 2.5.
const NAMES: &[&str] =
    &["at", "column", "file", "folder", "name", "names", "record", "test", "tests", "text", "twin", "version"];

/// Returns whether the value of a placeholder is a number, whose format depends on the language.
///
/// A number may have a sign and a unit after it. Names, command options and versions are not numbers.
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

/// Value of a placeholder in a sentence.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Value {
    /// A number ([`is_number`]), a unit, or the name of a test or an effect. The text is equal in all languages.
    AsIs(String),
    /// A word of this crate, which is translated, or a name such as a path, which stays unchanged.
    Word(String),
    /// A sentence within the sentence.
    Said(Sentence),
    /// Several values, with a separator.
    List(Vec<Value>, Template),
}

/// A sentence. Its serialized and displayed form is the English text. A deserialized sentence stays English.
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

/// Values of a sentence.
impl Sentence {
    /// Adds a number or a name.
    pub fn with(self, name: &'static str, value: impl ToString) -> Self {
        self.and(name, Value::AsIs(value.to_string()))
    }

    /// Adds a word of this crate.
    pub fn with_word(self, name: &'static str, word: &str) -> Self {
        self.and(name, Value::Word(word.to_owned()))
    }

    /// Adds another sentence.
    pub fn with_sentence(self, name: &'static str, sentence: impl Into<Sentence>) -> Self {
        self.and(name, Value::Said(sentence.into()))
    }

    /// Adds another sentence if it is not `None`. Otherwise the placeholder stays empty.
    pub fn with_any(self, name: &'static str, sentence: Option<Sentence>) -> Self {
        match sentence {
            Some(sentence) => self.with_sentence(name, sentence),
            None => self,
        }
    }

    /// Adds a list of names.
    pub fn with_names<T: ToString>(
        self,
        name: &'static str,
        names: impl IntoIterator<Item = T>,
        between: Template,
    ) -> Self {
        let list = names.into_iter().map(|n| Value::AsIs(n.to_string())).collect();
        self.and(name, Value::List(list, between))
    }

    /// Adds a list of sentences.
    pub fn with_list(self, name: &'static str, list: Vec<Sentence>, between: Template) -> Self {
        self.and(name, Value::List(list.into_iter().map(Value::Said).collect(), between))
    }

    /// Joins several sentences into one.
    pub fn list(list: Vec<Sentence>, between: Template) -> Self {
        Sentence::from(AS_IT_IS).with_list("text", list, between)
    }

    /// Makes a sentence from a text that is equal in all languages.
    pub fn as_it_is(text: impl ToString) -> Self {
        Sentence::from(AS_IT_IS).with("text", text)
    }

    /// Returns the template of the sentence.
    pub fn template(&self) -> Template {
        self.template
    }

    fn and(mut self, name: &'static str, value: Value) -> Self {
        debug_assert!(self.template.0.contains(&format!("{{{name}}}")), "no place for {name} in {:?}", self.template);
        self.values.push((name, value));
        self
    }

    /// Formats the sentence in a language.
    ///
    /// `translated` returns the translation of a text; unknown texts stay English. `value` formats a value. Its
    /// arguments are the name and the value. A placeholder without a value is left empty.
    pub fn to_text(
        &self,
        translated: &dyn Fn(&str) -> Option<&'static str>,
        value: &dyn Fn(&str, &str) -> String,
    ) -> String {
        let mut rest = translated(self.template.0).unwrap_or(self.template.0);
        let mut text = String::new();
        while let Some((before, after)) = rest.split_once('{') {
            text += before;
            let (name, behind) = after.split_once('}').unwrap_or((after, ""));
            if let Some((_, held)) = self.values.iter().find(|(n, _)| *n == name) {
                text += &held.said(name, translated, value);
            }
            rest = behind;
        }
        text + rest
    }
}

impl Value {
    fn said(
        &self,
        place: &str,
        translated: &dyn Fn(&str) -> Option<&'static str>,
        value: &dyn Fn(&str, &str) -> String,
    ) -> String {
        match self {
            Value::AsIs(text) => value(place, text),
            Value::Word(word) => translated(word).map_or_else(|| word.clone(), str::to_owned),
            Value::Said(sentence) => sentence.to_text(translated, value),
            Value::List(values, between) => {
                let all: Vec<String> = values.iter().map(|held| held.said(place, translated, value)).collect();
                all.join(translated(between.0).unwrap_or(between.0))
            }
        }
    }
}

/// Parser that finds the templates and words from which a text was made.
#[derive(Debug)]
pub struct Reader {
    templates: Vec<Pieces>,
    words: HashSet<&'static str>,
    /// Possible separators between the values of a list.
    between: Vec<Template>,
    /// Beginnings of sentences that may follow a value directly. Templates of such sentences begin with a separator,
    /// not with a word.
    beginnings: Vec<&'static str>,
}

impl Reader {
    /// Makes a reader for texts of these templates and words.
    pub fn new(templates: impl IntoIterator<Item = Template>, words: impl IntoIterator<Item = &'static str>) -> Reader {
        let templates: Vec<Pieces> = templates.into_iter().map(Pieces::new).collect();
        let between = templates.iter().filter(|t| t.places.is_empty()).map(|t| t.template).collect();
        let with_places = templates.iter().filter(|t| !t.places.is_empty()).map(|t| t.first);
        let beginnings = with_places.filter(|first| first.starts_with([' ', ',', ';', '(', ':'])).collect();
        Reader { templates, words: words.into_iter().collect(), between, beginnings }
    }

    /// Splits a text into the parts that match templates and words. Other parts stay unchanged. The English text of the
    /// result always equals the input.
    pub fn read(&self, text: &str) -> Sentence {
        match self.value(text) {
            Value::Said(sentence) => sentence,
            other => Sentence::from(AS_IT_IS).and("text", other),
        }
    }

    fn value(&self, text: &str) -> Value {
        if self.words.contains(text) {
            return Value::Word(text.to_owned());
        }
        self.list(text).or_else(|| self.sentence(text).map(Value::Said)).unwrap_or_else(|| Value::AsIs(text.to_owned()))
    }

    /// Returns whether a value is a known word or contains no letters.
    fn is_known(&self, value: &str) -> bool {
        self.words.contains(value) || !value.chars().any(char::is_alphabetic)
    }

    /// Returns whether a text begins with a sentence that may follow a value directly.
    fn begins(&self, text: &str) -> bool {
        self.beginnings.iter().any(|beginning| text.starts_with(beginning))
    }

    /// Matches a text with a template. If several match, the template with the longest own text has precedence.
    ///
    /// A template without a word, such as `{name} {figure}`, matches many texts. Such a match counts only if the values
    /// are known words, numbers or lists of these.
    fn sentence(&self, text: &str) -> Option<Sentence> {
        let mut fitting: Vec<_> = self
            .templates
            .iter()
            .filter(|pieces| pieces.own > 0)
            .filter_map(|pieces| Some((pieces, pieces.taken_apart(text, &|rest| self.begins(rest))?)))
            .collect();
        fitting.sort_by_key(|(pieces, _)| pieces.own);
        let (pieces, values) = fitting.into_iter().rev().find(|(pieces, values)| {
            pieces.speaks || values.iter().all(|(_, v)| self.is_known(v) || !matches!(self.value(v), Value::AsIs(_)))
        })?;
        Some(self.made_of(pieces, values))
    }

    /// Matches a list of sentences. All have one template, and their values are words and numbers.
    fn list(&self, text: &str) -> Option<Value> {
        let between = self.between.iter().filter(|between| text.contains(between.0));
        let lists = between.flat_map(|between| self.templates.iter().map(move |of| (between, of)));
        lists.filter(|(_, of)| of.own > 0 && of.may_enclose(text)).find_map(|(between, of)| {
            let (mut items, mut open) = (Vec::new(), String::new());
            for part in text.split(between.0) {
                open += part;
                match of.taken_apart(&open, &|rest| self.begins(rest)) {
                    Some(values) if values.iter().all(|(_, value)| self.is_known(value)) => {
                        items.push(Value::Said(self.made_of(of, values)));
                        open.clear();
                    }
                    // A name may contain the separator.
                    _ => open += between.0,
                }
            }
            (open.is_empty() && items.len() > 1).then_some(Value::List(items, *between))
        })
    }

    /// Makes the sentence of a template with these texts as values.
    fn made_of(&self, pieces: &Pieces, values: Vec<(&'static str, &str)>) -> Sentence {
        let values = values.into_iter().map(|(name, value)| (name, self.value(value))).collect();
        Sentence { template: pieces.template, values }
    }
}

impl fmt::Display for Sentence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.to_text(&|_| None, &|_, value| value.to_owned()))
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

    const TWO: Template = Template("{names} in {place}{note}");
    const NOTE: Template = Template(", {what}");
    const AND: Template = Template(" and ");

    fn german(text: &str) -> Option<&'static str> {
        match text {
            "{names} in {place}{note}" => Some("in {place}: {names}{note}"),
            " and " => Some(" und "),
            "rig" => Some("Prüfstand"),
            _ => None,
        }
    }

    fn comma(place: &str, value: &str) -> String {
        if is_number(place, value) { value.replace('.', ",") } else { value.to_owned() }
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
        const AT: Template = Template("{test}: {value} {unit} at {names}");
        let said = Sentence::from(AT).with("test", "2.5").with("value", "1.5").with("unit", "N");
        let said = said.with_names("names", ["0.1", "0.2"], NOTE);
        assert_eq!(said.to_text(&|_| None, &comma), "2.5: 1,5 N at 0.1, {what}0.2");
        assert_eq!(said.to_string(), "2.5: 1.5 N at 0.1, {what}0.2");
    }

    #[test]
    fn values_keep_their_places_in_every_language() {
        let sentence = Sentence::from(TWO).with_names("names", ["a", "{place}"], AND).with_word("place", "rig");
        // A name with braces is not a placeholder.
        assert_eq!(sentence.to_string(), "a and {place} in rig");
        assert_eq!(sentence.to_text(&german, &comma), "in Prüfstand: a und {place}");
        let noted = sentence.with_sentence("note", Sentence::from(NOTE).with("what", 3));
        assert_eq!(noted.to_string(), "a and {place} in rig, 3");
        assert_eq!(noted.to_text(&german, &comma), "in Prüfstand: a und {place}, 3");
    }

    #[test]
    fn a_text_is_taken_apart_as_it_was_made() {
        const CHOICE: Template = Template("{of}: {chosen} — error {error}{others}; {why}");
        const OTHERS: Template = Template(" ({others})");
        const OTHER: Template = Template("{name} {error}");
        const COMMA: Template = Template(", ");
        let words = ["friction", "none", "none, rigid", "Coulomb + viscous"];
        let reader = Reader::new([COMMA, OTHER, OTHERS, CHOICE], words);
        let other = |name, error: &str| Sentence::from(OTHER).with_word("name", name).with("error", error);
        for others in
            [vec![other("none", "2.10")], vec![other("none, rigid", "1.20"), other("Coulomb + viscous", "0.97")]]
        {
            let list = |others: &Vec<Sentence>| match &others[..] {
                [one] => Sentence::from(OTHERS).with_sentence("others", one.clone()),
                _ => Sentence::from(OTHERS).with_list("others", others.clone(), COMMA),
            };
            let made = Sentence::from(CHOICE)
                .with_word("of", "friction")
                .with_word("chosen", "none")
                .with("error", "0.93")
                .with_sentence("others", list(&others))
                .with("why", "the simplest");
            assert_eq!(reader.read(&made.to_string()), made);
        }
        for text in ["", "{", "by hand: nothing of ours", "none", ", , "] {
            assert_eq!(reader.read(text).to_string(), text);
        }
    }
}
