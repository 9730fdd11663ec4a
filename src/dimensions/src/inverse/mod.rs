//! Inverse: what an identified model says of gas, oil and valves of its damper, with 95 % intervals.

mod contradictions;
mod errors;
mod gas;
mod model;
mod oil;
mod report;
mod valves;

pub use report::{Contradiction, Explanation, Gap, Quantity};

use crate::dimensions::Dimensions;
use crate::phrases;
use dashpot_identification::model_file::ModelFile;
use dashpot_messages::Sentence;

/// Explains a model by a drawing.
///
/// Intervals hold those of the model file, of the drawing and of the handbooks' oil data, and the error of the model's form.
pub fn explain(model: &ModelFile, drawing: &Dimensions) -> Explanation {
    let mut to = Explanation::default();
    let model = model::Identified(model);
    gas::explain(&model, drawing, &mut to);
    oil::explain(&model, drawing, &mut to);
    valves::explain(&model, drawing, &mut to);
    contradictions::explain(&model, drawing, &mut to);
    for quantity in &mut to.quantities {
        if quantity.from.iter().any(|name| model.had_prior(name)) {
            let all = quantity.note.take().into_iter().chain([phrases::HAD_PRIOR.into()]).collect();
            quantity.note = Some(Sentence::list(all, phrases::SEMICOLON));
        }
    }
    to
}
