//! Flow through the piston: a bleed that is always open and one blow-off valve for each direction.

/// Discharge coefficient of the sharp-edged passages.
const DISCHARGE: f64 = 0.7;

/// All passages of the piston, in parallel.
#[derive(Debug, Clone, PartialEq)]
pub struct PistonValves {
    /// Passage that is open in both directions.
    pub bleed: Bleed,
    /// Valve that opens in extension.
    pub rebound: BlowOff,
    /// Valve that opens in compression.
    pub compression: BlowOff,
}

impl Default for PistonValves {
    fn default() -> Self {
        Self {
            bleed: Bleed { area_m2: 6.0e-6, laminar_pa_s_m3: 7.0e8 },
            rebound: BlowOff { preload_pa: 5.0e5, opening_m2_pa: 3.4e-11, port_m2: 6.0e-5, knee_pa: 6.0e4 },
            compression: BlowOff { preload_pa: 2.6e5, opening_m2_pa: 1.1e-10, port_m2: 1.0e-4, knee_pa: 3.5e4 },
        }
    }
}

impl PistonValves {
    /// Computes the flow from the rebound into the compression chamber, m³/s, for a pressure drop in this direction,
    /// Pa.
    pub fn flow_m3_s(&self, drop_pa: f64, density_kg_m3: f64) -> f64 {
        let blow_off = if drop_pa > 0.0 { &self.rebound } else { &self.compression };
        let size = drop_pa.abs();
        (self.bleed.flow(size, density_kg_m3) + blow_off.flow(size, density_kg_m3)).copysign(drop_pa)
    }

    /// Computes the pressure drop, Pa, of a given flow, m³/s: the inverse of [`PistonValves::flow_m3_s`].
    pub fn pressure_drop_pa(&self, flow_m3_s: f64, density_kg_m3: f64) -> f64 {
        let flow = |size: f64| self.flow_m3_s(size.copysign(flow_m3_s), density_kg_m3).abs();
        let target = flow_m3_s.abs();
        let mut high = 1.0;
        while flow(high) < target {
            high *= 2.0;
        }
        let mut low = 0.0;
        // The flow increases with the pressure drop, so 100 bisections give the drop to the precision of `f64`.
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if flow(middle) < target {
                low = middle;
            } else {
                high = middle;
            }
        }
        (0.5 * (low + high)).copysign(flow_m3_s)
    }
}

/// Passage of constant area: a laminar and an orifice resistance in series.
#[derive(Debug, Clone, PartialEq)]
pub struct Bleed {
    /// Area of the orifice, m².
    pub area_m2: f64,
    /// Laminar resistance, Pa s/m³.
    pub laminar_pa_s_m3: f64,
}

impl Bleed {
    /// Solves `drop = R Q + rho Q² / (2 (Cd A)²)` for the flow Q, m³/s. R is the laminar resistance, rho the density,
    /// Cd the discharge coefficient and A the area.
    fn flow(&self, drop_pa: f64, density: f64) -> f64 {
        let turbulent = density / (2.0 * (DISCHARGE * self.area_m2).powi(2));
        let laminar = self.laminar_pa_s_m3;
        2.0 * drop_pa / (laminar + (laminar * laminar + 4.0 * turbulent * drop_pa).sqrt())
    }
}

/// Preloaded shim over a port. The shim is closed up to the preload, then opens with pressure until the port limits the
/// flow.
#[derive(Debug, Clone, PartialEq)]
pub struct BlowOff {
    /// Pressure drop at which the shim lifts (blow-off pressure), Pa.
    pub preload_pa: f64,
    /// Opening area per pressure drop above the preload, m²/Pa.
    pub opening_m2_pa: f64,
    /// Area of the port behind the shim, m².
    pub port_m2: f64,
    /// Width of the knee, Pa, over which the valve opens, because parts of the shim's edge lift at different pressures.
    pub knee_pa: f64,
}

impl BlowOff {
    /// Computes the opening area of the shim, m², at a pressure drop, Pa: zero without pressure, linear well above the
    /// preload.
    fn shim_area(&self, drop_pa: f64) -> f64 {
        let softplus = |x: f64| if x > 30.0 { x } else { libm::log1p(libm::exp(x)) };
        let lift = softplus((drop_pa - self.preload_pa) / self.knee_pa) - softplus(-self.preload_pa / self.knee_pa);
        self.opening_m2_pa * self.knee_pa * lift
    }

    fn flow(&self, drop_pa: f64, density: f64) -> f64 {
        let shim = self.shim_area(drop_pa);
        // The shim and the port are two orifices in series.
        let area = shim * self.port_m2 / libm::hypot(shim, self.port_m2);
        DISCHARGE * area * (2.0 * drop_pa / density).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DENSITY: f64 = 850.0;

    #[test]
    fn flow_rises_with_pressure_and_inverts() {
        let valves = PistonValves::default();
        let mut last = f64::NEG_INFINITY;
        for i in -400..=400 {
            let drop = f64::from(i) * 1e4;
            let flow = valves.flow_m3_s(drop, DENSITY);
            assert!(flow > last);
            last = flow;
            assert!((valves.pressure_drop_pa(flow, DENSITY) - drop).abs() < 1e-6 * drop.abs() + 1e-9);
        }
    }

    #[test]
    fn bleed_is_laminar_at_small_and_turbulent_at_large_flow() {
        let bleed = PistonValves::default().bleed;
        assert!((bleed.flow(1.0, DENSITY) * bleed.laminar_pa_s_m3 - 1.0).abs() < 1e-3);
        let orifice = DISCHARGE * bleed.area_m2 * (2.0 * 1e9 / DENSITY).sqrt();
        assert!((bleed.flow(1e9, DENSITY) / orifice - 1.0).abs() < 0.02);
    }

    #[test]
    fn blow_off_is_closed_below_preload_and_limited_by_its_port() {
        let valve = PistonValves::default().rebound;
        let bleed = PistonValves::default().bleed;
        assert_eq!(valve.flow(0.0, DENSITY), 0.0);
        assert!(valve.flow(0.5 * valve.preload_pa, DENSITY) < 0.02 * bleed.flow(0.5 * valve.preload_pa, DENSITY));
        assert!(valve.flow(2.0 * valve.preload_pa, DENSITY) > bleed.flow(2.0 * valve.preload_pa, DENSITY));
        let port = DISCHARGE * valve.port_m2 * (2.0 * 1e8 / DENSITY).sqrt();
        assert!((valve.flow(1e8, DENSITY) / port - 1.0).abs() < 1e-2);
    }
}
