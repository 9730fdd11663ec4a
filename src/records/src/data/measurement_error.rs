//! Measurement error of a record.

/// Measurement error of a record: delay, inertia, and drift of gain and zero.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MeasurementError {
    /// Delay of the force, s.
    pub delay_s: f64,
    /// Mass between load cell and damper, kg. The load cell measures the inertia force of this mass, which moves with
    /// the damper's end.
    pub mass_kg: f64,
    /// Drift of the force gain over the campaign clock, 1/s.
    pub gain_per_s: f64,
    /// Drift of the force zero over the campaign clock, N/s.
    pub zero_n_per_s: f64,
}

impl MeasurementError {
    /// No measurement error.
    pub const NONE: MeasurementError =
        MeasurementError { delay_s: 0.0, mass_kg: 0.0, gain_per_s: 0.0, zero_n_per_s: 0.0 };

    /// Returns the error that remains after an earlier correction of the error `before`.
    pub fn beyond(&self, before: &MeasurementError) -> MeasurementError {
        MeasurementError {
            delay_s: self.delay_s - before.delay_s,
            mass_kg: self.mass_kg - before.mass_kg,
            gain_per_s: self.gain_per_s - before.gain_per_s,
            zero_n_per_s: self.zero_n_per_s - before.zero_n_per_s,
        }
    }
}
