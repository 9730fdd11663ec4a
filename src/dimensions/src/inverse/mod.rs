//! Inverse formulas: gas, oil and valves of a damper from an identified model, with 95 % intervals.

mod contradictions;
mod errors;
mod gas;
mod model;
mod oil;
mod report;
mod valves;

pub use report::{Cause, Contradiction, Explanation, Gap, Quantity};

use crate::dimensions::Dimensions;
use crate::phrases;
use dashpot_identification::model_file::ModelFile;
use dashpot_messages::Sentence;

/// Determines physical quantities of a damper from its model and its drawing, and contradictions between model and
/// drawing.
///
/// The intervals include the uncertainties of model file, drawing and handbook data, and the form error of the model.
pub fn explain(model: &ModelFile, drawing: &Dimensions) -> Explanation {
    let mut to = Explanation::default();
    let model = model::Identified(model);
    gas::explain(&model, drawing, &mut to);
    oil::explain(&model, drawing, &mut to);
    valves::explain(&model, drawing, &mut to);
    contradictions::explain(&model, drawing, &mut to);
    let mut doubted: Vec<&'static str> =
        to.contradictions.iter().flat_map(|found| found.likely_causes().map(|cause| cause.entry)).collect();
    doubted.sort_unstable();
    doubted.dedup();
    let doubt = |quantity: &Quantity| quantity.from.iter().find_map(|name| model.doubtful_effect(name));
    let direct: Vec<_> = to.quantities.iter().filter_map(|quantity| Some((quantity.name, doubt(quantity)?))).collect();
    for quantity in &mut to.quantities {
        let own: Vec<&str> = quantity.from.iter().copied().filter(|name| doubted.contains(name)).collect();
        if !own.is_empty() {
            quantity.add_note(Sentence::from(phrases::IN_DOUBT).with_names("entries", own, phrases::COMMA));
        }
        // A quantity may follow from a parameter of the model, or from another quantity.
        let of_quantity =
            |name: &str| direct.iter().find(|(quantity, _)| *quantity == name).map(|(_, doubt)| doubt.clone());
        let doubt = quantity.from.iter().find_map(|name| model.doubtful_effect(name).or_else(|| of_quantity(name)));
        if let Some((effect, probability)) = doubt {
            let doubt = Sentence::from(phrases::DOUBTFUL_EFFECT);
            quantity.add_note(doubt.with("effect", effect).with("probability", probability));
        }
        if quantity.from.iter().any(|name| model.had_prior(name)) {
            quantity.add_note(phrases::HAD_PRIOR.into());
        }
    }
    to
}
