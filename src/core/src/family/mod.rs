//! One damper over a setting: the current of a semi-active valve, the click of an adjuster, a gas pressure.
//!
//! A family is a parameter set of which some numbers, and the forces of the FV table, are given over a grid of settings:
//!
//! | file | what |
//! |---|---|
//! | [`axis`] | what a user fills in: the grid, the values over it, the actuator |
//! | [`interpolation`] | between the grid: monotone cubics whose forces never fall over velocity |
//! | [`actuator`] | from the setting that the host commands to where the valve stands |
//! | [`delay`] | its dead time |
//! | [`section`] | the tables of a damper at one setting, borrowed from the family |
//! | [`prepared`] | the family made ready: step, rates, partials |
//!
//! # Why parameters are interpolated, and not forces
//! At every setting the family is the ordinary damper of the interpolated numbers ([`axis::Axis::at`]), with one set of internal states. The alternatives
//! were rejected for these reasons.
//!
//! - Models of the grid, each with states of its own, blended by force: friction, oil and mass would have one history for each setting, which no damper
//!   has, and a step would cost twice as much.
//! - Forces of the grid's models, blended over common states: weights that are positive, exact on the grid and continuous in their derivative have no
//!   derivative on the grid, so that a controller would find no gain there; weights that are not positive make a law that may fall over velocity.
//!
//! An ordinary damper only takes energy, so a family does at a constant setting, and changes of the setting add none as long as no number that stores
//! energy depends on it: see [`axis::Axis::stores_energy`].

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
