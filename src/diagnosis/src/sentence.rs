//! Sentences that can be said in any language: an English text with the places of its values, and the values. Scripts and the terminal
//! get the English; who writes for people looks the text up in another language and puts the same values in.

use serde::{Serialize, Serializer};
use std::fmt;

/// A text with `{name}` where a value stands. Only [`super::phrases`] makes them, so that its list holds every one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Template(pub(super) &'static str);

impl Template {
    /// The English text.
    pub fn english(self) -> &'static str {
        self.0
    }
}

/// What stands at a place of a sentence.
#[derive(Debug, Clone, PartialEq)]
enum Value {
    /// A number, a unit, a name of a test or an effect: the same in every language.
    AsIs(String),
    /// A word of this crate, such as a path; the same in every language where it is no word but a name.
    Word(String),
    /// A sentence in the sentence.
    Said(Sentence),
    /// Several, with the text between them.
    List(Vec<Value>, Template),
}

/// A sentence. Serialized and shown, it is the English text.
#[derive(Debug, Clone, PartialEq, Default)]
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
    pub(super) fn with(self, name: &'static str, value: impl ToString) -> Self {
        self.and(name, Value::AsIs(value.to_string()))
    }

    /// With a word of this crate.
    pub(super) fn with_word(self, name: &'static str, word: &str) -> Self {
        self.and(name, Value::Word(word.to_owned()))
    }

    /// With another sentence.
    pub(super) fn with_said(self, name: &'static str, said: impl Into<Sentence>) -> Self {
        self.and(name, Value::Said(said.into()))
    }

    /// With another sentence where there is one; its place stays empty otherwise.
    pub(super) fn with_any(self, name: &'static str, said: Option<Sentence>) -> Self {
        match said {
            Some(said) => self.with_said(name, said),
            None => self,
        }
    }

    /// With names.
    pub(super) fn with_names<T: ToString>(
        self,
        name: &'static str,
        names: impl IntoIterator<Item = T>,
        between: Template,
    ) -> Self {
        let list = names.into_iter().map(|n| Value::AsIs(n.to_string())).collect();
        self.and(name, Value::List(list, between))
    }

    /// With several sentences.
    pub(super) fn with_list(self, name: &'static str, list: Vec<Sentence>, between: Template) -> Self {
        self.and(name, Value::List(list.into_iter().map(Value::Said).collect(), between))
    }

    fn and(mut self, name: &'static str, value: Value) -> Self {
        debug_assert!(self.template.0.contains(&format!("{{{name}}}")), "no place for {name} in {:?}", self.template);
        self.values.push((name, value));
        self
    }

    /// The sentence with every text as `translated` has it; what that does not know stays English. A place without a value is left empty.
    pub fn said(&self, translated: &dyn Fn(&str) -> Option<&'static str>) -> String {
        let mut rest = translated(self.template.0).unwrap_or(self.template.0);
        let mut text = String::new();
        while let Some((before, after)) = rest.split_once('{') {
            text += before;
            let (name, behind) = after.split_once('}').unwrap_or((after, ""));
            if let Some((_, value)) = self.values.iter().find(|(n, _)| *n == name) {
                text += &value.said(translated);
            }
            rest = behind;
        }
        text + rest
    }
}

impl Value {
    fn said(&self, translated: &dyn Fn(&str) -> Option<&'static str>) -> String {
        match self {
            Value::AsIs(text) => text.clone(),
            Value::Word(word) => translated(word).map_or_else(|| word.clone(), str::to_owned),
            Value::Said(sentence) => sentence.said(translated),
            Value::List(values, between) => {
                let all: Vec<String> = values.iter().map(|value| value.said(translated)).collect();
                all.join(translated(between.0).unwrap_or(between.0))
            }
        }
    }
}

impl fmt::Display for Sentence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.said(&|_| None))
    }
}

impl Serialize for Sentence {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
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

    #[test]
    fn values_keep_their_places_in_every_language() {
        let sentence = Sentence::from(TWO).with_names("names", ["a", "{place}"], AND).with_word("place", "rig");
        // A name with braces is no place.
        assert_eq!(sentence.to_string(), "a and {place} in rig");
        assert_eq!(sentence.said(&german), "in Prüfstand: a und {place}");
        let noted = sentence.with_said("note", Sentence::from(NOTE).with("what", 3));
        assert_eq!(noted.to_string(), "a and {place} in rig, 3");
        assert_eq!(noted.said(&german), "in Prüfstand: a und {place}, 3");
    }
}
