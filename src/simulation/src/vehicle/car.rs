//! Masses, springs and tires of a vehicle, and their equations of motion.
//!
//! Axes: x forward, y to the left, z up. The order of the corners is L1, R1, L2, R2. All heights are relative to the static position, and
//! all suspension forces are relative to the static forces. So the vehicle starts in equilibrium.

use dashpot_messages::format_number;

/// Masses, dimensions, springs and tires of a vehicle.
#[derive(Clone, Copy, Debug)]
pub struct Car {
    /// Sprung mass, kg.
    pub sprung_mass: f64,
    /// Mass of a wheel with its part of the suspension, kg.
    pub unsprung_mass: f64,
    /// Roll, pitch and yaw inertia, kg m².
    pub inertia: [f64; 3],
    /// Distances of the front axle and the rear axle from the center of gravity, m.
    pub axle: [f64; 2],
    /// Track, m.
    pub track: f64,
    /// Height of the center of gravity above the roll axis, m.
    pub roll_arm: f64,
    /// Spring rate at the wheel, front and rear, N/m.
    pub spring: [f64; 2],
    /// Anti-roll rate at the wheel, front and rear, N/m. It refers to the difference of the strokes of an axle's two wheels.
    pub anti_roll: [f64; 2],
    /// Vertical tire stiffness, N/m.
    pub tyre: f64,
    /// Cornering stiffness of a tire, N/rad.
    pub cornering: f64,
    /// Friction coefficient between tire and road.
    pub grip: f64,
    /// Ratio of damper travel to wheel travel.
    pub motion_ratio: f64,
}

/// Parameter of a vehicle with its name and unit, for files and reports.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarValue {
    /// Name of the number in a file.
    pub name: &'static str,
    /// Value of the number, in `unit`.
    pub value: f64,
    /// Unit of `value`.
    pub unit: &'static str,
    /// Lowest and highest value that a file may state, in `unit`.
    pub bounds: (f64, f64),
}

/// Names, units and bounds of the numbers of a vehicle, in the order of files and reports.
///
/// The bounds include a model car of 1 kg and a haul truck of 600 t with margins. A vehicle may have no anti-roll bars and no roll arm, so
/// the lower bounds of these numbers are 0.
///
/// Test: `numbers_of_no_vehicle_are_rejected_with_their_bounds`.
const ROWS: [(&str, &str, (f64, f64)); 17] = [
    ("sprung_mass", "kg", (0.1, 1e6)),
    ("unsprung_mass", "kg", (1e-3, 1e5)),
    // The bounds of an inertia are the bounds of the sprung mass times the square of a radius of gyration, 1 cm to 10 m.
    ("roll_inertia", "kg m²", (1e-5, 1e8)),
    ("pitch_inertia", "kg m²", (1e-5, 1e8)),
    ("yaw_inertia", "kg m²", (1e-5, 1e8)),
    ("front_axle_distance", "m", (0.01, 30.0)),
    ("rear_axle_distance", "m", (0.01, 30.0)),
    ("track", "m", (0.01, 30.0)),
    ("roll_arm", "m", (0.0, 10.0)),
    // No spring is stiffer than a steel wheel on a rail, 1e9 N/m.
    ("front_spring", "N/m", (0.1, 1e9)),
    ("rear_spring", "N/m", (0.1, 1e9)),
    ("front_anti_roll", "N/m", (0.0, 1e9)),
    ("rear_anti_roll", "N/m", (0.0, 1e9)),
    ("tyre", "N/m", (0.1, 1e9)),
    // The cornering stiffness is 5 to 60 times the wheel load, N/rad, and the bounds leave a factor of 10.
    ("cornering", "N/rad", (0.1, 1e9)),
    // The friction coefficient is 0.05 on ice and reaches 5 with the slicks of dragsters.
    ("grip", "-", (1e-3, 10.0)),
    // The motion ratio of a suspension with pushrods is rarely outside 0.3 to 2.
    ("motion_ratio", "-", (0.01, 10.0)),
];

/// Reason why a file does not describe a vehicle.
#[derive(Debug, thiserror::Error)]
pub enum CarError {
    /// The file is not TOML, or a value is not a number.
    #[error("{0}")]
    Toml(String),
    /// A name does not belong to a vehicle.
    #[error("line {line}: a vehicle has no {name:?}; it has {}", Car::default().values().map(|v| v.name).join(", "))]
    Unknown {
        /// Name in the file.
        name: String,
        /// Line number, from 1.
        line: usize,
    },
    /// A value is out of range.
    #[error(
        "line {line}: {name} = {} {unit} is that of no vehicle; give {} to {} {unit}, and look at the unit",
        format_number(*value),
        format_number(bounds.0),
        format_number(bounds.1)
    )]
    Range {
        /// Name of the number.
        name: &'static str,
        /// Value of the number.
        value: f64,
        /// Unit of the number.
        unit: &'static str,
        /// Lowest and highest accepted value, in `unit`.
        bounds: (f64, f64),
        /// Line number, from 1.
        line: usize,
    },
}

impl Car {
    /// Reads a vehicle from a file of `name = number` lines in SI units. The passenger car ([`Car::default`]) supplies the numbers that the
    /// file omits.
    ///
    /// # Errors
    /// Returns a [`CarError`] with the line.
    pub fn read(text: &str) -> Result<Car, CarError> {
        let table: toml::Table =
            toml::from_str(text).map_err(|e| CarError::Toml(e.to_string().trim_end().to_owned()))?;
        let mut car = Car::default();
        for (name, value) in &table {
            let is_it = |line: &&str| line.split('=').next().is_some_and(|key| key.trim().trim_matches('"') == name);
            let line = text.lines().position(|l| is_it(&l)).map_or(1, |k| k + 1);
            let Some(known) = car.values().into_iter().find(|v| v.name == name) else {
                return Err(CarError::Unknown { name: name.clone(), line });
            };
            let number = value.as_float().or_else(|| value.as_integer().map(|i| i as f64));
            let Some(number) = number else {
                return Err(CarError::Toml(format!("line {line}: {name} is {value}, which is no number")));
            };
            let bounds = known.bounds;
            if !(bounds.0..=bounds.1).contains(&number) {
                return Err(CarError::Range { name: known.name, value: number, unit: known.unit, bounds, line });
            }
            *car.place_of(known.name) = number;
        }
        Ok(car)
    }

    /// Returns every number with its name and unit, in the order of files and reports.
    pub fn values(&self) -> [CarValue; 17] {
        let mut car = *self;
        ROWS.map(|(name, unit, bounds)| CarValue { name, value: *car.place_of(name), unit, bounds })
    }

    /// Returns a mutable reference to the number with this name. Any unknown name refers to the motion ratio, so callers check names first.
    fn place_of(&mut self, name: &str) -> &mut f64 {
        match name {
            "sprung_mass" => &mut self.sprung_mass,
            "unsprung_mass" => &mut self.unsprung_mass,
            "roll_inertia" => &mut self.inertia[0],
            "pitch_inertia" => &mut self.inertia[1],
            "yaw_inertia" => &mut self.inertia[2],
            "front_axle_distance" => &mut self.axle[0],
            "rear_axle_distance" => &mut self.axle[1],
            "track" => &mut self.track,
            "roll_arm" => &mut self.roll_arm,
            "front_spring" => &mut self.spring[0],
            "rear_spring" => &mut self.spring[1],
            "front_anti_roll" => &mut self.anti_roll[0],
            "rear_anti_roll" => &mut self.anti_roll[1],
            "tyre" => &mut self.tyre,
            "cornering" => &mut self.cornering,
            "grip" => &mut self.grip,
            _ => &mut self.motion_ratio,
        }
    }
}

impl Default for Car {
    /// Returns a passenger car.
    fn default() -> Car {
        Car {
            sprung_mass: 1400.0,
            unsprung_mass: 40.0,
            inertia: [500.0, 2200.0, 2500.0],
            axle: [1.2, 1.5],
            track: 1.55,
            roll_arm: 0.45,
            spring: [24e3, 26e3],
            anti_roll: [12e3, 6e3],
            tyre: 220e3,
            cornering: 60e3,
            grip: 1.0,
            motion_ratio: 0.9,
        }
    }
}

/// Positions and velocities of a vehicle.
#[derive(Clone, Copy, Debug, Default)]
pub struct Body {
    /// Heave, roll (left side up) and pitch (nose down) from the static position: m, rad, rad.
    pub position: [f64; 3],
    /// Velocities of heave, roll and pitch, m/s, rad/s, rad/s.
    pub velocity: [f64; 3],
    /// Vertical displacements of the wheels from the static position, m, up positive.
    pub wheel: [f64; 4],
    /// Velocities of the wheels, m/s.
    pub wheel_velocity: [f64; 4],
    /// Velocity to the left, m/s, and yaw rate, rad/s.
    pub lateral: [f64; 2],
    /// Heave acceleration, m/s².
    pub heave_acceleration: f64,
    /// Lateral acceleration, m/s².
    pub lateral_acceleration: f64,
}

const GRAVITY: f64 = 9.81;

impl Car {
    /// Returns the position of a corner: forward and to the left of the center of gravity, m.
    pub fn place(&self, corner: usize) -> [f64; 2] {
        let x = if corner < 2 { self.axle[0] } else { -self.axle[1] };
        [x, if corner.is_multiple_of(2) { 0.5 * self.track } else { -0.5 * self.track }]
    }

    /// Returns the static load of a wheel, N.
    fn load(&self, corner: usize) -> f64 {
        let wheelbase = self.axle[0] + self.axle[1];
        let share = self.axle[if corner < 2 { 1 } else { 0 }] / wheelbase;
        GRAVITY * (0.5 * share * self.sprung_mass + self.unsprung_mass)
    }

    /// Returns the stroke of a suspension, m, and its rate, m/s, extension positive, at the wheel.
    pub fn stroke(&self, body: &Body, corner: usize) -> [f64; 2] {
        let [x, y] = self.place(corner);
        let above = |q: &[f64; 3]| q[0] + y * q[1] - x * q[2];
        [above(&body.position) - body.wheel[corner], above(&body.velocity) - body.wheel_velocity[corner]]
    }

    /// Advances the vehicle by one step of `dt`, s. The inputs are the forward speed, m/s, the steering angle, rad, and the road heights
    /// under the wheels, m.
    ///
    /// The damper forces, N, are relative to the static forces and act at the wheel, tension positive. The step is semi-implicit: it
    /// updates velocities first, then positions.
    pub fn step(&self, body: &mut Body, dt: f64, speed: f64, steer: f64, road: [f64; 4], damper: [f64; 4]) {
        let stroke: [f64; 4] = std::array::from_fn(|i| self.stroke(body, i)[0]);
        let (mut heave, mut roll, mut pitch, mut side, mut yaw) = (0.0, 0.0, 0.0, 0.0, 0.0);
        let mut wheel = [0.0; 4];
        for i in 0..4 {
            let ([x, y], axle, other) = (self.place(i), i / 2, i ^ 1);
            // The force `lift` lifts the body and presses the wheel down.
            let lift = -self.spring[axle] * stroke[i] - self.anti_roll[axle] * (stroke[i] - stroke[other]) - damper[i];
            let load = (self.load(i) + self.tyre * (road[i] - body.wheel[i])).max(0.0);
            wheel[i] = (load - self.load(i) - lift) / self.unsprung_mass;
            let slip =
                if axle == 0 { steer } else { 0.0 } - libm::atan((body.lateral[0] + x * body.lateral[1]) / speed);
            let force = if load > 0.0 {
                let limit = self.grip * load;
                limit * libm::tanh(self.cornering * slip / limit)
            } else {
                0.0
            };
            heave += lift;
            roll += y * lift;
            pitch -= x * lift;
            side += force;
            yaw += x * force;
        }
        let mass = self.sprung_mass + 4.0 * self.unsprung_mass;
        body.lateral_acceleration = side / mass;
        body.heave_acceleration = heave / self.sprung_mass;
        roll += self.sprung_mass * self.roll_arm * body.lateral_acceleration;
        let rate = [body.heave_acceleration, roll / self.inertia[0], pitch / self.inertia[1]];
        for (k, rate) in rate.iter().enumerate() {
            body.velocity[k] += dt * rate;
            body.position[k] += dt * body.velocity[k];
        }
        for (i, wheel) in wheel.iter().enumerate() {
            body.wheel_velocity[i] += dt * wheel;
            body.wheel[i] += dt * body.wheel_velocity[i];
        }
        body.lateral[0] += dt * (body.lateral_acceleration - speed * body.lateral[1]);
        body.lateral[1] += dt * yaw / self.inertia[2];
    }

    /// Returns the energy of the vehicle, J, relative to the static position on a flat road. It includes heave, pitch, roll, wheels,
    /// springs and tires.
    pub fn energy(&self, body: &Body) -> f64 {
        let kinetic: f64 = self.sprung_mass * body.velocity[0].powi(2)
            + self.inertia[0] * body.velocity[1].powi(2)
            + self.inertia[1] * body.velocity[2].powi(2)
            + body.wheel_velocity.iter().map(|v| self.unsprung_mass * v * v).sum::<f64>();
        let potential: f64 = (0..4)
            .map(|i| {
                let (stroke, other) = (self.stroke(body, i)[0], self.stroke(body, i ^ 1)[0]);
                self.spring[i / 2] * stroke * stroke
                    + 0.5 * self.anti_roll[i / 2] * (stroke - other).powi(2)
                    + self.tyre * body.wheel[i].powi(2)
            })
            .sum();
        0.5 * (kinetic + potential)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks that free oscillations lose the energy that the dampers absorb, up to an error of the order of the step.
    #[test]
    fn energy_goes_where_the_dampers_take_it() {
        let car = Car::default();
        let error = |dt: f64| {
            let mut body = Body { position: [0.03, 0.02, 0.01], ..Body::default() };
            let before = car.energy(&body);
            let mut taken = 0.0;
            for _ in 0..(1.0 / dt) as usize {
                let rate: [f64; 4] = std::array::from_fn(|i| car.stroke(&body, i)[1]);
                let force = rate.map(|v| 1500.0 * v);
                // At this speed, 1e9 m/s, the side forces of the tires are negligible and cause no roll.
                car.step(&mut body, dt, 1e9, 0.0, [0.0; 4], force);
                let after: [f64; 4] = std::array::from_fn(|i| car.stroke(&body, i)[1]);
                taken += dt * (0..4).map(|i| force[i] * 0.5 * (rate[i] + after[i])).sum::<f64>();
            }
            ((before - car.energy(&body) - taken) / before).abs()
        };
        let (coarse, fine) = (error(1e-3), error(2.5e-4));
        assert!(coarse < 0.02 && fine < 0.4 * coarse, "{coarse} {fine}");
    }

    #[test]
    fn a_vehicle_on_a_flat_road_stands_still() {
        let (car, mut body) = (Car::default(), Body::default());
        for _ in 0..1000 {
            car.step(&mut body, 1e-3, 20.0, 0.0, [0.0; 4], [0.0; 4]);
        }
        assert!(body.position.iter().chain(&body.wheel).all(|x| x.abs() < 1e-12), "{body:?}");
    }

    /// Checks that the yaw rate in steady cornering is that of the linear single-track model, and that the body rolls outward.
    #[test]
    fn steady_cornering_is_that_of_the_single_track_model() {
        let (car, mut body) = (Car::default(), Body::default());
        let (speed, steer) = (20.0, 0.005);
        for _ in 0..6000 {
            let force = std::array::from_fn(|i| 1500.0 * car.stroke(&body, i)[1]);
            car.step(&mut body, 1e-3, speed, steer, [0.0; 4], force);
        }
        let ([a, b], c) = (car.axle, 2.0 * car.cornering);
        let mass = car.sprung_mass + 4.0 * car.unsprung_mass;
        let understeer = mass * (b - a) / (c * (a + b));
        let yaw = speed * steer / (a + b + understeer * speed * speed);
        assert!((body.lateral[1] / yaw - 1.0).abs() < 0.02, "{} {yaw}", body.lateral[1]);
        assert!(body.position[1] > 0.0, "left turn: the left side rises");
    }

    #[test]
    fn numbers_of_no_vehicle_are_rejected_with_their_bounds() {
        for of in Car::default().values() {
            let (low, high) = of.bounds;
            for value in ["1e308", "-1e308", "-1e-308", "nan", "inf", "-inf"] {
                let message = Car::read(&format!("{} = {value}\n", of.name)).unwrap_err().to_string();
                assert!(message.starts_with(&format!("line 1: {} = ", of.name)), "{message}");
                assert!(message.contains(&format!("{} to {}", format_number(low), format_number(high))), "{message}");
                assert!(message.len() < 300, "{message}");
            }
            let read = |value: f64| Car::read(&format!("{} = {value:e}\n", of.name)).is_ok();
            assert!(read(low) && read(high) && !read(1.01 * high) && !read(0.99 * low - 1e-9), "{}", of.name);
            assert_eq!(read(0.0), low == 0.0, "{}", of.name);
            assert_eq!(read(1e-308), low == 0.0, "{}", of.name);
        }
    }

    #[test]
    fn a_vehicle_is_read_by_name() {
        let car = Car::read("sprung_mass = 1800 # kg\nrear_spring = 31e3\nfront_anti_roll = 0\n").unwrap();
        assert_eq!((car.sprung_mass, car.spring, car.anti_roll[0]), (1800.0, [24e3, 31e3], 0.0));
        assert_eq!(Car::read("").unwrap().values(), Car::default().values());
        for (text, wanted) in [
            ("a = 1\n", "line 1: a vehicle has no \"a\"; it has sprung_mass, unsprung_mass"),
            ("track = 1.5\ntyre = 0\n", "line 2: tyre = 0 N/m is that of no vehicle; give 0.1 to 1e9 N/m"),
            ("grip = \"wet\"\n", "line 1: grip is \"wet\""),
            ("track = nan\n", "track = NaN m"),
            ("track", "TOML parse error at line 1"),
        ] {
            let message = Car::read(text).unwrap_err().to_string();
            assert!(message.contains(wanted), "{text:?}: {message}");
        }
    }
}
