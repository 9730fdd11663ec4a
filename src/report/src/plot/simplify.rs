//! Thinning of a path without a visible change.

/// A point of the figure, px.
pub type Point = [f64; 2];

/// Largest invisible deviation of a thinned path, px.
const INVISIBLE: f64 = 0.2;

/// Tolerance of thinning above which the result has `rough` set, px.
const ROUGH: f64 = 1.0;

/// A thinned path.
#[derive(Debug, Clone, PartialEq)]
pub struct Thinned {
    /// The remaining points.
    pub points: Vec<Point>,
    /// Whether the path is too noisy for its limit of points. Its envelope is then correct, but its details are not.
    pub rough: bool,
}

/// Thins a path (Douglas & Peucker 1973) without a visible change.
///
/// Points closer together than 0.2 px merge. Points within 0.2 px of the line between remaining points are removed. If more than `limit`
/// points remain, as in a noisy measurement, the tolerance of 0.2 px increases until the path fits. If it exceeds 1 px, the result has
/// `rough` set.
pub fn simplify(path: &[Point], limit: usize) -> Thinned {
    let mut near = INVISIBLE;
    let mut merged = merge(path, near);
    // A path with more than 50 times `limit` points is noise on the scale of pixels. Its points are merged at larger distances, because
    // that limits the work of [`strays`].
    while merged.len() > 50 * limit.max(2) {
        near *= 1.5;
        merged = merge(path, near);
    }
    let strays = strays(&merged);
    let mut tolerance = INVISIBLE;
    while strays.iter().filter(|stray| **stray > tolerance).count() > limit.max(2) {
        tolerance *= 1.3;
    }
    let kept = merged.iter().zip(&strays).filter_map(|(point, stray)| (*stray > tolerance).then_some(*point));
    Thinned { points: kept.collect(), rough: tolerance > ROUGH }
}

/// Removes points closer than `near`, px, to the preceding remaining point. Keeps both ends of the path.
fn merge(path: &[Point], near: f64) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::with_capacity(path.len().min(4096));
    for (i, point) in path.iter().enumerate() {
        let far = kept.last().is_none_or(|last| libm::hypot(point[0] - last[0], point[1] - last[1]) >= near);
        if far || i + 1 == path.len() {
            kept.push(*point);
        }
    }
    kept
}

/// Returns for each point of a path the largest tolerance, px, at which thinning keeps it. The ends always remain. Another point remains if
/// its distance from the line between remaining points exceeds the tolerance. The farthest point does not depend on the tolerance, so one
/// pass serves all tolerances.
fn strays(path: &[Point]) -> Vec<f64> {
    let mut strays = vec![0.0; path.len()];
    let mut open = Vec::new();
    if let Some(last) = path.len().checked_sub(1) {
        (strays[0], strays[last]) = (f64::INFINITY, f64::INFINITY);
        open.push((0, last, f64::INFINITY));
    }
    while let Some((from, to, known)) = open.pop() {
        let square = square_of_distance(path[from], path[to]);
        let furthest = (from + 1..to)
            .map(|i| (i, square(path[i])))
            .fold((from, INVISIBLE * INVISIBLE), |best, this| if this.1 > best.1 { this } else { best });
        if furthest.0 != from {
            let stray = furthest.1.sqrt().min(known);
            strays[furthest.0] = stray;
            open.push((from, furthest.0, stray));
            open.push((furthest.0, to, stray));
        }
    }
    strays
}

/// Returns the squared distance of a point from the segment a–b, px².
fn square_of_distance(a: Point, b: Point) -> impl Fn(Point) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let square = dx * dx + dy * dy;
    let inverse = if square > 0.0 { 1.0 / square } else { 0.0 };
    move |point| {
        let (x, y) = (point[0] - a[0], point[1] - a[1]);
        let along = ((x * dx + y * dy) * inverse).clamp(0.0, 1.0);
        let (across, beyond) = (x - along * dx, y - along * dy);
        across * across + beyond * beyond
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(points: usize) -> Vec<Point> {
        let angle = |i: usize| std::f64::consts::TAU * i as f64 / points as f64;
        (0..=points).map(|i| [200.0 + 150.0 * libm::cos(angle(i)), 200.0 + 150.0 * libm::sin(angle(i))]).collect()
    }

    #[test]
    fn a_smooth_loop_keeps_its_shape_with_few_points() {
        let thin = simplify(&circle(5000), 500);
        assert!(!thin.rough);
        let thin = thin.points;
        assert!(thin.len() < 100, "{}", thin.len());
        for point in circle(5000) {
            let nearest =
                thin.windows(2).map(|s| square_of_distance(s[0], s[1])(point).sqrt()).fold(f64::MAX, f64::min);
            assert!(nearest <= 2.0 * INVISIBLE, "{nearest}");
        }
    }

    #[test]
    fn noise_is_held_to_the_limit_and_keeps_its_extent() {
        let mut seed = 1u32;
        let mut noise = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed) / f64::from(u32::MAX) * 40.0
        };
        let path: Vec<Point> = (0..40_000).map(|i| [f64::from(i) * 0.01, noise()]).collect();
        let thin = simplify(&path, 300);
        assert!(thin.rough);
        let thin = thin.points;
        assert!(thin.len() <= 300);
        let high = thin.iter().map(|p| p[1]).fold(f64::MIN, f64::max);
        assert!(high > 39.0, "{high}");
        assert_eq!((thin[0], thin[thin.len() - 1]), (path[0], path[path.len() - 1]));
    }

    #[test]
    fn short_paths_pass_unchanged() {
        assert!(simplify(&[], 10).points.is_empty());
        assert_eq!(simplify(&[[1.0, 2.0]], 10).points, [[1.0, 2.0]]);
        assert_eq!(simplify(&[[1.0, 1.0]; 5], 10).points, [[1.0, 1.0], [1.0, 1.0]]);
    }
}
