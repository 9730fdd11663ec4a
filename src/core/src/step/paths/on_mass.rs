//! Elements with a state that act on the internal mass in a stage: friction and gas, if the series path also carries
//! their force.
//!
//! In a stage the mass moves at constant acceleration from its position at the start of the substep to that of the
//! stage. Each element computes its state after such a motion in closed form. The method of the step therefore need not
//! resolve a friction contact, whose force may reverse within micrometers. The forces of these elements do not decrease
//! with the displacement of the mass, so the stage has a unique solution.

use crate::assembly::Elements;
use crate::dual::{Dual, Real};
use crate::element::{StateVisitor, StatefulForce};
use crate::input::Travel;
use crate::state::MAX_INTERNAL;
use crate::tables::Tables;

/// Largest number of elements with a state that act on the mass: presliding friction and the gas spring.
pub(super) const MOST: usize = 2;

/// States of the elements with a state that act on the mass, in the order of the element list.
pub(super) type States = [f64; MOST];

/// Final state and force, N, of each element with a state that acts on the mass.
type Ends = [[Dual<2>; 2]; MOST];

const NO_ENDS: Ends = [[Dual { value: 0.0, derivatives: [0.0; 2] }; 2]; MOST];

/// Forces, in a stage, of the elements with a state that act on the mass, and their states after the stage.
#[derive(Clone, Copy, Debug)]
pub(super) struct MassForces {
    /// End states and forces, with derivatives with respect to the final displacement of the mass and the initial
    /// state.
    ends: Ends,
    /// End states and forces, with derivatives with respect to initial displacement and velocity of the mass. Computed
    /// only on request.
    by_start: Ends,
}

/// Values at the start of a substep, for the elements with a state that act on the mass.
#[derive(Clone, Copy, Debug)]
pub(super) struct MassStart {
    /// Displacement, m, and velocity, m/s, of the mass at the start of the substep.
    pub mass: [f64; 2],
    /// States of the elements at the start of the substep.
    pub states: States,
    /// Time from the start of the substep to the stage, s.
    pub time: f64,
}

impl MassStart {
    /// Propagates the elements' states over a motion of the mass from displacement `x0` and velocity `u0` to
    /// displacement `end`. `lifted` turns each state into a dual number.
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
    /// Zero forces and states, for a model in which no element with a state acts on the mass.
    pub(super) const NONE: MassForces = MassForces { ends: NO_ENDS, by_start: NO_ENDS };

    /// Computes states and forces of the elements after a motion of the mass to the displacement `end`, m.
    #[inline(always)]
    pub(super) fn stage(elements: &Elements<impl Tables>, from: &MassStart, end: f64) -> MassForces {
        let [x0, u0] = from.mass.map(Dual::constant);
        let ends = from.propagate(elements, [x0, u0, Dual::along(end, 0)], |z| Dual::along(z, 1));
        MassForces { ends, by_start: NO_ENDS }
    }

    /// Computes the derivatives of end states and forces with respect to displacement and velocity of the mass at the
    /// start of the substep.
    #[inline(always)]
    pub(super) fn evaluate_at_start(&mut self, elements: &Elements<impl Tables>, from: &MassStart, end: f64) {
        let [x0, u0] = from.mass;
        self.by_start =
            from.propagate(elements, [Dual::along(x0, 0), Dual::along(u0, 1), Dual::constant(end)], Dual::constant);
    }

    /// Returns the sum of the forces, N, and its derivative with respect to the displacement of the mass, N/m.
    #[inline(always)]
    pub(super) fn force(&self) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for [_, force] in &self.ends {
            sum[0] += force.value;
            sum[1] += force.derivative(0);
        }
        sum
    }

    /// Returns the states of the elements after the stage.
    #[inline(always)]
    pub(super) fn states(&self) -> States {
        self.ends.map(|[state, _]| state.value)
    }

    /// Extrapolates the states linearly by a further displacement `way` of the mass, m.
    #[inline(always)]
    pub(super) fn go(&mut self, way: f64) {
        for [state, _] in &mut self.ends {
            state.value += state.derivative(0) * way;
        }
    }

    /// Returns the derivative of the force in one direction. `start` contains the derivatives of the mass's initial
    /// displacement and velocity in this direction, and `states` those of the initial states. The final displacement of
    /// the mass is fixed.
    #[inline(always)]
    pub(super) fn force_along(&self, start: [f64; 2], states: &States) -> f64 {
        self.along(1, start, states).into_iter().sum()
    }

    /// Returns the derivatives of the final states in one direction. `start` contains the derivatives of the mass's
    /// initial displacement and velocity in this direction, and `states` those of the initial states. `end` is the
    /// derivative of the mass's final displacement.
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

/// Reads the states of the elements that act on the mass from the internal states.
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

/// Writes the states of the elements that act on the mass back to the internal states.
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

/// Visitor that calls `act` for each element with a state that acts on the mass. The arguments are its number, the
/// element, and the index of its state.
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

    /// Exactly [`MOST`] elements with a state act on the mass. A further element would have no slot, so its force would
    /// be missing.
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
