//! Model files of dampers that depend on a setting, as Python sees them.

use crate::errors::{ModelError, MotionError, raise};
use crate::model::Model;
use dashpot_core::family;
use dashpot_identification::model_file::{self, ModelFile};
use dashpot_records::MotionRecord;
use dashpot_simulation::imposed_motion::ImposedMotion;
use numpy::{AllowTypeChange, PyArray1, PyArrayLike1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::path::PathBuf;

/// A damper over a setting.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Family {
    file: ModelFile,
    prepared: Box<family::Family>,
    text: String,
}

#[pymethods]
impl Family {
    /// From the text of a model file; `name` is what errors call it.
    #[staticmethod]
    #[allow(clippy::needless_pass_by_value)]
    fn parse(text: String, name: PathBuf) -> PyResult<Family> {
        let file = model_file::family_of_text(&text, &name).map_err(raise::<ModelError>)?;
        let mut prepared = Box::new(family::Family::OFF);
        prepared.set(&file.params, &file.axis).map_err(|fault| {
            PyErr::new::<ModelError, _>(format!("{}: the setting {}", name.display(), fault.reason.text()))
        })?;
        Ok(Family { file, prepared, text })
    }

    /// The text of the model file.
    #[getter]
    fn text(&self) -> &str {
        &self.text
    }

    /// The settings of the file, the one where none is given, name and unit.
    fn setting(&self) -> (Vec<f64>, f64, &str, &str) {
        let axis = &self.file.axis;
        (axis.grid().to_vec(), axis.start(), axis.name(), axis.unit())
    }

    /// The ordinary damper at a setting.
    fn at(&self, setting: f64, name: PathBuf) -> PyResult<Model> {
        let text = model_file::plain(&self.file.definition().params_at(setting), &[]);
        Model::from_text(text, &name)
    }

    /// Times, displacements, velocities and forces for a motion with a setting for each of its times.
    #[allow(clippy::needless_pass_by_value, clippy::type_complexity)]
    fn simulate<'py>(
        &self,
        py: Python<'py>,
        time: PyArrayLike1<'py, f64, AllowTypeChange>,
        displacement: Option<PyArrayLike1<'py, f64, AllowTypeChange>>,
        velocity: Option<PyArrayLike1<'py, f64, AllowTypeChange>>,
        setting: PyArrayLike1<'py, f64, AllowTypeChange>,
        initial_position: Option<f64>,
    ) -> PyResult<[Bound<'py, PyArray1<f64>>; 4]> {
        let numbers = |values: PyArrayLike1<'py, f64, AllowTypeChange>| values.as_array().to_vec();
        let (time, setting) = (numbers(time), numbers(setting));
        let (displacement, velocity) = (displacement.map(numbers), velocity.map(numbers));
        let channels =
            [("displacement", displacement.as_ref()), ("velocity", velocity.as_ref()), ("setting", Some(&setting))];
        for (name, values) in channels.into_iter().filter_map(|(name, values)| Some((name, values?))) {
            if values.len() != time.len() || values.iter().any(|value| !value.is_finite()) {
                return Err(PyValueError::new_err(format!("{name} needs one finite number for every time")));
            }
        }
        if displacement.is_none() && velocity.is_none() {
            return Err(PyValueError::new_err("a motion needs displacement or velocity"));
        }
        let increases = time.windows(2).all(|pair| pair[0] < pair[1]) && time.iter().all(|t| t.is_finite());
        if time.len() < 2 || !increases {
            return Err(PyValueError::new_err("a motion has at least two times, which increase"));
        }
        let record = MotionRecord { time: time.clone(), displacement, velocity, side_force: None, temperature: None };
        let answers = py.detach(|| {
            let motion = ImposedMotion::new(record, initial_position)?;
            let at = |t: f64| setting[time.partition_point(|other| *other < t).min(setting.len() - 1)];
            motion.drive_family(&self.prepared, &at)
        });
        let answers = answers.map_err(raise::<MotionError>)?;
        let column = |of: fn(&dashpot_simulation::imposed_motion::SimulatedSample) -> f64| {
            PyArray1::from_vec(py, answers.iter().map(of).collect())
        };
        Ok([column(|a| a.time), column(|a| a.displacement), column(|a| a.velocity), column(|a| a.force)])
    }
}
