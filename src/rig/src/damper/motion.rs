//! The equations of motion: balance of oil mass in each chamber, seal bristles, and mount.

use super::{ATMOSPHERE_PA, Damper};
use crate::solver::Tolerance;

/// Number of states of the damper.
pub const STATES: usize = 5;
/// State vector. The constants from [`REBOUND`] to [`MOUNT_RATE`] are its indices.
pub type State = [f64; STATES];

/// Index of the absolute pressure in the rebound chamber, Pa.
const REBOUND: usize = 0;
/// Index of the absolute pressure in the compression chamber and the gas, Pa.
const COMPRESSION: usize = 1;
/// Index of the deflection of the seal's bristles (friction model), m.
const BRISTLE: usize = 2;
/// Index of the deflection of the mount, positive in extension, m.
const MOUNT: usize = 3;
/// Index of the rate of the mount's deflection, m/s.
const MOUNT_RATE: usize = 4;

/// Motion and side force that the rig imposes at one instant.
#[derive(Debug, Clone, Copy)]
pub struct Excitation {
    /// Displacement that the actuator imposes, from mid-stroke, m, positive in extension.
    pub displacement_m: f64,
    /// Velocity, m/s, positive in extension.
    pub velocity_m_s: f64,
    /// Side force on the rod, N.
    pub side_force_n: f64,
}

impl Damper {
    /// Returns the solver's error tolerance per step: 2e-7 of each state, plus an absolute tolerance that corresponds
    /// to about 1 mN of force.
    pub(crate) fn tolerance() -> Tolerance<STATES> {
        Tolerance { absolute: [1.0, 1.0, 2e-9, 1e-10, 5e-7], relative: 2e-7 }
    }

    /// Computes the time derivatives of all states: Pa/s, m/s, m/s².
    pub(crate) fn rates(&self, state: &State, input: &Excitation) -> State {
        let Chambers { rebound, compression, velocity } = self.chambers(state, input);
        let flow = self.valves.flow_m3_s(state[REBOUND] - state[COMPRESSION], self.oil.density_kg_m3);
        // The oil flow through the piston has the density of its source chamber. Its mass, not its volume, is
        // conserved.
        let (out_of_rebound, into_compression) = if flow > 0.0 {
            (flow, flow * compression.specific_volume / rebound.specific_volume)
        } else {
            (flow * rebound.specific_volume / compression.specific_volume, flow)
        };
        let mut rates = [0.0; STATES];
        rates[REBOUND] = (self.tube.annulus_m2() * velocity * rebound.dilation - out_of_rebound) / rebound.compliance;
        rates[COMPRESSION] =
            (into_compression - self.tube.piston_m2() * velocity * compression.dilation) / compression.compliance;
        rates[BRISTLE] = self.seal.deflection_rate(state[BRISTLE], velocity, input.side_force_n);
        if let Some(mount) = &self.mount {
            rates[MOUNT] = state[MOUNT_RATE];
            rates[MOUNT_RATE] =
                (self.rod_force_n(state) - mount.force_n(state[MOUNT], state[MOUNT_RATE])) / mount.rod_mass_kg;
        }
        rates
    }

    /// Computes the force on the load cell, N.
    pub(crate) fn force_n(&self, state: &State) -> f64 {
        match &self.mount {
            Some(mount) => mount.force_n(state[MOUNT], state[MOUNT_RATE]),
            None => self.rod_force_n(state),
        }
    }

    /// Computes the state of equilibrium at a displacement, m: equal pressures, unloaded bristles, and the oil mass
    /// that the damper has at mid-stroke.
    pub(crate) fn at_rest(&self, displacement_m: f64) -> State {
        let filled = self.oil_volume(&self.level_state(self.gas.pressure_pa), 0.0);
        let (mut low, mut high) = (1e3, 1e9);
        // Bisect: the oil mass at one displacement increases with pressure, because oil and gas are compressible.
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if self.oil_volume(&self.level_state(middle), displacement_m) < filled {
                low = middle;
            } else {
                high = middle;
            }
        }
        self.level_state(0.5 * (low + high))
    }

    /// Makes a state with the absolute pressure `pressure_pa` in both chambers, the mount in equilibrium, and zero for
    /// all other states.
    fn level_state(&self, pressure_pa: f64) -> State {
        let mut state = [pressure_pa, pressure_pa, 0.0, 0.0, 0.0];
        if let Some(mount) = &self.mount {
            state[MOUNT] = self.rod_force_n(&state) / mount.stiffness_n_m;
        }
        state
    }

    /// Computes the force of chamber pressures, atmosphere and seal on the rod, N, tension positive.
    fn rod_force_n(&self, state: &State) -> f64 {
        state[REBOUND] * self.tube.annulus_m2() - state[COMPRESSION] * self.tube.piston_m2()
            + ATMOSPHERE_PA * self.tube.rod_area_m2()
            + self.seal.force_n(state[BRISTLE])
    }

    /// Computes the volume that the oil of both chambers has at atmospheric pressure, m³. It is constant, like the
    /// oil's mass.
    fn oil_volume(&self, state: &State, displacement_m: f64) -> f64 {
        let chambers = self.chambers(state, &Excitation { displacement_m, velocity_m_s: 0.0, side_force_n: 0.0 });
        [chambers.rebound, chambers.compression].iter().map(|chamber| chamber.volume / chamber.specific_volume).sum()
    }

    fn chambers(&self, state: &State, input: &Excitation) -> Chambers {
        let position = input.displacement_m - state[MOUNT];
        let velocity = input.velocity_m_s - state[MOUNT_RATE];
        let (tube, wall) = (&self.tube, self.tube.wall_modulus_pa);
        let dilation = |pressure: f64| 1.0 + (pressure - ATMOSPHERE_PA) / wall;

        let rebound_space = tube.annulus_m2() * (tube.rebound_length_m - position);
        let gas = self.gas.volume_at(state[COMPRESSION]);
        let compression_space = tube.piston_m2() * (tube.compression_length_m + position) + self.gas.volume_m3 - gas;

        let chamber = |pressure: f64, space: f64, gas_compliance: f64| {
            let oil = self.oil.compress(pressure);
            let dilation = dilation(pressure);
            let volume = space * dilation;
            Chamber {
                volume,
                specific_volume: oil.volume,
                dilation,
                compliance: volume / oil.modulus_pa + space / wall + gas_compliance * dilation,
            }
        };
        Chambers {
            rebound: chamber(state[REBOUND], rebound_space, 0.0),
            compression: chamber(state[COMPRESSION], compression_space, self.gas.compliance(state[COMPRESSION], gas)),
            velocity,
        }
    }
}

/// State of one chamber at one instant.
struct Chamber {
    /// Volume of the chamber, filled with oil, m³.
    volume: f64,
    /// Specific volume of the oil relative to that at atmospheric pressure.
    specific_volume: f64,
    /// Cross-section of the tube relative to that at atmospheric pressure, due to the expansion of its wall.
    dilation: f64,
    /// Additional volume of oil that the chamber accepts per increase of pressure, due to oil, tube and gas, m³/Pa.
    compliance: f64,
}

/// State of both chambers at one instant.
struct Chambers {
    rebound: Chamber,
    compression: Chamber,
    /// Velocity of the piston relative to the tube, m/s, positive in extension.
    velocity: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TestPoint;
    use crate::drive::Drive;
    use crate::matrix::default_cycles;
    use crate::solver::Integrator;
    use std::f64::consts::TAU;

    fn point(amplitude_m: f64, frequency_hz: f64) -> TestPoint {
        TestPoint {
            name: "test".into(),
            amplitude_m,
            frequency_hz,
            peak_velocity_m_s: TAU * amplitude_m * frequency_hz,
            mean_displacement_m: 0.0,
            side_force_n: 0.0,
            cycles: default_cycles(frequency_hz),
            road_seed: None,
        }
    }

    /// Returns time, input and state over the whole cycles at full amplitude, with `per_cycle` samples in each cycle.
    /// `sharpen` divides the error tolerances of the integrator.
    fn simulate(damper: &Damper, point: &TestPoint, sharpen: f64, per_cycle: u32) -> Vec<(f64, Excitation, State)> {
        let drive = Drive::new(point);
        let input = |time: f64| {
            let (displacement_m, velocity_m_s) = drive.motion(time);
            Excitation { displacement_m, velocity_m_s, side_force_n: point.side_force_n }
        };
        let mut tolerance = Damper::tolerance();
        tolerance.relative /= sharpen;
        for absolute in &mut tolerance.absolute {
            *absolute /= sharpen;
        }
        let rest = damper.at_rest(point.mean_displacement_m);
        let mut motion = Integrator::new(|t, y: &State| damper.rates(y, &input(t)), 0.0, rest, tolerance);
        let (start, end) = drive.full_cycles_s();
        let count = point.cycles * per_cycle;
        (0..=count)
            .map(|i| {
                let time = start + (end - start) * f64::from(i) / f64::from(count);
                motion.advance_to(time).unwrap();
                (time, input(time), *motion.state())
            })
            .collect()
    }

    #[test]
    fn rest_stays_at_rest_and_shows_the_gas_force() {
        let damper = Damper::default();
        for displacement_m in [-0.05, 0.0, 0.05] {
            let state = damper.at_rest(displacement_m);
            let input = Excitation { displacement_m, velocity_m_s: 0.0, side_force_n: 0.0 };
            for (rate, allowed) in damper.rates(&state, &input).iter().zip(Damper::tolerance().absolute) {
                assert!(rate.abs() < allowed, "{rate}");
            }
            let expected = (state[COMPRESSION] - ATMOSPHERE_PA) * damper.tube.rod_area_m2();
            assert!((damper.force_n(&state) + expected).abs() < 1e-6);
        }
        let force = |x| damper.force_n(&damper.at_rest(x));
        // The gas pushes the rod out, which is compression of the load cell. The deeper the rod, the larger the force.
        assert!(force(-0.05) < force(0.0) && force(0.0) < force(0.05) && force(0.05) < -60.0);
    }

    #[test]
    fn slow_cycles_show_gas_force_and_friction() {
        let damper = Damper::default();
        let samples = simulate(&damper, &point(0.01, 0.006369), 1.0, 200);
        let mean_and_half = |time_share: f64| {
            let quarter = 200.0 * time_share;
            let up = &samples[400 + quarter as usize];
            let down = &samples[400 + 100 + quarter as usize];
            let (up, down) = (damper.force_n(&up.2), damper.force_n(&down.2));
            (0.5 * (up + down), 0.5 * (up - down))
        };
        // At mid-stroke, the mean of the forces in rebound and compression is the static gas force. Half their
        // difference is the sliding friction plus the force of the bleed at 0.4 mm/s.
        let (gas, friction) = mean_and_half(0.0);
        assert!((gas - damper.force_n(&damper.at_rest(0.0))).abs() < 1.0, "{gas}");
        let expected = damper.seal.sliding_force_n(4e-4, 0.0);
        let bleed = damper.valves.pressure_drop_pa(4e-4 * damper.tube.annulus_m2(), damper.oil.density_kg_m3)
            * damper.tube.annulus_m2();
        assert!(bleed < 3.0);
        assert!((friction - expected - bleed).abs() < 0.5, "{friction} against {expected} + {bleed}");
    }

    #[test]
    fn side_force_raises_friction_by_its_share() {
        let damper = Damper::default();
        let loop_area = |side_force_n| {
            let point = TestPoint { side_force_n, ..point(0.01, 0.02) };
            let samples = simulate(&damper, &point, 1.0, 400);
            work(&damper, &samples[400..=800])
        };
        let added = loop_area(300.0) - loop_area(0.0);
        let expected = damper.seal.side_force_ratio * 300.0 * 0.04;
        assert!((added / expected - 1.0).abs() < 0.03, "{added} against {expected}");
    }

    #[test]
    fn long_stroke_peaks_agree_with_steady_flow() {
        let damper = Damper { mount: None, ..Damper::default() };
        for (amplitude, frequency) in [(0.05, 5.0 / 12.0), (0.05, 5.0)] {
            let samples = simulate(&damper, &point(amplitude, frequency), 1.0, 400);
            let first = samples.len() - 401;
            for (sample, sign) in [(&samples[first], 1.0), (&samples[first + 200], -1.0)] {
                let steady = damper.steady_force_n(sign * TAU * amplitude * frequency);
                let force = damper.force_n(&sample.2);
                // The polytropic gas pressure and the compressibility of the oil cause a difference of less than 3 %
                // from the force in steady flow.
                assert!((force / steady - 1.0).abs() < 0.03, "{force} against {steady}");
            }
        }
    }

    #[test]
    fn default_damper_has_the_forces_of_a_car_damper() {
        let damper = Damper::default();
        let rebound = damper.steady_force_n(TAU * 0.05 * 5.0);
        let compression = damper.steady_force_n(-TAU * 0.05 * 5.0);
        assert!((3200.0..3800.0).contains(&rebound), "{rebound}");
        assert!((-2000.0..-1600.0).contains(&compression), "{compression}");
        // The FV curve has a knee: its slope above 0.2 m/s is less than 0.4 of its slope below 0.06 m/s.
        for sign in [1.0, -1.0] {
            let force = |v: f64| damper.steady_force_n(sign * v).abs();
            let below = (force(0.06) - force(0.02)) / 0.04;
            let above = (force(1.0) - force(0.2)) / 0.8;
            assert!(above < 0.4 * below, "{above} after {below}");
        }
    }

    #[test]
    fn oil_column_and_mount_are_as_stiff_as_in_a_car_damper() {
        let damper = Damper::default();
        let input = Excitation { displacement_m: 0.0, velocity_m_s: 0.0, side_force_n: 0.0 };
        let chambers = damper.chambers(&damper.at_rest(0.0), &input);
        let oil = damper.tube.annulus_m2().powi(2) / chambers.rebound.compliance;
        let series = 1.0 / (1.0 / oil + 1.0 / damper.mount.unwrap().stiffness_n_m);
        println!("oil column {oil:.3e} N/m, with the mount {series:.3e} N/m");
        assert!((2e6..6e6).contains(&series), "{series}");
        // The gas keeps the pressure in the compression chamber nearly constant, so this chamber has a much larger
        // compliance than the rebound chamber.
        assert!(chambers.compression.compliance > 20.0 * chambers.rebound.compliance);
    }

    #[test]
    fn oil_mass_is_conserved() {
        let damper = Damper::default();
        let point = point(0.04, 4.0);
        let drive = Drive::new(&point);
        let filled = damper.oil_volume(&damper.at_rest(0.0), 0.0);
        for (time, _, state) in simulate(&damper, &point, 1.0, 50) {
            let now = damper.oil_volume(&state, drive.motion(time).0);
            // The gas pressure is sensitive to numerical loss of oil, so the tolerance is strict.
            assert!((now / filled - 1.0).abs() < 2e-5, "{}", now / filled - 1.0);
        }
    }

    /// Computes the work on the damper over one cycle of samples, J. The trapezoidal rule is accurate, because the data
    /// are periodic.
    fn work(damper: &Damper, cycle: &[(f64, Excitation, State)]) -> f64 {
        integral(cycle, |input, state| damper.force_n(state) * input.velocity_m_s)
    }

    fn integral(cycle: &[(f64, Excitation, State)], power: impl Fn(&Excitation, &State) -> f64) -> f64 {
        cycle
            .windows(2)
            .map(|pair| 0.5 * (pair[1].0 - pair[0].0) * (power(&pair[0].1, &pair[0].2) + power(&pair[1].1, &pair[1].2)))
            .sum()
    }

    #[test]
    fn work_of_a_cycle_is_what_valves_seal_and_mount_dissipate() {
        let damper = Damper::default();
        let mount = damper.mount.clone().unwrap();
        for (amplitude, frequency, closeness) in
            [(0.05, 5.0, 0.01), (0.015, 2.0, 0.01), (0.001, 20.0, 0.01), (0.01, 0.01, 0.01)]
        {
            let samples = simulate(&damper, &point(amplitude, frequency), 1.0, 2000);
            let cycle = &samples[samples.len() - 2001..];
            let work = work(&damper, cycle);
            let lost = integral(cycle, |input, state| {
                let drop = state[REBOUND] - state[COMPRESSION];
                let velocity = input.velocity_m_s - state[MOUNT_RATE];
                let seal = damper.seal.force_n(state[BRISTLE]);
                let slip = velocity - damper.seal.deflection_rate(state[BRISTLE], velocity, 0.0);
                drop * damper.valves.flow_m3_s(drop, damper.oil.density_kg_m3)
                    + seal * slip
                    + mount.damping_n_s_m * state[MOUNT_RATE].powi(2)
            });
            assert!(work > 0.0);
            assert!((lost / work - 1.0).abs() < closeness, "{amplitude} m, {frequency} Hz: {lost} against {work}");
        }
    }

    #[test]
    fn force_converges_with_the_tolerance() {
        let damper = Damper::default();
        for (amplitude, frequency) in [(0.05, 5.0), (0.002, 20.8333), (0.03, 0.3), (0.01, 0.0064)] {
            let point = point(amplitude, frequency);
            let forces = |sharpen: f64| -> Vec<f64> {
                simulate(&damper, &point, sharpen, 40).iter().map(|(_, _, state)| damper.force_n(state)).collect()
            };
            let sharp = forces(1e3);
            let worst = |sharpen: f64| {
                let differences = forces(sharpen).into_iter().zip(&sharp).map(|(a, b)| (a - b).abs());
                differences.fold(0.0, f64::max)
            };
            let (usual, coarse) = (worst(1.0), worst(1e-3));
            println!("{amplitude} m, {frequency} Hz: {usual:.5} N, {coarse:.5} N with the coarse tolerance");
            assert!(usual < 0.05, "{amplitude} m, {frequency} Hz: {usual} N");
            assert!(usual <= coarse, "{amplitude} m, {frequency} Hz: {usual} N, coarse {coarse} N");
        }
    }

    #[test]
    fn the_rig_limits_can_be_run_on_any_damper() {
        let corner = |amplitude, frequency, mean, side| TestPoint {
            mean_displacement_m: mean,
            side_force_n: side,
            cycles: 2,
            ..point(amplitude, frequency)
        };
        let corners = [
            corner(0.075, 6.36, 0.0, 0.0),
            corner(0.0095, 50.0, -0.06, -3000.0),
            corner(0.00005, 50.0, 0.07, 0.0),
            corner(0.005, 0.001, 0.07, 3000.0),
        ];
        for seed in 0..6 {
            let damper = Damper::seeded(seed);
            for point in &corners {
                for (_, _, state) in simulate(&damper, point, 1.0, 100) {
                    assert!(damper.force_n(&state).is_finite());
                    assert!(state[REBOUND] > 0.0 && state[COMPRESSION] > 0.0, "{seed}, {point:?}: {state:?}");
                }
            }
        }
    }
}
