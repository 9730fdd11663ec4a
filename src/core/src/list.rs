//! List of the elements of the model. Each element is one physical effect.
//!
//! A new effect is a new file with its equation, parameters, states and partial derivatives in `elements/`, and one
//! line in this file. The block of the line defines the position of the effect in the model:
//!
//! - `inner`: on the internal mass, driven by its displacement and velocity (inside the series compliance);
//! - `friction` and `preload`: parallel to the whole damper, driven by the motion of the moving end;
//! - `stateful`: parallel to the whole damper, with one internal state;
//! - `stops`: parallel to the whole damper, at the ends of its stroke.
//!
//! The block also defines the output to which a force is added, besides the total force: `inner` the spring force,
//! `friction` the friction force, `preload` the gas force, and `stops` the stop force. An element of `stateful` selects
//! its output by [`crate::element::StatefulForce::component`].
//!
//! The block `default` names the elements that are on in a new parameter set. The name of a line is the name of the
//! element in model files.
//!
//! The coupled elements in the force path come first; their list is [`crate::paths::list`].
//!
//! Internal states are stored in [`crate::State::internal`] in the order of the list, only for elements that are on.
//!
//! `T` is the owner of an element's tables ([`crate::tables`]). `T` must be in scope where the list is expanded.
//!
//! Code that needs the list passes the name of a macro to [`each_element!`], which calls that macro with all blocks.
//! [`crate::parameter::groups`] makes the groups of the parameter table in this way, and [`crate::assembly`] the set of
//! prepared elements.

/// Calls the macro `then!` with the list of elements.
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
