//! Simulation of a maneuver at a fixed step of vehicle and dampers.

use super::too_fast::{SHORTEST_STEP, TooFast, too_fast};
use super::{Body, Car, Manoeuvre, Road};
use crate::chatter::RINGS;
use dashpot_core::{Input, Model, State, step};
use dashpot_messages::format_number;

/// Names of the corners of a vehicle: left and right, front (1) and rear (2).
pub const CORNERS: [&str; 4] = ["L1", "R1", "L2", "R2"];

/// Motion and force of one damper.
#[derive(Clone, Copy, Debug, Default)]
pub struct Corner {
    /// Displacement of the damper from its static position, m, extension positive.
    pub displacement: f64,
    /// Velocity of the damper, m/s.
    pub velocity: f64,
    /// Force of the damper, N, tension positive.
    pub force: f64,
}

/// Sample of a simulated maneuver.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Time, s.
    pub time: f64,
    /// State of the vehicle.
    pub body: Body,
    /// Motion and force of the dampers.
    pub corner: [Corner; 4],
    /// Height of the road under the wheels, m.
    pub road: [f64; 4],
}

/// Results of a simulated maneuver.
#[derive(Clone, Debug)]
pub struct Run {
    /// Samples at every host step.
    pub samples: Vec<Sample>,
    /// Largest coupling ratio c h/m. Here c is the slope of the damper at the wheel, N s/m, h the step, s, and m the unsprung mass, kg. An
    /// explicit host is unstable above 2. With one more step of delay, it is unstable above 1.
    pub coupling: f64,
    /// Largest coupling ratio at damper velocities above [`SLOW`].
    ///
    /// Below that velocity, friction determines the slope. The friction force is bounded, so an unstable coupling chatters but does not
    /// diverge.
    pub coupling_moving: f64,
}

/// Damper velocity below which friction determines the slope, m/s.
pub const SLOW: f64 = 0.02;

/// Reason why a maneuver failed.
#[derive(Debug, thiserror::Error)]
pub enum VehicleError {
    /// The step is outside the range of real-time simulators.
    #[error("--step is that of a vehicle, 0.0001 to 0.005 s, not {} s", format_number(*.0))]
    Step(f64),
    /// The vehicle became unstable: time, s, and cause.
    #[error("the vehicle left the road after {0:.3} s: {1}")]
    Unstable(f64, TooFast),
}

/// Four dampers as a simulator calls them. At each step, they receive their motion and return their force. Extension and tension are
/// positive.
pub trait Dampers {
    /// Sets all dampers to equilibrium at displacement 0. Returns their static forces, N.
    fn rest(&mut self) -> [f64; 4];
    /// Advances the dampers by `dt`, s, to these displacements, m, and velocities, m/s.
    ///
    /// Returns the force, N, and its total derivative with respect to velocity, N s/m. The total derivative includes the change of
    /// displacement, which is `dt` times the change of velocity.
    fn step(&mut self, dt: f64, motion: [[f64; 2]; 4]) -> [[f64; 2]; 4];
}

/// Dampers that `dashpot_core` simulates.
struct Kernels<'a> {
    models: [&'a Model; 4],
    states: [State; 4],
}

impl<'a> Kernels<'a> {
    fn new(models: [&'a Model; 4]) -> Kernels<'a> {
        Kernels { models, states: [State::ZERO; 4] }
    }
}

impl Dampers for Kernels<'_> {
    fn rest(&mut self) -> [f64; 4] {
        let still = Input::motion(0.0, 0.0);
        self.states = self.models.map(|model| model.steady_state(&still));
        // A step with dt = 0 returns the static force.
        std::array::from_fn(|i| step(self.models[i], &self.states[i], &still, 0.0).1.force)
    }

    fn step(&mut self, dt: f64, motion: [[f64; 2]; 4]) -> [[f64; 2]; 4] {
        std::array::from_fn(|i| {
            let [displacement, velocity] = motion[i];
            let (next, answer) = step(self.models[i], &self.states[i], &Input::motion(displacement, velocity), dt);
            self.states[i] = next;
            [answer.force, answer.d_force_d_velocity + dt * answer.d_force_d_displacement]
        })
    }
}

/// Simulates a maneuver at a fixed step with the dampers L1, R1, L2, R2 of these models.
///
/// # Errors
/// Returns an error if the step is out of range, or if the vehicle becomes unstable.
pub fn run(car: &Car, manoeuvre: Manoeuvre, models: [&Model; 4], dt: f64) -> Result<Run, VehicleError> {
    run_with(car, manoeuvre, &mut Kernels::new(models), dt)
}

/// Simulates a maneuver with dampers of any kind, such as the dampers behind the simulator bridge.
///
/// # Errors
/// Returns an error if the step is out of range, or if the vehicle becomes unstable.
pub fn run_with(car: &Car, manoeuvre: Manoeuvre, dampers: &mut impl Dampers, dt: f64) -> Result<Run, VehicleError> {
    if !(SHORTEST_STEP..=5e-3).contains(&dt) {
        return Err(VehicleError::Step(dt));
    }
    told_every(1, car, manoeuvre, dampers, dt)
}

/// Simulates a maneuver. Stores one sample for each `every` steps of `dt`, s.
fn told_every(
    every: usize,
    car: &Car,
    manoeuvre: Manoeuvre,
    dampers: &mut impl Dampers,
    dt: f64,
) -> Result<Run, VehicleError> {
    let road = Road::new(1);
    let ratio = car.motion_ratio;
    let mut body = Body::default();
    let rest = dampers.rest();
    let mut force = rest;
    let steps = (manoeuvre.duration() / dt).round() as usize;
    let mut samples = Vec::with_capacity(steps / every);
    let (mut coupling, mut coupling_moving) = (0.0_f64, 0.0_f64);
    for k in 0..steps {
        let time = k as f64 * dt;
        let heights = std::array::from_fn(|i| manoeuvre.road(&road, time, car.place(i)[0], i % 2));
        let held = std::array::from_fn(|i| ratio * (force[i] - rest[i]));
        car.step(&mut body, dt, manoeuvre.speed(), manoeuvre.steer(time), heights, held);
        let motion: [[f64; 2]; 4] = std::array::from_fn(|i| car.stroke(&body, i).map(|stroke| ratio * stroke));
        if !motion.iter().all(|[displacement, velocity]| velocity.abs() < 50.0 && displacement.abs() < 1.0) {
            // Use the slope of moving dampers. The slope of friction is steeper, but cannot cause instability, because the friction force
            // is bounded.
            let slope = coupling_moving * car.unsprung_mass / dt;
            return Err(VehicleError::Unstable(time, too_fast(car, slope, dt)));
        }
        let answers = dampers.step(dt, motion);
        force = answers.map(|[force, _]| force);
        for ([_, slope], [_, velocity]) in answers.iter().zip(motion) {
            let here = slope.abs() * ratio * ratio * dt / car.unsprung_mass;
            coupling = coupling.max(here);
            if velocity.abs() > SLOW {
                coupling_moving = coupling_moving.max(here);
            }
        }
        let corner = std::array::from_fn(|i| {
            let [displacement, velocity] = motion[i];
            Corner { displacement, velocity, force: force[i] }
        });
        if (k + 1) % every == 0 {
            samples.push(Sample { time: time + dt, body, corner, road: heights });
        }
    }
    Ok(Run { samples, coupling, coupling_moving })
}

/// Runs of two sets of dampers in one maneuver, with steps so short that the coupling of force and motion does not chatter.
#[derive(Clone, Debug)]
pub struct Quiet {
    /// Step of both runs, s.
    pub step: f64,
    /// The runs, with samples at the steps of the host.
    pub runs: [Run; 2],
}

/// Coupling ratio ([`Run::coupling`]) at which the shorter step is chosen. With this ratio, an oscillation decays within a few steps.
const QUIET: f64 = 0.5;
/// Largest number of substeps of a host step. A damper that still chatters with these substeps has a jump in its FV curve, for which no
/// step is short enough.
const MOST_PARTS: f64 = 64.0;

/// Simulates both sets of dampers again in shorter steps if one of the `runs` at `dt` chatters. Returns `None` if neither run chatters.
///
/// The difference between the new runs comes from the dampers and not from the step of the coupling.
///
/// # Errors
/// Returns an error if the vehicle becomes unstable.
pub fn without_chatter(
    car: &Car,
    manoeuvre: Manoeuvre,
    sets: [[&Model; 4]; 2],
    runs: &[Run; 2],
    dt: f64,
) -> Result<Option<Quiet>, VehicleError> {
    let coupling = runs.iter().map(|run| run.coupling).fold(0.0, f64::max);
    if coupling <= RINGS {
        return Ok(None);
    }
    let parts = (coupling / QUIET).ceil().min(MOST_PARTS);
    let step = dt / parts;
    let each = |models| told_every(parts as usize, car, manoeuvre, &mut Kernels::new(models), step);
    let [first, second] = sets;
    Ok(Some(Quiet { step, runs: [each(first)?, each(second)?] }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::{Params, element, list};

    fn drive(manoeuvre: Manoeuvre, dt: f64) -> Run {
        let model = Model::new(&Params::new()).unwrap();
        run(&Car::default(), manoeuvre, [&model; 4], dt).unwrap()
    }

    /// Returns the largest difference in heave between two runs at common instants, relative to the largest heave of the second.
    fn apart(a: &Run, b: &Run, every: [usize; 2]) -> f64 {
        let heave = |r: &Run, n: usize| -> Vec<f64> {
            r.samples.iter().skip(n - 1).step_by(n).map(|s| s.body.position[0]).collect()
        };
        let (a, b) = (heave(a, every[0]), heave(b, every[1]));
        let peak = b.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        a.iter().zip(&b).fold(0.0_f64, |m, (x, y)| m.max((x - y).abs())) / peak
    }

    /// Checks that runs with steps of 2, 1 and 0.25 ms converge toward a run with a finer step.
    #[test]
    fn runs_converge_with_the_step() {
        for manoeuvre in [Manoeuvre::Bump, Manoeuvre::Track] {
            let fine = drive(manoeuvre, 1.25e-4);
            let error = |dt: f64, n: usize| apart(&drive(manoeuvre, dt), &fine, [1, n]);
            let errors = [error(2e-3, 16), error(1e-3, 8), error(2.5e-4, 2)];
            assert!(errors[0] < 0.1 && errors[2] < 0.5 * errors[1], "{manoeuvre:?} {errors:?}");
        }
    }

    #[test]
    fn dampers_take_energy_in_every_manoeuvre() {
        for (name, manoeuvre) in Manoeuvre::ALL {
            let run = drive(manoeuvre, 1e-3);
            for i in 0..4 {
                let taken: f64 = run.samples.iter().map(|s| s.corner[i].force * s.corner[i].velocity * 1e-3).sum();
                assert!(taken > 0.0, "{name} {i}: {taken}");
            }
        }
    }

    #[test]
    fn both_sides_of_a_bump_are_alike_and_a_step_steer_is_not() {
        let bump = drive(Manoeuvre::Bump, 1e-3);
        assert!(bump.samples.iter().all(|s| s.corner[0].force == s.corner[1].force));
        let steer = drive(Manoeuvre::StepSteer, 1e-3);
        let last = steer.samples.last().unwrap();
        assert!(last.corner[0].displacement > 0.005 && last.corner[1].displacement < -0.005);
    }

    /// Checks that the FV curve determines the coupling ratio in motion: its slope at the wheel times the step divided by the wheel mass.
    /// The largest coupling ratio is larger, because friction determines it.
    #[test]
    fn the_slope_in_motion_is_that_of_the_curve() {
        let run = drive(Manoeuvre::Track, 1e-3);
        let car = Car::default();
        let of_slope = |slope: f64| slope * car.motion_ratio.powi(2) * 1e-3 / car.unsprung_mass;
        assert!(run.coupling > run.coupling_moving, "{} {}", run.coupling, run.coupling_moving);
        assert!((of_slope(1e3)..of_slope(2e4)).contains(&run.coupling_moving), "{}", run.coupling_moving);
    }

    #[test]
    fn a_step_that_is_none_is_refused() {
        let model = Model::new(&Params::new()).unwrap();
        for dt in [0.0, -1e-3, f64::NAN, 0.1] {
            assert!(run(&Car::default(), Manoeuvre::Bump, [&model; 4], dt).is_err());
        }
    }

    /// A curve with a friction jump chatters in steps of 1 ms.
    ///
    /// Checks that the damper does not chatter in the shorter steps, and that both runs have samples at the same instants.
    #[test]
    fn a_steep_curve_is_driven_without_its_chatter() {
        let mut steep = Params::new();
        steep.disable_all();
        steep.enable(element!("fv_curve"), true);
        steep.set_list(list!("fv_velocity"), &[-1.0, -0.0005, 0.0, 0.0005, 1.0]).unwrap();
        steep.set_list(list!("fv_force"), &[-1500.0, -60.0, 0.0, 60.0, 1500.0]).unwrap();
        let (steep, smooth) = (Model::new(&steep).unwrap(), Model::new(&Params::new()).unwrap());
        let car = Car::default();
        let drive = |model: &Model| run(&car, Manoeuvre::StepSteer, [model; 4], 1e-3).unwrap();
        // Computes the mean change per step of a damper's force after the vehicle has reached steady cornering.
        let restless = |run: &Run| {
            let force: Vec<f64> = run.samples.iter().rev().take(400).map(|s| s.corner[0].force).collect();
            force.windows(2).map(|w| (w[1] - w[0]).abs()).sum::<f64>() / 399.0
        };
        let host = drive(&steep);
        let hosts = [host.clone(), host.clone()];
        let quiet = without_chatter(&car, Manoeuvre::StepSteer, [[&steep; 4]; 2], &hosts, 1e-3);
        let quiet = quiet.unwrap().unwrap();
        assert!(restless(&host) > 20.0 && restless(&quiet.runs[0]) < 0.05 * restless(&host), "{}", restless(&host));
        let times = |run: &Run| run.samples.iter().map(|s| (1e6 * s.time).round() as i64).collect::<Vec<_>>();
        assert_eq!(times(&host), times(&quiet.runs[0]));
        let gentle = run(&car, Manoeuvre::StepSteer, [&smooth; 4], 1e-4).unwrap();
        assert!(gentle.coupling < RINGS, "{}", gentle.coupling);
        let gentle = [gentle.clone(), gentle];
        assert!(without_chatter(&car, Manoeuvre::StepSteer, [[&smooth; 4]; 2], &gentle, 1e-4).unwrap().is_none());
    }
}
