//! Computations that the benchmarks measure: a thousand time steps of a damper, a fit, and reading a campaign.
//! `benches/time.rs` measures time, `benches/instructions.rs` counts instructions; `benchmarks.md` in the book contains
//! the figures.

use dashpot_core::number;
use dashpot_core::parameter::Element;
use dashpot_core::step::step;
use dashpot_core::{Input, Model, Params, State};
use dashpot_identification::{Family, Fit, FitOptions};
use dashpot_records::Campaign;
use dashpot_rig::{Matrix, MatrixOptions};
use tempfile::TempDir;

/// Number of steps per call of [`Steps::run`].
pub const STEPS: usize = 1000;

/// A damper, and a motion in time steps of 1 ms over the whole FV curve. The motion equals that of
/// `tests/hosts/cost.c`.
pub struct Steps {
    model: Model,
    state: State,
    inputs: Vec<Input>,
}

impl Steps {
    /// Makes a damper: `default`, `cheap` (one step of the Euler method per host step), or the default with the element
    /// that `damper` names.
    ///
    /// # Panics
    /// If the element does not exist.
    #[must_use]
    pub fn of(damper: &str) -> Steps {
        let mut params = Params::new();
        match damper {
            "default" => {}
            "cheap" => {
                params.set(number!("method"), 2.0).expect("a method");
                params.set(number!("substeps"), 1.0).expect("substeps");
            }
            element => params.enable(Element::find(element).expect("an element"), true),
        }
        let model = Model::new(&params).expect("a damper");
        let half = 32;
        let mut x = 0.0;
        let input = |k: usize| {
            let t = (k % half) as f64 / half as f64;
            let v = if k < half { 6.0 } else { -6.0 } * t * (1.0 - t);
            x += 1e-3 * v;
            Input::motion(x, v)
        };
        let inputs = (0..2 * half).map(input).collect();
        Steps { state: model.steady_state(&Input::motion(0.0, 0.0)), model, inputs }
    }

    /// Advances the damper by [`STEPS`] time steps. Returns the sum of the forces, N, so that the compiler cannot omit
    /// a step.
    pub fn run(&mut self) -> f64 {
        let mut sum = 0.0;
        for k in 0..STEPS {
            let (next, output) = step(&self.model, &self.state, &self.inputs[k % self.inputs.len()], 1e-3);
            (self.state, sum) = (next, sum + output.force);
        }
        sum
    }
}

/// Writes a campaign of the virtual rig: six fast tests and the slow tests.
///
/// # Panics
/// If the folder is not writable.
#[must_use]
pub fn files() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let options = MatrixOptions {
        amplitudes_m: vec![0.05, 0.015],
        peak_velocities_m_s: vec![0.0524, 0.262, 1.047],
        ..MatrixOptions::default()
    };
    let matrix = Matrix::thesis(&options).expect("a matrix");
    let measured =
        dashpot_rig::Campaign::run(&matrix, &dashpot_rig::Options { seed: 3, ..Default::default() }, |_, _| {});
    measured.expect("a campaign").write(&folder.path().join("records")).expect("records");
    folder
}

/// Reads the campaign that [`files`] wrote.
///
/// # Panics
/// If the records are not readable.
#[must_use]
pub fn read(files: &TempDir) -> Campaign {
    dashpot_records::load(&[files.path().join("records")], &Default::default(), &|_| {}).expect("a campaign")
}

/// Fits the model of a family: [`Family::Thesis`] selects among all elements, and [`Family::Fv`] is the FV curve alone.
///
/// # Panics
/// If the fit fails.
#[must_use]
pub fn fit(campaign: &Campaign, family: Family) -> Fit {
    let records = campaign.records.iter().collect::<Vec<_>>();
    dashpot_identification::fit(&records, &FitOptions { family, ..Default::default() }, |_| {}).expect("a fit")
}

/// Restricts rayon to this thread, because callgrind counts only this thread's instructions. Two runs then give equal
/// counts.
///
/// # Panics
/// If rayon has already started its threads.
pub fn one_thread() {
    rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global().expect("no threads before");
}
