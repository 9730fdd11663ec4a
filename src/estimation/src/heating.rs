//! Temperature of the damper in each test, from the measured power.
//!
//! Force times velocity is measured, so the heat requires no model of the damper. The heat balance is C Ṫ = F v − h (T
//! − T_a). C is the heat capacity, J/K, and h is the heat transfer, W/K. T is the temperature of the damper, and T_a
//! that of its surroundings, K. F is the force, N, and v the velocity, m/s. The balance applies over the campaign's
//! clock, from test to test, including pauses.

use super::campaign_clock::clock_runs_on;
use super::samples::Test;
use dashpot_records::Record;

/// Heat input of the damper, test by test.
#[derive(Debug, Clone)]
pub struct Heating {
    /// Beginning and end, s of the campaign's clock, and mean power, W, of every record.
    inputs: Vec<(f64, f64, f64)>,
    /// For each test, the time at which its temperature is evaluated, s of the campaign's clock, and the index of its
    /// record.
    looks: Vec<(f64, usize)>,
    /// Whether the records have one common clock, so that heat from earlier records is included.
    pub continues: bool,
}

impl Heating {
    /// Computes the heating in these records, evaluated in the middle of each test.
    pub fn new(records: &[&Record], tests: &[Test]) -> Heating {
        let inputs: Vec<(f64, f64, f64)> = records
            .iter()
            .map(|r| {
                let work: f64 = r
                    .time
                    .windows(2)
                    .zip(r.force.windows(2).zip(r.velocity.windows(2)))
                    .map(|(t, (f, v))| 0.5 * (f[0] * v[0] + f[1] * v[1]) * (t[1] - t[0]))
                    .sum();
                let (begin, end) = (r.clock_s + r.time[0], r.clock_s + r.time[r.time.len() - 1]);
                (begin, end, work / (end - begin).max(1e-9))
            })
            .collect();
        let continues = clock_runs_on(records);
        Heating { inputs, looks: tests.iter().map(|t| (t.segment.clock, t.record)).collect(), continues }
    }

    /// Returns the heating of the campaign, evaluated in the middle of other tests.
    pub fn of_tests(&self, tests: &[Test]) -> Heating {
        Heating { looks: tests.iter().map(|t| (t.segment.clock, t.record)).collect(), ..self.clone() }
    }

    /// Computes the temperature rise times heat capacity, J, at the test with the index `place`, for a cooling rate
    /// `cooling`, 1/s.
    pub fn rise(&self, place: usize, cooling: f64) -> f64 {
        let (t, record) = self.looks[place];
        self.at(t, record, cooling)
    }

    /// Computes the temperature rise times heat capacity, J, at the beginning of record `record`, for a cooling rate
    /// `cooling`, 1/s.
    pub fn at_the_begin(&self, record: usize, cooling: f64) -> f64 {
        self.at(self.inputs[record].0, record, cooling)
    }

    /// Computes the temperature rise times heat capacity, J, at time `t` of the campaign's clock, s, within record
    /// `record`, for a cooling rate `cooling`, 1/s.
    fn at(&self, t: f64, record: usize, cooling: f64) -> f64 {
        let of = |(begin, end, power): &(f64, f64, f64)| {
            let end = end.min(t);
            if end <= *begin {
                return 0.0;
            }
            power / cooling * (libm::exp(-cooling * (t - end)) - libm::exp(-cooling * (t - begin)))
        };
        if self.continues {
            self.inputs.iter().map(of).sum()
        } else {
            // If each record has its own clock, the heat from earlier tests is unknown, so each test starts cold.
            of(&self.inputs[record])
        }
    }

    /// Computes the range over all tests of temperature rise times heat capacity, J, with cooling neglected. If the
    /// range is small, heating cannot be identified.
    pub fn span(&self) -> f64 {
        let rises: Vec<f64> = (0..self.looks.len()).map(|k| self.rise(k, 1e-6)).collect();
        let (low, high) = rises.iter().fold((f64::INFINITY, 0.0f64), |(l, h), r| (l.min(*r), h.max(*r)));
        (high - low).max(0.0)
    }
}
