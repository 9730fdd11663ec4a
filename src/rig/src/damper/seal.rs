//! Friction of rod seal and guide: elastic bristles that slip (Canudas de Wit et al., IEEE Trans. Autom. Control 40,
//! 1995).
//!
//! The micro-damping term of the paper (bristle damping σ₁) is omitted, because with a constant coefficient it would
//! generate energy at high velocity.

/// Friction parameters of the rod seal and the rod guide.
#[derive(Debug, Clone, PartialEq)]
pub struct Seal {
    /// Sliding (Coulomb) friction without side force, N.
    pub sliding_n: f64,
    /// Break-away friction without side force, N.
    pub break_away_n: f64,
    /// Velocity scale of the decrease from break-away to sliding friction (Stribeck), m/s.
    pub stribeck_m_s: f64,
    /// Stiffness of the bristles, N/m.
    pub bristle_n_m: f64,
    /// Ratio of the additional friction to the magnitude of the side force on the rod.
    pub side_force_ratio: f64,
}

impl Default for Seal {
    fn default() -> Self {
        Self { sliding_n: 38.0, break_away_n: 44.0, stribeck_m_s: 0.008, bristle_n_m: 5.0e5, side_force_ratio: 0.05 }
    }
}

impl Seal {
    /// Computes the magnitude of friction in steady sliding at a velocity, m/s, under a side force, N.
    fn level_n(&self, velocity_m_s: f64, side_force_n: f64) -> f64 {
        let excess = (self.break_away_n - self.sliding_n) * libm::exp(-(velocity_m_s / self.stribeck_m_s).powi(2));
        self.sliding_n + excess + self.side_force_ratio * side_force_n.abs()
    }

    /// Computes the friction in steady sliding, N, with the sign of the velocity.
    pub fn sliding_force_n(&self, velocity_m_s: f64, side_force_n: f64) -> f64 {
        if velocity_m_s == 0.0 {
            return 0.0;
        }
        self.level_n(velocity_m_s, side_force_n).copysign(velocity_m_s)
    }

    /// Computes the friction force, N, from the bristles' deflection, m.
    pub fn force_n(&self, deflection_m: f64) -> f64 {
        self.bristle_n_m * deflection_m
    }

    /// Computes the rate of the bristles' deflection, m/s, at a deflection, m, a sliding velocity, m/s, and a side
    /// force, N.
    pub fn deflection_rate(&self, deflection_m: f64, velocity_m_s: f64, side_force_n: f64) -> f64 {
        let slip = self.force_n(deflection_m) / self.level_n(velocity_m_s, side_force_n);
        velocity_m_s - velocity_m_s.abs() * slip
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bristles_settle_at_the_sliding_level_and_side_force_raises_it() {
        let seal = Seal::default();
        for (velocity, side) in [(1e-4, 0.0), (-0.5, 0.0), (0.2, 300.0)] {
            let force = seal.sliding_force_n(velocity, side);
            assert_eq!(force.signum(), velocity.signum());
            let rate = seal.deflection_rate(force / seal.bristle_n_m, velocity, side);
            assert!(rate.abs() < 1e-12 * velocity.abs() + 1e-18);
        }
        let slope = (seal.sliding_force_n(0.2, 300.0) - seal.sliding_force_n(0.2, 0.0)) / 300.0;
        assert!((slope - seal.side_force_ratio).abs() < 1e-12);
    }

    #[test]
    fn never_gives_energy() {
        let seal = Seal::default();
        // The dissipated power (input power minus rate of stored energy) must be at least zero for all deflections
        // within the friction force.
        for i in -50..=50 {
            let deflection = 1e-6 * f64::from(i);
            for velocity in [-1.0, -1e-3, 1e-3, 1.0] {
                let stored = seal.force_n(deflection) * seal.deflection_rate(deflection, velocity, 0.0);
                assert!(seal.force_n(deflection) * velocity - stored >= -1e-12);
            }
        }
    }
}
