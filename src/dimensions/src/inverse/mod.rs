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
use dashpot_identification::model_file::ModelFile;

/// What is said of a quantity that does not rest on records alone.
const PRIOR: &str = "the fit had a prior of the dimensions for it";

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
            quantity.note =
                [quantity.note.as_str(), PRIOR].into_iter().filter(|n| !n.is_empty()).collect::<Vec<_>>().join("; ");
        }
    }
    to
}
