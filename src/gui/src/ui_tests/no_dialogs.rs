//! Tests of the window on a system that shows no dialogs, because it has neither a desktop portal nor zenity.

use super::made_up::window_with;
use super::*;
use crate::dialogs::Native;
use crate::session::exports::Host;
use egui_kittest::kittest::NodeT as _;

/// Opens a window with the dialogs of a system without a bus and without zenity on the path.
fn without_dialogs(folder: &Path) -> Harness<'static, App> {
    let file = model(folder);
    campaign(folder, 6);
    let path = |name: &str| (name == "PATH").then(|| "/nowhere".into());
    let mut harness = window_with(Box::new(Native::new(path)));
    harness.state_mut().session.open(&[folder.to_owned(), file]);
    until(&mut harness, "forces", |app| app.session.simulated.as_ref().is_some_and(|s| !s.quick));
    harness
}

/// Confirms the choice inside the window after a button asked for it, and waits for the end of writing.
fn confirm(harness: &mut Harness<'_, App>) {
    until(harness, "the choice", |app| app.view.choosing.is_some());
    assert!(holds(harness, "install xdg-desktop-portal with a backend, or zenity"), "why it is chosen here");
    press(harness, "OK");
    until(harness, "the file", |app| app.session.task.is_none());
}

#[test]
fn every_save_and_export_writes_or_says_why_not() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = without_dialogs(folder.path());
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 2.5e6));
    let w = crate::words::texts(Language::English);
    press(&mut harness, w.file);
    press(&mut harness, w.save_as);
    // The dialog proposes the name of the opened model. It warns the user that this choice would replace that file.
    until(&mut harness, "the choice", |app| app.view.choosing.is_some());
    assert!(says(&harness, w.is_there_already));
    confirm(&mut harness);
    let saved = Tuned::read(&folder.path().join("damper.toml")).unwrap();
    assert_eq!(saved.params().number(number!("series_stiffness")), 2.5e6, "{:?}", message(&harness));
    for (host, text) in [
        (Host::Property, w.export_property),
        (Host::Adams, w.export_adams),
        (Host::Fmu, w.export_fmu),
        (Host::Fmu3, w.export_fmu3),
        (Host::Vehicle, w.export_vehicle),
    ] {
        harness.state_mut().session.message = None;
        let path = folder.path().join(host.proposed());
        // FMI 2.0 and 3.0 have the same proposed name.
        let _ = std::fs::remove_file(&path);
        press(&mut harness, w.export);
        press(&mut harness, text);
        confirm(&mut harness);
        let (said, wrong) = message(&harness);
        assert!(said.len() > 20 && path.exists() != wrong, "{host:?}: {said}");
        // Only an FMU may be impossible, because it needs a library that may not be compiled.
        assert!(!wrong || (path.ends_with(".fmu") || said.contains(".a") || said.contains("FMU")), "{host:?}: {said}");
        assert!(!wrong || !matches!(host, Host::Property | Host::Adams), "{host:?}: {said}");
    }
    // Plots and tables are saved the same way.
    press(&mut harness, "Save plot Force over velocity");
    press(&mut harness, "CSV");
    confirm(&mut harness);
    assert!(folder.path().join("plot.csv").is_file());
    // A path that cannot be written is rejected: the OK button is disabled.
    std::fs::create_dir(folder.path().join("plot.svg")).unwrap();
    press(&mut harness, "Save plot Force over velocity");
    press(&mut harness, "SVG");
    until(&mut harness, "the choice", |app| app.view.choosing.is_some());
    assert!(widget(&harness, Role::Button, "OK").accesskit_node().is_disabled(), "a folder is no file");
    press(&mut harness, "Cancel");
    assert!(harness.state().view.choosing.is_none());
}

#[test]
fn a_model_tuned_by_hand_is_saved_before_a_fit_without_dialogs() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = without_dialogs(folder.path());
    let own = folder.path().join("damper.toml");
    // A model without a file is saved under the proposed name.
    harness.state_mut().session.model.as_mut().unwrap().path = None;
    std::fs::remove_file(&own).unwrap();
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 2.5e6));
    press(&mut harness, "Fit");
    assert!(says(&harness, "Replace the model tuned by hand?"));
    press(&mut harness, "Save first");
    confirm(&mut harness);
    assert_eq!(Tuned::read(&own).unwrap().params().number(number!("series_stiffness")), 2.5e6);
    until(&mut harness, "the fit", |app| app.session.results.fit.is_some() && app.session.task.is_none());
}
