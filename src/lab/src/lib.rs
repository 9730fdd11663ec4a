//! Everything before the simulator: rig records, identification, validation, the model file.
//!
//! | module | what |
//! |---|---|
//! | [`records`] | reading and cleaning rig records, sign, noise floor |
//! | [`motion`] | the measured motion, freed of noise before it drives a model |
//! | [`identification`] | from records to parameters with intervals |
//! | [`model_file`] | the model file, read and written |
//! | [`prediction`] | the forces a model gives for a record |
//! | [`imposed_motion`] | motions that a user imposes on a model |
//! | [`validation`] | error figures, error matrix, hysteresis |
//! | [`diagnosis`] | where model and records disagree, and which effect is missing |
//! | [`vehicle`] | a vehicle on four dampers, and the manoeuvres it drives |
//! | [`accuracy`] | error of the fixed step against a converged solution |

pub mod accuracy;
pub mod diagnosis;
pub mod identification;
pub mod imposed_motion;
pub mod model_file;
pub mod motion;
pub mod prediction;
pub mod records;
pub mod validation;
pub mod vehicle;
