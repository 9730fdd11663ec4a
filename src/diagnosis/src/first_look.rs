//! The first look of a diagnosis, as it weighed every form: for whoever calibrates the rule.

use super::evidence;
use super::prepared::{Prepared, prepare};
use super::search::{Limits, search};
use dashpot_core::Params;
use dashpot_records::Record;

/// A form of an effect as the first look found it, for whoever studies how forms are to be weighed.
#[derive(Debug, Clone, serde::Serialize)]
pub struct Looked {
    /// Effect; empty for the model as it came.
    pub effect: &'static str,
    /// Form.
    pub form: &'static str,
    /// Whether it is a detector of something without a name.
    pub nameless: bool,
    /// Numbers beyond the base's, those near what is usual counted half.
    pub numbers: f64,
    /// Price of values that dampers do not show.
    pub implausibility: f64,
    /// Mean square left of each test, in units of what noise and curves leave.
    pub mean_squares: Vec<f64>,
}

/// The first look of a diagnosis.
pub fn first_look(records: &[&Record], held_out: &[bool], params: &Params) -> Option<Vec<Looked>> {
    let Prepared { fitted, base, .. } = prepare(records, held_out, params);
    let limits = Limits { effects: 0, allowed: &|_| true };
    let found = search(base, records, &fitted, &limits, &|_, _| ())?;
    let round = found.rounds.first()?;
    let of = |effect, form, nameless, w: &evidence::Weighed| Looked {
        effect,
        form,
        nameless,
        numbers: w.numbers,
        implausibility: w.implausibility,
        mean_squares: w.mean_squares.clone(),
    };
    let mut list = vec![of("", "", false, &round.before)];
    list.extend(
        round.tried.iter().map(|t| of(t.candidate.effect, t.candidate.form, t.candidate.unnamed.is_some(), &t.weighed)),
    );
    Some(list)
}
