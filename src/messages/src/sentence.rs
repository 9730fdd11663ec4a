//! Sentences that can be said in any language: a message with its English text, and the values at the places of that. Scripts and the
//! terminal get the English; who writes for people has a [`Locale`] look the message up by its id and put the same values in. A sentence
//! that was written to a file in English is taken apart again by the templates that it was made of ([`Reader`]).

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::HashSet;
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

/// A template taken to pieces once.
#[derive(Debug)]
struct Pieces {
    template: Template,
    /// The text up to the first place.
    first: &'static str,
    /// Every place with the text behind it.
    places: Vec<(&'static str, &'static str)>,
    /// Letters that the template itself brings: the more, the surer is a text that fits it of it.
    own: usize,
    /// Whether it has a word of its own.
    speaks: bool,
}

impl Pieces {
    fn new(template: Template) -> Self {
        let mut pieces = template.english.split('{');
        let first = pieces.next().unwrap_or("");
        let places: Vec<_> = pieces.map(|piece| piece.split_once('}').unwrap_or((piece, ""))).collect();
        let own = first.len() + places.iter().map(|(_, behind)| behind.len()).sum::<usize>();
        let mut texts = std::iter::once(first).chain(places.iter().map(|(_, behind)| *behind));
        let speaks = texts.any(|own| own.chars().any(char::is_alphabetic));
        Pieces { template, first, places, own, speaks }
    }

    /// Whether a text begins and ends as this template does.
    fn may_enclose(&self, text: &str) -> bool {
        text.starts_with(self.first) && self.places.last().is_none_or(|(_, behind)| text.ends_with(behind))
    }

    /// What stands at the places in a text of this template. Where the text between two places occurs several times, the first one counts;
    /// before the last place the last one, so that of `{name} {figure}` the name may hold spaces. Where there is no text between two
    /// places, the second one begins where another sentence may (`begins`), or is empty.
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

/// A text that nobody can translate.
const AS_IT_IS: Template = Template::listed("", "{text}");

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
enum Value {
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
        Sentence::from(AS_IT_IS).with_list("text", list, between)
    }

    /// A text that stays as it is in every language.
    pub fn as_it_is(text: impl ToString) -> Self {
        Sentence::from(AS_IT_IS).with("text", text)
    }

    /// The text that it was made of.
    pub fn template(&self) -> Template {
        self.template
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

/// Takes texts apart by the templates and words that they were made of.
#[derive(Debug)]
pub struct Reader {
    templates: Vec<Pieces>,
    words: HashSet<&'static str>,
    /// What may stand between the values of a list.
    between: Vec<Template>,
    /// How a sentence begins that stands without a text before it: its template has a beginning of its own, which is no word.
    beginnings: Vec<&'static str>,
}

impl Reader {
    /// One for texts of these.
    pub fn new(templates: impl IntoIterator<Item = Template>, words: impl IntoIterator<Item = &'static str>) -> Reader {
        let templates: Vec<Pieces> = templates.into_iter().map(Pieces::new).collect();
        let between = templates.iter().filter(|t| t.places.is_empty()).map(|t| t.template).collect();
        let with_places = templates.iter().filter(|t| !t.places.is_empty()).map(|t| t.first);
        let beginnings = with_places.filter(|first| first.starts_with([' ', ',', ';', '(', ':'])).collect();
        Reader { templates, words: words.into_iter().collect(), between, beginnings }
    }

    /// A text taken apart, where templates and words fit it; what does not stays as it is. Its English is the text in any case.
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

    /// Whether a value is a word of the list or holds no letters.
    fn is_known(&self, value: &str) -> bool {
        self.words.contains(value) || !value.chars().any(char::is_alphabetic)
    }

    /// Whether a sentence that stands without a text before it may begin here.
    fn begins(&self, text: &str) -> bool {
        self.beginnings.iter().any(|beginning| text.starts_with(beginning))
    }

    /// By the template that leaves least to its places. One without a word of its own, such as `{name} {figure}`, fits much: it counts where
    /// its places hold words of the list, figures or a list of such.
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

    /// Several of one template, whose places hold words and figures.
    fn list(&self, text: &str) -> Option<Value> {
        let between = self.between.iter().filter(|between| text.contains(between.english));
        let lists = between.flat_map(|between| self.templates.iter().map(move |of| (between, of)));
        lists.filter(|(_, of)| of.own > 0 && of.may_enclose(text)).find_map(|(between, of)| {
            let (mut items, mut open) = (Vec::new(), String::new());
            for part in text.split(between.english) {
                open += part;
                match of.taken_apart(&open, &|rest| self.begins(rest)) {
                    Some(values) if values.iter().all(|(_, value)| self.is_known(value)) => {
                        items.push(Value::Said(self.made_of(of, values)));
                        open.clear();
                    }
                    // A name may hold what stands between names.
                    _ => open += between.english,
                }
            }
            (open.is_empty() && items.len() > 1).then_some(Value::List(items, *between))
        })
    }

    /// The sentence of a template with these texts at its places.
    fn made_of(&self, pieces: &Pieces, values: Vec<(&'static str, &str)>) -> Sentence {
        let values = values.into_iter().map(|(name, value)| (name, self.value(value))).collect();
        Sentence { template: pieces.template, values }
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

    #[test]
    fn a_text_is_taken_apart_as_it_was_made() {
        const CHOICE: Template = Template::listed("x", "{of}: {chosen} — error {error}{others}; {why}");
        const OTHERS: Template = Template::listed("x", " ({others})");
        const OTHER: Template = Template::listed("x", "{name} {error}");
        const COMMA: Template = Template::listed("x", ", ");
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
