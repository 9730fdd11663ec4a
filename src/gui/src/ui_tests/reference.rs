//! Test of the comparison with another campaign: the window diagnoses, shows and reports a change.

use super::made_up::{campaign, campaign_of, truth, until, window};
use super::{message, press, says, widget};
use crate::session::results::Diagnosed;
use dashpot_core::number;
use dashpot_report::diagnosis::headline;
use dashpot_report::words::EN;
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::{Queryable as _, by};

/// Number of tests of each damper.
const TESTS: usize = 18;

#[test]
fn what_changed_against_a_good_damper_is_diagnosed_answered_and_reported() {
    let [good, worn, models, out] = [(); 4].map(|()| tempfile::tempdir().unwrap());
    campaign(good.path(), TESTS);
    // The worn damper has lost gas. All other properties are equal.
    let mut damper = truth();
    let gas = damper.number(number!("gas_force"));
    damper.set(number!("gas_force"), 0.5 * gas).unwrap();
    campaign_of(&damper, worn.path(), TESTS);
    let file = models.path().join("damper.toml");
    std::fs::write(&file, dashpot_identification::model_file::flat(&truth(), |_| String::new())).unwrap();
    let report = out.path().join("changed.html");
    let mut harness = window(vec![vec![good.path().to_owned()], vec![report.clone()]]);
    harness.state_mut().session.open(&[worn.path().to_owned(), file]);
    until(&mut harness, "the records", |app| app.session.simulated.as_ref().is_some_and(|s| !s.quick));
    let words = crate::words::texts(harness.state().view.language);
    press(&mut harness, words.file);
    press(&mut harness, words.compare_campaign);
    until(&mut harness, "the good damper", |app| app.session.reference.is_some());
    harness.key_press(Key::F7);
    harness.step();
    until(&mut harness, "the diagnosis", |app| app.session.task.is_none());
    let said = message(&harness);
    let Some(Diagnosed { found, .. }) = harness.state().session.results.diagnosis.as_ref().map(|a| &a.found) else {
        panic!("{said:?}")
    };
    let change = found.changes.iter().find(|c| c.name == "gas_force");
    let change = change.unwrap_or_else(|| panic!("{} {:?}", found.summary, found.changes));
    let near = |a: f64, b: f64| (a - b).abs() < 0.02 * gas;
    assert!(near(change.reference, gas) && near(change.value, 0.5 * gas), "{change:?}");
    assert!(change.low <= change.value && change.value <= change.high && change.high < change.reference, "{change:?}");
    let headline = headline(found, &EN);
    let before = EN.number(&dashpot_report::numbers::with_unit(change.reference, change.unit));
    // The window shows the change.
    assert!(says(&harness, words.changed) && says(&harness, &headline), "{headline}");
    let line = format!("{}  {before} → ", EN.named("gas_force"));
    assert!(harness.query_all(by().label_contains(&line)).next().is_some(), "{line}");
    // Without the reference, the diagnosis has another basis, so its result is out of date.
    let old = format!("⚠ {}", words.old_result);
    assert!(!says(&harness, &old));
    let reference = harness.state_mut().session.reference.take();
    harness.step();
    assert!(reference.is_some() && says(&harness, &old));
    harness.state_mut().session.reference = reference;
    harness.step();
    assert!(!says(&harness, &old));
    // The report also shows the change against the reference, and lists the files of both dampers.
    widget(&harness, Role::Button, words.write_report).scroll_to_me();
    harness.step();
    press(&mut harness, words.write_report);
    until(&mut harness, "the report", |app| app.session.task.is_none());
    let page = std::fs::read_to_string(&report).unwrap_or_else(|e| panic!("{e}: {:?}", message(&harness)));
    assert!(page.contains("gas_force") && page.contains(EN.changed_section), "{headline}");
    for folder in [good.path(), worn.path()] {
        let name = folder.join("a40_000.csv").display().to_string();
        assert!(page.contains(&name), "{name} is not among the files that the report was made from");
    }
}
