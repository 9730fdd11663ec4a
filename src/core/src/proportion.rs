//! Whether the numbers of a damper go together in size.
//!
//! With all forces, stiffnesses, masses and heats s times as large, and lengths, speeds and times as they were, a damper moves as before and its
//! force is s times as large: every equation of the model has a force in each of its terms. So what is promised of dampers of the size of a
//! passenger car's, in whose bounds the promises are searched, holds for those of any other size, as long as all of it is of that size. A set is
//! allowed where there is one s by which every number that grows with the damper lies in the bounds of a car.

use crate::curve::STEEPEST;
use crate::fault::{Fault, Reason};
use crate::list;
use crate::parameter::{Params, table};

/// # Errors
/// The number that is too large or too small beside another one.
#[inline(never)]
pub fn check(params: &Params) -> Result<(), Fault> {
    // The smallest damper whose numbers may be as large as these, the largest whose may be as small, and the rows that say so.
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
    // Rounding must not refuse what lies on a bound.
    if least <= most * (1.0 + 1e-9) {
        return Ok(());
    }
    // The one that no car's damper has is at fault; with both, either is.
    let at_fault = if least > 1.0 { too_large } else { too_small };
    at_fault.map_or(Ok(()), |row| Err(row.fault(Reason::OutOfProportion)))
}
