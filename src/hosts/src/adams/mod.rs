//! Files of Adams: damper properties, models, commands.

pub mod akima;
mod dataset;
mod expression;
pub mod folder;
pub mod imported;
mod native;
pub mod patch;
pub mod property;
pub mod replaced;
