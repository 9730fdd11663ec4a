//! Files of Adams: damper properties, models, commands.

mod dataset;
pub mod dpr;
mod expression;
pub mod folder;
pub mod gas_preload;
mod native;
pub mod patch;
