//! The plots: loops over velocity and displacement, force over time, and peak forces with the draggable FV curve.

use crate::dialogs::Ask;
use crate::session::campaign::Loaded;
use crate::session::outputs::table;
use crate::session::{Session, model};
use crate::units::Shown;
use crate::views::grid;
use crate::views::legend::{self, Entry, FONT_SIZE, Mark};
use crate::views::lines::{Line as Drawn, Whose, identified_name, named};
use crate::views::{View, hue};
use crate::words::Words;
use dashpot_core::{Model, Params, element, list, number};
use dashpot_records::restrict;
use dashpot_report::plot::axes::{Axis, Marks, Plane, Series};
use dashpot_report::plot::palette::Role;
use dashpot_simulation::prediction::{at_velocities, between_velocities};
use eframe::egui::{self, Color32, Id, Key, Pos2, Rect, Ui, Vec2, WidgetInfo};
use egui_plot::{HoverPosition, Line, LineStyle, Plot, PlotPoint, PlotPoints, PlotUi, Points};

/// Largest distance between the pointer and a point of the curve at which a click grabs the point, px. It corresponds to the width of a
/// fingertip on a touch pad.
const GRAB: f32 = 12.0;

/// Two axes with their names and units.
#[derive(Clone)]
struct Axes {
    x: (&'static str, Shown),
    y: (&'static str, Shown),
}

impl Axes {
    fn label((name, unit): &(&str, Shown)) -> String {
        format!("{name} [{}]", unit.symbol)
    }
}

/// Returns a unit that does not depend on the selected units.
fn plain(symbol: &str) -> Shown {
    Shown { factor: 1.0, symbol: symbol.to_owned() }
}

/// Makes a plot with cursor read-out, zoom and pan. `linked` links it to the other plots with force on the vertical axis.
fn plot<'a>(id: &'static str, axes: &Axes, linked: bool, w: &'static Words) -> Plot<'a> {
    let (lower, left) = (Axes::label(&axes.x), Axes::label(&axes.y));
    let axes = axes.clone();
    let read_out = move |at: &HoverPosition<'_>| {
        let say = |p: &PlotPoint| {
            let ((x, ux), (y, uy)) = (&axes.x, &axes.y);
            format!("{x} {} {}\n{y} {} {}", w.digits(p.x), ux.symbol, w.digits(p.y), uy.symbol)
        };
        Some(match at {
            HoverPosition::NearDataPoint { plot_name, position, .. } => format!("{plot_name}\n{}", say(position)),
            HoverPosition::Elsewhere { position } => say(position),
        })
    };
    let plot =
        grid::with_axes(Plot::new(id), lower, left, w).label_formatter(read_out).set_margin_fraction(Vec2::splat(0.04));
    if linked {
        plot.link_axis(Id::unique("forces"), [false, true]).link_cursor(Id::unique("forces"), [false, true])
    } else {
        plot
    }
}

/// Draws the title of a plot, and the menu for saving the plot.
fn heading(
    ui: &mut Ui,
    view: &mut View,
    title: &str,
    axes: &Axes,
    lines: impl Fn() -> Vec<(Role, String, Vec<[f64; 2]>)>,
) {
    let words = view.words();
    ui.horizontal(|ui| {
        ui.strong(title);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let menu = ui.menu_button("…", |ui| {
                if ui.button("CSV").clicked() {
                    let named: Vec<_> = lines().into_iter().map(|(_, name, points)| (name, points)).collect();
                    let text = table([&Axes::label(&axes.x), &Axes::label(&axes.y)], &named);
                    view.asks.push(Ask::Text("plot.csv", text));
                    ui.close();
                }
                if ui.button("SVG").clicked() {
                    view.asks.push(Ask::Text("plot.svg", svg(title, axes, lines(), words)));
                    ui.close();
                }
                if ui.button("PNG").clicked() {
                    // [`remember_place`] stored the rectangle of the plot when the plot was drawn in the last frame.
                    let rect = ui.ctx().memory(|m| m.data.get_temp::<Rect>(Id::unique(("plot", title.to_owned()))));
                    let rect = rect.unwrap_or(Rect::EVERYTHING);
                    view.asks.push(Ask::Picture([rect.min.x, rect.min.y, rect.max.x, rect.max.y]));
                    ui.close();
                }
            });
            menu.response
                .widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, format!("{} {title}", words.save_plot)));
            menu.response.on_hover_text(words.save_plot);
        });
    });
}

/// Formats a plot as an SVG figure in the style of the report.
fn svg(title: &str, axes: &Axes, lines: Vec<(Role, String, Vec<[f64; 2]>)>, w: &Words) -> String {
    let all = || lines.iter().flat_map(|(_, _, points)| points.iter().copied());
    let (x, y) = (all().map(|p| p[0]).collect::<Vec<_>>(), all().map(|p| p[1]).collect::<Vec<_>>());
    let role_name = |role: Role| match role {
        Role::Measured => w.measured,
        Role::Model => w.model,
        Role::FvOnly => w.with_effect,
        _ => w.reference,
    };
    let mut series: Vec<Series> = Vec::new();
    for (role, _, points) in lines {
        match series.iter_mut().find(|s| s.role == role) {
            Some(known) => known.lines.push(points),
            None => series.push(Series { role, label: role_name(role), lines: vec![points], marks: Marks::Line }),
        }
    }
    Plane {
        title: title.to_owned(),
        x: Axis::around(Axes::label(&axes.x), x),
        y: Axis::around(Axes::label(&axes.y), y),
        series,
    }
    .draw_long(w.of.words())
}

fn role(whose: Whose) -> Role {
    match whose {
        Whose::Measured => Role::Measured,
        Whose::Model => Role::Model,
        Whose::Effect => Role::FvOnly,
        Whose::Reference | Whose::Identified => Role::Before,
    }
}

/// Returns color and width of a line. Each measured test has a hue, a model has a text color, and a model with an additional effect is red.
fn look(ui: &Ui, line: &Drawn) -> (Color32, f32) {
    let ink = ui.visuals().strong_text_color();
    match line.whose {
        Whose::Measured => (hue(line.place), 2.2),
        Whose::Reference => (hue(line.place).gamma_multiply(0.55), 1.4),
        Whose::Identified => (ui.visuals().weak_text_color(), 1.0),
        Whose::Model => (ink, 1.2),
        Whose::Effect => (Color32::from_rgb(220, 50, 47), 1.6),
    }
}

/// Largest number of entries in the legend of loops, because a name of a test may fill half a line.
const ENTRIES: usize = 6;
/// Largest number of entries in the legend of peak forces, whose curves have the short names of settings.
const CURVES: usize = 12;

/// Returns the legend of the loop plots: every kind of drawn model once, and every measured test in its hue.
///
/// `dashes_reference` says whether the lines of the reference are dashed. Otherwise dashes have another meaning, and the reference has the
/// dimmed hues of its tests.
fn entries(
    ui: &Ui,
    session: &Session,
    lines: &[Drawn],
    is_drawn: impl Fn(&Drawn) -> bool,
    dashes_reference: bool,
    words: &Words,
) -> Vec<Entry> {
    let mut kinds: Vec<Entry> = Vec::new();
    for whose in [Whose::Model, Whose::Identified, Whose::Effect, Whose::Reference] {
        if let Some(line) = lines.iter().find(|l| l.whose == whose && is_drawn(l)) {
            let colour = match whose {
                Whose::Reference if dashes_reference => ui.visuals().text_color(),
                _ => look(ui, line).0,
            };
            let is_dashed = whose == Whose::Reference && dashes_reference;
            let mark = if is_dashed { Mark::Dashes } else { Mark::Line };
            kinds.push(Entry::new(colour, mark, named(whose, session, words)));
        }
    }
    let tests = session.selected.iter().enumerate();
    kinds.extend(tests.filter_map(|(place, k)| Some(Entry::new(hue(place), Mark::Line, &session.record(*k)?.name))));
    kinds
}

fn draw<'a>(plot: &mut PlotUi<'a>, line: &'a Drawn, points: &'a [PlotPoint], (colour, width): (Color32, f32)) {
    let drawn = Line::new(line.name.clone(), PlotPoints::Borrowed(points)).color(colour).width(width);
    plot.line(if line.whose == Whose::Reference { drawn.style(LineStyle::dashed_dense()) } else { drawn });
}

/// Kind of loop plot.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Which {
    /// Force over velocity.
    Velocity,
    /// Force over displacement.
    Displacement,
    /// Force over time.
    Time,
    /// Temperature over time.
    Temperature,
}

fn remember_place(ui: &Ui, title: &str, top: Pos2, bottom: Rect) {
    let rect = Rect::from_two_pos(top, bottom.max);
    ui.ctx().memory_mut(|m| m.data.insert_temp(Id::unique(("plot", title.to_owned())), rect));
}

/// Draws one of the loop plots.
pub fn loops(ui: &mut Ui, session: &Session, view: &mut View, which: Which) {
    let words = view.words();
    let units = view.units;
    let lines = view.lines.lines(session, view.effect, units, words);
    let force = (words.force, units.force());
    let time = (words.time, plain("s"));
    let (id, title, axes) = match which {
        Which::Velocity => ("fv", words.force_velocity, Axes { x: (words.velocity, units.velocity()), y: force }),
        Which::Displacement => {
            ("fx", words.force_displacement, Axes { x: (words.displacement, units.length()), y: force })
        }
        Which::Time => ("ft", words.force_time, Axes { x: time, y: force }),
        Which::Temperature => ("tt", words.temperature, Axes { x: time, y: (words.temperature, plain("°C")) }),
    };
    let of = |line: &Drawn| -> Vec<PlotPoint> { points_of(line, which).to_vec() };
    let top = ui.cursor().min;
    heading(ui, view, title, &axes, || {
        let plain = |line: &Drawn| of(line).iter().map(|p| [p.x, p.y]).collect();
        lines.iter().map(|l| (role(l.whose), l.name.clone(), plain(l))).collect()
    });
    let entries = entries(ui, session, &lines, |line| !points_of(line, which).is_empty(), true, words);
    legend::show(ui, &entries, ENTRIES);
    let looks: Vec<_> = lines.iter().map(|l| look(ui, l)).collect();
    let response = plot(id, &axes, which != Which::Temperature, words).show(ui, |plot| {
        for (line, look) in lines.iter().zip(&looks) {
            draw(plot, line, points_of(line, which), *look);
        }
    });
    remember_place(ui, title, top, response.response.rect);
    let shown = summary(session, words);
    response.response.widget_info(|| WidgetInfo::labeled(egui::Role::Figure, true, format!("{title}: {shown}")));
}

/// Draws the mean force of both directions of a cycle over displacement, and half of their difference. In a slow test, the mean shows gas
/// and springs, the difference drag and friction.
pub fn gas_and_drag(ui: &mut Ui, session: &Session, view: &mut View) {
    let words = view.words();
    let units = view.units;
    let lines = view.lines.lines(session, view.effect, units, words);
    let axes = Axes { x: (words.displacement, units.length()), y: (words.force, units.force()) };
    let both = |l: &Drawn| [(words.both_ways, l.gas.clone()), (words.drag, l.drag.clone())];
    let top = ui.cursor().min;
    heading(ui, view, words.gas_and_drag, &axes, || {
        let plain = |points: Vec<PlotPoint>| points.iter().map(|p| [p.x, p.y]).collect();
        let of =
            |l: &Drawn| both(l).map(|(what, points)| (role(l.whose), format!("{}: {what}", l.name), plain(points)));
        lines.iter().flat_map(of).collect()
    });
    let weak = ui.visuals().text_color();
    let mut entries = entries(ui, session, &lines, |line| !line.gas.is_empty(), false, words);
    let both = [Entry::new(weak, Mark::Line, words.both_ways), Entry::new(weak, Mark::Dashes, words.drag)];
    entries.splice(0..0, both);
    legend::show(ui, &entries, ENTRIES);
    let looks: Vec<_> = lines.iter().map(|l| look(ui, l)).collect();
    let response = plot("gas", &axes, false, words).show(ui, |plot| {
        for (line, (colour, width)) in lines.iter().zip(looks) {
            let [gas, drag] = [(words.both_ways, &line.gas), (words.drag, &line.drag)]
                .map(|(what, points)| Line::new(format!("{}: {what}", line.name), PlotPoints::Borrowed(points)));
            plot.line(gas.color(colour).width(width));
            plot.line(drag.color(colour).width(width).style(LineStyle::dashed_loose()));
        }
    });
    remember_place(ui, words.gas_and_drag, top, response.response.rect);
    let shown = summary(session, words);
    let label = format!("{}: {shown}", words.gas_and_drag);
    response.response.widget_info(|| WidgetInfo::labeled(egui::Role::Figure, true, label.clone()));
}

fn points_of(line: &Drawn, which: Which) -> &[PlotPoint] {
    match which {
        Which::Velocity => &line.velocity,
        Which::Displacement => &line.displacement,
        Which::Time => &line.time,
        Which::Temperature => &line.temperature,
    }
}

/// Describes the contents of a plot for a screen reader: the plotted tests, and the model.
fn summary(session: &Session, words: &Words) -> String {
    let names: Vec<&str> =
        session.selected.iter().filter_map(|k| session.record(*k)).map(|r| r.name.as_str()).collect();
    let model = if session.model.is_some() { words.model } else { "" };
    format!("{} {model}", names.join(", "))
}

/// Curve of the damper at a test's own setting.
struct OwnCurve {
    /// The setting with its unit.
    setting: String,
    colour: Color32,
    /// Velocities and forces in the selected units.
    points: Vec<[f64; 2]>,
}

impl OwnCurve {
    fn name(&self, words: &Words) -> String {
        format!("{} ({})", words.steady_force, self.setting)
    }
}

/// Returns the color of a setting, from blue at 0 to vermilion at 1. Color-blind readers can distinguish these two colors, which come from
/// the palette of Okabe & Ito.
fn blend(part: f32) -> Color32 {
    Color32::from_rgb(86, 180, 233).lerp_to_gamma(Color32::from_rgb(213, 94, 0), part)
}

/// Curves and points of the plot of peak forces, in the units of the user.
struct Peaks {
    /// Curve of the model.
    now: Option<Vec<[f64; 2]>>,
    /// Curve of the identified model, if the user changed the model.
    identified: Option<Vec<[f64; 2]>>,
    /// Name of the identified model's curve.
    before: &'static str,
    /// Curve of each setting, if tests have their own settings.
    own: Vec<OwnCurve>,
    /// Peaks of all tests.
    measured: Vec<[f64; 2]>,
    /// Peaks of the selected tests, with the place of the test in the selection.
    selected: Vec<(usize, [f64; 2])>,
    /// Draggable points of the FV curve.
    handles: Vec<[f64; 2]>,
}

impl Peaks {
    fn new(session: &Session, words: &'static Words, loaded: &Loaded, shown: impl Fn([f64; 2]) -> [f64; 2]) -> Peaks {
        let curve = |params: &Params| -> Vec<[f64; 2]> {
            steady(params, reach(loaded, params)).into_iter().map(&shown).collect()
        };
        let model = session.model.as_ref();
        let unit = model.and_then(|model| Some(model.over_setting()?.0.unit())).unwrap_or_default();
        let own = session.dampers().map_or_else(Vec::new, |dampers| dampers.settings(&loaded.campaign.records));
        let count = own.len();
        let own = own.iter().enumerate().map(|(k, (setting, params))| OwnCurve {
            setting: format!("{} {unit}", words.typed(*setting)).trim_end().to_owned(),
            colour: blend(k as f32 / (count.max(2) - 1) as f32),
            points: curve(params),
        });
        let is_there = |p: &[f64; 2]| p[0].is_finite() && p[1].is_finite();
        let selected = session.selected.iter().enumerate();
        let selected =
            selected.filter_map(|(place, k)| Some(loaded.tests.get(*k)?.peaks.map(|p| (place, p)))).flatten();
        Peaks {
            now: model.map(|m| curve(m.params())),
            identified: model.filter(|m| m.is_tuned()).map(|m| curve(&m.identified)),
            before: identified_name(session, words),
            own: own.collect(),
            measured: loaded.tests.iter().flat_map(|t| t.peaks).filter(is_there).map(&shown).collect(),
            selected: selected.filter(|(_, p)| is_there(p)).map(|(place, p)| (place, shown(p))).collect(),
            handles: model
                .map_or_else(Vec::new, |m| handles(m.params()))
                .into_iter()
                .map(|(x, y)| shown([x, y]))
                .collect(),
        }
    }

    /// Returns points and curves with their names, for export.
    fn lines(&self, words: &Words) -> Vec<(Role, String, Vec<[f64; 2]>)> {
        let mut lines = vec![(Role::Measured, words.measured.to_owned(), self.measured.clone())];
        let curves = [(&self.now, Role::Model, words.steady_force), (&self.identified, Role::Before, self.before)];
        for (curve, role, name) in curves {
            lines.extend(curve.as_ref().map(|c| (role, name.to_owned(), c.clone())));
        }
        lines.extend(self.own.iter().map(|of| (Role::Model, of.name(words), of.points.clone())));
        lines
    }

    /// Returns the entries of the legend.
    fn entries(&self, words: &'static Words, ink: Color32, weak: Color32) -> Vec<Entry> {
        let mut entries = vec![Entry::new(weak, Mark::Dot, words.measured)];
        if self.now.is_some() {
            entries.push(Entry::new(ink, Mark::Line, words.steady_force));
        }
        if self.identified.is_some() {
            entries.push(Entry::new(weak, Mark::Line, self.before));
        }
        if !self.handles.is_empty() {
            entries.push(Entry::new(ink, Mark::Ring, words.fv_points));
        }
        entries.extend(self.own.iter().map(|of| Entry::new(of.colour, Mark::Line, &of.setting)));
        entries
    }

    fn draw(&self, plot: &mut PlotUi<'_>, words: &'static Words, ink: Color32, weak: Color32) {
        let grey = Points::new(words.measured, PlotPoints::from(self.measured.clone())).radius(2.5).color(weak);
        plot.points(grey);
        for (place, peak) in &self.selected {
            plot.points(Points::new(words.measured, PlotPoints::from(vec![*peak])).radius(4.0).color(hue(*place)));
        }
        for of in &self.own {
            let line = Line::new(of.name(words), PlotPoints::from(of.points.clone()));
            plot.line(line.color(of.colour).width(1.2));
        }
        if let Some(curve) = &self.identified {
            plot.line(Line::new(self.before, PlotPoints::from(curve.clone())).color(weak).width(1.0));
        }
        if let Some(curve) = &self.now {
            plot.line(Line::new(words.steady_force, PlotPoints::from(curve.clone())).color(ink).width(1.5));
        }
        if !self.handles.is_empty() {
            let points = Points::new(words.fv_points, PlotPoints::from(self.handles.clone()));
            plot.points(points.radius(4.5).filled(false).color(ink));
        }
    }

    /// Returns the index of the draggable point that a click would grab. `None` if the pointer is too far from all of them.
    fn point_under_pointer(&self, plot: &PlotUi<'_>) -> Option<usize> {
        let at = plot.response().hover_pos()?;
        let distance = |k: usize| {
            let [x, y] = self.handles[k];
            plot.screen_from_plot(PlotPoint::new(x, y)).distance(at)
        };
        let nearest = (0..self.handles.len()).min_by(|a, b| distance(*a).total_cmp(&distance(*b)));
        nearest.filter(|k| distance(*k) <= GRAB)
    }
}

/// Draws peak force over peak velocity for tests and model, and the draggable points of the curve. The model is at constant velocity, as in
/// the report.
pub fn peaks(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let words = view.words();
    let units = view.units;
    let [v, f] = [units.velocity().factor, units.force().factor];
    let axes = Axes { x: (words.velocity, units.velocity()), y: (words.force, units.force()) };
    let Some(loaded) = session.campaign.clone() else { return };
    let peaks = Peaks::new(session, words, &loaded, move |[x, y]| [v * x, f * y]);
    let top = ui.cursor().min;
    heading(ui, view, words.peaks, &axes, || peaks.lines(words));
    let ink = ui.visuals().strong_text_color();
    let weak = ui.visuals().weak_text_color();
    legend::show(ui, &peaks.entries(words, ink, weak), CURVES);
    let is_free = view.grabbed.is_none();
    let figure = plot("peaks", &axes, false, words).allow_drag(is_free).allow_boxed_zoom(is_free);
    let response = figure.show(ui, |plot| {
        peaks.draw(plot, words, ink, weak);
        (peaks.point_under_pointer(plot), plot.pointer_coordinate())
    });
    let (near, pointer) = response.inner;
    let mouse = response.response;
    remember_place(ui, words.peaks, top, mouse.rect);
    let stopped = view.stopped.map_or("", |why| why.text(words));
    let label = format!("{}: {} {stopped}", words.peaks, summary(session, words));
    mouse.widget_info(|| WidgetInfo::labeled(egui::Role::Figure, true, label.clone()));
    drag_point(ui, session, view, &mouse, near, pointer.map(|at| [at.x / v, at.y / f]));
}

/// Grabs the point `near` the pointer when the user presses the button, moves it to `pointer`, m/s and N, and releases it.
fn drag_point(
    ui: &Ui,
    session: &mut Session,
    view: &mut View,
    mouse: &egui::Response,
    near: Option<usize>,
    pointer: Option<[f64; 2]>,
) {
    // A press near a point grabs the point before the plot starts to pan.
    let (pressed, down) = ui.input(|i| (i.pointer.primary_pressed(), i.pointer.primary_down()));
    if pressed && mouse.contains_pointer() {
        view.grabbed = near;
        view.stopped = None;
    }
    if near.is_some() || view.grabbed.is_some() {
        ui.ctx().set_cursor_icon(egui::CursorIcon::Grab);
    }
    if let (Some(point), Some(to), true) = (view.grabbed, pointer, down) {
        let with_velocity = ui.input(|i| i.modifiers.shift);
        session.tune(|m| {
            let (changed, stopped) = drag(m, point, to, with_velocity);
            view.stopped = stopped;
            changed
        });
    }
    if let Some(why) = view.stopped {
        remark(ui, mouse.rect, why.text(view.words()));
    }
    if view.grabbed.is_some() && !down {
        view.grabbed = None;
        view.stopped = None;
        if let Some(model) = &mut session.model {
            model.seal();
        }
    }
    if mouse.has_focus() && ui.input(|i| i.key_pressed(Key::Escape)) {
        view.grabbed = None;
    }
}

/// Draws a remark in the corner of a plot: why a dragged point stopped.
fn remark(ui: &Ui, plot: Rect, text: &str) {
    let at = plot.left_top() + Vec2::new(66.0, 6.0);
    let font = egui::FontId::proportional(FONT_SIZE + 1.0);
    let color = ui.visuals().error_fg_color;
    let galley = ui.painter().layout(text.to_owned(), font, color, (plot.width() - 80.0).max(60.0));
    let back = Rect::from_min_size(at, galley.size()).expand(3.0);
    ui.painter().rect_filled(back, 3.0, ui.visuals().extreme_bg_color.gamma_multiply(0.9));
    ui.painter().galley(at, galley, color);
}

/// Returns the velocity range, m/s, that contains the peaks of the tests and the draggable points, with a margin.
fn reach(loaded: &Loaded, params: &Params) -> [f64; 2] {
    let peaks = loaded.tests.iter().flat_map(|t| t.peaks).map(|p| p[0]).filter(|v| v.is_finite());
    let points = handles(params).into_iter().map(|h| h.0);
    let ends = peaks.chain(points).fold([-0.1f64, 0.1f64], |[low, high], v| [low.min(v), high.max(v)]);
    ends.map(|v| 1.02 * v)
}

/// Returns velocities, m/s, and the force at each constant velocity, N. The force includes friction and gas, as in the report.
fn steady(params: &Params, [low, high]: [f64; 2]) -> Vec<[f64; 2]> {
    Model::new(params).map_or_else(|_| Vec::new(), |model| between_velocities(&model, low, high))
}

/// Returns the points of the FV table on the line of [`steady`], or no points if the FV curve has another form.
fn handles(params: &Params) -> Vec<(f64, f64)> {
    if !params.is_on(element!("fv_curve")) || params.number(number!("fv_form")) != 0.0 {
        return Vec::new();
    }
    let Ok(model) = Model::new(params) else { return Vec::new() };
    // All points must have a force, because their indices must be those of the table.
    let at = at_velocities(&model, params.list(list!("fv_velocity")));
    if at.len() == params.list(list!("fv_velocity")).len() {
        at.iter().map(|p| (p[0], p[1])).collect()
    } else {
        Vec::new()
    }
}

/// Reason why a dragged point does not follow the pointer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stop {
    /// The force at zero velocity is fixed to zero.
    AtRest,
    /// The force would pass the force of the neighboring point.
    Force,
    /// The velocity would pass the velocity of the neighboring point.
    Velocity,
    /// The parameter has reached its bound.
    Bound,
}

impl Stop {
    /// Returns the text that explains to the user why the point stopped.
    pub fn text(self, words: &Words) -> &'static str {
        match self {
            Stop::AtRest => words.stop_at_rest,
            Stop::Force => words.stop_force,
            Stop::Velocity => words.stop_velocity,
            Stop::Bound => words.stop_bound,
        }
    }
}

/// Moves a point of the curve to a velocity, m/s, and a force of the damper, N.
///
/// The velocity changes only if `with_velocity` is set. The point stops at its neighbors. Returns whether the point moved, and the reason
/// for a stop.
pub fn drag(model: &mut model::Tuned, point: usize, to: [f64; 2], with_velocity: bool) -> (bool, Option<Stop>) {
    let (velocity, force) = (list!("fv_velocity"), list!("fv_force"));
    let (velocities, forces) = (model.params().list(velocity).to_vec(), model.params().list(force).to_vec());
    let (Some(v), Some(now)) = (velocities.get(point), forces.get(point)) else { return (false, None) };
    if *v == 0.0 {
        return (false, Some(Stop::AtRest));
    }
    let between = |values: &[f64], wanted: f64, apart: f64| {
        let low = point.checked_sub(1).map_or(f64::NEG_INFINITY, |k| values[k] + apart);
        let high = values.get(point + 1).map_or(f64::INFINITY, |next| next - apart);
        if low <= high { restrict(wanted, low, high) } else { values[point] }
    };
    // The drawn line also contains friction and gas. So the force of the table changes by the distance between the drawn point and the
    // pointer.
    let shown = handles(model.params()).get(point).map_or(*now, |h| h.1);
    let wanted = now + to[1] - shown;
    let allowed = between(&forces, wanted, 0.0);
    let mut stopped = (allowed != wanted).then_some(Stop::Force);
    let changed = model.set(force.row(), point, allowed);
    let p = force.row().parameter;
    if restrict(allowed, p.low, p.high) != allowed {
        stopped = Some(Stop::Bound);
    }
    let mut moved = false;
    if with_velocity {
        // The distance to the neighbors is at least 1 mm/s, because closer points would make a step in the curve.
        let allowed = between(&velocities, to[0], 1e-3);
        if allowed != to[0] {
            stopped = stopped.or(Some(Stop::Velocity));
        }
        moved = model.set(velocity.row(), point, allowed);
    }
    (changed || moved, stopped)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Units;
    use crate::words::{Language, texts};

    #[test]
    fn a_saved_plot_is_in_the_language_of_the_window() {
        let w = texts(Language::German);
        let axes = Axes { x: (w.velocity, Units::default().velocity()), y: (w.force, Units::default().force()) };
        let lines = vec![(Role::Measured, "a".to_owned(), vec![[-0.5, -300.0], [0.0, 10.0], [0.5, 900.0]])];
        let text = svg(w.force_velocity, &axes, lines, w);
        assert!(text.contains(w.measured) && text.contains("0,2") && !text.contains(">measured<"), "{text}");
    }

    #[test]
    fn the_curve_of_the_window_is_that_of_the_report() {
        let mut params = Params::new();
        params.enable(element!("coulomb_friction"), true);
        let model = Model::new(&params).unwrap();
        let drawn = steady(&params, [-0.8, 0.9]);
        assert_eq!(drawn, between_velocities(&model, -0.8, 0.9));
        // The line includes friction and gas, so the force at a low velocity differs from the force of the valves.
        let low = drawn.iter().find(|p| p[0] > 0.01).unwrap();
        let valves = model.elements().paths.fv_curve.evaluate(low[0]).value;
        assert!((low[1] - valves).abs() > 1.0, "{low:?} {valves}");
        // The draggable points lie on the line.
        for (v, force) in handles(&params) {
            assert_eq!(at_velocities(&model, &[v])[0][1], force);
        }
    }
}
