//! One test: a sine at constant amplitude and frequency, or a road-like random motion.

use std::f64::consts::TAU;

use dashpot_messages::{format_decimals, format_number};

/// Default number of whole measured cycles of a test up to 2 Hz.
pub const DEFAULT_CYCLES_SLOW: u32 = 3;
/// Default number of whole measured cycles above 2 Hz, where a cycle has fewer samples.
pub const DEFAULT_CYCLES_FAST: u32 = 5;
/// Frequency above which a test counts as fast, Hz.
const FAST_FREQUENCY_HZ: f64 = 2.0;

/// Smallest amplitude, m. Below it, sensors measure only noise.
pub(super) const SMALLEST_M: f64 = 1e-6;
/// Largest travel from mid-stroke that the rig allows, m.
const TRAVEL_LIMIT_M: f64 = 0.075;
/// Largest velocity of the rig's actuator, m/s.
const VELOCITY_LIMIT_M_S: f64 = 3.0;
/// Range of frequencies of the rig's controller, Hz.
const FREQUENCY_RANGE_HZ: (f64, f64) = (1e-3, 50.0);
/// Largest side force of the loading device, N.
const SIDE_FORCE_LIMIT_N: f64 = 3000.0;
/// Largest number of whole cycles of a test.
const CYCLES_LIMIT: u32 = 1000;
/// Largest accepted relative difference between the stated peak velocity and 2 pi A f, with amplitude A and frequency
/// f. A matrix file may contain rounded values.
const PEAK_VELOCITY_TOLERANCE: f64 = 0.02;

/// One test of a matrix: a sine, or a road-like random motion.
#[derive(Debug, Clone, PartialEq)]
pub struct TestPoint {
    /// Name, unique in the matrix. It is also the file name of the record without `.csv`.
    pub name: String,
    /// Amplitude of the sine (half the stroke), m.
    pub amplitude_m: f64,
    /// Frequency of the sine, Hz.
    pub frequency_hz: f64,
    /// Largest velocity of the sine, m/s: `2 pi A f` with amplitude A and frequency f.
    pub peak_velocity_m_s: f64,
    /// Mean position of the sine from mid-stroke, extension positive, m.
    pub mean_displacement_m: f64,
    /// Constant side force on the rod, N.
    pub side_force_n: f64,
    /// Number of whole cycles at full amplitude.
    pub cycles: u32,
    /// Seed of a road-like random motion; `None` means a sine.
    ///
    /// `amplitude_m` and `peak_velocity_m_s` are upper limits of a random motion, which reaches one of them. The
    /// duration equals that of the sine with these values.
    pub road_seed: Option<u64>,
}

/// Reason why the rig cannot run a test: the field and the problem.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Fault {
    /// The invalid field, by its column name in a matrix file.
    pub column: &'static str,
    /// The problem and a remedy.
    pub problem: String,
}

impl TestPoint {
    /// Makes a sine test about mid-stroke without side force, at an amplitude, m, and a peak velocity, m/s, with the
    /// default number of cycles.
    pub fn at_peak_velocity(name: String, amplitude_m: f64, peak_velocity_m_s: f64) -> Self {
        let frequency_hz = peak_velocity_m_s / (TAU * amplitude_m);
        Self {
            name,
            amplitude_m,
            frequency_hz,
            peak_velocity_m_s,
            mean_displacement_m: 0.0,
            side_force_n: 0.0,
            cycles: default_cycles(frequency_hz),
            road_seed: None,
        }
    }

    /// Checks that the rig can run this test. Otherwise, returns the first reason why it cannot.
    pub(crate) fn check(&self) -> Result<(), Fault> {
        let fault = |column, problem: String| Err(Fault { column, problem });
        if let Some(problem) = name_problem(&self.name) {
            return fault("name", problem);
        }
        for (column, value) in [
            ("amplitude_mm", self.amplitude_m),
            ("frequency_hz", self.frequency_hz),
            ("peak_velocity_mm_s", self.peak_velocity_m_s),
            ("mean_displacement_mm", self.mean_displacement_m),
            ("side_force_n", self.side_force_n),
        ] {
            if !value.is_finite() {
                return fault(column, format!("{} is not a number that can be used", format_number(value)));
            }
        }
        if self.amplitude_m < SMALLEST_M {
            return fault(
                "amplitude_mm",
                format!(
                    "the amplitude is {} mm; give {} to {} mm",
                    format_number(self.amplitude_m * 1e3),
                    SMALLEST_M * 1e3,
                    TRAVEL_LIMIT_M * 1e3
                ),
            );
        }
        let travel = self.amplitude_m + self.mean_displacement_m.abs();
        // The term 1e-9 allows for rounding of a value on the limit.
        if travel > TRAVEL_LIMIT_M * (1.0 + 1e-9) {
            let column = if self.amplitude_m > TRAVEL_LIMIT_M { "amplitude_mm" } else { "mean_displacement_mm" };
            return fault(
                column,
                format!(
                    "amplitude and mean displacement together reach {} mm from mid-stroke, the damper ends at {:.0} mm; \
                     reduce one of them",
                    format_decimals(travel * 1e3, 1),
                    TRAVEL_LIMIT_M * 1e3
                ),
            );
        }
        let (low, high) = FREQUENCY_RANGE_HZ;
        if !(self.frequency_hz >= low && self.frequency_hz <= high) {
            return fault(
                "frequency_hz",
                format!("{} Hz is outside what the rig can run, {low} to {high} Hz", format_number(self.frequency_hz)),
            );
        }
        let peak = TAU * self.amplitude_m * self.frequency_hz;
        if peak > VELOCITY_LIMIT_M_S {
            return fault(
                "frequency_hz",
                format!(
                    "{:.3} mm at {:.4} Hz needs {peak:.2} m/s, the actuator reaches {VELOCITY_LIMIT_M_S} m/s; \
                     reduce amplitude or frequency",
                    self.amplitude_m * 1e3,
                    self.frequency_hz
                ),
            );
        }
        if (self.peak_velocity_m_s / peak - 1.0).abs() > PEAK_VELOCITY_TOLERANCE {
            return fault(
                "peak_velocity_mm_s",
                format!(
                    "{} mm/s contradicts amplitude and frequency, 2 pi A f = {:.3} mm/s; \
                     correct one of them or leave one of the three columns empty",
                    format_decimals(self.peak_velocity_m_s * 1e3, 3),
                    peak * 1e3
                ),
            );
        }
        if self.side_force_n.abs() > SIDE_FORCE_LIMIT_N {
            return fault(
                "side_force_n",
                format!("{} N is beyond the loading device's {SIDE_FORCE_LIMIT_N} N", format_number(self.side_force_n)),
            );
        }
        if self.cycles == 0 || self.cycles > CYCLES_LIMIT {
            return fault("cycles", format!("{} cycles; give 1 to {CYCLES_LIMIT}", self.cycles));
        }
        Ok(())
    }
}

/// Returns the default number of whole measured cycles at a frequency, Hz.
pub fn default_cycles(frequency_hz: f64) -> u32 {
    if frequency_hz > FAST_FREQUENCY_HZ { DEFAULT_CYCLES_FAST } else { DEFAULT_CYCLES_SLOW }
}

/// Returns the problem of a test's name, if any. Names become file names, so they must be valid file names on all
/// operating systems.
fn name_problem(name: &str) -> Option<String> {
    if name.is_empty() || name.len() > 100 {
        return Some("the name must have 1 to 100 characters".into());
    }
    if name.starts_with(['.', '-']) || name.ends_with('.') {
        return Some("the name must not begin with '.' or '-' nor end with '.'".into());
    }
    let bad = name.chars().find(|c| !(c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.')))?;
    Some(format!(
        "the name '{name}' contains '{bad}'; use letters, digits, '_', '-' and '.' only, the name becomes a file name"
    ))
}

/// Formats a name such as `a50mm_v0524mm_s`, which sorts by amplitude and then by peak velocity. `decimals`
/// distinguishes close velocities.
pub(crate) fn sine_name(amplitude_m: f64, peak_velocity_m_s: f64, decimals: usize) -> String {
    let width = |digits: usize| {
        if decimals == 0 { digits } else { digits + 1 + decimals }
    };
    // Amplitudes such as 2.5 mm have decimals, even if the velocities have none.
    let amplitude = format!("{:.3}", amplitude_m * 1e3);
    let amplitude = amplitude.trim_end_matches('0').trim_end_matches('.');
    let whole = amplitude.split('.').next().map_or(0, str::len);
    let pad = "0".repeat(2usize.saturating_sub(whole));
    format!(
        "a{pad}{amplitude}mm_v{:0velocity_width$.decimals$}mm_s",
        peak_velocity_m_s * 1e3,
        velocity_width = width(4),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_that_are_no_numbers_are_refused() {
        let good = TestPoint::at_peak_velocity("good".into(), 0.05, 0.5);
        assert_eq!(good.check(), Ok(()));
        let refused = |change: fn(&mut TestPoint, f64)| {
            let mut point = good.clone();
            change(&mut point, f64::NAN);
            point.check().unwrap_err().column
        };
        assert_eq!(refused(|p, x| p.amplitude_m = x), "amplitude_mm");
        assert_eq!(refused(|p, x| p.frequency_hz = x), "frequency_hz");
        assert_eq!(refused(|p, x| p.peak_velocity_m_s = x), "peak_velocity_mm_s");
        assert_eq!(refused(|p, x| p.mean_displacement_m = x), "mean_displacement_mm");
        assert_eq!(refused(|p, x| p.side_force_n = x), "side_force_n");
    }

    #[test]
    fn names_are_safe_as_file_names() {
        for name in ["", ".hidden", "-option", "a/b", "a\\b", "a:b", "dot.", "gr\u{fc}n", "a b"] {
            assert!(name_problem(name).is_some(), "{name}");
        }
        assert_eq!(name_problem("a02.5mm_v0100mm_s"), None);
    }
}
