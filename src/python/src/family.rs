//! Model files of dampers that depend on a setting, as Python objects.

use crate::campaign::Campaign;
use crate::compare::figures;
use crate::dimensions::priors;
use crate::errors::{FitError, ModelError, MotionError, ValidationError, raise, say};
use crate::limits;
use crate::model::Model;
use crate::work;
use dashpot_core::family;
use dashpot_identification::FitOptions;
use dashpot_identification::family::{FamilyFigures, fit_family as fit};
use dashpot_identification::limits::{SettingsFigures, judge_over_settings, restate_settings_of_limits};
use dashpot_identification::model_file::{self, ModelFile};
use dashpot_identification::setting_units::restate_settings;
use dashpot_messages::format_number;
use dashpot_records::hold_out::kept;
use dashpot_records::{MotionRecord, Record};
use dashpot_simulation::comparison::{compare_family, settings_of, summarize_settings};
use dashpot_simulation::imposed_motion::ImposedMotion;
use dashpot_simulation::prediction::at_velocities;
use dashpot_simulation::step_response::step_responses;
use numpy::{AllowTypeChange, PyArray1, PyArrayLike1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::path::PathBuf;

/// Forces of the model and of the FV curve alone at the samples of one test, N.
type Forces<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

/// Raises a `ValueError` if one of the settings exceeds the largest setting of any damper. `name` is the name of the argument.
pub fn check_settings<'a>(name: &str, values: impl IntoIterator<Item = &'a f64>) -> PyResult<()> {
    let is_beyond = |value: &&f64| !(value.abs() <= family::LARGEST_SETTING);
    values.into_iter().find(is_beyond).map_or(Ok(()), |value| {
        let (number, largest) = (format_number(*value), format_number(family::LARGEST_SETTING));
        Err(PyValueError::new_err(format!("{name} {number} is that of no damper; give -{largest} to {largest}")))
    })
}

/// Damper over a setting, with the text and the contents of its model file.
#[pyclass(frozen, module = "dashpot._native")]
pub struct Family {
    /// Contents of the model file.
    pub file: ModelFile,
    prepared: Box<family::Family>,
    text: String,
}

#[pymethods]
impl Family {
    /// Makes a family from the text of a model file. `name` is its name in error messages.
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

    /// Returns the text of the model file.
    #[getter]
    fn text(&self) -> &str {
        &self.text
    }

    /// Returns the values of the setting in the file, its start value, its name and its unit.
    fn setting(&self) -> (Vec<f64>, f64, &str, &str) {
        let axis = &self.file.axis;
        (axis.grid().to_vec(), axis.start(), axis.name(), axis.unit())
    }

    /// Returns the ordinary damper that the family has at the constant setting `setting`. `name` is its name in error messages.
    fn at(&self, setting: f64, name: PathBuf) -> PyResult<Model> {
        check_settings("setting", [&setting])?;
        let text = model_file::plain(&self.file.definition().params_at(setting), &[]);
        Model::from_text(text, &name)
    }

    /// Returns the force, N, of the damper in steady motion at each pair of a velocity, m/s, and a setting. Both arrays must have the same
    /// length. A force that is not finite is NaN.
    fn steady_force<'py>(
        &self,
        py: Python<'py>,
        velocity: PyArrayLike1<'py, f64, AllowTypeChange>,
        setting: PyArrayLike1<'py, f64, AllowTypeChange>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let (velocity, setting) = (velocity.as_array().to_vec(), setting.as_array().to_vec());
        if velocity.len() != setting.len() {
            return Err(PyValueError::new_err("setting needs one number for every velocity"));
        }
        check_settings("setting", &setting)?;
        if velocity.iter().any(|value| !value.is_finite()) {
            return Err(PyValueError::new_err("velocity needs finite numbers"));
        }
        let forces = py.detach(|| {
            let definition = self.file.definition();
            let mut order: Vec<usize> = (0..setting.len()).collect();
            order.sort_by(|a, b| setting[*a].total_cmp(&setting[*b]));
            let mut forces = vec![f64::NAN; velocity.len()];
            // Prepare the damper only once for each distinct setting.
            for run in order.chunk_by(|a, b| setting[*a] == setting[*b]) {
                let model = model_file::prepared(&definition.params_at(setting[run[0]]))?;
                for place in run {
                    let found = at_velocities(&model, &[velocity[*place]]);
                    forces[*place] = found.first().map_or(f64::NAN, |point| point[1]);
                }
            }
            Ok::<_, model_file::NoModel>(forces)
        });
        Ok(PyArray1::from_vec(py, forces.map_err(raise::<ModelError>)?))
    }

    /// Compares the family with records like `dashpot validate`, and with limits if they are given. If a test states no setting, the
    /// `given` setting applies. Returns the figures as JSON, the simulated forces of every test, the compared records, and warnings about
    /// doubtful settings.
    #[pyo3(signature = (campaign, given=None, progress=None, limits=None))]
    fn validate<'py>(
        &self,
        py: Python<'py>,
        campaign: &Campaign,
        given: Option<f64>,
        progress: Option<Py<PyAny>>,
        limits: Option<Vec<limits::Row>>,
    ) -> PyResult<(String, Vec<Forces<'py>>, Campaign, Vec<String>)> {
        check_settings("setting", &given)?;
        let file = &self.file;
        let mut windows = limits.map(limits::of_rows).transpose()?;
        if let Some(windows) = &mut windows {
            restate_settings_of_limits(windows, file.axis.unit()).map_err(raise::<ValidationError>)?;
        }
        let done = work::run(py, progress, |progress| -> anyhow::Result<_> {
            let say = |done: usize, total: usize| progress.say(done as f64 / total.max(1) as f64, "simulating");
            let mut read = campaign.read.clone();
            restate_settings(&file.axis, &mut read.records)?;
            let note = file.identification.right(&mut read.records);
            read.notes.extend(note);
            // Tests with several settings are expected here, so remove the warning about them.
            read.accept_settings();
            let compared = compare_family(file, &read, given, &say)?;
            let mut validation = figures(&read, &compared, None, &[])?;
            let settings = summarize_settings(&mut validation, file, (&read, &compared), given)?;
            if let Some(windows) = &windows {
                let records: Vec<&Record> = compared.iter().map(|c| c.record).collect();
                let forces: Vec<&[f64]> = compared.iter().map(|c| c.model.as_slice()).collect();
                validation.limits =
                    Some(judge_over_settings(windows, (&records, &settings), &forces, &validation.step_responses)?);
            }
            let json = serde_json::to_string(&validation)?;
            let forces: Vec<_> = compared.into_iter().map(|c| (c.model, c.fv_only)).collect();
            let unit = file.axis.unit();
            let doubts = validation.setting_doubts.iter().map(|doubt| doubt.sentence(unit).to_string()).collect();
            Ok((json, forces, read, doubts))
        })?;
        let (json, forces, read, doubts) = done.map_err(raise::<ValidationError>)?;
        let array = |values| PyArray1::from_vec(py, values);
        let forces = forces.into_iter().map(|(model, fv_only)| (array(model), array(fv_only))).collect();
        Ok((json, forces, Campaign { read }, doubts))
    }

    /// Measures the figures of records for limits, with the response times of the steps of the setting. The records are those that
    /// [`Family::validate`] returned.
    #[pyo3(signature = (campaign, progress=None))]
    fn measure(
        &self,
        py: Python<'_>,
        campaign: &Campaign,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<limits::SettingsFigures> {
        let file = &self.file;
        let of = work::run(py, progress, |progress| -> anyhow::Result<_> {
            progress.say(0.0, "measuring");
            let records = campaign.records();
            let settings = settings_of(file, &campaign.read, None)?;
            let changing: Vec<&Record> = records
                .iter()
                .zip(&settings)
                .filter(|(_, setting)| setting.is_none())
                .map(|(record, _)| *record)
                .collect();
            let responses = step_responses(&file.definition(), &changing)?;
            Ok(SettingsFigures::measure((&records, &settings), &responses))
        })?;
        Ok(limits::SettingsFigures { of: of.map_err(raise::<ValidationError>)? })
    }

    /// Simulates a motion with a setting at each time. Returns times, s, displacements, m, velocities, m/s, and forces, N. The setting at a
    /// sample is the command during the step that ends at this sample.
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
        check_settings("setting", &setting)?;
        if displacement.is_none() && velocity.is_none() {
            return Err(PyValueError::new_err("a motion needs displacement or velocity"));
        }
        let increases = time.windows(2).all(|pair| pair[0] < pair[1]) && time.iter().all(|t| t.is_finite());
        if time.len() < 2 || !increases {
            return Err(PyValueError::new_err("a motion has at least two times, which increase"));
        }
        let record = MotionRecord { time, displacement, velocity, ..MotionRecord::default() };
        let answers = py.detach(|| {
            let motion = ImposedMotion::new(record, initial_position)?;
            motion.drive_family(&self.prepared, &|sample| setting[sample])
        });
        let answers = answers.map_err(raise::<MotionError>)?;
        let column = |of: fn(&dashpot_simulation::imposed_motion::SimulatedSample) -> f64| {
            PyArray1::from_vec(py, answers.iter().map(of).collect())
        };
        Ok([column(|a| a.time), column(|a| a.displacement), column(|a| a.velocity), column(|a| a.force)])
    }
}

/// Fits a damper over a setting. Returns the text of its model file, and the figures as JSON.
#[pyfunction]
#[pyo3(signature = (campaign, setting, elements=None, hold_out=Vec::new(), progress=None, dimensions=None))]
pub fn fit_family(
    py: Python<'_>,
    campaign: &Campaign,
    setting: &str,
    elements: Option<Vec<String>>,
    hold_out: Vec<String>,
    progress: Option<Py<PyAny>>,
    dimensions: Option<PathBuf>,
) -> PyResult<(String, String)> {
    if setting.is_empty() {
        return Err(say::<FitError>("setting is the name of what the tests were set to, such as current; it is empty"));
    }
    let records = kept(&campaign.read, &hold_out).map_err(raise::<FitError>)?;
    let options = FitOptions { elements, priors: priors(dimensions.as_deref())?, ..FitOptions::default() };
    let found = work::run(py, progress, |progress| {
        fit(&records, setting, &options, |stage| progress.say(stage.done, stage.text.english()))
    })?;
    let found = found.map_err(raise::<FitError>)?;
    let said = FamilyFigures::new(&found, &campaign.read, None);
    let json = serde_json::to_string(&said).map_err(raise::<FitError>)?;
    Ok((dashpot_identification::family::model_file::write(&found), json))
}
