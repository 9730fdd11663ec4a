//! A non-decreasing curve through measured points: monotone cubic or linear, extrapolated linearly beyond its ends.
//!
//! The force–velocity curve and the lookup spring are such curves. Besides value and derivative, a curve computes the
//! *resolvent* of an implicit step: the `u` that satisfies `a u + f(u) = r` ([`Curve::solve`]). The solution is unique,
//! because the curve never falls. The number of operations has a small bound, whatever the points.

use crate::fault::Reason;
use crate::math::{max, min, pair};

/// Largest number of points of a curve.
pub const MAX_POINTS: usize = 63;
/// Smallest distance between two points, m/s or m.
///
/// No channel of a test rig resolves a smaller difference of velocity or displacement. The coefficients of a piece
/// between two points are divided by the distance and its square. With a smaller distance, the piece's derivative would
/// have no valid digits.
pub const NEAREST: f64 = 1e-6;
/// Largest derivative between two points, N s/m or N/m: 100 N per micrometer (per second).
///
/// A force computed from a velocity has the rounding error of the velocity, 1e-17 m/s, times the derivative. With this
/// limit the error is far below a millinewton. The limit is a hundred times the derivative of the steepest damper's
/// curve; a steeper rise is an invalid measurement.
pub const STEEPEST: f64 = 1e8;
/// Largest number of pieces: one between each pair of adjacent points, and one beyond each end.
const PIECES: usize = 64;

/// Interpolation of a curve between its points.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Interpolation {
    /// Piecewise cubic Hermite with Fritsch–Butland derivatives (SIAM J. Sci. Stat. Comput. 5, 1984): smooth derivative,
    /// no overshoot.
    MonotoneCubic,
    /// Monotone cubic on each side of zero. The derivatives on both sides of zero differ, because the valves for
    /// rebound and compression differ.
    ///
    /// Each derivative at zero is that of the parabola through zero and two further points (see [`derivatives`]).
    CubicEachSide,
    /// Straight lines.
    Linear,
}

/// Value and derivative of a curve at one argument u (a velocity, m/s, or a displacement, m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// Value f(u), N.
    pub value: f64,
    /// Derivative df/du, N s/m or N/m.
    pub derivative: f64,
}

/// One piece of a curve: `f(u) = f0 + t (c1 + t (c2 + t c3))` with `t = u − u0`.
#[derive(Clone, Copy, Debug)]
struct Piece {
    u0: f64,
    f0: f64,
    /// Value at the start of the piece relative to that at u = 0: f0 − f(0), N.
    above: f64,
    c1: f64,
    /// Coefficient c2 for the value and 2 c2 for the derivative, so that both polynomials are evaluated in parallel.
    /// Likewise, `c3` contains c3 and 3 c3.
    c2: [f64; 2],
    c3: [f64; 2],
}

/// Extent of a piece of a curve and its mean derivative.
#[derive(Clone, Copy, Debug)]
struct Extent {
    /// Lower end of the piece as a value of t = u − u0; `high` is the upper end. The outer pieces extend to the largest
    /// finite numbers.
    low: f64,
    high: f64,
    /// Mean derivative of an inner piece, or the derivative of an outer piece.
    chord: f64,
}

/// A prepared curve.
#[derive(Clone, Copy, Debug)]
pub struct Curve {
    /// Points (u, f), ascending; the unused entries are the largest finite number.
    points: [[f64; 2]; PIECES],
    /// The pieces, without their extents, which an evaluation does not need. A piece therefore fills one cache line.
    pieces: [Piece; PIECES],
    extents: [Extent; PIECES],
    /// Number of points.
    count: u32,
    /// Largest number of points inside one of the [`BUCKETS`].
    crowded: u32,
    /// Number of points whose u is below each bucket: the buckets of positive arguments, then those of negative ones.
    below: [[u8; BUCKETS]; 2],
    /// Value of the curve at 0, f(0), N.
    at_zero: f64,
    low: f64,
    high: f64,
}

/// Value, derivative and curvature of a curve at one argument u; the value is relative to f(0).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Above {
    /// Value relative to that at 0, f(u) − f(0), N: it never has the opposite sign of u.
    pub value: f64,
    /// Derivative df/du, N s/m or N/m.
    pub derivative: f64,
    /// Curvature d²f/du².
    pub curvature: f64,
}

/// Number of buckets (intervals of the argument) on each side of 0. The bucket of an argument replaces most comparisons
/// in the lookup of its piece.
const BUCKETS: usize = 256;
/// Number of points in one bucket of the lookup above which bisection is faster than a linear search.
const CROWDED: u32 = 3;

/// Returns the bucket (interval of the lookup) that contains `u`: whether `u` has a negative sign, and the index of the
/// bucket outward from 0.
///
/// The index consists of the exponent and the first four bits of the mantissa of |u| + 2^-12, clamped below 2^4. This
/// makes sixteen buckets per power of two, so the buckets are narrow where damper curves have knees. Rounding cannot
/// reverse the order of two numbers, so the index never decreases with |u|.
#[inline(always)]
fn bucket(u: f64) -> (bool, u8) {
    const NEAREST: f64 = 1.0 / 4096.0;
    const FURTHEST: f64 = 16.0 - 1e-3;
    /// Sign, exponent and first four mantissa bits of `NEAREST`.
    const FIRST: u64 = NEAREST.to_bits() >> 48;
    let out = u.abs() + NEAREST;
    let out = min(out, FURTHEST);
    (u.is_sign_negative(), ((out.to_bits() >> 48) - FIRST) as u8)
}

const FAR: f64 = f64::MAX;
/// Largest Householder step, relative to the width of the piece, after which [`Curve::solve`] stops. The remaining
/// error, relative to that width, is then about the fourth power of this ratio.
const FEW: f64 = 1e-3;

impl Curve {
    const ZERO_PIECE: Piece = Piece { u0: 0.0, f0: 0.0, above: 0.0, c1: 0.0, c2: [0.0; 2], c3: [0.0; 2] };
    const EVERYWHERE: Extent = Extent { low: -FAR, high: FAR, chord: 0.0 };

    /// Memory for a curve, invalid before [`Curve::set`] or [`Curve::clear`]. It is all zeros and therefore takes no
    /// space in the program file.
    pub const UNSET: Curve = Curve {
        points: [[0.0; 2]; PIECES],
        pieces: [Curve::ZERO_PIECE; PIECES],
        extents: [Extent { low: 0.0, high: 0.0, chord: 0.0 }; PIECES],
        count: 0,
        crowded: 0,
        below: [[0; BUCKETS]; 2],
        at_zero: 0.0,
        low: 0.0,
        high: 0.0,
    };

    /// Prepares the curve through the points (`u`, `f`).
    ///
    /// # Errors
    /// Returns the errors of [`Curve::check`].
    pub fn new(u: &[f64], f: &[f64], interpolation: Interpolation) -> Result<Curve, Reason> {
        let mut curve = Curve::UNSET;
        curve.set(u, f, interpolation)?;
        Ok(curve)
    }

    /// Checks whether a curve can pass through the points.
    ///
    /// # Errors
    /// - fewer than two points or more than [`MAX_POINTS`], or different counts of `u` and `f`;
    /// - a non-finite number;
    /// - `u` not strictly increasing, or `f` falling anywhere;
    /// - points nearer than [`NEAREST`], or a rise beyond [`STEEPEST`].
    pub fn check(u: &[f64], f: &[f64]) -> Result<(), Reason> {
        let n = u.len();
        if !(2..=MAX_POINTS).contains(&n) {
            return Err(Reason::PointCount);
        }
        if f.len() != n {
            return Err(Reason::CurveLengths);
        }
        if u.iter().chain(f).any(|x| !x.is_finite()) {
            return Err(Reason::NotFinite);
        }
        let rises = |s: &[f64], strictly: bool| {
            s.iter().zip(s.iter().skip(1)).all(|(a, b)| if strictly { a < b } else { a <= b })
        };
        if !rises(u, true) {
            return Err(Reason::NotIncreasing);
        }
        if !rises(f, false) {
            return Err(Reason::ForceDecreases);
        }
        let gaps = u.iter().zip(u.iter().skip(1)).zip(f.iter().zip(f.iter().skip(1)));
        for ((u0, u1), (f0, f1)) in gaps {
            if u1 - u0 < NEAREST {
                return Err(Reason::TooClose);
            }
            if f1 - f0 > STEEPEST * (u1 - u0) {
                return Err(Reason::TooSteep);
            }
        }
        Ok(())
    }

    /// Prepares the curve in place, because a curve is too large for the stack of a small thread.
    ///
    /// # Errors
    /// Returns the errors of [`Curve::check`]; the curve then stays unchanged.
    #[inline(never)]
    pub fn set(&mut self, u: &[f64], f: &[f64], interpolation: Interpolation) -> Result<(), Reason> {
        Curve::check(u, f)?;
        let n = u.len();
        let curve = self;
        curve.clear();
        for (to, (u, f)) in curve.points.iter_mut().zip(u.iter().zip(f)) {
            *to = [*u, *f];
        }
        let mut at_points = [[0.0; 2]; PIECES];
        if interpolation != Interpolation::Linear {
            for (i, both) in at_points.iter_mut().enumerate().take(n) {
                *both = derivatives(u, f, i, interpolation);
            }
        }
        let derivative =
            |i: usize, side: usize| at_points.get(i).and_then(|both| both.get(side)).copied().unwrap_or(0.0);
        let at = |s: &[f64], i: usize| s.get(i).copied().unwrap_or(0.0);
        let pieces = curve.pieces.iter_mut().zip(&mut curve.extents);
        for (i, (piece, extent)) in pieces.enumerate().take(n + 1) {
            // Piece i lies left of point i. The first and the last piece extrapolate the curve with its end
            // derivatives.
            let (left, right) = (i.wrapping_sub(1), i);
            let inner = i > 0 && i < n;
            let anchor = if i == 0 { 0 } else { left };
            *piece = Piece { u0: at(u, anchor), f0: at(f, anchor), ..Curve::ZERO_PIECE };
            if inner {
                let h = at(u, right) - at(u, left);
                let chord = (at(f, right) - at(f, left)) / h;
                (extent.low, extent.high, extent.chord) = (0.0, h, chord);
                match interpolation {
                    Interpolation::Linear => piece.c1 = chord,
                    Interpolation::MonotoneCubic | Interpolation::CubicEachSide => {
                        let (m0, m1) = (derivative(left, 1), derivative(right, 0));
                        piece.c1 = m0;
                        let (c2, c3) = ((3.0 * chord - 2.0 * m0 - m1) / h, (m0 + m1 - 2.0 * chord) / (h * h));
                        piece.c2 = [c2, 2.0 * c2];
                        piece.c3 = [c3, 3.0 * c3];
                    }
                }
            } else {
                piece.c1 = match interpolation {
                    Interpolation::MonotoneCubic | Interpolation::CubicEachSide => derivative(anchor, 0),
                    Interpolation::Linear => {
                        let k = if i == 0 { 0 } else { n - 2 };
                        (at(f, k + 1) - at(f, k)) / (at(u, k + 1) - at(u, k))
                    }
                };
                extent.chord = piece.c1;
                (extent.low, extent.high) = if i == 0 { (-FAR, 0.0) } else { (0.0, FAR) };
            }
        }
        curve.count = n as u32;
        curve.low = at(u, 0);
        curve.high = at(u, n - 1);
        curve.fill_buckets(u);
        curve.at_zero = curve.evaluate(0.0).value;
        for piece in &mut curve.pieces {
            piece.above = piece.f0 - curve.at_zero;
        }
        Ok(())
    }

    /// Sets the curve to zero everywhere.
    #[inline(never)]
    pub fn clear(&mut self) {
        self.points.fill([FAR; 2]);
        self.pieces.fill(Curve::ZERO_PIECE);
        self.extents.fill(Curve::EVERYWHERE);
        self.below.as_flattened_mut().fill(0);
        (self.count, self.crowded) = (0, 0);
        (self.at_zero, self.low, self.high) = (0.0, 0.0, 0.0);
    }

    /// Counts the points below and inside every bucket.
    fn fill_buckets(&mut self, u: &[f64]) {
        let order = |(negative, place): (bool, u8)| if negative { -1 - place as i32 } else { place as i32 };
        for (negative, side) in [false, true].into_iter().zip(&mut self.below) {
            for (place, below) in (0..=u8::MAX).zip(side) {
                let here = order((negative, place));
                *below = u.iter().filter(|u| order(bucket(**u)) < here).count() as u8;
                let within = u.iter().filter(|u| order(bucket(**u)) == here).count();
                self.crowded = self.crowded.max(within as u32);
            }
        }
    }

    /// Returns the first and the last `u` of the points, or zeros for a cleared curve.
    pub fn range(&self) -> (f64, f64) {
        (self.low, self.high)
    }

    #[inline(always)]
    fn piece(&self, index: usize) -> &Piece {
        // The mask does not change the index, which is below 64. It avoids the bounds check and thus a panic path.
        &self.pieces[index & (PIECES - 1)]
    }

    /// Returns the number of points at which `key(u, f)` is at most `r`. The key rises from point to point, so this
    /// number is the index of the piece in which the key reaches `r`.
    #[inline(always)]
    fn locate(&self, r: f64, key: impl Fn(f64, f64) -> f64) -> usize {
        let mut index = 0;
        let mut halve = |half: usize| {
            let [u, f] = self.points[(index + half - 1) & (PIECES - 1)];
            index = if key(u, f) <= r { index + half } else { index };
        };
        // The bisection over the points is unrolled, so that its cost is fixed. Most curves have fewer than 16 points
        // and need only four comparisons.
        if self.count >= 16 {
            halve(32);
            halve(16);
        }
        halve(8);
        halve(4);
        halve(2);
        halve(1);
        index
    }

    /// Returns the piece that contains `u`.
    #[inline(always)]
    fn at_place(&self, u: f64) -> &Piece {
        let (negative, place) = bucket(u);
        let mut index = self.below[usize::from(negative)][usize::from(place)] as usize;
        let mut count_on = || {
            let [next, _] = self.points[index & (PIECES - 1)];
            index += usize::from(next <= u);
        };
        if self.crowded <= 1 {
            count_on();
        } else if self.crowded <= CROWDED {
            for _ in 0..CROWDED {
                count_on();
            }
        } else {
            index = self.locate(u, |u, _| u);
        }
        self.piece(index)
    }

    /// Computes value and derivative of the curve at `u`.
    #[inline(always)]
    pub fn evaluate(&self, u: f64) -> Value {
        let p = self.at_place(u);
        p.at(u - p.u0)
    }

    /// Computes the value f(u) − f(0) relative to that at 0, the derivative and the curvature of the curve at `u`.
    #[inline(always)]
    pub fn above_zero(&self, u: f64) -> Above {
        let p = self.at_place(u);
        let t = u - p.u0;
        // The polynomial of the piece is evaluated in two halves, which processors compute in parallel.
        let [bent, bending] = pair(|k| p.c2[k] + t * p.c3[k]);
        Above {
            value: (p.above + t * p.c1) + (t * t) * bent,
            derivative: p.c1 + t * bending,
            curvature: bending + t * p.c3[1],
        }
    }

    /// Returns f(0), the value of the curve at 0.
    #[inline(always)]
    pub fn at_zero(&self) -> f64 {
        self.at_zero
    }

    /// Computes the resolvent: the `u` with `a u + f(u) = r` for `a > 0`, with the value and the derivative of f there.
    ///
    /// The values of `a u + f(u)` at the points determine the piece. Inside the piece, `STEPS` Householder steps of
    /// fourth order start from the chord and are clamped to the piece. The errors below are the largest of all monotone
    /// cubic pieces, relative to the piece's height. The worst piece has end derivatives of 0 and 3 times the piece's
    /// mean derivative. If `a` is 0.6, 0.3 or 0.1 of the mean derivative, the error after two steps is at most 1e-10,
    /// 6e-8 or 2e-5. If `a` is 0.03 of the mean derivative, the error after three steps is 1e-9.
    #[inline(always)]
    pub fn solve<const STEPS: usize>(&self, a: f64, r: f64) -> (f64, Value) {
        let index = self.locate(r, |u, f| a * u + f);
        let (p, extent) = (self.piece(index), &self.extents[index & (PIECES - 1)]);
        let target = r - (a * p.u0 + p.f0);
        let c1 = a + p.c1;
        let mut t = target * (1.0 / (a + extent.chord));
        for _ in 0..STEPS {
            let [mean, derivative] = p.polynomials(c1, t);
            let value = t * mean - target;
            // Half the curvature.
            let bend = p.c2[0] + t * p.c3[1];
            let bent = value * bend;
            let narrowed = derivative * derivative - bent;
            let step = value * narrowed / (derivative * (narrowed - bent) + value * (value * p.c3[0]));
            t -= step;
            t = max(extent.low, t);
            t = min(extent.high, t);
            // The remaining error is about the fourth power of the step, both relative to the width of the piece.
            if step.abs() <= FEW * extent.high {
                break;
            }
        }
        (p.u0 + t, p.at(t))
    }
}

impl Piece {
    /// Returns (f − f0)/t and the derivative of f at `t` for a piece whose linear coefficient is replaced by `c1`.
    #[inline(always)]
    fn polynomials(&self, c1: f64, t: f64) -> [f64; 2] {
        pair(|k| c1 + t * (self.c2[k] + t * self.c3[k]))
    }

    #[inline(always)]
    fn at(&self, t: f64) -> Value {
        let [mean, derivative] = self.polynomials(self.c1, t);
        Value { value: self.f0 + t * mean, derivative }
    }
}

/// Returns the derivatives of a cubic curve through the points (`u`, `f`) before and after point `i`.
///
/// The two derivatives differ only at zero and only with [`Interpolation::CubicEachSide`]. Each is then the derivative
/// of the parabola through zero and the next two points of its side, but at least 0. If the side has only one point, the
/// derivative is that of the line to that point.
/// The limit for a monotone cubic, three times the chord, always holds: the derivative of a parabola through rising
/// points is below twice the chord.
pub fn derivatives(u: &[f64], f: &[f64], i: usize, interpolation: Interpolation) -> [f64; 2] {
    let at = |s: &[f64], k: usize| s.get(k).copied().unwrap_or(0.0);
    let is_inner = i > 0 && i + 1 < u.len();
    if interpolation != Interpolation::CubicEachSide || !is_inner || at(u, i) != 0.0 {
        return [monotone_derivative(u, f, i); 2];
    }
    let one_sided = |near: usize, far: Option<usize>| {
        let h0 = at(u, near).abs();
        let d0 = (at(f, near) - at(f, i)).abs() / h0;
        let Some(far) = far.filter(|far| *far < u.len()) else { return d0 };
        let h1 = (at(u, far) - at(u, near)).abs();
        let d1 = (at(f, far) - at(f, near)).abs() / h1;
        max(0.0, d0 + (d0 - d1) * h0 / (h0 + h1))
    };
    [one_sided(i - 1, i.checked_sub(2)), one_sided(i + 1, Some(i + 2))]
}

/// Returns the derivative at point `i` after Fritsch and Butland: the weighted harmonic mean of the slopes of the
/// neighboring chords. It is zero if the slopes differ in sign or one of them is zero. At the first and the last point
/// it is the slope of the adjacent chord.
pub fn monotone_derivative(u: &[f64], f: &[f64], i: usize) -> f64 {
    let at = |s: &[f64], k: usize| s.get(k).copied().unwrap_or(0.0);
    let n = u.len();
    let chord = |k: usize| (at(f, k + 1) - at(f, k)) / (at(u, k + 1) - at(u, k));
    if n < 2 {
        return 0.0;
    }
    if i == 0 {
        return chord(0);
    }
    if i + 1 >= n {
        return chord(n - 2);
    }
    let (h0, h1) = (at(u, i) - at(u, i - 1), at(u, i + 1) - at(u, i));
    let (d0, d1) = (chord(i - 1), chord(i));
    if d0 * d1 <= 0.0 {
        return 0.0;
    }
    let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
    (w0 + w1) / (w0 / d0 + w1 / d1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Interpolation; 3] = [Interpolation::MonotoneCubic, Interpolation::CubicEachSide, Interpolation::Linear];

    fn knee() -> ([f64; 9], [f64; 9]) {
        (
            [-1.6, -0.8, -0.3, -0.05, 0.0, 0.05, 0.3, 0.8, 1.6],
            [-1800.0, -1200.0, -800.0, -500.0, 0.0, 700.0, 1100.0, 2000.0, 3500.0],
        )
    }

    #[test]
    fn passes_through_its_points_and_never_falls() {
        let (u, f) = knee();
        for interpolation in ALL {
            let c = Curve::new(&u, &f, interpolation).unwrap();
            for (u, f) in u.iter().zip(&f) {
                assert!((c.evaluate(*u).value - f).abs() < 1e-9);
            }
            let mut last = f64::MIN;
            for i in -2500..=2500 {
                let v = c.evaluate(i as f64 * 1e-3);
                assert!(v.value >= last - 1e-9 && v.derivative >= -1e-9);
                last = v.value;
            }
        }
    }

    /// At zero, the curve has a derivative for each side: here that of a line in rebound, and that of a parabola in
    /// compression.
    #[test]
    fn each_side_has_a_derivative_of_its_own_at_zero() {
        let u = [-1.0, -0.3, -0.1, 0.0, 0.2, 0.5, 1.0];
        let f = u.map(|u: f64| if u > 0.0 { 900.0 * u } else { -4000.0 * u * u + 300.0 * u });
        let c = Curve::new(&u, &f, Interpolation::CubicEachSide).unwrap();
        assert!((c.evaluate(0.0).derivative - 900.0).abs() < 1e-9);
        assert!((c.evaluate(-1e-9).derivative - 300.0).abs() < 1e-4);
        assert!((c.evaluate(0.1).value - 90.0).abs() < 1e-9);
        // Away from zero, and without a point at zero, the curve equals the monotone cubic.
        let (plain, off) = (Interpolation::MonotoneCubic, u.map(|u| u + 1e-3));
        assert_eq!(derivatives(&u, &f, 2, Interpolation::CubicEachSide), derivatives(&u, &f, 2, plain));
        assert_eq!(derivatives(&off, &f, 3, Interpolation::CubicEachSide), derivatives(&off, &f, 3, plain));
        // The parabola of the right side falls at zero, so its derivative is limited to 0.
        let level = Curve::new(&[-1.0, 0.0, 0.1, 0.2], &[-9.0, 0.0, 1.0, 50.0], Interpolation::CubicEachSide).unwrap();
        assert_eq!(level.evaluate(0.0).derivative, 0.0);
    }

    #[test]
    fn derivative_is_the_derivative_of_the_value() {
        let (u, f) = knee();
        let c = Curve::new(&u, &f, Interpolation::MonotoneCubic).unwrap();
        for i in -200..200 {
            let at = i as f64 * 0.01 + 0.0037;
            let h = 1e-6;
            let difference = (c.evaluate(at + h).value - c.evaluate(at - h).value) / (2.0 * h);
            assert!(
                (difference - c.evaluate(at).derivative).abs() < 1e-6 * c.evaluate(at).derivative.abs().max(1000.0)
            );
        }
    }

    /// The lookup by buckets finds the piece that counting the points below an argument gives. The curves are dense and
    /// sparse, with points at the ends of buckets and at 0 of either sign.
    #[test]
    fn buckets_lead_to_the_piece_that_halving_finds() {
        let even = |n: usize, width: f64| -> std::vec::Vec<f64> {
            (0..n).map(|i| width * (2.0 * i as f64 / (n - 1) as f64 - 1.0)).collect()
        };
        let tables = [
            knee().0.to_vec(),
            even(63, 20.0),
            even(62, 0.02),
            even(33, 1.0),
            even(2, 1e-6),
            std::vec![-16.0, -0.25, -0.0, 0.25, 0.265625, 16.0, 19.0],
            std::vec![0.25, 0.5, 1e6],
            std::vec![-40.0, -30.0, -20.0],
        ];
        for u in &tables {
            let c = Curve::new(u, u, Interpolation::Linear).unwrap();
            let near = |at: f64| [at, at.next_up(), at.next_down(), at + 1e-5, at - 1e-5];
            let sweep = (-4000..=4000).map(|i| i as f64 * 0.0061);
            let bits = (0..4000).map(|i| f64::from_bits(i * 0x0004_1893_74bc_6a7f));
            for at in sweep.chain(u.iter().flat_map(|u| near(*u))).chain(bits).chain([0.0, -0.0, 1e300, -1e300]) {
                if at.is_finite() {
                    let got = c.at_place(at);
                    let wanted = c.piece(u.iter().filter(|u| **u <= at).count());
                    assert!(core::ptr::eq(got, wanted), "{at} in {u:?}");
                }
            }
        }
    }

    #[test]
    fn counted_from_zero_is_the_same_curve() {
        let (u, f) = knee();
        let f = f.map(|f| f + 250.0);
        let c = Curve::new(&u, &f, Interpolation::MonotoneCubic).unwrap();
        assert_eq!(c.at_zero(), 250.0);
        for i in -2500..=2500 {
            let at = i as f64 * 1e-3 + 1e-4;
            let (plain, above) = (c.evaluate(at), c.above_zero(at));
            assert!((plain.value - above.value - 250.0).abs() < 1e-9);
            assert!((plain.derivative - above.derivative).abs() < 1e-9 * (1.0 + plain.derivative));
            let h = 1e-6;
            let bend = (c.evaluate(at + h).derivative - c.evaluate(at - h).derivative) / (2.0 * h);
            assert!((bend - above.curvature).abs() < 1e-3 * (1.0 + bend.abs()));
            assert!(above.value * at >= 0.0);
        }
    }

    #[test]
    fn resolvent_solves_its_equation_over_twelve_decades() {
        let (u, f) = knee();
        for interpolation in ALL {
            let c = Curve::new(&u, &f, interpolation).unwrap();
            let mut worst: f64 = 0.0;
            for decade in -6..=6 {
                let a = 10f64.powi(decade);
                for i in -3000..=3000 {
                    let wanted = i as f64 * 1e-3;
                    let r = a * wanted + c.evaluate(wanted).value;
                    let (got, v) = c.solve::<3>(a, r);
                    let left = (a * got + v.value - r).abs() / (a + v.derivative.max(1.0));
                    worst = worst.max(left);
                }
            }
            assert!(worst < 2e-9, "left {worst} m/s");
        }
    }

    #[test]
    fn refuses_what_is_not_a_curve() {
        assert_eq!(Curve::new(&[0.0], &[0.0], Interpolation::Linear).err(), Some(Reason::PointCount));
        assert_eq!(Curve::new(&[0.0, 1.0], &[0.0], Interpolation::Linear).err(), Some(Reason::CurveLengths));
        assert_eq!(Curve::new(&[0.0, 0.0], &[0.0, 1.0], Interpolation::Linear).err(), Some(Reason::NotIncreasing));
        assert_eq!(Curve::new(&[0.0, 1.0], &[1.0, 0.0], Interpolation::Linear).err(), Some(Reason::ForceDecreases));
        assert_eq!(Curve::new(&[0.0, 0.9e-6], &[0.0, 1.0], Interpolation::Linear).err(), Some(Reason::TooClose));
        assert_eq!(Curve::new(&[0.0, 2e-6], &[0.0, 201.0], Interpolation::Linear).err(), Some(Reason::TooSteep));
        assert!(Curve::new(&[0.0, 2e-6], &[0.0, 199.0], Interpolation::Linear).is_ok());
        assert_eq!(Curve::new(&[0.0, f64::NAN], &[0.0, 1.0], Interpolation::Linear).err(), Some(Reason::NotFinite));
    }
}
