//! Families made from structures that were found at single settings.

use super::pattern::{site_of, sites, varies};
use super::problem::{FamilyHypothesis, SettingTests};
use super::structure::FamilyStructure;
use crate::first_guess;
use crate::hypothesis::{Free, Hypothesis};
use crate::refit::{Effort, refit};
use crate::segment::Segment;
use crate::structure::component::Component;
use crate::structure::context::Structure;
use crate::structure::curve_points::{forces_at, with_velocities};
use crate::unknowns::{CurveName, Unknown, anchor, towards_zero};
use dashpot_core::curve::MAX_POINTS;
use dashpot_core::list;
use dashpot_core::parameter::{Number, table};
use dashpot_records::restrict;
use rayon::prelude::*;

/// Smallest ratio of the speed of a point that a search added at a knee to the speed of any other point. The search of
/// one setting adds points at least a factor of 1.13 from their neighbors. If the points of two settings are closer
/// than about half of that factor, they show the same knee. The curve would then have too few samples between them.
const APART: f64 = 1.06;

/// Returns the velocities of the FV table that all settings share, m/s.
///
/// The velocities are those for the tests of all settings, and those of the points that the search of any setting added
/// at its knees. With the former alone, a knee that moves with the setting would be rounded off.
pub fn velocities(settings: &[SettingTests], at_settings: &[&Structure]) -> Vec<f64> {
    let segments = |of: &SettingTests| of.tests.iter().map(|t| t.segment.clone()).collect::<Vec<Segment>>();
    let mut all = first_guess::velocities(&settings.iter().flat_map(segments).collect::<Vec<Segment>>());
    for (own, of) in at_settings.iter().zip(settings) {
        let plain = first_guess::velocities(&segments(of));
        for point in own.hypothesis.base.list(list!("fv_velocity")) {
            let is_apart = |other: &f64| other * point <= 0.0 || !(1.0 / APART..=APART).contains(&(point / other));
            if !plain.contains(point) && all.iter().all(is_apart) && all.len() < MAX_POINTS {
                all.push(*point);
            }
        }
    }
    all.sort_by(f64::total_cmp);
    all
}

/// Makes a family with the effects of one structure, in which every parameter varies if possible. At each setting,
/// parameters start from the structure of that setting if it contains them. Each setting is then refitted separately.
/// Returns `None` if a structure is not valid with an FV curve at `velocities`.
pub fn varying_family(
    from: &Structure,
    at_settings: &[&Structure],
    settings: &[SettingTests],
    velocities: &[f64],
) -> Option<(FamilyHypothesis, Vec<Component>)> {
    let template = Hypothesis { heating: None, ..with_velocities(&from.hypothesis, &from.refit.theta, velocities)? };
    let zero = anchor(velocities);
    let starts: Option<Vec<Vec<f64>>> = at_settings
        .par_iter()
        .zip(settings)
        .map(|(own, of)| {
            let forces = forces_at(&own.hypothesis.params(&own.refit.theta), velocities)?;
            let start: Vec<f64> = template
                .numbers
                .iter()
                .map(|number| {
                    let value = match &number.free {
                        Free::Model(Unknown::Rise { curve: CurveName::Fv, point }) => {
                            (forces[*point] - forces[towards_zero(*point, zero)]).abs()
                        }
                        free => own.hypothesis.position(free).map_or(number.start, |place| own.refit.theta[place]),
                    };
                    restrict(value, number.bounds.0, number.bounds.1)
                })
                .collect();
            let refitted = refit(&template, &of.tests, &start, None, Effort::JUDGE);
            Some(refitted.map_or(start, |refitted| refitted.theta))
        })
        .collect();
    let varies = varies(&template, &sites(&template));
    Some((FamilyHypothesis { template, varies, starts: starts? }, from.components.clone()))
}

/// Adds one effect to the family from a structure of one setting. Without `varies`, all settings share the parameters
/// of the effect. With `varies`, each setting has separate parameters where possible. Returns `None` if the structure
/// lacks the effect, or if `varies` is true but no parameter of the effect can vary.
pub fn with_effect(
    family: &FamilyStructure,
    source: &Structure,
    effect: &str,
    varies: bool,
) -> Option<(FamilyHypothesis, Vec<Component>)> {
    let component = source.components.iter().find(|c| c.effect == effect)?;
    let mut hypothesis = family.hypothesis.clone();
    let template = &mut hypothesis.template;
    for element in &component.elements {
        template.base.enable(*element, true);
        for row in table().filter(|row| row.element() == Some(*element)) {
            if let Ok(number) = Number::try_from(row) {
                let _ = template.base.set(number, source.hypothesis.base.number(number));
            }
        }
    }
    for (number, value) in &component.fixed {
        let _ = template.base.set(*number, *value);
    }
    let is_own = |free: &Free| component.frees.contains(free);
    let own = source.hypothesis.numbers.iter().zip(&source.refit.theta).filter(|(n, _)| is_own(&n.free));
    let mut can_vary = false;
    for (number, value) in own {
        if template.position(&number.free).is_none() {
            let varies = varies && site_of(&number.free).is_some();
            can_vary |= varies;
            template.numbers.push(number.clone());
            hypothesis.varies.push(varies);
            hypothesis.starts.iter_mut().for_each(|start| start.push(*value));
        }
    }
    let mut components = family.components.clone();
    components.push(component.clone());
    (can_vary || !varies).then_some((hypothesis, components))
}
