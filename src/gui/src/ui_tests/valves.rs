//! Tests of the panel of an adjustable damper's valve: its responses and parameters.

use super::made_up::{campaign, campaign_of_family, until, window};
use super::{has, holds, press, says};
use crate::views::Side;
use crate::words::{Language, texts};
use eframe::egui::accesskit::Role;

/// A damper that depends on a current, with different lags for rising and falling current.
const FAMILY: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\nsetting = [0.0, 1.0]\nsetting_name = \"current\"\nsetting_unit = \"A\"\n\
     setting_time_up = 0.008\nsetting_time_down = 0.02\nfv_velocity = [-1.0, 0.0, 1.0]\n\
     fv_force = [[-800.0, 0.0, 1200.0], [-2400.0, 0.0, 3600.0]]\n\n[identification]\n\n[identification.intervals]\nsetting_time_up = [0.007, 0.009]\n";

#[test]
fn a_family_shows_the_response_of_its_valve_by_its_numbers_where_no_test_has_steps() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), 6);
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    std::fs::write(file.path(), FAMILY).unwrap();
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[folder.path().to_owned()]);
    until(&mut harness, "the records", |app| app.session.has_records());
    assert!(!has(&harness, Role::Button, "Valve"), "there is no model");
    harness.state_mut().session.open(&[file.path().to_owned()]);
    until(&mut harness, "the model", |app| app.session.has_valve());
    press(&mut harness, "Valve");
    assert!(says(&harness, "Response to a step up: 0 → 1 A") && says(&harness, "Response to a step down: 1 → 0 A"));
    assert!(holds(&harness, "the setting of the valve alone"));
    // A first-order lag reaches 63 % of a step after one time constant, and 90 % after 2.3 time constants. The time constants are 8 ms and
    // 20 ms.
    for time in ["8.0", "18.4", "20.0", "46.1"] {
        assert!(says(&harness, time), "{time} ms");
    }
    assert!(says(&harness, "setting_time_up") && holds(&harness, "(7."), "its interval");
    for (_, language) in Language::ALL {
        harness.state_mut().view.language = language;
        harness.step();
        assert!(says(&harness, texts(language).of_valve), "{language:?}");
    }
    // Without valve dynamics the panel disappears.
    std::fs::write(
        file.path(),
        FAMILY.replace("setting_time", "# setting_time").split("[identification]").next().unwrap(),
    )
    .unwrap();
    harness.state_mut().session.open(&[file.path().to_owned()]);
    until(&mut harness, "the other model", |app| !app.session.has_valve());
    assert!(harness.state().view.side == Side::Tune && !has(&harness, Role::Button, "Valve"));
}

#[test]
fn steps_of_the_open_tests_are_shown_measured_beside_the_model() {
    let folder = tempfile::tempdir().unwrap();
    // The measured damper has another lag than the open model.
    campaign_of_family(&FAMILY.replace("up = 0.008", "up = 0.012"), folder.path());
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    std::fs::write(file.path(), FAMILY).unwrap();
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[folder.path().to_owned(), file.path().to_owned()]);
    until(&mut harness, "the responses", |app| app.session.responses.of_force.len() == 2);
    press(&mut harness, "Valve");
    let of = harness.state().session.step_response(true).unwrap();
    let (measured, model) = (of.measured.unwrap(), of.model.unwrap());
    assert!((measured.t63_s - 0.012).abs() < 0.0015 && (model.t63_s - 0.008).abs() < 0.0015, "{measured:?} {model:?}");
    assert!(of.steps > 3 && of.tests == ["steps"], "{of:?}");
    assert!(says(&harness, &format!("Force, as a fraction of its way; mean of so many steps: {}", of.steps)));
    assert!(
        says(&harness, &format!("{:.1}", 1e3 * measured.t63_s)) && !holds(&harness, "the setting of the valve alone")
    );
}

#[test]
fn a_family_that_may_supply_energy_is_named_where_it_is_tuned() {
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    let remark = "zero velocity, 0 N at 0 A to 300.0 N at 1 A";
    for (text, is_named) in [(FAMILY.to_owned(), false), (FAMILY.replace("-2400.0, 0.0", "-2400.0, 300.0"), true)] {
        // Without the results of a fit, the window treats the model file as made by hand.
        std::fs::write(file.path(), text.split("[identification]").next().unwrap()).unwrap();
        let mut harness = window(vec![]);
        harness.state_mut().session.open(&[file.path().to_owned()]);
        harness.state_mut().view.side = Side::Tune;
        harness.step();
        harness.step();
        assert_eq!(holds(&harness, remark), is_named);
    }
}
