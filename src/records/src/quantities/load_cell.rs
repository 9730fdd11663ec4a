//! Expected zero offset of a load cell for dampers.

use crate::numbers::restrict;
pub use crate::tuning::load_cell::OF_CARS;
use crate::tuning::load_cell::OFFSET;

/// Returns the expected zero offset of the load cell, N, for the largest force of the damper, N.
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
