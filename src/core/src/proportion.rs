//! Whether the numbers of a damper go together in size.
//!
//! With all forces, stiffnesses, masses and heats s times as large, and lengths, speeds and times as they were, a damper moves as before and its
//! force is s times as large: every equation of the model has a force in each of its terms. So what is promised of dampers of the size of a
//! passenger car's, in whose bounds the promises are searched, holds for those of any other size, as long as all of it is of that size. A set is
//! allowed where there is one s by which every number that grows with the damper lies in the bounds of a car.

use crate::curve::STEEPEST;
use crate::fault::{Fault, Reason};
use crate::parameter::{Params, table};
use crate::{element, list};

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
    let curves = [
        (element!("fv_curve"), list!("fv_velocity"), list!("fv_force")),
        (element!("parallel_spring"), list!("spring_displacement"), list!("spring_force")),
    ];
    for (element, over, forces) in curves {
        if !params.is_on(element) || !params.counts(forces.row()) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number;
    use crate::parameter::Number;

    fn of_size(factor: f64) -> Params {
        let mut params = Params::new();
        for row in table().filter(|row| row.parameter.grows) {
            match Number::try_from(row) {
                Ok(number) => params.set(number, factor * number.default()).unwrap(),
                Err(_) => {
                    let name = row.parameter.name;
                    let list = crate::parameter::List::find(name).unwrap();
                    let mut values = [0.0; 64];
                    let n = params.list(list).len();
                    for (to, from) in values.iter_mut().zip(params.list(list)) {
                        *to = factor * from;
                    }
                    params.set_list(list, &values[..n]).unwrap();
                }
            }
        }
        params
    }

    #[test]
    fn dampers_of_any_size_are_allowed_whole() {
        for factor in [1.01e-3, 0.02, 1.0, 99.0] {
            crate::Model::check(&of_size(factor)).unwrap();
        }
    }

    #[test]
    fn a_number_of_another_size_is_named() {
        let mut params = of_size(0.01);
        params.set(number!("internal_mass"), 1e-3).unwrap();
        check(&params).unwrap();
        params.set(number!("series_stiffness"), 1e7).unwrap();
        let refused = check(&params).unwrap_err();
        assert_eq!(refused, number!("internal_mass").fault(Reason::OutOfProportion));
        let mut params = of_size(1.0);
        params.set(number!("series_stiffness"), 2e8).unwrap();
        params.set(number!("gas_force"), 2e4).unwrap();
        check(&params).unwrap();
        params.set(number!("internal_mass"), 0.05).unwrap();
        assert_eq!(check(&params).unwrap_err().reason, Reason::OutOfProportion);
    }

    #[test]
    fn what_a_car_may_have_goes_together() {
        for low in [true, false] {
            let mut params = Params::new();
            for (i, row) in table().enumerate() {
                if let Ok(number) = Number::try_from(row) {
                    let (least, most) = row.parameter.of_a_car;
                    params.set(number, if low == (i % 2 == 0) { least } else { most }).unwrap();
                }
            }
            check(&params).unwrap();
        }
    }
}
