//! Formatting of numbers in reports.

use dashpot_estimation::hypothesis::Free;
use dashpot_estimation::unknowns::Unknown;

/// Formats a fraction in percent.
pub fn percent(x: f64) -> String {
    format!("{:.0} %", 100.0 * x)
}

/// Converts a free parameter from its search coordinate to its physical value.
pub fn physical(free: &Free, value: f64) -> f64 {
    match free {
        Free::Model(Unknown::Log(_)) | Free::Cooling | Free::HeatCapacity => libm::exp(value),
        _ => value,
    }
}
