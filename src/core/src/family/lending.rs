//! What an element of the family is at a setting: the same, or made ready from the numbers there.

use super::section::{Lent, Passage};
use crate::element::Prepare;
use crate::elements::parallel_spring::ParallelSpring;
use crate::elements::valve_hysteresis::ValveHysteresis;
use crate::parameter::Params;
use crate::schema::View;

/// Values of the numbers at a setting.
pub(crate) trait Numbers {
    /// Whether an element depends on the setting.
    fn vary(&self, group: usize) -> bool;

    /// Puts the values of the numbers of a group into its slots, which hold those that do not depend on the setting.
    fn put(&self, group: usize, first_slot: usize, slots: &mut [f64]);

    /// The set that the others come from.
    fn params(&self) -> &Params;
}

/// An element that is small: it is copied, or made ready anew. One that keeps a large table has methods of its own of these names.
pub(crate) trait Lend: Prepare + Copy {
    /// The same.
    #[inline(always)]
    fn lent(&self) -> Self {
        *self
    }

    /// From other numbers. Those between two that can be prepared can be; else the element stays as it is.
    #[inline(always)]
    fn renewed(&self, numbers: &View<Self>) -> Self {
        Self::prepare(numbers).unwrap_or(*self)
    }
}

impl<E: Prepare + Copy> Lend for E {}

/// An element at a setting.
macro_rules! lent_or_renewed {
    ($of:ident, $numbers:ident, $name:ident, $Type:ty) => {
        if $numbers.vary(Place::$name as usize) {
            const SLOTS: usize = $crate::parameter::row::slots_of(<$Type as $crate::schema::Describe>::PARAMETERS);
            const START: (usize, usize) = $crate::parameter::row::start_of(Place::$name as usize);
            let mut values = [0.0; SLOTS];
            for (to, from) in values.iter_mut().zip($numbers.params().slots(START.1, SLOTS)) {
                *to = *from;
            }
            $numbers.put(Place::$name as usize, START.1, &mut values);
            let lengths = $numbers.params().lengths(START.0);
            $of.$name.renewed(&$crate::schema::View::new(START.0, lengths, &values))
        } else {
            $of.$name.lent()
        }
    };
}
pub(crate) use lent_or_renewed;

impl ParallelSpring {
    /// The same, with its table borrowed.
    #[inline(always)]
    pub(crate) fn lent(&self) -> ParallelSpring<Lent<'_>> {
        self.with_table(self.table())
    }

    /// As [`Lend::renewed`]: the table does not depend on the setting.
    #[inline(always)]
    pub(crate) fn renewed(&self, numbers: &View<ParallelSpring>) -> ParallelSpring<Lent<'_>> {
        let mut spring = self.lent();
        spring.set_powers(numbers);
        spring
    }
}

impl ValveHysteresis {
    /// The same, with its passage borrowed.
    #[inline(always)]
    pub(crate) fn lent(&self) -> ValveHysteresis<Lent<'_>> {
        self.with_conductance(Passage(Some(self.conductance())))
    }

    /// As [`Lend::renewed`]: what the passage conducts is read off the FV curve.
    #[inline(always)]
    pub(crate) fn renewed<'a>(&self, numbers: &View<ValveHysteresis>) -> ValveHysteresis<Lent<'a>> {
        ValveHysteresis::of(numbers, Passage(None))
    }
}

impl ValveHysteresis<Lent<'_>> {
    /// Reads what the passage conducts off the FV curve: that depends on the setting.
    #[inline(always)]
    pub(crate) fn measure(&mut self) {
        *self = self.with_conductance(Passage(None));
    }
}
