//! The graphical user interface, comparable to the software of a shock dyno. It opens, plots, tunes, fits, validates,
//! diagnoses and exports records and a model. Each of its functions is also a verb of the command `dashpot`.
//!
//! | module | contents |
//! |---|---|
//! | [`session`] | all open data and running tasks, without a window |
//! | [`views`] | the views, one file each |
//! | [`words`] | all texts, in every language |
//! | [`app`] | the window: views of a session |
//! | [`drawing`] | graphics backends |
//! | [`dialogs`] | dialogs for files |
//! | [`units`] | conversion from SI to the units on screen |
//! | [`format`] | numbers and sentences in the language and the units on screen |
//! | [`restated`] | sentences of the reports in the units on screen |

pub mod app;
pub mod dialogs;
pub mod drawing;
pub mod format;
pub mod restated;
pub mod session;
pub mod units;
pub mod views;
pub mod words;

#[cfg(test)]
mod ui_tests;
