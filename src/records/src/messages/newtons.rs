//! Formats forces in messages.

use dashpot_messages::format_decimals;

/// Largest number of decimals: a tenth of a millinewton, finer than the resolution of any load cell for dampers.
const MOST: usize = 4;

/// Returns whether a force is zero when rounded to [`MOST`] decimals.
fn is_nothing(force: f64) -> bool {
    force.abs() < 0.5 * 10f64.powi(-(MOST as i32))
}

/// Returns the number of decimals, from `decimals` to four, with which a force, N, has two significant digits.
///
/// Half a newton is negligible for a car damper, but may be the whole force of a small damper.
pub fn places(force: f64, decimals: usize) -> usize {
    // The criterion applies after rounding: 9.95 becomes 10.
    let needed = (decimals..=MOST).find(|&places| force.abs() * 10f64.powi(places as i32) >= 9.95);
    if is_nothing(force) { decimals } else { needed.unwrap_or(MOST) }
}

/// Formats a force, N, with at least `decimals` decimals, and with more if two significant digits require them.
pub fn newtons(force: f64, decimals: usize) -> String {
    let places = places(force, decimals);
    format_decimals(if is_nothing(force) { 0.0 } else { force }, places)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_digits_are_left_of_a_small_force() {
        let tenths = [0.0, -1e-9, 0.04, -0.35, 0.997, 4.43, 688.42].map(|force| newtons(force, 1));
        assert_eq!(tenths, ["0.0", "0.0", "0.040", "-0.35", "1.0", "4.4", "688.4"]);
        assert_eq!([0.0, 0.59, 3.04, 118.2].map(|force| newtons(force, 0)), ["0", "0.59", "3.0", "118"]);
        assert_eq!([1.234e-4, 4.9e-5, f64::NAN].map(|force| newtons(force, 1)), ["0.0001", "0.0", "NaN"]);
    }
}
