//! The physical effects, one file each, and the one list that puts them into the model.
//!
//! A new effect is a new file with its equation, parameters, states and partials, and one line in [`elements!`] below.
//! The line says where the effect acts:
//!
//! - `inner`: on the internal mass, driven by its displacement and velocity (inside the series compliance);
//! - `friction` and `preload`: beside the whole damper, driven by the input motion;
//! - `memory`: beside the whole damper, with one private state;
//! - `stops`: beside the whole damper, at the ends of its stroke;
//! - `series_law`: bends the law of the series compliance (see [`crate::paths::series`]);
//! - `hydraulic`: between the internal mass and the FV curve (see [`crate::paths::hydraulic`]).
//!
//! `primary` (the FV curve) and `series` (the compliance with its mass) make the frame they act in.
//!
//! Private states take a place in [`crate::State::memory`] in the order of the list, those of elements that are on only.

mod aeration;
mod bump_stop;
mod bushing;
mod cavitation;
mod coulomb_friction;
mod end_stop;
mod free_play;
mod frequency_selective_damping;
mod fv_curve;
mod gas_preload;
mod gas_spring;
mod gas_warming;
mod lagged_polynomial;
mod moving_mass;
mod oil_compressibility;
mod parallel_spring;
mod position_dependent_damping;
mod presliding_friction;
mod rebound_stop;
mod series_compliance;
mod side_force_friction;
mod stribeck_friction;
mod temperature_fade;
mod valve_hysteresis;
mod viscous_friction;

pub(crate) use bushing::Relaxed;

use crate::fault::{Fault, NO_PARAMETER, Reason};
use crate::input::Path;
use crate::parameter::{Group, Parameter, Params, View};
use crate::paths::{self, Slots};

/// The motion that an element sees, and what surrounds it.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    /// Displacement, m, extension positive.
    pub displacement: f64,
    /// Velocity, m/s, extension positive.
    pub velocity: f64,
    /// Side force, N.
    pub side_force: f64,
    /// Damper temperature, °C.
    pub temperature: f64,
}

/// Force of an element without memory, and its slopes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Force, N, tension positive.
    pub force: f64,
    /// ∂F/∂x, N/m.
    pub by_x: f64,
    /// ∂F/∂v, N s/m.
    pub by_v: f64,
}

impl Response {
    /// Nothing.
    pub const NONE: Response = Response { force: 0.0, by_x: 0.0, by_v: 0.0 };

    #[inline(always)]
    fn add(&mut self, other: Response) {
        self.force += other.force;
        self.by_x += other.by_x;
        self.by_v += other.by_v;
    }
}

/// What acts between the ends or, where the series compliance carries the whole, on the mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outer {
    /// Friction without memory.
    pub friction: Response,
    /// Position forces without memory.
    pub preload: Response,
}

impl Outer {
    /// Nothing.
    pub const NONE: Outer = Outer { friction: Response::NONE, preload: Response::NONE };
}

/// Beside the bits of the elements: friction and preload act on the mass.
const CARRIES_WHOLE: u64 = 1 << 63;

/// Force and state rate of an element with one private state, and their slopes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recall {
    /// Force, N.
    pub force: f64,
    /// ∂F/∂x.
    pub by_x: f64,
    /// ∂F/∂v.
    pub by_v: f64,
    /// ∂F/∂z.
    pub by_memory: f64,
    /// dz/dt.
    pub rate: f64,
    /// ∂(dz/dt)/∂x.
    pub rate_by_x: f64,
    /// ∂(dz/dt)/∂v.
    pub rate_by_v: f64,
    /// ∂(dz/dt)/∂z, at most 0.
    pub rate_by_memory: f64,
}

impl Recall {
    /// Nothing.
    pub const NONE: Recall = Recall {
        force: 0.0,
        by_x: 0.0,
        by_v: 0.0,
        by_memory: 0.0,
        rate: 0.0,
        rate_by_x: 0.0,
        rate_by_v: 0.0,
        rate_by_memory: 0.0,
    };
}

/// What an element tells the parameter table.
pub trait Describe {
    /// What it is, in one line.
    const MEANING: &'static str;
    /// Its rows.
    const PARAMETERS: &'static [Parameter];
}

/// How an element is made ready from its parameters.
pub trait Prepare: Describe + Sized {
    /// The element switched off.
    const OFF: Self;
    /// Checks what the bounds of single parameters cannot, and precomputes.
    ///
    /// # Errors
    /// The parameter that does not fit the others.
    fn prepare(parameters: &View<Self>) -> Result<Self, Fault>;

    /// As [`Prepare::prepare`], where the element is kept; large elements have one of their own.
    ///
    /// # Errors
    /// The same; nothing is changed then.
    fn set(&mut self, parameters: &View<Self>) -> Result<(), Fault> {
        *self = Self::prepare(parameters)?;
        Ok(())
    }

    /// Switches it off.
    fn clear(&mut self) {
        *self = Self::OFF;
    }
}

/// Whether an element can be prepared. Not inlined: each takes its room on the stack and gives it back.
#[inline(never)]
fn checked<E: Prepare>(params: &Params, place: usize) -> Result<(), Fault> {
    let mut probe = E::OFF;
    probe.set(&View::new(params, place))
}

/// Prepares an element that [`checked`] accepted.
#[inline(never)]
fn placed<E: Prepare>(element: &mut E, on: bool, params: &Params, place: usize) {
    if !on || element.set(&View::new(params, place)).is_err() {
        element.clear();
    }
}

/// An element whose force depends on the present motion alone.
pub trait Force {
    /// Force and slopes.
    fn force(&self, at: &Motion) -> Response;

    /// The same to the bit where it takes a handful of operations: what most steps of most models need. `None` where it
    /// takes more; [`Force::force`] is then asked, out of the way of the quick.
    #[inline(always)]
    fn at_once(&self, _: &Motion) -> Option<Response> {
        None
    }

    /// Whether it bends so sharply that a straight line may not hold for a stage.
    #[inline(always)]
    fn bends(&self) -> bool {
        false
    }
}

/// Where the answer counts the force of an element beside the damper, besides the total.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Share {
    /// Nowhere else.
    Total,
    /// In the friction.
    Friction,
    /// In the gas force.
    Gas,
}

/// An element with one private state z.
pub trait Memory {
    /// Where the answer counts its force.
    fn share(&self) -> Share {
        Share::Total
    }
    /// Force, state rate and all slopes at state `z`.
    fn recall(&self, at: &Motion, z: f64) -> Recall;
    /// The state after the motion has been held long enough.
    fn settled(&self, at: &Motion) -> f64;

    /// The same of one that was `z` where the driven end stood at `from`: another where it keeps at rest what brought it there.
    fn held(&self, _from: f64, _z: f64, at: &Motion) -> f64 {
        self.settled(at)
    }

    /// Whether it does: then it follows the displacement alone, and no velocity that is held for an instant.
    fn keeps(&self, _at: &Motion) -> bool {
        false
    }

    /// The state after the motion along a path, in closed form, with its slopes over displacement and velocity at the end (0
    /// where no `slopes` are asked for). `None` where there is no such form: the step then integrates the rate.
    fn carried(&self, _path: &Path, _z: f64, _slopes: bool) -> Option<(f64, [f64; 2])> {
        None
    }
}

/// Most private states that a model may carry.
pub const MAX_MEMORY: usize = 8;

/// Where an element acts: the blocks of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Acts {
    /// The FV curve.
    Primary,
    /// The series compliance.
    Series,
    /// In the law of the series compliance.
    SeriesLaw,
    /// Between the internal mass and the FV curve.
    Hydraulic,
    /// On the internal mass.
    Inner,
    /// Beside the damper: friction.
    Friction,
    /// Beside the damper: position.
    Preload,
    /// Beside the damper, with a private state.
    Memory,
    /// Beside the damper, at the ends of the stroke.
    Stop,
    /// Nowhere: the settings.
    Nowhere,
}

/// Expands the list of elements into their prepared set, the table's groups and the sums the equations need.
macro_rules! elements {
    (
        primary { $primary:ident: $Primary:ty }
        series { $series:ident: $Series:ty }
        series_law { $($law:ident: $Law:ty,)* }
        hydraulic { $($hydraulic:ident: $Hydraulic:ty,)* }
        inner { $($inner:ident: $Inner:ty,)* }
        friction { $($friction:ident: $Friction:ty,)* }
        preload { $($preload:ident: $Preload:ty,)* }
        memory { $($memory:ident: $Memory:ty,)* }
        stops { $($stop:ident: $Stop:ty,)* }
        default { $($default:ident,)* }
        settings { $settings:ident: $Settings:ty }
    ) => {
        /// Places of the elements in the table's groups.
        #[allow(non_camel_case_types, missing_docs, clippy::upper_case_acronyms)]
        #[derive(Clone, Copy)]
        enum Place { $primary, $series, $($law,)* $($hydraulic,)* $($inner,)* $($friction,)* $($preload,)* $($memory,)* $($stop,)* $settings }

        /// Groups of the parameter table: the elements in the order of the list, then the settings of the integration.
        pub const GROUPS: &[Group] = &[
            Group { name: stringify!($primary), meaning: <$Primary>::MEANING, parameters: <$Primary>::PARAMETERS },
            Group { name: stringify!($series), meaning: <$Series>::MEANING, parameters: <$Series>::PARAMETERS },
            $(Group { name: stringify!($law), meaning: <$Law>::MEANING, parameters: <$Law>::PARAMETERS },)*
            $(Group {
                name: stringify!($hydraulic),
                meaning: <$Hydraulic>::MEANING,
                parameters: <$Hydraulic>::PARAMETERS,
            },)*
            $(Group { name: stringify!($inner), meaning: <$Inner>::MEANING, parameters: <$Inner>::PARAMETERS },)*
            $(Group { name: stringify!($friction), meaning: <$Friction>::MEANING, parameters: <$Friction>::PARAMETERS },)*
            $(Group { name: stringify!($preload), meaning: <$Preload>::MEANING, parameters: <$Preload>::PARAMETERS },)*
            $(Group { name: stringify!($memory), meaning: <$Memory>::MEANING, parameters: <$Memory>::PARAMETERS },)*
            $(Group { name: stringify!($stop), meaning: <$Stop>::MEANING, parameters: <$Stop>::PARAMETERS },)*
            Group { name: stringify!($settings), meaning: <$Settings>::MEANING, parameters: <$Settings>::PARAMETERS },
        ];

        /// Where the element of a group acts.
        pub fn acts(group: usize) -> Acts {
            const fn acts(place: Acts, _: Place) -> Acts {
                place
            }
            const ACTS: &[Acts] = &[
                Acts::Primary,
                Acts::Series,
                $(acts(Acts::SeriesLaw, Place::$law),)*
                $(acts(Acts::Hydraulic, Place::$hydraulic),)*
                $(acts(Acts::Inner, Place::$inner),)*
                $(acts(Acts::Friction, Place::$friction),)*
                $(acts(Acts::Preload, Place::$preload),)*
                $(acts(Acts::Memory, Place::$memory),)*
                $(acts(Acts::Stop, Place::$stop),)*
            ];
            ACTS.get(group).copied().unwrap_or(Acts::Nowhere)
        }

        /// Number of elements: the groups without the settings.
        pub const COUNT: usize = Place::$settings as usize;

        /// Elements of the default model.
        pub const DEFAULT_ON: u64 = 0 $(| 1 << Place::$default as usize)*;

        /// The prepared elements of one model.
        #[derive(Clone, Copy, Debug)]
        #[repr(C)]
        pub struct Elements {
            on: u64,
            /// The primary damper.
            pub $primary: $Primary,
            /// The series compliance.
            pub $series: $Series,
            $(pub(crate) $law: $Law,)*
            $(pub(crate) $hydraulic: $Hydraulic,)*
            $($inner: $Inner,)*
            $($friction: $Friction,)*
            $($preload: $Preload,)*
            $($memory: $Memory,)*
            $($stop: $Stop,)*
            /// Where the states of the coupled paths are kept.
            slots: Slots,
            /// What acts in their stages.
            acting: u32,
        }

        impl Elements {
            /// No element.
            pub const OFF: Elements = Elements {
                on: 0,
                $primary: <$Primary>::OFF,
                $series: <$Series>::OFF,
                $($law: <$Law>::OFF,)*
                $($hydraulic: <$Hydraulic>::OFF,)*
                $($inner: <$Inner>::OFF,)*
                $($friction: <$Friction>::OFF,)*
                $($preload: <$Preload>::OFF,)*
                $($memory: <$Memory>::OFF,)*
                $($stop: <$Stop>::OFF,)*
                slots: Slots::NONE,
                acting: 0,
            };

            /// Whether the elements that are on can be prepared, one by one and together.
            ///
            /// # Errors
            /// The parameter that does not fit.
            pub fn check(params: &Params) -> Result<(), Fault> {
                let on = |place: Place| params.elements() & (1 << place as usize) != 0;
                macro_rules! each {
                    ($name:ident, $Type:ty) => {
                        if on(Place::$name) {
                            checked::<$Type>(params, Place::$name as usize)?;
                        }
                    };
                }
                each!($primary, $Primary);
                each!($series, $Series);
                $(each!($law, $Law);)*
                $(each!($hydraulic, $Hydraulic);)*
                $(each!($inner, $Inner);)*
                $(each!($friction, $Friction);)*
                $(each!($preload, $Preload);)*
                $(each!($memory, $Memory);)*
                $(each!($stop, $Stop);)*
                if !on(Place::$series) {
                    $(if on(Place::$law) {
                        return Err(View::<$Law>::new(params, Place::$law as usize).fault_of_all(Reason::NeedsSeries));
                    })*
                }
                const MEMORY: u64 = 0 $(| 1 << Place::$memory as usize)*;
                let beside = (params.elements() & MEMORY).count_ones() as usize;
                if paths::states_of(params) + beside > MAX_MEMORY {
                    return Err(Fault { parameter: NO_PARAMETER, reason: Reason::TooManyStates });
                }
                Ok(())
            }

            /// Largest slope of the elements on the internal mass over the displacements `places`.
            ///
            /// # Errors
            /// The parameter that does not fit.
            #[inline(never)]
            pub fn steepest_inner(params: &Params, places: impl Iterator<Item = f64>) -> Result<f64, Fault> {
                $(
                    let mut $inner = <$Inner>::OFF;
                    if params.elements() & (1 << Place::$inner as usize) != 0 {
                        $inner.set(&View::new(params, Place::$inner as usize))?;
                    }
                )*
                let mut steepest = 0.0;
                for displacement in places {
                    let at = Motion { displacement, velocity: 0.0, side_force: 0.0, temperature: 20.0 };
                    let slope = 0.0 $(+ $inner.force(&at).by_x)*;
                    steepest = if slope > steepest { slope } else { steepest };
                }
                Ok(steepest)
            }

            /// Prepares the elements that are on, where they are kept, from a set that [`Elements::check`] accepted.
            pub fn set(&mut self, params: &Params) {
                let on = params.elements();
                self.on = on;
                macro_rules! each {
                    ($name:ident) => {
                        placed(&mut self.$name, on & (1 << Place::$name as usize) != 0, params, Place::$name as usize);
                    };
                }
                each!($primary);
                each!($series);
                $(each!($law);)*
                $(each!($hydraulic);)*
                $(each!($inner);)*
                $(each!($friction);)*
                $(each!($preload);)*
                $(each!($memory);)*
                $(each!($stop);)*
                if self.has_series() && self.$series.carries_whole {
                    self.on |= CARRIES_WHOLE;
                }
                self.slots = paths::slots(self);
                self.acting = paths::acting::of(self);
            }

            #[inline(always)]
            fn has(&self, place: Place) -> bool {
                self.on & (1 << place as usize) != 0
            }

            /// Whether the series compliance is on: without it the internal mass is the driven end.
            #[inline(always)]
            pub fn has_series(&self) -> bool {
                self.has(Place::$series)
            }

            /// Whether friction and preload act on the internal mass, behind the series compliance.
            #[inline(always)]
            pub fn carries_whole(&self) -> bool {
                self.on & CARRIES_WHOLE != 0
            }

            /// Sum of all that acts on the internal mass beside the FV curve, wherever it belongs.
            #[inline(always)]
            pub fn on_the_mass(&self, at: &Motion) -> Response {
                let mut sum = self.inner(at);
                if self.carries_whole() {
                    let behind = self.behind(at);
                    sum.add(behind.friction);
                    sum.add(behind.preload);
                }
                sum
            }

            /// Friction and preload of a damper whose series compliance carries the whole, out of the way of all others.
            #[inline(never)]
            pub fn behind(&self, at: &Motion) -> Outer {
                Outer { friction: self.friction(at), preload: self.preload(at) }
            }

            /// Friction and preload beside the whole damper: nothing where they act on the mass.
            #[inline(always)]
            pub fn beside(&self, at: &Motion) -> Outer {
                if self.carries_whole() {
                    return Outer::NONE;
                }
                Outer { friction: self.friction(at), preload: self.preload(at) }
            }

            /// Sum of the elements that always act on the internal mass.
            #[inline(always)]
            pub fn inner(&self, at: &Motion) -> Response {
                let mut sum = Response::NONE;
                $(if self.has(Place::$inner) { sum.add(self.$inner.force(at)); })*
                sum
            }

            /// Whether one of them bends so sharply that no straight line holds for a stage.
            #[inline(always)]
            pub fn bends(&self) -> bool {
                false $(|| self.has(Place::$inner) && self.$inner.bends())*
            }

            /// As [`Elements::inner`] where all of them answer at once.
            #[inline(always)]
            pub fn inner_at_once(&self, at: &Motion) -> Option<Response> {
                let mut sum = Response::NONE;
                $(if self.has(Place::$inner) { sum.add(self.$inner.at_once(at)?); })*
                Some(sum)
            }

            /// Sum of the friction elements beside the whole damper.
            #[inline(always)]
            pub fn friction(&self, at: &Motion) -> Response {
                let mut sum = Response::NONE;
                $(if self.has(Place::$friction) { sum.add(self.$friction.force(at)); })*
                sum
            }

            /// As [`Elements::friction`] where all of them answer at once.
            #[inline(always)]
            pub fn friction_at_once(&self, at: &Motion) -> Option<Response> {
                let mut sum = Response::NONE;
                $(if self.has(Place::$friction) { sum.add(self.$friction.at_once(at)?); })*
                Some(sum)
            }

            /// Sum of the position forces beside the whole damper.
            #[inline(always)]
            pub fn preload(&self, at: &Motion) -> Response {
                let mut sum = Response::NONE;
                $(if self.has(Place::$preload) { sum.add(self.$preload.force(at)); })*
                sum
            }

            /// As [`Elements::preload`] where all of them answer at once.
            #[inline(always)]
            pub fn preload_at_once(&self, at: &Motion) -> Option<Response> {
                let mut sum = Response::NONE;
                $(if self.has(Place::$preload) { sum.add(self.$preload.at_once(at)?); })*
                Some(sum)
            }

            /// Sum of the stops at the ends of the stroke.
            pub fn stops(&self, at: &Motion) -> Response {
                let mut sum = Response::NONE;
                $(if self.has(Place::$stop) { sum.add(self.$stop.force(at)); })*
                sum
            }

            /// Names and units of the private states of the elements beside the damper, in their order.
            pub fn each_memory_name(&self, mut visit: impl FnMut(&'static str)) {
                $(if self.has(Place::$memory) {
                    visit(stringify!($memory));
                })*
            }

            /// Which of them are on, as bits in their order.
            pub(crate) fn memory_bits(&self) -> u64 {
                let (mut bits, mut next) = (0, 1);
                $(if self.has(Place::$memory) {
                    bits |= next;
                }
                next <<= 1;)*
                let _ = next;
                bits
            }

            /// Number of private states.
            pub fn memories(&self) -> usize {
                const MEMORY: u64 = 0 $(| 1 << Place::$memory as usize)*;
                self.slots.count() + (self.on & MEMORY).count_ones() as usize
            }

            /// Whether an element of the series path or the hydraulic path is on: see [`crate::paths`].
            #[inline(always)]
            pub fn has_paths(&self) -> bool {
                const PATHS: u64 = CARRIES_WHOLE $(| 1 << Place::$law as usize)* $(| 1 << Place::$hydraulic as usize)*;
                self.on & PATHS != 0
            }

            /// Whether an element is on that most dampers do not have: one beside the damper with a private state, a stop,
            /// or one of the coupled paths.
            #[inline(always)]
            pub fn has_extras(&self) -> bool {
                const EXTRAS: u64 = CARRIES_WHOLE $(| 1 << Place::$memory as usize)* $(| 1 << Place::$stop as usize)*
                    $(| 1 << Place::$law as usize)* $(| 1 << Place::$hydraulic as usize)*;
                self.on & EXTRAS != 0
            }

            /// Whether an element beside the damper is on that has a private state or is a stop.
            #[inline(always)]
            pub fn has_beside(&self) -> bool {
                const BESIDE: u64 = 0 $(| 1 << Place::$memory as usize)* $(| 1 << Place::$stop as usize)*;
                self.on & BESIDE != 0
            }

            /// Whether the internal mass is there and nothing that its plain step does not know.
            #[inline(always)]
            pub fn is_plain_mass(&self) -> bool {
                const MASS: u64 = 1 << Place::$series as usize;
                const REST: u64 = MASS | CARRIES_WHOLE $(| 1 << Place::$memory as usize)* $(| 1 << Place::$stop as usize)*
                    $(| 1 << Place::$law as usize)* $(| 1 << Place::$hydraulic as usize)*;
                self.on & REST == MASS
            }

            /// Calls `visit` with the place of its state and the element, for each element with memory that is on.
            #[inline(always)]
            pub fn each_memory(&self, mut visit: impl FnMut(usize, &dyn Memory)) {
                let mut place = self.slots.count();
                $(if self.has(Place::$memory) {
                    visit(place, &self.$memory);
                    place += 1;
                })*
                debug_assert!(place <= MAX_MEMORY);
            }
        }
    };
}

elements! {
    primary { fv_curve: fv_curve::FvCurve }
    series { series_compliance: series_compliance::SeriesCompliance }
    series_law {
        free_play: free_play::FreePlay,
        bushing: bushing::Bushing,
    }
    hydraulic {
        oil_compressibility: oil_compressibility::OilCompressibility,
        aeration: aeration::Aeration,
        cavitation: cavitation::Cavitation,
        position_dependent_damping: position_dependent_damping::PositionDependentDamping,
        temperature_fade: temperature_fade::TemperatureFade,
        frequency_selective_damping: frequency_selective_damping::FrequencySelectiveDamping,
        valve_hysteresis: valve_hysteresis::ValveHysteresis,
    }
    inner {
        parallel_spring: parallel_spring::ParallelSpring,
    }
    friction {
        coulomb_friction: coulomb_friction::CoulombFriction,
        stribeck_friction: stribeck_friction::StribeckFriction,
        viscous_friction: viscous_friction::ViscousFriction,
        side_force_friction: side_force_friction::SideForceFriction,
    }
    preload {
        gas_preload: gas_preload::GasPreload,
        gas_warming: gas_warming::GasWarming,
    }
    memory {
        lagged_polynomial: lagged_polynomial::LaggedPolynomial,
        presliding_friction: presliding_friction::PreslidingFriction,
        gas_spring: gas_spring::GasSpring,
        moving_mass: moving_mass::MovingMass,
    }
    stops {
        bump_stop: bump_stop::BumpStop,
        rebound_stop: rebound_stop::ReboundStop,
    }
    default { fv_curve, series_compliance, parallel_spring, stribeck_friction, viscous_friction, gas_preload, }
    settings { integration: crate::step::Integration }
}

/// What the coupled paths ask for.
impl Elements {
    /// Gives one element what another one brings along: the internal mass, a mass inside; a late valve, the FV curve.
    pub(crate) fn join(&mut self) {
        if self.has_valve() {
            self.valve_hysteresis.join(&self.fv_curve);
        }
        if self.has_series() {
            self.moving_mass.join(&mut self.series_compliance.mass);
        }
    }

    #[inline(always)]
    pub(crate) fn has_free_play(&self) -> bool {
        self.has(Place::free_play)
    }

    #[inline(always)]
    pub(crate) fn has_bushing(&self) -> bool {
        self.has(Place::bushing)
    }

    /// Whether a part of the bushing gives way slowly.
    #[inline(always)]
    pub(crate) fn has_slow_bushing(&self) -> bool {
        self.has_bushing() && self.bushing.slow_share > 0.0
    }

    #[inline(always)]
    pub(crate) fn has_cavitation(&self) -> bool {
        self.has(Place::cavitation)
    }

    #[inline(always)]
    pub(crate) fn has_position(&self) -> bool {
        self.has(Place::position_dependent_damping) && !self.position_dependent_damping.is_groove
    }

    /// Whether position-dependent damping is a flow beside the valves.
    #[inline(always)]
    pub(crate) fn has_groove(&self) -> bool {
        self.has(Place::position_dependent_damping) && self.position_dependent_damping.is_groove
    }

    /// Whether frequency-selective damping is a flow beside the valves.
    #[inline(always)]
    pub(crate) fn has_passage(&self) -> bool {
        self.has(Place::frequency_selective_damping) && self.frequency_selective_damping.is_bypass
    }

    #[inline(always)]
    pub(crate) fn has_fade(&self) -> bool {
        self.has(Place::temperature_fade)
    }

    #[inline(always)]
    pub(crate) fn has_frequency_selective(&self) -> bool {
        self.has(Place::frequency_selective_damping) && !self.frequency_selective_damping.is_bypass
    }

    #[inline(always)]
    pub(crate) fn has_valve(&self) -> bool {
        self.has(Place::valve_hysteresis)
    }

    /// Whether the valve has mass.
    #[inline(always)]
    pub(crate) fn has_spool(&self) -> bool {
        self.has_valve() && self.valve_hysteresis.is_spool()
    }

    /// Whether there is an oil column that yields.
    #[inline(always)]
    pub(crate) fn has_column(&self) -> bool {
        self.has(Place::oil_compressibility) || self.has(Place::aeration)
    }

    /// Whether the oil column is shorter at one end of the stroke than at the other.
    #[inline(always)]
    pub(crate) fn has_length(&self) -> bool {
        self.has(Place::oil_compressibility) && self.oil_compressibility.has_length()
    }

    #[inline(always)]
    pub(crate) fn has_aeration(&self) -> bool {
        self.has(Place::aeration)
    }

    /// What acts in the stages of the coupled paths: bits of [`crate::paths::acting`].
    #[inline(always)]
    pub(crate) fn acting(&self) -> u32 {
        self.acting
    }

    /// Where the states of the coupled paths are kept.
    #[inline(always)]
    pub(crate) fn slots(&self) -> &Slots {
        &self.slots
    }
}

/// The names of all elements, in the order of the list.
pub fn names() -> impl Iterator<Item = &'static str> {
    GROUPS.iter().take(COUNT).map(|group| group.name)
}
