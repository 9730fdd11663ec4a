//! The window, which draws the views of a session.

use crate::dialogs::{Ask, Dialogs, Reply};
use crate::session::recent::Recent;
use crate::session::replacing::Replacement;
use crate::session::tasks::Kind as Work;
use crate::session::{Session, Waker, guarded, outputs};
use crate::units::Units;
use crate::views::choosing::Choosing;
use crate::views::plots::{self, Which};
use crate::views::{
    Corner, Side, View, bar, choosing, closing, drawing, matrix, records, replacing, results, status, study, tables,
    tests, tune, valve,
};
use crate::words;
use dashpot_output::Kind;
use eframe::egui::{self, CentralPanel, ColorImage, Panel, Rect, Ui};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

/// The window: an open session, the state of the display, and the dialogs.
pub struct App {
    /// The open session.
    pub session: Session,
    /// State of the display.
    pub view: View,
    dialogs: Box<dyn Dialogs>,
    waker: Waker,
    /// Whether a task has requested a frame that is not drawn yet.
    called: Arc<AtomicBool>,
    pictures: (Sender<Picture>, Receiver<Picture>),
    /// Inputs of the plot layout in the last frame.
    drawn: Option<Layout>,
}

/// Inputs of the plot layout: counter of the plotted data, number of selected tests, language, lower right view, and units. A change of
/// one of them triggers a second frame.
type Layout = (u64, usize, words::Language, Corner, Units);

/// A screenshot of the whole window, with the part of it to save and the path of the file.
///
/// `part` is left, top, right and bottom in points, and `scale` the number of pixels per point.
struct Picture {
    path: PathBuf,
    part: [f32; 4],
    scale: f32,
    image: Arc<ColorImage>,
}

/// Smallest font size, points.
const SMALLEST: f32 = 11.0;
/// Interval at which running tasks are polled while nothing else changes.
const LOOK: Duration = Duration::from_millis(60);

impl App {
    /// Makes an empty window in the language of the system, if the texts exist in that language.
    pub fn new(ctx: &egui::Context, dialogs: Box<dyn Dialogs>) -> App {
        App::with_recent(ctx, dialogs, Recent::read(Recent::place()))
    }

    /// Makes an empty window with a given list of recent campaigns.
    pub fn with_recent(ctx: &egui::Context, dialogs: Box<dyn Dialogs>, recent: Recent) -> App {
        let called = Arc::new(AtomicBool::new(false));
        let (own, calls) = (ctx.clone(), called.clone());
        let waker: Waker = Arc::new(move || {
            calls.store(true, Ordering::Release);
            own.request_repaint();
        });
        // The small letters of egui have 9 points and are unreadable on a screen in a rig's control room, so they are enlarged.
        ctx.all_styles_mut(|style| {
            for font in style.text_styles.values_mut() {
                font.size = font.size.max(SMALLEST);
            }
        });
        let view = View { language: words::of_system(), ..View::default() };
        App {
            session: Session::new(recent, waker.clone()),
            view,
            dialogs,
            waker,
            called,
            pictures: channel(),
            drawn: None,
        }
    }

    /// Collects results of tasks, and requests a frame while a task runs or a requested frame is pending.
    ///
    /// If a frame is a quarter of a second late (busy or hidden window), eframe runs only [`eframe::App::logic`] and drops the request. A
    /// single request would then stay without effect until the mouse moves.
    fn stay_awake(&mut self, ctx: &egui::Context) {
        if self.session.poll() || self.called.load(Ordering::Acquire) {
            ctx.request_repaint_after(LOOK);
        }
    }

    /// Returns the inputs of the plot layout. After a change, a second frame places the axes.
    fn layout(&self) -> Layout {
        (self.session.generation, self.session.selected.len(), self.view.language, self.view.corner, self.view.units)
    }

    /// Draws a frame: all views, dialogs and replies of dialogs.
    pub fn show(&mut self, ui: &mut Ui) {
        let layout = self.layout();
        if self.drawn.replace(layout.clone()) != Some(layout) {
            ui.ctx().request_repaint();
        }
        self.take_drops(ui);
        self.called.store(false, Ordering::Release);
        self.stay_awake(ui.ctx());
        // Select the panel of results, because another panel may be selected when a result arrives.
        if let Some(Work::Fit | Work::Validate | Work::Diagnose) = self.session.arrived.take() {
            self.view.side = Side::Result;
            self.view.is_result_new = true;
        }
        if std::mem::take(&mut self.session.is_drawing_new) {
            self.view.side = Side::Drawing;
        }
        bar::keys(ui, &mut self.session, &mut self.view);
        let (session, view) = (&mut self.session, &mut self.view);
        Panel::top("bar").show(ui, |ui| bar::show(ui, session, view));
        let height = status::height(ui, session, view);
        Panel::bottom("status").exact_size(height).show(ui, |ui| status::show(ui, session, view));
        Panel::left("tests")
            .default_size(270.0)
            .size_range(200.0..=460.0)
            .show(ui, |ui| within(ui, |ui| tests::show(ui, session, view)));
        Panel::right("side").default_size(330.0).size_range(270.0..=560.0).show(ui, |ui| side(ui, session, view));
        CentralPanel::default().show(ui, |ui| centre(ui, session, view));
        closing::show(ui, session, view);
        replacing::show(ui, session, view);
        choosing::show(ui, view);
        let from = self.session.folder();
        for ask in std::mem::take(&mut self.view.asks) {
            self.dialogs.ask(ask, from.clone(), self.waker.clone());
        }
        while let Some((ask, reply)) = self.dialogs.poll() {
            match reply {
                Reply::Paths(paths) => self.obey(ui.ctx(), ask, paths),
                Reply::NoDialog => self.view.choosing = Some(Choosing::new(ask, from.clone())),
            }
        }
        for (ask, paths) in std::mem::take(&mut self.view.chosen) {
            self.obey(ui.ctx(), ask, paths);
        }
        while let Ok(picture) = self.pictures.1.try_recv() {
            self.write_picture(&picture);
        }
    }

    fn take_drops(&mut self, ui: &Ui) {
        let dropped: Vec<PathBuf> =
            ui.ctx().input(|i| i.raw.dropped_files.iter().map(|f| f.path().to_path_buf()).collect());
        if !dropped.is_empty() {
            self.session.open(&dropped);
        }
    }

    /// Carries out a request with the chosen paths. Does nothing if the user cancelled.
    fn obey(&mut self, ctx: &egui::Context, ask: Ask, paths: Vec<PathBuf>) {
        let Some(first) = paths.first().cloned() else { return };
        let session = &mut self.session;
        match ask {
            Ask::Folder | Ask::Files => {
                session.open_records(paths, dashpot_records::Options::default());
            }
            Ask::Reference => session.open_reference(paths),
            Ask::Model => session.replace(Replacement::File(first)),
            Ask::Dimensions => {
                session.open_drawing(&first);
            }
            Ask::SaveModel => {
                session.save(&first);
            }
            Ask::Export(host) => session.export(host, first),
            Ask::Paper(paper) => session.write_paper(paper, first, self.view.language.words()),
            Ask::Text(_, text) => {
                let kind = Kind::detect(text.as_bytes());
                self.report_written(&first, guarded::write(&first, kind, text.as_bytes()));
            }
            Ask::Picture(part) => {
                let (send, scale, waker) = (self.pictures.0.clone(), ctx.pixels_per_point(), self.waker.clone());
                ctx.request_screenshot(move |image| {
                    let _ = send.send(Picture { path: first, part, scale, image });
                    waker();
                });
            }
        }
    }

    fn report_written(&mut self, path: &Path, written: anyhow::Result<()>) {
        match written {
            Ok(()) => self.session.say(path.display().to_string()),
            Err(error) => self.session.complain(outputs::error_sentence(&error)),
        }
    }

    fn write_picture(&mut self, picture: &Picture) {
        let written = png(&picture.image, picture.part, picture.scale)
            .and_then(|bytes| guarded::write(&picture.path, Kind::Picture, &bytes));
        self.report_written(&picture.path, written);
    }
}

/// Encodes a part of the window as a PNG file.
fn png(image: &ColorImage, part: [f32; 4], scale: f32) -> anyhow::Result<Vec<u8>> {
    let whole = Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(image.width() as f32, image.height() as f32));
    let [left, top, right, bottom] = part.map(|v| (v * scale).round());
    let part = Rect::from_min_max(egui::pos2(left, top), egui::pos2(right, bottom)).intersect(whole);
    let (x, y) = (part.left() as usize, part.top() as usize);
    let (width, height) = (part.width() as usize, part.height() as usize);
    anyhow::ensure!(width > 0 && height > 0, "the plot was not on the screen");
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let rows = (y..y + height).flat_map(|row| &image.pixels[row * image.width() + x..][..width]);
    let data: Vec<u8> = rows.flat_map(|c| [c.r(), c.g(), c.b()]).collect();
    encoder.write_header()?.write_image_data(&data)?;
    Ok(bytes)
}

/// Draws in the remaining space of a panel, and clips wider contents. Without the clip, the panel would grow, move its tabs away from the
/// pointer, and shrink the plots.
fn within(ui: &mut Ui, draw: impl FnOnce(&mut Ui)) {
    let rest = ui.available_rect_before_wrap();
    let mut inside = ui.new_child(egui::UiBuilder::new().max_rect(rest));
    inside.shrink_clip_rect(rest);
    draw(&mut inside);
    ui.advance_cursor_after_rect(rest);
}

fn side(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let w = view.words();
    let always = [(Side::Tune, w.tune), (Side::Result, w.result), (Side::Records, w.records), (Side::Study, w.study)];
    // Optional tabs come last, so that the other tabs keep their positions.
    let valve = session.has_valve().then_some((Side::Valve, w.valve));
    let drawing = session.drawing.is_some().then_some((Side::Drawing, w.drawing));
    let sides: Vec<_> = always.into_iter().chain(valve).chain(drawing).collect();
    if !sides.iter().any(|(side, _)| *side == view.side) {
        view.side = Side::Tune;
    }
    ui.horizontal_wrapped(|ui| {
        for (side, text) in sides {
            ui.selectable_value(&mut view.side, side, text);
        }
    });
    ui.separator();
    within(ui, |ui| match view.side {
        Side::Tune => tune::show(ui, session, view),
        Side::Result => results::show(ui, session, view),
        Side::Records => records::show(ui, session, view),
        Side::Study => study::show(ui, session, view),
        Side::Valve => valve::show(ui, session, view),
        Side::Drawing => drawing::show(ui, session, view),
    });
}

fn centre(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let w = view.words();
    if !session.has_records() {
        ui.centered_and_justified(|ui| ui.label(egui::RichText::new(w.drop_here).size(20.0).weak()));
        return;
    }
    let gap = ui.spacing().item_spacing;
    let half = egui::vec2((ui.available_width() - gap.x) / 2.0, (ui.available_height() - gap.y) / 2.0);
    let place = |ui: &mut Ui, add: &mut dyn FnMut(&mut Ui)| {
        ui.allocate_ui_with_layout(half, egui::Layout::top_down(egui::Align::Min), |ui| {
            ui.set_min_size(half);
            ui.set_max_size(half);
            add(ui);
        });
    };
    ui.horizontal(|ui| {
        place(ui, &mut |ui| plots::loops(ui, session, view, Which::Velocity));
        place(ui, &mut |ui| plots::loops(ui, session, view, Which::Displacement));
    });
    ui.horizontal(|ui| {
        place(ui, &mut |ui| plots::peaks(ui, session, view));
        place(ui, &mut |ui| corner(ui, session, view));
    });
}

fn corner(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let w = view.words();
    let warm = session.campaign.as_ref().is_some_and(|c| c.campaign.records.iter().any(|r| r.temperature.is_some()));
    ui.horizontal_wrapped(|ui| {
        ui.selectable_value(&mut view.corner, Corner::Matrix, w.error_matrix);
        ui.selectable_value(&mut view.corner, Corner::Time, w.force_time);
        ui.selectable_value(&mut view.corner, Corner::GasAndDrag, w.gas_and_drag);
        ui.selectable_value(&mut view.corner, Corner::Tables, w.tables).on_hover_text(w.tables_hint);
        if warm {
            ui.selectable_value(&mut view.corner, Corner::Temperature, w.temperature);
        }
        if session.study.is_some() {
            ui.selectable_value(&mut view.corner, Corner::Study, w.study);
        }
    });
    match view.corner {
        Corner::Time => plots::loops(ui, session, view, Which::Time),
        Corner::GasAndDrag => plots::gas_and_drag(ui, session, view),
        Corner::Temperature if warm => plots::loops(ui, session, view, Which::Temperature),
        Corner::Tables => tables::show(ui, session, view),
        Corner::Study => study::plot(ui, session, view.units, w),
        _ => matrix::show(ui, session, view),
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        self.stay_awake(ctx);
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.show(ui);
    }
}

#[cfg(test)]
mod waking {
    use super::*;
    use crate::dialogs::Message;

    /// A frame shows the result of a task, even if eframe runs the logic several times without a frame. After that frame, the window
    /// requests no more frames.
    #[test]
    fn a_call_is_not_forgotten_before_it_is_drawn() {
        let ctx = egui::Context::default();
        let mut app = App::with_recent(&ctx, Box::new(Message::default()), Recent::read(None));
        let input = egui::RawInput::default;
        let draws = |app: &mut App, rounds: usize| {
            for _ in 0..rounds {
                let _ = ctx.run_ui(input(), |ui| app.show(ui));
            }
            ctx.has_requested_repaint()
        };
        assert!(!draws(&mut app, 10), "nothing moves, and the window is drawn");
        (app.waker)();
        for _ in 0..5 {
            let _ = ctx.run_logic(&input(), |ctx| app.stay_awake(ctx));
            assert!(ctx.has_requested_repaint(), "what work brought is forgotten");
        }
        assert!(!draws(&mut app, 10), "nothing moves any more, and the window is drawn");
    }
}

#[cfg(test)]
mod pictures {
    use super::*;
    use eframe::egui::Color32;

    /// The screenshot of a plot contains the plot's part of the window, clipped at the edge of the window. The test screen has two pixels
    /// per point.
    #[test]
    fn the_picture_of_a_plot_holds_its_pixels() {
        let colour = |x: usize, y: usize| Color32::from_rgb(10 * x as u8, 20 * y as u8, 7);
        let pixels = (0..6).flat_map(|y| (0..8).map(move |x| colour(x, y))).collect();
        let image = ColorImage::new([8, 6], pixels);
        for (part, from, size) in [([1.0, 1.0, 3.0, 2.0], (2, 2), (4, 2)), ([3.0, 2.0, 9.0, 9.0], (6, 4), (2, 2))] {
            let bytes = png(&image, part, 2.0).unwrap();
            let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
            let mut data = vec![0; reader.output_buffer_size().unwrap()];
            let info = reader.next_frame(&mut data).unwrap();
            assert_eq!((info.width, info.height), size);
            for (k, rgb) in data.chunks(3).enumerate() {
                let (column, row) = (k % size.0 as usize, k / size.0 as usize);
                assert_eq!(rgb, &colour(from.0 + column, from.1 + row).to_array()[..3]);
            }
        }
        assert!(png(&image, [20.0, 20.0, 30.0, 30.0], 2.0).is_err(), "a plot that is not on the screen");
    }
}
