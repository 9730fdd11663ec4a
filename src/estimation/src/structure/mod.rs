//! Structures: which effects a model has, in which forms, and the search for the most probable one.
//!
//! | module | what |
//! |---|---|
//! | [`context`], [`component`] | what a search works on; a structure; one effect of it |
//! | [`budget`] | how much a step of the search may spend |
//! | [`starts`], [`inventory`] | where a search starts; what each effect carries |
//! | [`evidence`], [`prior_odds`] | how probable the records are under a structure, and the structure beforehand |
//! | [`extend`] | a hypothesis with one more effect |
//! | [`screening`] | first-order gain of every start of every effect |
//! | [`halving`] | refits of the promising ones by successive halving |
//! | [`expansion`] | all structures with one more effect than a given one |
//! | [`search`] | add, remove, swap and change of form, from several starts; the table of visited structures |
//! | [`alternatives`] | structures that the records do not rule out, and how far they leave numbers open |
//! | [`curve_points`], [`curve_at_rest`], [`series_restart`], [`coordinate_search`], [`nearby`] | what refits need |

pub mod alternatives;
pub mod budget;
pub mod component;
pub mod context;
pub mod coordinate_search;
pub mod curve_at_rest;
pub mod curve_points;
pub mod evidence;
pub mod expansion;
pub mod extend;
pub mod halving;
pub mod inventory;
pub mod nearby;
pub mod prior_odds;
pub mod screening;
pub mod search;
pub mod series_restart;
pub mod starts;
