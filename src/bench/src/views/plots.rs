//! The plots: loops over velocity and displacement, force over time, and the peak forces with the FV curve, whose points are dragged.

use crate::dialogs::Ask;
use crate::session::outputs::table;
use crate::session::{Session, model};
use crate::views::grid;
use crate::views::lines::{Line as Drawn, Whose, named};
use crate::views::{View, hue};
use crate::words::Words;
use dashpot_core::{element, list, number};
use dashpot_records::restrict;
use dashpot_report::plot::axes::{Axis, Marks, Plane, Series};
use dashpot_report::plot::palette::Role;
use eframe::egui::{self, Color32, Id, Key, Pos2, Rect, Ui, Vec2, WidgetInfo};
use egui_plot::{HoverPosition, Line, LineStyle, Plot, PlotPoint, PlotPoints, PlotUi, Points};

/// Distance from a point of the curve at which it is grabbed, px: a fingertip on a touch pad.
const GRAB: f32 = 12.0;
/// Points of a drawn curve; straight beyond what a screen resolves.
const CURVE: usize = 161;

/// Two axes with their names and units.
#[derive(Clone, Copy)]
struct Axes {
    x: (&'static str, &'static str),
    y: (&'static str, &'static str),
}

impl Axes {
    fn label(of: (&str, &str)) -> String {
        format!("{} [{}]", of.0, of.1)
    }
}

/// A plot with cursor read-out, zoom and pan, and links to the others that have force upwards.
fn plot<'a>(id: &'static str, axes: Axes, linked: bool, w: &'static Words) -> Plot<'a> {
    let read_out = move |at: &HoverPosition<'_>| {
        let say = |p: &PlotPoint| {
            let ((x, ux), (y, uy)) = (axes.x, axes.y);
            format!("{x} {} {ux}\n{y} {} {uy}", w.digits(p.x), w.digits(p.y))
        };
        Some(match at {
            HoverPosition::NearDataPoint { plot_name, position, .. } => format!("{plot_name}\n{}", say(position)),
            HoverPosition::Elsewhere { position } => say(position),
        })
    };
    let plot = Plot::new(id)
        .custom_x_axes(vec![grid::lower(Axes::label(axes.x), w)])
        .y_axis_label(Axes::label(axes.y))
        .label_formatter(read_out)
        .x_grid_spacer(|input| grid::marks(input, grid::ACROSS))
        .y_grid_spacer(|input| grid::marks(input, grid::UPWARDS))
        .set_margin_fraction(Vec2::splat(0.04))
        .y_axis_formatter(|mark, _| grid::number(mark, w))
        .y_axis_min_width(54.0);
    if linked {
        plot.link_axis(Id::unique("forces"), [false, true]).link_cursor(Id::unique("forces"), [false, true])
    } else {
        plot
    }
}

/// Title of a plot, what it is for a screen reader, and what it can be saved as.
fn heading(
    ui: &mut Ui,
    view: &mut View,
    title: &str,
    axes: Axes,
    lines: impl Fn() -> Vec<(Role, String, Vec<[f64; 2]>)>,
) {
    let words = view.words();
    ui.horizontal(|ui| {
        ui.strong(title);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let menu = ui.menu_button("…", |ui| {
                if ui.button("CSV").clicked() {
                    let named: Vec<_> = lines().into_iter().map(|(_, name, points)| (name, points)).collect();
                    let text = table([&Axes::label(axes.x), &Axes::label(axes.y)], &named);
                    view.asks.push(Ask::Text("plot.csv", text));
                    ui.close();
                }
                if ui.button("SVG").clicked() {
                    view.asks.push(Ask::Text("plot.svg", svg(title, axes, lines(), words)));
                    ui.close();
                }
                if ui.button("PNG").clicked() {
                    // Filled in when the plot is drawn: it lies below this line.
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

/// The figure as the report draws it.
fn svg(title: &str, axes: Axes, lines: Vec<(Role, String, Vec<[f64; 2]>)>, w: &Words) -> String {
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
        x: Axis::around(Axes::label(axes.x), x),
        y: Axis::around(Axes::label(axes.y), y),
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

/// Colour and width of a line: measured tests in their own hue, models in ink over them.
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

fn draw<'a>(plot: &mut PlotUi<'a>, line: &'a Drawn, points: &'a [PlotPoint], (colour, width): (Color32, f32)) {
    let drawn = Line::new(line.name.clone(), PlotPoints::Borrowed(points)).color(colour).width(width);
    plot.line(if line.whose == Whose::Reference { drawn.style(LineStyle::dashed_dense()) } else { drawn });
}

/// Which of the loop plots.
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
    let lines = view.lines.lines(session, view.effect, words);
    let force = (words.force, "N");
    let (id, title, axes) = match which {
        Which::Velocity => ("fv", words.force_velocity, Axes { x: (words.velocity, "m/s"), y: force }),
        Which::Displacement => ("fx", words.force_displacement, Axes { x: (words.displacement, "mm"), y: force }),
        Which::Time => ("ft", words.force_time, Axes { x: (words.time, "s"), y: force }),
        Which::Temperature => ("tt", words.temperature, Axes { x: (words.time, "s"), y: (words.temperature, "°C") }),
    };
    let of = |line: &Drawn| -> Vec<PlotPoint> { points_of(line, which).to_vec() };
    let top = ui.cursor().min;
    heading(ui, view, title, axes, || {
        let plain = |line: &Drawn| of(line).iter().map(|p| [p.x, p.y]).collect();
        lines.iter().map(|l| (role(l.whose), l.name.clone(), plain(l))).collect()
    });
    let looks: Vec<_> = lines.iter().map(|l| look(ui, l)).collect();
    let response = plot(id, axes, which != Which::Temperature, words).show(ui, |plot| {
        for (line, look) in lines.iter().zip(&looks) {
            draw(plot, line, points_of(line, which), *look);
        }
    });
    remember_place(ui, title, top, response.response.rect);
    let shown = summary(session, words);
    response.response.widget_info(|| WidgetInfo::labeled(egui::Role::Figure, true, format!("{title}: {shown}")));
}

/// What both ways of a cycle have in common over displacement, and half of what they do not: gas and springs, drag and friction where the
/// test is slow.
pub fn gas_and_drag(ui: &mut Ui, session: &Session, view: &mut View) {
    let words = view.words();
    let lines = view.lines.lines(session, view.effect, words);
    let axes = Axes { x: (words.displacement, "mm"), y: (words.force, "N") };
    let both = |l: &Drawn| [(words.both_ways, l.gas.clone()), (words.drag, l.drag.clone())];
    let top = ui.cursor().min;
    heading(ui, view, words.gas_and_drag, axes, || {
        let plain = |points: Vec<PlotPoint>| points.iter().map(|p| [p.x, p.y]).collect();
        let of =
            |l: &Drawn| both(l).map(|(what, points)| (role(l.whose), format!("{}: {what}", l.name), plain(points)));
        lines.iter().flat_map(of).collect()
    });
    let looks: Vec<_> = lines.iter().map(|l| look(ui, l)).collect();
    let response = plot("gas", axes, false, words).show(ui, |plot| {
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

/// What a screen reader says of the plots.
fn summary(session: &Session, words: &Words) -> String {
    let names: Vec<&str> =
        session.selected.iter().filter_map(|k| session.record(*k)).map(|r| r.name.as_str()).collect();
    let model = if session.model.is_some() { named(Whose::Model, words) } else { "" };
    format!("{} {model}", names.join(", "))
}

/// Peak force over peak velocity: the tests, the curve of the model, and its points, which are dragged.
pub fn peaks(ui: &mut Ui, session: &mut Session, view: &mut View) {
    let words = view.words();
    let axes = Axes { x: (words.velocity, "m/s"), y: (words.force, "N") };
    let Some(loaded) = session.campaign.clone() else { return };
    let curve = |params: &dashpot_core::Params| curve(params, reach(&loaded));
    let now = session.model.as_ref().map(|m| curve(m.params()));
    let identified = session.model.as_ref().filter(|m| m.is_tuned()).map(|m| curve(&m.identified));
    let measured: Vec<[f64; 2]> =
        loaded.tests.iter().flat_map(|t| t.peaks).filter(|p| p[0].is_finite() && p[1].is_finite()).collect();
    let top = ui.cursor().min;
    heading(ui, view, words.peaks, axes, || {
        let mut lines = vec![(Role::Measured, words.measured.to_owned(), measured.clone())];
        let curves = [(&now, Role::Model, words.fv_curve), (&identified, Role::Before, words.identified_model)];
        for (curve, role, name) in curves {
            lines.extend(curve.as_ref().map(|c| (role, name.to_owned(), c.clone())));
        }
        lines
    });
    let handles = session.model.as_ref().map_or_else(Vec::new, |m| handles(m.params()));
    let ink = ui.visuals().strong_text_color();
    let weak = ui.visuals().weak_text_color();
    let grabbed = view.grabbed;
    let selected: Vec<(usize, [f64; 2])> = session
        .selected
        .iter()
        .enumerate()
        .filter_map(|(place, k)| Some(loaded.tests.get(*k)?.peaks.map(|p| (place, p))))
        .flatten()
        .filter(|(_, p)| p[0].is_finite())
        .collect();
    let figure = plot("peaks", axes, false, words).allow_drag(grabbed.is_none()).allow_boxed_zoom(grabbed.is_none());
    let response = figure.show(ui, |plot| {
        let grey = Points::new(words.measured, PlotPoints::from(measured.clone())).radius(2.5).color(weak);
        plot.points(grey);
        for (place, peak) in &selected {
            plot.points(Points::new(words.measured, PlotPoints::from(vec![*peak])).radius(4.0).color(hue(*place)));
        }
        if let Some(curve) = &identified {
            plot.line(Line::new(words.identified_model, PlotPoints::from(curve.clone())).color(weak).width(1.0));
        }
        if let Some(curve) = &now {
            plot.line(Line::new(words.fv_curve, PlotPoints::from(curve.clone())).color(ink).width(1.5));
        }
        if !handles.is_empty() {
            let places = handles.iter().map(|h| [h.0, h.1]).collect::<Vec<_>>();
            let points = Points::new(words.fv_points, PlotPoints::from(places)).radius(4.5).filled(false).color(ink);
            plot.points(points);
        }
        let pointer = plot.response().hover_pos();
        let near = pointer.and_then(|at| {
            let distance = |h: &(f64, f64)| plot.screen_from_plot(PlotPoint::new(h.0, h.1)).distance(at);
            let nearest = (0..handles.len()).min_by(|a, b| distance(&handles[*a]).total_cmp(&distance(&handles[*b])));
            nearest.filter(|k| distance(&handles[*k]) <= GRAB)
        });
        (near, plot.pointer_coordinate())
    });
    let (near, pointer) = response.inner;
    let mouse = response.response;
    remember_place(ui, words.peaks, top, mouse.rect);
    let shown = summary(session, words);
    mouse.widget_info(|| WidgetInfo::labeled(egui::Role::Figure, true, format!("{}: {shown}", words.peaks)));
    // A press near a point takes it, before the plot takes the drag for itself.
    let (pressed, down) = ui.input(|i| (i.pointer.primary_pressed(), i.pointer.primary_down()));
    if pressed && mouse.contains_pointer() {
        view.grabbed = near;
    }
    if near.is_some() || view.grabbed.is_some() {
        ui.ctx().set_cursor_icon(egui::CursorIcon::Grab);
    }
    if let (Some(point), Some(at), true) = (view.grabbed, pointer, down) {
        let with_velocity = ui.input(|i| i.modifiers.shift);
        session.tune(|m| drag(m, point, [at.x, at.y], with_velocity));
    }
    if view.grabbed.is_some() && !down {
        view.grabbed = None;
        if let Some(model) = &mut session.model {
            model.seal();
        }
    }
    if mouse.has_focus() && ui.input(|i| i.key_pressed(Key::Escape)) {
        view.grabbed = None;
    }
}

/// How fast the tests are, with a little more.
fn reach(loaded: &crate::session::campaign::Loaded) -> f64 {
    1.05 * loaded.campaign.records.iter().map(|r| r.peak_velocity).fold(0.1, f64::max)
}

/// Force of the gas as the load cell sees it: it stands beside the curve.
fn gas_in_tension(params: &dashpot_core::Params) -> f64 {
    let mut alone = *params;
    alone.disable_all();
    alone.enable(element!("gas_preload"), params.is_on(element!("gas_preload")));
    let Ok(model) = dashpot_core::Model::new(&alone) else { return 0.0 };
    let input = dashpot_core::Input { displacement: Some(0.0), velocity: 0.0, side_force: 0.0, temperature: 20.0 };
    dashpot_core::evaluate::force(&model, &model.settled(&input), &input).force
}

/// The curve of the model with its gas force.
fn curve(params: &dashpot_core::Params, reach: f64) -> Vec<[f64; 2]> {
    let Ok(model) = dashpot_core::Model::new(params) else { return Vec::new() };
    let gas = gas_in_tension(params);
    let fv = model.elements().paths.fv_curve;
    let at = |k: usize| reach * (2.0 * k as f64 / (CURVE - 1) as f64 - 1.0);
    // Closer together where the curve bends, at low speeds.
    let bent = |k: usize| at(k) * (at(k).abs() / reach);
    (0..CURVE).map(bent).map(|v| [v, fv.at(v).value + gas]).collect()
}

/// The points of the curve's table where they are drawn; none where it has another form.
fn handles(params: &dashpot_core::Params) -> Vec<(f64, f64)> {
    if !params.is_on(element!("fv_curve")) || params.number(number!("fv_form")) != 0.0 {
        return Vec::new();
    }
    let gas = gas_in_tension(params);
    params.list(list!("fv_velocity")).iter().zip(params.list(list!("fv_force"))).map(|(v, f)| (*v, f + gas)).collect()
}

/// Moves a point of the curve; where the neighbours are in the way it stops beside them.
pub fn drag(model: &mut model::Tuned, point: usize, to: [f64; 2], with_velocity: bool) -> bool {
    let (velocity, force) = (list!("fv_velocity"), list!("fv_force"));
    let (velocities, forces) = (model.params().list(velocity).to_vec(), model.params().list(force).to_vec());
    let (Some(v), Some(_)) = (velocities.get(point), forces.get(point)) else { return false };
    // At rest the curve has no force.
    if *v == 0.0 {
        return false;
    }
    let between = |values: &[f64], wanted: f64, apart: f64| {
        let low = point.checked_sub(1).map_or(f64::NEG_INFINITY, |k| values[k] + apart);
        let high = values.get(point + 1).map_or(f64::INFINITY, |next| next - apart);
        if low <= high { restrict(wanted, low, high) } else { values[point] }
    };
    let wanted = to[1] - gas_in_tension(model.params());
    let changed = model.set(force.row(), point, between(&forces, wanted, 0.0));
    // Neighbours closer than a micrometre a second would make a step of the curve.
    let moved = with_velocity && model.set(velocity.row(), point, between(&velocities, to[0], 1e-3));
    changed || moved
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{Language, texts};

    #[test]
    fn a_saved_plot_is_in_the_language_of_the_window() {
        let w = texts(Language::German);
        let axes = Axes { x: (w.velocity, "m/s"), y: (w.force, "N") };
        let lines = vec![(Role::Measured, "a".to_owned(), vec![[-0.5, -300.0], [0.0, 10.0], [0.5, 900.0]])];
        let text = svg(w.force_velocity, axes, lines, w);
        assert!(text.contains(w.measured) && text.contains("0,2") && !text.contains(">measured<"), "{text}");
    }
}
