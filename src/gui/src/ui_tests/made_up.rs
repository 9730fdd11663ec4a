//! Synthetic records of a damper from the kernel, and a window without a screen.

use crate::app::App;
use crate::dialogs::{Dialogs, Message};
use crate::session::recent::Recent;
use dashpot_core::number;
use dashpot_core::step::step;
use dashpot_core::{Input, Model, Params};
use eframe::egui;
use egui_kittest::Harness;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Makes the "measured" damper. Only its series spring differs from the default.
pub fn truth() -> Params {
    let mut params = Params::new();
    params.set(number!("series_stiffness"), 1.6e6).unwrap();
    params
}

/// Number of samples of a cycle: enough for the checks of the readers, and few enough for hundreds of tests.
const SAMPLES: usize = 200;

/// Writes `count` sine tests into a folder: amplitudes 40, 20, 8 mm, at increasing velocity.
pub fn campaign(folder: &Path, count: usize) {
    campaign_of(&truth(), folder, count);
}

/// Writes the tests of [`campaign`] for another damper.
pub fn campaign_of(damper: &Params, folder: &Path, count: usize) {
    let model = Model::new(damper).unwrap();
    for k in 0..count {
        let amplitude = [0.040, 0.020, 0.008][k % 3];
        let speed = 0.05 * 1.25f64.powi((k / 3 % 14) as i32) * (1.0 + 1e-3 * (k / 42) as f64);
        let frequency = speed / (TAU * amplitude);
        let dt = 1.0 / (frequency * SAMPLES as f64);
        let at = |i: usize| {
            let phase = TAU * frequency * dt * i as f64;
            (amplitude * libm::sin(phase), TAU * frequency * amplitude * libm::cos(phase))
        };
        let input = |i: usize| {
            let (x, v) = at(i);
            Input { displacement: Some(x), velocity: v, side_force: 0.0, temperature: 20.0 }
        };
        let mut state = model.steady_state(&input(0));
        let mut text = String::from("time_s,displacement_mm,velocity_mps,force_N\n");
        // The first sample is not recorded. Its force is the steady force at constant velocity, so a reader would report a spike.
        for i in 0..3 * SAMPLES + 1 {
            let (next, output) = step(&model, &state, &input(i), dt);
            state = next;
            if i == 0 {
                continue;
            }
            let (x, v) = at(i);
            // The noise is deterministic and below one millinewton.
            let noise = 1e-3 * ((i * 7919 + k * 104_729) % 1000) as f64 / 1000.0;
            let _ = writeln!(text, "{},{},{v},{}", dt * i as f64, 1e3 * x, output.force + noise);
        }
        std::fs::write(folder.join(format!("a{:02.0}_{k:03}.csv", 1e3 * amplitude)), text).unwrap();
    }
}

/// Writes tests of a damper that depends on a current.
///
/// Two tests have constant currents. In the third the current steps between these values, up and down, at constant velocity.
pub fn campaign_of_family(text: &str, folder: &Path) {
    let file = dashpot_identification::model_file::family_of_text(text, Path::new("family.toml")).unwrap();
    let family = dashpot_identification::model_file::prepared_family(&file.definition()).unwrap();
    let (dt, speed, turn) = (1e-3, 0.1, 0.4);
    for (name, of_half) in [("soft", [0.0; 2]), ("hard", [1.0; 2]), ("steps", [0.0, 1.0])] {
        let at = |i: usize| {
            let phase = (i as f64 * dt) % (2.0 * turn);
            let rises = phase < turn;
            let x = speed * if rises { phase } else { 2.0 * turn - phase } - 0.5 * speed * turn;
            (x, if rises { speed } else { -speed })
        };
        // The current steps in the middle of the strokes, where the velocity is constant.
        let current = |i: usize| of_half[usize::from((i + 200) / 400 % 2 == 1)];
        let input = |i: usize| {
            let (x, v) = at(i);
            Input { displacement: Some(x), velocity: v, side_force: 0.0, temperature: 20.0 }
        };
        let mut state = family.steady_state(&input(0), Some(current(0)));
        let mut delay = family.steady_delay(Some(current(0)));
        let (mut output, _) = family.evaluate(&state, &input(0), Some(current(0)));
        let mut text = String::from("time_s,displacement_mm,velocity_mps,force_N,current [A]\n");
        for i in 0..8000 {
            if i > 0 {
                family.step_in_place(&mut state, &mut delay, &input(i), Some(current(i)), dt, &mut output, false);
            }
            let (x, v) = at(i);
            let noise = 1e-2 * ((i * 7919) % 1000) as f64 / 1000.0;
            let _ = writeln!(text, "{},{},{v},{},{}", dt * i as f64, 1e3 * x, output.force + noise, current(i));
        }
        std::fs::write(folder.join(format!("{name}.csv")), text).unwrap();
    }
}

/// Writes a model file with the default parameters, and returns its path.
pub fn model(folder: &Path) -> PathBuf {
    let path = folder.join("damper.toml");
    let text = dashpot_identification::model_file::flat(&Params::new(), |_| String::new());
    std::fs::write(&path, text).unwrap();
    path
}

/// Makes a window of 1280 by 800 points without a screen. Its dialogs return these paths, in order.
pub fn window(answers: Vec<Vec<PathBuf>>) -> Harness<'static, App> {
    window_with(Box::new(Message::naming(answers)))
}

/// Makes a window of 1280 by 800 points without a screen, with these dialogs.
pub fn window_with(dialogs: Box<dyn Dialogs>) -> Harness<'static, App> {
    Harness::builder().with_size(egui::vec2(1280.0, 800.0)).allow_missing_glyphs().build_eframe(move |creation| {
        let mut app = App::with_recent(&creation.egui_ctx, dialogs, Recent::read(None));
        app.view.language = crate::words::Language::English;
        app
    })
}

/// Longest wait for a task in the background.
const PATIENCE: Duration = Duration::from_secs(240);

/// Draws frames until a condition is true. Fails after [`PATIENCE`].
#[track_caller]
pub fn until(harness: &mut Harness<'_, App>, what: &str, mut done: impl FnMut(&App) -> bool) {
    let began = Instant::now();
    loop {
        harness.step();
        if done(harness.state()) {
            harness.step();
            return;
        }
        assert!(began.elapsed() < PATIENCE, "{what} did not come in {PATIENCE:?}");
        std::thread::sleep(Duration::from_millis(5));
    }
}
