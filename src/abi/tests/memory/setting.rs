//! Tests that call the functions for dampers over a setting, with and without an actuator, with uninitialized blocks.

use super::{DT, STEPS, at_rest, copy, exactly, filled, input, model, params, room};
use dashpot_abi::evaluate::{dashpot_evaluate, dashpot_jacobian};
use dashpot_abi::input::{DASHPOT_KNOWS_SETTING, dashpot_input};
use dashpot_abi::model::dashpot_model;
use dashpot_abi::params::{dashpot_params, dashpot_params_get_list, dashpot_params_read, dashpot_params_set};
use dashpot_abi::partials::{dashpot_partials, dashpot_setting_derivatives};
use dashpot_abi::setting::{
    dashpot_actuator_setting, dashpot_d_force_d_setting, dashpot_force_with_setting, dashpot_jacobian_setting,
    dashpot_params_set_grid, dashpot_params_set_list_over, dashpot_params_set_over, dashpot_params_setting,
    dashpot_setting,
};
use dashpot_abi::state::{dashpot_output, dashpot_state, dashpot_state_init_motion};
use dashpot_abi::status::{DASHPOT_MISALIGNED, DASHPOT_NULL};
use dashpot_abi::step::{dashpot_force, dashpot_step, dashpot_step_batch};
use std::mem::{MaybeUninit, size_of};
use std::ptr::{null, null_mut};

/// Settings of the grid, A.
const GRID: [f64; 3] = [0.0, 0.8, 1.6];
/// Entries of the actuator in a model file: all kinds of dynamics.
const ACTUATOR: [(&str, f64); 7] = [
    ("setting_dead_time", 2.5e-3),
    ("setting_time_up", 8e-3),
    ("setting_time_down", 0.02),
    ("setting_rate_up", 120.0),
    ("setting_rate_down", 60.0),
    ("setting_hysteresis", 0.05),
    ("setting_hysteresis_rest", 0.6),
];

/// Makes the parameters of a damper over a setting with these elements, from lists of exactly their length.
fn over_setting(elements: &[&str], has_actuator: bool) -> Box<dashpot_params> {
    let mut params = params(elements);
    let grid: Box<[f64]> = GRID.into();
    let (curve, gas) = (exactly("fv_force"), exactly("gas_force"));
    let mut count = 0;
    // SAFETY: a filled set, zero-terminated names, and lists of exactly the stated length.
    unsafe {
        assert_eq!(dashpot_params_set_grid(&mut *params, grid.as_ptr(), 3), 0);
        assert_eq!(dashpot_params_get_list(&*params, curve.as_ptr(), null_mut(), 0, &mut count), 0);
        let mut forces: Box<[f64]> = vec![0.0; count as usize].into();
        assert_eq!(dashpot_params_get_list(&*params, curve.as_ptr(), forces.as_mut_ptr(), count, &mut count), 0);
        for (index, times) in (0..3).zip([1.0, 1.5, 2.5]) {
            let own: Box<[f64]> = forces.iter().map(|force| times * force).collect();
            assert_eq!(dashpot_params_set_list_over(&mut *params, curve.as_ptr(), index, own.as_ptr(), count), 0);
        }
        let values: Box<[f64]> = [80.0, 85.0, 95.0].into();
        assert_eq!(dashpot_params_set_over(&mut *params, gas.as_ptr(), values.as_ptr(), 3), 0);
        for (name, value) in ACTUATOR.iter().filter(|_| has_actuator) {
            assert_eq!(dashpot_params_set(&mut *params, exactly(name).as_ptr(), *value), 0, "{name}");
        }
    }
    let mut setting = room::<dashpot_setting>();
    // SAFETY: a filled set, and a block with its size set, which the function fills.
    let setting = unsafe {
        (&raw mut (*setting.as_mut_ptr()).struct_size).write(size_of::<dashpot_setting>() as u32);
        assert_eq!(dashpot_params_setting(&*params, setting.as_mut_ptr()), 0);
        filled(setting)
    };
    assert_eq!((setting.count, &setting.grid[..3]), (3, &GRID[..]));
    params
}

/// Makes an input with a command. Without `x`, the displacement is unknown.
fn commanded(x: Option<f64>, v: f64, setting: f64) -> Box<dashpot_input> {
    let mut input = input(x, v);
    input.known |= DASHPOT_KNOWS_SETTING;
    input.setting = setting;
    input
}

/// Returns the command of a step, A: it changes within the dead time, and leaves the grid.
fn command(k: i32) -> f64 {
    [0.2, 1.4, 2.0, 0.0][k as usize % 4]
}

/// Calls the functions that a host uses with a model over a setting.
fn run(model: &dashpot_model, what: &str) {
    let mut state = at_rest(model, -0.01);
    let mut moving = room::<dashpot_state>();
    // SAFETY: an initialized model, an input, and room for a state.
    let status = unsafe { dashpot_state_init_motion(model, &*commanded(Some(0.01), 0.2, 1.2), moving.as_mut_ptr()) };
    assert!(status >= 0, "{what}: {status}");
    for k in 0..STEPS {
        let (x, v) = (-0.01 + 0.002 * f64::from(k), 2.0 - 0.3 * f64::from(k));
        let moved = commanded(Some(x), v, command(k));
        let (mut force, mut actual, mut derivative) = (f64::NAN, f64::NAN, f64::NAN);
        // SAFETY: an initialized model and state, inputs, and room for each output, which the functions fill.
        unsafe {
            assert!(dashpot_force(model, &mut *state, v, DT, &mut force) >= 0 && force.is_finite(), "{what}");
            let status = dashpot_force_with_setting(model, &mut *state, v, command(k), DT, &mut force);
            assert!(status >= 0 && force.is_finite(), "{what}: {status}");
            let (mut to, mut output) = (room::<dashpot_state>(), room::<dashpot_output>());
            let status = dashpot_step(model, &*state, &*moved, DT, to.as_mut_ptr(), output.as_mut_ptr());
            assert!(status >= 0 && filled(output).force.is_finite(), "{what}: {status}");
            let mut to = filled(to);
            // The same step in place, on a copy of the state.
            let mut output = room::<dashpot_output>();
            let place: *mut dashpot_state = &mut *state;
            assert_eq!(dashpot_step(model, place, &*moved, DT, place, output.as_mut_ptr()), status, "{what}");
            assert_eq!((to.internal, to.commands), (state.internal, state.commands), "{what}");
            assert!(dashpot_actuator_setting(model, &*to, &*moved, &mut actual) >= 0, "{what}");
            assert!((0.0..=1.6).contains(&actual), "{what}: {actual}");
            assert!(dashpot_d_force_d_setting(model, &*to, &*moved, DT, &mut derivative) >= 0, "{what}");
            let (mut output, mut rate) = (room::<dashpot_output>(), room::<dashpot_state>());
            assert!(dashpot_evaluate(model, &*to, &*moved, output.as_mut_ptr(), rate.as_mut_ptr()) >= 0, "{what}");
            assert!(filled(output).force.is_finite() && filled(rate).internal.iter().all(|r| r.is_finite()), "{what}");
            let (mut partials, mut by) = (room::<dashpot_partials>(), room::<dashpot_setting_derivatives>());
            assert!(dashpot_jacobian(model, &*to, &*moved, partials.as_mut_ptr()) >= 0, "{what}");
            assert!(dashpot_jacobian_setting(model, &*to, &*moved, by.as_mut_ptr()) >= 0, "{what}");
            assert!(filled(partials).d_rate_d_state.as_flattened().iter().all(|p| p.is_finite()), "{what}");
            let by = filled(by);
            assert!(by.d_force_d_setting.is_finite() && by.d_rate_d_setting.iter().all(|r| r.is_finite()), "{what}");
            // A trial step from a copy leaves the copied state as it is.
            let before = copy(&to);
            let mut trial = copy(&to);
            assert!(dashpot_force_with_setting(model, &mut trial, v, 1.6, DT, &mut force) >= 0, "{what}");
            assert_eq!((before.internal, before.commands), (to.internal, to.commands), "{what}");
            to = Box::new(before);
            state = to;
        }
    }
}

/// Steps an adjustable and an ordinary damper in arrays of exactly two elements. First `from` and `to` are separate, then equal.
fn both(family: &dashpot_model, ordinary: &dashpot_model) {
    let models: Box<[*const dashpot_model]> = vec![std::ptr::from_ref(family), std::ptr::from_ref(ordinary)].into();
    let mut from: Box<[dashpot_state]> =
        [family, ordinary].into_iter().map(|model| copy(&at_rest(model, 0.01))).collect();
    let inputs: Box<[dashpot_input]> = (0..2).map(|k| *commanded(None, 0.2 - f64::from(k), 1.1)).collect();
    let mut to: Box<[MaybeUninit<dashpot_state>]> = (0..2).map(|_| MaybeUninit::uninit()).collect();
    let mut outputs: Box<[MaybeUninit<dashpot_output>]> = (0..2).map(|_| MaybeUninit::uninit()).collect();
    let (reached, answers) = (to.as_mut_ptr().cast(), outputs.as_mut_ptr().cast());
    // SAFETY: two elements of each, and room for two outputs. In the second call `from` and `to` are equal, as the header allows.
    unsafe {
        let status = dashpot_step_batch(2, models.as_ptr(), from.as_ptr(), inputs.as_ptr(), DT, reached, answers);
        assert!(status >= 0, "{status}");
        let place = from.as_mut_ptr();
        assert_eq!(dashpot_step_batch(2, models.as_ptr(), place, inputs.as_ptr(), DT, place, answers), status);
        for (apart, same) in to.iter().zip(&from) {
            assert_eq!(apart.assume_init_ref().internal, same.internal);
        }
        assert_eq!(to[0].assume_init_ref().commands, from[0].commands);
    }
}

#[test]
fn dampers_over_a_setting_run_in_blocks_of_exactly_their_size() {
    let elements = ["fv_curve", "series_compliance", "gas_preload", "presliding_friction", "oil_compressibility"];
    for has_actuator in [false, true] {
        let family = model(&over_setting(&elements, has_actuator)).unwrap();
        run(&family, if has_actuator { "with an actuator" } else { "without an actuator" });
        both(&family, &model(&params(&elements)).unwrap());
    }
}

#[test]
fn a_model_file_over_a_setting_is_read_to_its_last_byte_and_no_further() {
    let whole = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\nsetting = [0.0, 1.6]\nsetting_name = \"current\"\nsetting_unit = \"A\"\n\
                 setting_time_up = 0.008\ngas_force = [80.0, 90.0]\nfv_velocity = [-1.0, 0.0, 1.0]\nfv_force = [[-500.0, 0.0, 900.0], [-900.0, 0.0, 1600.0]]\n";
    let mut set = params(&[]);
    // The text is truncated at every byte, each time in an allocation that ends there. Under Miri, it is truncated at a few bytes only.
    for end in (0..whole.len()).step_by(if cfg!(miri) { 97 } else { 1 }).chain([whole.len()]) {
        let text: Box<[u8]> = whole.as_bytes()[..end].into();
        // SAFETY: a filled set, the stated number of bytes, and no room for a fault.
        let status = unsafe { dashpot_params_read(&mut *set, text.as_ptr().cast(), text.len(), null_mut()) };
        assert!(end < whole.len() || status == 0, "{status}");
    }
    assert!(model(&set).is_some());
}

#[test]
fn what_the_header_refuses_of_a_setting_is_refused_before_it_is_touched() {
    let family = model(&over_setting(&["fv_curve", "gas_preload"], true)).unwrap();
    let mut state = at_rest(&family, 0.0);
    let before = copy(&state);
    let at = commanded(Some(0.0), 0.1, 1.0);
    let mut force = 1.0;
    let mut set = params(&["fv_curve"]);
    // SAFETY: null, or an address one byte off. The functions reject them by the header, and read nothing there.
    unsafe {
        assert_eq!(dashpot_force_with_setting(null(), &mut *state, 0.1, 1.0, DT, &mut force), DASHPOT_NULL);
        assert_eq!(dashpot_force_with_setting(&*family, null_mut(), 0.1, 1.0, DT, &mut force), DASHPOT_NULL);
        assert_eq!(dashpot_force_with_setting(&*family, &mut *state, 0.1, 1.0, DT, null_mut()), DASHPOT_NULL);
        let off = (&raw mut *state).cast::<u8>().wrapping_add(1).cast::<dashpot_state>();
        assert_eq!(dashpot_force_with_setting(&*family, off, 0.1, 1.0, DT, &mut force), DASHPOT_MISALIGNED);
        assert!(dashpot_force_with_setting(&*family, &mut *state, 0.1, f64::NAN, DT, &mut force) < 0);
        assert_eq!(dashpot_actuator_setting(&*family, &*state, &*at, null_mut()), DASHPOT_NULL);
        assert_eq!(dashpot_d_force_d_setting(&*family, &*state, null(), DT, &mut force), DASHPOT_NULL);
        assert!(dashpot_d_force_d_setting(&*family, &*state, &*at, -DT, &mut force) < 0);
        assert_eq!(dashpot_jacobian_setting(&*family, &*state, &*at, null_mut()), DASHPOT_NULL);
        assert_eq!(dashpot_params_set_grid(&mut *set, null(), 2), DASHPOT_NULL);
        assert_eq!(dashpot_params_setting(&*set, null_mut()), DASHPOT_NULL);
    }
    assert_eq!((force, state.internal, state.commands), (1.0, before.internal, before.commands));
}
