//! Elements with a state that act on the mass in a stage: friction and gas behind a series path that carries the whole.
//!
//! In a stage the mass goes from where it is at the start of the substep to where the stage puts it, at constant
//! acceleration over the time of the stage. Each element knows its state after such a travel in closed form, so that the
//! method of the step does not integrate a contact that turns over within micrometres. The force rises with the place of
//! the mass: the stage has one answer.

use crate::assembly::Elements;
use crate::dual::{Dual, Real};
use crate::element::{Carrying, StateVisitor, StatefulForce, carrying};
use crate::input::Travel;
use crate::state::MAX_INTERNAL;
use crate::tables::Tables;

/// Most elements with a state that act on the mass: presliding friction and the gas spring.
pub(super) const MOST: usize = 2;

/// Their states at the start of a substep.
pub(super) type States = [f64; MOST];

/// What acts on the mass in a stage, and the states that it leaves.
#[derive(Clone, Copy, Debug)]
pub(super) struct OnMass {
    forces: [Carrying; MOST],
    ends: [Carrying; MOST],
}

const ZERO: Carrying = Dual { value: 0.0, derivatives: [0.0; carrying::ALL] };

impl OnMass {
    pub(super) const NONE: OnMass = OnMass { forces: [ZERO; MOST], ends: [ZERO; MOST] };

    /// After a travel of the mass from `start`, its displacement and velocity, to `end` in `time`.
    #[inline(never)]
    pub(super) fn stage(
        elements: &Elements<impl Tables>,
        states: &States,
        [x0, u0]: [f64; 2],
        end: f64,
        time: f64,
    ) -> OnMass {
        let from = Dual::along(x0, carrying::START);
        let travel = Travel::accelerated(from, Dual::along(u0, carrying::SPEED), Dual::along(end, carrying::END), time);
        let mut on_mass = OnMass::NONE;
        elements.visit_stateful(&mut Each {
            next: 0,
            act: |index: usize, element: &dyn StatefulForce, _| {
                if let Some(((force, end), z)) =
                    on_mass.forces.get_mut(index).zip(on_mass.ends.get_mut(index)).zip(states.get(index))
                {
                    [*end, *force] = element.carried(from, &travel, Dual::along(*z, carrying::STATE));
                }
            },
        });
        on_mass
    }

    /// Force on the mass and its derivative over the place of the mass.
    #[inline(always)]
    pub(super) fn force(&self) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for force in &self.forces {
            sum[0] += force.value;
            sum[1] += force.derivative(carrying::END);
        }
        sum
    }

    /// The states.
    #[inline(always)]
    pub(super) fn states(&self) -> States {
        self.ends.map(Dual::value)
    }

    /// Straight on by a way of the mass.
    #[inline(always)]
    pub(super) fn go(&mut self, way: f64) {
        for end in &mut self.ends {
            end.value += end.derivative(carrying::END) * way;
        }
    }

    /// Derivative of the force in a direction in which displacement, velocity and states at the start move, with the end
    /// of the mass held.
    #[inline(always)]
    pub(super) fn force_by_start(&self, start: [f64; 2], states: &States) -> f64 {
        self.forces.iter().zip(states).map(|(force, state)| by_start(force, start, *state)).sum()
    }

    /// Derivatives of the states in that direction, in which the mass ends further by `end`.
    #[inline(always)]
    pub(super) fn states_along(&self, end: f64, start: [f64; 2], states: &States) -> States {
        let mut along = *states;
        for (state, to) in along.iter_mut().zip(&self.ends) {
            *state = by_start(to, start, *state) + to.derivative(carrying::END) * end;
        }
        along
    }
}

#[inline(always)]
fn by_start(number: &Carrying, [x, u]: [f64; 2], state: f64) -> f64 {
    number.derivative(carrying::START) * x
        + number.derivative(carrying::SPEED) * u
        + number.derivative(carrying::STATE) * state
}

/// Reads the states of these elements.
pub(super) fn read(elements: &Elements<impl Tables>, internal: &[f64; MAX_INTERNAL]) -> States {
    let mut states = [0.0; MOST];
    elements.visit_stateful(&mut Each {
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
    elements.visit_stateful(&mut Each {
        next: 0,
        act: |index: usize, _: &dyn StatefulForce, place: usize| {
            if let Some((to, state)) = internal.get_mut(place).zip(states.get(index)) {
                *to = *state;
            }
        },
    });
}

/// Visits those that act on the mass, counted in their order, with the places of their states.
struct Each<F> {
    next: usize,
    act: F,
}

impl<F: FnMut(usize, &dyn StatefulForce, usize)> StateVisitor for Each<F> {
    #[inline(always)]
    fn visit<M: StatefulForce>(&mut self, place: usize, element: &M) {
        if element.acts_on_mass() {
            (self.act)(self.next, element, place);
            self.next += 1;
        }
    }
}
