//! The one list that puts the physical effects into the model.
//!
//! A new effect is a new file with its equation, parameters, states and partials, in `elements/`, and one line here.
//! The line says where the effect acts:
//!
//! - `inner`: on the internal mass, driven by its displacement and velocity (inside the series compliance);
//! - `friction` and `preload`: beside the whole damper, driven by the input motion;
//! - `memory`: beside the whole damper, with one private state;
//! - `stops`: beside the whole damper, at the ends of its stroke.
//!
//! The elements in the way of the force, which act on each other, come first; their list is [`crate::paths::list`].
//!
//! Private states take a place in [`crate::State::memory`] in the order of the list, those of elements that are on only.
//!
//! `T` stands for whoever keeps the tables of an element ([`crate::tables`]): who calls the list has it in scope.
//!
//! Whoever needs the list hands the name of a macro to [`each_element!`], which calls it with all blocks: the table makes its groups of
//! them ([`crate::parameter::groups`]), the model its prepared set ([`crate::assembly`]).

/// Calls the macro `then!` with the list.
macro_rules! each_element {
    ($then:ident) => {
        $crate::paths::list::each_path_element! {
            $then
            inner {
                parallel_spring: $crate::elements::parallel_spring::ParallelSpring<T>,
            }
            friction {
                coulomb_friction: $crate::elements::coulomb_friction::CoulombFriction,
                stribeck_friction: $crate::elements::stribeck_friction::StribeckFriction,
                viscous_friction: $crate::elements::viscous_friction::ViscousFriction,
                side_force_friction: $crate::elements::side_force_friction::SideForceFriction,
            }
            preload {
                gas_preload: $crate::elements::gas_preload::GasPreload,
                gas_warming: $crate::elements::gas_warming::GasWarming,
            }
            stateful {
                lagged_polynomial: $crate::elements::lagged_polynomial::LaggedPolynomial,
                presliding_friction: $crate::elements::presliding_friction::PreslidingFriction,
                gas_spring: $crate::elements::gas_spring::GasSpring,
                moving_mass: $crate::elements::moving_mass::MovingMass,
            }
            stops {
                bump_stop: $crate::elements::bump_stop::BumpStop,
                rebound_stop: $crate::elements::rebound_stop::ReboundStop,
            }
            default { fv_curve, series_compliance, parallel_spring, stribeck_friction, viscous_friction, gas_preload, }
            settings { integration: $crate::settings::Settings }
        }
    };
}
pub(crate) use each_element;
