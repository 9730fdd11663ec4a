//! Tests of the panel of the results: the order of the results, texts that must appear only once, and units.

use super::drawn::each_shape;
use super::*;
use crate::units::{Force, Units, Velocity};
use crate::views::{Corner, Side};
use dashpot_identification::Standing;
use eframe::egui::Shape;

/// Runs a task by its key, and waits for its end.
fn run(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    harness.step();
    until(harness, "the result", |app| app.session.task.is_none());
}

/// Returns the titles of the results from top to bottom.
fn titles(harness: &Harness<'_, App>) -> Vec<&'static str> {
    let w = crate::words::texts(Language::English);
    let mut all: Vec<(f32, &str)> = Vec::new();
    each_shape(harness, |shape, _| {
        if let Shape::Text(text) = shape {
            let title = [w.fit_result, w.validation_result, w.diagnosis_result];
            let is_heading = text.galley.job.sections.iter().all(|of| of.format.font_id.size > 15.0);
            let found = title.into_iter().find(|title| is_heading && *title == text.galley.job.text);
            all.extend(found.map(|title| (text.pos.y, title)));
        }
    });
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.into_iter().map(|(_, title)| title).collect()
}

#[test]
fn the_newest_answer_stands_first_and_the_panel_opens_at_it() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 12, vec![]);
    let w = crate::words::texts(Language::English);
    run(&mut harness, Key::F7);
    run(&mut harness, Key::F6);
    // The user reads the end of the diagnosis while the fit runs.
    let panel = widget(&harness, Role::Button, w.tune).rect().center() + egui::vec2(0.0, 300.0);
    harness.hover_at(panel);
    for _ in 0..20 {
        harness.event(egui::Event::MouseWheel {
            unit: egui::MouseWheelUnit::Point,
            delta: egui::vec2(0.0, -400.0),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Unknown,
            modifiers: Modifiers::NONE,
        });
        harness.step();
    }
    harness.run_steps(30);
    assert!(!titles(&harness).contains(&w.validation_result), "the panel is scrolled: {:?}", titles(&harness));
    run(&mut harness, Key::F5);
    harness.run_steps(3);
    let quality = harness.state().session.results.fit.as_ref().unwrap().found.quality.as_ref().unwrap();
    let sentence = dashpot_report::quality::sentence(quality, Language::English.words());
    let rect = widget(&harness, Role::Label, &sentence).rect();
    let tabs = widget(&harness, Role::Button, w.tune).rect().bottom();
    assert!(rect.top() > tabs && rect.top() < tabs + 80.0, "{rect:?} below {tabs}");
    // In a window of this height, the panel shows all results.
    harness.set_size(egui::vec2(1280.0, 8000.0));
    harness.run_steps(3);
    assert_eq!(titles(&harness), [w.fit_result, w.validation_result, w.diagnosis_result]);
    // After the undo, the model is the one before the fit. Validation and diagnosis belong to this model, so they come
    // before the fit.
    press(&mut harness, "Undo");
    harness.run_steps(2);
    assert_eq!(titles(&harness), [w.validation_result, w.diagnosis_result, w.fit_result]);
}

#[test]
fn what_a_fit_did_not_identify_stands_once() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    run(&mut harness, Key::F5);
    harness.set_size(egui::vec2(1280.0, 8000.0));
    for (_, language) in Language::ALL {
        harness.state_mut().view.language = language;
        harness.run_steps(2);
        let said = language.words();
        let fit = &harness.state().session.results.fit.as_ref().unwrap().found.fit;
        let is_open =
            |e: &&dashpot_identification::Estimate| e.standing == Standing::NotIdentified && e.index.is_none();
        let open: Vec<_> = fit.estimates.iter().filter(is_open).collect();
        assert!(!open.is_empty());
        // The notes of the fit also contain the notes on the unidentified parameters, so the panel could state them
        // twice.
        let notes: Vec<String> = fit.notes.iter().map(|note| said.say(note)).collect();
        assert!(notes.len() > fit.further_notes().count());
        for e in open {
            let name = crate::views::translate_name(e.name, said);
            let beginnings = [format!("{name}{}", said.colon), format!("• {name}")];
            let lines = harness.query_all(by().role(Role::Label)).filter(|node| {
                let text = node.value().unwrap_or_default();
                beginnings.iter().any(|begin| text.starts_with(begin.as_str()))
            });
            assert_eq!(lines.count(), 1, "{language:?}: {name}");
        }
    }
}

/// Returns the texts of the last frame that state a number in a unit which is not selected.
fn in_other_units(harness: &Harness<'_, App>) -> Vec<String> {
    let mut found = Vec::new();
    each_shape(harness, |shape, _| {
        let Shape::Text(text) = shape else { return };
        let text = text.galley.job.text.replace(['\u{a0}', '\u{202f}'], " ");
        for other in ["N", "kN", "mm", "m/s", "mm/s", "N/mm", "kN/mm", "N·s/m", "J"] {
            let pieces: Vec<&str> = text.split(&format!(" {other}")).collect();
            let states = pieces.windows(2).any(|pair| {
                pair[0].ends_with(|c: char| c.is_ascii_digit())
                    && !pair[1].starts_with(|c: char| c.is_ascii_alphanumeric() || "/·²³".contains(c))
            });
            if states || text.contains(&format!("[{other}]")) {
                found.push(text.clone());
            }
        }
    });
    found
}

#[test]
fn every_number_of_the_window_is_in_the_selected_units() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 12, vec![]);
    // The model lacks the series spring, so that the diagnosis has a finding.
    harness.state_mut().session.tune(|m| m.switch(element!("series_compliance"), false));
    press(&mut harness, "Study");
    press(&mut harness, "Compute");
    until(&mut harness, "the study", |app| app.session.study.is_some() && app.session.task.is_none());
    run(&mut harness, Key::F7);
    run(&mut harness, Key::F6);
    harness.key_press(Key::F5);
    harness.run_steps(2);
    press(&mut harness, "Replace");
    until(&mut harness, "the fit", |app| app.session.results.fit.is_some() && app.session.task.is_none());
    press(&mut harness, "Study");
    press(&mut harness, "Compute");
    until(&mut harness, "the study", |app| app.session.study.is_some() && app.session.task.is_none());
    until(&mut harness, "forces", |app| app.session.simulated.as_ref().is_some_and(|s| !s.quick));
    harness.set_size(egui::vec2(1280.0, 8000.0));
    // With the default SI units, the function finds numbers in these views. Therefore it would also find them below.
    harness.state_mut().view.side = Side::Result;
    harness.run_steps(3);
    assert!(in_other_units(&harness).len() > 20, "{:?}", in_other_units(&harness));
    harness.state_mut().view.units = Units { velocity: Velocity::InchesPerSecond, force: Force::Pounds };
    for (_, language) in Language::ALL {
        harness.state_mut().view.language = language;
        for side in [Side::Tune, Side::Result, Side::Records, Side::Study] {
            harness.state_mut().view.side = side;
            harness.run_steps(2);
            let other = in_other_units(&harness);
            assert!(other.is_empty(), "{language:?} {side:?}: {other:#?}");
        }
        for corner in [Corner::Matrix, Corner::Tables, Corner::Study, Corner::GasAndDrag] {
            harness.state_mut().view.corner = corner;
            harness.run_steps(2);
            let other = in_other_units(&harness);
            assert!(other.is_empty(), "{language:?} {corner:?}: {other:#?}");
        }
    }
}

#[test]
fn errors_of_one_cycle_have_a_mark_until_the_whole_records_follow() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    let marks = |harness: &Harness<'_, App>| {
        let mut count = 0;
        each_shape(harness, |shape, _| {
            if let Shape::Text(text) = shape {
                count += usize::from(text.galley.job.text.contains('≈'));
            }
        });
        count
    };
    harness.run_steps(2);
    assert_eq!(marks(&harness), 0);
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 2.5e6));
    let tests = harness.state().session.campaign.as_ref().unwrap().tests.len();
    // The previous errors belong to another model. The errors of the quick simulation belong to one cycle of each test.
    // Both are provisional.
    for is_quick in [false, true] {
        until(&mut harness, "the errors", |app| app.session.simulated.as_ref().is_some_and(|s| s.quick) == is_quick);
        // The marks are in the list of tests, the details of a test, the error matrix with its mean, and the panel of
        // the model.
        assert!(marks(&harness) >= tests + 4, "quick {is_quick}: {}", marks(&harness));
    }
    until(&mut harness, "the whole records", |app| !app.session.are_errors_provisional());
    harness.run_steps(2);
    assert_eq!(marks(&harness), 0);
}
