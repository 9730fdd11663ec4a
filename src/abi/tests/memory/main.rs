//! Tests that call the functions for dampers without a setting, with uninitialized blocks. Module [`setting`] calls those for dampers over a
//! setting.
//!
//! Each block has exactly the size in the header and a separate heap allocation.
//!
//! Tools that check every access (Miri, AddressSanitizer) run these tests: see `tests/tests/system/memory_safety.rs`. Without the tools, the
//! tests still check that the functions accept everything that the header allows.

mod setting;

use dashpot_abi::evaluate::{dashpot_evaluate, dashpot_jacobian};
use dashpot_abi::input::{DASHPOT_KNOWS_DISPLACEMENT, dashpot_input};
use dashpot_abi::model::{
    dashpot_model, dashpot_model_init, dashpot_model_state_name, dashpot_model_states, dashpot_state_name,
};
use dashpot_abi::params::{
    dashpot_fault, dashpot_params, dashpot_params_check, dashpot_params_default, dashpot_params_enable,
    dashpot_params_get, dashpot_params_get_list, dashpot_params_is_on, dashpot_params_read, dashpot_params_set,
    dashpot_params_set_list,
};
use dashpot_abi::partials::dashpot_partials;
use dashpot_abi::state::{dashpot_output, dashpot_state, dashpot_state_init, dashpot_state_init_motion};
use dashpot_abi::status::{
    DASHPOT_BUFFER_TOO_SHORT, DASHPOT_FILE_REPEATED, DASHPOT_MISALIGNED, DASHPOT_NEEDS_SERIES, DASHPOT_NULL,
    DASHPOT_TOO_MANY_STATES, DASHPOT_UNKNOWN_NAME, dashpot_status_text,
};
use dashpot_abi::step::{dashpot_force, dashpot_step, dashpot_step_batch};
use dashpot_abi::table::{dashpot_parameter, dashpot_parameter_count, dashpot_parameter_info};
use dashpot_abi::version::{DASHPOT_ABI_VERSION, dashpot_version};
use dashpot_core::parameter::names;
use std::ffi::{CStr, CString, c_char};
use std::mem::{MaybeUninit, size_of};
use std::ptr::{null, null_mut};

const DT: f64 = 1e-3;
/// Number of steps of a run. Miri interprets every instruction, so it gets only two.
const STEPS: i32 = if cfg!(miri) { 2 } else { 8 };

/// Allocates an uninitialized block, like the allocator of a host.
fn room<T>() -> Box<MaybeUninit<T>> {
    Box::new(MaybeUninit::uninit())
}

/// Returns a block that a function has filled.
///
/// # Safety
/// The function wrote the whole block.
unsafe fn filled<T>(room: Box<MaybeUninit<T>>) -> Box<T> {
    // SAFETY: the caller guarantees that the block is fully written. Both boxes have the same layout.
    unsafe { Box::from_raw(Box::into_raw(room).cast::<T>()) }
}

/// Makes a string whose allocation ends with its terminator.
fn exactly(text: &str) -> CString {
    CString::new(text.as_bytes().to_vec().into_boxed_slice().into_vec()).unwrap()
}

fn text<const N: usize>(field: &[c_char; N]) -> String {
    field.iter().take_while(|c| **c != 0).map(|c| *c as u8 as char).collect()
}

/// Makes default parameters with only these elements on.
fn params(on: &[&str]) -> Box<dashpot_params> {
    let mut params = room::<dashpot_params>();
    let at = params.as_mut_ptr();
    // SAFETY: the block has this type. Only its first two members are set, as the header requires.
    unsafe {
        (&raw mut (*at).struct_size).write(size_of::<dashpot_params>() as u32);
        (&raw mut (*at).abi_version).write(DASHPOT_ABI_VERSION);
    }
    // SAFETY: the block has size and version, and the function fills it.
    let mut params = unsafe {
        assert_eq!(dashpot_params_default(at), 0);
        filled(params)
    };
    for name in names() {
        let name_of = exactly(name);
        let mut is_on = 9;
        // SAFETY: a filled block, a zero-terminated name and a local number.
        unsafe {
            assert_eq!(dashpot_params_enable(&mut *params, name_of.as_ptr(), u32::from(on.contains(&name))), 0);
            assert_eq!(dashpot_params_is_on(&*params, name_of.as_ptr(), &mut is_on), 0);
        }
        assert_eq!(is_on, u32::from(on.contains(&name)), "{name}");
    }
    params
}

/// Makes a model. Returns `None` if an element needs another element, or if the model would need too many internal states.
fn model(params: &dashpot_params) -> Option<Box<dashpot_model>> {
    let mut model = room::<dashpot_model>();
    // SAFETY: room for a model and a filled parameter set. Only functions read the model.
    unsafe {
        let status = dashpot_model_init(model.as_mut_ptr(), params);
        assert!([0, DASHPOT_NEEDS_SERIES, DASHPOT_TOO_MANY_STATES].contains(&status), "{status}");
        (status == 0).then(|| filled(model))
    }
}

fn input(x: Option<f64>, v: f64) -> Box<dashpot_input> {
    Box::new(dashpot_input {
        struct_size: size_of::<dashpot_input>() as u32,
        known: if x.is_some() { DASHPOT_KNOWS_DISPLACEMENT } else { 0 },
        displacement: x.unwrap_or(0.0),
        velocity: v,
        side_force: 0.0,
        temperature: 0.0,
        setting: 0.0,
    })
}

fn at_rest(model: &dashpot_model, position: f64) -> Box<dashpot_state> {
    let mut state = room::<dashpot_state>();
    // SAFETY: an initialized model, and room for a state, which the function fills.
    unsafe {
        assert_eq!(dashpot_state_init(model, position, state.as_mut_ptr()), 0);
        filled(state)
    }
}

/// Copies the bytes of a state, like an assignment in C.
fn copy(state: &dashpot_state) -> dashpot_state {
    // SAFETY: the header allows copying a state with = or memcpy. A state contains only numbers.
    unsafe { std::ptr::read(state) }
}

/// Calls the functions that a host uses with a model without a setting.
fn run(model: &dashpot_model, what: &str) {
    // SAFETY: an initialized model.
    let states = unsafe { dashpot_model_states(model) };
    assert!(states >= 2, "{what}: {states}");
    for state in 0..states as u32 {
        let mut name = room::<dashpot_state_name>();
        // SAFETY: an initialized model, and a block with its size set, which the function fills.
        let name = unsafe {
            (&raw mut (*name.as_mut_ptr()).struct_size).write(size_of::<dashpot_state_name>() as u32);
            assert_eq!(dashpot_model_state_name(model, state, name.as_mut_ptr()), 0);
            filled(name)
        };
        assert!(!text(&name.name).is_empty() && !text(&name.unit).is_empty(), "{what}");
    }
    let mut state = at_rest(model, -0.01);
    let mut moving = room::<dashpot_state>();
    // SAFETY: an initialized model, an input, and room for a state.
    let status = unsafe { dashpot_state_init_motion(model, &*input(Some(0.01), 0.2), moving.as_mut_ptr()) };
    assert!(status >= 0, "{what}: {status}");
    for k in 0..STEPS {
        let (x, v) = (-0.01 + 0.002 * f64::from(k), 2.0 - 0.3 * f64::from(k));
        let (mut force, mut to, mut output) = (f64::NAN, room::<dashpot_state>(), room::<dashpot_output>());
        // SAFETY: an initialized model and state, inputs, and room for each output, which the functions fill.
        unsafe {
            assert!(dashpot_force(model, &mut *state, v, DT, &mut force) >= 0, "{what}");
            assert!(force.is_finite(), "{what}");
            let moved = input(Some(x), v);
            let status = dashpot_step(model, &*state, &*moved, DT, to.as_mut_ptr(), output.as_mut_ptr());
            assert!(status >= 0 && filled(output).force.is_finite(), "{what}: {status}");
            state = filled(to);
            let (mut output, mut rate) = (room::<dashpot_output>(), room::<dashpot_state>());
            assert!(dashpot_evaluate(model, &*state, &*moved, output.as_mut_ptr(), rate.as_mut_ptr()) >= 0, "{what}");
            assert!(filled(output).force.is_finite() && filled(rate).mass_velocity.is_finite(), "{what}");
            let mut partials = room::<dashpot_partials>();
            assert!(dashpot_jacobian(model, &*state, &*moved, partials.as_mut_ptr()) >= 0, "{what}");
            let partials = filled(partials);
            assert!(partials.d_rate_d_state.as_flattened().iter().all(|p| p.is_finite()), "{what}");
        }
    }
    four_corners(model, &state, what);
}

/// Steps four dampers in arrays of exactly four elements. First `from` and `to` are separate, then equal.
fn four_corners(model: &dashpot_model, state: &dashpot_state, what: &str) {
    let models: Box<[*const dashpot_model]> = vec![std::ptr::from_ref(model); 4].into();
    let mut from: Box<[dashpot_state]> = (0..4).map(|_| copy(state)).collect();
    let inputs: Box<[dashpot_input]> = (0..4).map(|k| *input(None, 0.1 * f64::from(k))).collect();
    let mut to: Box<[MaybeUninit<dashpot_state>]> = (0..4).map(|_| MaybeUninit::uninit()).collect();
    let mut outputs: Box<[MaybeUninit<dashpot_output>]> = (0..4).map(|_| MaybeUninit::uninit()).collect();
    let (reached, answers) = (to.as_mut_ptr().cast(), outputs.as_mut_ptr().cast());
    // SAFETY: four elements of each, and room for four outputs. In the second call `from` and `to` are equal, as the header allows.
    unsafe {
        let status = dashpot_step_batch(4, models.as_ptr(), from.as_ptr(), inputs.as_ptr(), DT, reached, answers);
        assert!(status >= 0, "{what}: {status}");
        let place = from.as_mut_ptr();
        assert_eq!(dashpot_step_batch(4, models.as_ptr(), place, inputs.as_ptr(), DT, place, answers), status);
        for (apart, same) in to.iter().zip(&from) {
            assert_eq!(apart.assume_init_ref().mass_velocity.to_bits(), same.mass_velocity.to_bits(), "{what}");
        }
        assert_eq!(dashpot_step_batch(0, null(), null(), null(), DT, null_mut(), null_mut()), 0, "{what}");
    }
}

#[test]
fn every_element_alone_and_all_together_run_in_blocks_of_exactly_their_size() {
    let mut together = vec!["fv_curve", "series_compliance"];
    if cfg!(miri) {
        // Two elements suffice under Miri, where all elements take minutes, because no element has unsafe code of its own.
        together.extend(["presliding_friction", "oil_compressibility"]);
    } else {
        for element in names() {
            if let Some(alone) = model(&params(&[element])) {
                run(&alone, element);
            }
            // Coupled elements interact with other elements only if the internal mass is present.
            let beside = model(&params(&["fv_curve", "series_compliance", element]));
            run(&beside.unwrap_or_else(|| panic!("{element} is refused")), element);
            together.push(element);
            if model(&params(&together)).is_none() {
                together.pop();
            }
        }
        assert!(together.len() > 10, "{together:?}");
    }
    run(&model(&params(&together)).unwrap(), "all elements that go together");
}

#[test]
fn parameters_are_set_read_and_described_in_blocks_of_exactly_their_size() {
    let mut set = params(&["fv_curve"]);
    for row in (0..dashpot_parameter_count()).step_by(if cfg!(miri) { 11 } else { 1 }) {
        let mut info = room::<dashpot_parameter>();
        // SAFETY: a block with its size set, which the function fills.
        let info = unsafe {
            (&raw mut (*info.as_mut_ptr()).struct_size).write(size_of::<dashpot_parameter>() as u32);
            assert_eq!(dashpot_parameter_info(row, info.as_mut_ptr()), 0);
            filled(info)
        };
        let name = exactly(&text(&info.name));
        let (mut value, mut count) = (f64::NAN, 0);
        // SAFETY: a filled set, a zero-terminated name, and lists of exactly the stated length.
        unsafe {
            if dashpot_params_get(&*set, name.as_ptr(), &mut value) == 0 {
                assert_eq!(dashpot_params_set(&mut *set, name.as_ptr(), value), 0, "{name:?}");
                continue;
            }
            assert_eq!(dashpot_params_get_list(&*set, name.as_ptr(), null_mut(), 0, &mut count), 0, "{name:?}");
            if count == 0 {
                continue;
            }
            let mut list: Box<[f64]> = vec![0.0; count as usize].into();
            assert_eq!(dashpot_params_get_list(&*set, name.as_ptr(), list.as_mut_ptr(), count, &mut count), 0);
            assert_eq!(
                dashpot_params_get_list(&*set, name.as_ptr(), list.as_mut_ptr(), count - 1, &mut count),
                DASHPOT_BUFFER_TOO_SHORT
            );
            assert_eq!(dashpot_params_set_list(&mut *set, name.as_ptr(), list.as_ptr(), count), 0, "{name:?}");
        }
    }
    // SAFETY: the texts are static and zero-terminated.
    unsafe {
        assert!(CStr::from_ptr(dashpot_version()).to_str().is_ok_and(|v| v.split('.').count() == 3));
        for status in -40..4 {
            assert!(!CStr::from_ptr(dashpot_status_text(status)).is_empty());
        }
    }
}

#[test]
fn a_model_file_is_read_to_its_last_byte_and_no_further() {
    let whole = "format = 1\nelements = [\"fv_curve\", \"coulomb_friction\"]\ncoulomb_force = 40.0\nfv_velocity = [-1.0, 0.0, 1.0]\nfv_force = [-500.0, 0.0, 900.0]\n";
    let mut set = params(&[]);
    // The text is truncated at every byte, each time in an allocation that ends there. Under Miri, it is truncated at a few bytes only.
    for end in (0..whole.len()).step_by(if cfg!(miri) { 83 } else { 1 }).chain([whole.len()]) {
        let text: Box<[u8]> = whole.as_bytes()[..end].into();
        let mut fault = room::<dashpot_fault>();
        // SAFETY: a filled set, the stated number of bytes, and room for a fault.
        let (status, silent) = unsafe {
            let of = text.as_ptr().cast();
            let status = dashpot_params_read(&mut *set, of, text.len(), fault.as_mut_ptr());
            (status, dashpot_params_read(&mut *set, of, text.len(), null_mut()))
        };
        assert_eq!(status, silent);
        assert!(end < whole.len() || status == 0, "{status}");
        if status < 0 {
            // SAFETY: the function fills the fault if it rejects the file.
            assert_eq!(unsafe { filled(fault) }.status, status);
        }
    }
    let twice: Box<[u8]> = format!("{whole}coulomb_force = 41").into_bytes().into();
    let mut fault = room::<dashpot_fault>();
    // SAFETY: as before.
    let fault = unsafe {
        let status = dashpot_params_read(&mut *set, twice.as_ptr().cast(), twice.len(), fault.as_mut_ptr());
        assert_eq!(status, DASHPOT_FILE_REPEATED);
        filled(fault)
    };
    assert_eq!((text(&fault.parameter).as_str(), fault.line), ("coulomb_force", 6));
    let mut fault = room::<dashpot_fault>();
    // SAFETY: a filled set, and room for a fault.
    assert_eq!(unsafe { dashpot_params_check(&*set, fault.as_mut_ptr()) }, 0);
}

#[test]
fn what_the_header_refuses_is_refused_before_it_is_touched() {
    let mut set = params(&["fv_curve"]);
    let ready = model(&set).unwrap();
    let mut state = at_rest(&ready, 0.0);
    let before = copy(&state);
    let mut force = 1.0;
    let nothing = exactly("no_such_name");
    // SAFETY: null, an address one byte off, or an unknown name. The functions reject them by the header, and read nothing there.
    unsafe {
        assert_eq!(dashpot_force(null(), &mut *state, 0.1, DT, &mut force), DASHPOT_NULL);
        assert_eq!(dashpot_force(&*ready, null_mut(), 0.1, DT, &mut force), DASHPOT_NULL);
        assert_eq!(dashpot_force(&*ready, &mut *state, 0.1, DT, null_mut()), DASHPOT_NULL);
        let off = (&raw mut *state).cast::<u8>().wrapping_add(1).cast::<dashpot_state>();
        assert_eq!(dashpot_force(&*ready, off, 0.1, DT, &mut force), DASHPOT_MISALIGNED);
        assert!(dashpot_force(&*ready, &mut *state, f64::NAN, DT, &mut force) < 0);
        assert!(dashpot_force(&*ready, &mut *state, 0.1, -DT, &mut force) < 0);
        assert_eq!(dashpot_params_set(&mut *set, nothing.as_ptr(), 1.0), DASHPOT_UNKNOWN_NAME);
        assert_eq!(dashpot_params_set(&mut *set, null(), 1.0), DASHPOT_NULL);
        assert_eq!(dashpot_params_read(&mut *set, null(), 3, null_mut()), DASHPOT_NULL);
        assert_eq!(dashpot_model_init(null_mut(), &*set), DASHPOT_NULL);
    }
    assert_eq!((force, state.velocity.to_bits(), state.internal), (1.0, before.velocity.to_bits(), before.internal));
}
