//! Simulation with damper models: of records, imposed motions, hosts and vehicles.
//!
//! | module | what |
//! |---|---|
//! | [`prediction`] | forces of a model for a record |
//! | [`step_response`] | response of the force to a step of the setting |
//! | [`valve_response`] | response of the valve, from the parameters of its actuator |
//! | [`warm_starts`] | temperature of the damper at the start of each record |
//! | [`own_setting`] | setting of a record, for a damper that depends on one |
//! | [`setting_doubts`] | records whose forces belong to another setting |
//! | [`comparison`] | comparison of a model and its FV curve with a campaign |
//! | [`against`] | comparison with models of the literature |
//! | [`whole_records`] | errors of a model over every sample of records |
//! | [`imposed_motion`] | motions that a user imposes on a model |
//! | [`motion_sign`] | sign of an imposed motion, from the force recorded with it |
//! | [`vehicle`] | a vehicle on four dampers, and its maneuvers |
//! | [`chatter`] | chatter of a damper in a host with a zero-order hold of its force |
//! | [`followed`] | check whether a step resolves an oscillating internal mass |
//! | [`stiffness`] | fastest rate of a damper's states, and the longest step of explicit solvers |
//! | [`accuracy`] | error of the model's fixed step relative to a converged solution |

pub mod accuracy;
pub mod against;
pub mod chatter;
pub mod comparison;
pub mod followed;
pub mod imposed_motion;
mod limit;
pub mod motion_sign;
pub mod own_setting;
pub mod prediction;
pub mod setting_doubts;
pub mod step_response;
pub mod stiffness;
pub mod valve_response;
pub mod vehicle;
pub mod warm_starts;
pub mod whole_records;
