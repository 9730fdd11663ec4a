//! Scales between the motion and force of host and damper.

use anyhow::bail;
use dashpot_messages::format_number;

/// Accepted magnitudes of a scale. Micrometers and meganewtons are a factor of 10⁶ from SI, and the bounds leave 10³ for a motion ratio.
///
/// Test: `scales_beyond_their_bounds_are_rejected_with_option_and_bounds`.
const MAGNITUDES: (f64, f64) = (1e-9, 1e9);

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
    /// The magnitude of a scale is outside [`MAGNITUDES`], or the offset is larger than 1 m.
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
            bail!("--position-offset is in m and lies between -1 and 1, not {}", format_number(position_offset));
        }
        for (name, scale) in [("--motion-scale", scales.motion), ("--force-scale", scales.force)] {
            if !(MAGNITUDES.0..=MAGNITUDES.1).contains(&scale.abs()) {
                bail!(
                    "{name} is a factor of a magnitude from {} to {}, such as 0.001 for a host in mm or kN, not {}",
                    format_number(MAGNITUDES.0),
                    format_number(MAGNITUDES.1),
                    format_number(scale)
                );
            }
        }
        Ok(scales)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_beyond_their_bounds_are_rejected_with_option_and_bounds() {
        let absurd = [1e308, -1e308, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
        let tiny = [0.0, 1e-308, -1e-308];
        for value in absurd.into_iter().chain(tiny) {
            for (option, checked) in [
                ("--motion-scale", Scales::checked(1, Some(value), None, 0.0)),
                ("--force-scale", Scales::checked(4, None, Some(value), 0.0)),
            ] {
                let message = checked.err().expect("no such scale").to_string();
                assert!(message.starts_with(option) && message.contains("1e-9 to 1e9"), "{message}");
                assert!(
                    message.ends_with(&format!("not {}", format_number(value))) && message.len() < 300,
                    "{message}"
                );
            }
        }
        for value in absurd {
            let message = Scales::checked(1, None, None, value).err().expect("no such offset").to_string();
            assert!(message.starts_with("--position-offset") && message.len() < 300, "{message}");
            let message = Scales::carmaker(value).err().expect("no such length").to_string();
            assert!(message.starts_with("--carmaker") && message.len() < 300, "{message}");
        }
        assert!(Scales::carmaker(0.0).is_err() && Scales::carmaker(1e-308).is_err());
        for value in [1e-9, -1e9, 0.9] {
            let scales = Scales::checked(1, Some(value), Some(-value), 1e-308).expect("scales within the bounds");
            assert_eq!((scales.motion, scales.force), (value, -value));
        }
    }
}
