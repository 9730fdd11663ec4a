//! `dashpot-window [CAMPAIGN] [MODEL] [D.toml] [--subfolders]`: the program that `dashpot open` starts.

// Without this attribute, Windows opens a console window.
#![cfg_attr(windows, windows_subsystem = "windows")]

use dashpot_gui::app::App;
use dashpot_gui::dialogs::Native;
use dashpot_gui::drawing;
use dashpot_records::Options;
use eframe::egui;
use std::path::PathBuf;
use std::process::ExitCode;

const HELP: &str = "The window of dashpot: records and a model, looked at, tuned, fitted and exported\n\n\
    Usage: dashpot-window [CAMPAIGN] [MODEL] [D.toml] [--subfolders]\n\n\
    CAMPAIGN is a folder of records or record files, MODEL a model file, D.toml the dimensions of the damper; all can be opened or dropped later.\n\
    With --subfolders, the records in subfolders are tests of the same campaign.\n\
    Example: dashpot-window campaign/ damper.toml";

fn main() -> ExitCode {
    let (flags, paths): (Vec<PathBuf>, Vec<PathBuf>) =
        std::env::args_os().skip(1).map(PathBuf::from).partition(|argument| argument.as_os_str() == "--subfolders");
    let reading = Options { subfolders: !flags.is_empty(), ..Options::default() };
    if paths.iter().any(|p| p.as_os_str() == "--help" || p.as_os_str() == "-h") {
        println!("{HELP}");
        return ExitCode::SUCCESS;
    }
    if let Some(missing) = paths.iter().find(|p| !p.exists()) {
        dashpot_output::warn(&format!(
            "dashpot: {}: there is no such file or folder; check the path",
            missing.display()
        ));
        return ExitCode::from(2);
    }
    let viewport = egui::ViewportBuilder::default()
        .with_title("dashpot")
        .with_app_id("dashpot")
        .with_inner_size([1440.0, 900.0])
        .with_min_inner_size([900.0, 600.0])
        .with_drag_and_drop(true);
    let ran = drawing::run(|renderer, opened| {
        let (paths, opened, reading) = (paths.clone(), opened.clone(), reading.clone());
        let options =
            eframe::NativeOptions { viewport: viewport.clone(), renderer, ..eframe::NativeOptions::default() };
        eframe::run_native(
            "dashpot",
            options,
            Box::new(move |creation| {
                opened.set(true);
                let mut app = App::new(&creation.egui_ctx, Box::new(Native::default()));
                app.session.open_with(&paths, reading);
                Ok(Box::new(app))
            }),
        )
    });
    match ran {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let told = format!("no window can be opened here ({error}); on a machine without a screen use the verbs");
            if cfg!(windows) {
                // Without a console, a message box is the only visible output.
                rfd::MessageDialog::new().set_title("dashpot").set_description(told.as_str()).show();
            }
            dashpot_output::warn(&format!("dashpot: {told}"));
            ExitCode::from(2)
        }
    }
}
