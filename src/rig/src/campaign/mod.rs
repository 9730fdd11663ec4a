//! A campaign: the tests of a test matrix on one simulated damper, and the records of their virtual measurement.

mod folder;
mod run;

pub(crate) use run::check;

pub use folder::CAMPAIGN_FILE;
pub use run::{HIGHEST_DEFAULT_RATE_HZ, LOWEST_DEFAULT_RATE_HZ, SAMPLES_PER_CYCLE, default_sample_rate_hz};

use crate::TestPoint;

/// Options of a campaign.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Seed of the damper ([`crate::Damper::seeded`]; 0 is the default damper) and of the noise. Up to 2^63 - 1.
    pub seed: u64,
    /// Noise of the load cell: standard deviation in percent of the test's rms force. Amplifier noise with a standard
    /// deviation of 0.5 N is added.
    ///
    /// The noise of the other channels has these standard deviations: displacement 2 µm, velocity 0.1 % of the test's
    /// peak velocity, side force 0.5 N. If `noise_percent` is 0, all sensors are ideal.
    pub noise_percent: f64,
    /// Sample rate of every test, Hz. `None` selects the rate of each test from its frequency
    /// ([`default_sample_rate_hz`]).
    pub sample_rate_hz: Option<f64>,
    /// Correlation between successive samples of the load cell's noise (first-order autoregressive), 0 for white noise.
    /// The standard deviation of the noise does not depend on the correlation.
    pub noise_colour: f64,
    /// Amplitude of mains hum (50 Hz) on the force, N.
    pub hum_n: f64,
    /// Number of bits of the force channel's analog-to-digital converter. Its range is the smallest standard range
    /// above the campaign's largest force. `None` means no rounding.
    pub bits: Option<u32>,
    /// Whether the side force is recorded in tests with side force.
    pub side_force_channel: bool,
    /// Whether the temperature of the damper's body is recorded. Only campaigns of a case with injected effects support
    /// this channel.
    pub temperature_channel: bool,
    /// Initial temperature of the damper, °C; `None` means the laboratory temperature of 22 °C. Only campaigns of a
    /// case with injected effects use this value.
    pub start_temperature_c: Option<f64>,
    /// Seed of the sensors' noise; `None` uses `seed`. With two noise seeds, the rig measures one damper twice.
    pub noise_seed: Option<u64>,
    /// Seed that shuffles the order of a plan's tests; `None` uses `seed`.
    pub order: Option<u64>,
    /// Number of worker threads; `None` uses all processors. The result does not depend on this number.
    pub threads: Option<usize>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            seed: 0,
            noise_percent: 1.0,
            sample_rate_hz: None,
            noise_colour: 0.0,
            hum_n: 0.0,
            bits: None,
            side_force_channel: true,
            temperature_channel: true,
            start_temperature_c: None,
            noise_seed: None,
            order: None,
            threads: None,
        }
    }
}

/// A measured campaign: its options and the records of all tests.
#[derive(Debug, Clone, PartialEq)]
pub struct Campaign {
    /// Options of the run.
    pub options: Options,
    /// One record per test, in the order of the test matrix.
    pub records: Vec<Record>,
    /// Whether `campaign.toml` omits the seed, because the truth (true damper and effects) is in a sealed folder.
    pub sealed: bool,
}

/// Measured channels of one test, from standstill to standstill. All channels have the same length.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Motion and name of the test.
    pub point: TestPoint,
    /// Samples per second, Hz.
    pub sample_rate_hz: f64,
    /// Time, s: since the start of the record, or, in a case with injected effects, since the start of the campaign.
    pub time_s: Vec<f64>,
    /// Displacement from mid-stroke, m, positive in extension.
    pub displacement_m: Vec<f64>,
    /// Velocity, m/s, positive in extension (rebound).
    pub velocity_m_s: Vec<f64>,
    /// Force, tension positive, N.
    pub force_n: Vec<f64>,
    /// Side force on the rod, N; `None` if no test of the campaign has a side force, or if it is not recorded.
    pub side_force_n: Option<Vec<f64>>,
    /// Temperature of the damper's body, °C, if recorded.
    pub temperature_c: Option<Vec<f64>>,
    /// Force without noise, hum and rounding, N; not written to the record's file.
    pub clean_force_n: Vec<f64>,
}

impl Record {
    /// Makes an empty record with capacity for its samples.
    pub(crate) fn empty(point: &TestPoint, sample_rate_hz: f64, count: usize) -> Self {
        Self {
            point: point.clone(),
            sample_rate_hz,
            time_s: Vec::with_capacity(count),
            displacement_m: Vec::with_capacity(count),
            velocity_m_s: Vec::with_capacity(count),
            force_n: Vec::with_capacity(count),
            side_force_n: None,
            temperature_c: None,
            clean_force_n: Vec::new(),
        }
    }
}
