//! Starts of a search: models based on the records alone, and a given model.

use super::component::Component;
use crate::first_guess::{guess, size};
use crate::heating::Heating;
use crate::hypothesis::Hypothesis;
use crate::prior_set::PriorSet;
use crate::samples::Test;
use crate::segment::Segment;
use crate::vocabulary::base_numbers;
use dashpot_core::parameter::Element;
use dashpot_core::{Params, element, number};
use std::sync::Arc;

/// Series stiffnesses of a car damper, N/m: soft mount, oil column, stiff oil column. Between these values, the cost
/// has local maxima.
const STIFFNESSES: [f64; 3] = [6e5, 2.5e6, 1e7];

/// A model with its free parameters and components.
pub type StartModel = (Hypothesis, Vec<Component>);

/// Makes the start of a search from a model.
pub fn from_params(params: &Params, heating: &Arc<Heating>) -> StartModel {
    let hypothesis = Hypothesis {
        base: *params,
        numbers: base_numbers(params),
        heating: Some(heating.clone()),
        priors: PriorSet::default(),
    };
    let components = Component::of_model(&hypothesis);
    (hypothesis, components)
}

/// Makes models from the tests, each with an FV curve, gas and friction. There is one for each of three stiffnesses of
/// a series path, and one without a series path. Elements for which `may` is false stay disabled.
pub fn plain(tests: &[Test], heating: &Arc<Heating>, may: &dyn Fn(Element) -> bool) -> Vec<StartModel> {
    let segments: Vec<Segment> = tests.iter().map(|t| t.segment.clone()).collect();
    let first = guess(&segments);
    let scale = size(&segments).force();
    let with = |elements: &[Element], stiffness: Option<f64>| {
        let mut params = first;
        for element in elements.iter().filter(|element| may(**element)) {
            params.enable(*element, true);
        }
        if let Some(stiffness) = stiffness {
            let _ = params.set(number!("series_stiffness"), stiffness * scale);
        }
        // The power 1 is the simplest form of presliding friction.
        let _ = params.set(number!("presliding_power"), 1.0);
        from_params(&params, heating)
    };
    let friction = [element!("gas_preload"), element!("presliding_friction")];
    let whole = [friction[0], friction[1], element!("series_compliance")];
    let mut all: Vec<_> = STIFFNESSES.iter().map(|stiffness| with(&whole, Some(*stiffness))).collect();
    all.push(with(&friction, None));
    all
}
