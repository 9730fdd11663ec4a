//! Effects that a diagnosis can name, each with its additional parameters and their starts.
//!
//! One effect may have several forms (a cap on rebound or on compression, a stop of rubber or of oil). All forms have
//! one name, and the form with the best fit represents the effect.

mod base;
mod changes;
mod friction;
mod oil;
mod rig;
mod series;
mod springs;
mod stops;
mod unnamed;
mod valves;

pub use base::base_numbers;
pub use changes::changes;
pub use series::CARRIES_WHOLE;

use crate::hypothesis::Free;
use crate::measurement::Artefact;
use crate::scale::Scale;
use crate::situation::Situation;
use crate::unknowns::Unknown;
use dashpot_core::parameter::{Element, Number};

/// A parameter that an effect adds.
#[derive(Debug, Clone)]
pub struct Fresh {
    /// The parameter.
    pub free: Free,
    /// Range of values that are plausible for a damper or a rig. The report mentions a result outside the range. If the
    /// lower end is 0, no value is too small.
    pub plausible: (f64, f64),
    /// Prior standard deviation of the logarithm of a cooling rate or heat capacity; the mean is the logarithm of the
    /// start value. For a parameter of the model, the deviation has no effect, because [`crate::priors`] contains its
    /// prior.
    pub deviation: Option<f64>,
}

/// Start of the refit of a candidate.
#[derive(Debug, Clone)]
pub struct Start {
    /// Values of the new parameters in physical units, in the order of the parameters.
    pub values: Vec<f64>,
    /// Factors on parameters of the base model. They are needed because the fitted base model has absorbed a part of
    /// the effect.
    pub moves: Vec<(Number, f64)>,
    /// Linear extension of one stroke of the FV curve. It is needed because the fitted curve has absorbed a force cap.
    pub unbend: Option<LinearExtension>,
    /// Side (+1 rebound, −1 compression) on which a lookup spring is extended linearly. The extension is needed because
    /// the end of the fitted spring has absorbed a stop.
    pub straighten: Option<f64>,
    /// Start forces of the points of the FV curve, N. If empty, the points start from their current forces.
    pub curve: Vec<f64>,
    /// Force, N, by which the step of the FV curve at zero velocity is reduced. The reduction is needed because the
    /// curve already contains a part of the friction that the effect adds.
    pub level: f64,
}

/// A linear extension of one stroke of the FV curve.
#[derive(Debug, Clone)]
pub struct LinearExtension {
    /// Stroke: +1 rebound, −1 compression.
    pub stroke: f64,
    /// Force up to which the curve counts as correct on this stroke, N, positive.
    pub from: f64,
    /// Smallest slope of the extension, as a fraction of the slope of the curve just below the force `from`.
    pub steepness: f64,
}

impl Start {
    fn at(values: &[f64]) -> Start {
        Start {
            values: values.to_vec(),
            moves: Vec::new(),
            unbend: None,
            straighten: None,
            curve: Vec::new(),
            level: 0.0,
        }
    }

    /// Returns whether the start changes parameters of the model to which the effect is added.
    pub fn moves_the_base(&self) -> bool {
        !self.moves.is_empty()
            || self.unbend.is_some()
            || self.straighten.is_some()
            || !self.curve.is_empty()
            || self.level > 0.0
    }

    fn moving(values: &[f64], moves: &[(Number, f64)]) -> Start {
        Start {
            values: values.to_vec(),
            moves: moves.to_vec(),
            unbend: None,
            straighten: None,
            curve: Vec::new(),
            level: 0.0,
        }
    }
}

/// One form of one effect.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// Name of the effect.
    pub effect: &'static str,
    /// Name of the form. Empty if the effect has only one form.
    pub form: &'static str,
    /// Elements that the effect enables.
    pub elements: &'static [Element],
    /// Parameters that the effect sets to fixed values.
    pub fixed: Vec<(Number, f64)>,
    /// Parameters that the effect makes free.
    pub fresh: Vec<Fresh>,
    /// Starts of the candidate's refits.
    pub starts: Vec<Start>,
    /// Whether the effect makes the force jump at positions that its parameters determine.
    pub jumps: bool,
    /// Kind of an unnamed error. Such a candidate is never added, but competes with known effects. If the unnamed error
    /// explains a deviation better than every known effect, the diagnosis names no effect for it.
    pub unnamed: Option<Unnamed>,
}

/// Unnamed measurement error, for which the vocabulary contains no effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Unnamed {
    /// Friction that increases with the force, such as that of tilted guides.
    Guides,
    /// Hysteresis of the load cell.
    LoadCell,
    /// A resonance in the force path.
    Resonance,
}

impl Fresh {
    /// Returns the factor from a car damper to a damper of size `scale` for the values of the parameter.
    fn factor(&self, scale: Scale) -> f64 {
        match &self.free {
            Free::Model(Unknown::Log(number) | Unknown::Linear(number) | Unknown::Above(number, _)) => {
                scale.of_number(*number)
            }
            Free::Model(Unknown::Rise { .. }) | Free::HeatCapacity => scale.force(),
            Free::Rig(artefact) => scale.of_artefact(*artefact),
            Free::Model(Unknown::Entry(..)) | Free::Cooling | Free::Shift(_) | Free::Curve(_) => 1.0,
        }
    }

    fn grow(&mut self, scale: Scale) {
        let (factor, (low, high)) = (self.factor(scale), self.plausible);
        self.plausible = (factor * low, factor * high);
        if let Free::Rig(Artefact::Loop(width)) = &mut self.free {
            *width = ((f64::from(*width) * scale.force()).round() as u32).max(1);
        }
    }
}

impl Candidate {
    /// Scales the candidate from a car damper to a damper of size `scale`.
    fn grow(&mut self, scale: Scale) {
        for start in &mut self.starts {
            for (value, fresh) in start.values.iter_mut().zip(&self.fresh) {
                *value *= fresh.factor(scale);
            }
            if let Some(drawn) = &mut start.unbend {
                drawn.from *= scale.force();
            }
            start.level *= scale.force();
            start.curve.iter_mut().for_each(|force| *force *= scale.force());
        }
        self.fixed.iter_mut().for_each(|(number, value)| *value *= scale.of_number(*number));
        self.fresh.iter_mut().for_each(|fresh| fresh.grow(scale));
    }

    /// Returns whether the candidate enables no element: an error of the rig, or a change from a reference damper.
    pub fn is_artefact(&self) -> bool {
        self.elements.is_empty()
    }
}

fn fresh(free: Free, plausible: (f64, f64)) -> Fresh {
    Fresh { free, plausible, deviation: None }
}

fn log(number: Number, plausible: (f64, f64)) -> Fresh {
    fresh(Free::Model(Unknown::Log(number)), plausible)
}

fn held(number: Number, plausible: (f64, f64), deviation: f64) -> Fresh {
    Fresh { deviation: Some(deviation), ..log(number, plausible) }
}

fn linear(number: Number, plausible: (f64, f64)) -> Fresh {
    fresh(Free::Model(Unknown::Linear(number)), plausible)
}

/// Makes the parameter of a force that exceeds another force by a free ratio.
fn above(number: Number, below: Number, plausible: (f64, f64)) -> Fresh {
    fresh(Free::Model(Unknown::Above(number, below)), plausible)
}

/// Makes a weakly determined parameter near its expected value. `deviation` has the unit of the parameter; like all
/// deviations of model parameters, it has no effect on the search.
fn near(number: Number, plausible: (f64, f64), deviation: f64) -> Fresh {
    Fresh { deviation: Some(deviation), ..linear(number, plausible) }
}

/// Makes an effect with the name of the first of its elements.
fn candidate(elements: &'static [Element], fresh: Vec<Fresh>, starts: Vec<Start>) -> Candidate {
    let effect = elements.first().map_or("", |element| element.name());
    Candidate { effect, form: "", elements, fixed: Vec::new(), fresh, starts, jumps: false, unnamed: None }
}

/// Makes a measurement error.
fn of_the_rig(artefact: Artefact, fresh: Vec<Fresh>, starts: Vec<Start>) -> Candidate {
    Candidate { effect: artefact.name(), ..candidate(&[], fresh, starts) }
}

fn grid(a: &[f64], b: &[f64]) -> Vec<Start> {
    a.iter().flat_map(|a| b.iter().map(|b| Start::at(&[*a, *b]))).collect()
}

/// Returns all candidates that could be added in a situation: effects of disabled elements, errors of the rig, and
/// unnamed errors.
pub fn candidates(s: &Situation) -> Vec<Candidate> {
    // All plausible ranges and starts apply to a car damper. For another damper, the candidates are made for a car
    // damper and then scaled.
    if !s.scale.is_car() {
        let mut all = candidates(&s.as_car());
        all.iter_mut().for_each(|candidate| candidate.grow(s.scale));
        return all;
    }
    let mut all = Vec::new();
    springs::springs(&mut all, s);
    friction::friction(s, &mut all);
    series::series(s, &mut all);
    oil::oil(s, &mut all);
    valves::valves(s, &mut all);
    stops::stops(s, &mut all);
    rig::rig(s, &mut all);
    unnamed::unnamed(&mut all);
    all.retain(|c| c.elements.first().is_none_or(|element| !s.base.is_on(*element)));
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::Params;
    use dashpot_core::element;

    #[test]
    fn every_start_has_a_value_for_each_number() {
        let mut base = Params::new();
        base.enable(element!("stribeck_friction"), false);
        base.enable(element!("gas_preload"), false);
        let mut situation = Situation::new(&base, &[], &[]);
        (situation.reach, situation.clock_span, situation.pauses) = ((-0.05, 0.05), 100.0, vec![50]);
        situation.temperature_measured = true;
        for c in candidates(&situation) {
            assert!(!c.starts.is_empty() && c.starts.iter().all(|s| s.values.len() == c.fresh.len()), "{c:?}");
        }
    }
}
