//! Tests of a simulated vehicle on the simulator bridge (`vi-crt-bridge`), as in a real-time simulator.
//!
//! Every maneuver, at steps from 0.25 to 2 ms, must equal the simulation with the kernel bit for bit. The bridge uses
//! the host's sign convention.

use dashpot_core::{Model, Params, model_file};
use dashpot_simulation::vehicle::{Car, Dampers, Manoeuvre, run, run_with};
use dashpot_tests::bridge::{MODEL, bridge_host};
use std::io::{Read as _, Write as _};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// Host program with the four corners of the bridge, connected by pipes. In the bridge, compression and push are
/// positive.
struct Bridge {
    host: Child,
    to: ChildStdin,
    from: ChildStdout,
}

impl Bridge {
    fn ask(&mut self, dt: f64, motion: [[f64; 2]; 4]) -> [[f64; 2]; 4] {
        let numbers = [dt].into_iter().chain(motion.into_iter().flatten().map(|n| -n));
        let request: Vec<u8> = numbers.flat_map(f64::to_le_bytes).collect();
        self.to.write_all(&request).expect("the bridge listens");
        let mut answer = [0; 12 * 8];
        self.from.read_exact(&mut answer).expect("the bridge answers");
        let number = |i: usize| f64::from_le_bytes(answer[8 * i..8 * i + 8].try_into().expect("eight bytes"));
        std::array::from_fn(|corner| {
            // Smaller status values are warnings, for example of a velocity beyond the FV curve. The status of a force
            // kept after a rejected input would be 0x10000.
            assert!(number(3 * corner + 2) < 65536.0, "an input was refused");
            [-number(3 * corner), number(3 * corner + 1)]
        })
    }
}

impl Dampers for Bridge {
    fn rest(&mut self) -> [f64; 4] {
        self.ask(-1.0, [[0.0; 2]; 4]).map(|[force, _]| force)
    }

    fn step(&mut self, dt: f64, motion: [[f64; 2]; 4]) -> [[f64; 2]; 4] {
        self.ask(dt, motion)
    }
}

#[test]
fn every_manoeuvre_is_the_kernels_bit_for_bit() {
    let folder = tempfile::tempdir().expect("a directory");
    // The rear dampers differ from the front dampers, so that exchanged corners are detected.
    let texts = [
        MODEL.to_owned(),
        MODEL.replace("141.5", "200.0").replace("[\"fv_curve\"", "[\"valve_hysteresis\", \"fv_curve\""),
    ];
    let names = ["front.toml", "rear.toml"].map(|name| folder.path().join(name));
    let models = std::array::from_fn::<Model, 2, _>(|i| {
        std::fs::write(&names[i], &texts[i]).expect("a model file");
        let mut params = Params::new();
        model_file::read(texts[i].as_bytes(), &mut params).expect("the model file");
        Model::new(&params).expect("a model")
    });
    let program = bridge_host("serve.c", &["-O2"], folder.path());
    let mut host = Command::new(program)
        .args([&names[0], &names[0], &names[1], &names[1]])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the host runs");
    let (to, from) = (host.stdin.take().expect("a pipe"), host.stdout.take().expect("a pipe"));
    let mut bridge = Bridge { host, to, from };
    let car = Car::default();
    let kernel = [&models[0], &models[0], &models[1], &models[1]];
    for (name, manoeuvre) in Manoeuvre::ALL {
        for dt in [0.25e-3, 0.5e-3, 1e-3, 2e-3] {
            let through = run_with(&car, manoeuvre, &mut bridge, dt).expect("a run");
            let direct = run(&car, manoeuvre, kernel, dt).expect("a run");
            assert!(through.samples.len() > 1000 && through.coupling == direct.coupling, "{name} {dt}");
            for (a, b) in through.samples.iter().zip(&direct.samples) {
                for (a, b) in a.corner.iter().zip(&b.corner) {
                    assert!((a.force, a.displacement) == (b.force, b.displacement), "{name} {dt}: {a:?} {b:?}");
                }
            }
        }
    }
    let Bridge { mut host, to, .. } = bridge;
    drop(to);
    assert!(host.wait().expect("the host ends").success());
}
