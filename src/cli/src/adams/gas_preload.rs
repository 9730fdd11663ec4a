//! The XML form of a damper's properties, which holds the gas preload that the `.dpr` form has no place for.

use super::dpr::Curve;
use std::fmt::Write as _;

/// FV table and constant gas preload (N, positive where it pushes the rod out) as a property file in mm, s and N.
pub fn write(curve: &Curve, gas_force: f64) -> String {
    let mut rows = String::new();
    for (v, f) in curve.velocities.iter().zip(&curve.forces) {
        let _ = writeln!(rows, "{:?} {f:?}", 1e3 * v);
    }
    include_str!("templates/damper.xml")
        .replace("{rows}", rows.trim_end())
        .replace("{gas_force}", &format!("{gas_force:?}"))
}
