//! Size of a damper relative to that of a passenger car.
//!
//! Priors, starts and bounds of searches come from passenger cars: a mount of 2.5 MN/m, friction of 40 N, a rod of 0.4
//! kg. The values of an instrument damper with 10 N and of a train damper with 20 kN are proportional to their forces.
//! At equal pressures and strokes, force, stiffness, mass and heat all grow with the area of the piston. Therefore, a
//! parameter with a force in its unit is divided by the relative size before the comparison with car values. Lengths,
//! speeds and times are not scaled: clearances, oil films and valves do not grow with the area.

use crate::distribution::Distribution;
use crate::measurement::Artefact;
use dashpot_core::parameter::Number;
use dashpot_core::schema::has_force;
use dashpot_core::{Params, element, list, number};
use dashpot_records::load_cell::OF_CARS;
use dashpot_records::restrict;

/// Force of a typical car damper, N, to which the medians of the priors apply. It is the geometric mean of the force
/// range of cars. The scale of a damper far beyond this range is relative to this typical force. With a scale relative
/// to the end of the range, a weak damper would have the series stiffness of a weak car damper. This stiffness is too
/// high.
const TYPICAL: f64 = 1500.0;
/// Width, as a force ratio, of the transition beyond the force range of cars. In the transition, the scale changes
/// continuously from 1, so that similar dampers have similar scales.
const PASSAGE: f64 = 3.0;

/// Ratio of a damper's strength to that of a passenger car's damper; it is 1 within the force range of cars.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale(f64);

/// Returns the largest force of a model, N: the sum of curve, friction and gas.
///
/// Records of few tests do not separate these three forces, so only their sum is a measure of size.
pub fn largest_force(params: &Params) -> f64 {
    let curve = if params.is_on(element!("fv_curve")) { params.list(list!("fv_force")) } else { &[] };
    let curve = curve.iter().fold(0.0f64, |most, force| most.max(force.abs()));
    let parallel = [
        (element!("coulomb_friction"), number!("coulomb_force")),
        (element!("stribeck_friction"), number!("stribeck_coulomb_force")),
        (element!("presliding_friction"), number!("presliding_force")),
        (element!("gas_preload"), number!("gas_force")),
    ];
    let parallel = parallel.into_iter().filter(|(element, _)| params.is_on(*element));
    curve + parallel.map(|(_, force)| params.number(force).abs()).sum::<f64>()
}

impl Scale {
    /// Scale of passenger cars.
    pub const CAR: Scale = Scale(1.0);

    /// Returns the scale of a damper whose largest force is `largest`, N.
    pub fn of_force(largest: f64) -> Scale {
        let (low, high) = OF_CARS;
        // The size is unknown for a model without a force.
        if !(largest > 0.0 && largest.is_finite()) || (low..=high).contains(&largest) {
            return Scale::CAR;
        }
        let beyond = largest / restrict(largest, low, high);
        let share = (libm::log(beyond).abs() / libm::log(PASSAGE)).min(1.0);
        Scale(libm::pow(largest / TYPICAL, share))
    }

    /// Returns the scale of a model's damper.
    pub fn from_params(params: &Params) -> Scale {
        Scale::of_force(largest_force(params))
    }

    /// Returns whether the scale is that of cars.
    pub fn is_car(self) -> bool {
        self == Scale::CAR
    }

    /// Returns the factor from car dampers to this damper for forces and quantities with a force in their unit:
    /// stiffness, damping, mass, heat.
    pub fn force(self) -> f64 {
        self.0
    }

    /// Returns the factor from car dampers to this damper for a parameter of the model.
    pub fn of_number(self, number: Number) -> f64 {
        if self.is_car() {
            return 1.0;
        }
        if number == number!("fsd_flow") || number == number!("bypass_flow") {
            // The parameter is the flow through an orifice at 1 kN. At a hundredth of the force, an equal orifice has a
            // tenth of the flow. For equal flow, the orifice needs ten times the flow at 1 kN.
            libm::pow(self.0, -0.5)
        } else {
            self.of_unit(number.parameter().unit)
        }
    }

    fn of_unit(self, unit: &str) -> f64 {
        if has_force(unit) { self.0 } else { 1.0 }
    }

    /// Returns the factor from car dampers to this damper for a parameter of the rig, whose load cell and fixtures are
    /// chosen for the damper.
    pub fn of_artefact(self, artefact: Artefact) -> f64 {
        self.of_unit(artefact.unit())
    }

    /// Returns the bounds of a search: the scaled bounds for a car damper, within the bounds of the parameter.
    pub fn reach(self, number: Number) -> (f64, f64) {
        let ((low, high), (from, to)) = (number.bounds(), number.parameter().of_a_car);
        let factor = self.of_number(number);
        (low.max(from * factor), high.min(to * factor))
    }

    /// Scales the distribution of a parameter from car dampers to this damper.
    pub fn scale_distribution(self, number: Number, of_cars: Distribution) -> Distribution {
        let factor = self.of_number(number);
        match of_cars {
            Distribution::Size(median, spread) => Distribution::Size(factor * median, spread),
            Distribution::Strength(median, spread) => Distribution::Strength(factor * median, spread),
            Distribution::Place(mean, deviation) => Distribution::Place(factor * mean, factor * deviation),
            Distribution::Skewed(mode, below, above) => {
                Distribution::Skewed(factor * mode, factor * below, factor * above)
            }
        }
    }

    /// Scales a model of this damper to a car damper.
    pub fn as_car(self, params: &Params) -> Params {
        let mut as_car = *params;
        if self.is_car() {
            return as_car;
        }
        for number in dashpot_core::parameter::table().filter_map(|row| Number::try_from(row).ok()) {
            let _ = as_car.set(number, number.inside(params.number(number) / self.of_number(number)));
        }
        for forces in [list!("fv_force"), list!("spring_force")] {
            let forces_of_cars: Vec<f64> = params.list(forces).iter().map(|force| force / self.0).collect();
            let _ = as_car.set_list(forces, &forces_of_cars);
        }
        as_car
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::parameter::Element;
    use dashpot_core::{Input, Model, State, step};

    fn with_forces(factor: f64) -> Params {
        let mut params = Params::new();
        let forces: Vec<f64> = params.list(list!("fv_force")).iter().map(|force| factor * force).collect();
        params.set_list(list!("fv_force"), &forces).unwrap();
        params.disable_all();
        params.enable(element!("fv_curve"), true);
        params
    }

    #[test]
    fn what_is_said_of_cars_is_not_changed() {
        for factor in [0.1, 1.0, 2.0] {
            let scale = Scale::from_params(&with_forces(factor));
            assert!(scale.is_car(), "{factor}: {scale:?}");
            assert_eq!(scale.reach(number!("internal_mass")), (0.005, 20.0));
        }
    }

    /// A new element with a force of constant size would otherwise be missing from the size of the damper.
    #[test]
    fn every_force_that_hardly_depends_on_the_motion_counts_in_the_largest_force() {
        let mut counted = 0;
        for element in Element::all() {
            let mut params = Params::new();
            params.disable_all();
            params.enable(element, true);
            // Some elements are part of another one and need it.
            let Ok(model) = Model::new(&params) else { continue };
            let force = |v: f64| {
                let (mut state, mut force) = (State::ZERO, 0.0);
                for k in 1..=50 {
                    let (next, output) = step(&model, &state, &Input::motion(1e-3 * f64::from(k) * v, v), 1e-3);
                    (state, force) = (next, output.force);
                }
                force
            };
            let [slow, fast] = [0.2, 0.4].map(force);
            if slow.abs() > 1.0 && (fast / slow - 1.0).abs() < 0.1 {
                counted += 1;
                assert!(largest_force(&params) > 0.5 * slow.abs(), "{}: {slow} N", element.name());
            } else {
                let name = element.name();
                assert!(largest_force(&params) == 0.0 || name == "fv_curve", "{name}: {slow} and {fast} N");
            }
        }
        assert!(counted > 3, "{counted} elements");
    }

    #[test]
    fn what_has_a_force_in_its_unit_grows_with_the_damper_and_nothing_else() {
        let (small, large) = (Scale::of_force(15.0), Scale::of_force(30_000.0));
        for (scale, factor) in [(small, 0.01), (large, 20.0)] {
            for number in ["series_stiffness", "internal_mass", "coulomb_force", "gas_warming_rate", "heat_capacity"] {
                let of = scale.of_number(Number::find(number).unwrap());
                assert!((of / factor - 1.0).abs() < 1e-12, "{number}: {of}");
            }
            for number in ["coulomb_steepness", "presliding_length", "gas_thermal_time", "oil_shortening"] {
                assert_eq!(scale.of_number(Number::find(number).unwrap()), 1.0, "{number}");
            }
        }
        assert_eq!(Scale::of_force(0.0), Scale::CAR);
    }

    #[test]
    fn a_model_as_of_a_car_has_the_forces_of_a_car() {
        for factor in [1e-3, 0.01, 0.08, 3.0, 30.0] {
            let model = with_forces(factor);
            let scale = Scale::from_params(&model);
            assert!(!scale.is_car(), "{factor}");
            assert!(Scale::from_params(&scale.as_car(&model)).is_car(), "{factor}: {scale:?}");
        }
    }

    #[test]
    fn a_damper_that_is_hardly_weaker_is_hardly_judged_otherwise() {
        let mut force = 1.0;
        while force < 1e5 {
            let (here, next) = (Scale::of_force(force).force(), Scale::of_force(1.01 * force).force());
            assert!((next / here).ln().abs() < 0.1, "{force}: {here}, {next}");
            force *= 1.01;
        }
    }
}
