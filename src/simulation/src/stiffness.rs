//! Stiffness of the states of a damper, for hosts whose own solver integrates them.
//!
//! `dashpot_step` is stable for steps of any length. A host may also integrate the states itself with an explicit method
//! (`dashpot_evaluate`, an FMU in model exchange). Such an integration is stable only if the product of step and fastest rate lies in the
//! stability region of the method. Otherwise the force may be wrong without an error message.

use dashpot_core::evaluate::partials;
use dashpot_core::family::Definition;
use dashpot_core::{Input, Model, Params};
use nalgebra::DMatrix;

/// Largest product of step and rate at which the classical Runge–Kutta method of fourth order is stable on the negative real axis.
///
/// Hairer & Wanner, *Solving Ordinary Differential Equations II*, IV.2.
const RUNGE_KUTTA: f64 = 2.785;
/// Rate, 1/s, above which the classical Runge–Kutta method is unstable at a typical host step of 1 ms.
const STIFF: f64 = RUNGE_KUTTA / 1e-3;
/// Speeds at which the rates are evaluated in both directions, m/s. They range from standstill, where FV curves are steepest, to a pothole.
const SPEEDS: [f64; 7] = [0.0, 1e-3, 0.01, 0.05, 0.2, 0.5, 1.5];

/// Returns the largest magnitude of an eigenvalue of the states' Jacobian, 1/s, or 0 if no state changes.
pub fn fastest_rate(model: &Model) -> f64 {
    let count = model.states();
    let mut fastest = 0.0f64;
    for velocity in SPEEDS.iter().flat_map(|speed| [*speed, -speed]) {
        let input = Input::motion(0.0, velocity);
        let all = partials(model, &model.steady_state(&input), &input).d_rate_d_state;
        let matrix = DMatrix::from_fn(count, count, |i, j| {
            all.get(i).and_then(|row| row.get(j)).copied().filter(|slope| slope.is_finite()).unwrap_or(0.0)
        });
        let sizes = matrix.complex_eigenvalues();
        fastest = sizes.iter().map(|value| libm::hypot(value.re, value.im)).fold(fastest, f64::max);
    }
    fastest
}

/// Returns the longest stable step, s, of the classical Runge–Kutta method at a rate, 1/s.
pub fn explicit_step(rate: f64) -> f64 {
    RUNGE_KUTTA / rate.max(1e-9)
}

/// Returns the longest step, s, with which the classical Runge–Kutta method can integrate the states of all dampers, at every setting of
/// their grids. The result is at most 1 s.
pub fn longest_explicit_step<D: Copy + Into<Definition>>(all: &[D]) -> f64 {
    let at_each_setting = |damper: &D| {
        let damper: Definition = (*damper).into();
        let grid = damper.axis.grid().to_vec();
        if grid.is_empty() {
            vec![damper.params]
        } else {
            grid.iter().map(|setting| damper.params_at(*setting)).collect()
        }
    };
    all.iter()
        .flat_map(at_each_setting)
        .filter_map(|params| Model::new(&params).ok())
        .map(|model| explicit_step(fastest_rate(&model)))
        .fold(1.0, f64::min)
}

/// Formats a limit with at least two significant digits, so that a small limit does not become 0.
fn in_digits(limit: f64) -> String {
    let digits = (1.0 - libm::log10(limit).floor()).clamp(0.0, 12.0) as usize;
    format!("{limit:.digits$}")
}

/// Returns the text of [`remark`] for a parameter set, or an empty list. The description of an FMU contains this text, because an FMU
/// allows model exchange.
pub fn remarks(params: &Params) -> Vec<String> {
    Model::new(params).ok().and_then(|model| remark(&model)).into_iter().collect()
}

/// Returns a remark for hosts that integrate the states, or `None` if a step of 1 ms is stable.
pub fn remark(model: &Model) -> Option<String> {
    let rate = fastest_rate(model);
    (rate > STIFF).then(|| {
        format!(
            "A solver that integrates the damper's states itself (model exchange, dashpot_evaluate) meets a rate of {rate:.1e} 1/s: an explicit one (Euler, Runge-Kutta) \
             needs steps below {} microseconds, and above them may give a wrong force without an error. Take an implicit solver (CVODE, DASSL, Radau), or \
             dashpot_step and co-simulation, which are stable at every step.",
            in_digits(1e6 * explicit_step(rate))
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::{State, element, evaluate, number};

    fn model(stiffness: f64, mass: f64) -> Model {
        let mut params = Params::new();
        params.set(number!("series_stiffness"), stiffness).unwrap();
        params.set(number!("internal_mass"), mass).unwrap();
        Model::new(&params).unwrap()
    }

    #[test]
    fn the_rate_is_that_of_the_mass_behind_its_spring_and_valves() {
        // The internal mass is overdamped. Its fast rate is at most the slope of the FV curve divided by the mass.
        let model = model(3e6, 0.05);
        let slope = model.elements().paths.fv_curve.evaluate(0.0).derivative;
        let rate = fastest_rate(&model);
        assert!(rate > 0.5 * slope / 0.05, "{rate} {slope}");
        assert!(remark(&model).unwrap().contains("model exchange"));
        assert_eq!(["0.21", "0.0021", "47", "4713"], [0.2085, 0.0021, 47.2, 4712.6].map(in_digits)[..]);
        let mut params = Params::new();
        params.enable(element!("series_compliance"), false);
        assert_eq!(remark(&Model::new(&params).unwrap()), None);
    }

    #[test]
    fn runge_kutta_holds_below_the_step_that_is_told_and_not_far_above_it() {
        let model = model(3e6, 0.05);
        let told = explicit_step(fastest_rate(&model));
        let largest = |dt: f64| {
            let motion = |t: f64| Input::motion(0.002 * libm::sin(60.0 * t), 0.12 * libm::cos(60.0 * t));
            let mut state = model.steady_state(&motion(0.0));
            let mut most = 0.0f64;
            for k in 0..(0.05 / dt) as usize {
                let t = k as f64 * dt;
                let rate = |s: &State, t: f64| evaluate(&model, s, &motion(t)).1;
                let moved = |by: &State, h: f64| State {
                    mass_displacement: state.mass_displacement + h * by.mass_displacement,
                    mass_velocity: state.mass_velocity + h * by.mass_velocity,
                    ..state
                };
                let a = rate(&state, t);
                let b = rate(&moved(&a, 0.5 * dt), t + 0.5 * dt);
                let c = rate(&moved(&b, 0.5 * dt), t + 0.5 * dt);
                let d = rate(&moved(&c, dt), t + dt);
                let mean = |of: fn(&State) -> f64| (of(&a) + 2.0 * of(&b) + 2.0 * of(&c) + of(&d)) / 6.0;
                let by = State {
                    mass_displacement: mean(|s| s.mass_displacement),
                    mass_velocity: mean(|s| s.mass_velocity),
                    ..State::ZERO
                };
                state = moved(&by, dt);
                if !state.is_finite() {
                    return f64::INFINITY;
                }
                most = most.max(state.mass_velocity.abs());
            }
            most
        };
        // The moving end reaches 0.12 m/s, so the internal mass stays below 0.2 m/s in a stable integration.
        assert!(largest(0.9 * told) < 0.2, "{}", largest(0.9 * told));
        assert!(largest(3.0 * told) > 0.4, "{}", largest(3.0 * told));
    }
}
