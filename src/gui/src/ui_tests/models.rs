//! Tests of replaced models: no tuned value is lost, all changes can be undone, and results state their basis.

use super::*;
use crate::session::replacing::Replacement;
use crate::units::{Force, Units, Velocity};

fn params(harness: &Harness<'_, App>) -> dashpot_core::Params {
    *harness.state().session.model.as_ref().unwrap().params()
}

fn fitted(harness: &mut Harness<'_, App>) {
    until(harness, "the fit", |app| app.session.results.fit.is_some() && app.session.task.is_none());
}

#[test]
fn undo_goes_back_over_a_fit_and_forth_again() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 12, vec![]);
    let opened = params(&harness);
    // The values are saved before the fit, so the window does not ask for confirmation before it replaces them.
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 2.5e6));
    let out = tempfile::tempdir().unwrap();
    assert!(harness.state_mut().session.save(&out.path().join("m.toml")));
    let tuned = params(&harness);
    harness.key_press(Key::F5);
    fitted(&mut harness);
    let found = params(&harness);
    assert_ne!(found, tuned);
    press(&mut harness, "Undo");
    assert_eq!(params(&harness), tuned, "the model before the fit");
    press(&mut harness, "Undo");
    assert_eq!(params(&harness), opened, "and the steps before it");
    press(&mut harness, "Redo");
    press(&mut harness, "Redo");
    assert_eq!(params(&harness), found);
    assert!(!harness.state().session.can_undo().1);
    // A change after an undo discards the redo steps.
    press(&mut harness, "Undo");
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 3e6));
    assert!(!harness.state().session.can_undo().1);
}

#[test]
fn a_model_tuned_by_hand_is_not_replaced_without_a_question() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 12, vec![]);
    let other = tempfile::tempdir().unwrap();
    let file = model(other.path());
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 2.5e6));
    let tuned = params(&harness);
    let title = "Replace the model tuned by hand?";
    // The three replacements are a fit, an opened file and a dropped file.
    for how in 0..3 {
        match how {
            0 => press(&mut harness, "Fit"),
            1 => harness.state_mut().session.replace(Replacement::File(file.clone())),
            _ => drop_files(&mut harness, &[file.clone()]),
        }
        harness.step();
        harness.step();
        assert!(says(&harness, title) && harness.state().session.task.is_none(), "{how}");
        press(&mut harness, "Stay");
        assert!(!says(&harness, title) && params(&harness) == tuned, "{how}");
    }
    harness.state_mut().session.replace(Replacement::File(file));
    harness.step();
    harness.step();
    press(&mut harness, "Replace");
    assert_ne!(params(&harness), tuned);
    press(&mut harness, "Undo");
    assert_eq!(params(&harness), tuned, "it can be gone back to");
    // If the user tunes the model during a fit, the window asks at the end of the fit.
    harness.state_mut().session.fit();
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 2.6e6));
    let tuned = params(&harness);
    until(&mut harness, "the fit", |app| app.session.task.is_none());
    assert!(says(&harness, title));
    assert_eq!(params(&harness), tuned);
    press(&mut harness, "Replace");
    assert_ne!(params(&harness), tuned);
}

#[test]
fn an_answer_that_is_not_of_what_is_on_screen_says_so_and_the_answer_comes_by_itself() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), 12);
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[folder.path().to_owned()]);
    until(&mut harness, "the records", |app| app.session.has_records());
    press(&mut harness, "Fit");
    fitted(&mut harness);
    let old = "⚠ Out of date: the model, the records or the ticked tests have changed since";
    // Only parameters that the fit identified have an identified value.
    let session = &harness.state().session;
    let model = session.model.as_ref().unwrap();
    let estimates = session.estimates();
    assert!(estimates.iter().any(|e| e.standing != dashpot_identification::Standing::Identified));
    for e in estimates.iter().filter(|e| e.index.is_none()) {
        let row = dashpot_core::parameter::find(e.name).unwrap();
        let identified = e.standing == dashpot_identification::Standing::Identified && e.low.is_some();
        assert_eq!(model.identified_value(&row, 0).is_some(), identified, "{} {:?}", e.name, e.standing);
    }
    // The panel begins with a sentence on the quality of the fit.
    harness.step();
    assert_eq!(harness.state().view.side, crate::views::Side::Result);
    let quality = harness.state().session.results.fit.as_ref().unwrap().found.quality.clone().unwrap();
    for (_, language) in Language::ALL.iter().rev() {
        harness.state_mut().view.language = *language;
        harness.step();
        let sentence = dashpot_report::quality::sentence(&quality, language.words());
        assert!(says(&harness, &sentence), "{sentence}");
    }
    assert!(!says(&harness, old));
    harness.key_press(Key::F6);
    until(&mut harness, "the validation", |app| app.session.results.validation.is_some());
    assert!(!says(&harness, old));
    harness.state_mut().session.tune(|m| m.set(number!("gas_force").row(), 0, 77.0));
    harness.step();
    assert_eq!(harness.query_all(by().label(old)).count(), 2, "fit and validation");
    press(&mut harness, "Undo");
    assert!(!says(&harness, old), "they are of this model again");
    harness.state_mut().session.unticked.insert(0);
    harness.step();
    assert!(says(&harness, old));
    harness.state_mut().session.unticked.clear();
    harness.step();
    assert!(!says(&harness, old));
    // A validation of values that were tuned while it ran is out of date when it arrives.
    harness.key_press(Key::F6);
    harness.step();
    harness.state_mut().session.tune(|m| m.set(number!("gas_force").row(), 0, 78.0));
    harness.state_mut().session.results.validation = None;
    until(&mut harness, "the validation", |app| app.session.results.validation.is_some());
    assert_eq!(harness.query_all(by().label(old)).count(), 2, "fit and validation");
    press(&mut harness, "Undo");
    assert!(!says(&harness, old));
    // After an undo of the fit, the model on screen does not come from the fit. Undo needs an earlier model, so another model is opened
    // first.
    let other = tempfile::tempdir().unwrap();
    harness.state_mut().session.replace(Replacement::File(made_up::model(other.path())));
    harness.step();
    assert_eq!(harness.query_all(by().label(old)).count(), 2, "both are of the model before");
    press(&mut harness, "Undo");
    assert!(!says(&harness, old));
    // Another campaign makes the fit out of date. The validation has no records any more, so it disappears.
    campaign(other.path(), 6);
    harness.state_mut().session.open(&[other.path().to_owned()]);
    until(&mut harness, "the other records", |app| {
        app.session.task.is_none() && app.session.campaign.as_ref().is_some_and(|c| c.tests.len() == 6)
    });
    harness.step();
    assert_eq!(harness.query_all(by().label(old)).count(), 1);
    assert!(harness.state().session.results.validation.is_none());
}

#[test]
fn a_study_of_another_damper_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    press(&mut harness, "Study");
    press(&mut harness, "Compute");
    until(&mut harness, "the study", |app| app.session.study.is_some() && app.session.task.is_none());
    let old = "⚠ Out of date: the model, the records or the ticked tests have changed since";
    assert!(!says(&harness, old));
    // The study varies this number itself, so its present value does not matter.
    let varied = harness.state().session.study.as_ref().unwrap().question.number;
    let value = params(&harness).number(varied);
    harness.state_mut().session.tune(|m| m.set(varied.row(), 0, 1.3 * value));
    harness.step();
    assert!(!says(&harness, old) && harness.state().session.model.as_ref().unwrap().is_tuned());
    harness.state_mut().session.tune(|m| m.set(number!("gas_force").row(), 0, 77.0));
    harness.step();
    // The plot and the panel both have the mark. Another panel may cover the one with the mark.
    let marks = |harness: &Harness<'_, App>| harness.query_all(by().label(old)).count();
    assert_eq!(marks(&harness), 2);
    press(&mut harness, "Tune");
    assert_eq!(marks(&harness), 1);
    press(&mut harness, "Undo");
    assert!(!says(&harness, old));
}

#[test]
fn an_undo_behind_the_question_does_not_answer_it() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    let other = tempfile::tempdir().unwrap();
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 2.5e6));
    let tuned = params(&harness);
    harness.state_mut().session.replace(Replacement::File(made_up::model(other.path())));
    harness.step();
    harness.step();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.step();
    harness.step();
    assert!(says(&harness, "Replace the model tuned by hand?"));
    press(&mut harness, "Stay");
    assert!(params(&harness) == tuned && harness.state().session.pending.is_none());
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.step();
    assert!(params(&harness) != tuned, "without a question, the shortcut acts");
}

#[test]
fn values_tuned_at_a_setting_are_not_lost_by_going_to_another() {
    let (_folders, mut harness) = window_of_family(6);
    harness.state_mut().session.tune(|m| m.set(number!("gas_force").row(), 0, 123.0));
    let tuned = params(&harness);
    // After a reset, the slider can move again. The reset can be undone.
    press(&mut harness, "Reset");
    for setting in [0.25, 0.5, 0.75] {
        harness.state_mut().session.move_to(setting);
    }
    harness.step();
    press(&mut harness, "Undo");
    let at = |harness: &Harness<'_, App>| harness.state().session.model.as_ref().unwrap().over_setting().unwrap().1;
    assert_eq!(at(&harness), 0.0, "back at the setting of the tuned values");
    press(&mut harness, "Undo");
    assert!(params(&harness) == tuned);
}

#[test]
fn without_dialogs_of_the_system_a_path_is_chosen_in_the_window() {
    use crate::dialogs::Message;
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), 6);
    let models = folder.path().join("models");
    std::fs::create_dir(&models).unwrap();
    let file = model(&models);
    let began = std::rc::Rc::<std::cell::RefCell<Vec<Option<PathBuf>>>>::default();
    let asked = std::rc::Rc::clone(&began);
    let mut harness = made_up::window_with(Box::new(Message::without_dialogs(asked)));
    harness.state_mut().session.open(&[folder.path().to_owned(), file]);
    until(&mut harness, "forces", |app| app.session.simulated.is_some());
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 2.5e6));
    press(&mut harness, "File");
    press(&mut harness, "Save model as…");
    harness.step();
    assert_eq!(began.borrow().last().unwrap().as_deref(), Some(folder.path()), "in the folder of the campaign");
    assert!(harness.query_all(by().label_contains("zenity")).next().is_some(), "why it is chosen here");
    harness.check_accessibility();
    press(&mut harness, "OK");
    let saved = folder.path().join("damper.toml");
    assert_eq!(
        Tuned::read(&saved).unwrap().params().number(number!("series_stiffness")),
        2.5e6,
        "{:?}",
        message(&harness)
    );
    // A click on the folder of the model enters it.
    press(&mut harness, "File");
    press(&mut harness, "Open model…");
    harness.step();
    press(&mut harness, "models/");
    press(&mut harness, "damper.toml");
    press(&mut harness, "OK");
    assert_eq!(
        harness.state().session.model.as_ref().unwrap().path.as_deref(),
        Some(models.join("damper.toml").as_path())
    );
}

#[test]
fn tabs_stand_still() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 12, vec![]);
    let places = |harness: &Harness<'_, App>, language: Language| {
        let w = crate::words::texts(language);
        let of_side = [w.tune, w.result, w.records, w.study];
        let of_corner = [w.error_matrix, w.force_time, w.gas_and_drag, w.tables];
        of_side.into_iter().chain(of_corner).map(|text| widget(harness, Role::Button, text).rect()).collect::<Vec<_>>()
    };
    let stand = |first: &[egui::Rect], now: &[egui::Rect], case: &str| {
        for (a, b) in first.iter().zip(now) {
            assert!((a.min - b.min).length() < 0.6 && (a.max - b.max).length() < 0.6, "{case}: {a} {b}");
        }
    };
    for (_, language) in Language::ALL {
        harness.state_mut().view.language = language;
        harness.step();
        harness.step();
        let first = places(&harness, language);
        let w = crate::words::texts(language);
        let sides = [w.tune, w.result, w.records, w.study];
        for tab in sides.into_iter().chain([w.force_time, w.gas_and_drag, w.tables, w.error_matrix]) {
            press(&mut harness, tab);
            harness.step();
            stand(&first, &places(&harness, language), &format!("{language:?} {tab}"));
        }
    }
    // Results, tuning and a study do not move the tabs either.
    let language = Language::English;
    harness.state_mut().view.language = language;
    harness.run_steps(2);
    let first = places(&harness, language);
    harness.key_press(Key::F5);
    fitted(&mut harness);
    harness.run_steps(2);
    stand(&first, &places(&harness, language), "a fit");
    harness.key_press(Key::F6);
    until(&mut harness, "the validation", |app| app.session.results.validation.is_some());
    stand(&first, &places(&harness, language), "a validation");
    press(&mut harness, "Tune");
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 2.5e6));
    until(&mut harness, "forces of both models", |app| app.session.identified.is_some());
    stand(&first, &places(&harness, language), "a tuned model");
}

#[test]
fn names_are_translated_and_units_are_those_chosen() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    for (language, name) in [
        (Language::German, "Reihensteifigkeit"),
        (Language::French, "raideur en série"),
        (Language::Chinese, "串联刚度"),
    ] {
        harness.state_mut().view.language = language;
        harness.step();
        assert!(has(&harness, Role::Slider, &format!("{name} N/mm")), "{name}");
    }
    harness.state_mut().view.language = Language::English;
    harness.state_mut().view.units = Units { velocity: Velocity::InchesPerSecond, force: Force::Pounds };
    harness.step();
    assert!(has(&harness, Role::Slider, "series stiffness lbf/in"));
    let most = |harness: &Harness<'_, App>| {
        let lines = &harness.state().view.lines.lines;
        let of =
            |f: fn(&egui_plot::PlotPoint) -> f64| lines.iter().flat_map(|l| &l.velocity).map(f).fold(0.0, f64::max);
        (of(|p| p.x), of(|p| p.y))
    };
    harness.step();
    let inches = most(&harness);
    harness.state_mut().view.units = Units::default();
    harness.step();
    harness.step();
    let metric = most(&harness);
    assert!(
        (inches.0 / metric.0 - 1.0 / 0.0254).abs() < 1e-6 && (inches.1 * 4.448_221_615 / metric.1 - 1.0).abs() < 1e-6
    );
}

#[test]
fn a_point_that_stops_says_why() {
    use crate::views::plots::{Stop, drag};
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    let session = &mut harness.state_mut().session;
    let mut stops = Vec::new();
    let zero =
        session.model.as_ref().unwrap().params().list(list!("fv_velocity")).iter().position(|v| *v == 0.0).unwrap();
    session.tune(|m| {
        stops.push(drag(m, zero, [0.0, 50.0], false).1);
        stops.push(drag(m, 3, [0.0, 1e5], false).1);
        stops.push(drag(m, 3, [1e3, 0.0], true).1);
        // This change is small, and the neighbors leave space on both sides. The drawn point follows the pointer.
        let at = m.params().list(list!("fv_force"))[2];
        let (moved, stop) = drag(m, 2, [0.0, at - 5.0], false);
        stops.push(stop);
        moved
    });
    assert_eq!(stops[0], Some(Stop::AtRest));
    assert_eq!(stops[1], Some(Stop::Force));
    assert!(stops[2].is_some());
}

#[test]
fn the_tables_of_velocities_are_shown_and_saved() {
    let folder = tempfile::tempdir().unwrap();
    let out = tempfile::tempdir().unwrap();
    let files = [out.path().join("cvp.csv"), out.path().join("pvp.csv")];
    let mut harness = opened(folder.path(), 6, files.iter().map(|f| vec![f.clone()]).collect());
    press(&mut harness, "PVP, CVP");
    for k in 0..2 {
        let button = |harness: &Harness<'_, App>| {
            let found = harness.query_all(by().role(Role::Button).label("Save table…")).nth(k);
            found.unwrap_or_else(|| panic!("table {k} has no button")).rect().center()
        };
        harness.query_all(by().role(Role::Button).label("Save table…")).nth(k).unwrap().scroll_to_me();
        // The scroll is animated, so the test waits for its end.
        harness.run_steps(30);
        let at = button(&harness);
        harness.hover_at(at);
        harness.step();
        harness.drag_at(at);
        harness.drop_at(at);
        harness.step();
        harness.step();
    }
    let rows = |path: &Path| -> Vec<Vec<String>> {
        let text = std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{e}: {:?}", message(&harness)));
        text.lines().skip(1).map(|l| l.split(',').map(str::to_owned).collect()).collect()
    };
    let [cvp, pvp] = files.each_ref().map(|f| rows(f));
    assert_eq!(pvp.len(), 6);
    // The records come from a model with another series spring, so measured and computed peak forces agree only within 20 %.
    for row in &pvp {
        let numbers: Vec<f64> = row[1..].iter().map(|c| c.parse().unwrap()).collect();
        assert!(numbers[1] > 0.0 && numbers[4] < 0.0 && (numbers[2] / numbers[3] - 1.0).abs() < 0.2, "{row:?}");
    }
    assert!(cvp.len() >= 6, "{cvp:?}");
    let velocities: Vec<f64> = cvp.iter().map(|r| r[0].parse().unwrap()).collect();
    assert!(velocities.windows(2).all(|w| w[0] > w[1]), "{velocities:?}");
}

/// A damper whose curve grows with a current.
const FAMILY: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\nsetting = [0.0, 1.0]\nsetting_name = \"current\"\nsetting_unit = \"A\"\n\
     fv_velocity = [-1.0, 0.0, 1.0]\nfv_force = [[-800.0, 0.0, 1200.0], [-2400.0, 0.0, 3600.0]]\n";

/// Opens a campaign of `tests` tests with [`FAMILY`] and waits for the forces of all tests. The folders exist as long as
/// their values.
fn window_of_family(tests: usize) -> ([tempfile::TempDir; 2], Harness<'static, App>) {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), tests);
    let models = tempfile::tempdir().unwrap();
    let file = models.path().join("family.toml");
    std::fs::write(&file, FAMILY).unwrap();
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[folder.path().to_owned(), file]);
    until(&mut harness, "forces of all tests", |app| app.session.simulated.as_ref().is_some_and(|s| !s.quick));
    ([folder, models], harness)
}

#[test]
fn a_slider_goes_over_the_setting_of_a_family_and_its_loops_follow() {
    let (_folders, mut harness) = window_of_family(12);
    let most = |harness: &Harness<'_, App>| {
        let lines = &harness.state().view.lines.lines;
        let own = lines.iter().filter(|line| line.whose != Whose::Measured);
        own.flat_map(|line| &line.velocity).map(|point| point.y).fold(0.0, f64::max)
    };
    harness.step();
    let soft = most(&harness);
    assert!(has(&harness, Role::Slider, "current A"));
    let slider = widget(&harness, Role::Slider, "current A").rect();
    harness.drag_at(slider.center());
    harness.step();
    harness.hover_at(egui::pos2(slider.right() - 1.0, slider.center().y));
    harness.step();
    harness.drop_at(egui::pos2(slider.right() - 1.0, slider.center().y));
    harness.step();
    let at = |harness: &Harness<'_, App>| harness.state().session.model.as_ref().unwrap().over_setting().unwrap().1;
    assert!(at(&harness) > 0.4, "{}", at(&harness));
    let wanted = params(&harness);
    until(&mut harness, "forces there", |app| {
        app.session.simulated.as_ref().is_some_and(|s| !s.quick && *s.dampers.params() == wanted)
    });
    harness.step();
    assert!(most(&harness) > 1.5 * soft, "{} at {} A, {soft} at 0 A", most(&harness), at(&harness));
    // Moving the slider does not count as tuning. A tuned model keeps its setting.
    assert!(!harness.state().session.model.as_ref().unwrap().is_tuned());
    harness.state_mut().session.tune(|m| m.set(number!("gas_force").row(), 0, 123.0));
    let before = at(&harness);
    harness.state_mut().session.move_to(0.0);
    assert_eq!(at(&harness), before);
}
