//! Largest magnitude of a channel in a motion or a record.

use super::channel::Channel;
use crate::tuning::options::LARGEST_SETTING;

/// Returns the largest allowed magnitude of a channel, in SI units or in the unit of the setting. A larger value in a
/// motion is an error. In a record, single larger values count as missing.
///
/// The C interface of the kernel has the same limits for the side force, the temperature, and the sum of displacement
/// and velocity. The limit of time allows a clock in seconds since 1970. Only a record has a force.
pub fn motion_limit(channel: Channel) -> f64 {
    match channel {
        Channel::Time => 1e10,
        Channel::Displacement | Channel::Velocity => 1e3,
        Channel::Force | Channel::SideForce => 1e9,
        Channel::Temperature => 1e5,
        Channel::Current | Channel::Setting => LARGEST_SETTING,
    }
}
