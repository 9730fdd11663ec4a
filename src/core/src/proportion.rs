//! Check whether the numbers of a damper are in proportion to each other.
//!
//! Multiply all forces, stiffnesses, masses and heats by a factor s, with lengths, speeds and times unchanged. The
//! damper then moves as before with s times the force, because each term of every equation is proportional to one
//! force. The tests show stability and passivity of the steps for all values within the bounds of passenger car
//! dampers. Both therefore hold for dampers of any size whose numbers are in proportion. A parameter set is allowed if
//! one factor s scales every size-dependent number into the bounds of a car damper.

use crate::curve::STEEPEST;
use crate::fault::{Fault, Reason};
use crate::list;
use crate::parameter::{Params, table};

/// Checks whether the numbers of a parameter set are in proportion to each other.
///
/// # Errors
/// Returns the number that is too large or too small compared with another.
#[inline(never)]
pub fn check(params: &Params) -> Result<(), Fault> {
    // `least` is the smallest size at which no number is too large, `most` the largest at which none is too small. A
    // size is the ratio to a car damper. `too_large` and `too_small` are the rows that determine `least` and `most`.
    let (mut least, mut most) = (0.0f64, f64::INFINITY);
    let (mut too_large, mut too_small) = (None, None);
    for row in table().filter(|row| row.parameter.grows && params.counts(row)) {
        let (low, high) = row.parameter.of_a_car;
        for value in params.get(&row) {
            if value.abs() > least * high {
                (least, too_large) = (value.abs() / high, Some(row));
            }
            if low > 0.0 && *value < most * low {
                (most, too_small) = (value / low, Some(row));
            }
        }
    }
    let curves = [(list!("fv_velocity"), list!("fv_force")), (list!("spring_displacement"), list!("spring_force"))];
    for (over, forces) in curves {
        if !params.counts(forces.row()) {
            continue;
        }
        let (u, f) = (params.list(over), params.list(forces));
        for ((u0, f0), (u1, f1)) in u.iter().zip(f).zip(u.iter().skip(1).zip(f.iter().skip(1))) {
            if f1 - f0 > least * STEEPEST * (u1 - u0) {
                (least, too_large) = ((f1 - f0) / (STEEPEST * (u1 - u0)), Some(*forces.row()));
            }
        }
    }
    // The tolerance is for numbers exactly on a bound, which rounding must not reject.
    if least <= most * (1.0 + 1e-9) {
        return Ok(());
    }
    // Of the two numbers, the one outside the bounds of a car damper is at fault. If both are outside, the function
    // reports the large number.
    let at_fault = if least > 1.0 { too_large } else { too_small };
    at_fault.map_or(Ok(()), |row| Err(row.fault(Reason::OutOfProportion)))
}
