//! Tests the damper test rig that `dashpot export adams` writes: a strict reader parses its files, and a stand-in
//! solver runs them.

use dashpot_core::{Input, Model, State, evaluate::evaluate};
use dashpot_rig::Matrix;
use dashpot_tests::adams::{Accepted, PLAIN, library, model_of, solver, started};
use dashpot_tests::cli::done;
use dashpot_tests::dataset::{self, Command, Dataset, values};
use std::f64::consts::TAU;
use std::path::Path;

const LENGTH: f64 = 412.5;

/// Exports the run folder for Adams. Returns the dataset of the rig and the commands of its command file.
fn exported(folder: &Path) -> (Dataset, Vec<Command>) {
    std::fs::write(folder.join("damper.toml"), PLAIN).unwrap();
    let library = library().to_str().unwrap();
    let length = LENGTH.to_string();
    done(folder, &["export", "adams", "damper.toml", "-o", "run", "--length", &length, "--library", library]);
    let read = |name: &str| std::fs::read_to_string(folder.join("run").join(name)).unwrap();
    let (model, output, commands) = dataset::commands(&read("rig.acf"));
    assert_eq!((model.as_str(), output.as_str()), ("rig", "rig"));
    (dataset::read(&read("rig.adm"), true, &[]), commands)
}

#[test]
fn the_datasets_are_whole() {
    let folder = tempfile::tempdir().unwrap();
    let (rig, commands) = exported(folder.path());
    let count = |name: &str| rig.keys().filter(|k| k.0 == name).count();
    assert_eq!(
        ["PART", "JOINT", "MOTION", "BUSHING", "SFORCE", "STRING", "REQUEST"].map(count),
        [4, 2, 1, 2, 1, 1, 2],
        "thesis figure 7.12: rig part and motion, damper, bushings at both ends"
    );
    let part_of = |marker: f64| values(&rig[&("MARKER".into(), marker as u64)], "PART")[0];
    let parts = |name: &str, id: u64| {
        let ends = ["I", "J"].map(|end| part_of(values(&rig[&(name.into(), id)], end)[0]));
        (ends[0], ends[1])
    };
    // The parts are ground 1, rig 2, tube 3, rod 4.
    assert_eq!((parts("JOINT", 1), parts("JOINT", 2)), ((2.0, 1.0), (4.0, 3.0)));
    assert_eq!((parts("BUSHING", 1), parts("BUSHING", 2), parts("SFORCE", 1)), ((4.0, 1.0), (3.0, 2.0), (4.0, 3.0)));

    let matrix = Matrix::default();
    assert_eq!(commands[..2], [Command::Integrator(1e-5), Command::Statics]);
    assert_eq!(commands.len(), 2 + 2 * matrix.points().len());
    let mut begin = 0.0;
    for (pair, point) in commands[2..].chunks(2).zip(matrix.points()) {
        let [Command::Motion(1, function), Command::Dynamics(end, 800)] = pair else { panic!("{pair:?}") };
        assert!((end - begin - 4.0 / point.frequency_hz).abs() < 1e-7, "four cycles of {}", point.name);
        let amplitude: f64 = function.split('*').next().unwrap().parse().unwrap();
        assert!((amplitude - 1e3 * point.amplitude_m).abs() < 1e-9, "{function}");
        begin = *end;
    }

    // The fragments damper.adm and native.adm use only their own markers and two markers of the user's model.
    let read = |name: &str| std::fs::read_to_string(folder.path().join("run").join(name)).unwrap();
    let damper = dataset::read(&read("damper.adm"), false, &[11, 12]);
    assert_eq!(damper.len(), 4);
    // The native elements use two markers of the model, and add neither parts nor joints.
    let native = dataset::read(&read("native.adm"), false, &[11, 12]);
    let of = |name: &str| native.keys().filter(|k| k.0 == name).count();
    assert_eq!(["DIFF", "SFORCE", "SPLINE"].map(of), [2, 1, 3]);
    assert_eq!(native.len(), 6);
}

#[test]
fn the_reader_refuses_what_is_broken() {
    let folder = tempfile::tempdir().unwrap();
    exported(folder.path());
    let good = std::fs::read_to_string(folder.path().join("run/rig.adm")).unwrap();
    for (from, to) in [
        ("MARKER/41, PART = 4", "MARKER/41, PART = 9"),
        ("MARKER/41,", "MARKER/31,"),
        ("I = 11", "I = 15"),
        ("JOINT = 1", "JOINT = 3"),
        ("K = 1E4, 1E4, 1E4", "K = 1E4, 1E4"),
        ("STRING/7", "STRING/8"),
        ("USER(1, 1, 2)", "USER(1, 4, 2)"),
        ("MASS = 2,", "MASS = two,"),
        (")\\\n", ")\n"),
        (", TRANSLATION\n", ", SIDEWAYS\n"),
        ("END\n", "\n"),
    ] {
        assert!(good.contains(from), "{from}");
        let bad = good.replacen(from, to, 1);
        assert!(std::panic::catch_unwind(|| dataset::read(&bad, true, &[])).is_err(), "{from} as {to} passes");
    }
}

/// Masses of tube and rod, kg, and stiffness, N/m, and damping, N s/m, of the two bushings. Index 0 is between rod and
/// ground, index 1 between tube and rig.
struct Rig {
    tube: f64,
    rod: f64,
    stiffness: [f64; 2],
    damping: [f64; 2],
}

/// Returns displacement, mm, and velocity, mm/s, of the rig's actuator at the time `t`, s, of a test. The test has one
/// cycle of fade-in, two full cycles, and one cycle of fade-out.
fn moved(point: &dashpot_rig::TestPoint, t: f64) -> (f64, f64) {
    let (w, cycles) = (TAU * point.frequency_hz, t * point.frequency_hz);
    let rise = |s: f64| {
        if (0.0..1.0).contains(&s) {
            (s * s * (3.0 - 2.0 * s), 6.0 * s * (1.0 - s))
        } else {
            (if s < 0.0 { 0.0 } else { 1.0 }, 0.0)
        }
    };
    let ((up, up_rate), (down, down_rate)) = (rise(cycles), rise(cycles - 3.0));
    let (share, rate) = (up * (1.0 - down), (up_rate * (1.0 - down) - up * down_rate) * point.frequency_hz);
    let a = 1e3 * point.amplitude_m;
    (a * share * (w * t).sin(), a * (rate * (w * t).sin() + share * w * (w * t).cos()))
}

/// Displacement, m, and velocity, m/s, of the tube and then of the rod, and the damper's state. The displacements are
/// zero where the bushings carry no force.
#[derive(Clone, Copy)]
struct Instant {
    y: [f64; 4],
    damper: State,
}

impl Rig {
    fn rates(&self, model: &Model, point: &dashpot_rig::TestPoint, t: f64, now: &Instant) -> (Instant, f64) {
        let [tube, tube_v, rod, rod_v] = now.y;
        let (rig, rig_v) = moved(point, t);
        let (output, rate) = evaluate(model, &now.damper, &Input::motion(rod - tube, rod_v - tube_v));
        let on_rod = -self.stiffness[0] * rod - self.damping[0] * rod_v - output.force;
        let on_tube =
            -self.stiffness[1] * (tube - 1e-3 * rig) - self.damping[1] * (tube_v - 1e-3 * rig_v) + output.force;
        let y = [tube_v, on_tube / self.tube, rod_v, on_rod / self.rod];
        (Instant { y, damper: rate }, output.force)
    }

    /// Computes the expected SFORCE, N, at the accepted time points of a test that starts at the time `begin`, s. The
    /// method is of fourth order, with short steps.
    fn run(
        &self,
        model: &Model,
        point: &dashpot_rig::TestPoint,
        begin: f64,
        now: &mut Instant,
        at: &[Accepted],
    ) -> Vec<f64> {
        let plus = |a: &Instant, k: &Instant, h: f64| {
            let mut b = *a;
            (0..4).for_each(|i| b.y[i] += h * k.y[i]);
            b.damper.mass_displacement += h * k.damper.mass_displacement;
            b.damper.mass_velocity += h * k.damper.mass_velocity;
            b
        };
        let mut t = 0.0;
        at.iter()
            .map(|accepted| {
                // Friction changes steeply with velocity at a reversal of motion, so the explicit method needs short
                // steps there.
                let slow = (now.y[3] - now.y[1]).abs() < 4e-3;
                let n = ((accepted.t - begin - t) / if slow { 1e-5 } else { 2e-5 }).ceil().max(1.0);
                let h = (accepted.t - begin - t) / n;
                for _ in 0..n as usize {
                    let k1 = self.rates(model, point, t, now).0;
                    let k2 = self.rates(model, point, t + h / 2.0, &plus(now, &k1, h / 2.0)).0;
                    let k3 = self.rates(model, point, t + h / 2.0, &plus(now, &k2, h / 2.0)).0;
                    let k4 = self.rates(model, point, t + h, &plus(now, &k3, h)).0;
                    for (k, share) in [(&k1, 1.0), (&k2, 2.0), (&k3, 2.0), (&k4, 1.0)] {
                        *now = plus(now, k, h * share / 6.0);
                    }
                    t += h;
                }
                -self.rates(model, point, t, now).1
            })
            .collect()
    }

    /// Computes the equilibrium of tube, rod and damper with the rig's actuator at zero displacement.
    fn rest(&self, model: &Model) -> Instant {
        let (mut low, mut high) = (-0.01, 0.01);
        for _ in 0..100 {
            let x = 0.5 * (low + high);
            let force = model.static_output(&Input::motion(x, 0.0)).force;
            // The bushings carry the force of the damper, so their deflections change the length of the damper.
            let apart = -force / self.stiffness[0] - force / self.stiffness[1];
            if apart > x { low = x } else { high = x }
        }
        let force = model.static_output(&Input::motion(low, 0.0)).force;
        let y = [force / self.stiffness[1], 0.0, -force / self.stiffness[0], 0.0];
        Instant { y, damper: model.steady_state(&Input::motion(y[2] - y[0], 0.0)) }
    }
}

#[test]
fn the_exported_rig_runs_the_matrix_as_the_kernel_does() {
    let folder = tempfile::tempdir().unwrap();
    let (dataset, _) = exported(folder.path());
    let si =
        |name: &str, id: u64, key: &str, to_si: f64| *values(&dataset[&(name.into(), id)], key).last().unwrap() * to_si;
    let rig = Rig {
        tube: si("PART", 3, "MASS", 1.0),
        rod: si("PART", 4, "MASS", 1.0),
        stiffness: [1, 2].map(|id| si("BUSHING", id, "K", 1e3)),
        damping: [1, 2].map(|id| si("BUSHING", id, "C", 1e3)),
    };
    let model = model_of(PLAIN);
    // The argument `model` replaces the path of the model file in the STRING. That path is relative to the run folder,
    // but the solver runs in another folder.
    let acf = format!("dataset={}", folder.path().join("run/rig.acf").display());
    let string = format!("model={}", folder.path().join("run/damper.toml").display());
    // Only the sines run. The slow cycles after the sines would take minutes and test nothing new.
    let matrix = Matrix::default();
    let sines = matrix.points().iter().take_while(|p| p.frequency_hz > 0.1).count();
    assert!(sines > 40);
    let runs = started(&solver(), "sfo", &[acf, string, format!("simulations={sines}")]).simulations();

    assert_eq!(runs.len(), sines);
    let mut now = rig.rest(&model);
    let (mut begin, mut worst) = (0.0, 0.0_f64);
    let mut results = Vec::new();
    for ((end, accepted), point) in runs.iter().zip(matrix.points()) {
        let want = rig.run(&model, point, begin, &mut now, accepted);
        results.push((point, accepted, want));
        begin = *end;
    }
    for (point, accepted, want) in &results {
        let largest = want.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
        let off = accepted.iter().zip(want).fold(0.0_f64, |m, (a, w)| m.max((a.sforce - w).abs()));
        worst = worst.max(off / largest);
        assert!(accepted.len() >= 800 && off < 1e-3 * largest, "{}: {:.4} %", point.name, 100.0 * off / largest);
    }
    println!("{} tests, worst deviation {:.4} % of the largest force", results.len(), 100.0 * worst);
}
