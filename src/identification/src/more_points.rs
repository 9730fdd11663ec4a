//! The FV curve through more points, for a fit to move.

use dashpot_core::Params;
use dashpot_core::curve::{Curve, Interpolation, MAX_POINTS};
use dashpot_core::list;

/// The same parameters with points at these velocities too, on the curve as it runs there; `None` where there are none, or too many.
pub(super) fn with_points(from: &Params, more: impl IntoIterator<Item = f64>) -> Option<Params> {
    let (v, f) = (from.list(list!("fv_velocity")), from.list(list!("fv_force")));
    let curve = Curve::new(v, f, Interpolation::MonotoneCubic).ok()?;
    let mut points: Vec<f64> = v.iter().copied().chain(more).collect();
    if points.len() == v.len() || points.len() > MAX_POINTS {
        return None;
    }
    points.sort_by(f64::total_cmp);
    let forces: Vec<f64> = points.iter().map(|v| curve.at(*v).value).collect();
    let mut params = *from;
    params.set_list(list!("fv_velocity"), &points).ok()?;
    params.set_list(list!("fv_force"), &forces).ok()?;
    Some(params)
}
