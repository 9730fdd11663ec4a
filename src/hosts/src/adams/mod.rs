//! Files of Adams: damper properties, models, commands.

mod dataset;
mod expression;
pub mod folder;
mod native;
pub mod patch;
pub mod property;
