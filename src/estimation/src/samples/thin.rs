//! Fewer samples of the tests: enough to see which explanations are worth a closer look.

use super::Test;
use crate::segment::Segment;

/// Scored samples of a cycle that will do, and the most of which one is kept.
const ENOUGH: usize = 40;
const MOST: usize = 3;

/// Tests with a part of their samples, and which those are.
pub struct Thin {
    /// The tests.
    pub tests: Vec<Test>,
    /// Places of their scored samples among all scored samples.
    pub rows: Vec<usize>,
    /// Scored samples of all, for one that was kept.
    pub share: f64,
}

impl Thin {
    /// Of all tests, in their order; a road and a cycle of few samples stay whole.
    pub fn new(tests: &[Test]) -> Thin {
        let (mut rows, mut first) = (Vec::new(), 0);
        let thinned: Vec<Test> = tests
            .iter()
            .map(|test| {
                let every = if test.frequency > 0.0 { (test.count() / ENOUGH).clamp(1, MOST) } else { 1 };
                rows.extend((0..test.count()).step_by(every).map(|k| first + k));
                first += test.count();
                thinned(test, every)
            })
            .collect();
        let share = first as f64 / rows.len().max(1) as f64;
        Thin { tests: thinned, rows, share }
    }
}

fn thinned(test: &Test, every: usize) -> Test {
    let whole = &test.segment;
    // Counted from the first scored sample, on both sides of it.
    let kept: Vec<usize> = (whole.from % every..whole.force.len()).step_by(every).collect();
    let since = |pair: &[usize]| whole.dt[pair[0] + 1..=pair[1]].iter().sum();
    let dt = std::iter::once(0.0).chain(kept.windows(2).map(since)).collect();
    let segment = Segment {
        dt,
        input: kept.iter().map(|k| whole.input[*k]).collect(),
        force: kept.iter().map(|k| whole.force[*k]).collect(),
        from: whole.from / every,
        ..whole.clone()
    };
    let allowed = test.allowed.iter().step_by(every).copied().collect();
    Test { segment, allowed, ..test.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::Input;

    fn test(from: usize, count: usize, frequency: f64) -> Test {
        let all = from + count;
        let dt: Vec<f64> = (0..all).map(|k| if k == 0 { 0.0 } else { 1e-3 + 1e-5 * k as f64 }).collect();
        let segment = Segment {
            name: String::new(),
            dt,
            input: (0..all).map(|k| Input::motion(k as f64, -(k as f64))).collect(),
            force: (0..all).map(|k| 10.0 * k as f64).collect(),
            from,
            scale: 5.0,
            top: 1000.0,
            peak_velocity: 1.0,
            amplitude: 0.01,
            clock: 0.0,
        };
        let allowed = (0..count).map(|k| 1.0 + k as f64).collect();
        Test {
            record: 0,
            segment,
            allowed,
            mean_noise: 5.0,
            independence: 1.0,
            growth: 0.0,
            noise_freedom: 100.0,
            frequency,
        }
    }

    #[test]
    fn kept_samples_keep_their_time_their_force_and_what_is_allowed() {
        let tests = [test(31, 120, 2.0), test(30, 119, 2.0), test(20, 60, 2.0), test(0, 400, 0.0)];
        let thin = Thin::new(&tests);
        assert_eq!(thin.tests.iter().map(Test::count).collect::<Vec<_>>(), [40, 60, 60, 400]);
        assert!((thin.share - 699.0 / 560.0).abs() < 1e-12);
        let all = |of: fn(&Test) -> Vec<f64>, tests: &[Test]| tests.iter().flat_map(of).collect::<Vec<f64>>();
        let forces = |tests: &[Test]| all(|t| t.forces().to_vec(), tests);
        let allowed = |tests: &[Test]| all(|t| t.allowed.clone(), tests);
        let at = |values: Vec<f64>| thin.rows.iter().map(|k| values[*k]).collect::<Vec<f64>>();
        assert_eq!(forces(&thin.tests), at(forces(&tests)));
        assert_eq!(allowed(&thin.tests), at(allowed(&tests)));
        for (few, many) in thin.tests.iter().zip(&tests) {
            let scored = |t: &Test| t.segment.dt[t.segment.from + 1..].iter().sum::<f64>();
            // What comes after the last sample kept.
            let every = many.count().div_ceil(few.count());
            let over = (many.count() - 1) % every;
            let left_over: f64 = many.segment.dt[many.segment.dt.len() - over..].iter().sum();
            assert!((scored(few) + left_over - scored(many)).abs() < 1e-12);
            assert_eq!(few.inputs().len(), few.count());
        }
    }
}
