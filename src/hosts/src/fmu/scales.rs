//! Scales between the motion and force of host and damper.

use anyhow::bail;

/// Scales between the motion and force of host and damper.
#[derive(Clone, Copy)]
pub struct Scales {
    /// Damper extension, m, per unit of the host's displacement.
    pub motion: f64,
    /// Force in the host's unit per N of tension.
    pub force: f64,
    /// Extension of the damper, m, at zero displacement of the host, relative to the zero of the rig.
    pub position_offset: f64,
    /// Start value of the displacement in the host's unit. It applies if the host sets no displacement before the start.
    pub start: f64,
}

impl Scales {
    /// Checks the user's scales. The default of an omitted scale is 1 for one damper: extension and tension are positive in the host. It is
    /// −1 for a vehicle: compression and push are positive.
    ///
    /// # Errors
    /// A scale is 0 or not finite, or the offset is larger than 1 m.
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
