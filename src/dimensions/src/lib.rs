//! Drawing of a damper: bore, rod, chambers, gas, oil, tube and eyes.
//!
//! In the forward direction, a drawing gives priors for the parameters of the model ([`forward`]). In the inverse
//! direction, an identified model gives gas pressure, moduli, passages and air with intervals ([`inverse`]). Both
//! directions use one set of formulas, which are independent of files and models.
//!
//! | module | contents |
//! |---|---|
//! | [`entry`], [`dimensions`], [`read`](mod@read) | entries of the drawing, and the file |
//! | [`uncertain`] | numbers with intervals, and formulas of such numbers |
//! | [`geometry`], [`oil`], [`gas`], [`orifice`] | the formulas |
//! | [`forward`] | priors that follow from a drawing |
//! | [`inverse`] | physical quantities of the damper from a model |

pub mod dimensions;
pub mod entry;
pub mod error;
pub mod forward;
pub mod gas;
pub mod geometry;
pub mod inverse;
pub mod oil;
pub mod orifice;
mod phrases;
pub mod read;
pub mod uncertain;

pub use dimensions::{Design, Dimensions};
pub use entry::Entry;
pub use error::DimensionsError;
pub use inverse::{Explanation, explain};
pub use phrases::{templates, words};
pub use read::read;
