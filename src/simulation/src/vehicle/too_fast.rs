//! Search for the cause of a vehicle simulation that becomes unstable at its step.
//!
//! The cause is a part of the vehicle with too high a frequency for the step, or a damper whose FV curve is too steep.
//!
//! Consider a mass m on a stiffness k in semi-implicit steps h. In each step, its damper with the slope c has the force of the preceding
//! step. The motion, with the displacement x and the velocity v before the step and x' and v' after it,
//!
//! ```text
//! v' = v − (h/m)(k x + c v),   x' = x + h v'
//! ```
//!
//! grows if 2 c h/m + k h²/m > 4. The first term is the contribution of the damper, the second term that of the springs. A simulation of
//! the whole vehicle finds the longest stable step, because the masses are coupled. Due to the coupling, the effective mass of each part is
//! smaller than its own mass.

use super::{Body, Car};
use dashpot_messages::format_number;
use std::fmt;

/// Cause of the instability.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Blame {
    /// A mass on its springs, regardless of the damper.
    Part {
        /// Name in a file and value of the oscillating mass or inertia.
        mass: (&'static str, f64),
        /// Name in a file and value, N/m, of the stiffest spring on that mass.
        spring: (&'static str, f64),
    },
    /// The delayed coupling of damper force and motion.
    Damper {
        /// Damping of the damper at the wheel, N s/m.
        damping: f64,
        /// Name in a file and value of the mass that the damper moves.
        mass: (&'static str, f64),
    },
    /// Neither a part nor the damper. The step is short enough, so the large motion follows from the parameters of the vehicle.
    Neither,
}

/// Cause of an unstable run, with its step and the longest stable step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooFast {
    /// Cause of the instability.
    pub blame: Blame,
    /// Step of the run, s.
    pub step: f64,
    /// Longest step that is safely stable, s. If the step is not the cause, this is the step of the run.
    pub longest: f64,
}

/// Ratio of the reported step to the longest stable step.
///
/// Near the stability limit, a wheel that lifts off and lands gains energy. With tires of 1e8 to 1e9 N/m and dampers of 20 to 1500 N s/m,
/// no maneuver became unstable up to a ratio of 0.7. From 0.8 on, some maneuvers became unstable.
const ROOM: f64 = 0.7;

/// Shortest allowed step of a vehicle, s.
pub const SHORTEST_STEP: f64 = 1e-4;

/// Oscillation mode of a vehicle: its mass or inertia, the stiffness and damper slope that act on it, and its stiffest spring.
struct Way {
    mass: (&'static str, f64),
    stiffness: f64,
    slope: f64,
    spring: (&'static str, f64),
}

impl Way {
    /// Returns the contributions of the damper and the springs to the stability criterion. The motion grows if their sum exceeds 1.
    fn shares(&self, step: f64) -> [f64; 2] {
        [self.slope * step / (2.0 * self.mass.1), self.stiffness * step * step / (4.0 * self.mass.1)]
    }
}

impl Car {
    /// Returns whether a disturbance of the vehicle grows in steps of `step`, s.
    ///
    /// `slope` is the derivative of the damper forces with respect to velocity at the wheel, N s/m. The damper forces are constant over a
    /// step.
    fn swings_up(&self, slope: f64, step: f64) -> bool {
        // The disturbance excites all modes. It is so small that every tire stays on the road.
        let mut body = Body { position: [1e-9, 2e-9, 3e-9], wheel: [1e-9, -2e-9, 3e-9, -5e-9], ..Body::default() };
        let begin = self.energy(&body);
        for _ in 0..3000 {
            let force = std::array::from_fn(|i| slope * self.stroke(&body, i)[1]);
            // At this speed, 1e9 m/s, the tires have almost no side force.
            self.step(&mut body, step, 1e9, 0.0, [0.0; 4], force);
            // The energy of a stable vehicle stays below a small multiple of its initial value.
            if !(self.energy(&body) < 1e6 * begin) {
                return true;
            }
        }
        false
    }

    /// Returns all oscillation modes for dampers with the derivative `slope` at the wheel, N s/m.
    fn ways(&self, slope: f64) -> Vec<Way> {
        const SPRING: [&str; 2] = ["front_spring", "rear_spring"];
        const ANTI_ROLL: [&str; 2] = ["front_anti_roll", "rear_anti_roll"];
        // Name, value and multiplicity of a spring.
        type Spring = (&'static str, f64, f64);
        let stiffest = |springs: &[Spring]| {
            let most = springs.iter().max_by(|a, b| (a.1 * a.2).total_cmp(&(b.1 * b.2)));
            most.map_or(("tyre", self.tyre), |(name, value, _)| (*name, *value))
        };
        let mut ways = Vec::new();
        for axle in 0..2 {
            // If both wheels of an axle move in opposite directions, the anti-roll bar of the axle deflects twice as much.
            let on: [Spring; 3] = [
                ("tyre", self.tyre, 1.0),
                (SPRING[axle], self.spring[axle], 1.0),
                (ANTI_ROLL[axle], self.anti_roll[axle], 2.0),
            ];
            let spring = stiffest(&on);
            let stiffness = on.iter().map(|(_, value, times)| value * times).sum();
            ways.push(Way { mass: ("unsprung_mass", self.unsprung_mass), stiffness, slope, spring });
        }
        // The modes of the body are heave, roll and pitch. In each of them, the springs of the corners act at their lever arms.
        let arms = |axle: usize| [1.0, 0.5 * self.track, self.axle[axle]];
        let masses =
            [("sprung_mass", self.sprung_mass), ("roll_inertia", self.inertia[0]), ("pitch_inertia", self.inertia[1])];
        for (k, mass) in masses.into_iter().enumerate() {
            let (mut stiffness, mut damping, mut springs) = (0.0, 0.0, Vec::<Spring>::new());
            for axle in 0..2 {
                let arm = arms(axle)[k].powi(2);
                let bar = if k == 1 { 2.0 } else { 0.0 };
                stiffness += 2.0 * arm * (self.spring[axle] + bar * self.anti_roll[axle]);
                damping += 2.0 * arm * slope;
                springs.extend([
                    (SPRING[axle], self.spring[axle], arm),
                    (ANTI_ROLL[axle], self.anti_roll[axle], bar * arm),
                ]);
            }
            let spring = stiffest(&springs);
            ways.push(Way { mass, stiffness, slope: damping, spring });
        }
        ways
    }
}

/// Finds the cause if a vehicle becomes unstable in steps of `step`, s.
///
/// `slope` is the largest derivative of the damper forces with respect to velocity at the wheel, N s/m.
pub fn too_fast(car: &Car, slope: f64, step: f64) -> TooFast {
    if !car.swings_up(slope, step) {
        return TooFast { blame: Blame::Neither, step, longest: step };
    }
    let (mut quiet, mut longest) = (0.0, step);
    for _ in 0..20 {
        let half = 0.5 * (quiet + longest);
        *(if car.swings_up(slope, half) { &mut longest } else { &mut quiet }) = half;
    }
    let ways = car.ways(slope);
    let sum = |way: &Way| way.shares(step).iter().sum::<f64>();
    let blame = ways.iter().max_by(|a, b| sum(a).total_cmp(&sum(b))).map_or(Blame::Neither, |way| {
        let [damper, springs] = way.shares(step);
        if damper > springs {
            Blame::Damper { damping: slope, mass: way.mass }
        } else {
            Blame::Part { mass: way.mass, spring: way.spring }
        }
    });
    TooFast { blame, step, longest: ROOM * quiet }
}

/// Rounds a step down to two significant digits.
fn shorter(step: f64) -> f64 {
    let digit = libm::pow(10f64, libm::log10(step).floor() - 1.0);
    (step / digit).floor() * digit
}

impl fmt::Display for TooFast {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (step, longest) = (1e3 * self.step, 1e3 * shorter(self.longest));
        let unit = |name: &str| if name.ends_with("inertia") { "kg m²" } else { "kg" };
        match self.blame {
            Blame::Part { mass: (name, mass), spring: (spring, stiffness) } => write!(
                f,
                "{name} {} {} on {spring} {} N/m swings faster than steps of {step} ms follow, whatever the damper does; look at \
                 these two numbers of the vehicle",
                format_number(mass),
                unit(name),
                format_number(stiffness)
            )?,
            Blame::Damper { damping: slope, mass: (name, mass) } => write!(
                f,
                "the exchange of damper force and motion is unstable in steps of {step} ms: the dampers' slope of {slope:.0} N s/m at the wheel \
                 is too steep for {name} {} {}; look at the damper's FV curve",
                format_number(mass),
                unit(name)
            )?,
            Blame::Neither => {
                return write!(
                    f,
                    "a damper moved faster than 50 m/s or farther than 1 m. Steps of {step} ms are short enough for masses, springs, tyres and \
                     dampers, so look at the numbers of the vehicle"
                );
            }
        }
        if self.longest < SHORTEST_STEP {
            return write!(
                f,
                " (no step is short enough: a vehicle is driven in steps of {} ms at least)",
                1e3 * SHORTEST_STEP
            );
        }
        write!(f, ", or take steps of {longest:.3} ms or less")
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Manoeuvre, VehicleError, run};
    use super::*;
    use dashpot_core::{Model, Params, element, list};

    /// Makes a damper with a constant slope, N s/m.
    fn straight(slope: f64) -> Model {
        let mut params = Params::new();
        params.disable_all();
        params.enable(element!("fv_curve"), true);
        params.set_list(list!("fv_velocity"), &[-1.0, 0.0, 1.0]).unwrap();
        params.set_list(list!("fv_force"), &[-slope, 0.0, slope]).unwrap();
        Model::new(&params).unwrap()
    }

    fn left_the_road(car: &Car, damper: &Model, step: f64) -> Option<TooFast> {
        match run(car, Manoeuvre::Track, [damper; 4], step) {
            Ok(_) => None,
            Err(VehicleError::Unstable(_, why)) => Some(why),
            Err(other) => panic!("{other}"),
        }
    }

    /// Checks that the reported part is the part that the test made too fast for the step.
    ///
    /// The vehicle must be stable with the reported step. With a step slightly above the stability limit, a disturbance must grow.
    #[test]
    fn the_part_that_is_too_fast_is_named_with_the_longest_step() {
        let usual = Car::default();
        let tyre = ("tyre", "unsprung_mass");
        for (car, slope, named) in [
            (Car { tyre: 1e9, ..usual }, 1500.0, Some(tyre)),
            (Car { tyre: 4e8, ..usual }, 20.0, Some(tyre)),
            (Car { unsprung_mass: 0.05, ..usual }, 10.0, Some(tyre)),
            (Car { spring: [5e8, 26e3], ..usual }, 1500.0, Some(("front_spring", "unsprung_mass"))),
            (Car { anti_roll: [12e3, 3e8], ..usual }, 1500.0, Some(("rear_anti_roll", "unsprung_mass"))),
            (Car { inertia: [0.005, 2200.0, 2500.0], ..usual }, 1.0, Some(("rear_spring", "roll_inertia"))),
            (usual, 2.5e5, None),
        ] {
            let damper = straight(slope);
            let why = left_the_road(&car, &damper, 1e-3).unwrap_or_else(|| panic!("{named:?} stays on the road"));
            match (why.blame, named) {
                (Blame::Part { mass, spring }, Some(named)) => assert_eq!((spring.0, mass.0), named),
                (Blame::Damper { mass, damping: slope }, None) => {
                    assert_eq!(mass.0, "unsprung_mass");
                    assert!((slope / (2.5e5 * 0.81) - 1.0).abs() < 0.01, "{slope}");
                }
                (blame, named) => panic!("{blame:?} and not {named:?}"),
            }
            assert!(left_the_road(&car, &damper, why.longest).is_none(), "{named:?} in {} s", why.longest);
            assert!(car.swings_up(slope * 0.81, 1.05 / ROOM * why.longest), "{named:?} beyond {} s", why.longest);
        }
    }

    #[test]
    fn words_name_numbers_and_step() {
        let told = too_fast(&Car { tyre: 1e9, ..Car::default() }, 2000.0, 1e-3).to_string();
        assert!(told.contains("unsprung_mass 40 kg on tyre 1e9 N/m") && told.contains("0.270 ms or less"), "{told}");
        let told = too_fast(&Car::default(), 2e5, 1e-3).to_string();
        assert!(told.contains("200000 N s/m") && told.contains("unsprung_mass 40 kg"), "{told}");
        let told = too_fast(&Car { tyre: 1e12, ..Car::default() }, 2000.0, 1e-3).to_string();
        assert!(told.contains("no step is short enough"), "{told}");
        let told = too_fast(&Car::default(), 2000.0, 1e-3).to_string();
        assert!(told.contains("farther than 1 m"), "{told}");
    }
}
