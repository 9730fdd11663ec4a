//! Plans: the tests of a campaign.

use super::waveform::Waveform;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// One test of a campaign.
#[derive(Debug, Clone)]
pub struct Test {
    /// Name of the test and of its file.
    pub name: String,
    /// Motion of the moving end.
    pub motion: Waveform,
    /// Mean displacement from mid-stroke, m.
    pub mean: f64,
    /// Side force on the rod, N.
    pub side: f64,
    /// Whether the test is excluded from identification.
    pub left_out: bool,
    /// Whether the test is a repeat that shows drift. Repeats stay at start, middle and end of a shuffled plan.
    pub is_reference: bool,
}

/// Plans of tests.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Plan {
    /// 34 tests for identification (sines, three mean positions, side force, three repeats of one test), and 10
    /// left-out tests.
    Sines,
    /// The matrix of the thesis (Jonnalagadda & Vyas 2020): eight amplitudes at common peak velocities, and slow tests.
    /// The mean displacement of all tests is 0, and there is no side force.
    Thesis,
    /// Twelve sines with three amplitudes, and three left-out sines.
    Reduced,
    /// Triangles and sweeps with some sines.
    Ramps,
    /// Road-like random motions with few sines.
    Roads,
}

/// Prefix of the names of left-out tests.
pub const LEFT_OUT_PREFIX: &str = "check_";

/// Row of a plan: amplitude (mm), frequency (Hz), mean displacement (mm), side force (N).
type Row = (f64, f64, f64, f64);

const fn row(amplitude: f64, frequency: f64) -> Row {
    (amplitude, frequency, 0.0, 0.0)
}

const SINES: [Row; 31] = [
    row(45.0, 0.04),
    row(20.0, 0.08),
    row(8.0, 0.06),
    row(8.0, 0.25),
    row(0.4, 0.12),
    row(0.4, 1.2),
    row(1.2, 0.1),
    row(1.2, 1.0),
    row(1.2, 8.0),
    row(1.2, 22.0),
    row(2.5, 4.0),
    row(2.5, 20.0),
    row(5.0, 1.2),
    row(5.0, 6.0),
    row(5.0, 20.0),
    row(10.0, 1.6),
    row(10.0, 6.5),
    row(10.0, 18.0),
    row(20.0, 0.6),
    row(20.0, 2.5),
    row(20.0, 5.0),
    row(20.0, 10.0),
    row(45.0, 0.4),
    row(45.0, 1.4),
    row(45.0, 4.2),
    (9.0, 2.2, 24.0, 0.0),
    (9.0, 2.2, -24.0, 0.0),
    (22.0, 1.8, 22.0, 0.0),
    (22.0, 1.8, -22.0, 0.0),
    (20.0, 0.5, 0.0, 400.0),
    (20.0, 0.5, 0.0, 900.0),
];

const SINES_LEFT_OUT: [Row; 7] = [
    row(0.7, 2.0),
    row(3.5, 11.0),
    row(14.0, 3.2),
    row(36.0, 2.4),
    row(7.0, 17.0),
    (14.0, 2.6, -16.0, 0.0),
    (16.0, 0.8, 0.0, 650.0),
];

/// Peak velocities, m/s, of the matrix of the thesis ([`Plan::Thesis`]). [`THESIS_STROKES`] contains the amplitudes,
/// mm.
const THESIS_SPEEDS: [f64; 7] = [0.052, 0.131, 0.262, 0.393, 0.524, 1.047, 1.571];
const THESIS_STROKES: [f64; 8] = [50.0, 40.0, 30.0, 25.0, 15.0, 5.0, 2.0, 1.0];
/// Highest frequency of the thesis's rig, Hz. Tests of higher frequency are omitted.
const THESIS_FASTEST: f64 = 25.03;

fn sine(prefix: &str, (amplitude, frequency, mean, side): Row) -> Test {
    let place = if mean == 0.0 { String::new() } else { format!("_at{mean}mm") };
    let loaded = if side == 0.0 { String::new() } else { format!("_side{side}N") };
    Test {
        name: format!("{prefix}sine_{amplitude}mm_{frequency}Hz{place}{loaded}"),
        motion: Waveform::Sine { amplitude: amplitude * 1e-3, frequency },
        mean: mean * 1e-3,
        side,
        left_out: prefix == LEFT_OUT_PREFIX,
        is_reference: false,
    }
}

fn road(prefix: &str, number: u64, displacement: f64, velocity: f64, mean: f64, side: f64, seconds: f64) -> Test {
    Test {
        name: format!("{prefix}road_{number}"),
        motion: Waveform::Road { displacement, velocity, seconds, seed: number },
        mean,
        side,
        left_out: prefix == LEFT_OUT_PREFIX,
        is_reference: false,
    }
}

fn references(amplitude: f64, frequency: f64) -> impl Iterator<Item = Test> {
    (1..=3).map(move |i| Test {
        name: format!("repeat_{i}"),
        is_reference: true,
        ..sine("", row(amplitude, frequency))
    })
}

impl Plan {
    /// Returns the tests in the order of the plan. `roads` is the duration of a road-like random motion, s.
    pub fn tests(self, roads: f64) -> Vec<Test> {
        match self {
            Plan::Sines => references(20.0, 1.3)
                .chain(SINES.map(|r| sine("", r)))
                .chain(SINES_LEFT_OUT.map(|r| sine(LEFT_OUT_PREFIX, r)))
                .chain([
                    road(LEFT_OUT_PREFIX, 1, 0.02, 0.5, 0.0, 0.0, roads),
                    road(LEFT_OUT_PREFIX, 2, 0.03, 1.1, 0.006, 0.0, roads),
                    road(LEFT_OUT_PREFIX, 3, 0.015, 0.8, -0.01, 300.0, roads),
                ])
                .collect(),
            Plan::Thesis => THESIS_STROKES
                .into_iter()
                .flat_map(|stroke| THESIS_SPEEDS.map(|speed| (stroke, speed / (TAU * stroke * 1e-3))))
                .filter(|(_, f)| *f <= THESIS_FASTEST)
                .map(|(stroke, f)| {
                    // The frequency is rounded to three significant digits, as in a test plan.
                    let digits = libm::pow(10f64, 3.0 - libm::log10(f).ceil());
                    let prefix = if stroke == 30.0 || stroke == 2.0 { LEFT_OUT_PREFIX } else { "" };
                    sine(prefix, row(stroke, (f * digits).round() / digits))
                })
                .chain([0.04, 0.02, 0.01].map(|f| sine("", row(10.0, f))))
                .collect(),
            Plan::Reduced => [
                row(25.0, 0.05),
                row(25.0, 0.5),
                row(25.0, 1.5),
                row(25.0, 4.0),
                row(25.0, 8.0),
                row(10.0, 1.0),
                row(10.0, 4.0),
                row(10.0, 12.0),
                row(2.0, 0.5),
                row(2.0, 5.0),
                row(2.0, 15.0),
                row(25.0, 2.5),
            ]
            .map(|r| sine("", r))
            .into_iter()
            .chain([row(25.0, 6.0), row(15.0, 2.0), row(4.0, 9.0)].map(|r| sine(LEFT_OUT_PREFIX, r)))
            .collect(),
            Plan::Ramps => {
                let triangle = |amplitude: f64, frequency: f64| Test {
                    name: format!("triangle_{amplitude}mm_{frequency}Hz"),
                    motion: Waveform::Triangle { amplitude: amplitude * 1e-3, frequency },
                    ..sine("", row(amplitude, frequency))
                };
                let sweep = |prefix: &str, amplitude: f64, frequencies: (f64, f64)| Test {
                    name: format!("{prefix}sweep_{amplitude}mm_{}_{}Hz", frequencies.0, frequencies.1),
                    motion: Waveform::Sweep { amplitude: amplitude * 1e-3, frequencies, seconds: 12.0 },
                    ..sine(prefix, row(amplitude, frequencies.0))
                };
                references(20.0, 1.3)
                    .chain(
                        [(40.0, 0.05), (20.0, 0.05), (20.0, 0.25), (20.0, 1.0), (5.0, 0.2)]
                            .map(|(a, f)| triangle(a, f)),
                    )
                    .chain([(5.0, 1.0), (5.0, 4.0), (40.0, 1.0), (1.0, 0.5), (1.0, 5.0)].map(|(a, f)| triangle(a, f)))
                    .chain([sweep("", 30.0, (0.5, 12.0)), sweep("", 12.0, (0.5, 15.0)), sweep("", 4.0, (1.0, 20.0))])
                    .chain(
                        [row(1.0, 20.0), row(10.0, 12.0), (10.0, 2.0, 20.0, 0.0), (10.0, 2.0, -20.0, 0.0)]
                            .map(|r| sine("", r)),
                    )
                    .chain([
                        sweep(LEFT_OUT_PREFIX, 20.0, (0.4, 14.0)),
                        road(LEFT_OUT_PREFIX, 1, 0.025, 0.9, 0.0, 0.0, roads),
                    ])
                    .chain([row(14.0, 3.2), row(3.5, 11.0)].map(|r| sine(LEFT_OUT_PREFIX, r)))
                    .collect()
            }
            Plan::Roads => (1..=6)
                .map(|i| {
                    let (x, v) = [(0.02, 0.4), (0.03, 0.8), (0.04, 1.3)][(i as usize - 1) % 3];
                    road("", i, x, v, 0.0, 0.0, roads)
                })
                .chain([row(25.0, 0.05), row(2.0, 0.5), row(25.0, 2.0), row(2.0, 15.0)].map(|r| sine("", r)))
                .chain((7..=8).map(|i| road(LEFT_OUT_PREFIX, i, 0.028, 0.9, 0.0, 0.0, roads)))
                .collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn plans_have_their_tests_and_every_name_once() {
        for plan in [Plan::Sines, Plan::Thesis, Plan::Reduced, Plan::Ramps, Plan::Roads] {
            let tests = plan.tests(10.0);
            let names: BTreeSet<&str> = tests.iter().map(|t| t.name.as_str()).collect();
            assert_eq!(names.len(), tests.len(), "{plan:?}");
            assert!(tests.iter().all(|t| t.left_out == t.name.starts_with(LEFT_OUT_PREFIX)), "{plan:?}");
            assert!(tests.iter().any(|t| t.left_out), "{plan:?}");
        }
        let sines = Plan::Sines.tests(10.0);
        assert_eq!((sines.len(), sines.iter().filter(|t| t.left_out).count()), (44, 10));
    }
}
