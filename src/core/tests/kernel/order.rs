//! Each integration method converges with its order for a smooth damper.

use crate::common::*;
use dashpot_core::parameter::Element;
use dashpot_core::step::{Integration, Method};
use dashpot_core::{Model, Params};
use dashpot_core::{list, number};

/// Makes a model with smooth elements in the series path and in the hydraulic path ([`dashpot_core::paths`]).
///
/// A stage computes the damping from the oil temperature before the stage's own heat. The resulting error is of first
/// order but far below the other errors.
fn smooth_paths() -> Model {
    let mut params = smooth_params();
    for element in ["bushing", "oil_compressibility", "frequency_selective_damping", "temperature_fade"] {
        params.enable(Element::find(element).unwrap(), true);
    }
    params.set(number!("bushing_hardening"), 0.02).unwrap();
    params.set(number!("oil_stiffness"), 3e5).unwrap();
    params.set(number!("fade_source"), 1.0).unwrap();
    params.set(number!("heat_capacity"), 1e5).unwrap();
    Model::new(&params).unwrap()
}

/// Makes a damper without kinks: a linear FV curve, a cubic spring, no dry friction. The oscillation of its internal
/// mass is slow enough that the error of millisecond steps falls with the order of the method.
fn smooth() -> Model {
    Model::new(&smooth_params()).unwrap()
}

fn smooth_params() -> Params {
    let mut params = Params::new();
    params.disable_all();
    for element in ["fv_curve", "series_compliance", "parallel_spring"] {
        params.enable(Element::find(element).unwrap(), true);
    }
    params.set_list(list!("fv_velocity"), &[-2.0, 2.0]).unwrap();
    params.set_list(list!("fv_force"), &[-1500.0, 1500.0]).unwrap();
    params.set(number!("spring_quadratic"), 0.0).unwrap();
    params.set(number!("spring_cubic"), 5e6).unwrap();
    params.set(number!("series_stiffness"), 2e5).unwrap();
    params.set(number!("internal_mass"), 2.0).unwrap();
    params
}

#[test]
fn error_falls_with_the_order_of_the_method() {
    falls(smooth());
}

#[test]
fn error_falls_with_the_order_of_the_method_through_the_paths() {
    falls(smooth_paths());
}

fn falls(model: Model) {
    let motion = sine(0.02, 4.0);
    // The steps are short enough to show the order of each method with the stiffest element, the bushing.
    let (coarse, steps) = (5e-4, 500);
    let exact = reference_forces(&model, &motion, coarse, steps, 200);
    let methods = [
        (Method::Euler, 0.9),
        (Method::Second, 1.9),
        (Method::ThreeStage, 1.85),
        (Method::Third, 2.8),
        (Method::Fourth, 3.5),
    ];
    for (method, order) in methods {
        let model = model.with_integration(Integration::fixed(method, 1));
        let error = |finer: usize| {
            let forces = step_forces(&model, &motion, coarse / finer as f64, steps * finer, false);
            let forces: Vec<f64> = forces.into_iter().skip(finer - 1).step_by(finer).collect();
            errors(&forces, &exact).0
        };
        let (e1, e2, e4) = (error(1), error(2), error(4));
        let derivatives = ((e1 / e2).log2(), (e2 / e4).log2());
        assert!(
            derivatives.0 > order && derivatives.1 > order,
            "{method:?}: errors {e1:.2e} {e2:.2e} {e4:.2e}, slopes {derivatives:?}"
        );
    }
}

#[test]
fn substeps_and_shorter_steps_are_the_same_refinement() {
    // The motion is a cubic in time, which the path of a step reproduces exactly. A step of n substeps then equals n
    // steps.
    let model = smooth();
    let motion = |t: f64| (0.02 * t + 3.0 * t * t * t, 0.02 + 9.0 * t * t);
    for method in METHODS {
        let whole = step_forces(&model.with_integration(Integration::fixed(method, 4)), &motion, 4e-3, 20, false);
        let parts = step_forces(&model.with_integration(Integration::fixed(method, 1)), &motion, 1e-3, 80, false);
        for (whole, part) in whole.iter().zip(parts.iter().skip(3).step_by(4)) {
            assert!((whole - part).abs() < 1e-8 * part.abs().max(1.0), "{method:?}: {whole} {part}");
        }
    }
}
