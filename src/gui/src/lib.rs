//! The window: what dyno software is to a test engineer. Records and a model are opened, looked at, tuned by hand, fitted,
//! validated, diagnosed and exported; everything it does is a verb of the command too.
//!
//! | module | what |
//! |---|---|
//! | [`session`] | everything that is open and under way, without a window |
//! | [`views`] | what is drawn, one file a view |
//! | [`words`] | every text, in every language |
//! | [`app`] | the window itself: views arranged around a session |
//! | [`drawing`] | by what it is drawn |
//! | [`dialogs`] | files that the user names |
//! | [`units`] | SI inside, an engineer's units on the screen |

pub mod app;
pub mod dialogs;
pub mod drawing;
pub mod session;
pub mod units;
pub mod views;
pub mod words;

#[cfg(test)]
mod ui_tests;
