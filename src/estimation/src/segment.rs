//! A stretch of record that the model is run along.

use dashpot_core::Input;

/// Motion and measured force of one test.
#[derive(Debug, Clone)]
pub struct Segment {
    /// Name of the test.
    pub name: String,
    /// Time from one sample to the next, s; the first is 0.
    pub dt: Vec<f64>,
    /// The motion, side force and temperature at the samples.
    pub input: Vec<Input>,
    /// Command of the setting in the step that ends at each sample, where it changes within the test.
    pub setting: Option<Vec<f64>>,
    /// Measured force, N.
    pub force: Vec<f64>,
    /// First sample whose force counts.
    pub from: usize,
    /// Force that one unit of weighted residual stands for, N.
    pub scale: f64,
    /// Largest measured force, N.
    pub top: f64,
    /// Peak velocity of the test, m/s.
    pub peak_velocity: f64,
    /// Amplitude, m.
    pub amplitude: f64,
    /// Middle of it on the campaign's clock, s.
    pub clock: f64,
}
