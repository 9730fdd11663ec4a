//! The prepared elements of one model, and the sums of their forces by position in the model.

use crate::element::{Force, OperatingPoint, Prepare, Response, StateResponse, StateVisitor, StatefulForce};
use crate::family::lending::{Numbers, kept, lent_or_renewed, numbers_at_setting};
use crate::family::section::{Lent, Section};
use crate::fault::{Fault, NO_PARAMETER, Reason};
use crate::list::each_element;
use crate::math::max;
use crate::parameter::Params;
use crate::parameter::groups::GroupIndex;
use crate::paths::bits::{FADE, SERIES};
use crate::paths::slots::states_of;
use crate::paths::{Paths, RenewedPaths};
use crate::preparing::{Keep, checked, placed};
use crate::state::{MAX_INTERNAL, Output};
use crate::tables::{Owned, OwnedElement, Tables};

/// Friction and preload (gas force): parallel to the damper, or on the internal mass if the series compliance carries
/// the whole force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outer {
    /// Friction without internal state.
    pub friction: Response,
    /// Preload: forces of the gas elements without internal state.
    pub preload: Response,
}

impl Outer {
    /// No force.
    pub const NONE: Outer = Outer { friction: Response::NONE, preload: Response::NONE };
}

/// Flag in the bit set of the elements that are on: friction and preload act on the internal mass.
const CARRIES_WHOLE: u64 = 1 << 63;
/// Flag in the bit set of the elements that are on: an element with an internal state acts on the internal mass.
const STATES_ON_MASS: u64 = 1 << 62;

/// Expands the list of elements into the struct of the prepared elements and the sums of their forces.
macro_rules! assembled {
    (
        primary { $primary:ident: $Primary:ty }
        series { $series:ident: $Series:ty }
        series_law { $($law:ident: $Law:ty,)* }
        hydraulic { $($hydraulic:ident: $Hydraulic:ty,)* }
        late { $late:ident: $Late:ty }
        inner { $($inner:ident: $Inner:ty,)* }
        friction { $($friction:ident: $Friction:ty,)* }
        preload { $($preload:ident: $Preload:ty,)* }
        stateful { $($stateful:ident: $Stateful:ty,)* }
        stops { $($stop:ident: $Stop:ty,)* }
        default { $($default:ident,)* }
        settings { $settings:ident: $Settings:ty }
    ) => {
        /// The prepared elements of one model.
        #[derive(Clone, Copy, Debug)]
        #[repr(C)]
        pub struct Elements<T: Tables = Owned> {
            on: u64,
            /// The elements in the series and the hydraulic path, which act on each other.
            pub paths: Paths<T>,
            $($inner: $Inner,)*
            $($friction: T::Kept<$Friction>,)*
            $($preload: T::Kept<$Preload>,)*
            $($stateful: T::Kept<$Stateful>,)*
            $($stop: T::Kept<$Stop>,)*
        }

        impl Elements {
            /// A model with all elements switched off.
            pub const OFF: Elements = {
                type T = Owned;
                Elements {
                on: 0,
                paths: Paths::OFF,
                $($inner: <$Inner>::OFF,)*
                $($friction: OwnedElement(<$Friction>::OFF),)*
                $($preload: OwnedElement(<$Preload>::OFF),)*
                $($stateful: OwnedElement(<$Stateful>::OFF),)*
                $($stop: OwnedElement(<$Stop>::OFF),)*
                }
            };

            /// Checks the parameters of all elements that are on: first each element alone, then whether the elements
            /// fit together.
            ///
            /// # Errors
            /// Returns the parameter at fault. More than [`MAX_INTERNAL`] internal states are an error without a
            /// parameter.
            pub fn check(params: &Params) -> Result<(), Fault> {
                type T = Owned;
                let on = |place: GroupIndex| params.elements() & (1 << place as usize) != 0;
                macro_rules! each {
                    ($name:ident, $Type:ty) => {
                        if on(GroupIndex::$name) {
                            checked::<$Type>(params, GroupIndex::$name as usize)?;
                        }
                    };
                }
                Paths::check(params)?;
                $(each!($inner, $Inner);)*
                $(each!($friction, $Friction);)*
                $(each!($preload, $Preload);)*
                $(each!($stateful, $Stateful);)*
                $(each!($stop, $Stop);)*
                Paths::check_together(params)?;
                if Elements::memories_of(params) > MAX_INTERNAL {
                    return Err(Fault { parameter: NO_PARAMETER, reason: Reason::TooManyStates });
                }
                Ok(())
            }

            /// Returns the number of internal states of the elements that are on in a parameter set.
            pub(crate) fn memories_of(params: &Params) -> usize {
                const MEMORY: u64 = 0 $(| 1 << GroupIndex::$stateful as usize)*;
                states_of(params) + (params.elements() & MEMORY).count_ones() as usize
            }

            /// Computes the largest sum of the stiffnesses ∂F/∂x of the elements on the internal mass, N/m, over the
            /// displacements `places` in m. The velocity is 0, and the result is at least 0.
            ///
            /// # Errors
            /// Returns the parameter at fault.
            #[inline(never)]
            pub fn steepest_inner(params: &Params, places: impl Iterator<Item = f64>) -> Result<f64, Fault> {
                type T = Owned;
                $(
                    let mut $inner = <$Inner>::OFF;
                    if params.elements() & (1 << GroupIndex::$inner as usize) != 0 {
                        $inner.set(&params.view(GroupIndex::$inner as usize))?;
                    }
                )*
                let mut steepest = 0.0;
                for displacement in places {
                    let at = OperatingPoint { displacement, velocity: 0.0, side_force: 0.0, temperature: 20.0 };
                    let derivative = 0.0 $(+ $inner.force(&at).d_force_d_x)*;
                    steepest = max(derivative, steepest);
                }
                Ok(steepest)
            }

            /// Prepares in place the elements that are on, from parameters that [`Elements::check`] accepted.
            pub fn set(&mut self, params: &Params) {
                let on = params.elements();
                self.on = on;
                macro_rules! each {
                    ($name:ident) => {
                        placed(self.$name.kept(), on & (1 << GroupIndex::$name as usize) != 0, params, GroupIndex::$name as usize);
                    };
                }
                self.paths.set(params);
                $(each!($inner);)*
                $(each!($friction);)*
                $(each!($preload);)*
                $(each!($stateful);)*
                $(each!($stop);)*
                if self.paths.carries_whole() {
                    self.on |= CARRIES_WHOLE;
                    $(if self.has(GroupIndex::$stateful) && self.$stateful.acts_on_mass() {
                        self.on |= STATES_ON_MASS;
                    })*
                }
            }

            /// Returns the elements of a family at a setting, with the FV curve `fv` and the parameters `numbers` of
            /// that setting. Each element is borrowed from the family or from `renewed`, which stores the elements that
            /// are prepared for the setting.
            #[inline(always)]
            pub(crate) fn lent<'a>(
                &'a self,
                fv: Section<'a>,
                numbers: &impl Numbers,
                renewed: &'a mut Renewed,
            ) -> Elements<Lent<'a>> {
                type T = Owned;
                macro_rules! each {
                    ($name:ident, $Type:ty) => {
                        kept!(self, numbers, renewed, $name, $Type)
                    };
                }
                Elements {
                    on: self.on,
                    paths: self.paths.lent(fv, numbers, &mut renewed.paths),
                    $($inner: lent_or_renewed!(self, numbers, $inner, $Inner),)*
                    $($friction: each!($friction, $Friction),)*
                    $($preload: each!($preload, $Preload),)*
                    $($stateful: each!($stateful, $Stateful),)*
                    $($stop: each!($stop, $Stop),)*
                }
            }
        }

        /// Elements that were prepared again for one setting of a family.
        pub(crate) struct Renewed {
            paths: RenewedPaths,
            $($friction: Option<$Friction>,)*
            $($preload: Option<$Preload>,)*
            $($stateful: Option<$Stateful>,)*
            $($stop: Option<$Stop>,)*
        }

        impl Renewed {
            /// Returns a set in which no element is prepared. It is a function, because each use of a constant would
            /// copy the whole set.
            #[inline(always)]
            pub(crate) fn none() -> Renewed {
                Renewed {
                    paths: RenewedPaths::none(),
                    $($friction: None,)*
                    $($preload: None,)*
                    $($stateful: None,)*
                    $($stop: None,)*
                }
            }
        }

        impl<T: Tables> Elements<T> {
            #[inline(always)]
            fn has(&self, place: GroupIndex) -> bool {
                self.on & (1 << place as usize) != 0
            }

            /// Returns whether the series compliance is on: without it the internal mass moves with the moving end.
            #[inline(always)]
            pub fn has_series(&self) -> bool {
                self.paths.has_series()
            }

            /// Returns whether friction and preload act on the internal mass, behind the series compliance.
            #[inline(always)]
            pub fn carries_whole(&self) -> bool {
                self.on & CARRIES_WHOLE != 0
            }

            /// Sums all forces on the internal mass of elements without internal state, except the hydraulic and the
            /// series force.
            #[inline(always)]
            pub fn on_the_mass(&self, at: &OperatingPoint) -> Response {
                let mut sum = self.inner(at);
                if self.carries_whole() {
                    let behind = self.outer(at);
                    sum.add(behind.friction);
                    sum.add(behind.preload);
                }
                sum
            }

            /// Sums friction and preload, parallel to the damper or on the mass. Not inlined, because several copies of
            /// the code cost more time than the call. Only the plain step calls [`Elements::friction`] and
            /// [`Elements::preload`] directly.
            #[inline(never)]
            pub fn outer(&self, at: &OperatingPoint) -> Outer {
                Outer { friction: self.friction(at), preload: self.preload(at) }
            }

            /// Sums friction and preload parallel to the whole damper; zero if they act on the mass.
            #[inline(always)]
            pub fn parallel(&self, at: &OperatingPoint) -> Outer {
                if self.carries_whole() { Outer::NONE } else { self.outer(at) }
            }

            /// Sums the forces of the inner elements, which always act on the internal mass.
            #[inline(always)]
            pub fn inner(&self, at: &OperatingPoint) -> Response {
                let mut sum = Response::NONE;
                $(if self.has(GroupIndex::$inner) { sum.add(self.$inner.force(at)); })*
                sum
            }

            /// Returns whether an element on the internal mass may be too nonlinear for one linearization per stage of
            /// a step.
            #[inline(always)]
            pub fn is_nonlinear(&self) -> bool {
                false $(|| self.has(GroupIndex::$inner) && self.$inner.is_nonlinear())*
            }

            /// Sums the forces of the inner elements; requires that [`Elements::is_nonlinear`] is false.
            #[inline(always)]
            pub fn linear_force(&self, at: &OperatingPoint) -> Response {
                let mut sum = Response::NONE;
                $(if self.has(GroupIndex::$inner) { sum.add(self.$inner.linear_force(at)); })*
                sum
            }

            /// Sums the forces of the inner elements if all of them have a short form ([`Force::at_once`]); otherwise
            /// returns `None`.
            #[inline(always)]
            pub fn inner_at_once(&self, at: &OperatingPoint) -> Option<Response> {
                let mut sum = Response::NONE;
                $(if self.has(GroupIndex::$inner) { sum.add(self.$inner.at_once(at)?); })*
                Some(sum)
            }

            /// Sums the forces of the friction elements without internal state.
            #[inline(always)]
            pub fn friction(&self, at: &OperatingPoint) -> Response {
                let mut sum = Response::NONE;
                $(if self.has(GroupIndex::$friction) { sum.add(self.$friction.force(at)); })*
                sum
            }

            /// Sums the friction if all its elements have a short form ([`Force::at_once`]); otherwise returns `None`.
            #[inline(always)]
            pub fn friction_at_once(&self, at: &OperatingPoint) -> Option<Response> {
                let mut sum = Response::NONE;
                $(if self.has(GroupIndex::$friction) { sum.add(self.$friction.at_once(at)?); })*
                Some(sum)
            }

            /// Sums the preload, which is the force of the gas elements without internal state.
            #[inline(always)]
            pub fn preload(&self, at: &OperatingPoint) -> Response {
                let mut sum = Response::NONE;
                $(if self.has(GroupIndex::$preload) { sum.add(self.$preload.force(at)); })*
                sum
            }

            /// Sums the preload if all its elements have a short form ([`Force::at_once`]); otherwise returns `None`.
            #[inline(always)]
            pub fn preload_at_once(&self, at: &OperatingPoint) -> Option<Response> {
                let mut sum = Response::NONE;
                $(if self.has(GroupIndex::$preload) { sum.add(self.$preload.at_once(at)?); })*
                Some(sum)
            }

            /// Sums the forces of the stops at the ends of the stroke.
            pub fn stops(&self, at: &OperatingPoint) -> Response {
                let mut sum = Response::NONE;
                $(if self.has(GroupIndex::$stop) { sum.add(self.$stop.force(at)); })*
                sum
            }

            /// Calls `visit` with the names of the parallel elements with internal states that are on, in the order of
            /// the element list.
            pub fn each_stateful_name(&self, mut visit: impl FnMut(&'static str)) {
                $(if self.has(GroupIndex::$stateful) {
                    visit(stringify!($stateful));
                })*
            }

            /// Returns the parallel elements with internal states that are on, as bits in the order of the element
            /// list.
            pub(crate) fn memory_bits(&self) -> u64 {
                let (mut bits, mut next) = (0, 1);
                $(if self.has(GroupIndex::$stateful) {
                    bits |= next;
                }
                next <<= 1;)*
                let _ = next;
                bits
            }

            /// Returns the number of internal states of the elements that are on.
            pub fn memories(&self) -> usize {
                const MEMORY: u64 = 0 $(| 1 << GroupIndex::$stateful as usize)*;
                self.paths.slots().count() + (self.on & MEMORY).count_ones() as usize
            }

            /// Returns whether an element of the series path or the hydraulic path is on, besides the FV curve and the
            /// series compliance: see [`crate::paths`]. Also true if the series compliance carries the whole force.
            #[inline(always)]
            pub fn has_paths(&self) -> bool {
                const PATHS: u64 = CARRIES_WHOLE | Paths::<Owned>::COUPLED;
                self.on & PATHS != 0
            }

            /// Returns whether a parallel element is on that has an internal state or is a stop.
            #[inline(always)]
            pub fn has_stateful_or_stop(&self) -> bool {
                const STATEFUL_OR_STOP: u64 = 0 $(| 1 << GroupIndex::$stateful as usize)* $(| 1 << GroupIndex::$stop as usize)*;
                self.on & STATEFUL_OR_STOP != 0
            }

            /// Returns whether the series compliance is on, and no element is on that needs more than the cheap step of
            /// the mass.
            #[inline(always)]
            pub fn is_plain_mass(&self) -> bool {
                const REST: u64 = Paths::<Owned>::MASS | CARRIES_WHOLE | Paths::<Owned>::COUPLED $(| 1 << GroupIndex::$stateful as usize)* $(| 1 << GroupIndex::$stop as usize)*;
                self.on & REST == Paths::<Owned>::MASS
            }

            /// Calls `visitor` for each parallel element that is on and has one internal state, with code compiled for
            /// the element's type.
            #[inline(always)]
            pub fn visit_stateful(&self, visitor: &mut impl StateVisitor) {
                let mut place = self.paths.slots().count();
                $(if self.has(GroupIndex::$stateful) {
                    visitor.visit(place, &*self.$stateful);
                    place += 1;
                })*
                debug_assert!(place <= MAX_INTERNAL);
            }

            /// Returns whether any element with an internal state acts on the internal mass.
            #[inline(always)]
            pub fn has_states_on_mass(&self) -> bool {
                self.on & STATES_ON_MASS != 0
            }

            /// Returns whether `element`, which has an internal state, acts on the mass in this model.
            #[inline(always)]
            pub fn has_on_mass(&self, element: &(impl StatefulForce + ?Sized)) -> bool {
                self.carries_whole() && element.acts_on_mass()
            }

            /// Calls `visit` for each parallel element that is on and has an internal state. The arguments are the
            /// state's index and the element.
            #[inline(always)]
            pub fn each_stateful(&self, visit: impl FnMut(usize, &dyn StatefulForce)) {
                self.visit_stateful(&mut Shown(visit));
            }
        }
    };
}

each_element!(assembled);

/// Visitor that passes elements with internal states as trait objects to a function.
struct Shown<F>(F);

impl<F: FnMut(usize, &dyn StatefulForce)> StateVisitor for Shown<F> {
    #[inline(always)]
    fn visit<M: StatefulForce>(&mut self, place: usize, element: &M) {
        (self.0)(place, element);
    }
}

impl<T: Tables> Elements<T> {
    /// Moves friction and gas force from the spring force in `output` to their own outputs, if they act on the internal
    /// mass.
    #[inline(always)]
    pub(crate) fn hand_out(&self, output: &mut Output, mass: &OperatingPoint, internal: &[f64; MAX_INTERNAL]) {
        if self.carries_whole() {
            let Outer { friction, preload } = self.outer(mass);
            output.friction_force = friction.force;
            output.gas_force = preload.force;
            output.spring_force -= friction.force + preload.force;
            self.each_on_mass(mass, internal, |element, response| {
                output.count(element.component(), response.force);
                output.spring_force -= response.force;
            });
        }
    }

    /// Calls `visit` with element and response for each element that acts on the internal mass and has an internal
    /// state.
    #[inline(always)]
    pub(crate) fn each_on_mass(
        &self,
        mass: &OperatingPoint,
        internal: &[f64; MAX_INTERNAL],
        mut visit: impl FnMut(&dyn StatefulForce, StateResponse),
    ) {
        if !self.has_states_on_mass() {
            return;
        }
        self.each_stateful(|place, element| {
            if element.acts_on_mass() {
                visit(element, element.evaluate(mass, internal.get(place).copied().unwrap_or(0.0)));
            }
        });
    }

    /// Sums the forces of the elements that act on the internal mass and have an internal state, at given states.
    #[inline(always)]
    pub(crate) fn states_on_mass(&self, mass: &OperatingPoint, internal: &[f64; MAX_INTERNAL]) -> Response {
        let mut sum = Response::NONE;
        self.each_on_mass(mass, internal, |_, response| {
            sum.add(Response {
                force: response.force,
                d_force_d_x: response.d_force_d_x,
                d_force_d_v: response.d_force_d_v,
            });
        });
        sum
    }
}

impl<T: Tables> Elements<T> {
    /// Returns whether the damper can use the plain step ([`mod@crate::step`]) although its force fades with
    /// temperature.
    ///
    /// The fade must be the only element of the force path. It must scale the whole FV curve by a factor that depends
    /// on the host's temperature alone. The springs must be linear enough, because the plain step does not solve
    /// nonlinear ones to rounding accuracy.
    #[inline(always)]
    pub(crate) fn fades_alone(&self) -> bool {
        self.paths.acting() & !SERIES == FADE && self.paths.temperature_fade.is_of_all() && !self.is_nonlinear()
    }
}

impl Elements {
    /// Prepares what depends on several elements. For example, adds a moving mass inside the damper to the internal
    /// mass.
    pub(crate) fn join(&mut self) {
        self.paths.join();
        if self.has_series() {
            self.moving_mass.join(&mut self.paths.series_compliance.mass);
        }
    }
}
