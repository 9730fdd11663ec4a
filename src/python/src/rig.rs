//! Virtual rig: makes records of simulated dampers for experiments, and test matrices.

use crate::errors::{OutputError, RigError, raise, say};
use crate::work;
use dashpot_output::FolderLock;
use dashpot_rig::{Campaign, InjectedCase, Matrix, MatrixOptions, Options, Plan, RigError as Refusal};
use dashpot_severity::SeverityError;
use dashpot_severity::request::{Numbers, RequestedEffects, strengths};
use pyo3::prelude::*;
use std::path::PathBuf;

/// Choice of tests: from a file, from a plan, or from the thesis (Jonnalagadda & Vyas 2020) with changes.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Tests {
    matrix: Option<PathBuf>,
    plan: Option<String>,
    amplitudes_m: Option<Vec<f64>>,
    peak_velocities_m_s: Option<Vec<f64>>,
    frequency_limit_hz: Option<f64>,
    slow_tests: bool,
}

impl Tests {
    /// Returns the tests of the thesis (Jonnalagadda & Vyas 2020) with the user's changes.
    fn of_thesis(&self) -> Result<Matrix, Refusal> {
        let usual = MatrixOptions::default();
        Matrix::thesis(&MatrixOptions {
            amplitudes_m: self.amplitudes_m.clone().unwrap_or(usual.amplitudes_m),
            peak_velocities_m_s: self.peak_velocities_m_s.clone().unwrap_or(usual.peak_velocities_m_s),
            frequency_limit_hz: self.frequency_limit_hz.unwrap_or(usual.frequency_limit_hz),
            slow_tests: self.slow_tests,
        })
    }

    fn is_varied(&self) -> bool {
        let lists = self.amplitudes_m.is_some() || self.peak_velocities_m_s.is_some();
        lists || self.frequency_limit_hz.is_some() || !self.slow_tests
    }

    /// Returns the plan whose tests determine the severity of an injected effect, or `None` if the user chose tests of their own.
    fn searched(&self) -> Result<Option<Plan>, Refusal> {
        match &self.plan {
            _ if self.matrix.is_some() || self.is_varied() => Ok(None),
            Some(name) => Plan::named(name).map(Some),
            None => Ok(Some(Plan::default())),
        }
    }

    /// Returns the tests of a campaign. If effects are injected (`hides`), the default is a plan. Otherwise, the default is the tests of
    /// the thesis (Jonnalagadda & Vyas 2020). `order` is the seed for the order of a plan's tests.
    fn chosen(&self, hides: bool, order: u64) -> Result<Matrix, Refusal> {
        if let Some(file) = &self.matrix {
            return Matrix::read(file);
        }
        match &self.plan {
            Some(name) => Ok(Plan::named(name)?.matrix(order)),
            None if hides && !self.is_varied() => Ok(Plan::default().matrix(order)),
            None => self.of_thesis(),
        }
    }
}

/// Options of the virtual rig and its sensors.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Bench {
    seed: u64,
    noise_percent: f64,
    sample_rate_hz: Option<f64>,
    noise_colour: f64,
    hum_n: f64,
    bits: Option<u32>,
    side_force: bool,
    temperature: bool,
    start_temperature_c: Option<f64>,
    noise_seed: Option<u64>,
    order: Option<u64>,
}

/// Names of options in messages of the rig, and the corresponding arguments of the Python package.
const ARGUMENTS: [(&str, &str); 8] = [
    ("amplitudes", "amplitudes_m"),
    ("peak velocities", "peak_velocities_m_s"),
    ("frequency limit", "frequency_limit_hz"),
    ("noise", "noise_percent"),
    ("noise colour", "noise_colour"),
    ("hum", "hum_n"),
    ("start temperature", "start_temperature_c"),
    ("sample rate", "sample_rate_hz"),
];

/// Converts an error of the rig to an exception. In its message, names of Python arguments replace names of options.
fn refused(error: anyhow::Error) -> PyErr {
    match error.downcast_ref::<Refusal>() {
        Some(Refusal::Option { option, problem }) => {
            let argument = ARGUMENTS.iter().find(|known| known.0 == *option).map_or(*option, |known| known.1);
            say::<RigError>(format!("{argument}: {problem}"))
        }
        _ => raise::<RigError>(error),
    }
}

/// Extracts the error of the rig from an error of the severity search.
fn of_rig(error: SeverityError) -> anyhow::Error {
    match error {
        SeverityError::Rig(refusal) => refusal.into(),
        other => other.into(),
    }
}

/// Measures tests on the virtual rig, and writes their records to a folder. Returns the number of records.
///
/// `hide` contains the names of injected effects with their strengths, or with their severities if `severity` is set. An effect without a
/// number has the strength of a typical strong case.
#[pyfunction]
#[pyo3(signature = (folder, tests, bench, hide, severity, progress=None))]
#[allow(clippy::needless_pass_by_value)]
pub fn measure(
    py: Python<'_>,
    folder: PathBuf,
    tests: Tests,
    bench: Bench,
    hide: Option<RequestedEffects>,
    severity: bool,
    progress: Option<Py<PyAny>>,
) -> PyResult<usize> {
    let options = Options {
        seed: bench.seed,
        noise_percent: bench.noise_percent,
        sample_rate_hz: bench.sample_rate_hz,
        noise_colour: bench.noise_colour,
        hum_n: bench.hum_n,
        bits: bench.bits,
        side_force_channel: bench.side_force,
        temperature_channel: bench.temperature,
        start_temperature_c: bench.start_temperature_c,
        noise_seed: bench.noise_seed,
        order: bench.order,
        ..Options::default()
    };
    let matrix =
        tests.chosen(hide.is_some(), bench.order.unwrap_or(bench.seed)).map_err(|error| refused(error.into()))?;
    let searched = tests.searched().map_err(|error| refused(error.into()))?;
    let held = FolderLock::take(&folder).map_err(raise::<OutputError>)?;
    let measured = work::run(py, progress, |progress| -> anyhow::Result<usize> {
        let say = |done: usize, total: usize| progress.say(done as f64 / total.max(1) as f64, "measuring");
        let Some(asked) = hide else {
            let campaign = Campaign::run(&matrix, &options, say)?;
            campaign.write(&folder)?;
            return Ok(campaign.records.len());
        };
        let numbers = if severity { Numbers::Severities } else { Numbers::Strengths };
        let watch = |_, _| progress.say(0.0, "finding strengths");
        let effects = strengths(asked, numbers, searched, &options, &watch).map_err(of_rig)?;
        let outcome = InjectedCase { effects, plan: Plan::default(), options }.run_matrix(&matrix, say)?;
        outcome.write(&folder)?;
        Ok(outcome.campaign.records.len())
    });
    drop(held);
    measured?.map_err(refused)
}

/// Returns the test matrix of the thesis (Jonnalagadda & Vyas 2020), with the user's changes, as the text of a CSV file. Also returns the
/// number of tests.
#[pyfunction]
#[allow(clippy::needless_pass_by_value)]
pub fn test_matrix(tests: Tests) -> PyResult<(String, usize)> {
    let matrix = tests.of_thesis().map_err(|error| refused(error.into()))?;
    Ok((matrix.to_csv(), matrix.points().len()))
}
