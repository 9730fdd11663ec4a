//! Bits of the elements in the force path and of their forms, from which sets of elements are made.

/// The series compliance.
pub const SERIES: u32 = 1;
/// Free play in the series compliance.
pub const FREE_PLAY: u32 = 1 << 1;
/// A bushing in the series compliance.
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
/// Self-heating of the damper.
pub const HEAT: u32 = 1 << 8;
/// Frequency-selective damping.
pub const SELECTIVE: u32 = 1 << 9;
/// Valve hysteresis.
pub const VALVE: u32 = 1 << 10;
/// Flow that bypasses the valves through a groove.
pub const GROOVE: u32 = 1 << 11;
/// Flow that bypasses the valves through the passage of frequency-selective damping.
pub const PASSAGE: u32 = 1 << 12;
/// A length of the oil column that depends on the displacement.
pub const LENGTH: u32 = 1 << 13;
/// A part of the bushing that relaxes slowly.
pub const SLOW_BUSHING: u32 = 1 << 14;
/// A valve with mass.
pub const SPOOL: u32 = 1 << 15;
/// Friction and gas on the internal mass.
pub const WHOLE: u32 = 1 << 16;
/// Set of any elements, for code that is not compiled for a certain set: the model determines its elements at run time.
pub const ANY: u32 = u32::MAX;
