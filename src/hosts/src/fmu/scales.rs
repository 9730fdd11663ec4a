//! How host and damper count motion and force.

use anyhow::bail;

/// How host and damper count motion and force.
#[derive(Clone, Copy)]
pub struct Scales {
    /// Damper extension per unit of the host's displacement.
    pub motion: f64,
    /// The host's force per N of tension.
    pub force: f64,
    /// The damper's extension, from the rig's zero, where the host's displacement is 0, m.
    pub position_offset: f64,
    /// The host's displacement where it sets none before it begins.
    pub start: f64,
}

impl Scales {
    /// Scales as the user gives them. Where he does not, one damper counts extension and tension, a vehicle compression.
    ///
    /// # Errors
    /// A scale that is 0 or no number, an offset that no damper has.
    pub fn checked(
        corners: usize,
        motion: Option<f64>,
        force: Option<f64>,
        position_offset: f64,
    ) -> anyhow::Result<Scales> {
        let usual = if corners == 1 { 1.0 } else { -1.0 };
        let scales =
            Scales { motion: motion.unwrap_or(usual), force: force.unwrap_or(usual), position_offset, start: 0.0 };
        if !(scales.position_offset.abs() <= 1.0) {
            bail!("--position-offset is in m and lies between -1 and 1, not {}", scales.position_offset);
        }
        for (name, scale) in [("--motion-scale", scales.motion), ("--force-scale", scales.force)] {
            if !scale.is_finite() || scale == 0.0 {
                bail!("{name} must be finite and not 0");
            }
        }
        Ok(scales)
    }
}
