//! Files of Adams: damper properties, models, commands.

pub mod akima;
mod dataset;
mod expression;
pub mod folder;
mod native;
pub mod patch;
pub mod property;
