//! Flow through passages and laminar leaks.
//!
//! The flow through a passage of area a is Q = C_d a √(2 Δp / ρ). C_d is the discharge coefficient, Δp the pressure
//! difference and ρ the density of the oil.

/// Computes the area, m², of a sharp-edged passage from its flow, m³/s, at a pressure difference, Pa. `coefficient` is
/// the discharge coefficient, and `density` is in kg/m³.
pub fn passage_area(flow: f64, difference: f64, coefficient: f64, density: f64) -> f64 {
    flow / (coefficient * libm::sqrt(2.0 * difference / density))
}

/// Computes the coefficient b, N s²/m², of a passage's force b w² at the piston speed w. `passage` and `area`, m², are
/// the areas of passage and piston, `coefficient` is the discharge coefficient, and `density` is in kg/m³.
pub fn quadratic_force(passage: f64, area: f64, coefficient: f64, density: f64) -> f64 {
    density * area * area * area / (2.0 * coefficient * coefficient * passage * passage)
}

/// Computes the area of a passage, m², from the coefficient b, N s²/m², of [`quadratic_force`] and the area of the
/// piston, m². `coefficient` is the discharge coefficient, and `density` is in kg/m³.
pub fn passage_of_quadratic(b: f64, area: f64, coefficient: f64, density: f64) -> f64 {
    libm::sqrt(density * area * area * area / (2.0 * b)) / coefficient
}

/// Computes the flow per pressure, m³/(s Pa), of a laminar leak with the force `a` w at the piston speed w. `a` is in N
/// s/m, and the piston area `area` in m².
pub fn leak_of_linear(a: f64, area: f64) -> f64 {
    area * area / a
}

/// Computes the speed w, m/s, at which `a` w + `b` w² equals a force, N. `a` is in N s/m and `b` in N s²/m².
pub fn bleed_speed(force: f64, a: f64, b: f64) -> f64 {
    2.0 * force / (a + libm::sqrt(a * a + 4.0 * b * force))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passages_come_back_and_agree() {
        let (area, cd, rho) = (1.1e-3, 0.7, 850.0);
        let b = quadratic_force(4e-6, area, cd, rho);
        assert!((passage_of_quadratic(b, area, cd, rho) / 4e-6 - 1.0).abs() < 1e-12);
        let w = bleed_speed(500.0, 0.0, b);
        assert!((passage_area(area * w, 500.0 / area, cd, rho) / 4e-6 - 1.0).abs() < 1e-9);
        assert!((bleed_speed(300.0, 1000.0, 0.0) - 0.3).abs() < 1e-12);
    }
}
