//! Structures: the effects of a model with their forms, and the search for the most probable structure.
//!
//! | module | contents |
//! |---|---|
//! | [`context`], [`component`] | inputs of a search, a structure; one effect of a structure |
//! | [`budget`] | limits of the cost of a search step |
//! | [`starts`], [`inventory`] | starts of a search; the force of each effect |
//! | [`evidence`], [`prior_odds`] | probability of the records under a structure; prior probability of the structure |
//! | [`extend`] | a hypothesis with one more effect |
//! | [`screening`] | first-order gain of every start of every effect |
//! | [`halving`] | refits of the promising starts by successive halving |
//! | [`expansion`] | all structures with one more effect than a given structure |
//! | [`search`] | add, remove, swap and change of form, from several starts; the table of visited structures |
//! | [`without_doubtful`] | the proposed model: the most probable structure, without doubtful additions |
//! | [`alternatives`] | structures that the records do not rule out, and the intervals over them |
//! | [`curve_points`], [`curve_at_rest`], [`series_restart`], [`coordinate_search`], [`nearby`] | methods for the refits |

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
pub mod without_doubtful;
