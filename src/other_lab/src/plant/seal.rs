//! Friction of rod seal and guides: the LuGre model with a Stribeck curve (Canudas de Wit et al., IEEE Trans. Autom. Control 40, 1995).

use crate::draw::Draw;

/// Friction `F = σ_0 z + σ_1 dz/dt` of bristles with the deflection z, m, at the sliding velocity v, m/s.
///
/// `dz/dt = v − |v| z/g(v)`, `g = (F_c + (F_b − F_c) exp(−(v/v_s)²))/σ_0`. F_c is the sliding (Coulomb) friction, N, F_b the break-away
/// friction, N, and v_s the Stribeck velocity, m/s.
#[derive(Debug, Clone)]
pub struct Seal {
    /// Stiffness σ_0 of the bristles, N/m.
    pub stiffness: f64,
    /// Damping σ_1 of the bristles at standstill, N s/m. It decays with velocity over v_s, so that the bristles never drive the rod.
    pub damping: f64,
    /// Sliding (Coulomb) friction F_c, N.
    pub sliding: f64,
    /// Break-away friction F_b, N.
    pub breakaway: f64,
    /// Stribeck velocity v_s, m/s.
    pub stribeck: f64,
}

impl Seal {
    /// Draws a seal within a range of sliding friction, N.
    pub fn new(d: &mut Draw, sliding: (f64, f64)) -> Seal {
        let sliding = d.scale(sliding.0, sliding.1);
        let stiffness = sliding / d.scale(4e-5, 2.5e-4);
        Seal {
            stiffness,
            damping: stiffness * d.between(2e-4, 1e-3),
            sliding,
            breakaway: sliding * d.between(1.05, 1.35),
            stribeck: d.scale(8e-3, 3e-2),
        }
    }

    /// Computes the deflection, m, at which the bristles slide under the sliding friction.
    pub fn length(&self) -> f64 {
        self.sliding / self.stiffness
    }

    /// Computes the rate dz/dt of the bristles' deflection, m/s, at the velocity `v`, m/s, and the deflection `z`, m.
    pub fn rate(&self, v: f64, z: f64) -> f64 {
        let level = self.sliding + (self.breakaway - self.sliding) * libm::exp(-(v / self.stribeck).powi(2));
        v - v.abs() * z * self.stiffness / level
    }

    /// Computes the friction force, N, at the velocity `v`, m/s, and the bristles' deflection `z`, m.
    pub fn force(&self, v: f64, z: f64) -> f64 {
        let fades = libm::exp(-(v / self.stribeck).powi(2));
        self.stiffness * z + self.damping * fades * self.rate(v, z)
    }
}
