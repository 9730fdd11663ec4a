//! The damper model: parameters, elements, states, force, rates and partial derivatives.
//!
//! SI units. Extension (rebound) velocity and tension force are positive: a damper that resists extension has a
//! positive force. `no_std`, no allocation, no `unsafe`, no panic path, the same digits on every platform.
//!
//! The equations (source: Jonnalagadda & Vyas, *Modelling of Automotive Suspension Damper*, KTH 2020, chapter 3):
//!
//! ```text
//! x_in = x_0 + ∫ v_in dt                                 [`input`]
//! F_s  = k_s (x_in − x_m) + c_s (v_in − v_m)             [`elements`: series_compliance]
//! m dv_m/dt = F_s − F_p(x_m) − F_d(v_m),  dx_m/dt = v_m  [`elements`: parallel_spring, fv_curve]
//! F = F_s + F_friction(v_in) + F_gas                     [`elements`: the rest]
//! ```
//!
//! x_in, m, and v_in, m/s, are displacement and velocity of the moving end, which starts at x_0. The internal mass m,
//! kg, has displacement x_m and velocity v_m. F is the damper force, and F_s the force of the series spring k_s and
//! damper c_s. F_p is the force of the parallel spring, and F_d that of the force–velocity (FV) curve, all in N. Free
//! play and bushing in the series compliance extend F_s. Oil, air, voids and valves before the FV curve extend F_d: see
//! [`paths`]. The compliance of an eye or a mount carries the whole damper force. The parameter `series_load` selects
//! this case: friction and gas act on the mass, at x_m and v_m. F is then F_s plus the forces of the moving mass, the
//! lagged polynomial and the stops.
//!
//! The host is the simulation program that calls the damper. [`evaluate()`] returns force and state derivatives at one
//! instant; [`step()`] advances by one step of the host.

#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate std;

pub mod assembly;
pub mod curve;
pub mod dual;
pub mod element;
pub mod elements;
pub mod equilibrium;
pub mod evaluate;
pub mod family;
pub mod fault;
pub mod input;
pub mod integration;
mod laid_out;
mod layout;
pub mod list;
pub mod math;
pub mod model;
pub mod model_file;
pub mod number;
mod own_tables;
pub mod parameter;
pub mod paths;
mod preparing;
mod proportion;
pub mod schema;
pub mod settings;
pub mod state;
pub mod step;
pub mod tables;

pub use evaluate::{Partials, evaluate};
pub use fault::{Fault, Reason};
pub use input::Input;
pub use model::Model;
pub use parameter::Params;
pub use schema::Parameter;
pub use state::{Output, State};
pub use step::step;
