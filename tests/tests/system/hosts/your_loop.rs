//! Tests the example from the book's page for host authors.
//!
//! The three simulation loops of the example simulate the same car, also with a moving mass in the damper.

use dashpot_tests::library::{Language, Linkage, host, root, succeed};
use std::path::Path;
use std::process::Command;

const CALM: &str = "format = 1\nelements = [\"fv_curve\", \"series_compliance\", \"parallel_spring\", \"gas_preload\"]\ngas_force = 120\n";

/// Returns the rows that a loop of the example prints: time, s, position, m, and force, N.
fn run(program: &Path, model: &str, kind: &str, dt: &str) -> Vec<[f64; 3]> {
    let file = program.with_file_name("model.toml");
    std::fs::write(&file, model).expect("a model file");
    let told = succeed(Command::new(program).arg(&file).args([kind, dt]));
    told.lines()
        .map(|line| {
            let row: Vec<f64> = line.split(' ').map(|n| n.parse().expect("a number")).collect();
            row.try_into().expect("three numbers")
        })
        .collect()
}

fn apart(a: &[[f64; 3]], b: &[[f64; 3]], column: usize) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a[column] - b[column]).abs()).fold(0.0, f64::max)
}

#[test]
fn three_loops_are_one_car() {
    let folder = tempfile::tempdir().expect("a directory");
    let source = root().join("examples/your_loop.c");
    let program = host(source.to_str().expect("a path in UTF-8"), Language::C, Linkage::Static, &[], folder.path());
    let fine = run(&program, CALM, "explicit", "0.00001");
    let peak = fine.iter().map(|row| row[1].abs()).fold(0.0, f64::max);
    let force = fine.iter().map(|row| row[2].abs()).fold(0.0, f64::max);
    let kinds = ["explicit", "trial"].map(|kind| run(&program, CALM, kind, "0.001"));
    assert!(apart(&kinds[0], &kinds[1], 1) > 0.0, "no step was taken back");
    assert!(fine.len() == 200 && peak > 0.01 && force > 300.0, "{} {peak} {force}", fine.len());
    for kind in ["explicit", "trial", "implicit"] {
        let [coarse, half] = ["0.001", "0.0005"].map(|dt| run(&program, CALM, kind, dt));
        let errors = [apart(&coarse, &fine, 1), apart(&half, &fine, 1)];
        println!(
            "{kind}: {:.3} and {:.3} mm of {:.1} mm at 1 and 0.5 ms",
            1e3 * errors[0],
            1e3 * errors[1],
            1e3 * peak
        );
        assert!(errors[0] < 0.01 * peak, "{kind}: {errors:?} of {peak}");
        // The integration methods of the loops are of first order: half the step gives half the error. The loop `trial`
        // adapts its steps.
        assert!(kind == "trial" || errors[1] < 0.7 * errors[0], "{kind}: {errors:?}");
    }
}

/// Checks that a moving mass in the damper affects the car as in a simulation with small steps. This must hold even if
/// a loop advances the displacement with another velocity.
///
/// The loop `explicit` is semi-implicit. The errors of a loop in the motion of the car body cancel in the difference
/// between runs with and without the mass.
#[test]
fn a_moving_mass_acts_as_it_is_in_every_loop() {
    let folder = tempfile::tempdir().expect("a directory");
    let source = root().join("examples/your_loop.c");
    let program = host(source.to_str().expect("a path in UTF-8"), Language::C, Linkage::Static, &[], folder.path());
    let heavy = CALM.replace("\"gas_preload\"", "\"gas_preload\", \"moving_mass\"") + "moving_mass = 20.0\n";
    let by_the_mass = |kind: &str, dt: &str| -> Vec<f64> {
        let (with, without) = (run(&program, &heavy, kind, dt), run(&program, CALM, kind, dt));
        with.iter().zip(&without).map(|(a, b)| a[1] - b[1]).collect()
    };
    let fine = by_the_mass("explicit", "0.00001");
    let most = fine.iter().fold(0.0f64, |m, d| m.max(d.abs()));
    assert!(most > 1e-4, "{most}");
    for kind in ["explicit", "trial", "implicit"] {
        let coarse = by_the_mass(kind, "0.001");
        let off = fine.iter().zip(&coarse).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
        println!("{kind}: {:.2} of {:.2} mm", 1e3 * off, 1e3 * most);
        assert!(off < 0.1 * most, "{kind}: off by {off} of {most}");
    }
}
