//! A campaign: all tests of a matrix run on one damper, and the records measured.

mod folder;
mod run;

pub use folder::CAMPAIGN_FILE;
pub use run::{HIGHEST_DEFAULT_RATE_HZ, LOWEST_DEFAULT_RATE_HZ, SAMPLES_PER_CYCLE, default_sample_rate_hz};

use crate::TestPoint;

/// How a campaign is run.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Chooses the damper ([`crate::Damper::seeded`]; 0 is the default damper) and the noise. Up to 2^63 - 1.
    pub seed: u64,
    /// Noise of the load cell: standard deviation in percent of the test's rms force (0.5 N of amplifier noise come on top).
    /// The other channels have the noise of their sensors: displacement 2 µm, velocity 0.1 % of the test's peak velocity,
    /// side force 0.5 N. At 0 all sensors are ideal.
    pub noise_percent: f64,
    /// Samples per second of every test, Hz; `None` chooses by frequency ([`default_sample_rate_hz`]).
    pub sample_rate_hz: Option<f64>,
    /// Worker threads; `None` takes what the machine has. The result does not depend on it.
    pub threads: Option<usize>,
}

impl Default for Options {
    fn default() -> Self {
        Self { seed: 0, noise_percent: 1.0, sample_rate_hz: None, threads: None }
    }
}

/// What was measured in all tests.
#[derive(Debug, Clone, PartialEq)]
pub struct Campaign {
    /// How it was run.
    pub options: Options,
    /// One record per test, in the order of the matrix.
    pub records: Vec<Record>,
}

/// What was measured in one test, from rest to rest. All channels have the same length.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// The test.
    pub point: TestPoint,
    /// Samples per second, Hz.
    pub sample_rate_hz: f64,
    /// Time since the start of the record, s.
    pub time_s: Vec<f64>,
    /// Extension from mid-stroke, m.
    pub displacement_m: Vec<f64>,
    /// Rate of extension, m/s.
    pub velocity_m_s: Vec<f64>,
    /// Force, tension positive, N.
    pub force_n: Vec<f64>,
    /// Side force on the rod, N; absent when no test of the campaign has one.
    pub side_force_n: Option<Vec<f64>>,
}
