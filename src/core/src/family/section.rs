//! The tables of a damper at one setting, borrowed from the family.

use crate::curve::{Above, Curve, Interpolation, MAX_POINTS, Value};
use crate::elements::valve_hysteresis::{Conductance, tabulated};
use crate::math::{max, min};
use core::fmt::Debug;

use crate::tables::{Conducted, Conduction, ForceLaw, Lookup, Tables};

/// Size of the arrays of a curve: the largest number of points, and one entry beyond all of them.
pub(crate) const ROOM: usize = MAX_POINTS + 1;
/// Mask of an index into the arrays of a curve, which replaces the bounds check.
const MASK: usize = ROOM - 1;
/// Abscissa of unused entries, beyond all points.
const FAR: f64 = f64::MAX;
/// Largest Householder step, relative to the width of the piece, after which the iteration of `solve` stops, as in
/// [`Curve::solve`].
const FEW: f64 = 1e-3;

/// Points of a curve at one setting.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Points {
    /// Abscissae (velocities, m/s), and the reciprocal of the distance to the next abscissa. Unused abscissae are the
    /// largest finite number.
    pub u: [f64; ROOM],
    pub per: [f64; ROOM],
    /// Forces of the points, N.
    pub f: [f64; ROOM],
}

impl Points {
    /// No points.
    pub const NONE: Points = Points { u: [FAR; ROOM], per: [0.0; ROOM], f: [FAR; ROOM] };

    /// Sets the points (u, f).
    pub fn set(&mut self, u: &[f64], f: &[f64]) {
        *self = Points::NONE;
        for (to, from) in self.u.iter_mut().zip(u) {
            *to = *from;
        }
        for (to, from) in self.f.iter_mut().zip(f) {
            *to = *from;
        }
        for (per, (u, next)) in self.per.iter_mut().zip(u.iter().zip(u.iter().skip(1))) {
            *per = 1.0 / (next - u);
        }
    }
}

/// The FV curve at one setting. It contains points only; each piece is computed when an evaluation needs it.
#[derive(Clone, Copy, Debug)]
pub struct Section<'a> {
    u: &'a [f64; ROOM],
    per: &'a [f64; ROOM],
    f: &'a [f64; ROOM],
    count: usize,
    interpolation: Interpolation,
}

/// A piece of the curve: f(u) = f0 + t (c1 + t (c2 + t c3)) with t = u − u0.
struct Piece {
    u0: f64,
    f0: f64,
    c1: f64,
    c2: f64,
    c3: f64,
    low: f64,
    high: f64,
    chord: f64,
}

impl<'a> Section<'a> {
    /// Makes the curve through `count` points.
    #[inline(always)]
    pub(crate) fn new(
        u: &'a [f64; ROOM],
        per: &'a [f64; ROOM],
        f: &'a [f64; ROOM],
        count: usize,
        interpolation: Interpolation,
    ) -> Section<'a> {
        Section { u, per, f, count, interpolation }
    }

    /// Returns the number of points at which `key(u, f)` is at most `r`. It is the index of the piece in which the key,
    /// which rises from point to point, reaches `r`.
    #[inline(always)]
    fn locate(&self, r: f64, key: impl Fn(f64, f64) -> f64) -> usize {
        let mut index = 0;
        let mut halve = |half: usize| {
            let place = (index + half - 1) & MASK;
            index = if key(self.u[place], self.f[place]) <= r { index + half } else { index };
        };
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

    /// Returns the mean derivative of the curve between a point and the next, N s/m.
    #[inline(always)]
    fn chord(&self, point: usize) -> f64 {
        let (from, to) = (point & MASK, (point + 1) & MASK);
        (self.f[to] - self.f[from]) * self.per[from]
    }

    /// Computes the Fritsch–Butland derivative at a point. `before` and `after` are the mean derivatives on both sides,
    /// at least 0.
    #[inline(always)]
    fn derivative(&self, point: usize, before: f64, after: f64) -> f64 {
        if point == 0 {
            return after;
        }
        if point + 1 >= self.count {
            return before;
        }
        // The weights of the harmonic mean, times the reciprocals of the distances to both neighbors.
        let (r0, r1) = (self.per[(point - 1) & MASK], self.per[point & MASK]);
        let (w0, w1) = (2.0 * r0 + r1, r0 + 2.0 * r1);
        let product = before * after;
        if product > 0.0 { (w0 + w1) * product / (w0 * after + w1 * before) } else { 0.0 }
    }

    /// Returns whether the curve may have different derivatives on the two sides of a point.
    #[inline(always)]
    fn has_kink_at(&self, point: usize) -> bool {
        self.interpolation == Interpolation::CubicEachSide && self.u[point & MASK] == 0.0
    }

    /// Computes the derivative at zero of one side of the curve, as [`crate::curve::derivatives`] does.
    ///
    /// The side has the piece after the point `near` and, if present, the piece after the point `far`.
    #[inline(always)]
    fn derivative_of_side(&self, near: usize, far: Option<usize>) -> f64 {
        let d0 = self.chord(near);
        let Some(far) = far else { return d0 };
        // The last factor is h0/(h0 + h1) with the widths h0 and h1 of both pieces, computed from their reciprocals.
        let (r0, r1) = (self.per[near & MASK], self.per[far & MASK]);
        max(0.0, d0 + (d0 - self.chord(far)) * (r1 / (r0 + r1)))
    }

    /// Computes the piece left of point `index`.
    #[inline(always)]
    fn piece(&self, index: usize) -> Piece {
        let last = self.count.wrapping_sub(1);
        if index > 0 && index <= last {
            let left = index - 1;
            let (per, chord) = (self.per[left & MASK], self.chord(left));
            let (u0, f0) = (self.u[left & MASK], self.f[left & MASK]);
            let high = self.u[index & MASK] - u0;
            if self.interpolation == Interpolation::Linear {
                return Piece { u0, f0, c1: chord, c2: 0.0, c3: 0.0, low: 0.0, high, chord };
            }
            let m0 = if left > 0 && self.has_kink_at(left) {
                let after = if index < last { Some(index) } else { None };
                self.derivative_of_side(left, after)
            } else {
                self.derivative(left, if left > 0 { self.chord(left - 1) } else { 0.0 }, chord)
            };
            let m1 = if index < last && self.has_kink_at(index) {
                self.derivative_of_side(left, left.checked_sub(1))
            } else {
                self.derivative(index, chord, if index < last { self.chord(index) } else { 0.0 })
            };
            let c2 = (3.0 * chord - 2.0 * m0 - m1) * per;
            let c3 = (m0 + m1 - 2.0 * chord) * (per * per);
            return Piece { u0, f0, c1: m0, c2, c3, low: 0.0, high, chord };
        }
        // Beyond its first and last point the curve is linear; without points it is zero everywhere.
        if self.count < 2 {
            return Piece { u0: 0.0, f0: 0.0, c1: 0.0, c2: 0.0, c3: 0.0, low: -FAR, high: FAR, chord: 0.0 };
        }
        let (anchor, derivative) = if index == 0 { (0, self.chord(0)) } else { (last, self.chord(last - 1)) };
        let (low, high) = if index == 0 { (-FAR, 0.0) } else { (0.0, FAR) };
        Piece {
            u0: self.u[anchor & MASK],
            f0: self.f[anchor & MASK],
            c1: derivative,
            c2: 0.0,
            c3: 0.0,
            low,
            high,
            chord: derivative,
        }
    }
}

impl Piece {
    #[inline(always)]
    fn at(&self, t: f64) -> Value {
        Value {
            value: self.f0 + t * (self.c1 + t * (self.c2 + t * self.c3)),
            derivative: self.c1 + t * (2.0 * self.c2 + t * (3.0 * self.c3)),
        }
    }
}

impl ForceLaw for Section<'_> {
    #[inline(always)]
    fn evaluate(&self, u: f64) -> Value {
        let piece = self.piece(self.locate(u, |u, _| u));
        piece.at(u - piece.u0)
    }

    #[inline(always)]
    fn above_zero(&self, u: f64) -> Above {
        let piece = self.piece(self.locate(u, |u, _| u));
        let t = u - piece.u0;
        let Value { value, derivative } = piece.at(t);
        Above { value: value - self.at_zero(), derivative, curvature: 2.0 * piece.c2 + t * (6.0 * piece.c3) }
    }

    #[inline(always)]
    fn at_zero(&self) -> f64 {
        self.evaluate(0.0).value
    }

    /// Solves `a u + f(u) = r`: returns the velocity u, m/s, and value and derivative of the curve there.
    #[inline(always)]
    fn solve<const STEPS: usize>(&self, a: f64, r: f64) -> (f64, Value) {
        let p = self.piece(self.locate(r, |u, f| a * u + f));
        let target = r - (a * p.u0 + p.f0);
        let c1 = a + p.c1;
        let mut t = target * (1.0 / (a + p.chord));
        for _ in 0..STEPS {
            let (mean, derivative) = (c1 + t * (p.c2 + t * p.c3), c1 + t * (2.0 * p.c2 + t * (3.0 * p.c3)));
            let value = t * mean - target;
            let bend = p.c2 + t * (3.0 * p.c3);
            let bent = value * bend;
            let narrowed = derivative * derivative - bent;
            let step = value * narrowed / (derivative * (narrowed - bent) + value * (value * p.c3));
            t -= step;
            t = max(p.low, t);
            t = min(p.high, t);
            if step.abs() <= FEW * p.high {
                break;
            }
        }
        (p.u0 + t, p.at(t))
    }

    fn range(&self) -> (f64, f64) {
        if self.count < 2 { (0.0, 0.0) } else { (self.u[0], self.u[(self.count - 1) & MASK]) }
    }
}

/// Conductance of a lagging valve's passage at one setting.
#[derive(Clone, Copy, Debug)]
pub enum Passage<'a> {
    /// The table of the family, if neither the curve nor the valve depends on the setting.
    Table(&'a Conductance),
    /// Values computed from the FV curve, if the curve or the valve depends on the setting. They equal those of a table
    /// that begins at this force, N.
    From(f64),
}

impl Conduction for Passage<'_> {
    #[inline(always)]
    fn conducted(&self, curve: &impl ForceLaw, h: f64, stroke: f64) -> Conducted {
        match self {
            Passage::Table(table) => table.conducted(curve, h, stroke),
            Passage::From(opens) => tabulated(curve, *opens, h, stroke),
        }
    }
}

impl Lookup for &Curve {
    #[inline(always)]
    fn lookup(&self, u: f64) -> Value {
        self.evaluate(u)
    }
}

/// Tables that a damper at one setting borrows.
#[derive(Clone, Copy, Debug)]
pub struct Lent<'a>(core::marker::PhantomData<&'a ()>);

impl<'a> Tables for Lent<'a> {
    // Stages compiled for common sets of elements: without them the library is 130 KB smaller, but a step with an oil
    // column needs 10,500 instead of 6,500 instructions.
    const HAS_STAGES_OF_ITS_OWN: bool = true;
    type Fv = Section<'a>;
    type Spring = &'a Curve;
    type Conductance = Passage<'a>;
    type Kept<E: Copy + Debug + 'static> = &'a E;
}
