//! What is measured: a thousand steps of a damper, a fit, reading a campaign. `benches/time.rs` takes the time, `benches/instructions.rs` counts
//! instructions; the figures are in the book, `benchmarks.md`.

use dashpot_core::number;
use dashpot_core::parameter::Element;
use dashpot_core::step::step;
use dashpot_core::{Input, Model, Params, State};
use dashpot_identification::{Family, Fit, FitOptions};
use dashpot_records::Campaign;
use dashpot_rig::{Matrix, MatrixOptions};
use tempfile::TempDir;

/// Steps of one call of [`Steps::run`].
pub const STEPS: usize = 1000;

/// A damper, and a motion at 1 ms that passes through all of its FV curve; the same as in `tests/hosts/cost.c`.
pub struct Steps {
    model: Model,
    state: State,
    inputs: Vec<Input>,
}

impl Steps {
    /// `default`, `cheap` (the one cheap step a host step), or the name of an element that is on beside the default ones.
    ///
    /// # Panics
    /// Where there is no such element.
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

    /// Goes on by [`STEPS`] steps; the sum of the forces, so that none is left out.
    pub fn run(&mut self) -> f64 {
        let mut sum = 0.0;
        for k in 0..STEPS {
            let (next, output) = step(&self.model, &self.state, &self.inputs[k % self.inputs.len()], 1e-3);
            (self.state, sum) = (next, sum + output.force);
        }
        sum
    }
}

/// A campaign of the virtual rig as files: six fast tests and the slow ones.
///
/// # Panics
/// Where the folder cannot be written.
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

/// Reads them.
///
/// # Panics
/// Where they cannot be read.
#[must_use]
pub fn read(files: &TempDir) -> Campaign {
    dashpot_records::load(&[files.path().join("records")], &Default::default(), &|_| {}).expect("a campaign")
}

/// Fits a model with all elements of the fit's choice, or the plain FV curve.
///
/// # Panics
/// Where it cannot be fitted.
#[must_use]
pub fn fit(campaign: &Campaign, family: Family) -> Fit {
    let records = campaign.records.iter().collect::<Vec<_>>();
    dashpot_identification::fit(&records, &FitOptions { family, ..Default::default() }, |_| {}).expect("a fit")
}

/// Keeps all work on this thread: instructions are counted there alone, and two runs count the same.
///
/// # Panics
/// Where threads were started before.
pub fn one_thread() {
    rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global().expect("no threads before");
}
