//! Elements with a state that act on the mass in a stage: friction and gas behind a series path that carries the whole.
//!
//! In a stage the mass goes from where it is at the start of the substep to where the stage puts it, at constant
//! acceleration over the time of the stage. Each element knows its state after such a travel in closed form, so that the
//! method of the step does not integrate a contact that turns over within micrometres. The force rises with the place of
//! the mass: the stage has one answer.

use crate::assembly::Elements;
use crate::dual::{Dual, Real};
use crate::element::{StateVisitor, StatefulForce};
use crate::input::Travel;
use crate::state::MAX_INTERNAL;
use crate::tables::Tables;

/// Most elements with a state that act on the mass: presliding friction and the gas spring.
pub(super) const MOST: usize = 2;

/// Their states at the start of a substep.
pub(super) type States = [f64; MOST];

/// State at the end and force of each of these elements.
type Ends = [[Dual<2>; 2]; MOST];

const NO_ENDS: Ends = [[Dual { value: 0.0, derivatives: [0.0; 2] }; 2]; MOST];

/// What acts on the mass in a stage, and the states that it leaves.
#[derive(Clone, Copy, Debug)]
pub(super) struct MassForces {
    /// With derivatives over displacement of the mass and state at the end and start.
    ends: Ends,
    /// With derivatives over displacement and velocity of the mass at the start; found where they are asked for.
    by_start: Ends,
}

/// Where these elements start from, and the time since.
#[derive(Clone, Copy, Debug)]
pub(super) struct MassStart {
    /// Displacement and velocity of the mass at the start of the substep.
    pub mass: [f64; 2],
    pub states: States,
    /// Time from there to the stage, s.
    pub time: f64,
}

impl MassStart {
    /// After a travel of the mass to `end`, at these displacements and velocities; each state by `lifted`.
    #[inline(never)]
    fn propagate(
        &self,
        elements: &Elements<impl Tables>,
        [x0, u0, end]: [Dual<2>; 3],
        lifted: fn(f64) -> Dual<2>,
    ) -> Ends {
        let travel = Travel::accelerated(x0, u0, end, self.time);
        let mut ends = NO_ENDS;
        let act = |index: usize, element: &dyn StatefulForce, _| {
            if let Some((to, z)) = ends.get_mut(index).zip(self.states.get(index)) {
                *to = element.propagate_on_mass(x0, &travel, lifted(*z));
            }
        };
        elements.visit_stateful(&mut MassVisitor { next: 0, act });
        ends
    }
}

impl MassForces {
    /// No element with a state acts on the mass.
    pub(super) const NONE: MassForces = MassForces { ends: NO_ENDS, by_start: NO_ENDS };

    /// After a travel of the mass to `end`.
    #[inline(always)]
    pub(super) fn stage(elements: &Elements<impl Tables>, from: &MassStart, end: f64) -> MassForces {
        let [x0, u0] = from.mass.map(Dual::constant);
        let ends = from.propagate(elements, [x0, u0, Dual::along(end, 0)], |z| Dual::along(z, 1));
        MassForces { ends, by_start: NO_ENDS }
    }

    /// Finds the derivatives over the start.
    #[inline(always)]
    pub(super) fn look_at_start(&mut self, elements: &Elements<impl Tables>, from: &MassStart, end: f64) {
        let [x0, u0] = from.mass;
        self.by_start =
            from.propagate(elements, [Dual::along(x0, 0), Dual::along(u0, 1), Dual::constant(end)], Dual::constant);
    }

    /// Force on the mass and its derivative over the place of the mass.
    #[inline(always)]
    pub(super) fn force(&self) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for [_, force] in &self.ends {
            sum[0] += force.value;
            sum[1] += force.derivative(0);
        }
        sum
    }

    /// The states.
    #[inline(always)]
    pub(super) fn states(&self) -> States {
        self.ends.map(|[state, _]| state.value)
    }

    /// Straight on by a way of the mass.
    #[inline(always)]
    pub(super) fn go(&mut self, way: f64) {
        for [state, _] in &mut self.ends {
            state.value += state.derivative(0) * way;
        }
    }

    /// Derivative of the force in a direction in which displacement, velocity and states at the start move, with the end
    /// of the mass held.
    #[inline(always)]
    pub(super) fn force_by_start(&self, start: [f64; 2], states: &States) -> f64 {
        self.along(1, start, states).into_iter().sum()
    }

    /// Derivatives of the states in that direction, in which the mass ends further by `end`.
    #[inline(always)]
    pub(super) fn states_along(&self, end: f64, start: [f64; 2], states: &States) -> States {
        let mut along = self.along(0, start, states);
        for (state, [to, _]) in along.iter_mut().zip(&self.ends) {
            *state += to.derivative(0) * end;
        }
        along
    }

    #[inline(always)]
    fn along(&self, which: usize, [x, u]: [f64; 2], states: &States) -> States {
        let mut along = [0.0; MOST];
        for (((to, end), by_start), state) in along.iter_mut().zip(&self.ends).zip(&self.by_start).zip(states) {
            if let Some((end, by_start)) = end.get(which).zip(by_start.get(which)) {
                *to = by_start.derivative(0) * x + by_start.derivative(1) * u + end.derivative(1) * state;
            }
        }
        along
    }
}

/// Reads the states of these elements.
pub(super) fn read(elements: &Elements<impl Tables>, internal: &[f64; MAX_INTERNAL]) -> States {
    let mut states = [0.0; MOST];
    elements.visit_stateful(&mut MassVisitor {
        next: 0,
        act: |index: usize, _: &dyn StatefulForce, place: usize| {
            if let Some((state, from)) = states.get_mut(index).zip(internal.get(place)) {
                *state = *from;
            }
        },
    });
    states
}

/// Puts them where they are kept.
pub(super) fn write(elements: &Elements<impl Tables>, states: &States, internal: &mut [f64; MAX_INTERNAL]) {
    elements.visit_stateful(&mut MassVisitor {
        next: 0,
        act: |index: usize, _: &dyn StatefulForce, place: usize| {
            if let Some((to, state)) = internal.get_mut(place).zip(states.get(index)) {
                *to = *state;
            }
        },
    });
}

/// Visits those that act on the mass, counted in their order, with the places of their states.
struct MassVisitor<F> {
    next: usize,
    act: F,
}

impl<F: FnMut(usize, &dyn StatefulForce, usize)> StateVisitor for MassVisitor<F> {
    #[inline(always)]
    fn visit<M: StatefulForce>(&mut self, place: usize, element: &M) {
        if element.acts_on_mass() {
            (self.act)(self.next, element, place);
            self.next += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element;
    use crate::model::Model;
    use crate::number;
    use crate::parameter::{Element, Params};

    /// One more would have no place, and no force.
    #[test]
    fn each_element_on_the_mass_has_a_place() {
        let mut params = Params::new();
        for element in ["lagged_polynomial", "presliding_friction", "gas_spring", "moving_mass"] {
            params.enable(Element::find(element).unwrap(), true);
        }
        params.enable(element!("series_compliance"), true);
        params.set(number!("series_load"), 1.0).unwrap();
        let model = Model::new(&params).unwrap();
        let (mut count, mut all) = (0, 0);
        model.elements.each_stateful(|_, element| {
            count += usize::from(element.acts_on_mass());
            all += 1;
        });
        assert_eq!((count, all), (MOST, 4));
    }
}
