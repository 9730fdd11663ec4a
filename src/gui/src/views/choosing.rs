//! Dialog inside the window for a file or folder, for systems that show no dialogs.

use crate::dialogs::Ask;
use crate::views::View;
use eframe::egui::{self, Id, Modal, RichText, Ui};
use std::path::PathBuf;

/// State of the dialog.
pub struct Choosing {
    ask: Ask,
    folder: PathBuf,
    /// Text of the input field: a name in the folder, or a whole path.
    name: String,
    /// Names in the folder, and whether each is a folder.
    entries: Vec<(String, bool)>,
}

/// Largest number of directory entries that are read for the list; the user can type any other name.
const LISTED: usize = 2000;

impl Choosing {
    /// Makes the dialog for a request, with the contents of the folder `from` or of the working directory.
    pub fn new(ask: Ask, from: Option<PathBuf>) -> Choosing {
        let from = from.or_else(|| std::env::current_dir().ok()).unwrap_or_default();
        let name = ask.proposed().0.to_owned();
        let mut choosing = Choosing { ask, folder: PathBuf::new(), name, entries: Vec::new() };
        choosing.enter(from);
        choosing
    }

    /// Lists a folder: first the folders, then the files with an accepted extension.
    fn enter(&mut self, folder: PathBuf) {
        let (_, endings) = self.ask.proposed();
        let fits = |name: &str| {
            let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
            endings.is_empty() || endings.iter().any(|e| e.eq_ignore_ascii_case(ending))
        };
        let entries = std::fs::read_dir(&folder).into_iter().flatten().flatten().take(LISTED);
        self.entries = entries
            .filter_map(|entry| Some((entry.file_name().into_string().ok()?, entry.path().is_dir())))
            .filter(|(name, is_folder)| {
                !name.starts_with('.') && (*is_folder || (fits(name) && !self.ask.is_of_folder()))
            })
            .collect();
        self.entries.sort_by(|a, b| (!a.1, &a.0).cmp(&(!b.1, &b.0)));
        self.folder = folder;
    }

    /// Returns the path in the input field.
    fn path(&self) -> PathBuf {
        let name = self.name.trim();
        if name.is_empty() { self.folder.clone() } else { self.folder.join(name) }
    }

    /// Returns whether the request accepts the path.
    fn is_complete(&self) -> bool {
        let path = self.path();
        match (self.ask.is_of_input(), self.ask.is_of_folder()) {
            (true, true) => path.is_dir(),
            (true, false) => path.is_file(),
            (false, _) => {
                path.file_name().is_some()
                    && path.parent().is_some_and(|p| p.is_dir())
                    && !(path.is_dir() && !self.ask.is_of_folder())
            }
        }
    }
}

/// Draws the dialog if it is open.
pub fn show(ui: &Ui, view: &mut View) {
    let w = view.words();
    let Some(choosing) = &mut view.choosing else { return };
    let mut done = None;
    let asked = Modal::new(Id::unique("choosing")).show(ui.ctx(), |ui| {
        ui.set_width(560.0);
        ui.heading(if choosing.ask.is_of_folder() { w.choose_folder } else { w.choose_path });
        ui.add(egui::Label::new(RichText::new(w.no_dialog).weak()).wrap());
        ui.horizontal(|ui| {
            let above = choosing.folder.parent().map(PathBuf::from);
            if ui.add_enabled(above.is_some(), egui::Button::new("⬆")).on_hover_text(w.folder_up).clicked()
                && let Some(above) = above
            {
                choosing.enter(above);
            }
            ui.add(egui::Label::new(choosing.folder.display().to_string()).truncate());
        });
        let mut enter = None;
        egui::ScrollArea::vertical().id_salt("entries").max_height(260.0).auto_shrink([false, false]).show(ui, |ui| {
            for (name, is_folder) in &choosing.entries {
                let text = if *is_folder { format!("{name}/") } else { name.clone() };
                if ui.selectable_label(!is_folder && *name == choosing.name, text).clicked() {
                    if *is_folder {
                        enter = Some(choosing.folder.join(name));
                    } else {
                        choosing.name.clone_from(name);
                    }
                }
            }
        });
        if let Some(folder) = enter {
            choosing.enter(folder);
        }
        ui.horizontal(|ui| {
            let label = ui.label(w.path);
            let field = egui::TextEdit::singleline(&mut choosing.name).desired_width(f32::INFINITY);
            ui.add(field).labelled_by(label.id);
        });
        if !choosing.ask.is_of_input() && choosing.path().is_file() {
            ui.colored_label(ui.visuals().warn_fg_color, w.is_there_already);
        }
        ui.add_space(6.0);
        ui.horizontal(|ui| {
            if ui.add_enabled(choosing.is_complete(), egui::Button::new(w.ok)).clicked() {
                done = Some(vec![choosing.path()]);
            }
            if ui.button(w.cancel).clicked() {
                done = Some(Vec::new());
            }
        });
    });
    if asked.should_close() {
        done = Some(Vec::new());
    }
    if let (Some(paths), Some(choosing)) = (done.clone(), view.choosing.take_if(|_| done.is_some())) {
        view.chosen.push((choosing.ask, paths));
    }
}
