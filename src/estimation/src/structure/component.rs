//! Components of a structure: each is an effect in one of its forms, with its elements and its free parameters.

use crate::hypothesis::{self, Free, Hypothesis};
use crate::priors::is_force_of_effect;
use crate::unknowns::{CurveName, Unknown};
use crate::vocabulary::{CARRIES_WHOLE, Candidate};
use dashpot_core::parameter::{Element, Number};
use dashpot_core::{element, number};

/// One effect of a structure.
#[derive(Debug, Clone, PartialEq)]
pub struct Component {
    /// Name of the effect.
    pub effect: &'static str,
    /// Form of the effect. Empty if the effect has only one form, or if the given model does not state the form.
    pub form: &'static str,
    /// Elements that the effect enables. Empty for a measurement error and for a change from a reference damper.
    pub elements: Vec<Element>,
    /// Parameters that the effect sets to fixed values.
    pub fixed: Vec<(Number, f64)>,
    /// Parameters that the effect makes free.
    pub frees: Vec<Free>,
    /// Number of free parameters. Weakly determined parameters count half.
    pub numbers: f64,
}

/// Parameters about which records contain little information. They stay near their prior and count half.
const WEAK: [Number; 34] = [
    number!("series_damping"),
    number!("internal_mass"),
    number!("coulomb_steepness"),
    number!("stribeck_breakaway_velocity"),
    number!("stribeck_fall"),
    number!("presliding_length"),
    number!("presliding_power"),
    number!("presliding_creep"),
    number!("gas_length"),
    number!("gas_thermal_time"),
    number!("free_play_force"),
    number!("free_play_load"),
    number!("bushing_loss_time"),
    number!("bushing_slip"),
    number!("bushing_slow_time"),
    number!("oil_shortening"),
    number!("aeration_force"),
    number!("aeration_compression"),
    number!("cavitation_expansion"),
    number!("cavitation_velocity"),
    number!("bypass_half_width"),
    number!("bypass_blend"),
    number!("fade_laminar_force"),
    number!("heat_capacity"),
    number!("fsd_force"),
    number!("fsd_laminar_force"),
    number!("valve_width"),
    number!("valve_play"),
    number!("valve_damping"),
    number!("bump_stop_progression"),
    number!("rebound_stop_progression"),
    number!("bump_stop_damping"),
    number!("rebound_stop_damping"),
    number!("moving_mass_time"),
];

/// Returns the element to which a free parameter belongs. Returns `None` for parameters of the measurement and of the
/// FV curve, and for changes from a reference damper.
pub fn element_of(free: &Free) -> Option<Element> {
    let element = match free {
        Free::Model(Unknown::Log(number) | Unknown::Linear(number) | Unknown::Above(number, _)) => {
            number.row().element()
        }
        Free::Model(Unknown::Rise { curve: CurveName::Spring, .. }) => Some(element!("parallel_spring")),
        Free::Model(Unknown::Entry(list, _)) => list.row().element(),
        Free::Cooling | Free::HeatCapacity => Some(element!("temperature_fade")),
        Free::Model(Unknown::Rise { .. }) | Free::Rig(_) | Free::Shift(_) | Free::Curve(_) => None,
    };
    element.filter(|element| *element != element!("fv_curve"))
}

/// Returns the number of parameters as which a free parameter counts: 0.5 if it is weakly determined, else 1.
pub fn weight(free: &Free) -> f64 {
    match free {
        Free::Model(Unknown::Log(number) | Unknown::Linear(number)) if WEAK.contains(number) => 0.5,
        Free::Model(Unknown::Above(..)) | Free::Cooling | Free::HeatCapacity => 0.5,
        _ => 1.0,
    }
}

impl Component {
    /// Makes the component that a candidate adds.
    pub fn of_candidate(candidate: &Candidate) -> Component {
        Component {
            effect: candidate.effect,
            form: candidate.form,
            elements: candidate.elements.to_vec(),
            fixed: candidate.fixed.clone(),
            frees: candidate.fresh.iter().map(|fresh| fresh.free.clone()).collect(),
            numbers: candidate.fresh.iter().map(|fresh| weight(&fresh.free)).sum(),
        }
    }

    /// Returns the components of a given model: one for each enabled element except the FV curve, and one for each
    /// measurement error.
    pub fn of_model(of: &Hypothesis) -> Vec<Component> {
        let mut all: Vec<Component> = Element::all()
            .filter(|element| of.base.is_on(*element) && *element != element!("fv_curve"))
            .map(|element| {
                let own = of.numbers.iter().filter(|n| element_of(&n.free) == Some(element));
                let frees: Vec<Free> = own.map(|n| n.free.clone()).collect();
                let numbers = frees.iter().map(weight).sum();
                let carries_whole =
                    element == element!("series_compliance") && of.base.number(number!("series_load")) == 1.0;
                Component {
                    effect: element.name(),
                    form: if carries_whole { CARRIES_WHOLE } else { "" },
                    elements: vec![element],
                    fixed: if carries_whole { vec![(number!("series_load"), 1.0)] } else { Vec::new() },
                    frees,
                    numbers,
                }
            })
            .collect();
        all.extend(of.numbers.iter().filter_map(|n| match n.free {
            Free::Rig(artefact) => Some(Component {
                effect: artefact.name(),
                form: "",
                elements: Vec::new(),
                fixed: Vec::new(),
                frees: vec![n.free.clone()],
                numbers: 1.0,
            }),
            _ => None,
        }));
        all
    }

    /// Returns whether all force parameters of the component are at a lower bound of zero at `theta`. The structure is
    /// then equivalent to the structure without the component. Returns `false` if the component has no free force
    /// parameter.
    pub fn is_absent(&self, of: &Hypothesis, theta: &[f64]) -> bool {
        let mut forces = of.numbers.iter().zip(theta).filter(|(number, _)| {
            let Free::Model(Unknown::Linear(force)) = number.free else { return false };
            is_force_of_effect(force)
                && element_of(&number.free).is_some_and(|element| self.elements.contains(&element))
        });
        let is_zero =
            |(number, value): (&hypothesis::Number, &f64)| *value <= number.bounds.0 && number.bounds.0 <= 0.0;
        forces.next().is_some_and(|first| is_zero(first) && forces.all(is_zero))
    }

    /// Returns whether the component enables no element: a measurement error, or a change from a reference damper.
    pub fn is_of_measurement(&self) -> bool {
        self.elements.is_empty()
    }

    /// Returns a hypothesis at `theta` without this component.
    pub fn remove(&self, from: &Hypothesis, theta: &[f64]) -> Hypothesis {
        let mut to = from.clone().starting_at(theta);
        for element in &self.elements {
            to.base.enable(*element, false);
        }
        for (number, _) in &self.fixed {
            let _ = to.base.set(*number, number.default());
        }
        to.numbers.retain(|n| {
            !self.frees.contains(&n.free) && element_of(&n.free).is_none_or(|element| !self.elements.contains(&element))
        });
        to
    }
}
