//! Two thermal nodes of a damper on the rig. The dissipated power heats the oil, the oil heats the body, and the body
//! heats the air.

use crate::draw::Draw;

/// Temperature of the laboratory, °C.
pub(crate) const AIR_C: f64 = 22.0;

/// Heat capacities (J/K) and thermal conductances (W/K) of oil and body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Heat {
    oil_j_k: f64,
    body_j_k: f64,
    oil_to_body_w_k: f64,
    body_to_air_w_k: f64,
}

/// Temperatures of the oil and of the body of a damper, °C.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Temperatures {
    pub oil_c: f64,
    pub body_c: f64,
}

impl Heat {
    pub fn draw(draw: &mut Draw) -> Self {
        Self {
            oil_j_k: draw.between("oil_j_k", 150.0, 300.0),
            body_j_k: draw.between("body_j_k", 300.0, 600.0),
            oil_to_body_w_k: draw.between("oil_to_body_w_k", 10.0, 25.0),
            body_to_air_w_k: draw.between("body_to_air_w_k", 4.0, 8.0),
        }
    }

    /// Computes the temperatures of oil and body, °C, after `seconds` at a constant dissipated power, W.
    pub fn after(&self, now: Temperatures, power_w: f64, seconds: f64) -> Temperatures {
        // The time constant of the oil, `oil_j_k / oil_to_body_w_k`, is 6 s to 30 s, so an explicit step of at most 1 s
        // is stable.
        let steps = seconds.ceil().max(1.0);
        let step = seconds / steps;
        let mut then = now;
        for _ in 0..steps as usize {
            let inward = self.oil_to_body_w_k * (then.oil_c - then.body_c);
            let outward = self.body_to_air_w_k * (then.body_c - AIR_C);
            then.oil_c += step * (power_w - inward) / self.oil_j_k;
            then.body_c += step * (inward - outward) / self.body_j_k;
        }
        then
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heat_goes_through_the_body_to_the_air() {
        let heat = Heat::draw(&mut Draw::new(1, "heat"));
        let cold = Temperatures { oil_c: AIR_C, body_c: AIR_C };
        let warm = heat.after(cold, 100.0, 20_000.0);
        assert!((warm.body_c - AIR_C - 100.0 / heat.body_to_air_w_k).abs() < 0.01, "{warm:?}");
        assert!((warm.oil_c - warm.body_c - 100.0 / heat.oil_to_body_w_k).abs() < 0.01, "{warm:?}");
        let cooled = heat.after(warm, 0.0, 20_000.0);
        assert!((cooled.oil_c - AIR_C).abs() < 0.01);
        // Within 0.1 s, heat losses are negligible, and the oil stores all heat.
        let short = heat.after(cold, 1000.0, 0.1);
        assert!((short.oil_c - AIR_C - 100.0 / heat.oil_j_k).abs() < 1e-3);
    }
}
