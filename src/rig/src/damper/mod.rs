//! The physical damper on the rig: a monotube with a floating piston.
//!
//! ```text
//!        load cell == mount == rod =[ seal friction ]
//!                               |
//!                   rebound chamber   p_r, area bore - rod
//!                   ---- piston ----  bleed, rebound and compression blow-off
//!                   compression chamber p_c, area bore
//!                   ~~ floating piston ~~
//!                   gas               p_c
//!        actuator == tube
//! ```
//!
//! Extension (rebound) and tension at the load cell are positive.

mod draw;
mod gas;
mod motion;
mod mount;
mod oil;
mod seal;
mod tube;
mod valve;

pub use gas::GasChamber;
pub use mount::Mount;
pub use oil::Oil;
pub use seal::Seal;
pub use tube::Tube;
pub use valve::{Bleed, BlowOff, PistonValves};

pub(crate) use motion::{Excitation, State};

/// Pressure of the surrounding air, Pa.
pub const ATMOSPHERE_PA: f64 = 101_325.0;

/// A monotube damper, by its physical parameters.
///
/// The default damper has a force of about 3500 N in rebound and 1800 N in compression at 1.57 m/s.
#[derive(Debug, Clone, PartialEq)]
pub struct Damper {
    /// Dimensions of bore, rod and oil chambers.
    pub tube: Tube,
    /// The oil with its entrained air.
    pub oil: Oil,
    /// The gas behind the floating piston.
    pub gas: GasChamber,
    /// Flow resistance of the piston.
    pub valves: PistonValves,
    /// Friction of the rod seal and guide.
    pub seal: Seal,
    /// Elastic mount between rod and load cell; `None` means rigid.
    pub mount: Option<Mount>,
}

impl Default for Damper {
    fn default() -> Self {
        Self {
            tube: Tube::default(),
            oil: Oil::default(),
            gas: GasChamber::default(),
            valves: PistonValves::default(),
            seal: Seal::default(),
            mount: Some(Mount::default()),
        }
    }
}

impl Damper {
    /// Draws a variant of the default damper, similar to the variation between products.
    ///
    /// The result depends only on the seed. Seed 0 gives the default damper.
    pub fn seeded(seed: u64) -> Self {
        draw::damper(seed)
    }

    /// Returns the force on the rod, N, in steady oil flow at mid-stroke: gas, valves and sliding seal, without
    /// compressibility. In long, slow strokes, the force of the simulated damper approaches this value.
    pub fn steady_force_n(&self, velocity_m_s: f64) -> f64 {
        let area = self.tube.annulus_m2();
        let drop = self.valves.pressure_drop_pa(area * velocity_m_s, self.oil.density_kg_m3);
        let gas = (self.gas.pressure_pa - ATMOSPHERE_PA) * self.tube.rod_area_m2();
        drop * area - gas + self.seal.sliding_force_n(velocity_m_s, 0.0)
    }
}
