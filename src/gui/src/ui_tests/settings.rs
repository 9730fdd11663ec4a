//! Tests of records with their own settings, and of a fit of one adjustable damper.

use super::made_up::{campaign_of, campaign_of_family, until, window};
use super::narrow::cut_off;
use super::{has, holds, press, says, widget};
use crate::app::App;
use crate::words::{Language, texts};
use dashpot_identification::model_file::family_of_text;
use dashpot_report::family::errors;
use dashpot_report::quality;
use dashpot_simulation::whole_records::Quality;
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use std::path::Path;

/// A damper that depends on a current, with different lags for rising and falling current.
const FAMILY: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\nsetting = [0.0, 1.0]\nsetting_name = \"current\"\nsetting_unit = \"A\"\n\
     setting_time_up = 0.008\nsetting_time_down = 0.02\nfv_velocity = [-1.0, 0.0, 1.0]\n\
     fv_force = [[-800.0, 0.0, 1200.0], [-2400.0, 0.0, 3600.0]]\n";

/// Waits for the forces of all tests at the session's current state.
fn computed(harness: &mut Harness<'_, App>) {
    until(harness, "forces of all tests", |app| {
        let dampers = app.session.dampers();
        app.session.simulated.as_ref().is_some_and(|s| !s.quick && Some(&s.dampers) == dampers.as_ref())
    });
}

/// Returns the mean error of the model on screen over a test, in percent of the test's largest force.
fn error(harness: &Harness<'_, App>, name: &str) -> f64 {
    let session = &harness.state().session;
    let records = &session.campaign.as_ref().unwrap().campaign.records;
    let place = records.iter().position(|record| record.name == name).unwrap();
    session.simulated.as_ref().unwrap().tests[place].percent
}

#[test]
fn each_test_is_compared_at_its_own_setting_or_all_at_the_slider() {
    let folder = tempfile::tempdir().unwrap();
    campaign_of_family(FAMILY, folder.path());
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    std::fs::write(file.path(), FAMILY).unwrap();
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[folder.path().to_owned(), file.path().to_owned()]);
    until(&mut harness, "the records", |app| app.session.has_records());
    computed(&mut harness);
    for test in ["soft", "hard", "steps"] {
        assert!(error(&harness, test) < 1.0, "{test}: {}", error(&harness, test));
    }
    // The slider over the setting affects no test, because all tests have their own settings.
    let before = error(&harness, "hard");
    harness.state_mut().session.move_to(0.5);
    computed(&mut harness);
    assert_eq!(error(&harness, "hard"), before);
    harness.state_mut().session.selected = (0..3).collect();
    harness.step();
    harness.step();
    let names: Vec<String> = harness.state().view.lines.lines.iter().map(|line| line.name.clone()).collect();
    assert!(names.iter().any(|name| name == "hard · model (1 A)"), "{names:?}");
    assert_eq!(
        harness
            .state()
            .session
            .dampers()
            .unwrap()
            .settings(&harness.state().session.campaign.as_ref().unwrap().campaign.records)
            .len(),
        2
    );
    // No test is at 0.5 A, so there is nothing to diagnose.
    assert!(harness.state().session.diagnosed().is_empty());
    harness.key_press(Key::F6);
    until(&mut harness, "the validation", |app| app.session.results.validation.is_some());
    let validation = &harness.state().session.results.validation.as_ref().unwrap().found;
    assert_eq!((validation.settings.len(), validation.changing.is_some()), (2, true));
    assert!(validation.overall.errors.model.error_percent < 1.0, "{:?}", validation.overall);
    let is_old = |harness: &Harness<'_, App>| {
        let session = &harness.state().session;
        session.results.validation.as_ref().is_some_and(|found| found.is_old(session))
    };
    harness.state_mut().session.move_to(1.0);
    computed(&mut harness);
    assert!(!is_old(&harness), "no ticked test is at the slider");
    assert_eq!(harness.state().session.diagnosed().len(), 1);
    // The validation begins with a rating. The diagnosis of one of the settings says so.
    harness.state_mut().view.side = crate::views::Side::Result;
    harness.step();
    let found = &harness.state().session.results.validation.as_ref().unwrap().found;
    let rating = quality::sentence(&Quality::of_validation(found), Language::English.words());
    assert!(says(&harness, &rating), "{rating}");
    assert!(says(&harness, texts(Language::English).percent_of));
    harness.state_mut().session.diagnose();
    until(&mut harness, "the diagnosis", |app| app.session.results.diagnosis.is_some());
    harness.step();
    assert!(holds(&harness, "Only of the setting of the slider, 1 A: 1 of the ticked tests"));
    // Tuned values apply only to the test at 1 A.
    harness.state_mut().session.tune(|m| m.set(dashpot_core::number!("gas_force").row(), 0, 900.0));
    computed(&mut harness);
    assert!(error(&harness, "hard") > 5.0 && error(&harness, "soft") < 1.0);
    harness.state_mut().session.tune(crate::session::model::Tuned::reset);
    // If the user unchecks "Each test at its own setting", all tests are simulated at the setting of the slider.
    harness.state_mut().view.side = crate::views::Side::Tune;
    harness.step();
    for (_, language) in Language::ALL.iter().rev() {
        harness.state_mut().view.language = *language;
        harness.step();
        assert!(has(&harness, Role::CheckBox, texts(*language).own_settings), "{language:?}");
    }
    widget(&harness, Role::CheckBox, "Each test at its own setting").click();
    harness.step();
    computed(&mut harness);
    assert!(error(&harness, "hard") < 1.0 && error(&harness, "soft") > 10.0);
    assert!(is_old(&harness), "the validation is of tests at their own settings");
    assert_eq!(harness.state().session.diagnosed().len(), 3);
    harness.step();
    let names: Vec<String> = harness.state().view.lines.lines.iter().map(|line| line.name.clone()).collect();
    assert!(names.iter().any(|name| name.starts_with("steps · model (the setting changes")), "{names:?}");
}

/// Writes sine tests of the damper at three currents, stated in the file names.
fn sines(folder: &Path) {
    let damper = family_of_text(FAMILY, Path::new("family.toml")).unwrap().definition();
    for current in [0.0, 0.5, 1.0] {
        let one = tempfile::tempdir().unwrap();
        campaign_of(&damper.params_at(current), one.path(), 9);
        for entry in std::fs::read_dir(one.path()).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            std::fs::copy(&path, folder.join(format!("{name}_{:.0}mA.csv", 1e3 * current))).unwrap();
        }
    }
}

#[test]
fn one_damper_over_the_setting_is_fitted_and_taken_back() {
    let folder = tempfile::tempdir().unwrap();
    sines(folder.path());
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    std::fs::write(file.path(), "format = 1\nelements = [\"fv_curve\"]\n").unwrap();
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[folder.path().to_owned(), file.path().to_owned()]);
    until(&mut harness, "the records", |app| app.session.has_records());
    assert_eq!(harness.state().session.settings(), ["current"]);
    press(&mut harness, "Fit");
    assert!(says(&harness, "One ordinary damper"));
    press(&mut harness, "One damper over the setting (current)");
    until(&mut harness, "the fit", |app| app.session.results.family_fit.is_some() && app.session.task.is_none());
    computed(&mut harness);
    let session = &harness.state().session;
    let (axis, _) = session.model.as_ref().unwrap().over_setting().unwrap();
    assert_eq!((axis.grid(), axis.name(), axis.unit()), (&[0.0, 0.5, 1.0][..], "current", "A"));
    assert!(session.own_settings && session.is_unsaved());
    assert!(session.simulated.as_ref().unwrap().tests.iter().all(|test| test.percent < 2.0));
    // The result opens automatically, in every language.
    for (_, language) in Language::ALL.iter().rev() {
        harness.state_mut().view.language = *language;
        harness.step();
        assert!(says(&harness, language.words().family_errors_section), "{language:?}");
        let fit = &harness.state().session.results.family_fit.as_ref().unwrap().found;
        let between = errors::between(fit, language.words());
        assert!(says(&harness, &between), "{language:?}: {between}");
        let words = texts(*language);
        let panel = widget(&harness, Role::Button, words.tune).rect().left() - 8.0;
        for side in [words.tune, words.result] {
            press(&mut harness, side);
            harness.step();
            for role in [Role::Label, Role::Button, Role::CheckBox] {
                let cut = cut_off(&harness, role, (panel, 1280.0));
                assert!(cut.is_empty(), "{language:?}, {side}: {cut:#?}");
            }
        }
    }
    let old = texts(Language::English).old_result;
    harness.state_mut().session.move_to(0.7);
    harness.step();
    assert!(!holds(&harness, old), "the slider does not change what was fitted");
    // The saved file contains the adjustable damper.
    let out = tempfile::tempdir().unwrap();
    let path = out.path().join("family.toml");
    assert!(harness.state_mut().session.save(&path));
    assert!(dashpot_identification::model_file::read_family(&path).unwrap().axis.is_some());
    press(&mut harness, "Undo");
    assert!(harness.state().session.model.as_ref().unwrap().over_setting().is_none());
    assert!(holds(&harness, old));
    press(&mut harness, "Redo");
    assert!(harness.state().session.model.as_ref().unwrap().over_setting().is_some());
    assert!(!holds(&harness, old));
}
