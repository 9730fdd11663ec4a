//! Messages with ids and arguments, and their texts in Fluent files, one a language.
//!
//! Code names a message by its id and gives its arguments as finished texts; a [`Catalog`] has the text of the language. Ids come from the
//! names of constants and fields ([`id!`]), so that code cannot misspell one; [`file::faults`] compares a file with what the code asks for.

mod catalog;
pub mod file;
mod id;
mod interface;
mod kept;
mod sentence;

pub use catalog::Catalog;
pub use id::{Message, kebab};
pub use kept::{Kept, Restorer};
pub use sentence::{Locale, Sentence, Template, is_number, word_id};
