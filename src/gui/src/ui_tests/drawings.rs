//! Tests of the dimensions panel.

use super::made_up::{campaign, until, window};
use super::{has, holds, message, press, says};
use crate::app::App;
use crate::views::Side;
use crate::words::Language;
use dashpot_core::number;
use eframe::egui::accesskit::Role;

/// A monotube whose gas force corresponds to a gas pressure of 25 bar on a rod of 12 mm diameter.
const MODEL: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\", \"oil_compressibility\"]\ngas_force = 282.74\n\
     oil_stiffness = 1.0554e7\noil_shortening = 7.69\nfv_velocity = [-1.0, -0.3, -0.1, -0.05, 0.0, 0.05, 0.1, 0.3, 1.0]\n\
     fv_force = [-900.0, -500.0, -300.0, -100.0, 0.0, 200.0, 600.0, 1000.0, 1500.0]\n\n[identification.intervals]\n\
     gas_force = [275.0, 290.0]\noil_stiffness = [1.0e7, 1.1e7]\n";
const DRAWING: &str = "design = \"monotube\"\nbore_mm = 40\nrod_mm = 12\nrebound_chamber_mm = 130\n";

#[test]
fn a_drawing_is_dropped_beside_the_model_and_explains_it() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), 6);
    let files = tempfile::tempdir().unwrap();
    let (model, drawing) = (files.path().join("m.toml"), files.path().join("front axle.toml"));
    std::fs::write(&model, MODEL).unwrap();
    std::fs::write(&drawing, DRAWING).unwrap();
    let mut harness = window(vec![vec![drawing.clone()]]);
    // The dimensions may be opened before model and records.
    harness.state_mut().session.open(&[drawing.clone()]);
    harness.step();
    harness.step();
    assert!(harness.state().view.side == Side::Drawing && has(&harness, Role::Button, "Drawing"));
    assert!(holds(&harness, "Open a model"), "what is missing");
    harness.state_mut().session.open(&[folder.path().to_owned(), model]);
    until(&mut harness, "the model", |app| app.session.model.is_some());
    harness.step();
    assert!(says(&harness, "gas pressure") && holds(&harness, "bar gauge"));
    assert!(says(&harness, "effective modulus of the oil") && holds(&harness, "GPa"));
    // The window lists the missing inputs of a quantity that cannot be determined.
    assert!(holds(&harness, "the model has no gas spring") && holds(&harness, "the drawing lacks tube_wall_mm"));
    assert!(!says(&harness, "Contradictions"));
    // The explanation changes with a tuned parameter.
    let pressure = |app: &mut App| app.session.explain().unwrap().find("gas_pressure").unwrap().value.unwrap();
    let before = pressure(harness.state_mut());
    assert!((before - 25.0).abs() < 0.1, "{before}");
    harness.state_mut().session.tune(|m| m.set(number!("gas_force").row(), 0, 565.48));
    assert!(pressure(harness.state_mut()) > 1.9 * before);
    press(&mut harness, "Undo");
    for (_, language) in Language::ALL {
        harness.state_mut().view.language = language;
        harness.step();
        let noun = language.words().word("gas pressure");
        assert!(says(&harness, noun) && (language == Language::English || noun != "gas pressure"), "{noun}");
    }
    harness.state_mut().view.language = Language::English;
    harness.step();
    // The window shows a contradiction between dimensions and model, with its quantity and its magnitude.
    std::fs::write(&drawing, "rod_mm = 12\ngas_pressure_bar = 12\n").unwrap();
    press(&mut harness, "File");
    press(&mut harness, "Open dimensions…");
    harness.step();
    harness.step();
    assert!(says(&harness, "Contradictions"), "{:?}", message(&harness));
    assert!(holds(
        &harness,
        "The gas force of the model, 283 N, is 2.1 times the 136 N that 12 bar on a rod of 12 mm give."
    ));
    harness.check_accessibility();
}

#[test]
fn a_slip_in_a_drawing_is_said_with_its_line_and_the_one_before_stays() {
    let files = tempfile::tempdir().unwrap();
    let drawing = files.path().join("dimensions.toml");
    let mut harness = window(vec![]);
    std::fs::write(&drawing, DRAWING).unwrap();
    harness.state_mut().session.open(&[drawing.clone()]);
    harness.step();
    assert!(harness.state().session.drawing.is_some());
    for (text, part) in [
        ("rod_mm = 12\nbor_mm = 40\n", "line 2: bor_mm is no entry of a drawing; did you mean bore_mm?"),
        ("bore_mm 40\n", "is not a TOML file"),
        ("bore_mm = 4000\n", "line 1: bore_mm = 4000 lies outside 5 to 300"),
    ] {
        std::fs::write(&drawing, text).unwrap();
        harness.state_mut().session.open(&[drawing.clone()]);
        harness.step();
        let (said, wrong) = message(&harness);
        assert!(wrong && said.contains(part), "{text}: {said}");
        assert!(harness.state().session.drawing.is_some() && harness.state().session.model.is_none());
    }
}
