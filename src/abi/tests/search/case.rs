//! Cases of the search. A case is a parameter set and a motion, and runs through the C interface.

use dashpot_abi::evaluate::{dashpot_evaluate, dashpot_jacobian};
use dashpot_abi::input::{
    DASHPOT_KNOWS_DISPLACEMENT, DASHPOT_KNOWS_SIDE_FORCE, DASHPOT_KNOWS_TEMPERATURE, dashpot_input,
};
use dashpot_abi::model::{dashpot_model, dashpot_model_init};
use dashpot_abi::params::{
    dashpot_params, dashpot_params_default, dashpot_params_enable, dashpot_params_set, dashpot_params_set_list,
};
use dashpot_abi::partials::dashpot_partials;
use dashpot_abi::state::{dashpot_output, dashpot_state, dashpot_state_init};
use dashpot_abi::step::dashpot_step;
use dashpot_abi::version::DASHPOT_ABI_VERSION;
use dashpot_core::parameter::Element;
use dashpot_core::parameter::{GROUPS, names};
use dashpot_core::parameter::{Shape, table};
use dashpot_core::schema::SIZES;
use dashpot_test_support::Random;
use std::ffi::CString;
use std::fmt::Write as _;
use std::mem::{MaybeUninit, size_of, zeroed};

/// Input of the host in one step: displacement `x`, m, velocity `v`, m/s, side force, N, temperature, °C, and step size `dt`, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Given {
    pub x: Option<f64>,
    pub v: f64,
    pub side: f64,
    pub temperature: f64,
    pub dt: f64,
}

/// Everything on which a run depends.
#[derive(Clone, Debug)]
pub struct Case {
    pub on: Vec<&'static str>,
    /// Parameters that differ from their defaults.
    pub values: Vec<(&'static str, Vec<f64>)>,
    pub start: f64,
    pub motion: Vec<Given>,
    /// Whether a damper can make this motion. Otherwise the force is not compared with its bound.
    pub ordinary: bool,
}

/// Failure of a case, and the step in which it occurred.
#[derive(Clone, Debug)]
pub struct Failure {
    pub step: usize,
    /// Ratio of the force to its limit; infinity for any other failure.
    pub by: f64,
    pub what: String,
}

/// Forces and displacements of the successful steps of a run, and the number of rejected calls.
pub struct Run {
    pub forces: Vec<f64>,
    pub places: Vec<f64>,
    pub refused: usize,
}

/// Prepares a model on the heap. Returns `None` if a parameter or the model is rejected.
pub fn prepare(case: &Case) -> Option<Box<dashpot_model>> {
    // SAFETY: the structure contains only numbers and pointers, for which zero bytes are valid.
    let mut params: dashpot_params = unsafe { zeroed() };
    params.struct_size = size_of::<dashpot_params>() as u32;
    params.abi_version = DASHPOT_ABI_VERSION;
    // SAFETY: the block is local, with size and version set.
    assert_eq!(unsafe { dashpot_params_default(&mut params) }, 0);
    for name in names() {
        let c = CString::new(name).unwrap();
        // SAFETY: a filled block and a zero-terminated name.
        assert_eq!(unsafe { dashpot_params_enable(&mut params, c.as_ptr(), u32::from(case.on.contains(&name))) }, 0);
    }
    for (name, values) in &case.values {
        let row = dashpot_core::parameter::find(name).unwrap();
        let name = CString::new(*name).unwrap();
        let status = match row.parameter.shape {
            // SAFETY: a filled block, a zero-terminated name, and the stated number of values.
            Shape::List(_) => unsafe {
                dashpot_params_set_list(&mut params, name.as_ptr(), values.as_ptr(), values.len() as u32)
            },
            // SAFETY: a filled block and a zero-terminated name.
            _ => unsafe { dashpot_params_set(&mut params, name.as_ptr(), values[0]) },
        };
        if status < 0 {
            return None;
        }
    }
    let mut model = Box::new(MaybeUninit::<dashpot_model>::uninit());
    // SAFETY: the memory of a model may be uninitialized, and the parameter block is filled.
    let status = unsafe { dashpot_model_init(model.as_mut_ptr(), &params) };
    // SAFETY: by its status, the function initialized the model in this memory.
    (status >= 0).then(|| unsafe { Box::from_raw(Box::into_raw(model).cast::<dashpot_model>()) })
}

impl Given {
    pub fn input(&self) -> dashpot_input {
        let mut known = DASHPOT_KNOWS_SIDE_FORCE | DASHPOT_KNOWS_TEMPERATURE;
        if self.x.is_some() {
            known |= DASHPOT_KNOWS_DISPLACEMENT;
        }
        dashpot_input {
            struct_size: size_of::<dashpot_input>() as u32,
            known,
            displacement: self.x.unwrap_or(0.0),
            velocity: self.v,
            side_force: self.side,
            temperature: self.temperature,
            setting: 0.0,
        }
    }
}

fn numbers<T>(block: &T) -> &[f64] {
    assert_eq!(size_of::<T>() % 8, 0);
    // SAFETY: by the assertion above, the block consists of eight-byte numbers. Its alignment is theirs.
    unsafe { std::slice::from_raw_parts((block as *const T).cast(), size_of::<T>() / 8) }
}

fn finite<T>(block: &T) -> bool {
    numbers(block).iter().all(|x| x.is_finite())
}

impl Case {
    /// Runs the motion. Checks that every successful result is finite, and that an error changes nothing.
    pub fn run(&self, model: &dashpot_model, at_each_instant: bool) -> Result<Run, Failure> {
        // SAFETY: the structure contains only numbers, for which zero bytes are valid.
        let mut state: dashpot_state = unsafe { zeroed() };
        let mut run = Run { forces: Vec::new(), places: Vec::new(), refused: 0 };
        let fail = |step, what: String| Failure { step, by: f64::INFINITY, what };
        // SAFETY: an initialized model and a local state.
        if unsafe { dashpot_state_init(model, self.start, &mut state) } < 0 {
            run.refused += 1;
            return Ok(run);
        }
        if !finite(&state) {
            return Err(fail(0, format!("the state at the start is {:?}", numbers(&state))));
        }
        for (i, given) in self.motion.iter().enumerate() {
            let input = given.input();
            // SAFETY: the structure contains only numbers, for which zero bytes are valid.
            let mut output: dashpot_output = unsafe { zeroed() };
            if at_each_instant {
                // SAFETY: the structures contain only numbers, for which zero bytes are valid.
                let (mut rate, mut partials): (dashpot_state, dashpot_partials) = unsafe { (zeroed(), zeroed()) };
                // SAFETY: an initialized model and local blocks.
                let status = unsafe { dashpot_evaluate(model, &state, &input, &mut output, &mut rate) };
                if status >= 0 && !(finite(&output) && finite(&rate)) {
                    return Err(fail(
                        i,
                        format!("evaluate answers {status} with {:?} {:?}", numbers(&output), numbers(&rate)),
                    ));
                }
                // SAFETY: an initialized model and local blocks.
                let status = unsafe { dashpot_jacobian(model, &state, &input, &mut partials) };
                if status >= 0 && !finite(&partials) {
                    return Err(fail(i, format!("jacobian answers {status} with {:?}", numbers(&partials))));
                }
                // SAFETY: the structure contains only numbers, for which zero bytes are valid.
                output = unsafe { zeroed() };
            }
            let before = numbers(&state).to_vec();
            let state_at: *mut dashpot_state = &mut state;
            // SAFETY: an initialized model and local blocks. Both state pointers are equal, as the manual allows.
            let status = unsafe { dashpot_step(model, state_at, &input, given.dt, state_at, &mut output) };
            if status < 0 {
                run.refused += 1;
                if before.iter().zip(numbers(&state)).any(|(a, b)| a.to_bits() != b.to_bits()) {
                    return Err(fail(i, format!("refused with {status}, and the state has changed")));
                }
                continue;
            }
            if !(finite(&output) && finite(&state)) {
                return Err(fail(i, format!("status {status} with {:?} at {:?}", numbers(&output), numbers(&state))));
            }
            run.forces.push(output.force);
            run.places.push(state.displacement);
        }
        Ok(run)
    }

    /// Formats the case as code.
    pub fn describe(&self) -> String {
        let mut text = String::from("Case {\n");
        writeln!(text, "    on: vec!{:?},", self.on).unwrap();
        writeln!(text, "    values: vec![").unwrap();
        for (name, values) in &self.values {
            writeln!(text, "        ({name:?}, vec!{values:?}),").unwrap();
        }
        writeln!(text, "    ],\n    start: {:?},\n    motion: vec![", self.start).unwrap();
        for g in &self.motion {
            writeln!(
                text,
                "        Given {{ x: {:?}, v: {:?}, side: {:?}, temperature: {:?}, dt: {:?} }},",
                g.x, g.v, g.side, g.temperature, g.dt
            )
            .unwrap();
        }
        writeln!(text, "    ],\n    ordinary: {},\n}}", self.ordinary).unwrap();
        text
    }
}

/// Draws a parameter's value in its range, most often with a uniform logarithm, sometimes at an end or at the default.
fn scalar(r: &mut Random, low: f64, high: f64, default: f64) -> f64 {
    match r.one_of(8) {
        0 => low,
        1 => high,
        2 | 3 => default,
        4 => r.between(low, high),
        _ if low >= 0.0 => r.decade(if low > 0.0 { low } else { 1e-6 * high }, high).clamp(low, high),
        _ => {
            let size = r.decade(1e-6 * high.max(-low), high.max(-low));
            (if r.chance(0.5) { size } else { -size }).clamp(low, high)
        }
    }
}

/// Draws an increasing table with jumps and horizontal sections. Its abscissae span `width`, its ordinates are scaled by `height`.
fn rising(r: &mut Random, width: f64, height: f64) -> (Vec<f64>, Vec<f64>) {
    let most = if r.chance(0.1) { 61 } else { 14 };
    let n = 2 + r.one_of(most);
    let nearest = r.decade(1e-7, 0.1);
    let (mut x, mut f) = (vec![0.0], vec![0.0]);
    for _ in 1..n {
        let gap = if r.chance(0.3) { nearest } else { r.share() };
        let rise = match r.one_of(4) {
            0 => 0.0,
            1 => r.decade(1e-6, 1.0),
            _ => r.share(),
        };
        x.push(x[x.len() - 1] + gap);
        f.push(f[f.len() - 1] + rise);
    }
    let (span, top) = (x[n - 1], f[n - 1].max(1e-9));
    let off = if r.chance(0.7) { r.between(-1.0, 1.0) } else { 0.0 };
    // With probability 0.6, one point of the table lies at the origin, as for most dampers.
    let through = r.chance(0.6).then(|| r.one_of(n));
    let (x0, f0) = through.map_or((0.5 * span, 0.5 * top + off * top), |i| (x[i], f[i]));
    (x.iter().map(|x| (x - x0) / span * width).collect(), f.iter().map(|f| (f - f0) / top * height).collect())
}

/// Multiplies by `size` all parameters that grow with the size of the damper, including defaults. Clamps them to their bounds.
fn grow(values: &mut Vec<(&'static str, Vec<f64>)>, on: &[&'static str], size: f64) {
    for row in table().filter(|row| row.parameter.grows && on.contains(&GROUPS[row.group].name)) {
        let p = row.parameter;
        let grown = |values: &[f64]| values.iter().map(|v| (size * v).clamp(p.low, p.high)).collect();
        match values.iter_mut().find(|(name, _)| *name == p.name) {
            Some((_, drawn)) => *drawn = grown(drawn),
            None => values.push((p.name, grown(p.default))),
        }
    }
}

impl Case {
    /// Draws the parameters of a case in which these elements are on.
    pub fn set(r: &mut Random, on: Vec<&'static str>) -> Case {
        let mut values = Vec::new();
        // In some cases most parameters keep their defaults, because extreme values mask each other.
        let near = r.chance(0.4);
        for row in table() {
            let (p, group) = (row.parameter, GROUPS[row.group].name);
            if !on.contains(&group) && group != "integration" || near && r.chance(0.7) {
                continue;
            }
            match p.shape {
                Shape::Choice(words) => values.push((p.name, vec![r.one_of(words.len()) as f64])),
                Shape::Scalar if p.name == "substeps" => {
                    let n = if r.chance(0.7) { 0.0 } else { r.one_of(9) as f64 };
                    values.push((p.name, vec![n]));
                }
                Shape::Scalar => values.push((p.name, vec![scalar(r, p.of_a_car.0, p.of_a_car.1, p.default[0])])),
                Shape::List(n) if p.name == "polynomial" => {
                    let count = 1 + r.one_of(n);
                    values.push((p.name, (0..count).map(|_| r.between(-1e4, 1e4)).collect()));
                }
                Shape::List(_) => {}
            }
        }
        if on.contains(&"fv_curve") && r.chance(0.7) {
            let (width, height) = (r.decade(1e-2, 20.0), r.decade(10.0, 5e4));
            let (v, f) = rising(r, width, height);
            values.push(("fv_velocity", v));
            values.push(("fv_force", f));
        }
        if on.contains(&"parallel_spring") && r.chance(0.2) {
            let (width, height) = (r.decade(1e-2, 1.0), r.decade(1.0, 1e4));
            let (x, f) = rising(r, width, height);
            values.push(("spring_displacement", x));
            values.push(("spring_force", f));
        }
        // A separate generator draws the size, so that the other draws of a seed do not depend on it.
        let mut sizes = Random(r.0 ^ 0x73_69_7a_65);
        if sizes.chance(0.3) {
            grow(&mut values, &on, sizes.decade(SIZES.0, SIZES.1));
        }
        Case { on, values, start: 0.0, motion: Vec::new(), ordinary: true }
    }

    /// Draws a case with the elements `more` and all elements that are on by default. Sometimes only the FV curve and the series compliance
    /// remain of the latter.
    pub fn with(r: &mut Random, more: &[&'static str]) -> Case {
        let mut on: Vec<_> = names().filter(|n| dashpot_core::Params::new().is_on(Element::find(n).unwrap())).collect();
        if r.chance(0.3) {
            on.retain(|n| *n == "fv_curve" || *n == "series_compliance" && r.chance(0.7));
        }
        on.extend(more.iter().filter(|n| !on.contains(n)).copied().collect::<Vec<_>>());
        Case::set(r, on)
    }

    /// Draws a case with any elements.
    pub fn any(r: &mut Random) -> Case {
        let share = r.share();
        let on = names()
            .filter(|n| r.chance(if matches!(*n, "fv_curve" | "series_compliance") { 0.9 } else { share }))
            .collect();
        Case::set(r, on)
    }
}
