//! placeholder
pub mod accuracy;
pub mod records;
pub mod validation;
pub mod identification;
pub mod imposed_motion;
pub mod motion;
pub mod model_file;
pub mod prediction;
