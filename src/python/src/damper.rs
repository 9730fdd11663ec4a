//! Simulation of many dampers in one step, without a memory allocation for each damper.

use crate::errors::{StepError, say};
use crate::model::Model;
use crate::work;
use dashpot_core::step::step_into;
use dashpot_core::{Input, Output, State};
use dashpot_messages::format_number;
use numpy::ndarray::{ArrayView1, ArrayViewMut1};
use numpy::{
    AllowTypeChange, PyArray1, PyArray2, PyArrayLike2, PyArrayMethods as _, PyReadonlyArray1, PyReadwriteArray1,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use rayon::prelude::*;

/// Number of values of a damper's state.
const NUMBERS: usize = 14;
/// Shortest and longest accepted step, s, equal to the limits of the C interface.
const STEP: std::ops::RangeInclusive<f64> = 1e-15..=100.0;
/// Largest accepted sum of |displacement|, m, and |velocity|, m/s, equal to the limit of the C interface.
const LARGEST: f64 = 1e3;
/// Largest accepted |side force|, N, equal to the limit of the C interface.
const LARGEST_SIDE_FORCE: f64 = 1e9;
/// Largest accepted |temperature|, °C, equal to the limit of the C interface.
const LARGEST_TEMPERATURE: f64 = 1e5;
/// Limits of the inputs in messages.
const LIMITS: &str = "give at most 1000 m and m/s together, 1e9 N and 1e5 °C";
/// Smallest number of dampers at which a step is distributed over threads. Fewer dampers are stepped by the calling thread, because the
/// distribution costs some microseconds and the step of one damper about half a microsecond.
const SHARED: usize = 256;
/// Number of dampers in each unit of work of a thread.
const CHUNK: usize = 64;

/// Values of one channel: one value for all dampers, or one for each.
enum Channel<'py> {
    /// One value for all dampers.
    One(f64),
    /// One value for each damper.
    Each(PyReadonlyArray1<'py, f64>),
}

/// Values of one channel without Python objects.
#[derive(Clone, Copy)]
enum Values<'a> {
    One(f64),
    Each(ArrayView1<'a, f64>),
}

impl<'py> Channel<'py> {
    fn of(name: &str, given: &Bound<'py, PyAny>) -> PyResult<Channel<'py>> {
        if let Ok(array) = given.cast::<PyArray1<f64>>() {
            let Ok(values) = array.try_readonly() else {
                return Err(PyValueError::new_err(format!(
                    "out is {name} too; give an array of its own for the forces"
                )));
            };
            return Ok(Channel::Each(values));
        }
        if let Ok(one) = given.extract() {
            return Ok(Channel::One(one));
        }
        // Python code converts other objects that represent numbers, or raises an error with a message.
        let column = given.py().import("dashpot._numbers")?.getattr("column")?.call1((name, given))?;
        Ok(Channel::Each(column.extract()?))
    }

    fn values(&self, name: &str, count: usize) -> PyResult<Values<'_>> {
        match self {
            Channel::One(value) => Ok(Values::One(*value)),
            Channel::Each(values) => {
                let values = values.as_array();
                if values.len() != count {
                    return Err(PyValueError::new_err(format!(
                        "{name} has {} values; give one number, or one for each of the {count} dampers",
                        values.len()
                    )));
                }
                Ok(Values::Each(values))
            }
        }
    }
}

impl Values<'_> {
    fn at(&self, k: usize) -> f64 {
        match self {
            Values::One(value) => *value,
            Values::Each(values) => values[k],
        }
    }
}

/// Returns write access to the array for the forces. Raises a `TypeError` for any other object.
fn writable<'py>(out: &Bound<'py, PyAny>) -> PyResult<PyReadwriteArray1<'py, f64>> {
    let writable = out.cast::<PyArray1<f64>>().ok().and_then(|array| array.try_readwrite().ok());
    writable.ok_or_else(|| {
        PyTypeError::new_err(
            "out must be a numpy array of one float64 for each damper that may be written into, such as numpy.empty(4)",
        )
    })
}

/// Inputs of all dampers at one instant.
#[derive(Clone, Copy)]
struct Inputs<'a> {
    displacement: Option<Values<'a>>,
    velocity: Values<'a>,
    side_force: Values<'a>,
    temperature: Values<'a>,
}

impl Inputs<'_> {
    fn at(&self, k: usize) -> Input {
        Input {
            displacement: self.displacement.map(|x| x.at(k)),
            velocity: self.velocity.at(k),
            side_force: self.side_force.at(k),
            temperature: self.temperature.at(k),
        }
    }
}

/// Returns whether all inputs lie within their limits. Returns false for NaN.
fn sane(input: &Input) -> bool {
    input.displacement.unwrap_or(0.0).abs() + input.velocity.abs() <= LARGEST
        && input.side_force.abs() <= LARGEST_SIDE_FORCE
        && input.temperature.abs() <= LARGEST_TEMPERATURE
}

/// Returns whether the displacement exceeds 0.5 m or the velocity 20 m/s, for example because they are in millimeters. The reader of
/// records rejects such motions.
fn is_of_no_damper(input: &Input) -> bool {
    input.displacement.unwrap_or(0.0).abs() > 0.5 || input.velocity.abs() > 20.0
}

/// Dampers with their states. All have one common model, or each has its own model.
#[pyclass(module = "dashpot._native")]
pub struct Dampers {
    models: Vec<Py<Model>>,
    states: Vec<State>,
    /// Buffer for the states after the step. It is separate, so that a rejected step leaves the current states unchanged.
    next: Vec<State>,
}

#[pymethods]
impl Dampers {
    /// Makes dampers in steady motion at their initial positions, m, initial velocities, m/s, side forces, N, and temperatures, °C.
    ///
    /// At nonzero velocity, the state corresponds to `dashpot_state_init_motion` of the C interface. At velocity 0 it corresponds to
    /// `dashpot_state_init`.
    #[new]
    fn new(
        py: Python<'_>,
        models: Vec<Py<Model>>,
        initial_position: Vec<f64>,
        initial_velocity: Vec<f64>,
        side_force: Vec<f64>,
        temperature: Vec<f64>,
    ) -> PyResult<Dampers> {
        if models.len() != 1 && models.len() != initial_position.len() {
            return Err(PyValueError::new_err(format!(
                "{} models for {} dampers: give one model for all, or one for each",
                models.len(),
                initial_position.len()
            )));
        }
        if let Some(x) = initial_position.iter().find(|x| x.is_nan() || x.abs() > LARGEST) {
            return Err(say::<StepError>(format!(
                "initial_position_m is {} m, which is no position; give -{LARGEST} to {LARGEST} m",
                format_number(*x)
            )));
        }
        let count = initial_position.len();
        for (name, given) in [
            ("initial_velocity_m_s", &initial_velocity),
            ("side_force_n", &side_force),
            ("temperature_c", &temperature),
        ] {
            if given.len() != count {
                return Err(PyValueError::new_err(format!(
                    "{name} has {} values; give one number, or one for each of the {count} dampers, of which initial_position_m says how many",
                    given.len()
                )));
            }
        }
        let settled = |k: usize| {
            let input = Input {
                side_force: side_force[k],
                temperature: temperature[k],
                ..Input::motion(initial_position[k], initial_velocity[k])
            };
            let state = models[if models.len() == 1 { 0 } else { k }].get().prepared.steady_state(&input);
            (sane(&input) && state.is_finite()).then_some(state).ok_or(k)
        };
        let states = py.detach(|| (0..count).map(settled).collect::<Result<Vec<State>, usize>>());
        let states = states.map_err(|k| {
            say::<StepError>(format!(
                "damper {k} cannot start so: position {} m, velocity {} m/s, side force {} N, temperature {} °C; {LIMITS}",
                format_number(initial_position[k]),
                format_number(initial_velocity[k]),
                format_number(side_force[k]),
                format_number(temperature[k])
            ))
        })?;
        Ok(Dampers { models, next: states.clone(), states })
    }

    fn __len__(&self) -> usize {
        self.states.len()
    }

    /// Steps all dampers by `dt` (s) to the given inputs, and writes their forces (N) to `out`. Returns whether a motion is too large for a
    /// damper, so that the caller can warn.
    #[pyo3(signature = (velocity, dt, displacement, side_force, temperature, out))]
    #[allow(clippy::too_many_arguments, clippy::needless_pass_by_value)]
    fn step<'py>(
        slf: &Bound<'py, Self>,
        py: Python<'py>,
        velocity: &Bound<'py, PyAny>,
        dt: f64,
        displacement: Option<&Bound<'py, PyAny>>,
        side_force: &Bound<'py, PyAny>,
        temperature: &Bound<'py, PyAny>,
        out: &Bound<'py, PyAny>,
    ) -> PyResult<bool> {
        let Ok(mut own) = slf.try_borrow_mut() else {
            return Err(say::<StepError>(
                "another thread is stepping these dampers; give each thread dampers of its own",
            ));
        };
        let own = &mut *own;
        let mut out = writable(out)?;
        let velocity = Channel::of("velocity_m_s", velocity)?;
        let displacement = displacement.map(|x| Channel::of("displacement_m", x)).transpose()?;
        let side_force = Channel::of("side_force_n", side_force)?;
        let temperature = Channel::of("temperature_c", temperature)?;
        let count = own.states.len();
        if !STEP.contains(&dt) {
            return Err(say::<StepError>(format!(
                "dt_s is {} s; it must be between 1e-15 and 100 s",
                format_number(dt)
            )));
        }
        if out.as_array().len() != count {
            return Err(PyValueError::new_err(format!(
                "out has {} values for {count} dampers; give an array of one float64 for each",
                out.as_array().len()
            )));
        }
        let inputs = Inputs {
            displacement: displacement.as_ref().map(|x| x.values("displacement_m", count)).transpose()?,
            velocity: velocity.values("velocity_m_s", count)?,
            side_force: side_force.values("side_force_n", count)?,
            temperature: temperature.values("temperature_c", count)?,
        };
        if let Some(k) = (0..count).find(|k| !sane(&inputs.at(*k))) {
            let Input { displacement, velocity, side_force, temperature } = inputs.at(k);
            return Err(say::<StepError>(format!(
                "an input of damper {k} is NaN, infinite or absurd: displacement {} m, velocity {} m/s, side force \
                 {} N, temperature {} °C; {LIMITS}",
                format_number(displacement.unwrap_or(0.0)),
                format_number(velocity),
                format_number(side_force),
                format_number(temperature)
            )));
        }
        let models: &[Py<Model>] = &own.models;
        let (states, next) = (&own.states[..], &mut own.next[..]);
        let forces = out.as_array_mut();
        let refused = if count == 1 {
            // For one damper, releasing and reacquiring the interpreter lock costs as much as the step, so keep the lock.
            run(models, states, next, forces, &inputs, dt)
        } else {
            // With fewer dampers than `SHARED`, the calling thread does all the work.
            let pool = if count >= SHARED { work::pool(py) } else { None };
            let step = move || run(models, states, next, forces, &inputs, dt);
            py.detach(move || match pool {
                Some(pool) => pool.install(step),
                None => step(),
            })
        };
        if let Some(k) = refused {
            return Err(say::<StepError>(format!(
                "the force of damper {k} is no finite number: its input or state is far from what a damper meets"
            )));
        }
        std::mem::swap(&mut own.states, &mut own.next);
        Ok((0..count).any(|k| is_of_no_damper(&inputs.at(k))))
    }

    /// Returns a copy of all states, with one row of fourteen numbers for each damper.
    #[getter]
    fn get_state<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let array = PyArray2::zeros(py, [self.states.len(), NUMBERS], false);
        {
            let mut rows = array.try_readwrite()?;
            let mut rows = rows.as_array_mut();
            for (mut row, state) in rows.outer_iter_mut().zip(&self.states) {
                let own = [state.displacement, state.velocity, state.mass_displacement, state.mass_velocity];
                let own = own.into_iter().chain(state.internal).chain([state.layout, state.reserved]);
                row.iter_mut().zip(own).for_each(|(to, from)| *to = from);
            }
        }
        Ok(array)
    }

    /// Restores states that `get_state` returned.
    #[setter]
    #[allow(clippy::needless_pass_by_value)]
    fn set_state(&mut self, rows: PyArrayLike2<'_, f64, AllowTypeChange>) -> PyResult<()> {
        let rows = rows.as_array();
        if rows.dim() != (self.states.len(), NUMBERS) {
            return Err(PyValueError::new_err(format!(
                "the state is an array of {} by {NUMBERS} numbers",
                self.states.len()
            )));
        }
        if rows.iter().any(|x| !x.is_finite()) {
            return Err(say::<StepError>("the state holds NaN or infinity"));
        }
        for (row, state) in rows.outer_iter().zip(&mut self.states) {
            let at = |k: usize| row[k];
            *state = State {
                displacement: at(0),
                velocity: at(1),
                mass_displacement: at(2),
                mass_velocity: at(3),
                internal: std::array::from_fn(|m| at(4 + m)),
                layout: at(12),
                reserved: at(13),
            };
        }
        Ok(())
    }
}

/// Steps all dampers. If a damper has no finite force, returns the index of the first such damper.
fn run(
    models: &[Py<Model>],
    states: &[State],
    next: &mut [State],
    mut forces: ArrayViewMut1<'_, f64>,
    inputs: &Inputs<'_>,
    dt: f64,
) -> Option<usize> {
    let one = |k: usize, state: &State, next: &mut State, force: &mut f64| {
        let model = &models[if models.len() == 1 { 0 } else { k }].get().prepared;
        let mut output = Output::ZERO;
        let done = step_into(model, state, &inputs.at(k), dt, next, &mut output) && output.force.is_finite();
        if done {
            *force = output.force;
        }
        done
    };
    match forces.as_slice_mut() {
        Some(forces) if states.len() >= SHARED => {
            let chunks = next.par_chunks_mut(CHUNK).zip(forces.par_chunks_mut(CHUNK)).enumerate();
            chunks
                .filter_map(|(c, (next, forces))| {
                    let from = c * CHUNK;
                    (0..next.len())
                        .find(|i| !one(from + i, &states[from + i], &mut next[*i], &mut forces[*i]))
                        .map(|i| from + i)
                })
                .min()
        }
        _ => (0..states.len()).find(|k| !one(*k, &states[*k], &mut next[*k], &mut forces[*k])),
    }
}
