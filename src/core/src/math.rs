//! Elementary functions whose results have the same digits on every platform. `exp`, `tanh` and `ln` have a fixed cost,
//! because they contain no branch.
//!
//! The relative error of `exp` is a few units in the last place, and grows with |x|: see [`exp_below_bound`]. `tanh`
//! has a small absolute error, about 1e-15. A small relative error is not needed, because `tanh` multiplies a friction
//! level.

/// Largest argument magnitude of [`exp`]. Beyond it, `exp` returns its value at the bound, so that no result is
/// infinite or subnormal.
const EXP_BOUND: f64 = 700.0;

/// 2^(j/32) for j = 0..32, correctly rounded.
#[allow(clippy::approx_constant)]
const ROOTS: [f64; 32] = [
    1.0,
    1.0218971486541166,
    1.0442737824274138,
    1.0671404006768237,
    1.0905077326652577,
    1.1143867425958924,
    1.1387886347566916,
    1.1637248587775775,
    1.189207115002721,
    1.215247359980469,
    1.241857812073484,
    1.2690509571917332,
    1.2968395546510096,
    1.3252366431597413,
    1.3542555469368927,
    1.383909881963832,
    1.4142135623730951,
    1.4451808069770467,
    1.4768261459394993,
    1.5091644275934228,
    1.5422108254079407,
    1.5759808451078865,
    1.6104903319492543,
    1.645755478153965,
    1.681792830507429,
    1.718619298122478,
    1.7562521603732995,
    1.7947090750031072,
    1.8340080864093424,
    1.8741676341103,
    1.9152065613971474,
    1.9571441241754002,
];

/// Computes e^x; the argument is clamped to ±700.
#[inline(always)]
pub fn exp(x: f64) -> f64 {
    let x = min(EXP_BOUND, x);
    exp_below_bound(x)
}

/// Computes e^x for x ≤ 700: x log2(e) = n + (j + f)/32, e^x = 2^n 2^(j/32) 2^(f/32) with |f| ≤ 1/2.
///
/// Because of rounding in the product x log2(e), the relative error grows as 1e-16 |x|. This is harmless for negative
/// x, because the absolute error from this rounding stays below 1e-16.
#[inline(always)]
pub fn exp_below_bound(x: f64) -> f64 {
    const PER_LN2: f64 = 32.0 * core::f64::consts::LOG2_E;
    const LN2: f64 = core::f64::consts::LN_2 / 32.0;
    // Taylor series of 2^(f/32) − 1; the next term is below 3e-15.
    const C2: f64 = LN2 * LN2 / 2.0;
    const C3: f64 = C2 * LN2 / 3.0;
    const C4: f64 = C3 * LN2 / 4.0;
    const C5: f64 = C4 * LN2 / 5.0;
    // Adding 1.5·2^52 rounds the product to an integer, which is then in the low mantissa bits.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    let x = max(-EXP_BOUND, x);
    let scaled = x * PER_LN2;
    let shifted = scaled + ROUND;
    let f = scaled - (shifted - ROUND);
    let bits = shifted.to_bits();
    // The product with 2^n adds n to the binary exponent of 2^(j/32).
    let j = bits & 31;
    let scale = f64::from_bits(ROOTS[j as usize].to_bits().wrapping_add(bits.wrapping_sub(j) << 47));
    scale + scale * (f * (LN2 + f * (C2 + f * (C3 + f * (C4 + f * C5)))))
}

/// Computes tanh(x) with an absolute error of about 1e-15.
#[inline(always)]
pub fn tanh(x: f64) -> f64 {
    let t = exp_below_bound(-2.0 * x.abs());
    ((1.0 - t) / (1.0 + t)).copysign(x)
}

/// Returns the larger of two numbers in one instruction; `f64::max` needs more instructions, because it handles NaN.
#[inline(always)]
pub fn max(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Returns the smaller of two numbers in one instruction, without handling NaN.
#[inline(always)]
pub fn min(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// Returns `[f(0), f(1)]`; always inlined, unlike `[0, 1].map(f)`.
#[inline(always)]
pub fn pair(f: impl Fn(usize) -> f64) -> [f64; 2] {
    [f(0), f(1)]
}

/// Computes the moments of exponential relaxation toward a polynomial target.
///
/// The moments are e^-r and ∫ r e^{-r (1-s)} s^k ds over s from 0 to 1, k = 0 to 3, for r ≥ 0. A state relaxes toward Σ
/// p_k s^k with the rate r per step. Its end value is e^-r times its start value, plus the sum of p_k times the k-th
/// integral.
#[inline(always)]
pub fn relaxation(r: f64) -> (f64, [f64; 4]) {
    // Largest r for which the series is used. Up to this r, the recurrence of the other branch loses more digits than
    // the truncation of the series.
    const SMALL: f64 = 0.5;
    if r > SMALL {
        let kept = exp_below_bound(-r);
        let first = 1.0 - kept;
        let second = 1.0 - first / r;
        let third = 1.0 - 2.0 * second / r;
        return (kept, [first, second, third, 1.0 - 3.0 * third / r]);
    }
    // The fourth moment is r/4 (1 − r/5 (1 − r/6 (1 − …))), here with twelve factors; the truncation error is below
    // 0.5^13 · 3!/16!.
    const PER: [f64; 12] = {
        let mut per = [0.0; 12];
        let mut i = 0;
        while i < 12 {
            per[i] = 1.0 / (16.0 - i as f64);
            i += 1;
        }
        per
    };
    // Largest r for which the last five factors suffice. Their relative truncation error, r^6 · 4!/10!, is far below
    // rounding (also up to r = 4e-3). Gas with a thermal time of a second is in this range at steps of a millisecond.
    const FEW: f64 = 1e-3;
    let (late, early) = PER.split_at(7);
    let mut sum = 1.0;
    if r > FEW {
        for per in late {
            sum = 1.0 - r * per * sum;
        }
    }
    for per in early {
        sum = 1.0 - r * per * sum;
    }
    let fourth = 0.25 * r * sum;
    // From the fourth moment down to the first, the recurrence loses no digits.
    let third = r * (1.0 - fourth) * (1.0 / 3.0);
    let second = r * (1.0 - third) * 0.5;
    let first = r * (1.0 - second);
    (1.0 - first, [first, second, third, fourth])
}

/// Computes ln x for normal x > 0. The absolute error is about 1e-16, plus the rounding error of n ln 2.
///
/// x = 2^n m, √½ ≤ m < √2, ln m = 2 artanh s with s = (m − 1)/(m + 1).
#[inline(always)]
pub fn ln(x: f64) -> f64 {
    const MANTISSA: u64 = (1 << 52) - 1;
    const ROOT_HALF: u64 = core::f64::consts::FRAC_1_SQRT_2.to_bits();
    let up = x.to_bits().wrapping_sub(ROOT_HALF);
    let n = (up as i64 >> 52) as f64;
    let m = f64::from_bits((up & MANTISSA).wrapping_add(ROOT_HALF));
    let s = (m - 1.0) / (m + 1.0);
    let q = s * s;
    // Coefficients 1/3, 1/5, ... of the series of artanh: |s| < 0.172, so the next term is below 2e-17.
    let low = 1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q * (1.0 / 9.0)));
    let high = 1.0 / 11.0 + q * (1.0 / 13.0 + q * (1.0 / 15.0 + q * (1.0 / 17.0 + q * (1.0 / 19.0))));
    let square = q * q;
    let double = 2.0 * s;
    n * core::f64::consts::LN_2 + (double + double * (q * (low + square * square * high)))
}

/// Computes r^p for r ≥ 0. For r = 0 or subnormal r the result is 0, or 1 if p = 0.
#[inline(never)]
pub fn power(r: f64, p: f64) -> f64 {
    power_inlined(r, p)
}

/// Computes r^p as [`power`] does, always inlined.
#[inline(always)]
pub fn power_inlined(r: f64, p: f64) -> f64 {
    if r < f64::MIN_POSITIVE {
        return if p == 0.0 { 1.0 } else { 0.0 };
    }
    exp(p * ln(r))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exp_agrees_with_the_platform() {
        for i in -7000..=7000 {
            let x = i as f64 * 0.0997;
            let want = x.exp();
            assert!((exp(x) - want).abs() <= (16.0 + x.abs()) * f64::EPSILON * want, "exp({x})");
        }
        assert_eq!(exp(0.0), 1.0);
        assert_eq!(exp(-1e9), exp(-700.0));
    }

    #[test]
    fn logarithm_and_power_agree_with_the_platform() {
        for i in -3000..=3000 {
            let x = (i as f64 * 0.0101).exp();
            assert!((ln(x) - x.ln()).abs() <= 2.0 * f64::EPSILON * x.ln().abs().max(1.0), "ln({x})");
            for p in [-1.4, 0.4, 0.5, 3.0] {
                let want = x.powf(p);
                let off = (16.0 + 2.0 * (p * x.ln()).abs()) * f64::EPSILON;
                assert!((power(x, p) - want).abs() <= off * want, "{x}^{p}");
            }
        }
        assert_eq!((ln(1.0), power(0.0, 0.5), power(0.0, 0.0)), (0.0, 0.0, 1.0));
    }

    #[test]
    fn the_last_moment_is_its_series_to_rounding() {
        for r in [1e-6, 1e-4, 0.9e-3, 1e-3, 1.1e-3, 3e-3, 0.01, 0.1, 0.3, 0.5] {
            // Σ (−1)^k r^(k+1) 3!/(k+4)!
            let (mut term, mut sum) = (r / 4.0, 0.0);
            for k in 0..20 {
                sum += term;
                term *= -r / f64::from(k + 5);
            }
            assert!((relaxation(r).1[3] - sum).abs() <= 4.0 * f64::EPSILON * sum, "{r}");
        }
    }

    #[test]
    fn what_a_drawn_state_takes_adds_up() {
        for r in [0.0, 1e-12, 1e-3, 0.1, 0.499, 0.501, 1.0, 5.0, 700.0, 1e9] {
            let (kept, [first, second, third, fourth]) = relaxation(r);
            assert!((kept + first - 1.0).abs() < 1e-14, "{r}");
            // The moments are compared with their integrals by Simpson's rule over many parts.
            for (k, moment) in [(1, second), (2, third), (3, fourth)] {
                if r < 20.0 {
                    let n = 2000;
                    let f = |i: i32| {
                        let s = f64::from(i) / f64::from(n);
                        r * (-r * (1.0 - s)).exp() * s.powi(k)
                    };
                    let sum: f64 =
                        (0..n).step_by(2).map(|i| f(i) + 4.0 * f(i + 1) + f(i + 2)).sum::<f64>() / f64::from(3 * n);
                    assert!((sum - moment).abs() < 1e-11 * (1.0 + r * r * r), "{r} {k}: {sum} {moment}");
                }
            }
        }
    }

    #[test]
    fn tanh_agrees_with_the_platform_and_is_odd() {
        for i in -40_000..=40_000 {
            let x = i as f64 * 0.001_3;
            assert!((tanh(x) - x.tanh()).abs() <= 16.0 * f64::EPSILON, "tanh({x})");
            assert_eq!(tanh(x), -tanh(-x));
        }
        assert_eq!(tanh(1e300), 1.0);
    }
}
