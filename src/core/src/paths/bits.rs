//! The elements in the way of the force as bits.

/// The series compliance.
pub const SERIES: u32 = 1;
/// Free play in it.
pub const FREE_PLAY: u32 = 1 << 1;
/// A bushing in it.
pub const BUSHING: u32 = 1 << 2;
/// The oil column.
pub const COLUMN: u32 = 1 << 3;
/// Air in the oil column.
pub const AIR: u32 = 1 << 4;
/// Cavitation.
pub const CAVITATION: u32 = 1 << 5;
/// Position-dependent damping.
pub const POSITION: u32 = 1 << 6;
/// Temperature fade.
pub const FADE: u32 = 1 << 7;
/// The damper's own heat.
pub const HEAT: u32 = 1 << 8;
/// Frequency-selective damping.
pub const SELECTIVE: u32 = 1 << 9;
/// Valve hysteresis.
pub const VALVE: u32 = 1 << 10;
/// Flow beside the valves through a groove.
pub const GROOVE: u32 = 1 << 11;
/// Flow beside the valves through the passage of frequency-selective damping.
pub const PASSAGE: u32 = 1 << 12;
/// A length of the oil column that depends on the place.
pub const LENGTH: u32 = 1 << 13;
/// A part of the bushing that gives way slowly.
pub const SLOW_BUSHING: u32 = 1 << 14;
/// A valve with mass.
pub const SPOOL: u32 = 1 << 15;
/// Friction and gas on the internal mass.
pub const WHOLE: u32 = 1 << 16;
/// Whatever the model says.
pub const ANY: u32 = u32::MAX;
