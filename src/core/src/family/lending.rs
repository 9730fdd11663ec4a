//! Elements of a family of dampers at one setting: borrowed from the family, or prepared from the interpolated
//! parameters.

use super::section::{Lent, Passage};
use crate::elements::parallel_spring::ParallelSpring;
use crate::elements::valve_hysteresis::ValveHysteresis;
use crate::parameter::Params;
use crate::schema::View;

/// Source of the parameter values at a setting.
pub(crate) trait Numbers {
    /// Returns whether the element of a group depends on the setting.
    fn vary(&self, group: usize) -> bool;

    /// Writes the interpolated parameters of a group into `slots`, which already contain the group's constant
    /// parameters. `first_slot` is the slot of the first one in the whole set.
    fn put(&self, group: usize, first_slot: usize, slots: &mut [f64]);

    /// Returns the parameter set with the constant values.
    fn params(&self) -> &Params;
}

/// Builds the slots of an element with the parameters at a setting, and passes a view of them to `$then`.
macro_rules! numbers_at_setting {
    ($numbers:ident, $name:ident, $Type:ty, $then:expr) => {{
        const SLOTS: usize = $crate::parameter::row::slots_of(<$Type as $crate::schema::Describe>::PARAMETERS);
        const START: (usize, usize) = $crate::parameter::row::start_of(GroupIndex::$name as usize);
        let mut values = [0.0; SLOTS];
        for (to, from) in values.iter_mut().zip($numbers.params().slots(START.1, SLOTS)) {
            *to = *from;
        }
        $numbers.put(GroupIndex::$name as usize, START.1, &mut values);
        let lengths = $numbers.params().lengths(START.0);
        $then(&$crate::schema::View::<$Type>::new(START.0, lengths, &values))
    }};
}
pub(crate) use numbers_at_setting;

/// Returns a small element at a setting: the element of the family, or an element prepared from the parameters at the
/// setting.
///
/// A prepared element is stored in `renewed`. Interpolated parameters between two valid sets are usually valid. If they
/// are invalid, the element of the family at its start setting applies.
macro_rules! kept {
    ($of:ident, $numbers:ident, $renewed:ident, $name:ident, $Type:ty) => {
        if $numbers.vary(GroupIndex::$name as usize) {
            let own = &*$of.$name;
            let made = numbers_at_setting!($numbers, $name, $Type, |view| {
                <$Type as $crate::element::Prepare>::prepare(view).unwrap_or(*own)
            });
            &*$renewed.$name.insert(made)
        } else {
            &*$of.$name
        }
    };
}
pub(crate) use kept;

/// Returns an element with a large table at a setting: borrowed from the family, or prepared from the parameters at the
/// setting. Such an element has its own methods for borrowing and preparing.
macro_rules! lent_or_renewed {
    ($of:ident, $numbers:ident, $name:ident, $Type:ty) => {
        if $numbers.vary(GroupIndex::$name as usize) {
            let own = &$of.$name;
            numbers_at_setting!($numbers, $name, $Type, |view| own.renewed(view))
        } else {
            $of.$name.lent()
        }
    };
}
pub(crate) use lent_or_renewed;

impl ParallelSpring {
    /// Returns the parallel spring with its table borrowed.
    #[inline(always)]
    pub(crate) fn lent(&self) -> ParallelSpring<Lent<'_>> {
        self.with_table(self.table())
    }

    /// Returns the spring with the parameters `numbers` at a setting. Its table does not depend on the setting.
    #[inline(always)]
    pub(crate) fn renewed(&self, numbers: &View<ParallelSpring>) -> ParallelSpring<Lent<'_>> {
        let mut spring = self.lent();
        spring.set_powers(numbers);
        spring
    }
}

impl ValveHysteresis {
    /// Returns the valve with the table of its passage borrowed.
    #[inline(always)]
    pub(crate) fn lent(&self) -> ValveHysteresis<Lent<'_>> {
        self.with_conductance(Passage::Table(self.conductance()))
    }

    /// Returns the valve with the parameters `numbers` at a setting. The conductance of its passage is computed from
    /// the FV curve.
    #[inline(always)]
    pub(crate) fn renewed<'a>(&self, numbers: &View<ValveHysteresis>) -> ValveHysteresis<Lent<'a>> {
        let valve: ValveHysteresis<Lent<'_>> = ValveHysteresis::from_view(numbers, Passage::From(0.0));
        valve.with_conductance(Passage::From(valve.tabulated_from()))
    }
}

impl ValveHysteresis<Lent<'_>> {
    /// Replaces the table of the passage by values from the FV curve, because the curve depends on the setting.
    #[inline(always)]
    pub(crate) fn measure(&mut self) {
        *self = self.with_conductance(Passage::From(self.tabulated_from()));
    }
}
