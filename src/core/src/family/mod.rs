//! Adjustable dampers: their parameters depend on a setting.
//!
//! The setting is, for example, the current of a semi-active valve, the click of an adjuster or a gas pressure. In such
//! a family of dampers, some parameters and the forces of the FV table are given over a grid of settings:
//!
//! | file | content |
//! |---|---|
//! | [`axis`] | data from the user: the grid, the values over it, the actuator |
//! | [`interpolation`] | monotone cubics between the grid values, limited so that no force decreases with velocity |
//! | [`actuator`] | from the commanded to the actual setting |
//! | [`delay`] | the dead time of the actuator |
//! | [`section`] | the tables of a damper at one setting, borrowed from the family |
//! | [`prepared`] | the prepared family: step, rates, partial derivatives |
//!
//! # Why parameters are interpolated instead of forces
//! At every setting, the family equals an ordinary damper with interpolated parameters ([`axis::Axis::params_at`]) and
//! one set of internal states. Two alternatives, which blend forces, were rejected:
//!
//! - Blended forces of one model per grid value, each with its own states. Friction, oil and mass would have a separate
//!   history for each setting, unlike any damper. A step would cost twice as much.
//! - Blended forces of these models with common states. Smooth positive weights that reproduce the grid values have
//!   zero derivative on the grid, so a controller would see zero gain there. With negative weights, the force may
//!   decrease with velocity.
//!
//! An ordinary damper only dissipates energy, and so does a family at a constant setting. Changes of the setting add no
//! energy if they affect dissipation only: see [`axis::Axis::stores_energy`].

pub mod actuator;
pub mod axis;
pub mod delay;
pub mod interpolation;
pub(crate) mod lending;
pub mod prepared;
pub(crate) mod section;

pub use axis::{Axis, Definition, LARGEST_SETTING};
pub use delay::Delay;
pub use prepared::{BySetting, Family};
