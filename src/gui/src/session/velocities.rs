//! Contents of the two tables that a dyno prints. One has the forces at the peak velocities of every test (PVP), the other the forces at
//! given velocities within one cycle (CVP).

use crate::session::Session;
use crate::session::campaign::Seen;
use crate::session::simulation::OfTest;
use dashpot_records::Record;

/// Measured force and, with a model, computed force, N.
pub type Pair = (f64, Option<f64>);

/// Forces of a test at its peak velocities.
pub struct AtPeak {
    /// Name of the test.
    pub test: String,
    /// Amplitude, m.
    pub amplitude: f64,
    /// Velocity, m/s, and forces, N, in rebound and in compression; `None` for a direction without motion.
    pub sides: [Option<(f64, Pair)>; 2],
}

/// Forces at a velocity within a cycle.
pub struct AtVelocity {
    /// Velocity, m/s, rebound positive.
    pub velocity: f64,
    /// Forces while the speed rises and while the speed falls; `None` if the cycle does not pass the velocity with rising or with falling
    /// speed.
    pub forces: [Option<Pair>; 2],
}

/// Fraction of the peak velocity above which samples count as fastest. The plot of peak forces uses the same value.
const FASTEST: f64 = 0.995;
/// Largest number of velocities of a cycle in each direction.
const ROWS: usize = 8;

/// Returns the forces of all tests at their peak velocities, by decreasing amplitude and then by increasing velocity.
pub fn at_peaks(session: &Session) -> Vec<AtPeak> {
    let Some(loaded) = &session.campaign else { return Vec::new() };
    let mut rows: Vec<AtPeak> = loaded
        .tests
        .iter()
        .zip(&loaded.campaign.records)
        .enumerate()
        .map(|(k, (seen, record))| {
            let of = session.simulated.as_ref().and_then(|s| s.tests.get(k));
            let side = |which: usize| {
                let [velocity, force] = seen.peaks[which];
                let is_there = velocity.is_finite() && force.is_finite() && velocity != 0.0;
                is_there.then(|| (velocity, (force, of.and_then(|of| of_model(of, seen, velocity.signum())))))
            };
            AtPeak { test: record.name.clone(), amplitude: record.amplitude, sides: [side(0), side(1)] }
        })
        .collect();
    let speed = |row: &AtPeak| row.sides.iter().flatten().map(|s| s.0.abs()).fold(0.0, f64::max);
    rows.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude).then(speed(a).total_cmp(&speed(b))));
    rows
}

/// Averages the model's force, N, over the fastest samples of the shown cycle, in rebound (`sign` 1) or in compression (`sign` −1).
fn of_model(of: &OfTest, seen: &Seen, sign: f64) -> Option<f64> {
    let at = |i: usize| sign * seen.motion.velocity.get(seen.shown.start + i * of.stride).copied().unwrap_or(0.0);
    let fastest = (0..of.shown.len()).map(at).fold(0.0, f64::max);
    let forces: Vec<f64> = (0..of.shown.len()).filter(|i| at(*i) >= FASTEST * fastest).map(|i| of.shown[i]).collect();
    (fastest > 0.0 && !forces.is_empty()).then(|| forces.iter().sum::<f64>() / forces.len() as f64)
}

/// Returns forces of a test at round velocities within one cycle; `factor` converts SI to the displayed unit.
pub fn within_cycle(session: &Session, test: usize, factor: f64) -> Vec<AtVelocity> {
    let Some((loaded, record)) = session.campaign.as_ref().zip(session.record(test)) else { return Vec::new() };
    let seen = &loaded.tests[test];
    let of = session.simulated.as_ref().and_then(|s| s.tests.get(test));
    let cycle = Cycle::new(record, seen, of);
    let mut rows = Vec::new();
    for sign in [1.0, -1.0] {
        let fastest = cycle.velocity.iter().map(|v| sign * v).fold(0.0, f64::max);
        let mut side: Vec<AtVelocity> = round(factor * fastest)
            .into_iter()
            .map(|shown| shown / factor)
            .map(|speed| AtVelocity {
                velocity: sign * speed,
                forces: [true, false].map(|up| cycle.at(sign, speed, up)),
            })
            .filter(|row| row.forces.iter().any(Option::is_some))
            .collect();
        if sign > 0.0 {
            side.reverse();
        }
        rows.extend(side);
    }
    rows
}

/// Returns round velocities below the fastest velocity: multiples of 1, 2 or 5 times a power of ten. At most [`ROWS`] velocities are
/// returned.
fn round(fastest: f64) -> Vec<f64> {
    if !(fastest.is_finite() && fastest > 0.0) {
        return Vec::new();
    }
    let rough = fastest / ROWS as f64;
    let decade = libm::pow(10.0, libm::log10(rough).floor());
    let step =
        [1.0, 2.0, 5.0, 10.0].map(|f| f * decade).into_iter().find(|s| *s >= rough * (1.0 - 1e-9)).unwrap_or(rough);
    (1..).map(|k| f64::from(k) * step).take_while(|v| *v < fastest).collect()
}

/// Velocities and forces of the shown cycle. [`Cycle::at`] treats the samples as periodic.
struct Cycle {
    velocity: Vec<f64>,
    measured: Vec<f64>,
    /// Force of the model at every n-th sample, and the value of n.
    model: Option<(Vec<f64>, usize)>,
}

impl Cycle {
    fn new(record: &Record, seen: &Seen, of: Option<&OfTest>) -> Cycle {
        Cycle {
            velocity: seen.motion.velocity[seen.shown.clone()].to_vec(),
            measured: record.force[seen.shown.clone()].to_vec(),
            model: of.map(|of| (of.shown.clone(), of.stride)),
        }
    }

    /// Interpolates the forces, N, at the speed `speed`, m/s, in the direction `sign`, while the speed rises or falls. Returns `None` if
    /// the cycle does not pass this speed.
    fn at(&self, sign: f64, speed: f64, rising: bool) -> Option<Pair> {
        let n = self.velocity.len();
        let crossings: Vec<(usize, f64)> = (0..n)
            .filter_map(|i| {
                let [a, b] = [i, (i + 1) % n].map(|k| sign * self.velocity[k]);
                let passes = if rising { a < speed && b >= speed } else { a >= speed && b < speed };
                passes.then(|| (i, (speed - a) / (b - a)))
            })
            .collect();
        if crossings.is_empty() {
            return None;
        }
        let mean = |force: &dyn Fn(usize, f64) -> f64| {
            crossings.iter().map(|(i, part)| force(*i, *part)).sum::<f64>() / crossings.len() as f64
        };
        let measured = mean(&|i, part| {
            let [a, b] = [i, (i + 1) % n].map(|k| self.measured[k]);
            a + part * (b - a)
        });
        let model = self.model.as_ref().filter(|(forces, _)| !forces.is_empty()).map(|(forces, stride)| {
            mean(&|i, part| {
                // Interpolate between the two neighboring samples of the model's force.
                let at = (i as f64 + part) / *stride as f64;
                let k = at as usize;
                let [a, b] = [k, k + 1].map(|k| forces[k % forces.len()]);
                a + (at - k as f64) * (b - a)
            })
        });
        Some((measured, model))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn velocities_are_round_in_the_unit_that_is_shown() {
        assert_eq!(round(1.05), [0.2, 0.4, 0.6000000000000001, 0.8, 1.0]);
        assert_eq!(round(262.0), [50.0, 100.0, 150.0, 200.0, 250.0]);
        assert!(round(0.0).is_empty() && round(f64::NAN).is_empty());
        for fastest in [0.003, 0.07, 1.0, 41.3, 1048.0] {
            assert!((4..=10).contains(&round(fastest).len()), "{fastest}: {:?}", round(fastest));
        }
    }

    #[test]
    fn forces_of_a_cycle_are_told_apart_by_whether_the_speed_rises() {
        let n = 400;
        let phase = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
        let velocity: Vec<f64> = (0..n).map(|i| libm::cos(phase(i))).collect();
        // The force is 1000 N s/m times velocity, with a loop: up to 50 N more while the speed of rebound rises.
        let measured: Vec<f64> = (0..n).map(|i| 1000.0 * libm::cos(phase(i)) - 50.0 * libm::sin(phase(i))).collect();
        let thinned: Vec<f64> = measured.iter().step_by(4).copied().collect();
        let cycle = Cycle { velocity, measured, model: Some((thinned, 4)) };
        let root = libm::sqrt(1.0 - 0.6 * 0.6);
        for (sign, rising, expected) in [
            (1.0, true, 600.0 + 50.0 * root),
            (1.0, false, 600.0 - 50.0 * root),
            (-1.0, true, -600.0 - 50.0 * root),
            (-1.0, false, -600.0 + 50.0 * root),
        ] {
            let (measured, model) = cycle.at(sign, 0.6, rising).unwrap();
            assert!((measured - expected).abs() < 0.2, "{measured} {expected}");
            assert!((model.unwrap() - expected).abs() < 2.0, "{model:?} {expected}");
        }
        assert!(cycle.at(1.0, 1.5, true).is_none());
    }
}
