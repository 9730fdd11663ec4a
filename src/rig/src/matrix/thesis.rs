//! The test matrix of the thesis (Jonnalagadda & Vyas 2020, chapter 4).
//!
//! The matrix contains sines at eight amplitudes with equal peak velocities at each amplitude, and slow cycles for
//! friction and gas force.

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use dashpot_messages::format_number;

use super::point::{SMALLEST_M, sine_name};
use super::{Matrix, TestPoint};
use crate::RigError;

/// Highest frequency of the thesis's rig, Hz. The matrix omits tests above it.
pub const RIG_FREQUENCY_LIMIT_HZ: f64 = 25.03;

/// Amplitudes of tests 1 to 8, m.
const AMPLITUDES_M: [f64; 8] = [0.050, 0.040, 0.030, 0.025, 0.015, 0.005, 0.002, 0.001];

/// Frequencies of the standard test, Hz. At its amplitude of 50 mm, they define the peak velocities of the tests at all
/// amplitudes.
const STANDARD_FREQUENCIES_HZ: [f64; 7] = [1.0 / 6.0, 5.0 / 12.0, 5.0 / 6.0, 1.25, 5.0 / 3.0, 10.0 / 3.0, 5.0];
const STANDARD_AMPLITUDE_M: f64 = 0.050;

/// Amplitude of test 9 of the thesis, m. The frequencies of this test are a geometric sequence between
/// [`SLOW_FREQUENCIES_HZ`].
const SLOW_AMPLITUDE_M: f64 = 0.010;
const SLOW_FREQUENCIES_HZ: (f64, f64) = (0.041, 0.006369);
const SLOW_POINTS: usize = 10;

/// Parameters of the matrix. The default gives the matrix of the thesis (Jonnalagadda & Vyas 2020).
#[derive(Debug, Clone, PartialEq)]
pub struct MatrixOptions {
    /// Amplitudes, m; one for each row of the matrix.
    pub amplitudes_m: Vec<f64>,
    /// Peak velocities, m/s; one for each column of the matrix.
    pub peak_velocities_m_s: Vec<f64>,
    /// Highest frequency, Hz; tests above it are omitted.
    pub frequency_limit_hz: f64,
    /// Whether to add the slow cycles of test 9 of the thesis, which show friction.
    pub slow_tests: bool,
}

impl Default for MatrixOptions {
    fn default() -> Self {
        Self {
            amplitudes_m: AMPLITUDES_M.to_vec(),
            peak_velocities_m_s: STANDARD_FREQUENCIES_HZ
                .iter()
                .map(|frequency| TAU * STANDARD_AMPLITUDE_M * frequency)
                .collect(),
            frequency_limit_hz: RIG_FREQUENCY_LIMIT_HZ,
            slow_tests: true,
        }
    }
}

impl Matrix {
    /// Makes the thesis's test matrix with `options`: every amplitude A at every peak velocity Vp, then the slow
    /// cycles. The frequency is `f = Vp / (2 pi A)`.
    ///
    /// # Errors
    /// [`RigError::Option`] if a value is not a positive number or is listed twice, or no point remains below the
    /// frequency limit. [`RigError::TestPoint`] if a point is outside the rig's limits.
    pub fn thesis(options: &MatrixOptions) -> Result<Self, RigError> {
        check_values("amplitudes", "mm", &options.amplitudes_m)?;
        check_values("peak velocities", "mm/s", &options.peak_velocities_m_s)?;
        let limit = options.frequency_limit_hz;
        let (low, high) = FREQUENCY_LIMITS_HZ;
        if !(low..=high).contains(&limit) {
            return Err(RigError::Option {
                option: "frequency limit",
                problem: format!("{} Hz; give {low} to {high} Hz", format_number(limit)),
            });
        }
        let decimals = decimals_needed(&options.peak_velocities_m_s);
        let mut points = Vec::new();
        for &amplitude in &options.amplitudes_m {
            for &velocity in &options.peak_velocities_m_s {
                let name = sine_name(amplitude, velocity, decimals);
                let point = TestPoint::at_peak_velocity(name, amplitude, velocity);
                if point.frequency_hz <= limit {
                    points.push(point);
                }
            }
        }
        if options.slow_tests {
            points.extend(slow_points().filter(|point| point.frequency_hz <= limit));
        }
        if points.is_empty() {
            return Err(RigError::Option {
                option: "frequency limit",
                problem: format!(
                    "no point of the matrix lies at or below {} Hz; raise the limit, use larger amplitudes or lower velocities",
                    format_number(limit)
                ),
            });
        }
        Self::new(points)
    }
}

impl Default for Matrix {
    /// Makes the matrix of the thesis (Jonnalagadda & Vyas 2020): 45 sines and 10 slow cycles.
    fn default() -> Self {
        Self::thesis(&MatrixOptions::default()).expect("the thesis's matrix is within the rig's limits")
    }
}

fn slow_points() -> impl Iterator<Item = TestPoint> {
    let (first, last) = SLOW_FREQUENCIES_HZ;
    let ratio = last / first;
    (0..SLOW_POINTS).map(move |index| {
        // The first and the last frequency are values of the thesis. Only the frequencies between them are computed.
        let frequency = match index {
            0 => first,
            i if i == SLOW_POINTS - 1 => last,
            i => first * libm::pow(ratio, i as f64 / (SLOW_POINTS - 1) as f64),
        };
        let velocity = TAU * SLOW_AMPLITUDE_M * frequency;
        TestPoint {
            frequency_hz: frequency,
            ..TestPoint::at_peak_velocity(format!("slow_{frequency:.4}hz"), SLOW_AMPLITUDE_M, velocity)
        }
    })
}

/// Range of accepted frequency limits, Hz. The lowest is that of the rig's controller, and no hydraulic rig reaches the highest.
const FREQUENCY_LIMITS_HZ: (f64, f64) = (1e-3, 1000.0);

/// Range of accepted amplitudes, m, and peak velocities, m/s.
///
/// Below an amplitude of a micrometer, sensors measure only noise. No rig operates above 20 m/s.
const VALUES: (f64, f64) = (SMALLEST_M, 20.0);

fn check_values(option: &'static str, unit: &str, values: &[f64]) -> Result<(), RigError> {
    let fail = |problem| Err(RigError::Option { option, problem });
    if values.is_empty() {
        return fail("the list is empty; give at least one value".into());
    }
    for (index, value) in values.iter().enumerate() {
        if !(value.is_finite() && *value > 0.0) {
            return fail(format!("{} {unit}; give positive numbers", format_number(value * 1e3)));
        }
        if !(VALUES.0..=VALUES.1).contains(value) {
            let (low, high) = (1e3 * VALUES.0, 1e3 * VALUES.1);
            return fail(format!("{} {unit}; a rig drives {low} to {high} {unit}", format_number(value * 1e3)));
        }
        if values[..index].contains(value) {
            return fail(format!("{} {unit} is listed twice", value * 1e3));
        }
    }
    Ok(())
}

/// Returns the smallest number of decimals of velocities in mm/s that gives distinct names. Six decimals distinguish
/// all values that differ on a rig.
fn decimals_needed(velocities: &[f64]) -> usize {
    (0..6)
        .find(|&decimals| {
            let names: BTreeSet<String> =
                velocities.iter().map(|velocity| format!("{:.decimals$}", velocity * 1e3)).collect();
            names.len() == velocities.len()
        })
        .unwrap_or(6)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn standard_row_has_the_thesis_frequencies() {
        let matrix = Matrix::default();
        let row: Vec<(f64, f64)> =
            matrix.points()[..7].iter().map(|p| (p.frequency_hz, p.peak_velocity_m_s * 1e3)).collect();
        // The thesis prints frequencies with two decimals and velocities in whole mm/s.
        let printed =
            [(0.17, 52.0), (0.42, 131.0), (0.83, 262.0), (1.25, 393.0), (1.67, 524.0), (3.33, 1047.0), (5.00, 1571.0)];
        for ((f, v), (f_printed, v_printed)) in row.iter().zip(printed) {
            assert!((f - f_printed).abs() <= 0.005, "{f} against {f_printed}");
            assert!((v - v_printed).abs() <= 0.5, "{v} against {v_printed}");
        }
    }

    #[test]
    fn every_row_has_the_same_peak_velocities_below_the_rig_limit() {
        let matrix = Matrix::default();
        let in_row = |mm: f64| {
            matrix
                .points()
                .iter()
                .filter(|p| !p.name.starts_with("slow") && (p.amplitude_m * 1e3 - mm).abs() < 1e-9)
                .count()
        };
        let counts: Vec<usize> = [50.0, 40.0, 30.0, 25.0, 15.0, 5.0, 2.0, 1.0].map(in_row).to_vec();
        assert_eq!(counts, [7, 7, 7, 7, 7, 5, 3, 2]);
        assert_eq!(matrix.points().len(), 55);
        for point in matrix.points() {
            assert!(point.frequency_hz <= RIG_FREQUENCY_LIMIT_HZ);
            let peak = TAU * point.amplitude_m * point.frequency_hz;
            assert!((peak / point.peak_velocity_m_s - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn slow_cycles_run_from_2_58_to_0_4_mm_s() {
        let matrix = Matrix::default();
        let slow: Vec<&TestPoint> = matrix.points().iter().filter(|p| p.name.starts_with("slow")).collect();
        assert_eq!(slow.len(), 10);
        assert_eq!(slow[0].frequency_hz, 0.041);
        assert_eq!(slow[9].frequency_hz, 0.006369);
        assert_eq!(slow[9].name, "slow_0.0064hz");
        assert!((slow[0].peak_velocity_m_s - 2.58e-3).abs() < 5e-6);
        assert!((slow[9].peak_velocity_m_s - 0.40e-3).abs() < 5e-6);
        assert!(slow.windows(2).all(|pair| pair[0].frequency_hz > pair[1].frequency_hz));
    }

    #[test]
    fn names_sort_by_amplitude_and_velocity_and_stay_distinct() {
        let matrix = Matrix::thesis(&MatrixOptions {
            amplitudes_m: vec![0.0025, 0.01],
            peak_velocities_m_s: vec![0.1, 0.1002, 0.02],
            slow_tests: false,
            ..MatrixOptions::default()
        })
        .unwrap();
        let mut names: Vec<&str> = matrix.points().iter().map(|p| p.name.as_str()).collect();
        names.sort_unstable();
        assert_eq!(
            names,
            [
                "a02.5mm_v0020.0mm_s",
                "a02.5mm_v0100.0mm_s",
                "a02.5mm_v0100.2mm_s",
                "a10mm_v0020.0mm_s",
                "a10mm_v0100.0mm_s",
                "a10mm_v0100.2mm_s"
            ]
        );
    }

    #[test]
    fn options_out_of_range_are_named() {
        let with = |change: fn(&mut MatrixOptions)| {
            let mut options = MatrixOptions::default();
            change(&mut options);
            Matrix::thesis(&options).unwrap_err().to_string()
        };
        assert!(with(|o| o.amplitudes_m = vec![]).contains("amplitudes"));
        assert!(with(|o| o.amplitudes_m = vec![0.05, 0.05]).contains("50 mm is listed twice"));
        assert!(with(|o| o.peak_velocities_m_s = vec![-0.1]).contains("peak velocities"));
        assert!(with(|o| o.peak_velocities_m_s = vec![1e305]).contains("0.001 to 20000 mm/s"));
        assert!(with(|o| o.amplitudes_m = vec![1e-308]).contains("0.001 to 20000 mm"));
        assert!(with(|o| o.frequency_limit_hz = f64::NAN).contains("frequency limit"));
        assert!(with(|o| o.frequency_limit_hz = 1e-3).contains("raise the limit"));
        assert!(with(|o| o.amplitudes_m = vec![0.2]).contains("mid-stroke"));
        for value in [1e308, -1e308, 1e-308, 0.0, f64::NAN, f64::INFINITY] {
            for (options, name) in [
                (MatrixOptions { amplitudes_m: vec![value], ..MatrixOptions::default() }, "amplitudes"),
                (MatrixOptions { peak_velocities_m_s: vec![value], ..MatrixOptions::default() }, "peak velocities"),
                (MatrixOptions { frequency_limit_hz: value, ..MatrixOptions::default() }, "frequency limit"),
            ] {
                let message = Matrix::thesis(&options).unwrap_err().to_string();
                assert!(message.starts_with(&format!("option {name}: ")) && message.len() < 300, "{message}");
            }
        }
    }
}
