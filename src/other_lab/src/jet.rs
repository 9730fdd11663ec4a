//! A quantity with its first and second derivative with respect to time.
//!
//! The code of a motion computes only the displacement. Velocity and acceleration follow exactly by automatic
//! differentiation.

use std::ops::{Add, Mul, Neg, Sub};

/// A value with its first and second derivative with respect to time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet {
    /// Value.
    pub x: f64,
    /// First derivative with respect to time.
    pub v: f64,
    /// Second derivative with respect to time.
    pub a: f64,
}

impl Jet {
    /// Makes a constant.
    pub const fn constant(x: f64) -> Jet {
        Jet { x, v: 0.0, a: 0.0 }
    }

    /// Makes the time itself, whose first derivative is 1.
    pub const fn time(t: f64) -> Jet {
        Jet { x: t, v: 1.0, a: 0.0 }
    }

    /// Applies a function to this quantity by the chain rule. `f`, `first` and `second` are the function's value and
    /// derivatives at `self.x`.
    pub fn through(self, f: f64, first: f64, second: f64) -> Jet {
        Jet { x: f, v: first * self.v, a: second * self.v * self.v + first * self.a }
    }

    /// Computes the sine.
    pub fn sin(self) -> Jet {
        let (s, c) = libm::sincos(self.x);
        self.through(s, c, -s)
    }

    /// Computes the arc sine.
    pub fn asin(self) -> Jet {
        let rest = 1.0 - self.x * self.x;
        let root = rest.sqrt();
        self.through(libm::asin(self.x), 1.0 / root, self.x / (rest * root))
    }

    /// Computes the power of this quantity with the exponent `p`.
    pub fn powf(self, p: f64) -> Jet {
        let f = libm::pow(self.x, p);
        self.through(f, p * f / self.x, p * (p - 1.0) * f / (self.x * self.x))
    }

    /// Multiplies this quantity by a constant.
    pub fn times(self, by: f64) -> Jet {
        Jet { x: self.x * by, v: self.v * by, a: self.a * by }
    }

    /// Computes a step from 0 at 0 to 1 at 1 without a jump in acceleration. The step is constant outside this range.
    pub fn smooth_step(self) -> Jet {
        let u = self.x;
        if u <= 0.0 {
            return Jet::constant(0.0);
        }
        if u >= 1.0 {
            return Jet::constant(1.0);
        }
        let f = u * u * u * (10.0 + u * (6.0 * u - 15.0));
        let first = 30.0 * u * u * (1.0 - u) * (1.0 - u);
        let second = 60.0 * u * (1.0 - u) * (1.0 - 2.0 * u);
        self.through(f, first, second)
    }
}

impl Add for Jet {
    type Output = Jet;
    fn add(self, o: Jet) -> Jet {
        Jet { x: self.x + o.x, v: self.v + o.v, a: self.a + o.a }
    }
}

impl Sub for Jet {
    type Output = Jet;
    fn sub(self, o: Jet) -> Jet {
        self + -o
    }
}

impl Neg for Jet {
    type Output = Jet;
    fn neg(self) -> Jet {
        self.times(-1.0)
    }
}

impl Mul for Jet {
    type Output = Jet;
    fn mul(self, o: Jet) -> Jet {
        Jet { x: self.x * o.x, v: self.v * o.x + self.x * o.v, a: self.a * o.x + 2.0 * self.v * o.v + self.x * o.a }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_agree_with_differences() {
        let h = 1e-4;
        let of = |t: f64| {
            let t = Jet::time(t);
            t.times(3.0).sin().times(0.9).asin() * t.smooth_step() + t.powf(1.7)
        };
        for t in [0.2, 0.35, 0.61, 0.9] {
            let (before, at, after) = (of(t - h), of(t), of(t + h));
            assert!((at.v - (after.x - before.x) / (2.0 * h)).abs() < 1e-5 * (1.0 + at.v.abs()), "{t}");
            assert!((at.a - (after.v - before.v) / (2.0 * h)).abs() < 1e-4 * (1.0 + at.a.abs()), "{t}");
        }
    }
}
