//! The two force paths whose elements act on each other.
//!
//! The series path goes from the moving end to the internal mass, and the hydraulic path from there to the valves.
//!
//! ```text
//! F_s = φ(x − x_m) + c_s χ (v − u) + k_1 z + k_2 y                   [series]
//! m du/dt = F_s − F_p(x_m) − F_h                                    (or x_m = x, u = v)
//! F_h = N(s F_d(w)) = φ_o(q),   u = w + b + ℓ dq/dt + σ de/dt       [hydraulic]
//! ```
//!
//! x and v are displacement, m, and velocity, m/s, of the moving end, x_m and u those of the internal mass m. F_s is
//! the series force, F_p that of the parallel spring, F_h the hydraulic force, and F_d the FV curve. φ is the elastic
//! law of the series path, and c_s its damping. χ is the closed fraction of the free play's contacts, 1 without free
//! play. k_1 z and k_2 y are the forces of the relaxing springs of a bushing.
//!
//! w is the velocity of the oil through the valves, as a piston velocity, and b the flow that bypasses them. s is the
//! product of the factors for position and temperature. N stands for the lagging valve and frequency-selective damping.
//! q is the deflection of the oil column, φ_o its force law, and ℓ its length, 1 at x = 0. e is the depth of the
//! cavitation void. σ is 1 if the void opens in rebound, −1 in compression.
//!
//! If the series path carries the whole force, the forces of friction and gas act on the mass in addition to F_p.
//!
//! With only the FV curve and the series compliance on, φ is linear, w = u and F_h = F_d(u). The plain step of
//! [`mod@crate::step`] and the short formulas of [`mod@crate::evaluate`] then apply, and no code of this module runs.

pub mod acting;
pub mod bits;
pub mod bypass;
pub mod hydraulic;
pub mod list;
pub mod series;
pub mod slots;
pub(crate) mod solve;

use crate::element::Prepare;
use crate::family::lending::{Numbers, kept, lent_or_renewed, numbers_at_setting};
use crate::family::section::{Lent, Section};
use crate::fault::{Fault, Reason};
use crate::parameter::Params;
use crate::parameter::groups::GroupIndex;
use crate::preparing::{Keep, checked, placed};
use crate::tables::{Owned, OwnedElement, Tables};
use bits::{
    AIR, BUSHING, CAVITATION, COLUMN, FADE, FREE_PLAY, GROOVE, HEAT, LENGTH, PASSAGE, POSITION, SELECTIVE, SERIES,
    SLOW_BUSHING, SPOOL, VALVE, WHOLE,
};
use list::each_path_element;
pub use slots::{STATES, Slots, place};

/// Expands the list of elements in the force path into the struct of the prepared elements.
macro_rules! gathered {
    (
        primary { $primary:ident: $Primary:ty }
        series { $series:ident: $Series:ty }
        series_law { $($law:ident: $Law:ty,)* }
        hydraulic { $($hydraulic:ident: $Hydraulic:ty,)* }
        late { $late:ident: $Late:ty }
    ) => {
        /// The prepared elements in the force path.
        #[derive(Clone, Copy, Debug)]
        #[repr(C)]
        pub struct Paths<T: Tables = Owned> {
            on: u64,
            /// The primary damper.
            pub $primary: T::Fv,
            /// The series compliance.
            pub $series: T::Kept<$Series>,
            $(pub(crate) $law: T::Kept<$Law>,)*
            $(pub(crate) $hydraulic: T::Kept<$Hydraulic>,)*
            pub(crate) $late: $Late,
            /// Indices of the coupled states among the internal states.
            slots: Slots,
            /// Bit set of the elements that act in a stage.
            acting: u32,
        }

        impl Paths {
            /// Paths with all elements switched off.
            pub const OFF: Paths = {
                type T = Owned;
                Paths {
                on: 0,
                $primary: <$Primary>::OFF,
                $series: OwnedElement(<$Series>::OFF),
                $($law: OwnedElement(<$Law>::OFF),)*
                $($hydraulic: OwnedElement(<$Hydraulic>::OFF),)*
                    $late: <$Late>::OFF,
                slots: Slots::NONE,
                acting: 0,
                }
            };

            /// Bits of the elements of the force paths other than the FV curve and the series compliance. If one of
            /// them is on, the plain step of [`mod@crate::step`] does not apply.
            pub(crate) const COUPLED: u64 = 0 $(| 1 << GroupIndex::$law as usize)* $(| 1 << GroupIndex::$hydraulic as usize)* | 1 << GroupIndex::$late as usize;
            /// Bit of the series compliance in the set of elements that are on.
            pub(crate) const MASS: u64 = 1 << GroupIndex::$series as usize;

            /// Checks the parameters of each element that is on, element by element.
            ///
            /// # Errors
            /// Returns the parameter at fault.
            pub(crate) fn check(params: &Params) -> Result<(), Fault> {
                type T = Owned;
                macro_rules! each {
                    ($name:ident, $Type:ty) => {
                        if params.elements() & (1 << GroupIndex::$name as usize) != 0 {
                            checked::<$Type>(params, GroupIndex::$name as usize)?;
                        }
                    };
                }
                each!($primary, $Primary);
                each!($series, $Series);
                $(each!($law, $Law);)*
                $(each!($hydraulic, $Hydraulic);)*
                each!($late, $Late);
                Ok(())
            }

            /// Checks whether every element that is on has the other elements that it requires.
            ///
            /// # Errors
            /// Returns the element that requires an element that is off.
            pub(crate) fn check_together(params: &Params) -> Result<(), Fault> {
                if params.elements() & Paths::<Owned>::MASS == 0 {
                    $(if params.elements() & (1 << GroupIndex::$law as usize) != 0 {
                        return Err(params.view::<$Law>(GroupIndex::$law as usize).fault_of_all(Reason::NeedsSeries));
                    })*
                }
                Ok(())
            }

            /// Prepares in place the elements that are on, from parameters that [`Paths::check`] accepted.
            pub(crate) fn set(&mut self, params: &Params) {
                let on = params.elements();
                self.on = on;
                macro_rules! each {
                    ($name:ident) => {
                        placed(self.$name.kept(), on & (1 << GroupIndex::$name as usize) != 0, params, GroupIndex::$name as usize);
                    };
                }
                each!($primary);
                each!($series);
                $(each!($law);)*
                $(each!($hydraulic);)*
                each!($late);
                self.acting = self.bits();
                self.slots = self.laid_out();
            }

            /// Returns the elements of the force paths at a setting: see [`crate::assembly::Elements::lent`].
            #[inline(always)]
            pub(crate) fn lent<'a>(
                &'a self,
                fv: Section<'a>,
                numbers: &impl Numbers,
                renewed: &'a mut RenewedPaths,
            ) -> Paths<Lent<'a>> {
                type T = Owned;
                macro_rules! each {
                    ($name:ident, $Type:ty) => {
                        kept!(self, numbers, renewed, $name, $Type)
                    };
                }
                Paths {
                    on: self.on,
                    $primary: fv,
                    $series: each!($series, $Series),
                    $($law: each!($law, $Law),)*
                    $($hydraulic: each!($hydraulic, $Hydraulic),)*
                    $late: lent_or_renewed!(self, numbers, $late, $Late),
                    slots: self.slots,
                    acting: self.acting,
                }
            }
        }

        /// Elements of the force paths that were prepared again for one setting of a family.
        pub(crate) struct RenewedPaths {
            $series: Option<$Series>,
            $($law: Option<$Law>,)*
            $($hydraulic: Option<$Hydraulic>,)*
        }

        impl RenewedPaths {
            /// Returns a set in which no element is prepared. It is a function, because each use of a constant would
            /// copy the whole set.
            #[inline(always)]
            pub(crate) fn none() -> RenewedPaths {
                RenewedPaths { $series: None, $($law: None,)* $($hydraulic: None,)* }
            }
        }

        impl<T: Tables> Paths<T> {
            #[inline(always)]
            fn has(&self, place: GroupIndex) -> bool {
                self.on & (1 << place as usize) != 0
            }
        }
    };
}

each_path_element!(gathered);

/// Predicates of the elements, and indices of their states.
impl<T: Tables> Paths<T> {
    /// Returns whether the series compliance is on: without it the internal mass moves with the moving end.
    #[inline(always)]
    pub fn has_series(&self) -> bool {
        self.on & Paths::<Owned>::MASS != 0
    }

    /// Returns whether friction and preload act on the internal mass, behind the series compliance.
    #[inline(always)]
    pub fn carries_whole(&self) -> bool {
        self.has_series() && self.series_compliance.carries_whole
    }

    #[inline(always)]
    pub(crate) fn has_free_play(&self) -> bool {
        self.has(GroupIndex::free_play)
    }

    #[inline(always)]
    pub(crate) fn has_bushing(&self) -> bool {
        self.has(GroupIndex::bushing)
    }

    /// Returns whether a part of the bushing relaxes slowly.
    #[inline(always)]
    pub(crate) fn has_slow_bushing(&self) -> bool {
        self.has_bushing() && self.bushing.slow_ratio > 0.0
    }

    #[inline(always)]
    pub(crate) fn has_cavitation(&self) -> bool {
        self.has(GroupIndex::cavitation)
    }

    #[inline(always)]
    pub(crate) fn has_position(&self) -> bool {
        self.has(GroupIndex::position_dependent_damping) && !self.position_dependent_damping.is_groove
    }

    /// Returns whether position-dependent damping is a flow that bypasses the valves.
    #[inline(always)]
    pub(crate) fn has_groove(&self) -> bool {
        self.has(GroupIndex::position_dependent_damping) && self.position_dependent_damping.is_groove
    }

    /// Returns whether frequency-selective damping is a flow that bypasses the valves.
    #[inline(always)]
    pub(crate) fn has_passage(&self) -> bool {
        self.has(GroupIndex::frequency_selective_damping) && self.frequency_selective_damping.is_bypass
    }

    #[inline(always)]
    pub(crate) fn has_fade(&self) -> bool {
        self.has(GroupIndex::temperature_fade)
    }

    #[inline(always)]
    pub(crate) fn has_frequency_selective(&self) -> bool {
        self.has(GroupIndex::frequency_selective_damping) && !self.frequency_selective_damping.is_bypass
    }

    #[inline(always)]
    pub(crate) fn has_valve(&self) -> bool {
        self.has(GroupIndex::valve_hysteresis)
    }

    /// Returns whether the valve has mass.
    #[inline(always)]
    pub(crate) fn has_spool(&self) -> bool {
        self.has_valve() && self.valve_hysteresis.is_spool()
    }

    /// Returns whether there is a compliant oil column.
    #[inline(always)]
    pub(crate) fn has_column(&self) -> bool {
        self.has(GroupIndex::oil_compressibility) || self.has(GroupIndex::aeration)
    }

    /// Returns whether the length of the oil column depends on the displacement.
    #[inline(always)]
    pub(crate) fn has_length(&self) -> bool {
        self.has(GroupIndex::oil_compressibility) && self.oil_compressibility.has_length()
    }

    /// Returns whether the state of the oil column is the absorbed part of the piston stroke, instead of the
    /// deflection.
    #[inline(always)]
    pub(crate) fn counts_stroke(&self) -> bool {
        self.has(GroupIndex::oil_compressibility) && self.oil_compressibility.counts_stroke()
    }

    #[inline(always)]
    pub(crate) fn has_aeration(&self) -> bool {
        self.has(GroupIndex::aeration)
    }

    /// Returns the elements that act in a stage: bits of [`bits`].
    #[inline(always)]
    pub(crate) fn acting(&self) -> u32 {
        self.acting
    }

    /// Returns the indices of the coupled states among the internal states.
    #[inline(always)]
    pub(crate) fn slots(&self) -> &Slots {
        &self.slots
    }
}

/// Data that one element passes to another when a model is prepared.
impl Paths {
    /// Computes what one element needs from another: the conductance of a lagging valve from the FV curve.
    pub(crate) fn join(&mut self) {
        if self.has_valve() {
            self.valve_hysteresis.join(&self.fv_curve);
        }
    }
}

impl<T: Tables> Paths<T> {
    /// Computes the elements that act in a stage: bits of [`bits`].
    fn bits(&self) -> u32 {
        let mut acting = 0;
        for (bit, on) in [
            (SERIES, self.has_series()),
            (FREE_PLAY, self.has_free_play()),
            (BUSHING, self.has_bushing()),
            (SLOW_BUSHING, self.has_slow_bushing()),
            (COLUMN, self.has_column()),
            (AIR, self.has_aeration()),
            (LENGTH, self.has_length()),
            (CAVITATION, self.has_cavitation()),
            (POSITION, self.has_position()),
            (GROOVE, self.has_groove()),
            (PASSAGE, self.has_passage()),
            (FADE, self.has_fade()),
            (HEAT, self.temperature_fade.heats_itself),
            (SELECTIVE, self.has_frequency_selective()),
            (VALVE, self.has_valve()),
            (SPOOL, self.has_spool()),
            (WHOLE, self.carries_whole()),
        ] {
            if on {
                acting |= bit;
            }
        }
        acting
    }

    /// Assigns indices to the coupled states of the elements that are on.
    fn laid_out(&self) -> Slots {
        let mut on = [false; STATES];
        on[place::BUSHING] = self.has_bushing();
        on[place::SLOW_BUSHING] = self.has_slow_bushing();
        on[place::COLUMN] = self.has_column();
        on[place::VOID] = self.has_cavitation();
        on[place::SELECTIVE] = self.has_frequency_selective() || self.has_passage();
        on[place::VALVE] = self.has_valve();
        on[place::VALVE_RATE] = self.has_spool();
        on[place::HEAT] = self.temperature_fade.heats_itself;
        Slots::new(on)
    }

    /// Returns name and unit of the coupled state with the number `place` (see [`place`]).
    pub fn state_name(&self, place: usize) -> (&'static str, &'static str) {
        match place {
            place::X => ("internal_mass", "m"),
            place::U => ("internal_mass_velocity", "m/s"),
            place::BUSHING => ("bushing", "m"),
            place::SLOW_BUSHING => ("bushing_slow", "m"),
            place::COLUMN => ("oil_column", "m"),
            place::VOID => ("cavitation_void", "m"),
            place::SELECTIVE if self.frequency_selective_damping.holds_force() => ("frequency_selective_damping", "N"),
            place::SELECTIVE => ("frequency_selective_damping", "-"),
            place::VALVE if self.valve_hysteresis.holds_force() => ("valve_hysteresis", "N"),
            place::VALVE => ("valve_hysteresis", "-"),
            place::VALVE_RATE => ("valve_hysteresis_rate", "N"),
            _ => ("oil_temperature_rise", "K"),
        }
    }
}
