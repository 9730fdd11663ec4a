//! How long the window takes: `cargo run --release -p dashpot-bench --example latency -- CAMPAIGN MODEL`.
//!
//! Without a screen: reading and preparing the records until the first loops can be drawn; from a slider's move until the loops and
//! errors of all tests are there; a frame while the slider moves, made ready for the graphics card.

use dashpot_bench::app::App;
use dashpot_bench::dialogs::Told;
use dashpot_bench::session::recent::Recent;
use eframe::egui;
use egui_kittest::Harness;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Moves of the slider.
const MOVES: usize = 60;

fn main() {
    let paths: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    if paths.len() < 2 {
        eprintln!("give a campaign and a model file");
        std::process::exit(2);
    }
    let mut harness = Harness::builder()
        .with_size(egui::vec2(1440.0, 900.0))
        .allow_missing_glyphs()
        .build_eframe(|c| App::with_recent(&c.egui_ctx, Box::new(Told::default()), Recent::read(None)));
    let began = Instant::now();
    harness.state_mut().session.open(&paths);
    while !harness.state().session.has_records() {
        harness.step();
        std::thread::sleep(Duration::from_millis(2));
        if harness.state().session.message.as_ref().is_some_and(|m| m.wrong) {
            eprintln!("{}", harness.state().session.message.as_ref().map_or("", |m| &m.text));
            std::process::exit(2);
        }
    }
    harness.step();
    let tests = harness.state().session.campaign.as_ref().map_or(0, |c| c.tests.len());
    println!("{tests} tests: {:.0} ms from opening to the first loops", 1e3 * began.elapsed().as_secs_f64());
    while !harness.state().session.simulated.as_ref().is_some_and(|s| !s.quick) {
        harness.step();
        std::thread::sleep(Duration::from_millis(2));
    }
    println!("{:.0} ms until model and errors stand beside them", 1e3 * began.elapsed().as_secs_f64());
    let row = dashpot_core::parameter::find("series_stiffness").expect("the table has it");
    let value = harness.state().session.model.as_ref().map_or(2e6, |m| m.params().scalar("series_stiffness"));
    let (mut follows, mut frames) = (Vec::new(), Vec::new());
    for k in 1..=MOVES {
        let wanted = value * (1.0 + 0.01 * k as f64);
        let moved = Instant::now();
        harness.state_mut().session.tune(|m| m.set(&row, 0, wanted));
        loop {
            let frame = Instant::now();
            harness.step();
            frames.push(frame.elapsed().as_secs_f64());
            if harness.state().session.simulated.as_ref().is_some_and(|s| s.params.scalar("series_stiffness") == wanted)
            {
                break;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        follows.push(moved.elapsed().as_secs_f64());
    }
    let told = |name: &str, mut times: Vec<f64>| {
        times.sort_by(f64::total_cmp);
        let at = |part: f64| 1e3 * times[((times.len() - 1) as f64 * part) as usize];
        println!("{name}: median {:.1} ms, 95 % {:.1} ms, longest {:.1} ms", at(0.5), at(0.95), at(1.0));
    };
    told("from a slider's move to the loops and errors of all tests", follows);
    told("a frame meanwhile", frames);
}
