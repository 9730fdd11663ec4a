//! The states that act on each other: their places among themselves, and where they are kept.

use crate::parameter::Params;
use crate::state::{MAX_INTERNAL, State};
use crate::{element, number};

/// Number of states that act on each other.
pub const STATES: usize = 10;

/// Places of the states among them.
pub mod place {
    /// Displacement of the internal mass.
    pub const X: usize = 0;
    /// Its velocity.
    pub const U: usize = 1;
    /// Deflection of the bushing's spring that gives way, z.
    pub const BUSHING: usize = 2;
    /// Of the one that does so slowly, y.
    pub const SLOW_BUSHING: usize = 3;
    /// What the oil column has taken up of the piston's stroke, s: its deflection q where its length does not matter.
    pub const COLUMN: usize = 4;
    /// The void that cavitation left, e.
    pub const VOID: usize = 5;
    /// Frequency-selective damping.
    pub const SELECTIVE: usize = 6;
    /// Opening of the valve, or the force at which it stands.
    pub const VALVE: usize = 7;
    /// Rate of that, in its own unit.
    pub const VALVE_RATE: usize = 8;
    /// Rise of the oil's temperature.
    pub const HEAT: usize = 9;
}

/// Where the private states among them are kept in [`State::memory`]: one after the other, those of elements that are
/// on only.
#[derive(Clone, Copy, Debug)]
pub struct Slots {
    /// For each place its slot; [`NOWHERE`] where its element is off.
    slots: [u8; STATES],
    count: u8,
}

const NOWHERE: u8 = u8::MAX;

impl Slots {
    /// No private states.
    pub const NONE: Slots = Slots { slots: [NOWHERE; STATES], count: 0 };

    /// Gives each place that is `on` the next slot.
    pub fn new(on: [bool; STATES]) -> Slots {
        let mut slots = Slots::NONE;
        for (slot, on) in slots.slots.iter_mut().zip(on) {
            if on {
                *slot = slots.count;
                slots.count += 1;
            }
        }
        slots
    }

    /// Number of private states.
    #[inline(always)]
    pub fn count(&self) -> usize {
        self.count as usize
    }

    /// The slot of a place, if it has one.
    #[inline(always)]
    pub fn slot(&self, place: usize) -> Option<usize> {
        match self.slots.get(place) {
            Some(&slot) if slot != NOWHERE && usize::from(slot) < MAX_INTERNAL => Some(usize::from(slot)),
            _ => None,
        }
    }

    /// The states of the paths; 0 where there is none.
    pub fn read(&self, state: &State) -> [f64; STATES] {
        let mut states = [0.0; STATES];
        for (place, value) in states.iter_mut().enumerate() {
            *value = match place {
                place::X => state.mass_displacement,
                place::U => state.mass_velocity,
                _ => self.slot(place).and_then(|slot| state.internal.get(slot)).copied().unwrap_or(0.0),
            };
        }
        states
    }

    /// Puts the states of the paths where they are kept.
    pub fn write(&self, states: &[f64; STATES], state: &mut State) {
        for (place, value) in states.iter().enumerate() {
            match place {
                place::X => state.mass_displacement = *value,
                place::U => state.mass_velocity = *value,
                _ => {
                    if let Some(to) = self.slot(place).and_then(|slot| state.internal.get_mut(slot)) {
                        *to = *value;
                    }
                }
            }
        }
    }

    /// Index among the states of [`crate::Partials`].
    pub fn index(&self, place: usize) -> Option<usize> {
        match place {
            place::X | place::U => Some(place),
            _ => self.slot(place).map(|slot| slot + 2),
        }
    }
}

/// Number of internal states of the elements in both force paths that are on in a parameter set, counted before they
/// are prepared.
pub(crate) fn states_of(params: &Params) -> usize {
    let on = |element| usize::from(params.is_on(element));
    let with = |element, number, of: fn(f64) -> bool| usize::from(params.is_on(element) && of(params.number(number)));
    on(element!("bushing"))
        + with(element!("bushing"), number!("bushing_slow_stiffness"), |share| share > 0.0)
        + usize::from(params.is_on(element!("oil_compressibility")) || params.is_on(element!("aeration")))
        + on(element!("cavitation"))
        + on(element!("frequency_selective_damping"))
        + on(element!("valve_hysteresis"))
        + with(element!("valve_hysteresis"), number!("valve_form"), |form| form == 2.0)
        + with(element!("temperature_fade"), number!("fade_source"), |source| source == 1.0)
}
