//! Numbers that carry their derivatives.
//!
//! The equations of the force path ([`crate::paths`]) are written once for both kinds of numbers. With plain numbers
//! they give values, with [`Dual`] also exact derivatives.

use crate::math::{exp, tanh};
use core::ops::{Add, Mul, Neg, Sub};

/// A number with or without derivatives.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Mul<f64, Output = Self> + Neg<Output = Self>
{
    /// Makes a constant.
    fn constant(value: f64) -> Self;
    /// Returns the value without derivatives.
    fn value(self) -> f64;
    /// Applies a function to the number (chain rule). `value` and `derivative` are those of the function at the number.
    fn chain(self, value: f64, derivative: f64) -> Self;

    /// Adds a constant.
    #[inline(always)]
    fn plus(self, constant: f64) -> Self {
        self + Self::constant(constant)
    }

    /// Computes 1/x.
    #[inline(always)]
    fn inverse(self) -> Self {
        let inverse = 1.0 / self.value();
        self.chain(inverse, -inverse * inverse)
    }

    /// Computes |x|.
    #[inline(always)]
    fn abs(self) -> Self {
        let x = self.value();
        self.chain(x.abs(), if x < 0.0 { -1.0 } else { 1.0 })
    }

    /// Computes √x for x > 0.
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = libm::sqrt(self.value());
        self.chain(root, 0.5 / root)
    }

    /// Computes tanh x.
    #[inline(always)]
    fn tanh(self) -> Self {
        let t = tanh(self.value());
        self.chain(t, 1.0 - t * t)
    }

    /// Computes e^x.
    #[inline(always)]
    fn exp(self) -> Self {
        let e = exp(self.value());
        self.chain(e, e)
    }
}

impl Real for f64 {
    #[inline(always)]
    fn constant(value: f64) -> f64 {
        value
    }

    #[inline(always)]
    fn value(self) -> f64 {
        self
    }

    #[inline(always)]
    fn chain(self, value: f64, _: f64) -> f64 {
        value
    }
}

/// A number with its derivatives with respect to N variables (directions).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<const N: usize> {
    /// The number.
    pub value: f64,
    /// Derivatives of the number, one for each variable.
    pub derivatives: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// Makes a number with these derivatives.
    #[inline(always)]
    pub fn new(value: f64, derivatives: [f64; N]) -> Dual<N> {
        Dual { value, derivatives }
    }

    /// Makes an independent variable: its derivative in direction `direction` is 1, and all others are 0.
    #[inline(always)]
    pub fn along(value: f64, direction: usize) -> Dual<N> {
        let mut derivatives = [0.0; N];
        if let Some(derivative) = derivatives.get_mut(direction) {
            *derivative = 1.0;
        }
        Dual { value, derivatives }
    }

    /// Returns the derivative in a direction, or 0 if the direction is not below N.
    #[inline(always)]
    pub fn derivative(&self, direction: usize) -> f64 {
        self.derivatives.get(direction).copied().unwrap_or(0.0)
    }

    #[inline(always)]
    fn merge(self, other: Dual<N>, value: f64, f: impl Fn(f64, f64) -> f64) -> Dual<N> {
        let mut derivatives = self.derivatives;
        for (a, b) in derivatives.iter_mut().zip(other.derivatives) {
            *a = f(*a, b);
        }
        Dual { value, derivatives }
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Dual<N>;
    #[inline(always)]
    fn add(self, other: Dual<N>) -> Dual<N> {
        self.merge(other, self.value + other.value, |a, b| a + b)
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Dual<N>;
    #[inline(always)]
    fn sub(self, other: Dual<N>) -> Dual<N> {
        self.merge(other, self.value - other.value, |a, b| a - b)
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Dual<N>;
    // The product rule contains a sum, which the lint reports as suspicious in a multiplication.
    #[allow(clippy::suspicious_arithmetic_impl)]
    #[inline(always)]
    fn mul(self, other: Dual<N>) -> Dual<N> {
        self.merge(other, self.value * other.value, |a, b| a * other.value + b * self.value)
    }
}

impl<const N: usize> Mul<f64> for Dual<N> {
    type Output = Dual<N>;
    #[inline(always)]
    fn mul(self, factor: f64) -> Dual<N> {
        self.chain(self.value * factor, factor)
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Dual<N>;
    #[inline(always)]
    fn neg(self) -> Dual<N> {
        self.chain(-self.value, -1.0)
    }
}

impl<const N: usize> Real for Dual<N> {
    #[inline(always)]
    fn constant(value: f64) -> Dual<N> {
        Dual { value, derivatives: [0.0; N] }
    }

    #[inline(always)]
    fn value(self) -> f64 {
        self.value
    }

    #[inline(always)]
    fn chain(self, value: f64, derivative: f64) -> Dual<N> {
        let mut derivatives = self.derivatives;
        for s in &mut derivatives {
            *s *= derivative;
        }
        Dual { value, derivatives }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tried<R: Real>(x: R, y: R) -> R {
        ((x * y - y.tanh()).exp() + (x.abs().plus(1.0)).sqrt() * 3.0 - (-x).plus(4.0).inverse()) * y
    }

    #[test]
    fn derivatives_are_derivatives() {
        for (x, y) in [(0.3, 0.7), (-1.1, 0.4), (2.0, -0.6)] {
            let both = tried(Dual::<2>::along(x, 0), Dual::along(y, 1));
            let h = 1e-6;
            assert_eq!(both.value, tried(x, y));
            assert!((both.derivatives[0] - (tried(x + h, y) - tried(x - h, y)) / (2.0 * h)).abs() < 1e-8);
            assert!((both.derivatives[1] - (tried(x, y + h) - tried(x, y - h)) / (2.0 * h)).abs() < 1e-8);
        }
    }
}
