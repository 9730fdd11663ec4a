//! The effects that a diagnosis can name, each with the numbers it adds and where their search starts.
//!
//! One effect may come in several forms (a cap on rebound or on compression, a stop of rubber or of oil): they carry one
//! name, and the form that fits best speaks for it.

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

/// A number that an effect brings along.
#[derive(Debug, Clone)]
pub struct Fresh {
    /// What it is.
    pub free: Free,
    /// Values that a damper or a rig shows; a finding outside is told. From 0: however small.
    pub plausible: (f64, f64),
    /// Whether records leave it open by nature, so that it stays near what is usual: it then costs half of a free one. For heat, also the
    /// standard deviation of what is expected.
    pub deviation: Option<f64>,
}

/// Where a search begins.
#[derive(Debug, Clone)]
pub struct Start {
    /// Values of the fresh numbers in physical units, in their order.
    pub values: Vec<f64>,
    /// Numbers of the base that must move first, since the base stands where the effect hides: factors.
    pub moves: Vec<(Number, f64)>,
    /// A branch of the FV curve that is drawn on: a capped branch hides the cap.
    pub unbend: Option<LinearExtension>,
    /// A side (+1 rebound, −1 compression) on which a lookup spring is drawn on straight: a stop hides in its end.
    pub straighten: Option<f64>,
    /// Forces that the points of the FV curve start from, N; where they are instead if empty.
    pub curve: Vec<f64>,
    /// Force, N, by which the FV curve's step about standstill shrinks: friction that the effect takes over.
    pub level: f64,
}

/// A linear extension of a branch of the FV curve.
#[derive(Debug, Clone)]
pub struct LinearExtension {
    /// +1 rebound, −1 compression.
    pub stroke: f64,
    /// Force up to which it is trusted, N, positive.
    pub from: f64,
    /// Share of its slope there that it goes on with at least.
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

    /// Whether it moves numbers of the base.
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
    /// Which form, where there are several.
    pub form: &'static str,
    /// Elements that it switches on.
    pub elements: &'static [Element],
    /// Parameters that it sets and leaves.
    pub fixed: Vec<(Number, f64)>,
    /// Numbers that it frees.
    pub fresh: Vec<Fresh>,
    /// Where to search.
    pub starts: Vec<Start>,
    /// Whether it makes the force jump at places that its numbers say.
    pub jumps: bool,
    /// For a disagreement that has no name: what it looks like. It is never added; it keeps a known name from being given to
    /// what it explains better.
    pub unnamed: Option<Unnamed>,
}

/// A measurement error that the vocabulary has no name for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Unnamed {
    /// Friction that grows with the force, as of tilted guides.
    Guides,
    /// Hysteresis of the load cell.
    LoadCell,
    /// A resonance in the force path.
    Resonance,
}

impl Fresh {
    /// Factor by which its number grows with the damper.
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
    /// From what it is for a damper of a car to what it is for one of this size.
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

    /// Whether it is of the rig, not of the damper.
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

/// A force above another one, by a ratio that is free.
fn above(number: Number, below: Number, plausible: (f64, f64)) -> Fresh {
    fresh(Free::Model(Unknown::Above(number, below)), plausible)
}

/// Near an expected value by nature: `deviation` in its own unit.
fn near(number: Number, plausible: (f64, f64), deviation: f64) -> Fresh {
    Fresh { deviation: Some(deviation), ..linear(number, plausible) }
}

/// An effect that has the name of the first of its elements.
fn candidate(elements: &'static [Element], fresh: Vec<Fresh>, starts: Vec<Start>) -> Candidate {
    let effect = elements.first().map_or("", |element| element.name());
    Candidate { effect, form: "", elements, fixed: Vec::new(), fresh, starts, jumps: false, unnamed: None }
}

/// An effect that the measurement adds.
fn of_the_rig(artefact: Artefact, fresh: Vec<Fresh>, starts: Vec<Start>) -> Candidate {
    Candidate { effect: artefact.name(), ..candidate(&[], fresh, starts) }
}

fn grid(a: &[f64], b: &[f64]) -> Vec<Start> {
    a.iter().flat_map(|a| b.iter().map(|b| Start::at(&[*a, *b]))).collect()
}

/// All effects that could be added in a situation: those of elements that are not on, and those of the rig.
pub fn candidates(s: &Situation) -> Vec<Candidate> {
    // All sizes and starts are those of cars: for another damper they are put up for it as if it were one, and then grow to its size.
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
