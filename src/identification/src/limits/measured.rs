//! Figures for limits, measured from records: force at peak velocity, gas force and friction from slow tests, hysteresis.

use super::Value;
use super::table::{Limit, Quantity};
use crate::peaks::{AtPeak, Peak};
use crate::validation::{Compared, Hysteresis};
use dashpot_estimation::first_guess::{self, SLOW};
use dashpot_estimation::samples::segments;
use dashpot_records::Record;
use serde::{Deserialize, Serialize};

/// Largest relative difference between a test's peak velocity and the requested speed at which the test counts as a test at that speed.
/// Rigs reach their commanded speed with this error. With a larger value, the force at another speed could decide about a limit on a steep
/// curve.
pub const NEAR: f64 = 0.05;
/// Largest ratio of two commanded peak velocities between which a force is interpolated. In a wider gap, the curve may have a knee that no
/// test shows. The measured ratio may exceed this limit by the fraction [`NEAR`], so that tests at successively doubled speeds leave no
/// gap.
pub const BETWEEN: f64 = 2.0;
/// Largest relative difference of two amplitudes at which they count as the same stroke.
const SAME_STROKE: f64 = 0.1;

/// Force at peak velocity of one stroke of a test.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Name of the test.
    pub test: String,
    /// Amplitude, m.
    pub amplitude: f64,
    /// Velocity and force of the peak.
    pub peak: Peak,
}

/// Mean hysteresis of one test, N, with the amplitude, m, and the peak velocity, m/s, of the test.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Gap {
    test: String,
    amplitude: f64,
    peak_velocity: f64,
    mean_gap: f64,
}

/// Figures, measured from the records of a campaign, that decide about every limit on a force. Serde can store them as text. Limits judged
/// later from stored figures have bitwise the same results as limits judged from the records.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Figures {
    points: Vec<Point>,
    gaps: Vec<Gap>,
    /// Names of the slow tests, with the friction and gas force of these tests. `None` if no slow test shows them.
    sliding: Option<(Vec<String>, first_guess::Dry)>,
    /// Part of the slow tests' friction that grows with velocity, N. `None` if no slow test shows it.
    #[serde(default)]
    damping: Option<f64>,
}

impl Figures {
    /// Measures the figures of the records. If `forces` is given, its forces at the samples of each record replace the measured forces.
    /// Records without whole cycles give no figure.
    pub fn measure(records: &[&Record], forces: Option<&[&[f64]]>) -> Self {
        let mut found = Figures { points: Vec::new(), gaps: Vec::new(), sliding: None, damping: None };
        let mut slow: Vec<Record> = Vec::new();
        for (k, record) in records.iter().enumerate() {
            let force = forces.map_or(record.force.as_slice(), |all| all[k]);
            let Some(at) = AtPeak::find(record) else { continue };
            for peak in at.pick(force) {
                found.points.push(Point { test: record.name.clone(), amplitude: record.amplitude, peak });
            }
            let alone = Compared { record, model: force.to_vec(), fv_only: force.to_vec(), used_in_fit: false };
            found.gaps.extend(Hysteresis::of_test(&alone).map(|h| Gap {
                test: record.name.clone(),
                amplitude: record.amplitude,
                peak_velocity: record.peak_velocity,
                mean_gap: h.mean_gap_n.model,
            }));
            if record.peak_velocity <= SLOW {
                slow.push(Record { force: force.to_vec(), ..(*record).clone() });
            }
        }
        if !slow.is_empty() {
            let all = segments(&slow.iter().collect::<Vec<_>>());
            let dry = first_guess::sliding(&all);
            found.damping = first_guess::sliding_damping(&all);
            found.sliding = dry.map(|dry| (slow.into_iter().map(|r| r.name).collect(), dry));
        }
        found
    }

    /// Returns all points: one in rebound and one in compression for each test with whole cycles.
    pub fn points(&self) -> impl Iterator<Item = &Point> {
        self.points.iter()
    }

    /// Returns the measured figure for a limit, or `None` if the records do not show it.
    pub fn value(&self, limit: &Limit) -> Option<Value> {
        match (limit.quantity, limit.velocity_m_s) {
            (Quantity::Force, Some(velocity)) => self.force(velocity, limit.amplitude_m),
            (Quantity::Force, None) => None,
            (Quantity::GasForce, _) => self.of_slow_tests(|dry| dry.gas),
            (Quantity::Friction, _) => {
                let value = self.of_slow_tests(|dry| dry.friction)?;
                Some(Value { damping: self.damping, ..value })
            }
            (Quantity::Hysteresis, velocity) => self.hysteresis(velocity, limit.amplitude_m),
            // `judge_over_settings` judges the response times, because they come from steps of a setting.
            (
                Quantity::ResponseTimeUp | Quantity::ResponseTimeDown | Quantity::RiseTimeUp | Quantity::RiseTimeDown,
                _,
            ) => None,
        }
    }

    fn of_slow_tests(&self, of: impl Fn(&first_guess::Dry) -> f64) -> Option<Value> {
        self.sliding.as_ref().map(|(tests, dry)| Value { value: of(dry), tests: tests.clone(), ..Value::default() })
    }

    /// Returns the force at a velocity, m/s. If `amplitude`, m, is given, tests with this amplitude give the force. Otherwise, the tests
    /// with the largest amplitude that reach the velocity give it.
    fn force(&self, velocity: f64, amplitude: Option<f64>) -> Option<Value> {
        let mut side: Vec<&Point> = self
            .points
            .iter()
            .filter(|p| p.peak.velocity_m_s * velocity > 0.0 && is_stroke(p.amplitude, amplitude))
            .collect();
        side.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
        side.chunk_by(|a, b| a.amplitude - b.amplitude <= SAME_STROKE * a.amplitude)
            .find_map(|stroke| at_speed(stroke, velocity))
    }

    /// Returns the mean hysteresis, N, of a test at the peak velocity `velocity`, m/s. If several tests have this velocity, the one with
    /// the largest amplitude counts. Without a velocity, returns the largest hysteresis of all tests. `amplitude`, m, selects the tests if
    /// it is given.
    fn hysteresis(&self, velocity: Option<f64>, amplitude: Option<f64>) -> Option<Value> {
        let value = |gap: &Gap| Value { value: gap.mean_gap, tests: vec![gap.test.clone()], ..Value::default() };
        let candidates = self.gaps.iter().filter(|g| is_stroke(g.amplitude, amplitude));
        let Some(velocity) = velocity.map(f64::abs) else {
            return candidates.max_by(|a, b| a.mean_gap.total_cmp(&b.mean_gap)).map(value);
        };
        candidates
            .filter(|g| (g.peak_velocity - velocity).abs() <= NEAR * velocity)
            .max_by(|a, b| a.amplitude.total_cmp(&b.amplitude))
            .map(value)
    }
}

fn is_stroke(amplitude: f64, wanted: Option<f64>) -> bool {
    wanted.is_none_or(|wanted| (amplitude - wanted).abs() <= SAME_STROKE * wanted)
}

/// Returns the force at a velocity, m/s, from peaks of tests with one amplitude. The force is interpolated between the neighboring peaks,
/// if the ratio of their speeds is small enough ([`BETWEEN`]). Otherwise, a peak within [`NEAR`] of the speed gives the force.
fn at_speed(stroke: &[&Point], velocity: f64) -> Option<Value> {
    let speed = |p: &Point| p.peak.velocity_m_s.abs();
    let wanted = velocity.abs();
    let below = stroke.iter().filter(|p| speed(p) <= wanted).max_by(|a, b| speed(a).total_cmp(&speed(b)));
    let above = stroke.iter().filter(|p| speed(p) > wanted).min_by(|a, b| speed(a).total_cmp(&speed(b)));
    if let (Some(below), Some(above)) = (below, above)
        && speed(above) <= BETWEEN * (1.0 + NEAR) * speed(below)
    {
        let share = (wanted - speed(below)) / (speed(above) - speed(below));
        let value = below.peak.force_n + share * (above.peak.force_n - below.peak.force_n);
        return Some(Value { value, tests: vec![below.test.clone(), above.test.clone()], ..Value::default() });
    }
    let near = |p: &&&Point| (speed(p) - wanted).abs() <= NEAR * wanted;
    let nearest = below.into_iter().chain(above).filter(near);
    nearest.min_by(|a, b| (speed(a) - wanted).abs().total_cmp(&(speed(b) - wanted).abs())).map(|p| Value {
        value: p.peak.force_n,
        tests: vec![p.test.clone()],
        ..Value::default()
    })
}
