//! Adjustable dampers: their parameters depend on a setting.
//!
//! The setting is, for example, the current of a semi-active valve, the click of an adjuster or a gas pressure. In a
//! family, some parameters and the forces of the FV table are given over a grid of settings:
//!
//! | file | content |
//! |---|---|
//! | [`axis`] | data from the user: the grid, the values over it, the actuator |
//! | [`interpolation`] | between the grid values: monotone cubics whose forces never fall over velocity |
//! | [`actuator`] | from the commanded to the actual setting |
//! | [`delay`] | the dead time of the actuator |
//! | [`section`] | the tables of a damper at one setting, borrowed from the family |
//! | [`prepared`] | the prepared family: step, rates, partial derivatives |
//!
//! # Why parameters are interpolated, and not forces
//! At every setting the family is the ordinary damper of the interpolated numbers ([`axis::Axis::params_at`]), with one
//! set of internal states. The alternatives were rejected for these reasons.
//!
//! - Blended forces of one model per grid value, each with separate states: friction, oil and mass would have one
//!   history for each setting, which no damper has. A step would cost twice as much.
//! - Blended forces of these models over common states, with positive weights that are exact on the grid and smooth:
//!   such weights have zero derivative on the grid, so that a controller would find no gain there. With weights that
//!   are not positive, the force may fall over velocity.
//!
//! An ordinary damper only dissipates energy, and so does a family at a constant setting. Changes of the setting add no
//! energy if no number that stores energy depends on the setting: see [`axis::Axis::stores_energy`].

pub mod actuator;
pub mod axis;
pub mod delay;
pub mod interpolation;
pub(crate) mod lending;
pub mod prepared;
pub(crate) mod section;

pub use axis::{Axis, Definition};
pub use delay::Delay;
pub use prepared::{BySetting, Family};
