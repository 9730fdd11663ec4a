//! Models at work: what a model does with a motion.
//!
//! | module | what |
//! |---|---|
//! | [`prediction`] | the forces a model gives for a record |
//! | [`step_response`] | how fast the force follows a step of the setting |
//! | [`valve_response`] | how fast the valve does, by the numbers of its actuator |
//! | [`warm_starts`] | how warm the damper is when each record begins |
//! | [`own_setting`] | what a record says of the setting that a damper depends on |
//! | [`comparison`] | a model and its FV curve beside a campaign |
//! | [`against`] | models of the literature beside them |
//! | [`whole_records`] | how far a model is off over every sample of records |
//! | [`imposed_motion`] | motions that a user imposes on a model |
//! | [`vehicle`] | a vehicle on four dampers, and the manoeuvres it drives |
//! | [`chatter`] | whether a damper chatters in a host that holds its force over a step |
//! | [`followed`] | whether the step follows a mass that rings on its spring |
//! | [`stiffness`] | how fast a damper's states move by themselves |
//! | [`accuracy`] | error of the fixed step against a converged solution |

pub mod accuracy;
pub mod against;
pub mod chatter;
pub mod comparison;
pub mod followed;
pub mod imposed_motion;
mod limit;
pub mod own_setting;
pub mod prediction;
pub mod step_response;
pub mod stiffness;
pub mod valve_response;
pub mod vehicle;
pub mod warm_starts;
pub mod whole_records;
