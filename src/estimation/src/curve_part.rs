//! Parts of an FV curve that change as one: all of a side, its bleed, its blow-off.

use dashpot_core::Params;
use dashpot_core::list;

/// A part of the FV curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CurvePart {
    /// Whether it is the rebound side.
    pub rebound: bool,
    /// Which speeds.
    pub speeds: Speeds,
}

/// Speeds of a part of the FV curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Speeds {
    /// All: one factor on the side, as of oil, piston or preload.
    All,
    /// Those below the knee, where the bleed carries the flow.
    Low,
    /// Those beyond the knee, where the valve has blown off.
    High,
}

/// Speed, m/s, at which bleed and blow-off carry alike: knees of shim valves lie at 0.03 to 0.2 m/s (Dixon 2007, chapter 6).
const KNEE: f64 = 0.1;

impl CurvePart {
    /// All parts.
    pub const ALL: [CurvePart; 6] = {
        const fn part(rebound: bool, speeds: Speeds) -> CurvePart {
            CurvePart { rebound, speeds }
        }
        [
            part(true, Speeds::All),
            part(false, Speeds::All),
            part(true, Speeds::Low),
            part(false, Speeds::Low),
            part(true, Speeds::High),
            part(false, Speeds::High),
        ]
    };

    /// Its name in answers.
    pub fn name(self) -> &'static str {
        match (self.rebound, self.speeds) {
            (true, Speeds::All) => "rebound_curve",
            (false, Speeds::All) => "compression_curve",
            (true, Speeds::Low) => "rebound_low_speed",
            (false, Speeds::Low) => "compression_low_speed",
            (true, Speeds::High) => "rebound_high_speed",
            (false, Speeds::High) => "compression_high_speed",
        }
    }

    /// Fraction of the change that a speed takes part in.
    fn weight(self, velocity: f64) -> f64 {
        if (velocity > 0.0) != self.rebound {
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

    /// Scales the part by one plus a relative change.
    pub fn scale(self, params: &mut Params, change: f64) {
        let velocity = params.list(list!("fv_velocity")).to_vec();
        let force: Vec<f64> = params
            .list(list!("fv_force"))
            .iter()
            .zip(&velocity)
            .map(|(force, v)| force * (1.0 + change * self.weight(*v)))
            .collect();
        // A list that the table rejects leaves the base as it was.
        let _ = params.set_list(list!("fv_force"), &force);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_scales_its_side_and_speeds_alone() {
        let base = Params::new();
        for part in CurvePart::ALL {
            let mut changed = base;
            part.scale(&mut changed, 0.2);
            let (v, before, after) =
                (base.list(list!("fv_velocity")), base.list(list!("fv_force")), changed.list(list!("fv_force")));
            for k in 0..v.len() {
                let ratio = if before[k] == 0.0 { 1.0 } else { after[k] / before[k] };
                assert!((ratio - 1.0 - 0.2 * part.weight(v[k])).abs() < 1e-12);
                assert!(v[k] == 0.0 || (v[k] > 0.0) == part.rebound || ratio == 1.0);
            }
        }
    }
}
