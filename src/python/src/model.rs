//! Model files as Python objects, and the forces of their dampers.

use crate::errors::{ModelError, MotionError, OutputError, raise, say};
use crate::work;
use dashpot_core::parameter::GROUPS;
use dashpot_core::parameter::{self, Element, Shape};
use dashpot_core::{Input, evaluate};
use dashpot_identification::model_file::{self, Interval, ModelFile};
use dashpot_messages::format_number;
use dashpot_output::as_a_run;
use dashpot_records::MotionRecord;
use dashpot_simulation::imposed_motion::{ImposedMotion, PROGRESS_INTERVAL};
use numpy::{AllowTypeChange, PyArray1, PyArrayLike1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// Damper, with the text and the contents of its model file.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Model {
    /// Contents of the file.
    pub file: ModelFile,
    /// Model that the kernel runs, prepared from the parameters.
    pub prepared: Box<dashpot_core::Model>,
    text: String,
    /// Parameters that have an effect. They are determined at the first request, because determining them takes some thousand times as long
    /// as a step.
    in_use: OnceLock<Vec<parameter::Row>>,
}

/// Parameter that has an effect, with the results of the fit for it.
#[derive(Serialize)]
struct ParameterJson<'a> {
    name: &'a str,
    element: &'a str,
    unit: &'a str,
    meaning: &'a str,
    value: ValueJson<'a>,
    interval: Option<IntervalJson<'a>>,
    source: Option<&'a str>,
    identified: bool,
}

#[derive(Serialize)]
#[serde(untagged)]
enum ValueJson<'a> {
    Number(f64),
    Word(&'a str),
    List(&'a [f64]),
}

#[derive(Serialize)]
#[serde(untagged)]
enum IntervalJson<'a> {
    Number([f64; 2]),
    List(&'a [[f64; 2]]),
}

#[derive(Serialize)]
struct ModelJson<'a> {
    elements: Vec<&'a str>,
    parameters: Vec<ParameterJson<'a>>,
    tests: &'a [String],
    not_identified: &'a [String],
    notes: &'a [String],
}

impl Model {
    /// Makes a model from the text of a model file. `name` is its name in error messages.
    pub fn from_text(text: String, name: &Path) -> PyResult<Model> {
        let file = model_file::of_text(&text, name).map_err(|error| {
            match model_file::family_of_text(&text, name) {
                Ok(file) if file.axis.is_some() => say::<ModelError>(format!(
                    "{} is a damper over a setting: dashpot.Family.read reads it, and at(setting) is the ordinary damper there",
                    name.display()
                )),
                _ => raise::<ModelError>(error),
            }
        })?;
        let prepared = model_file::prepared(&file.params).map_err(raise::<ModelError>)?;
        Ok(Model { file, prepared: Box::new(prepared), text, in_use: OnceLock::new() })
    }

    /// Returns the text of the model file.
    pub fn text_of_file(&self) -> &str {
        &self.text
    }
}

#[pymethods]
impl Model {
    /// Reads a model file.
    #[staticmethod]
    fn read(path: PathBuf) -> PyResult<Model> {
        // The reader has its own error message for a file that is missing or is not text.
        let text = dashpot_records::read_small_text(&path)
            .map_err(|why| raise::<ModelError>(model_file::ModelFileError::Unreadable { file: path.clone(), why }))?;
        Model::from_text(text, &path)
    }

    /// Makes a model from the text of a model file. `name` is its name in error messages.
    #[staticmethod]
    fn parse(text: String, name: PathBuf) -> PyResult<Model> {
        Model::from_text(text, &name)
    }

    /// Returns the text of the model file.
    #[getter]
    fn text(&self) -> &str {
        &self.text
    }

    /// Returns elements, parameters and the results of the fit as JSON.
    fn json(&self) -> PyResult<String> {
        let known = &self.file.identification;
        let row = |row: &parameter::Row| {
            let p = row.parameter;
            let values = self.file.params.get(row);
            ParameterJson {
                name: p.name,
                element: GROUPS[row.group].name,
                unit: p.unit,
                meaning: p.meaning,
                value: match p.shape {
                    Shape::Scalar => ValueJson::Number(values[0]),
                    Shape::Choice(words) => ValueJson::Word(words[values[0] as usize]),
                    Shape::List(_) => ValueJson::List(values),
                },
                interval: known.intervals.get(p.name).map(|interval| match interval {
                    Interval::Number(pair) => IntervalJson::Number(*pair),
                    Interval::List(pairs) => IntervalJson::List(pairs),
                }),
                source: known.sources.get(p.name).map(String::as_str),
                identified: known.intervals.contains_key(p.name) && !known.not_identified.iter().any(|n| n == p.name),
            }
        };
        let is_on = |element: &Element| self.file.params.is_on(*element);
        let rows = self.in_use.get_or_init(|| model_file::in_use(&self.file.params));
        let said = ModelJson {
            elements: Element::all().filter(is_on).map(Element::name).collect(),
            parameters: rows.iter().map(row).collect(),
            tests: &known.tests,
            not_identified: &known.not_identified,
            notes: &self.file.notes(),
        };
        serde_json::to_string(&said).map_err(raise::<ModelError>)
    }

    /// Returns the lowest and the highest velocity, m/s, of the FV curve. Beyond them, the curve is extrapolated linearly.
    fn velocity_range(&self) -> (f64, f64) {
        self.prepared.elements().paths.fv_curve.range()
    }

    /// Returns the forces, N, of the damper in steady motion at each velocity, m/s, at displacement 0.
    #[pyo3(signature = (velocity, progress=None))]
    #[allow(clippy::needless_pass_by_value)]
    fn steady_force<'py>(
        &self,
        py: Python<'py>,
        velocity: PyArrayLike1<'py, f64, AllowTypeChange>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let velocity = velocity.as_array().to_vec();
        let forces = |tell: &dyn Fn(usize, usize)| -> Result<Vec<f64>, f64> {
            let mut forces = Vec::with_capacity(velocity.len());
            for (k, v) in velocity.iter().enumerate() {
                if k % PROGRESS_INTERVAL == 0 {
                    tell(k, velocity.len());
                }
                let input = Input::motion(0.0, *v);
                let force = evaluate::force(&self.prepared, &self.prepared.steady_state(&input), &input).force;
                forces.push(if force.is_finite() { force } else { return Err(*v) });
            }
            Ok(forces)
        };
        let forces = long(py, progress, velocity.len(), "evaluating", forces)?;
        let forces = forces.map_err(|v| {
            PyValueError::new_err(format!(
                "there is no finite force at {} m/s: it is no velocity of a damper",
                format_number(v)
            ))
        })?;
        Ok(PyArray1::from_vec(py, forces))
    }

    /// Simulates a motion, resampled at `step`, s, if it is given. Returns times, s, displacements, m, velocities, m/s, and forces, N.
    #[pyo3(signature = (time, displacement, velocity, side_force, temperature, initial_position, step, progress=None))]
    #[allow(clippy::too_many_arguments, clippy::type_complexity)]
    fn simulate<'py>(
        &self,
        py: Python<'py>,
        time: PyArrayLike1<'py, f64, AllowTypeChange>,
        displacement: Option<PyArrayLike1<'py, f64, AllowTypeChange>>,
        velocity: Option<PyArrayLike1<'py, f64, AllowTypeChange>>,
        side_force: Option<PyArrayLike1<'py, f64, AllowTypeChange>>,
        temperature: Option<PyArrayLike1<'py, f64, AllowTypeChange>>,
        initial_position: Option<f64>,
        step: Option<f64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<[Bound<'py, PyArray1<f64>>; 4]> {
        let time = time.as_array().to_vec();
        let channel = |name: &str, values: Option<PyArrayLike1<'py, f64, AllowTypeChange>>| {
            let values = values.map(|v| v.as_array().to_vec());
            match &values {
                Some(v) if v.len() != time.len() => Err(PyValueError::new_err(format!(
                    "{name} has {} samples, time_s has {}: give one value for every time",
                    v.len(),
                    time.len()
                ))),
                Some(v) if v.iter().any(|x| !x.is_finite()) => {
                    Err(PyValueError::new_err(format!("{name} holds a value that is no finite number")))
                }
                _ => Ok(values),
            }
        };
        let record = MotionRecord {
            displacement: channel("displacement_m", displacement)?,
            velocity: channel("velocity_m_s", velocity)?,
            side_force: channel("side_force_n", side_force)?,
            temperature: channel("temperature_c", temperature)?,
            time: time.clone(),
            ..MotionRecord::default()
        };
        if time.len() < 2 {
            return Err(PyValueError::new_err("a motion has at least two times"));
        }
        if let Some(k) = time.windows(2).position(|t| !(t[0] < t[1] && t[1].is_finite() && t[0].is_finite())) {
            return Err(PyValueError::new_err(format!(
                "time_s must increase from sample to sample, and does not from {} to {} s",
                format_number(time[k]),
                format_number(time[k + 1])
            )));
        }
        if record.displacement.is_none() && record.velocity.is_none() {
            return Err(PyValueError::new_err("a motion needs displacement_m or velocity_m_s"));
        }
        // Number of steps of the simulation. An invalid `step` is rejected later, by the resampling.
        let instants = match step {
            Some(step) if step > 0.0 => ((time[time.len() - 1] - time[0]) / step) as usize,
            _ => time.len(),
        };
        let answers = long(py, progress, instants.max(time.len()), "simulating", |tell| {
            let mut motion = ImposedMotion::new(record, initial_position)?;
            if let Some(step) = step {
                motion = motion.resampled(step)?;
            }
            motion.drive_telling(&self.prepared, tell)
        })?;
        let answers = answers.map_err(raise::<MotionError>)?;
        let column = |of: fn(&dashpot_simulation::imposed_motion::SimulatedSample) -> f64| {
            PyArray1::from_vec(py, answers.iter().map(of).collect())
        };
        Ok([column(|a| a.time), column(|a| a.displacement), column(|a| a.velocity), column(|a| a.force)])
    }
}

/// Runs work without the interpreter lock.
///
/// Work with at most [`PROGRESS_INTERVAL`] steps runs in this thread, because it ends before a check for Ctrl-C. This saves a tenth of a
/// millisecond compared with separate threads.
fn long<T: Send>(
    py: Python<'_>,
    progress: Option<Py<PyAny>>,
    steps: usize,
    text: &str,
    work: impl FnOnce(&dyn Fn(usize, usize)) -> T + Send,
) -> PyResult<T> {
    if steps <= PROGRESS_INTERVAL {
        let done = py.detach(|| work(&|_, _| {}));
        progress.map(|tell| tell.call1(py, (1.0, text))).transpose()?;
        return Ok(done);
    }
    work::run(py, progress, |progress| work(&|done, all| progress.say(done as f64 / all as f64, text)))
}

/// Writes a text to a file atomically. Without `force`, a device, a write-protected file or an existing file of another kind is an error.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn write(path: PathBuf, text: &str, force: bool) -> PyResult<()> {
    let written = as_a_run(force, [], || {
        dashpot_output::check([path.as_path()])?;
        dashpot_output::write(&path, text)
    });
    written.map_err(raise::<OutputError>)
}
