//! Error matrix: the campaign's errors for tests of equal amplitude, for tests of equal peak velocity, and for the slow tests.
//!
//! Rows correspond to the stitched records of Jonnalagadda & Vyas, which join all tests of one amplitude. Each test has equal weight in its
//! row, so frequencies with many tests do not dominate. Errors in percent are relative to the largest measured force of the whole row.

use super::deviation::Errors;
use super::of_test::TestValidation;
use serde::Serialize;

/// Peak velocity below which tests are friction tests and form a separate row, m/s.
///
/// In the test schedule of Jonnalagadda & Vyas, the slow test reaches 2.6 mm/s, and the slowest damping test reaches 52 mm/s.
pub const SLOW_PEAK_VELOCITY: f64 = 0.005;

/// Largest relative difference from the mean of a group at which an amplitude or a peak velocity belongs to the group.
const SAME: f64 = 0.05;

/// Difference, m, within which amplitudes always belong to one group: the scatter of a rig at the smallest strokes.
const SAME_AMPLITUDE: f64 = 0.0001;

/// Difference, m/s, within which peak velocities always belong to one group: the scatter of a rig in the slowest tests.
const SAME_VELOCITY: f64 = 0.002;

/// Errors of one group of tests, such as the tests of one amplitude.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MatrixRow {
    /// Description of the property that the tests share.
    pub label: String,
    /// Mean amplitude, m, of a row of `by_amplitude`. For all other rows, mean peak velocity, m/s.
    pub value: f64,
    /// Number of tests.
    pub tests: usize,
    /// Names of the tests.
    pub test_names: Vec<String>,
    /// Largest |measured force| of the row, N.
    pub max_force_n: f64,
    /// Mean errors with equal weight of each test. Errors in percent are relative to `max_force_n`.
    #[serde(flatten)]
    pub errors: Errors,
}

/// Errors of the tests of one amplitude and one peak velocity.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MatrixCell {
    /// Index of the row in [`ErrorMatrix::by_amplitude`].
    pub amplitude_row: usize,
    /// Index of the row in [`ErrorMatrix::by_peak_velocity`].
    pub peak_velocity_row: usize,
    /// Number of tests.
    pub tests: usize,
    /// Mean errors. The error in percent is the mean of the tests' errors in percent.
    #[serde(flatten)]
    pub errors: Errors,
}

/// Errors of a campaign by groups of tests, which follow the test schedule.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ErrorMatrix {
    /// One row for each amplitude. The largest amplitude comes first, as in the test schedule.
    pub by_amplitude: Vec<MatrixRow>,
    /// One row for each peak velocity. The slowest comes first.
    pub by_peak_velocity: Vec<MatrixRow>,
    /// Errors of each tested combination of amplitude and peak velocity.
    pub cells: Vec<MatrixCell>,
    /// Slow friction tests, or `None` without them. They appear in no other row.
    pub slow: Option<MatrixRow>,
    /// Tests without whole cycles (random, road), or `None` without them. Such tests have neither amplitude nor frequency.
    pub not_periodic: Option<MatrixRow>,
}

impl ErrorMatrix {
    /// Groups the validated tests.
    pub(super) fn from_tests(tests: &[TestValidation]) -> Self {
        let (slow, rest): (Vec<_>, Vec<_>) =
            tests.iter().partition(|test| test.cycles > 0 && test.peak_velocity_m_s < SLOW_PEAK_VELOCITY);
        let (periodic, not_periodic): (Vec<_>, Vec<_>) = rest.into_iter().partition(|test| test.cycles > 0);

        let amplitudes: Vec<f64> = periodic.iter().map(|test| test.amplitude_m).collect();
        let velocities: Vec<f64> = periodic.iter().map(|test| test.peak_velocity_m_s).collect();
        let mut amplitude_groups = groups(&amplitudes, SAME_AMPLITUDE);
        amplitude_groups.reverse();
        let velocity_groups = groups(&velocities, SAME_VELOCITY);

        let pick = |group: &[usize]| group.iter().map(|i| periodic[*i]).collect::<Vec<_>>();
        let mut cells = Vec::new();
        for (amplitude_row, amplitude) in amplitude_groups.iter().enumerate() {
            for (peak_velocity_row, velocity) in velocity_groups.iter().enumerate() {
                let both: Vec<usize> = amplitude.iter().filter(|i| velocity.contains(i)).copied().collect();
                let errors: Vec<Errors> = pick(&both).iter().map(|test| test.errors).collect();
                if let Some(errors) = Errors::mean(&errors) {
                    cells.push(MatrixCell { amplitude_row, peak_velocity_row, tests: both.len(), errors });
                }
            }
        }
        Self {
            by_amplitude: amplitude_groups
                .iter()
                .filter_map(|group| {
                    let value = mean(group, &amplitudes);
                    row(format!("{} mm amplitude", three_digits(1e3 * value)), value, &pick(group))
                })
                .collect(),
            by_peak_velocity: velocity_groups
                .iter()
                .filter_map(|group| {
                    let value = mean(group, &velocities);
                    row(format!("{} mm/s peak velocity", three_digits(1e3 * value)), value, &pick(group))
                })
                .collect(),
            cells,
            slow: row(
                format!("slow friction tests, below {} mm/s", 1e3 * SLOW_PEAK_VELOCITY),
                mean_peak_velocity(&slow),
                &slow,
            ),
            not_periodic: row("tests without whole cycles".into(), mean_peak_velocity(&not_periodic), &not_periodic),
        }
    }
}

/// Makes a row of tests. Returns `None` without tests.
fn row(label: String, value: f64, tests: &[&TestValidation]) -> Option<MatrixRow> {
    let errors: Vec<Errors> = tests.iter().map(|test| test.errors).collect();
    let max_force_n = tests.iter().map(|test| test.max_force_n).fold(0.0, f64::max);
    Some(MatrixRow {
        label,
        value,
        tests: tests.len(),
        test_names: tests.iter().map(|test| test.name.clone()).collect(),
        max_force_n,
        errors: Errors::mean(&errors)?.in_percent_of(max_force_n),
    })
}

/// Groups the indices of nearly equal values. The group with the smallest values comes first. Within a group, the indices increase.
///
/// A value joins the preceding group if its distance from the mean of the group is at most `floor` or [`SAME`] of the value.
fn groups(values: &[f64], floor: f64) -> Vec<Vec<usize>> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for i in order {
        match groups.last_mut() {
            Some(group) if values[i] - mean(group, values) <= (SAME * values[i]).max(floor) => group.push(i),
            _ => groups.push(vec![i]),
        }
    }
    groups.iter_mut().for_each(|group| group.sort_unstable());
    groups
}

/// Averages the chosen values.
fn mean(group: &[usize], values: &[f64]) -> f64 {
    group.iter().map(|i| values[*i]).sum::<f64>() / group.len() as f64
}

/// Averages the peak velocities of tests, m/s. Returns zero without tests.
fn mean_peak_velocity(tests: &[&TestValidation]) -> f64 {
    tests.iter().map(|test| test.peak_velocity_m_s).sum::<f64>() / tests.len().max(1) as f64
}

/// Formats a positive value to three significant digits, without trailing zeros after the decimal point.
fn three_digits(value: f64) -> String {
    let decimals = (2.0 - libm::log10(value.abs().max(1e-9)).floor()).clamp(0.0, 6.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::super::Deviation;
    use super::*;

    fn test(amplitude_mm: f64, peak_mm_s: f64, mean_error_n: f64, max_force_n: f64) -> TestValidation {
        let deviation = Deviation {
            mean_error_n,
            error_percent: 100.0 * mean_error_n / max_force_n,
            region1_n: mean_error_n,
            ..Deviation::default()
        };
        TestValidation {
            name: format!("{amplitude_mm}/{peak_mm_s}"),
            amplitude_m: 1e-3 * amplitude_mm,
            frequency_hz: peak_mm_s / amplitude_mm / std::f64::consts::TAU,
            peak_velocity_m_s: 1e-3 * peak_mm_s,
            max_force_n,
            errors: Errors { model: deviation, fv_only: deviation },
            used_in_fit: false,
            samples: 100,
            cycles: 3,
            noise_rms_n: 0.0,
            hysteresis: None,
            peaks: Vec::new(),
        }
    }

    #[test]
    fn measured_scatter_does_not_split_rows() {
        let tests = [
            test(50.2, 1571.0, 60.0, 3466.0),
            test(49.1, 524.0, 20.0, 1500.0),
            test(1.03, 52.0, 5.0, 175.0),
            test(0.97, 135.0, 7.0, 300.0),
            test(30.0, 131.0, 9.0, 400.0),
            test(25.0, 530.0, 11.0, 1500.0),
        ];
        let matrix = ErrorMatrix::from_tests(&tests);
        let amplitudes: Vec<_> = matrix.by_amplitude.iter().map(|row| (row.label.as_str(), row.tests)).collect();
        let expected =
            [("49.6 mm amplitude", 2), ("30 mm amplitude", 1), ("25 mm amplitude", 1), ("1 mm amplitude", 2)];
        assert_eq!(amplitudes, expected);
        let velocities: Vec<_> = matrix.by_peak_velocity.iter().map(|row| row.tests).collect();
        assert_eq!(velocities, [1, 2, 2, 1]);
        assert_eq!(matrix.cells.iter().map(|cell| cell.tests).sum::<usize>(), tests.len());
        assert!(matrix.slow.is_none() && matrix.not_periodic.is_none());
    }

    #[test]
    fn a_row_is_in_percent_of_its_own_largest_force() {
        let matrix = ErrorMatrix::from_tests(&[test(50.0, 1571.0, 200.0, 3466.0), test(50.0, 524.0, 96.2082, 1500.0)]);
        let row = &matrix.by_amplitude[0];
        assert!((row.errors.model.mean_error_n - 148.1041).abs() < 1e-9);
        assert!((row.errors.model.error_percent - 4.2731).abs() < 1e-4);
        assert_eq!(row.max_force_n, 3466.0);
    }

    #[test]
    fn slow_and_aperiodic_tests_stand_apart() {
        let mut road = test(20.0, 800.0, 50.0, 2000.0);
        road.cycles = 0;
        let matrix = ErrorMatrix::from_tests(&[test(10.0, 2.58, 10.0, 140.0), test(10.0, 52.0, 20.0, 300.0), road]);
        assert_eq!(matrix.slow.unwrap().test_names, ["10/2.58"]);
        assert_eq!(matrix.not_periodic.unwrap().tests, 1);
        assert_eq!(matrix.by_amplitude.len(), 1);
        assert_eq!(matrix.by_amplitude[0].tests, 1);
    }

    #[test]
    fn labels_keep_three_digits() {
        let cases = [(1571.2, "1571"), (52.36, "52.4"), (50.0, "50"), (0.4004, "0.4"), (12.5, "12.5")];
        for (value, label) in cases {
            assert_eq!(three_digits(value), label);
        }
    }
}
