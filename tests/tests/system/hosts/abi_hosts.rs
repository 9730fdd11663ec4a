//! Tests that C and C++ programs that use the built library give the forces of the Rust kernel bit for bit.

use dashpot_core::number;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use dashpot_core::{Input, Model, Output, Params, State, model_file};
use dashpot_tests::library::Language::{C, Cxx};
use dashpot_tests::library::{Language, Linkage, host, succeed};

const SANITIZERS: [&str; 3] = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-fno-omit-frame-pointer"];

/// Model file with features that the default model lacks: internal states, side force, piecewise FV curve.
const MODEL: &str = r#"
format = 1
elements = ["fv_curve", "series_compliance", "stribeck_friction", "side_force_friction", "gas_preload", "lagged_polynomial"]
fv_form = "piecewise"
series_stiffness = 2.2e6
gas_force = 141.5
polynomial = [3.0, 400.0, -25.0, 60.0]
method = "second_order"
substeps = 2
"#;

/// Input of the damper at one sample of the motion, and the time since the preceding sample, s.
struct Sample {
    input: Input,
    dt: f64,
}

/// Makes 600 samples of a sine that begins at zero displacement, with `amplitude` in m, `frequency` in Hz and `dt` in
/// s. `input` makes the kernel's input from displacement, m, and velocity, m/s.
fn sine(amplitude: f64, frequency: f64, dt: f64, input: impl Fn(f64, f64) -> Input) -> Vec<Sample> {
    let w = std::f64::consts::TAU * frequency;
    let motion = |t: f64| input(amplitude * (w * t).sin(), amplitude * w * (w * t).cos());
    (1..=600).map(|i| Sample { input: motion(i as f64 * dt), dt }).collect()
}

fn hex(text: &mut String, numbers: &[f64]) {
    for number in numbers {
        write!(text, " {:016x}", number.to_bits()).expect("a string takes it");
    }
}

/// Formats the motion for the host programs, one line per sample: the bit mask of the known inputs, then the numbers as
/// hexadecimal bits.
fn lines(samples: &[Sample]) -> String {
    let mut text = String::new();
    for Sample { input, dt } in samples {
        let known = if input.displacement.is_some() { 7 } else { 6 };
        write!(text, "{known}").expect("a string takes it");
        hex(
            &mut text,
            &[input.displacement.unwrap_or(f64::NAN), input.velocity, input.side_force, input.temperature, *dt],
        );
        text.push('\n');
    }
    text
}

/// Formats the kernel's output in the format of the host programs.
fn kernel(model: &Model, samples: &[Sample], force_alone: bool) -> String {
    let mut text = String::new();
    let mut state = model.steady_state(&Input::motion(0.0, 0.0));
    for Sample { input, dt } in samples {
        let (next, o): (State, Output) = dashpot_core::step(model, &state, input, *dt);
        state = next;
        let warning = i32::from(!model.covers(input.velocity)) + 2 * i32::from(*dt > 0.01);
        write!(text, "{warning}").expect("a string takes it");
        hex(&mut text, &[o.force]);
        if !force_alone {
            hex(&mut text, &[o.d_force_d_displacement, o.d_force_d_velocity, o.primary_force, o.spring_force]);
            hex(&mut text, &[o.friction_force, o.gas_force, o.series_deflection, o.stop_force, o.oil_temperature]);
        }
        hex(&mut text, &[state.displacement, state.velocity, state.mass_displacement, state.mass_velocity]);
        hex(&mut text, &state.internal);
        hex(&mut text, &[state.layout, state.reserved]);
        text.push('\n');
    }
    text
}

fn run(program: &Path, arguments: &[&str], input: &str) -> String {
    let mut child = Command::new(program)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap_or_else(|error| panic!("{}: {error}", program.display()));
    let mut stdin = child.stdin.take().expect("a pipe");
    let text = input.to_string();
    let writer = std::thread::spawn(move || stdin.write_all(text.as_bytes()));
    let output = child.wait_with_output().expect("the host's output");
    writer.join().expect("the writer").expect("the host reads its input");
    assert!(output.status.success(), "{} {arguments:?}: {}", program.display(), output.status);
    String::from_utf8(output.stdout).expect("text")
}

fn agrees(source: &str, language: Language, linkage: Linkage, flags: &[&str]) {
    let directory = tempfile::tempdir().expect("a directory");
    let program = host(source, language, linkage, flags, directory.path());
    let file = directory.path().join("model.toml");
    std::fs::write(&file, MODEL).expect("a model file");
    let file = file.to_str().expect("a path in UTF-8");
    let mut read = Params::new();
    model_file::read(MODEL.as_bytes(), &mut read).expect("the model file");
    let models = [(Params::new(), None), (read, Some(file))];
    for (params, file) in models {
        let model = Model::new(&params).expect("a model");
        let velocity_alone = |_: f64, v: f64| Input::velocity(v);
        let everything = |x: f64, v: f64| Input {
            side_force: 300.0 + 1e3 * v,
            temperature: 20.0 + 100.0 * x,
            ..Input::motion(x, v)
        };
        let runs = [
            ("step", sine(0.02, 1.5, 1e-3, Input::motion)),
            // The velocity of this motion leaves the range of the FV curve, so the library returns a warning.
            ("step", sine(0.025, 20.0, 5e-4, everything)),
            ("step", sine(0.02, 8.0, 1e-3, velocity_alone)),
            ("force", sine(0.02, 8.0, 1e-3, velocity_alone)),
            // The steps are longer than 0.01 s, so each returns a warning.
            ("force", sine(0.05, 1.0, 0.0125, velocity_alone)),
        ];
        for (mode, samples) in runs {
            let mut arguments = vec![mode];
            arguments.extend(file);
            let (got, want) = (run(&program, &arguments, &lines(&samples)), kernel(&model, &samples, mode == "force"));
            for (i, (got, want)) in got.lines().zip(want.lines()).enumerate() {
                assert_eq!(got, want, "{source} {linkage:?} {arguments:?}, step {i}");
            }
            assert_eq!(got.lines().count(), samples.len());
        }
    }
}

fn checks(source: &str) {
    let directory = tempfile::tempdir().expect("a directory");
    for (linkage, flags) in [(Linkage::Shared, &[][..]), (Linkage::Static, &SANITIZERS)] {
        succeed(&mut Command::new(host(source, C, linkage, flags, directory.path())));
    }
}

#[test]
fn c_agrees() {
    agrees("rig.c", C, Linkage::Shared, &[]);
    agrees("rig.c", C, Linkage::Static, &[]);
}

#[test]
fn cxx_agrees() {
    agrees("rig.cc", Cxx, Linkage::Shared, &[]);
    agrees("rig.cc", Cxx, Linkage::Static, &[]);
}

#[test]
fn c_agrees_under_sanitizers() {
    agrees("rig.c", C, Linkage::Shared, &SANITIZERS);
    agrees("rig.c", C, Linkage::Static, &SANITIZERS);
}

#[test]
fn cxx_agrees_under_sanitizers() {
    agrees("rig.cc", Cxx, Linkage::Shared, &SANITIZERS);
}

#[test]
fn refuses_what_it_must_and_touches_nothing() {
    checks("refusals.c");
}

#[test]
fn copies_batches_and_runs_in_place_are_the_same_run() {
    checks("copies.c");
}

#[test]
fn copies_of_an_adjustable_damper_and_its_actuator_are_the_same_run() {
    checks("copies_setting.c");
}

/// Checks that no function of the library needs more than 16 KB of stack, the limit that the header states. The program
/// `stack.c` measures each function on a separate stack.
#[test]
fn no_function_takes_more_than_16_kilobytes_of_stack() {
    let directory = tempfile::tempdir().expect("a directory");
    let program = host("stack.c", C, Linkage::Static, &["-pthread"], directory.path());
    let depths = succeed(&mut Command::new(program));
    assert!(depths.lines().count() >= 20, "{depths}");
    println!("{depths}");
}

/// Checks that the example at the top of `include/dashpot.h` compiles and runs unchanged.
#[test]
fn the_headers_example_runs() {
    let header = std::fs::read_to_string(dashpot_tests::header::path()).expect("include/dashpot.h");
    let manual = header.lines().take_while(|line| !line.starts_with('#'));
    let example: Vec<&str> = manual.filter_map(|line| line.strip_prefix("//     ")).collect();
    assert!(example.len() >= 6, "{example:?}");
    let program = format!(
        "#include <stdio.h>\n#include \"dashpot.h\"\nint main(void) {{\ndouble velocity = 0.3, dt = 1e-3;\nint running = 51;\n\
         #define running --running\n{}\n#undef running\nprintf(\"%.17g\\n\", force);\nreturn running != 0;\n}}\n",
        example.join("\n")
    );
    let directory = tempfile::tempdir().expect("a directory");
    let source = directory.path().join("example.c");
    std::fs::write(&source, program).expect("a source file");
    let program = host(source.to_str().expect("a path in UTF-8"), C, Linkage::Static, &[], directory.path());
    let force: f64 = succeed(&mut Command::new(program)).trim().parse().expect("a force");

    let mut params = Params::new();
    params.set(number!("gas_force"), 120.0).expect("in bounds");
    let model = Model::new(&params).expect("a model");
    let mut state = model.steady_state(&Input::motion(-0.02, 0.0));
    let mut output = Output::ZERO;
    for _ in 0..50 {
        (state, output) = dashpot_core::step(&model, &state, &Input::velocity(0.3), 1e-3);
    }
    assert_eq!(force.to_bits(), output.force.to_bits());
    assert!(force > 0.0, "rebound is resisted by tension");
}
