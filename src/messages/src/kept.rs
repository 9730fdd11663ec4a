//! Storage of sentences in files, as ids of messages and their arguments. [`Restorer`] restores the sentences.

use crate::sentence::{Sentence, Template, Value};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, HashMap};

/// Stored form of a sentence, or of a value in a sentence.
///
/// A table with the key `id` is a sentence, and its other keys are the values. A table with `word` or `foreign` is a
/// word or an untranslated text. A table with `list` and `between` is a list of values. A plain text is a number or a
/// name.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Kept {
    /// A plain text, or the id of a message.
    Text(String),
    /// Values of a list.
    List(Vec<Kept>),
    /// A sentence, a word, an untranslated text or a list.
    Table(BTreeMap<String, Kept>),
}

impl From<&Sentence> for Kept {
    fn from(sentence: &Sentence) -> Kept {
        let values = sentence.values().iter().map(|(place, value)| ((*place).to_owned(), value.into()));
        Kept::table(values.chain([("id".to_owned(), Kept::Text(sentence.template().id().to_owned()))]))
    }
}

impl From<&Value> for Kept {
    fn from(value: &Value) -> Kept {
        let text = |key: &str, text: &str| Kept::table([(key.to_owned(), Kept::Text(text.to_owned()))]);
        match value {
            Value::AsIs(value) => Kept::Text(value.clone()),
            Value::Word(word) => text("word", word),
            Value::Foreign(foreign) => text("foreign", foreign),
            Value::Sentence(sentence) => sentence.into(),
            Value::List(values, between) => Kept::table([
                ("list".to_owned(), Kept::List(values.iter().map(Kept::from).collect())),
                ("between".to_owned(), Kept::Text(between.id().to_owned())),
            ]),
        }
    }
}

impl Kept {
    fn table(entries: impl IntoIterator<Item = (String, Kept)>) -> Kept {
        Kept::Table(entries.into_iter().collect())
    }

    fn text(&self) -> Option<&str> {
        match self {
            Kept::Text(text) => Some(text),
            _ => None,
        }
    }
}

/// Restorer of stored sentences, with the templates of all known messages by id.
#[derive(Debug)]
pub struct Restorer(HashMap<&'static str, Template>);

impl Restorer {
    /// Makes a restorer for sentences of the given templates.
    pub fn new(templates: impl IntoIterator<Item = Template>) -> Restorer {
        let all = templates.into_iter().chain([Sentence::AS_IT_IS]);
        Restorer(all.map(|template| (template.id(), template)).collect())
    }

    /// Restores a sentence. Returns `None` if the sentence comes from a version with other messages or arguments.
    pub fn restore(&self, kept: &Kept) -> Option<Sentence> {
        let Kept::Table(entries) = kept else { return None };
        let template = *self.0.get(entries.get("id")?.text()?)?;
        let values = entries.iter().filter(|(place, _)| *place != "id").map(|(name, value)| {
            let place = template.places().find(|place| place == name)?;
            Some((place, self.value(value)?))
        });
        Some(Sentence::from_parts(template, values.collect::<Option<_>>()?))
    }

    /// Restores the sentences of a file. The keys of the result are their English texts.
    pub fn by_english(&self, kept: &[Kept]) -> HashMap<String, Sentence> {
        let all = kept.iter().filter_map(|kept| self.restore(kept));
        all.map(|sentence| (sentence.to_string(), sentence)).collect()
    }

    /// Restores the sentence of a file that has this English text. Without such a sentence, the text itself is
    /// returned.
    pub fn find(&self, english: &str, kept: &[Kept]) -> Sentence {
        let mut all = kept.iter().filter_map(|kept| self.restore(kept));
        all.find(|sentence| sentence.to_string() == english).unwrap_or_else(|| Sentence::as_it_is(english))
    }

    fn value(&self, kept: &Kept) -> Option<Value> {
        let entries = match kept {
            Kept::Text(text) => return Some(Value::AsIs(text.clone())),
            Kept::List(_) => return None,
            Kept::Table(entries) => entries,
        };
        let text = |key: &str| entries.get(key)?.text();
        if let (Some(Kept::List(values)), Some(between)) = (entries.get("list"), text("between")) {
            let values = values.iter().map(|value| self.value(value)).collect::<Option<_>>()?;
            return Some(Value::List(values, *self.0.get(between)?));
        }
        let word = text("word").map(|word| Value::Word(word.to_owned()));
        let foreign = || text("foreign").map(|foreign| Value::Foreign(foreign.to_owned()));
        word.or_else(foreign).or_else(|| self.restore(kept).map(Value::Sentence))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHOICE: Template = Template::listed("choice", "{of}: {chosen} — error {error}{others}; {why}");
    const OTHERS: Template = Template::listed("others", " ({others})");
    const OTHER: Template = Template::listed("other", "{name} {error}");
    const COMMA: Template = Template::listed("comma", ", ");

    #[test]
    fn a_sentence_is_made_again_as_it_was() {
        let other = |name, error: &str| Sentence::from(OTHER).with_word("name", name).with("error", error);
        let made = Sentence::from(CHOICE)
            .with_word("of", "friction")
            .with("chosen", "none, rigid")
            .with("error", "0.93")
            .with_sentence(
                "others",
                Sentence::from(OTHERS).with_list(
                    "others",
                    vec![other("none", "2.10"), other("Coulomb + viscous", "0.97")],
                    COMMA,
                ),
            )
            .with_foreign("why", "the simplest");
        let all = Restorer::new([CHOICE, OTHERS, OTHER, COMMA]);
        for sentence in
            [made.clone(), Sentence::list(vec![other("a", "1"), made], COMMA), Sentence::as_it_is("by hand")]
        {
            let json = serde_json::to_string(&Kept::from(&sentence)).unwrap();
            let kept: Kept = serde_json::from_str(&json).unwrap();
            let english = sentence.to_string();
            assert_eq!(all.restore(&kept).as_ref().map(Kept::from), Some(Kept::from(&sentence)));
            let found = all.find(&english, std::slice::from_ref(&kept));
            assert_eq!((Kept::from(&found), found.to_string()), (Kept::from(&sentence), english.clone()));
            // `find` returns an unknown text unchanged: one that was changed by hand, or one whose message this version does not have.
            assert_eq!(all.find("changed", std::slice::from_ref(&kept)), Sentence::as_it_is("changed"));
            assert_eq!(Restorer::new([]).find(&english, &[kept]).to_string(), english);
        }
        for damaged in ["{\"id\": \"other\", \"what\": \"1\"}", "[]", "\"\"", "{\"id\": []}"] {
            assert_eq!(all.restore(&serde_json::from_str(damaged).unwrap()), None, "{damaged}");
        }
    }
}
