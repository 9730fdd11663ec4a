//! Checks of cleaned records: signs, energy, units, magnitudes, and agreement of the tests of a campaign.

pub(crate) mod deviating_tests;
pub(crate) mod force_levels;
pub(crate) mod force_offset;
pub(crate) mod plausibility;
pub(crate) mod sign;
pub(crate) mod truncated_test;
pub(crate) mod unit_magnitude;
