//! The coupled states: their fixed numbers, and their indices among the internal states.
//!
//! The coupled states are those of the internal mass and of the elements in the force path.

use crate::parameter::Params;
use crate::state::{MAX_INTERNAL, State};
use crate::{element, number};

/// Number of coupled states.
pub const STATES: usize = 10;

/// Fixed numbers of the coupled states.
pub mod place {
    /// Displacement of the internal mass, m.
    pub const X: usize = 0;
    /// Velocity of the internal mass, m/s.
    pub const U: usize = 1;
    /// Deflection of the bushing's first relaxing element, z, m.
    pub const BUSHING: usize = 2;
    /// Deflection of the bushing's slowly relaxing element, y, m.
    pub const SLOW_BUSHING: usize = 3;
    /// Deflection of the oil column, or the part of the piston stroke that it absorbs, m: see `oil_compressibility`.
    pub const COLUMN: usize = 4;
    /// Depth of the cavitation void, e, m.
    pub const VOID: usize = 5;
    /// State of frequency-selective damping: a lagged force, N, or a filled fraction of a chamber.
    pub const SELECTIVE: usize = 6;
    /// State of valve hysteresis: the opening of the valve, or the force, N, under which the valve's position would be
    /// steady.
    pub const VALVE: usize = 7;
    /// Time derivative of the state of a valve with mass, times its time constant, N.
    pub const VALVE_RATE: usize = 8;
    /// Rise of the oil temperature by self-heating, K.
    pub const HEAT: usize = 9;
}

/// Indices of the coupled states in [`State::internal`], consecutive and only for elements that are on.
#[derive(Clone, Copy, Debug)]
pub struct Slots {
    /// Index of each coupled state; [`NOWHERE`] if its element is off.
    slots: [u8; STATES],
    count: u8,
}

const NOWHERE: u8 = u8::MAX;

impl Slots {
    /// Indices without any internal state.
    pub const NONE: Slots = Slots { slots: [NOWHERE; STATES], count: 0 };

    /// Assigns consecutive indices to the coupled states that are `on`.
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

    /// Returns the number of coupled states that have an index among the internal states.
    #[inline(always)]
    pub fn count(&self) -> usize {
        self.count as usize
    }

    /// Returns the index of a coupled state in [`State::internal`]. `None` if its element is off, and for the states of
    /// the mass.
    #[inline(always)]
    pub fn slot(&self, place: usize) -> Option<usize> {
        match self.slots.get(place) {
            Some(&slot) if slot != NOWHERE && usize::from(slot) < MAX_INTERNAL => Some(usize::from(slot)),
            _ => None,
        }
    }

    /// Reads the coupled states from a state; 0 for a coupled state whose element is off.
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

    /// Writes the coupled states to a state.
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

    /// Returns the index of a coupled state in [`crate::Partials`]; `None` if its element is off.
    pub fn index(&self, place: usize) -> Option<usize> {
        match place {
            place::X | place::U => Some(place),
            _ => self.slot(place).map(|slot| slot + 2),
        }
    }
}

/// Counts the internal states of both force paths for a parameter set, before the elements are prepared.
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
