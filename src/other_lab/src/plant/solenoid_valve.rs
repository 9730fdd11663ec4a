//! A solenoid valve: driver, coil, magnet, pilot spool and the main stage, which is an orifice of variable opening.
//!
//! The driver is a current controller on a battery. The driver can reduce the current only with the voltage of a diode.
//! Because of eddy currents, the magnetic flux lags the current. The magnetic force saturates. A spring, the flow force
//! and bristle friction act on the spool. The main stage follows the spool as oil fills its chamber through an orifice.

use crate::draw::Draw;

use super::flow::ramp;

/// Index of the coil current, A, in the valve's states.
pub const CURRENT: usize = 0;
const FLUX: usize = 1;
const SPOOL: usize = 2;
const SPEED: usize = 3;
const BRISTLE: usize = 4;
/// Index of the main stage's position, m, in the valve's states. At position 0, the main stage is fully open.
pub const STAGE: usize = 5;
/// Number of states of the valve.
pub const STATES: usize = 6;

/// Error tolerance per step of each state, in the unit of the state. The states are current (A), flux as a current (A),
/// spool position (m), spool velocity (m/s), bristle deflection (m) and stage position (m).
pub const TOLERANCES: [f64; STATES] = [2e-4, 2e-4, 2e-7, 2e-4, 2e-9, 2e-7];

/// Stiffness of the stops of the spool, N/m.
const STOP: f64 = 4e5;
/// Density of the oil, kg/m³. [`DISCHARGE`] is the discharge coefficient of a sharp-edged orifice.
const DENSITY: f64 = 850.0;
const DISCHARGE: f64 = 0.65;
/// Laminar part of the hydraulic force, N, at the flow at which the laminar and the turbulent part are equal.
const TRANSITION: f64 = 15.0;
/// Cosine of the jet's angle of 69° at a sharp metering edge (Merritt, Hydraulic Control Systems, 1967).
const JET: f64 = 0.36;

/// Parameters of a solenoid valve.
#[derive(Debug, Clone)]
pub struct SolenoidValve {
    /// Voltage of the battery, and forward voltage of the diode, V.
    pub supply: [f64; 2],
    /// Gain of the current controller, V/A.
    pub gain: f64,
    /// Resistance, Ω, and inductance, H, of the coil.
    pub coil: [f64; 2],
    /// Time constant of the eddy currents, s.
    pub eddy: f64,
    /// Magnetic force at saturation, N, and the current at which saturation begins, A.
    pub magnet: [f64; 2],
    /// Mass of the spool, kg, stiffness of its spring, N/m, and its damping, N s/m.
    pub spool: [f64; 3],
    /// Friction of the spool, N, and the deflection at which it slides, m.
    pub friction: [f64; 2],
    /// Fraction of the flow force that acts on the spool.
    pub flow_force: f64,
    /// Time constant of the main stage for small motion, s, and distance between spool and main stage, m. At larger
    /// distances, the flow into the chamber of the main stage is turbulent.
    pub stage: [f64; 2],
    /// Travel of the main stage, m, and width of its opening, m.
    pub opening: [f64; 2],
    /// Area of the opening at the closed position, m².
    pub leak: f64,
}

impl SolenoidValve {
    /// Draws a valve for currents up to `most`, A. `area` is the opening area at zero current, the soft setting, m².
    pub fn new(d: &mut Draw, area: f64, most: f64) -> SolenoidValve {
        let travel = d.between(1.0e-3, 1.6e-3);
        let stiffness = d.between(5e3, 1e4);
        let mass = d.between(6e-3, 14e-3);
        let begins = most * d.between(0.7, 1.2);
        // At the largest current, the spool has completed most of its travel.
        let reached = d.between(0.9, 0.96) * travel * stiffness;
        let force = reached / libm::tanh(most / begins);
        SolenoidValve {
            supply: [d.between(11.5, 14.0), 0.8],
            gain: d.between(20.0, 60.0),
            coil: [d.between(3.0, 5.0), d.scale(8e-3, 30e-3)],
            eddy: d.scale(1.5e-3, 5e-3),
            magnet: [force, begins],
            spool: [mass, stiffness, 2.0 * d.between(0.5, 0.9) * (mass * stiffness).sqrt()],
            friction: [d.between(0.005, 0.025) * reached, d.scale(5e-6, 2e-5)],
            flow_force: d.between(0.02, 0.08),
            stage: [d.scale(1.5e-3, 5e-3), d.between(3e-4, 1e-3)],
            opening: [travel, area / travel],
            leak: d.between(0.03, 0.07) * area,
        }
    }

    /// Computes the opening area of the main stage, m².
    pub fn area(&self, states: &[f64]) -> f64 {
        let [travel, width] = self.opening;
        width * ramp(travel - states[STAGE], 0.02 * travel) + self.leak
    }

    /// Computes the flow through the opening as a piston velocity, m/s, at the hydraulic force h ≥ 0, N. `area` is the
    /// piston area, m².
    pub fn velocity(&self, h: f64, area: f64, states: &[f64]) -> f64 {
        let ratio = area / (DISCHARGE * self.area(states));
        let turbulent = 0.5 * DENSITY * area * ratio * ratio;
        super::flow::passage(h, (turbulent * TRANSITION).sqrt(), turbulent)
    }

    /// Computes the time derivatives of the states for a commanded current, A, and a pressure drop across the main
    /// stage, Pa.
    pub fn rates(&self, command: f64, pressure: f64, y: &[f64], r: &mut [f64]) {
        let [resistance, inductance] = self.coil;
        let wanted = resistance * command + self.gain * (command - y[CURRENT]);
        let voltage = wanted.min(self.supply[0]).max(-self.supply[1]);
        // A diode prevents negative current, so a negative value due to an integration error decays with a time
        // constant of 0.1 ms.
        let rate = (voltage - resistance * y[CURRENT]) / inductance;
        r[CURRENT] = if y[CURRENT] < 0.0 { -y[CURRENT] / 1e-4 } else { rate };
        r[FLUX] = (y[CURRENT] - y[FLUX]) / self.eddy;

        let [mass, stiffness, damping] = self.spool;
        let [most, begins] = self.magnet;
        let [level, slides] = self.friction;
        let (place, speed) = (y[SPOOL], y[SPEED]);
        r[BRISTLE] = speed - speed.abs() * y[BRISTLE] / slides;
        let friction = level / slides * (y[BRISTLE] + 2e-4 * r[BRISTLE]);
        let stops = STOP * (place.min(0.0) + (place - self.opening[0]).max(0.0));
        let flow = self.flow_force * 2.0 * DISCHARGE * JET * self.area(y) * pressure;
        let magnet = most * libm::tanh(y[FLUX].max(0.0) / begins);
        r[SPOOL] = speed;
        r[SPEED] = (magnet + flow - stiffness * place - damping * speed - friction - stops) / mass;

        let [time, turbulent] = self.stage;
        let behind = place - y[STAGE];
        r[STAGE] = behind / (time * (1.0 + behind.abs() / turbulent).sqrt());
    }
}
