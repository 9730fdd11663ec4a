//! Messages with ids and arguments. Their texts are in Fluent files, one for each language.
//!
//! Code names a message by its id and passes its arguments as formatted texts. A [`Catalog`] contains the texts of a language. Ids are made
//! from the names of constants and fields ([`id!`]), so a wrong id does not compile. [`file::faults`] compares a file with the code's messages.

mod catalog;
pub mod file;
mod id;
mod interface;
mod kept;
mod number;
mod sentence;

pub use catalog::Catalog;
pub use id::{Message, kebab};
pub use kept::{Kept, Restorer};
pub use number::{format_decimals, format_number};
pub use sentence::{Locale, Sentence, Template, is_number, word_id};
