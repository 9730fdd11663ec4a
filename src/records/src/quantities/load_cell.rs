//! The load cell that a rig has for a damper.

use crate::numbers::restrict;

/// Zero offset to be expected of a load cell, N, with a damper of a car.
///
/// A tenth of a percent of a cell of 15 kN. A smaller force at rest tells nothing of gas, and a test that lies so far
/// off the others is no other.
const OFFSET: f64 = 15.0;
/// Largest force, N, of the dampers of cars: between these nothing depends on it, so that a soft and a firm damper are judged alike. From the
/// virtual rigs and the measured dampers of the book, 0.4 to 6 kN; a narrower range would change what is said of cars. Weaker dampers are
/// measured with a smaller cell, stronger ones with a larger one.
pub const OF_CARS: (f64, f64) = (300.0, 8000.0);

/// Zero offset, N, to be expected of the load cell that a damper with this largest force is measured with.
pub(crate) fn offset(largest: f64) -> f64 {
    let (low, high) = OF_CARS;
    if largest > 0.0 && largest.is_finite() { OFFSET * largest / restrict(largest, low, high) } else { OFFSET }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_chosen_for_its_damper() {
        assert_eq!([300.0, 1500.0, 8000.0, 0.0].map(offset), [15.0; 4]);
        assert!((offset(3.0) - 0.15).abs() < 1e-12 && (offset(80_000.0) - 150.0).abs() < 1e-9);
    }
}
