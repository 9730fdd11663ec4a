//! Tests of the window from its user's view, without a screen. They find widgets by their accessible names.
//!
//! The tests are part of the crate, because cargo would build the program for integration tests, and eframe a second time. The program
//! aborts on a panic, but a test has to unwind.

mod answers;
mod corrected_settings;
mod drawings;
mod drawn;
mod made_up;
mod models;
mod narrow;
mod no_dialogs;
mod reference;
mod settings;
mod unusable;
mod valves;

use crate::app::App;
use crate::session::model::Tuned;
use crate::session::simulation::Simulated;
use crate::session::tasks::Kind;
use crate::views::lines::Whose;
use crate::words::Language;
use dashpot_core::parameter::Element;
use dashpot_core::{element, list, number};
use dashpot_test_support::skipped;
use eframe::egui::accesskit::Role;
use eframe::egui::{self, Key, Modifiers, ViewportCommand, ViewportEvent, ViewportId};
use egui_kittest::kittest::{Queryable as _, by};
use egui_kittest::{Harness, Node};
use made_up::{campaign, model, until, window};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Opens a window with records and a model, and waits for all forces.
fn opened(folder: &Path, tests: usize, answers: Vec<Vec<PathBuf>>) -> Harness<'static, App> {
    campaign(folder, tests);
    let models = folder.join("models");
    std::fs::create_dir(&models).unwrap();
    let file = model(&models);
    let mut harness = window(answers);
    harness.state_mut().session.open(&[folder.to_owned(), file]);
    until(&mut harness, "forces of all tests", |app| app.session.simulated.as_ref().is_some_and(|s| !s.quick));
    harness
}

fn stiffness(harness: &Harness<'_, App>) -> f64 {
    harness.state().session.model.as_ref().unwrap().params().number(number!("series_stiffness"))
}

fn message(harness: &Harness<'_, App>) -> (String, bool) {
    harness.state().session.message.as_ref().map_or_else(Default::default, |m| (m.text.to_string(), m.wrong))
}

/// Finds the widget with this role and this name. Ignores a label with equal text, because it has another role.
#[track_caller]
fn widget<'h>(harness: &'h Harness<'_, App>, role: Role, label: &'h str) -> Node<'h> {
    let found = harness.query_all(by().role(role).label(label)).next();
    found.unwrap_or_else(|| panic!("there is no {role:?} called {label:?}"))
}

/// Clicks a button and draws two frames.
#[track_caller]
fn press(harness: &mut Harness<'_, App>, label: &str) {
    widget(harness, Role::Button, label).click();
    harness.step();
    harness.step();
}

fn has(harness: &Harness<'_, App>, role: Role, label: &str) -> bool {
    harness.query_all(by().role(role).label(label)).next().is_some()
}

fn says(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_all(by().label(text)).next().is_some()
}

/// Returns whether a label contains this text.
fn holds(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_all(by().label_contains(text)).next().is_some()
}

#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|e| e.to_string())
    }
}

fn sheets(path: &Path) -> Vec<(String, calamine::Range<calamine::Data>)> {
    let mut book: calamine::Xlsx<_> = calamine::open_workbook(path).unwrap();
    calamine::Reader::worksheets(&mut book)
}

fn drop_files(harness: &mut Harness<'_, App>, paths: &[PathBuf]) {
    let files = paths.iter().map(|p| Arc::new(Dropped(p.clone())) as egui::DroppedFileHandle);
    harness.input_mut().dropped_files = files.collect();
    harness.step();
}

#[test]
fn a_folder_is_opened_by_its_button_and_its_loops_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), 9);
    let mut harness = window(vec![vec![folder.path().to_owned()]]);
    harness.step();
    assert!(says(&harness, "No records open"));
    press(&mut harness, "Open folder of records…");
    until(&mut harness, "the records", |app| app.session.has_records());
    assert!(has(&harness, Role::Button, "a40_000"));
    let lines = harness.state_mut().view.lines.lines.clone();
    assert_eq!(lines.len(), 3, "all speeds of one amplitude");
    assert!(lines.iter().all(|l| l.whose == Whose::Measured && l.velocity.len() > 100));
    // A click shows one test alone; a click with Ctrl adds a test.
    press(&mut harness, "a20_001");
    assert_eq!(harness.state().session.selected.len(), 1);
    widget(&harness, Role::Button, "a08_002").click_modifiers(Modifiers::COMMAND);
    harness.step();
    harness.step();
    assert_eq!(harness.state().session.selected.len(), 2);
}

#[test]
fn records_and_a_model_are_dropped_onto_the_window() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), 6);
    let models = tempfile::tempdir().unwrap();
    let file = model(models.path());
    let mut harness = window(vec![]);
    drop_files(&mut harness, &[folder.path().to_owned(), file]);
    until(&mut harness, "forces", |app| app.session.simulated.is_some());
    let session = &harness.state().session;
    assert_eq!(session.simulated.as_ref().unwrap().tests.len(), 6);
    // The model differs from the measured damper, and the matrix shows the errors.
    assert!(session.simulated.as_ref().unwrap().tests.iter().any(|t| t.percent > 0.1));
}

#[test]
fn a_slider_is_dragged_and_the_loops_follow_and_it_is_taken_back() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    let before = stiffness(&harness);
    // The row may lie outside the visible part of the panel, so the test scrolls to it first.
    widget(&harness, Role::Slider, "series stiffness N/mm").scroll_to_me();
    harness.step();
    harness.step();
    let slider = widget(&harness, Role::Slider, "series stiffness N/mm").rect();
    harness.drag_at(slider.center());
    harness.step();
    let generation = harness.state().session.generation;
    for part in [0.6, 0.7, 0.8] {
        harness.hover_at(egui::pos2(slider.left() + part * slider.width(), slider.center().y));
        harness.step();
    }
    harness.drop_at(egui::pos2(slider.left() + 0.8 * slider.width(), slider.center().y));
    harness.step();
    let after = stiffness(&harness);
    assert!(after > 1.5 * before, "{before} {after}");
    until(&mut harness, "forces of the tuned model", |app| {
        app.session
            .simulated
            .as_ref()
            .is_some_and(|s| s.dampers.params().number(number!("series_stiffness")) == after && !s.quick)
    });
    assert!(harness.state().session.generation > generation);
    until(&mut harness, "forces of the identified model", |app| app.session.identified.is_some());
    harness.step();
    let lines = harness.state_mut().view.lines.lines.clone();
    assert!(lines.iter().any(|l| l.whose == Whose::Identified) && lines.iter().any(|l| l.whose == Whose::Model));
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.step();
    assert_eq!(stiffness(&harness), before, "the drag is one step");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Y);
    harness.step();
    assert_eq!(stiffness(&harness), after);
    press(&mut harness, "Reset");
    assert_eq!(stiffness(&harness), before);
}

#[test]
fn an_element_is_switched_and_shows_in_every_force() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    let before = harness.state().session.simulated.clone().unwrap();
    assert!(harness.state().session.model.as_ref().unwrap().params().is_on(element!("series_compliance")));
    widget(&harness, Role::CheckBox, "series compliance").click();
    harness.step();
    harness.step();
    assert!(!harness.state().session.model.as_ref().unwrap().params().is_on(element!("series_compliance")));
    until(&mut harness, "forces without it", |app| {
        app.session
            .simulated
            .as_ref()
            .is_some_and(|s| !s.dampers.params().is_on(element!("series_compliance")) && !s.quick)
    });
    let after = harness.state().session.simulated.clone().unwrap();
    assert!(before.tests.iter().zip(&after.tests).any(|(a, b)| (a.percent - b.percent).abs() > 0.01));
}

#[test]
fn a_point_of_the_curve_is_dragged_on_the_plot_and_stops_at_its_neighbours() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    let session = &mut harness.state_mut().session;
    let before = session.model.as_ref().unwrap().params().list(list!("fv_force")).to_vec();
    session.tune(|m| crate::views::plots::drag(m, 3, [0.0, 1e5], false).0);
    let after = session.model.as_ref().unwrap().params().list(list!("fv_force")).to_vec();
    assert_eq!(after[3], before[4], "no further than its neighbour");
    session.tune(|m| crate::views::plots::drag(m, 6, [0.0, 50.0], false).0);
    assert_eq!(session.model.as_ref().unwrap().params().list(list!("fv_force"))[6], 0.0, "no force at rest");
}

#[test]
fn a_tuned_model_is_saved_and_opened_again() {
    let folder = tempfile::tempdir().unwrap();
    let out = tempfile::tempdir().unwrap();
    let path = out.path().join("tuned.toml");
    let mut harness = opened(folder.path(), 6, vec![vec![path.clone()]]);
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 2.5e6));
    assert!(harness.state().session.is_unsaved());
    press(&mut harness, "File");
    press(&mut harness, "Save model as…");
    assert!(!harness.state().session.is_unsaved(), "{:?}", message(&harness));
    assert_eq!(Tuned::read(&path).unwrap().params().number(number!("series_stiffness")), 2.5e6);
    // A model never replaces a record.
    let record = folder.path().join("a40_000.csv");
    let text = std::fs::read_to_string(&record).unwrap();
    assert!(!harness.state_mut().session.save(&record));
    assert_eq!(std::fs::read_to_string(&record).unwrap(), text);
    assert!(message(&harness).1);
}

#[test]
fn a_fit_is_cancelled_and_leaves_everything_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 24, vec![]);
    let before = *harness.state().session.model.as_ref().unwrap().params();
    // Cancel before the next frame, because the fit may be complete by then. The window discards even a complete result. The test of a
    // cancelled diagnosis clicks the Cancel button instead.
    harness.state_mut().session.fit();
    assert!(harness.state().session.task.as_ref().is_some_and(|t| t.kind == Kind::Fit));
    harness.state().session.cancel();
    let asked = Instant::now();
    until(&mut harness, "the end of the fit", |app| app.session.task.is_none());
    let took = asked.elapsed();
    assert_eq!(*harness.state().session.model.as_ref().unwrap().params(), before);
    assert!(harness.state().session.results.fit.is_none());
    assert!(took.as_secs() < 30, "{took:?}");
}

#[test]
fn a_model_is_fitted_validated_and_its_answer_shown() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), 12);
    let out = tempfile::tempdir().unwrap();
    let named = |name: &str| out.path().join(name);
    let papers = [named("fit.xlsx"), named("validation.xlsx"), named("report.html")];
    let mut harness = window(papers.iter().map(|path| vec![path.clone()]).collect());
    harness.state_mut().session.open(&[folder.path().to_owned()]);
    until(&mut harness, "the records", |app| app.session.has_records());
    harness.key_press(Key::F5);
    until(&mut harness, "the fit", |app| app.session.results.fit.is_some());
    until(&mut harness, "its forces", |app| app.session.simulated.is_some());
    let errors = harness.state().session.simulated.as_ref().unwrap().tests.clone();
    assert!(errors.iter().all(|t| t.percent < 2.0), "{errors:?}");
    assert!(harness.state().session.is_unsaved(), "a new model is not saved yet");
    press(&mut harness, "Answer");
    press(&mut harness, "Tables to Excel…");
    until(&mut harness, "the fit's tables", |app| app.session.task.is_none() && papers[0].exists());
    let tables = sheets(&papers[0]);
    let estimates = &harness.state().session.results.fit.as_ref().unwrap().found.fit.estimates;
    assert_eq!(tables.iter().find(|(name, _)| name == "Model parameters").unwrap().1.height(), 1 + estimates.len());
    harness.key_press(Key::F6);
    until(&mut harness, "the validation", |app| app.session.results.validation.is_some());
    assert!(says(&harness, "all tests"));
    // The first button with this label belongs to the validation, the second to the fit.
    harness.get_all_by_label("Tables to Excel…").next().unwrap().click();
    harness.step();
    until(&mut harness, "the validation's tables", |app| app.session.task.is_none() && papers[1].exists());
    let tables = sheets(&papers[1]);
    assert_eq!(tables.iter().find(|(name, _)| name == "Errors of every test").unwrap().1.height(), 13);
    harness.state_mut().view.language = crate::words::Language::German;
    harness.step();
    press(&mut harness, "Bericht schreiben…");
    until(&mut harness, "the report", |app| app.session.task.is_none() && papers[2].exists());
    let page = std::fs::read_to_string(&papers[2]).unwrap();
    // The report has the contents of the report of `dashpot validate`: parameters of the model, the sign convention, files with their
    // hashes.
    for text in ["Parameter des Modells", "Zugstufe positiv", "SHA-256", "fv_force[0]", "a40_000"] {
        assert!(page.contains(text), "{text}");
    }
    // The errors in the report equal the errors in the window, because both come from the same forces.
    let validation = &harness.state().session.results.validation.as_ref().unwrap().found;
    for (of, own) in validation.tests.iter().zip(&errors) {
        assert!((of.errors.model.error_percent - own.percent).abs() < 1e-9);
    }
}

#[test]
fn a_broken_file_is_named_and_what_was_open_stays() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    let broken = tempfile::tempdir().unwrap();
    let record = broken.path().join("broken.csv");
    std::fs::write(&record, "time_s,displacement_mm,force_N\n0,1,2\n0.1,x,3\n").unwrap();
    drop_files(&mut harness, &[record]);
    until(&mut harness, "an answer", |app| app.session.task.is_none());
    let (text, wrong) = message(&harness);
    assert!(wrong && text.contains("broken.csv"), "{text}");
    assert_eq!(harness.state().session.campaign.as_ref().unwrap().tests.len(), 6);
    let file = broken.path().join("m.toml");
    std::fs::write(&file, "format = 1\nelements = []\nseries_stifness = 1\n").unwrap();
    drop_files(&mut harness, &[file]);
    let (text, wrong) = message(&harness);
    assert!(wrong && text.contains("line 3"), "{text}");
    assert!(harness.state().session.model.is_some());
}

#[test]
fn a_folder_that_vanishes_is_named_and_what_was_read_stays() {
    let folder = tempfile::tempdir().unwrap();
    let gone = folder.path().join("gone");
    std::fs::create_dir(&gone).unwrap();
    let mut harness = opened(&gone, 6, vec![]);
    std::fs::remove_dir_all(&gone).unwrap();
    harness.state_mut().session.read_again();
    until(&mut harness, "an answer", |app| app.session.task.is_none());
    let (text, wrong) = message(&harness);
    assert!(wrong && text.contains("gone"), "{text}");
    assert_eq!(harness.state().session.campaign.as_ref().unwrap().tests.len(), 6);
    assert!(!harness.state_mut().session.keep_reading());
}

#[test]
fn reading_is_corrected_by_hand_and_kept_for_every_verb() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    let before = harness.state().session.campaign.as_ref().unwrap().tests[0].max_force;
    press(&mut harness, "Records");
    harness.state_mut().session.reading.gain = 2.0;
    widget(&harness, Role::CheckBox, "Tests in subfolders too").click();
    widget(&harness, Role::ComboBox, "Dates such as 3/11/2026").click();
    harness.step();
    harness.step();
    press(&mut harness, "day first");
    press(&mut harness, "Read again");
    until(&mut harness, "the records again", |app| app.session.task.is_none());
    let after = harness.state().session.campaign.as_ref().unwrap().tests[0].max_force;
    assert!((after / before - 2.0).abs() < 1e-6, "{before} {after}");
    press(&mut harness, "Keep as campaign.toml");
    let profile = dashpot_records::Profile::read(folder.path()).unwrap().unwrap();
    assert_eq!((profile.gain, profile.subfolders, profile.dates.as_deref()), (2.0, true, Some("day-first")));
    // Excluding a test rereads the folder, so this test is missing.
    harness.state_mut().session.exclude(0);
    until(&mut harness, "the records again", |app| app.session.task.is_none());
    assert_eq!(harness.state().session.campaign.as_ref().unwrap().tests.len(), 5, "{:?}", message(&harness));
}

#[test]
fn a_campaign_in_subfolders_opens_with_its_option_and_a_long_error_is_visible_as_a_whole() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("soft")).unwrap();
    campaign(&folder.path().join("soft"), 3);
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[folder.path().to_owned()]);
    until(&mut harness, "the error", |app| app.session.task.is_none() && app.session.message.is_some());
    let (text, wrong) = message(&harness);
    assert!(wrong && text.contains("--subfolders"), "{text}");
    let text = format!("{text} {}", "The error has more words than fit into one row of the window. ".repeat(5));
    harness.state_mut().session.complain(dashpot_messages::Sentence::as_it_is(&text));
    harness.step();
    harness.step();
    let rect = widget(&harness, Role::Label, &format!("⚠ {text}")).rect();
    let screen = harness.ctx.content_rect();
    assert!(rect.height() > 40.0 && screen.contains_rect(rect), "{rect:?} in {screen:?}");
    let reading = dashpot_records::Options { subfolders: true, ..dashpot_records::Options::default() };
    harness.state_mut().session.open_with(&[folder.path().to_owned()], reading);
    until(&mut harness, "the records", |app| app.session.has_records());
    assert_eq!(harness.state().session.campaign.as_ref().unwrap().tests.len(), 3);
}

#[test]
fn five_hundred_tests_are_listed_and_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 500, vec![]);
    assert_eq!(harness.state().session.simulated.as_ref().unwrap().tests.len(), 500);
    let count = harness.state().session.campaign.as_ref().unwrap().tests.len();
    harness.state_mut().session.selected = (0..count).collect();
    harness.step();
    let points: usize = harness.state().view.lines.lines.iter().map(|l| l.velocity.len()).sum();
    assert!(points < 80_000, "thinned to what a frame can draw: {points}");
    widget(&harness, Role::TextInput, "Filter by name").click();
    harness.step();
    widget(&harness, Role::TextInput, "Filter by name").type_text("a08_002");
    harness.step();
    harness.step();
    assert!(has(&harness, Role::CheckBox, "Use a08_002") && !has(&harness, Role::CheckBox, "Use a08_005"));
}

#[test]
fn closing_in_the_middle_of_a_fit_asks_first() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 24, vec![]);
    press(&mut harness, "Fit");
    let close = |harness: &mut Harness<'_, App>| {
        let viewport = harness.input_mut().viewports.entry(ViewportId::ROOT).or_default();
        viewport.events.push(ViewportEvent::Close);
        harness.step();
    };
    let sent = |harness: &Harness<'_, App>, wanted: &ViewportCommand| {
        harness.output().viewport_output.values().any(|v| v.commands.contains(wanted))
    };
    close(&mut harness);
    assert!(sent(&harness, &ViewportCommand::CancelClose));
    harness.step();
    assert!(says(&harness, "Close dashpot?"));
    press(&mut harness, "Stay");
    assert!(!says(&harness, "Close dashpot?"));
    assert!(harness.state().session.task.is_some(), "the fit goes on");
    close(&mut harness);
    harness.step();
    press(&mut harness, "Close anyway");
    assert!(harness.state().view.may_close);
    until(&mut harness, "the end of the fit", |app| app.session.task.is_none());
    assert!(harness.state().session.results.fit.is_none());
}

#[test]
fn closing_with_nothing_to_lose_does_not_ask() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 3, vec![]);
    let viewport = harness.input_mut().viewports.entry(ViewportId::ROOT).or_default();
    viewport.events.push(ViewportEvent::Close);
    harness.step();
    assert!(harness.state().view.may_close && !harness.state().view.closing);
}

#[test]
fn every_language_draws_every_view() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    for (_, language) in Language::ALL {
        harness.state_mut().view.language = language;
        let words = crate::words::texts(language);
        for side in [words.tune, words.result, words.records, words.study] {
            harness.step();
            harness.step();
            press(&mut harness, side);
        }
        harness.step();
        assert!(has(&harness, Role::Button, words.study));
    }
}

#[test]
fn a_number_is_studied_and_an_effect_is_looked_at() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    press(&mut harness, "Study");
    press(&mut harness, "Compute");
    until(&mut harness, "the family", |app| app.session.study.is_some());
    let study = harness.state().session.study.clone().unwrap();
    assert_eq!(study.members.len(), 7);
    harness.state_mut().view.effect = Some((element!("gas_spring"), 2.0));
    harness.step();
    assert!(harness.state().view.lines.lines.iter().any(|l| l.whose == Whose::Effect));
}

#[test]
fn a_campaign_is_compared_with_another() {
    let folder = tempfile::tempdir().unwrap();
    let other = tempfile::tempdir().unwrap();
    campaign(other.path(), 6);
    let mut harness = opened(folder.path(), 6, vec![]);
    harness.state_mut().session.open_reference(vec![other.path().to_owned()]);
    until(&mut harness, "the other campaign", |app| app.session.reference.is_some());
    harness.step();
    let lines = harness.state().view.lines.lines.clone();
    let count = |whose: Whose| lines.iter().filter(|l| l.whose == whose).count();
    assert!(count(Whose::Reference) > 0 && count(Whose::Reference) == count(Whose::Measured));
}

#[test]
fn a_plot_is_saved_as_a_table_and_as_a_figure() {
    let folder = tempfile::tempdir().unwrap();
    let out = tempfile::tempdir().unwrap();
    let (csv, svg) = (out.path().join("p.csv"), out.path().join("p.svg"));
    let mut harness = opened(folder.path(), 3, vec![vec![csv.clone()], vec![svg.clone()]]);
    for kind in ["CSV", "SVG"] {
        press(&mut harness, "Save plot Force over velocity");
        press(&mut harness, kind);
    }
    let table = std::fs::read_to_string(&csv).unwrap_or_else(|e| panic!("{e}: {:?}", message(&harness)));
    assert!(table.starts_with("line,\"Velocity [m/s]\",\"Force [N]\"\n") && table.lines().count() > 100);
    let figure = std::fs::read_to_string(&svg).unwrap();
    assert!(figure.starts_with("<svg") && figure.contains("Force over velocity"));
}

#[test]
fn every_host_is_exported_to_and_what_must_be_known_beside_it_is_written_and_said() {
    use crate::session::exports::Host;
    let folder = tempfile::tempdir().unwrap();
    let out = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 3, vec![]);
    // This friction is steep enough to chatter in a host with zero-order hold of the force.
    harness.state_mut().session.tune(|m| {
        // A series spring would reduce the chatter.
        m.switch(element!("series_compliance"), false);
        m.switch(element!("stribeck_friction"), false);
        m.switch(element!("coulomb_friction"), true)
            && m.set(number!("coulomb_force").row(), 0, 40.0)
            && m.set(number!("coulomb_steepness").row(), 0, 5000.0)
    });
    let mut write = |host: Host, name: &str| {
        harness.state_mut().session.export(host, out.path().join(name));
        until(&mut harness, "the export", |app| app.session.task.is_none());
        let (text, wrong) = message(&harness);
        assert!(!wrong, "{text}");
        text
    };
    assert!(write(Host::Adams, "run").contains("coulomb_friction makes it"));
    let readme = std::fs::read_to_string(out.path().join("run/README.txt")).unwrap();
    assert!(readme.contains("coulomb_friction") && readme.contains("A damper for Adams"), "{readme}");
    assert!(out.path().join("run/damper.toml").is_file());
    // A property file lists the omitted effects and contains only the curve, which does not chatter.
    let said = write(Host::Property, "d.dpr");
    assert!(
        said.contains("Left out") && said.contains("coulomb_friction") && !said.contains("At a host step"),
        "{said}"
    );
    let text = std::fs::read_to_string(out.path().join("d.dpr")).unwrap();
    assert!(text.contains("Left out") && text.contains("check sum"), "{text}");
    // FMUs are complete only if this program contains the compiled runtimes. Otherwise the test reports that it skips them.
    if dashpot_hosts::runtimes::compiled("linux64", "dashpot_damper.so").is_none() {
        skipped(format!("FMUs, for there are no compiled runtimes; {}", dashpot_hosts::runtimes::HOW));
        return;
    }
    for (host, name, inside) in [
        (Host::Fmu, "two.fmu", "fmiVersion=\"2.0\""),
        (Host::Fmu3, "three.fmu", "fmiVersion=\"3.0\""),
        (Host::Vehicle, "car.fmu", "Damper_Force_R2"),
    ] {
        assert!(write(host, name).contains("coulomb_friction makes it"), "{name}");
        let mut archive = zip::ZipArchive::new(std::fs::File::open(out.path().join(name)).unwrap()).unwrap();
        let mut description = String::new();
        let mut file = archive.by_name("modelDescription.xml").unwrap();
        std::io::Read::read_to_string(&mut file, &mut description).unwrap();
        assert!(description.contains(inside), "{name}: {description}");
    }
}

#[test]
fn a_curve_that_chatters_is_said_in_its_property_file() {
    use crate::session::exports::{Export, Host};
    let out = tempfile::tempdir().unwrap();
    let path = out.path().join("steep.dpr");
    let mut params = dashpot_core::Params::new();
    let steep: Vec<f64> = params.list(list!("fv_force")).iter().map(|f| 60.0 * f).collect();
    params.set_list(list!("fv_force"), &steep).unwrap();
    let said = Export { host: Host::Property, params, text: String::new(), name: String::new() }.write(&path).unwrap();
    assert!(said.iter().any(|s| s.contains("At a host step of 1 ms")), "{said:?}");
    assert!(std::fs::read_to_string(&path).unwrap().contains("At a host step of 1 ms"));
}

#[test]
fn what_is_to_be_known_of_a_run_folder_is_said_as_everywhere_else() {
    use crate::session::exports::{Export, Host};
    let out = tempfile::tempdir().unwrap();
    let path = out.path().join("run");
    let mut params = dashpot_core::Params::new();
    let write = |params: &dashpot_core::Params| {
        let text = dashpot_identification::model_file::plain(params, &[]);
        Export { host: Host::Adams, params: *params, text, name: String::new() }.write(&path).unwrap()
    };
    params.enable(element!("series_compliance"), true);
    write(&params);
    assert!(path.join("native.adm").is_file());
    params.enable(element!("series_compliance"), false);
    let said = write(&params);
    let holds = |part: &str| said.iter().any(|note| note.contains(part));
    assert!(holds("no native.adm, because the element series_compliance is off"), "{said:?}");
    // The folder still contains `native.adm` of the damper with a series path, so a note asks the user to delete this file.
    assert!(holds("is of an earlier export and not of this model: delete it"), "{said:?}");
    std::fs::remove_file(path.join("native.adm")).unwrap();
    assert!(!write(&params).iter().any(|note| note.contains("earlier export")));
}

#[test]
fn a_missing_effect_is_diagnosed_reported_and_taken_over() {
    let folder = tempfile::tempdir().unwrap();
    let out = tempfile::tempdir().unwrap();
    let report = out.path().join("diagnosis.html");
    let mut harness = opened(folder.path(), 18, vec![vec![report.clone()]]);
    let opened_params = *harness.state().session.model.as_ref().unwrap().params();
    // The measured damper has a series spring, so the model without a series spring lacks this effect.
    widget(&harness, Role::CheckBox, "series compliance").click();
    harness.step();
    harness.step();
    let params = |harness: &Harness<'_, App>| *harness.state().session.model.as_ref().unwrap().params();
    let without = params(&harness);
    harness.key_press(Key::F6);
    until(&mut harness, "the validation", |app| app.session.results.validation.is_some());
    harness.key_press(Key::F7);
    harness.step();
    assert!(harness.state().session.task.as_ref().is_some_and(|t| t.kind == Kind::Diagnose));
    let mut told = 0.0;
    until(&mut harness, "the diagnosis", |app| {
        told = app.session.task.as_ref().map_or(told, |t| t.progress().done.max(told));
        app.session.task.is_none()
    });
    assert!(told > 0.0, "it said how far it is");
    let crate::session::results::Diagnosed { found, .. } =
        &harness.state().session.results.diagnosis.as_ref().unwrap_or_else(|| panic!("{:?}", message(&harness))).found;
    // Tests on a rig hardly distinguish a series spring from compressible oil. Both names are correct.
    let names: Vec<&str> = found.findings.iter().map(|f| f.effect).collect();
    let named = *names.first().unwrap_or_else(|| panic!("{}", found.summary));
    assert!(["series_compliance", "oil_compressibility"].contains(&named), "{names:?} {}", found.summary);
    assert!(found.after.rmse_n < 0.5 * found.before.rmse_n);
    let headlines = Language::ALL.map(|(_, of)| (of, dashpot_report::diagnosis::headline(found, of.words())));
    // English comes last, because the following steps use English texts.
    for (language, headline) in headlines.iter().rev() {
        harness.state_mut().view.language = *language;
        harness.step();
        assert!(says(&harness, headline), "{headline}");
    }
    harness.check_accessibility();
    press(&mut harness, "Write report…");
    until(&mut harness, "the report", |app| app.session.task.is_none());
    let page = std::fs::read_to_string(&report).unwrap_or_else(|e| panic!("{e}: {:?}", message(&harness)));
    assert!(page.contains(named) && page.contains("<svg"));
    press(&mut harness, "Take the improved model");
    // The user disabled the element and did not save the model, so the window asks before it replaces the model.
    press(&mut harness, "Replace");
    let model = harness.state().session.model.as_ref().unwrap();
    assert!(model.params().is_on(Element::find(named).unwrap()) && model.is_unsaved());
    until(&mut harness, "its forces", |app| {
        app.session
            .simulated
            .as_ref()
            .is_some_and(|s| !s.quick && s.dampers.params().is_on(Element::find(named).unwrap()))
    });
    // Undo restores the models before the fit, before the adopted diagnosis, and before the manual tuning. Redo restores them in the
    // opposite order. Each result is out of date except for the model from which it was computed.
    let improved = params(&harness);
    harness.key_press(Key::F5);
    until(&mut harness, "the fit", |app| app.session.results.fit.is_some() && app.session.task.is_none());
    let fitted = params(&harness);
    assert!(fitted != improved && !says(&harness, "Replace the model tuned by hand?"));
    let old = |harness: &Harness<'_, App>| {
        let session = &harness.state().session;
        let results = &session.results;
        [
            results.validation.as_ref().unwrap().is_old(session),
            results.diagnosis.as_ref().unwrap().is_old(session),
            results.fit.as_ref().unwrap().is_old(session),
        ]
    };
    assert_eq!(old(&harness), [true, true, false]);
    let steps = [(improved, [true; 3]), (without, [false, false, true]), (opened_params, [true; 3])];
    for (wanted, marks) in steps {
        press(&mut harness, "Undo");
        assert!(params(&harness) == wanted && old(&harness) == marks, "{:?}", old(&harness));
    }
    assert!(!harness.state().session.can_undo().0);
    for wanted in [without, improved, fitted] {
        press(&mut harness, "Redo");
        assert!(params(&harness) == wanted);
    }
    assert_eq!(old(&harness), [true, true, false]);
}

#[test]
fn a_diagnosis_is_cancelled_and_leaves_everything_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 72, vec![]);
    // A diagnosis of this many tests takes seconds. With fewer tests, it might end before the click on Cancel.
    widget(&harness, Role::CheckBox, "series compliance").click();
    harness.step();
    harness.step();
    press(&mut harness, "Diagnose");
    press(&mut harness, "Cancel");
    let asked = Instant::now();
    until(&mut harness, "the end", |app| app.session.task.is_none());
    assert!(asked.elapsed().as_secs() < 30, "{:?}", asked.elapsed());
    assert!(harness.state().session.results.diagnosis.is_none() && !message(&harness).1, "{:?}", message(&harness));
}

#[test]
fn everything_that_can_be_used_has_a_name_for_a_screen_reader() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    harness.check_accessibility();
    for side in ["Tune", "Answer", "Records", "Study", "Force over time"] {
        press(&mut harness, side);
        harness.step();
        harness.check_accessibility();
    }
}

/// Measures the latency of the window, on the user's own campaign and model.
///
/// The first time is from reading the records to the first loops. The second is from a slider's move to the loops and errors of all tests.
/// The third is the time of one frame during that computation, without the graphics card.
///
/// `DASHPOT_CAMPAIGN=... DASHPOT_MODEL=... cargo test --profile tests -p dashpot-gui latency -- --ignored --nocapture`
#[test]
#[ignore = "measures, and needs a campaign and a model"]
fn latency() {
    let given = |name: &str| std::env::var_os(name).map(PathBuf::from);
    let (Some(records), Some(model)) = (given("DASHPOT_CAMPAIGN"), given("DASHPOT_MODEL")) else {
        skipped("DASHPOT_CAMPAIGN and DASHPOT_MODEL name no campaign and no model");
        return;
    };
    const MOVES: usize = 60;
    let mut harness = window(vec![]);
    let began = Instant::now();
    harness.state_mut().session.open(&[records, model]);
    until(&mut harness, "the records", |app| app.session.has_records());
    let tests = harness.state().session.campaign.as_ref().unwrap().tests.len();
    println!("{tests} tests: {:.0} ms from opening to the first loops", 1e3 * began.elapsed().as_secs_f64());
    until(&mut harness, "the forces", |app| app.session.simulated.as_ref().is_some_and(|s| !s.quick));
    println!("{:.0} ms until model and errors stand beside them", 1e3 * began.elapsed().as_secs_f64());
    let row = *number!("series_stiffness").row();
    let value = stiffness(&harness);
    let (mut follows, mut frames) = (Vec::new(), Vec::new());
    for k in 1..=MOVES {
        let wanted = value * (1.0 + 0.01 * k as f64);
        let moved = Instant::now();
        harness.state_mut().session.tune(|m| m.set(&row, 0, wanted));
        loop {
            let frame = Instant::now();
            harness.step();
            frames.push(frame.elapsed().as_secs_f64());
            let there = |s: &Arc<Simulated>| s.dampers.params().number(number!("series_stiffness")) == wanted;
            if harness.state().session.simulated.as_ref().is_some_and(there) {
                break;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        follows.push(moved.elapsed().as_secs_f64());
    }
    let print_times = |name: &str, mut times: Vec<f64>| {
        times.sort_by(f64::total_cmp);
        let at = |part: f64| 1e3 * times[((times.len() - 1) as f64 * part) as usize];
        println!("{name}: median {:.1} ms, 95 % {:.1} ms, longest {:.1} ms", at(0.5), at(0.95), at(1.0));
    };
    print_times("from a slider's move to the loops and errors of all tests", follows);
    print_times("a frame meanwhile", frames);
}
