//! Files of Adams: damper properties, models, commands.

pub mod dpr;
pub mod folder;
pub mod gas_preload;
mod native;
pub mod patch;
