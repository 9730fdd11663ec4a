//! Proposed tests of a diagnosis as a test matrix for a rig.

use super::outcome::{Diagnosis, NextTest};

/// Columns of a test matrix, as in `dashpot matrix` and `dashpot rig --matrix`.
const HEADING: &str = "name,amplitude_mm,frequency_hz,mean_displacement_mm,side_force_n";

impl NextTest {
    /// Formats the test as a row of a matrix.
    ///
    /// Returns `None` unless the test is a sine of known amplitude and frequency. A soak or a road signal has no row.
    fn row(&self, number: usize) -> Option<String> {
        let (amplitude, frequency) = (self.amplitude_m?, self.frequency_hz?);
        let short = |v: f64| {
            let text = format!("{v:.6}");
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        };
        Some(format!(
            "next_{number},{},{},{},{}",
            short(1e3 * amplitude),
            short(frequency),
            short(1e3 * self.mean_displacement_m.unwrap_or(0.0)),
            short(self.side_force_n.unwrap_or(0.0))
        ))
    }
}

impl Diagnosis {
    /// Returns the proposed tests as a matrix (CSV), the most informative first, and the number of tests without a row.
    ///
    /// Only a sine has a row. Returns `None` if no test has a row.
    pub fn next_matrix(&self) -> Option<(String, usize)> {
        let rows: Vec<String> = self.next_tests.iter().enumerate().filter_map(|(k, test)| test.row(k + 1)).collect();
        let without = self.next_tests.len() - rows.len();
        (!rows.is_empty()).then(|| (format!("{HEADING}\n{}\n", rows.join("\n")), without))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_messages::Sentence;

    #[test]
    fn a_sine_is_a_row_and_a_soak_is_none() {
        let sine = NextTest {
            text: Sentence::default(),
            amplitude_m: Some(0.0125),
            frequency_hz: Some(2.5),
            mean_displacement_m: Some(-0.01),
            side_force_n: None,
            difference_n: None,
            separates: Vec::new(),
        };
        assert_eq!(sine.row(1).unwrap(), "next_1,12.5,2.5,-10,0");
        assert_eq!(NextTest { amplitude_m: None, ..sine }.row(2), None);
    }
}
