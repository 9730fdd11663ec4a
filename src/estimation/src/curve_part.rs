//! Parts of an FV curve that change as a whole: a side, the bleed of a side, the blow-off of a side.

use dashpot_core::Params;
use dashpot_core::list;

/// Part of the FV curve, given by a side and a range of speeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CurvePart {
    /// Side, rebound or compression, to which the part is restricted.
    pub side: Side,
    /// Range of speeds to which the part is restricted.
    pub speeds: Speeds,
}

/// Side of a part of the FV curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Rebound.
    Rebound,
    /// Compression.
    Compression,
    /// Both sides, which scale by one factor, for example because of thinner oil or a wrong load-cell gain.
    Both,
}

impl Side {
    /// Returns whether a velocity, m/s, positive in rebound, belongs to the side.
    pub fn has(self, velocity: f64) -> bool {
        match self {
            Side::Rebound => velocity > 0.0,
            Side::Compression => velocity < 0.0,
            Side::Both => velocity != 0.0,
        }
    }
}

/// Speeds of a part of the FV curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Speeds {
    /// All speeds: one factor on the whole side, for example because of oil, piston or preload.
    All,
    /// Speeds below the knee, where the oil flows through the bleed.
    Low,
    /// Speeds beyond the knee, where the blow-off is open.
    High,
}

/// Speed, m/s, at which bleed and blow-off have equal weight: knees of shim valves are at 0.03 to 0.2 m/s (Dixon 2007,
/// chapter 6).
const KNEE: f64 = 0.1;

impl CurvePart {
    /// Parts that a change may scale: both sides together, each side, and the low or the high speeds of each side.
    pub const ALL: [CurvePart; 7] = {
        const fn part(side: Side, speeds: Speeds) -> CurvePart {
            CurvePart { side, speeds }
        }
        [
            part(Side::Both, Speeds::All),
            part(Side::Rebound, Speeds::All),
            part(Side::Compression, Speeds::All),
            part(Side::Rebound, Speeds::Low),
            part(Side::Compression, Speeds::Low),
            part(Side::Rebound, Speeds::High),
            part(Side::Compression, Speeds::High),
        ]
    };

    /// Returns the name of the part in results.
    pub fn name(self) -> &'static str {
        match (self.side, self.speeds) {
            (Side::Both, _) => "fv_curve",
            (Side::Rebound, Speeds::All) => "rebound_curve",
            (Side::Compression, Speeds::All) => "compression_curve",
            (Side::Rebound, Speeds::Low) => "rebound_low_speed",
            (Side::Compression, Speeds::Low) => "compression_low_speed",
            (Side::Rebound, Speeds::High) => "rebound_high_speed",
            (Side::Compression, Speeds::High) => "compression_high_speed",
        }
    }

    /// Returns the name of the part that completes `part` to `whole` without overlap. Returns `None` if there is no
    /// such part.
    pub fn rest(whole: &str, part: &str) -> Option<&'static str> {
        let of = |name: &str| CurvePart::ALL.into_iter().find(|known| known.name() == name);
        let (whole, part) = (of(whole)?, of(part)?);
        let rest = match (whole, part) {
            (CurvePart { side: Side::Both, .. }, CurvePart { side, speeds: Speeds::All }) => {
                let other = match side {
                    Side::Rebound => Side::Compression,
                    Side::Compression => Side::Rebound,
                    Side::Both => return None,
                };
                CurvePart { side: other, speeds: Speeds::All }
            }
            (CurvePart { side, speeds: Speeds::All }, CurvePart { side: own, speeds }) if side == own => {
                let other = match speeds {
                    Speeds::Low => Speeds::High,
                    Speeds::High => Speeds::Low,
                    Speeds::All => return None,
                };
                CurvePart { side, speeds: other }
            }
            _ => return None,
        };
        Some(rest.name())
    }

    /// Computes the fraction, 0 to 1, of a relative change of the part that applies at a velocity, m/s.
    fn weight(self, velocity: f64) -> f64 {
        if !self.side.has(velocity) {
            return 0.0;
        }
        let ratio = velocity / KNEE;
        let low = 1.0 / (1.0 + ratio * ratio);
        match self.speeds {
            Speeds::All => 1.0,
            Speeds::Low => low,
            Speeds::High => 1.0 - low,
        }
    }

    /// Scales the part of the FV curve in `params` by 1 + `change`.
    pub fn scale(self, params: &mut Params, change: f64) {
        let velocity = params.list(list!("fv_velocity")).to_vec();
        let force: Vec<f64> = params
            .list(list!("fv_force"))
            .iter()
            .zip(&velocity)
            .map(|(force, v)| force * (1.0 + change * self.weight(*v)))
            .collect();
        // If the parameter set rejects the forces, it stays unchanged.
        let _ = params.set_list(list!("fv_force"), &force);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A part and the rest of a whole have together the weight of the whole at every velocity.
    #[test]
    fn a_part_and_the_rest_are_the_whole() {
        let mut count = 0;
        for whole in CurvePart::ALL {
            for part in CurvePart::ALL {
                let Some(rest) = CurvePart::rest(whole.name(), part.name()) else { continue };
                let rest = CurvePart::ALL.into_iter().find(|known| known.name() == rest).unwrap();
                for velocity in [-1.0, -0.1, -0.02, 0.02, 0.1, 1.0] {
                    let sum = part.weight(velocity) + rest.weight(velocity);
                    assert!((sum - whole.weight(velocity)).abs() < 1e-15, "{whole:?} {part:?} {rest:?}");
                }
                count += 1;
            }
        }
        assert_eq!(count, 6);
        assert_eq!(CurvePart::rest("rebound_curve", "compression_low_speed"), None);
        assert_eq!(CurvePart::rest("gas_force", "fv_curve"), None);
    }

    #[test]
    fn a_part_scales_its_side_and_speeds_alone() {
        let base = Params::new();
        for part in CurvePart::ALL {
            let mut changed = base;
            part.scale(&mut changed, 0.2);
            let (v, before, after) =
                (base.list(list!("fv_velocity")), base.list(list!("fv_force")), changed.list(list!("fv_force")));
            for k in (0..v.len()).filter(|k| v[*k] != 0.0) {
                let ratio = if before[k] == 0.0 { 1.0 } else { after[k] / before[k] };
                assert!((ratio - 1.0 - 0.2 * part.weight(v[k])).abs() < 1e-12, "{part:?} at {}: {ratio}", v[k]);
                assert!(v[k] == 0.0 || part.side.has(v[k]) || ratio == 1.0);
            }
        }
    }
}
