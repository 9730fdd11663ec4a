//! Tests of the derivatives of long steps with nonlinear springs nearly as stiff as the series spring.
//!
//! In such steps, the position about which a spring is linearized depends on the inputs. The stiffness of the tangent,
//! and thus the derivatives of the step, also depend on them.

use crate::common::METHODS;
use dashpot_core::step::{Integration, step};
use dashpot_core::{Input, Model, Params};
use dashpot_core::{element, list, number};
use dashpot_test_support::drawn;
use proptest::prelude::*;

/// Largest error of a derivative, relative to its value plus a hundredth of the derivative's scale: the series
/// stiffness, or this stiffness times the step.
const ALLOWED: f64 = 5e-3;

/// Series stiffness, N/m: about as large as the stiffness of the springs on the mass.
const SERIES: f64 = 3e5;

/// Computes the derivatives of f at 0 from the left and from the right, by one-sided differences with Richardson
/// extrapolation.
fn one_sided(f: &dyn Fn(f64) -> f64, width: f64) -> [f64; 2] {
    let at = f(0.0);
    [-width, width].map(|h| {
        let by = |h: f64| (f(h) - at) / h;
        2.0 * by(0.5 * h) - by(h)
    })
}

/// Returns the distance of a value from the interval between both one-sided differences.
fn distance(value: f64, [left, right]: [f64; 2]) -> f64 {
    (left.min(right) - value).max(value - left.max(right)).max(0.0)
}

fn springs(stiffness: f64) -> Vec<(&'static str, Params)> {
    let mut soft = Params::new();
    soft.set(number!("series_stiffness"), SERIES).unwrap();
    let (mut cubic, mut quartic, mut table) = (soft, soft, soft);
    cubic.set(number!("spring_cubic"), 9e6 * stiffness).unwrap();
    quartic.set(number!("spring_quartic"), 7e7 * stiffness).unwrap();
    let k = 0.6 * stiffness * SERIES;
    table.set_list(list!("spring_displacement"), &[-0.1, -0.04, 0.0, 0.03, 0.09]).unwrap();
    table.set_list(list!("spring_force"), &[-0.1 * k, -0.038 * k, 0.0, 0.024 * k, 0.09 * k]).unwrap();
    vec![("cubic", cubic), ("quartic", quartic), ("table", table)]
}

proptest! {
    #![proptest_config(drawn(150))]

    #[test]
    fn derivatives_follow_the_line_of_a_spring(
        x in -0.08..0.08f64, v in -1.2..1.2f64, gain in -0.3..0.3f64, stiffness in 0.2..1.0f64,
    ) {
        let input = |x: Option<f64>, v: f64| Input { displacement: x, velocity: v, side_force: 0.0, temperature: 20.0 };
        for (name, params) in springs(stiffness) {
            let model = Model::new(&params).unwrap();
            for method in METHODS.map(Some).into_iter().chain([None]) {
                let model = method.map_or(model, |method| model.with_integration(Integration::fixed(method, 1)));
                for dt in [1e-2, 3e-3] {
                    let from = step(&model, &model.steady_state(&input(Some(x), v)), &input(Some(x + 1e-3 * v), v), 1e-3).0;
                    let v1 = v + gain * dt / 1e-3;
                    let x1 = from.displacement + 0.5 * (v + v1) * dt;
                    let output = step(&model, &from, &input(Some(x1), v1), dt).1;
                    let alone = step(&model, &from, &input(None, v1), dt).1.d_force_d_velocity;
                    let force = |x: Option<f64>, v: f64| step(&model, &from, &input(x, v), dt).1.force;
                    let by_x = |h: f64| force(Some(x1 + h), v1);
                    let by_v = |h: f64| force(Some(x1), v1 + h);
                    let by_v_alone = |h: f64| force(None, v1 + h);
                    let compared: [(&str, f64, &dyn Fn(f64) -> f64, f64); 3] = [
                        ("dF/dx", output.d_force_d_displacement, &by_x, 1e-6),
                        ("dF/dv", output.d_force_d_velocity, &by_v, 1e-4),
                        ("dF/dv, velocity alone", alone, &by_v_alone, 1e-4),
                    ];
                    for (what, value, f, width) in compared {
                        let scale = if what == "dF/dx" { SERIES } else { SERIES * dt };
                        // A knee of a table or of the FV curve may lie within the wider difference, so the closer of
                        // two widths counts.
                        let misses = [width, 1e-2 * width].map(|width| {
                            let sides = one_sided(f, width);
                            distance(value, sides) / (value.abs().max(sides[0].abs()) + 1e-2 * scale)
                        });
                        let missed = misses[0].min(misses[1]);
                        prop_assert!(
                            missed <= ALLOWED,
                            "{name} {method:?} {dt} s: {what} {value} misses {:?} by {missed}; x {x} v {v}",
                            one_sided(f, width)
                        );
                    }
                }
            }
        }
    }
}

/// Beyond a series deflection of 50 mm, the tangent at the end of this reach replaces a spring on the mass. This end
/// moves with the moving end, and the derivative contains that. The zone of the damping is far away; it selects the
/// step through the force paths.
#[test]
fn the_end_of_the_reach_moves_with_the_moving_end() {
    let mut params = Params::new();
    for (number, value) in [
        (number!("series_stiffness"), 1e4),
        (number!("series_load"), 1.0),
        (number!("gas_force"), 1e3),
        (number!("spring_linear"), 0.0),
        (number!("spring_quadratic"), 1e4),
    ] {
        params.set(number, value).unwrap();
    }
    params.set_list(list!("fv_velocity"), &[-1.0, 0.0, 1.0]).unwrap();
    params.set_list(list!("fv_force"), &[-50.0, 0.0, 50.0]).unwrap();
    params.enable(element!("position_dependent_damping"), true);
    params.set(number!("bypass_centre"), -0.9).unwrap();
    let model = Model::new(&params).unwrap();
    let input = |x: f64| Input::motion(x, 0.0);
    let from = model.steady_state(&input(0.02));
    let at = |x: f64| step(&model, &from, &input(x), 1e-2).1;
    let (x, h) = (0.0201, 1e-6);
    let difference = (at(x + h).force - at(x - h).force) / (2.0 * h);
    let found = at(x);
    assert!(found.series_deflection.abs() > 0.06, "{}", found.series_deflection);
    let error = (found.d_force_d_displacement - difference).abs();
    assert!(error < 1e-5 * difference.abs(), "{} instead of {difference}", found.d_force_d_displacement);
}
