//! Tests of the field for the setting of a test: correction, undo, and the results that depend on it.

use super::made_up::{campaign_of, until, window};
use super::narrow::spoilt;
use super::{has, message, press, widget};
use crate::app::App;
use crate::words::{Language, texts};
use dashpot_core::number;
use dashpot_identification::model_file::family_of_text;
use dashpot_records::{Options, Setting, load};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use std::path::Path;

/// A damper that depends on a current.
const FAMILY: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\nsetting = [0.0, 1.0]\nsetting_name = \"current\"\nsetting_unit = \"A\"\n\
     fv_velocity = [-1.0, 0.0, 1.0]\nfv_force = [[-800.0, 0.0, 1200.0], [-2400.0, 0.0, 3600.0]]\n";

/// Writes sine tests of the damper at two currents, stated in the file names. The name of the test `wrong_0mA` states 0 A; its damper has
/// 1 A.
fn mislabeled(folder: &Path) {
    let damper = family_of_text(FAMILY, Path::new("family.toml")).unwrap().definition();
    for current in [0.0, 1.0] {
        let one = tempfile::tempdir().unwrap();
        campaign_of(&damper.params_at(current), one.path(), 6);
        for entry in std::fs::read_dir(one.path()).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            let stated = format!("{name}_{:.0}mA.csv", 1e3 * current);
            let name = if stated == "a40_003_1000mA.csv" { "wrong_0mA.csv" } else { &stated };
            std::fs::copy(&path, folder.join(name)).unwrap();
        }
    }
}

/// Opens the tests of [`mislabeled`] with their damper, and selects the test with the wrong name.
fn opened(folder: &Path) -> Harness<'static, App> {
    mislabeled(folder);
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    std::fs::write(file.path(), FAMILY).unwrap();
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[folder.to_owned(), file.path().to_owned()]);
    until(&mut harness, "the records", |app| app.session.has_records());
    press(&mut harness, "wrong_0mA");
    computed(&mut harness);
    harness
}

/// Waits until no task is running, and until the forces of all tests are computed with the current settings.
fn computed(harness: &mut Harness<'_, App>) {
    until(harness, "forces of all tests", |app| {
        let session = &app.session;
        session.task.is_none() && session.simulated.is_some() && !session.are_errors_provisional()
    });
}

/// Returns the index of the test with the wrong name.
fn wrong(harness: &Harness<'_, App>) -> usize {
    let records = &harness.state().session.campaign.as_ref().unwrap().campaign.records;
    records.iter().position(|record| record.name == "wrong_0mA").unwrap()
}

/// Returns the current of the test with the wrong name, A.
fn current(harness: &Harness<'_, App>) -> Option<f64> {
    let setting = harness.state().session.record(wrong(harness)).unwrap().setting.clone();
    setting.map(|Setting { name, unit, value }| {
        assert_eq!((name.as_str(), unit.as_str()), ("current", "A"));
        value
    })
}

/// Returns the mean error of the test with the wrong name, in percent of its largest force.
fn error(harness: &Harness<'_, App>) -> f64 {
    harness.state().session.simulated.as_ref().unwrap().tests[wrong(harness)].percent
}

/// Replaces the text in the field of the setting, without applying it.
fn write(harness: &mut Harness<'_, App>, typed: &str) {
    widget(harness, Role::TextInput, "current").click();
    harness.step();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.step();
    harness.key_press(Key::Delete);
    harness.step();
    if !typed.is_empty() {
        widget(harness, Role::TextInput, "current").type_text(typed);
        harness.step();
    }
}

/// Types a setting and applies it.
fn correct(harness: &mut Harness<'_, App>, typed: &str) {
    write(harness, typed);
    harness.key_press(Key::Enter);
    harness.step();
    harness.step();
    computed(harness);
}

fn is_old(harness: &Harness<'_, App>) -> bool {
    let session = &harness.state().session;
    session.results.validation.as_ref().is_some_and(|found| found.is_old(session))
}

#[test]
fn a_wrong_setting_is_corrected_and_taken_back() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path());
    assert_eq!(current(&harness), Some(0.0));
    assert_eq!(widget(&harness, Role::TextInput, "current").value().as_deref(), Some("0 A"));
    assert!(error(&harness) > 20.0, "{}", error(&harness));
    harness.key_press(Key::F6);
    until(&mut harness, "the validation", |app| app.session.results.validation.is_some());
    assert!(!is_old(&harness));
    let found = |harness: &Harness<'_, App>| {
        harness.state().session.results.validation.as_ref().unwrap().found.overall.errors.model.error_percent
    };
    let before = found(&harness);

    correct(&mut harness, "1");
    assert_eq!(current(&harness), Some(1.0));
    assert!(error(&harness) < 1.0, "{}", error(&harness));
    assert!(is_old(&harness), "the validation was at the wrong setting");
    harness.key_press(Key::F6);
    until(&mut harness, "the new validation", |app| {
        app.session.task.is_none() && app.session.results.validation.as_ref().is_some_and(|of| !of.is_old(&app.session))
    });
    assert!(found(&harness) < 0.5 * before, "{} {before}", found(&harness));

    press(&mut harness, "Undo");
    computed(&mut harness);
    assert!(current(&harness) == Some(0.0) && is_old(&harness));
    press(&mut harness, "Redo");
    computed(&mut harness);
    assert!(current(&harness) == Some(1.0) && !is_old(&harness), "the validation is of these settings again");

    // An empty field means that the test has no setting. The name of the test is then ignored.
    correct(&mut harness, "");
    assert_eq!(current(&harness), None);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.step();
    computed(&mut harness);
    assert_eq!(current(&harness), Some(1.0));

    // The button removes the correction, so that the setting comes from the name of the test again.
    press(&mut harness, texts(Language::English).setting_as_read);
    computed(&mut harness);
    assert_eq!(current(&harness), Some(0.0));
    assert!(!has(&harness, Role::Button, texts(Language::English).setting_as_read));
}

#[test]
fn undo_follows_the_order_of_values_and_settings() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path());
    let gas = |harness: &Harness<'_, App>| {
        harness.state().session.model.as_ref().unwrap().params().number(number!("gas_force"))
    };
    let tune = |harness: &mut Harness<'_, App>, force: f64| {
        harness.state_mut().session.tune(|model| {
            let changed = model.set(number!("gas_force").row(), 0, force);
            model.seal();
            changed
        });
        computed(harness);
    };
    let start = gas(&harness);
    tune(&mut harness, 300.0);
    correct(&mut harness, "1");
    tune(&mut harness, 400.0);
    for (value, setting) in [(300.0, 1.0), (300.0, 0.0), (start, 0.0)] {
        press(&mut harness, "Undo");
        computed(&mut harness);
        assert_eq!((gas(&harness), current(&harness)), (value, Some(setting)));
    }
    assert!(!harness.state().session.can_undo().0);
    for (value, setting) in [(300.0, 0.0), (300.0, 1.0), (400.0, 1.0)] {
        press(&mut harness, "Redo");
        computed(&mut harness);
        assert_eq!((gas(&harness), current(&harness)), (value, Some(setting)));
    }
    // A new change discards the redo steps of both the model and the settings.
    press(&mut harness, "Undo");
    press(&mut harness, "Undo");
    computed(&mut harness);
    correct(&mut harness, "0.5");
    assert!(!harness.state().session.can_undo().1);
    // The end of the undo steps is reached with other records.
    let other = tempfile::tempdir().unwrap();
    mislabeled(other.path());
    harness.state_mut().session.open(&[other.path().to_owned()]);
    computed(&mut harness);
    assert_eq!(current(&harness), Some(0.0));
    press(&mut harness, "Undo");
    computed(&mut harness);
    assert_eq!((gas(&harness), current(&harness)), (start, Some(0.0)));
}

#[test]
fn a_correction_is_kept_for_every_verb_and_an_invalid_text_is_not_applied() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path());
    for typed in ["hard", "3 bar"] {
        correct(&mut harness, typed);
        assert_eq!(current(&harness), Some(0.0));
        let (text, is_error) = message(&harness);
        assert!(is_error && text.contains(typed), "{text}");
    }
    // Escape discards the text.
    write(&mut harness, "1");
    harness.key_press(Key::Escape);
    harness.step();
    computed(&mut harness);
    assert_eq!(current(&harness), Some(0.0));
    // A click on another test applies the text. Options of reading that are not applied yet stay as they are.
    harness.state_mut().session.reading.gain = 1.25;
    write(&mut harness, "1000 mA");
    press(&mut harness, "a40_000_0mA");
    computed(&mut harness);
    assert_eq!(current(&harness), Some(1.0));
    assert_eq!(harness.state().session.reading.gain, 1.25);
    harness.state_mut().session.reading.gain = 1.0;
    assert!(harness.state_mut().session.keep_reading());
    let read = || load(&[folder.path().to_owned()], &Options::default(), &|_| ()).unwrap();
    let kept = read().records.into_iter().find(|record| record.name == "wrong_0mA").unwrap();
    assert_eq!(kept.setting.map(|of| of.value), Some(1.0));
    // The undo must take effect although `campaign.toml` contains the correction.
    press(&mut harness, "Undo");
    computed(&mut harness);
    assert_eq!(current(&harness), Some(0.0));
}

#[test]
fn the_field_of_the_setting_fits_into_the_panel_in_every_language() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path());
    correct(&mut harness, "1");
    for (_, language) in Language::ALL {
        harness.state_mut().view.language = language;
        harness.step();
        harness.step();
        let label = language.words().word("current");
        let field = widget(&harness, Role::TextInput, label).rect();
        assert!(field.width() > 50.0, "{language:?}: {field:?}");
        let button = widget(&harness, Role::Button, texts(language).setting_as_read).rect();
        // The panel of the tests is as wide as the field of its filter.
        let panel = widget(&harness, Role::TextInput, texts(language).filter).rect();
        assert!(
            field.right() <= button.left() && button.right() <= panel.right() + 1.0,
            "{language:?}: {button:?} {panel:?}"
        );
        let spoilt = spoilt(&harness);
        assert!(spoilt.is_empty(), "{language:?}: {spoilt:#?}");
    }
}
