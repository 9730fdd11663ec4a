//! Akima's interpolation, which Adams uses (function AKISPL) for the force-velocity points of a damper's property file. Also searches for
//! points whose Akima curve follows another curve.
//!
//! H. Akima, J. ACM 17, 1970. The curve is a cubic polynomial between two points. Its slope at a point is the weighted mean of the two
//! adjacent chord slopes. The weight of a chord is the absolute difference between the two chord slopes on the other side of the point.
//! Beyond each end, two chord slopes are extrapolated linearly from the last two chords.

use super::property::Curve;
use dashpot_core::curve::{Interpolation, MAX_POINTS, NEAREST, derivatives};

/// Allowed difference of two curves in compression or in rebound, relative to the largest force in that direction. The repeatability of
/// rigs is one to two percent, so half a percent is not visible.
const SHARE: f64 = 0.005;
/// Smallest allowed difference, N. It applies to a direction with almost no force, and is below the resolution of a load cell.
const LEAST: f64 = 1.0;
/// Ratio of a difference to the allowed difference at which [`refined`] stops adding points. The margin keeps the ratio below 1 when a file
/// is read and written again, so that no points are added then.
const ADDED: f64 = 0.5;
/// Number of equal intervals between two points of a table. [`worst`] compares two curves at the ends of these intervals, except at the
/// points of the table.
const PLACES: usize = 24;

/// Interpolation of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reading {
    /// Akima's interpolation, which Adams uses.
    Akima,
    /// Interpolation of a model's FV curve.
    Model(Interpolation),
}

impl Reading {
    /// Returns the slopes, N s/m, of the curve just below and just above each point, or `None` for linear interpolation.
    fn slopes(self, curve: &Curve) -> Option<Vec<[f64; 2]>> {
        let (v, f) = (&curve.velocities, &curve.forces);
        match self {
            Reading::Akima => Some(slopes(v, f).into_iter().map(|slope| [slope; 2]).collect()),
            Reading::Model(Interpolation::Linear) => None,
            Reading::Model(interpolation) => Some((0..v.len()).map(|i| derivatives(v, f, i, interpolation)).collect()),
        }
    }
}

/// Computes Akima's slopes, N s/m, at the points with velocities `v`, m/s, and forces `f`, N.
fn slopes(v: &[f64], f: &[f64]) -> Vec<f64> {
    let n = v.len();
    let chord = |k: usize| (f[k + 1] - f[k]) / (v[k + 1] - v[k]);
    let mut chords: Vec<f64> = (0..n - 1).map(chord).collect();
    let before = |a: f64, b: f64| [3.0 * a - 2.0 * b, 2.0 * a - b];
    let (first, last) = (chords[0], chords[n - 2]);
    let (second, last_but_one) = (*chords.get(1).unwrap_or(&first), if n > 2 { chords[n - 3] } else { last });
    let [far, near] = before(last, last_but_one);
    chords.splice(0..0, before(first, second));
    chords.extend([near, far]);
    let of = |m: &[f64]| {
        let (left, right) = ((m[3] - m[2]).abs(), (m[1] - m[0]).abs());
        let size = m.iter().fold(0.0f64, |most, m| most.max(m.abs()));
        // If the chord slope changes on neither side of the point, Akima uses the mean of the two adjacent chord slopes. The tolerance
        // keeps rounding errors from affecting this decision.
        if left + right <= 1e-9 * size { 0.5 * (m[1] + m[2]) } else { (left * m[1] + right * m[2]) / (left + right) }
    };
    chords.windows(4).map(of).collect()
}

/// Returns the index of the interval of the increasing velocities `v` that contains `at`. Beyond the ends of `v`, returns the first or the
/// last interval.
fn piece(v: &[f64], at: f64) -> usize {
    v.partition_point(|v| *v <= at).min(v.len() - 1).max(1) - 1
}

/// A table with its interpolation.
struct Read<'a> {
    curve: &'a Curve,
    slopes: Option<Vec<[f64; 2]>>,
}

impl<'a> Read<'a> {
    fn new(curve: &'a Curve, reading: Reading) -> Read<'a> {
        Read { curve, slopes: reading.slopes(curve) }
    }

    /// Returns the force, N, at a velocity, m/s, within the table.
    fn at(&self, at: f64) -> f64 {
        let (v, f) = (&self.curve.velocities, &self.curve.forces);
        let i = piece(v, at);
        let (h, t) = (v[i + 1] - v[i], at - v[i]);
        let chord = (f[i + 1] - f[i]) / h;
        let Some(m) = &self.slopes else { return f[i] + t * chord };
        let (from, to) = (m[i][1], m[i + 1][0]);
        let (c2, c3) = ((3.0 * chord - 2.0 * from - to) / h, (from + to - 2.0 * chord) / (h * h));
        f[i] + t * (from + t * (c2 + t * c3))
    }
}

/// Returns the force, N, of a table at zero velocity with Adams's interpolation, or with linear interpolation if `straight` is set. Returns
/// 0 if the table excludes zero velocity or has fewer than two points.
pub fn at_rest(curve: &Curve, straight: bool) -> f64 {
    let holds =
        curve.velocities.first().is_some_and(|v| *v <= 0.0) && curve.velocities.last().is_some_and(|v| *v >= 0.0);
    let reading = if straight { Reading::Model(Interpolation::Linear) } else { Reading::Akima };
    if holds && curve.velocities.len() > 1 { Read::new(curve, reading).at(0.0) } else { 0.0 }
}

/// Largest difference between an interpolated table and a curve.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Difference {
    /// Difference, N.
    pub force: f64,
    /// Velocity of this difference, m/s.
    pub velocity: f64,
    /// Largest ratio of a difference to the allowed difference (`share`), and its velocity, m/s (`asks`). Compression and rebound have
    /// different allowed differences.
    share: f64,
    asks: f64,
}

impl Difference {
    /// Returns whether the difference is at most the allowed one at all compared velocities.
    pub fn is_small(&self) -> bool {
        self.share <= 1.0
    }

    /// Formats the difference and its velocity.
    pub fn describe(&self) -> String {
        format!("at most {:.1} N (at {:.0} mm/s)", self.force, 1e3 * self.velocity)
    }
}

/// Returns the allowed difference in compression and in rebound, N.
fn tolerance(curve: &Curve) -> [f64; 2] {
    [false, true].map(|rebound| {
        let side = curve.velocities.iter().zip(&curve.forces).filter(|(v, _)| (**v > 0.0) == rebound);
        LEAST.max(SHARE * side.fold(0.0f64, |most, (_, f)| most.max(f.abs())))
    })
}

/// Computes the largest difference, N, between `target` and the table `curve`, over all interpolations in `readings`. The difference is
/// evaluated only between the points of the table. Also computes the largest ratio of a difference to the `allowed` one, N, in compression
/// or in rebound.
fn worst(curve: &Curve, readings: &[Reading], allowed: [f64; 2], target: &dyn Fn(f64) -> f64) -> Difference {
    let read: Vec<Read> = readings.iter().map(|reading| Read::new(curve, *reading)).collect();
    let mut most = Difference::default();
    for pair in curve.velocities.windows(2) {
        for k in 1..PLACES {
            let at = pair[0] + (pair[1] - pair[0]) * k as f64 / PLACES as f64;
            let wanted = target(at);
            for read in &read {
                let force = (read.at(at) - wanted).abs();
                let share = force / allowed[usize::from(at > 0.0)];
                if share > most.share {
                    (most.share, most.asks) = (share, at);
                }
                if force > most.force {
                    (most.force, most.velocity) = (force, at);
                }
            }
        }
    }
    most
}

/// Adds points to a table until it differs from `target` by at most [`ADDED`] of the `allowed` difference, N, with each interpolation in
/// `readings`. Stops earlier at [`MAX_POINTS`] points, or if two points are too close for another between them.
fn refined(mut curve: Curve, readings: &[Reading], allowed: [f64; 2], target: &dyn Fn(f64) -> f64) -> Curve {
    while curve.velocities.len() < MAX_POINTS {
        let at = worst(&curve, readings, allowed, target);
        if at.share <= ADDED {
            break;
        }
        let i = curve.velocities.partition_point(|v| *v <= at.asks);
        let (low, high) = (curve.velocities[i - 1] + 10.0 * NEAREST, curve.velocities[i] - 10.0 * NEAREST);
        if !(low < high) {
            break;
        }
        let velocity = at.asks.max(low).min(high);
        // The force of a model's curve never decreases with velocity, so rounding must not cause a decrease.
        let force = target(velocity).min(curve.forces[i]).max(curve.forces[i - 1]);
        curve.velocities.insert(i, velocity);
        curve.forces.insert(i, force);
    }
    curve
}

/// Adds points to a model's FV curve until the Akima curve through them follows `model`, which returns the force, N, at a velocity, m/s.
/// Returns the points and the remaining difference between the Akima curve and `model`.
pub fn written(points: Curve, interpolation: Interpolation, model: &dyn Fn(f64) -> f64) -> (Curve, Difference) {
    let allowed = tolerance(&points);
    let akima = |curve: &Curve| worst(curve, &[Reading::Akima], allowed, model);
    let as_it_is = akima(&points);
    if as_it_is.is_small() {
        return (points, as_it_is);
    }
    // The points must also suit the model's interpolation, so that reading the file gives this curve again.
    let curve = refined(points, &[Reading::Akima, Reading::Model(interpolation)], allowed, model);
    let left = akima(&curve);
    (curve, left)
}

/// Finds points and an interpolation with which a model's curve follows the Akima curve of a file.
///
/// Keeps the points of the file if one of the model's interpolations suffices. Otherwise, adds points. If the file has more points than a
/// model can contain, begins with few of them. Returns the points, the model's interpolation and the remaining difference of the two
/// curves.
pub fn read(points: Curve) -> (Curve, Interpolation, Difference) {
    let allowed = tolerance(&points);
    let akima = Read::new(&points, Reading::Akima);
    let against =
        |curve: &Curve, interpolation| worst(curve, &[Reading::Model(interpolation)], allowed, &|v| akima.at(v));
    let fits = points.velocities.len() <= MAX_POINTS;
    if fits {
        let all = [Interpolation::MonotoneCubic, Interpolation::Linear, Interpolation::CubicEachSide];
        let mut read = all.map(|interpolation| (interpolation, against(&points, interpolation)));
        if let Some((interpolation, left)) = read.iter().find(|(_, left)| left.is_small()) {
            return (points.clone(), *interpolation, *left);
        }
        if points.velocities.len() == MAX_POINTS {
            read.sort_by(|a, b| a.1.share.total_cmp(&b.1.share));
            let [(interpolation, left), ..] = read;
            return (points, interpolation, left);
        }
    }
    let rising = |at: f64| {
        let i = piece(&points.velocities, at);
        let (from, low, high) = (points.velocities[i], points.forces[i], points.forces[i + 1].max(points.forces[i]));
        let so_far = (0..=PLACES).map(|k| akima.at(from + (at - from) * k as f64 / PLACES as f64));
        so_far.fold(low, f64::max).min(high)
    };
    let interpolation = Interpolation::MonotoneCubic;
    let start = if fits { points.clone() } else { few(&points) };
    let curve = refined(start, &[Reading::Model(interpolation), Reading::Akima], allowed, &rising);
    let left = against(&curve, interpolation);
    (curve, interpolation, left)
}

/// Returns points whose linear interpolation in a model follows the linear curve of a file.
///
/// If a model cannot contain all points of the file, computes fewer. Also returns the remaining difference between the two curves.
pub fn read_linear(points: Curve) -> (Curve, Difference) {
    if points.velocities.len() <= MAX_POINTS {
        return (points, Difference::default());
    }
    let (allowed, straight) = (tolerance(&points), Reading::Model(Interpolation::Linear));
    let lines = Read::new(&points, straight);
    let curve = refined(few(&points), &[straight], allowed, &|v| lines.at(v));
    let left = worst(&curve, &[straight], allowed, &|v| lines.at(v));
    (curve, left)
}

/// Returns the end points of a table and its point nearest to zero velocity. [`refined`] adds other points to them.
fn few(points: &Curve) -> Curve {
    let (v, last) = (&points.velocities, points.velocities.len() - 1);
    let slowest = (0..=last).min_by(|a, b| v[*a].abs().total_cmp(&v[*b].abs())).unwrap_or(0);
    let mut kept = vec![0, slowest, last];
    kept.dedup();
    Curve { velocities: kept.iter().map(|i| v[*i]).collect(), forces: kept.iter().map(|i| points.forces[*i]).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::curve::Curve as Kernel;

    fn table(rows: &[[f64; 2]]) -> Curve {
        Curve { velocities: rows.iter().map(|r| r[0]).collect(), forces: rows.iter().map(|r| r[1]).collect() }
    }

    fn steep() -> Curve {
        table(&[[-1.0, -1200.0], [-0.002, -200.0], [0.0, 0.0], [0.002, 200.0], [1.0, 2200.0]])
    }

    /// The expected forces in `AKIMA` come from scipy.interpolate.Akima1DInterpolator.
    #[test]
    fn the_curve_is_akimas() {
        let curve = table(&[[-1.0, -900.0], [-0.3, -500.0], [0.0, 0.0], [0.2, 600.0], [0.5, 900.0], [1.0, 1100.0]]);
        let akima = Read::new(&curve, Reading::Akima);
        for (at, force) in AKIMA {
            assert!((akima.at(at) - force).abs() < 1e-6, "{at} {force} {}", akima.at(at));
        }
    }

    const AKIMA: [(f64, f64); 5] = [
        (-0.8, -861.754225500),
        (-0.1, -200.997709625),
        (0.05, 138.700265252),
        (0.3, 737.842617153),
        (0.9, 1081.415384615),
    ];

    #[test]
    fn points_are_added_until_akimas_curve_follows_a_models() {
        let knees = table(&[[-0.04, -250.0], [-0.02, -240.0], [0.0, 0.0], [0.02, 400.0], [0.4, 704.0], [0.8, 1304.0]]);
        let smooth =
            table(&[[-1.5, -1800.0], [-0.5, -850.0], [-0.13, -450.0], [0.0, 0.0], [0.13, 780.0], [1.5, 3300.0]]);
        for curve in [steep(), knees, smooth] {
            for interpolation in [Interpolation::Linear, Interpolation::MonotoneCubic, Interpolation::CubicEachSide] {
                let kernel = Kernel::new(&curve.velocities, &curve.forces, interpolation).unwrap();
                let model = |v: f64| kernel.evaluate(v).value;
                let before = worst(&curve, &[Reading::Akima], tolerance(&curve), &model);
                let (points, left) = written(curve.clone(), interpolation, &model);
                assert!(
                    !before.is_small() && left.is_small(),
                    "{curve:?} {interpolation:?} {before:?} {left:?} {points:?}"
                );
                let (back, read_as, _) = read(points.clone());
                assert_eq!(back, points, "what is read is what was written");
                let again = Kernel::new(&back.velocities, &back.forces, read_as).unwrap();
                let (twice, _) = written(back.clone(), read_as, &|v| again.evaluate(v).value);
                assert_eq!(twice, points, "and is written again as it was");
            }
        }
    }

    #[test]
    fn a_file_becomes_the_curve_that_adams_makes_of_it() {
        // Akima's curve decreases between points of the table `steep()`, but a model's curve cannot decrease. So the test expects that the
        // model does not follow the curve of this table.
        let car = table(&[
            [-1.27, -1495.5],
            [-0.508, -1000.0],
            [-0.254, -809.5],
            [-0.127, -600.0],
            [-0.025, -120.0],
            [0.0, 0.0],
            [0.025, 200.0],
            [0.127, 1000.0],
            [0.254, 1423.4],
            [0.508, 1800.0],
            [1.27, 2900.0],
        ]);
        for (points, is_followed) in [(car, true), (steep(), false)] {
            let (curve, interpolation, left) = read(points.clone());
            assert_eq!(left.is_small(), is_followed, "{left:?} {curve:?}");
            let kernel = Kernel::new(&curve.velocities, &curve.forces, interpolation).unwrap();
            let (again, _) = written(curve.clone(), interpolation, &|v| kernel.evaluate(v).value);
            assert!(!is_followed || again == curve);
            assert!(curve.velocities.len() > points.velocities.len());
        }
    }

    #[test]
    fn a_table_longer_than_a_models_keeps_its_curve() {
        // The table of a degressive damper has a sharp knee and a linear rise above it, in steps of 5 mm/s.
        let force = |v: f64| if v < 0.0 { 0.55 } else { 1.0 } * 900.0 * libm::tanh(v / 0.08) + 700.0 * v;
        let velocities: Vec<f64> = (-300..=300).map(|i| 5e-3 * f64::from(i)).collect();
        let points = Curve { forces: velocities.iter().map(|v| force(*v)).collect(), velocities };
        for (curve, interpolation, left) in [read(points.clone()), {
            let (curve, left) = read_linear(points.clone());
            (curve, Interpolation::Linear, left)
        }] {
            assert!(curve.velocities.len() <= MAX_POINTS && left.is_small(), "{interpolation:?} {left:?}");
            let kernel = Kernel::new(&curve.velocities, &curve.forces, interpolation).unwrap();
            for (v, f) in points.velocities.iter().zip(&points.forces) {
                assert!(
                    (kernel.evaluate(*v).value - f).abs() < 0.006 * 1950.0,
                    "{v}: {} for {f}",
                    kernel.evaluate(*v).value
                );
            }
            assert_eq!(kernel.evaluate(0.0).value, 0.0);
        }
    }

    #[test]
    fn two_points_are_a_straight_line() {
        let line = table(&[[-1.0, -10.0], [1.0, 30.0]]);
        assert!((Read::new(&line, Reading::Akima).at(0.5) - 20.0).abs() < 1e-9);
        assert_eq!(read(line.clone()).0, line);
    }
}
