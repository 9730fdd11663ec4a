//! A step without derivatives gives, bit by bit, the force and the state of a step with derivatives.

use crate::common::*;
use dashpot_core::step::{force_in_place, step_in_place};
use dashpot_core::{Input, Model, Output};
use dashpot_test_support::drawn;
use proptest::prelude::*;

proptest! {
    #![proptest_config(drawn(300))]

    #[test]
    fn force_and_state_are_those_of_the_step_with_derivatives(
        params in any_params(),
        speeds in prop::collection::vec(-3.0..3.0f64, 1..20),
        dt in (-5.0..-2.0f64).prop_map(|d| 10f64.powf(d)),
    ) {
        let Ok(model) = Model::new(&params) else { return Ok(()) };
        let mut with = model.steady_state(&Input::motion(0.01, 0.0));
        let mut without = with;
        for v in speeds {
            let mut output = Output::ZERO;
            let moved = step_in_place(&model, &mut with, &Input::velocity(v), dt, &mut output);
            let force = force_in_place(&model, &mut without, &Input::velocity(v), dt);
            prop_assert_eq!(force.map(f64::to_bits), moved.then_some(output.force.to_bits()), "{}", describe(&params));
            prop_assert_eq!(format!("{with:?}"), format!("{without:?}"), "{}", describe(&params));
        }
    }
}
