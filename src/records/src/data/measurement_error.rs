//! What a record is off by.

/// What a record is off by.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MeasurementError {
    /// How late the force is, s.
    pub delay_s: f64,
    /// Mass between load cell and damper, kg, that the load cell has to speed up with the damper's end.
    pub mass_kg: f64,
    /// Growth of the force's gain with the campaign's clock, 1/s.
    pub gain_per_s: f64,
    /// Growth of the force's zero with the campaign's clock, N/s.
    pub zero_n_per_s: f64,
}

impl MeasurementError {
    /// Not off at all.
    pub const NONE: MeasurementError =
        MeasurementError { delay_s: 0.0, mass_kg: 0.0, gain_per_s: 0.0, zero_n_per_s: 0.0 };

    /// What is left of it where some was taken out before.
    pub fn beyond(&self, before: &MeasurementError) -> MeasurementError {
        MeasurementError {
            delay_s: self.delay_s - before.delay_s,
            mass_kg: self.mass_kg - before.mass_kg,
            gain_per_s: self.gain_per_s - before.gain_per_s,
            zero_n_per_s: self.zero_n_per_s - before.zero_n_per_s,
        }
    }
}
