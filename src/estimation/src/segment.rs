//! Part of a record over which the model is simulated.

use dashpot_core::Input;

/// Motion and measured force of one test.
#[derive(Debug, Clone)]
pub struct Segment {
    /// Name of the test.
    pub name: String,
    /// Time step that ends at each sample, s; the first is 0.
    pub dt: Vec<f64>,
    /// Motion, side force and temperature at each sample.
    pub input: Vec<Input>,
    /// Command of the setting for the step that ends at each sample, if it changes within the test.
    pub setting: Option<Vec<f64>>,
    /// Measured force, N.
    pub force: Vec<f64>,
    /// Index of the first scored sample. The forces of earlier samples, the lead-in, are not compared.
    pub from: usize,
    /// Force that corresponds to one unit of weighted residual, N.
    pub scale: f64,
    /// Largest absolute measured force, N.
    pub top: f64,
    /// Peak velocity of the test, m/s.
    pub peak_velocity: f64,
    /// Amplitude of the test, m.
    pub amplitude: f64,
    /// Middle of the segment on the campaign's clock, s.
    pub clock: f64,
}
