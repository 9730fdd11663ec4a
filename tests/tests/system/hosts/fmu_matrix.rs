//! Tests of exported FMUs in FMPy over the test matrix of the rig. Co-simulation must equal the kernel's step, except
//! for the last digits of the sine. Model exchange must agree with the converged solution.

use dashpot_core::{Model, Params, model_file};
use dashpot_rig::Matrix;
use dashpot_simulation::accuracy::{HostInput, References, Sine, errors, step_forces};
use dashpot_tests::bridge::MODEL;
use dashpot_tests::fmu::exported;
use dashpot_tests::library::{Language, compiler, root, succeed};
use dashpot_tests::python::{has_python, python};
use std::process::Command;
use std::sync::OnceLock;

const DT: f64 = 1e-3;

fn model() -> Model {
    let mut params = Params::new();
    model_file::read(MODEL.as_bytes(), &mut params).expect("the model file");
    Model::new(&params).expect("a model")
}

/// Returns every test of the matrix with the converged forces, N, at each millisecond.
fn exact() -> &'static [(Sine, Vec<f64>)] {
    static EXACT: OnceLock<Vec<(Sine, Vec<f64>)>> = OnceLock::new();
    EXACT.get_or_init(|| {
        let tests: Vec<Sine> = Matrix::default()
            .points()
            .iter()
            .map(|p| Sine { amplitude: p.amplitude_m, frequency: p.frequency_hz })
            .collect();
        References::solve(&model(), &tests, 0.25e-3)
            .forces()
            .map(|(sine, forces)| (sine, forces.iter().copied().step_by(4).collect()))
            .collect()
    })
}

fn runs(fmi: &str, four: bool) {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    exported(at, MODEL, fmi, four, &[]);
    let mut tests = String::new();
    for (sine, forces) in exact() {
        tests += &format!("{:?} {:?} {}\n", sine.amplitude, sine.frequency, forces.len() - 1);
    }
    std::fs::write(at.join("tests.txt"), tests).expect("a file");
    let mut solver = compiler(Language::C);
    solver.args(["-O2", "-shared", "-fPIC"]).arg(root().join("tests/hosts/exchange_loop.c"));
    succeed(solver.args(["-lm", "-o"]).arg(at.join("exchange_loop.so")));
    let mut host = Command::new(python());
    host.arg(root().join("tests/hosts/fmu_matrix.py"));
    host.args(["damper.fmu", "tests.txt", "./exchange_loop.so", "forces"].map(|name| at.join(name)));
    succeed(host.current_dir(at));

    let bytes = std::fs::read(at.join("forces")).expect("the forces");
    let mut forces = bytes.chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().expect("eight bytes")));
    let model = model();
    let (mut steps, mut exchange) = ([0.0_f64; 2], [0.0_f64; 2]);
    for (sine, exact) in exact() {
        let of: [Vec<f64>; 2] = std::array::from_fn(|_| forces.by_ref().take(exact.len()).collect());
        let kernel = step_forces(&model, &sine.motion(), DT, exact.len() - 1, HostInput::Motion);
        // The sine functions of Python and of the reference may differ in the last digit.
        let same = errors(&of[0], &kernel);
        assert!(same.largest < 1e-11, "{sine:?}: co-simulation is not the kernel's step: {same:?}");
        for (worst, forces) in [(&mut steps, &of[0]), (&mut exchange, &of[1])] {
            let error = errors(forces, exact);
            *worst = [worst[0].max(error.rms), worst[1].max(error.largest)];
        }
    }
    assert_eq!(forces.next(), None);
    let percent = |e: [f64; 2]| format!("{:.4} % rms, {:.4} % at most", 100.0 * e[0], 100.0 * e[1]);
    println!(
        "FMI {fmi}, {} corners: steps of 1 ms {}; model exchange {}",
        if four { 4 } else { 1 },
        percent(steps),
        percent(exchange)
    );
    assert!(exchange[1] < 1e-3, "model exchange is {} from the converged kernel", percent(exchange));
    // The limits are the accuracy that the kernel guarantees at 1 ms.
    assert!(steps[0] < 1e-3 && steps[1] < 1e-2, "co-simulation is {} from the converged kernel", percent(steps));
}

dashpot_tests::each_fmu!(runs);
