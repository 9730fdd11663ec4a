//! Conversion of decimal text to a number, correctly rounded, without the locale of the host and without a panic path.
//!
//! `strtod` depends on the locale (a German workstation expects a decimal comma), and `str::parse` contains panic
//! paths. The model file therefore has its own parser. The parser is exact for up to 19 significant digits and ignores
//! further digits.

/// Number of 32-bit limbs that hold every intermediate integer: 19 digits times 2^1300.
const LIMBS: usize = 48;
/// Largest decimal exponent of a number that is written as an integer times a power of ten. Larger exponents and those
/// below minus twice this bound are rejected, because no damper needs them.
const EXPONENT_BOUND: i32 = 300;

/// Reads a decimal number such as `-1.5e3`, `+2`, `1_000.0`; `None` if `text` as a whole is not a number.
pub fn parse(text: &[u8]) -> Option<f64> {
    let (negative, digits) = match text.split_first()? {
        (b'-', rest) => (true, rest),
        (b'+', rest) => (false, rest),
        _ => (false, text),
    };
    let mut mantissa = 0u64;
    let (mut exponent, mut kept) = (0i32, 0);
    let (mut any_digit, mut after_point) = (false, false);
    let mut rest = digits;
    while let Some((c, tail)) = rest.split_first() {
        match c {
            b'0'..=b'9' => {
                any_digit = true;
                if kept < 19 {
                    mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(c - b'0'));
                    kept += i32::from(mantissa != 0);
                    exponent = exponent.wrapping_sub(i32::from(after_point));
                } else {
                    exponent = exponent.wrapping_add(i32::from(!after_point));
                }
            }
            b'.' if !after_point => after_point = true,
            // TOML allows an underscore between digits.
            b'_' if any_digit => {}
            b'e' | b'E' if any_digit => {
                exponent = exponent.wrapping_add(integer(tail)?);
                break;
            }
            _ => return None,
        }
        rest = tail;
    }
    if !any_digit || !(-2 * EXPONENT_BOUND..=EXPONENT_BOUND).contains(&exponent) {
        return None;
    }
    let value = scale(mantissa, exponent);
    Some(if negative { -value } else { value })
}

/// Reads the exponent: a short integer with an optional sign.
fn integer(text: &[u8]) -> Option<i32> {
    let (negative, digits) = match text.split_first()? {
        (b'-', rest) => (true, rest),
        (b'+', rest) => (false, rest),
        _ => (false, text),
    };
    if digits.is_empty() || digits.len() > 4 {
        return None;
    }
    let mut value = 0i32;
    for c in digits {
        if !c.is_ascii_digit() {
            return None;
        }
        value = value.wrapping_mul(10).wrapping_add(i32::from(c - b'0'));
    }
    Some(if negative { -value } else { value })
}

/// Computes mantissa · 10^exponent, rounded to nearest even.
fn scale(mantissa: u64, exponent: i32) -> f64 {
    // Numbers this small, below 1e-301, have no meaning for a damper.
    if mantissa == 0 || exponent < -EXPONENT_BOUND - 20 {
        return 0.0;
    }
    let mut big = [0u32; LIMBS];
    let mut binary = 0i32;
    let mut sticky = false;
    if exponent < 0 {
        // The left shift is large enough for 64 significant bits after the division by the power of ten.
        binary = exponent.wrapping_neg().wrapping_mul(10) / 3 + 70;
        place(&mut big, mantissa, binary as usize);
        let mut left = exponent.wrapping_neg();
        while left > 0 {
            let (divisor, digits) = if left >= 9 { (1_000_000_000, 9) } else { (10, 1) };
            sticky |= divide(&mut big, divisor) != 0;
            left -= digits;
        }
    } else {
        place(&mut big, mantissa, 0);
        for _ in 0..exponent {
            multiply(&mut big, 10);
        }
    }
    let mut top = 0usize;
    for (i, limb) in big.iter().enumerate() {
        if *limb != 0 {
            top = i;
        }
    }
    let limb = |i: usize| u128::from(big.get(i).copied().unwrap_or(0));
    // The three highest 32-bit limbs contain at least 65 significant bits. The lower limbs only decide ties in
    // rounding.
    let high = limb(top) << 64 | limb(top.wrapping_sub(1)) << 32 | limb(top.wrapping_sub(2));
    for (i, limb) in big.iter().enumerate() {
        sticky |= i + 2 < top && *limb != 0;
    }
    let bits = 128 - high.leading_zeros() as i32;
    let drop = bits - 53;
    let (mut value, remainder) = if drop > 0 {
        ((high >> drop) as u64, high & ((1u128 << drop) - 1))
    } else {
        ((high << drop.unsigned_abs()) as u64, 0)
    };
    let half = if drop > 0 { 1u128 << (drop - 1) } else { 1 };
    let above = remainder > half || (remainder == half && (sticky || value & 1 == 1));
    value = value.wrapping_add(u64::from(above && drop > 0));
    // The result value · 2^power is exact: no further rounding occurs.
    let power = drop + 32 * (top as i32 - 2) - binary;
    let two_to = |p: i32| f64::from_bits(((p + 1023).clamp(1, 2046) as u64) << 52);
    let first = power.clamp(-900, 900);
    value as f64 * two_to(first) * two_to(power - first)
}

/// Sets the integer `big` to value · 2^shift.
fn place(big: &mut [u32; LIMBS], value: u64, shift: usize) {
    let (limb, bit) = (shift / 32, shift % 32);
    let wide = u128::from(value) << bit;
    for (i, slot) in big.iter_mut().enumerate() {
        *slot = match i.wrapping_sub(limb) {
            0 => wide as u32,
            1 => (wide >> 32) as u32,
            2 => (wide >> 64) as u32,
            _ => 0,
        };
    }
}

fn multiply(big: &mut [u32; LIMBS], factor: u32) {
    let mut carry = 0u64;
    for limb in big.iter_mut() {
        carry += u64::from(*limb) * u64::from(factor);
        *limb = carry as u32;
        carry >>= 32;
    }
}

/// Divides `big` in place and returns the remainder; the divisor is 10 or 10^9, never 0.
fn divide(big: &mut [u32; LIMBS], divisor: u32) -> u32 {
    let divisor = u64::from(divisor.max(1));
    let mut remainder = 0u64;
    for limb in big.iter_mut().rev() {
        let value = remainder << 32 | u64::from(*limb);
        *limb = (value / divisor) as u32;
        remainder = value % divisor;
    }
    remainder as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;
    use std::string::String;

    fn same(text: &str) {
        let want: f64 = text.parse().unwrap();
        assert_eq!(parse(text.as_bytes()).map(f64::to_bits), Some(want.to_bits()), "{text}");
    }

    #[test]
    fn agrees_with_the_standard_reader_bit_for_bit() {
        for text in [
            "0",
            "-0.0",
            "1",
            "+1.5",
            "-2.5e3",
            "1e22",
            "1e23",
            "9007199254740993",
            "0.1",
            "3.0e6",
            "1e-300",
            "1.7e300",
            "1e0003",
        ] {
            same(text);
        }
        let mut seed = 0x9e37_79b9_7f4a_7c15u64;
        for _ in 0..200_000 {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let value = f64::from_bits(seed);
            if value.is_finite() && value.abs() > 1e-280 && value.abs() < 1e280 {
                same(&format!("{value:e}"));
            }
            // Numbers of ordinary magnitude, then integers above 2^53. Some of these integers lie halfway between two
            // doubles.
            same(&format!("{}", (seed >> 10) as f64 * 1e-6));
            same(&format!("{}", seed >> 9));
        }
    }

    #[test]
    fn refuses_what_is_no_number() {
        for text in
            ["", "-", ".", "e5", "1e", "1e+", "1,5", "nan", "inf", "0x10", "1.2.3", "1e99999", "1e00003", "--1", "1 "]
        {
            assert_eq!(parse(text.as_bytes()), None, "{text}");
        }
        let long: String = "1".repeat(400);
        assert_eq!(parse(long.as_bytes()), None);
    }
}
