//! Tests of the shapes that a frame draws: sizes of letters, legends of plots, marks of sliders.

use super::made_up::campaign_of_family;
use super::*;
use crate::units::{Force, Units, Velocity};
use crate::views::plots::Stop;
use crate::views::tune::IDENTIFIED;
use crate::views::{Corner, Side};
use eframe::egui::epaint::ColorMode;
use eframe::egui::{Color32, Pos2, Rect, Shape};
use egui_kittest::kittest::NodeT as _;
use std::collections::BTreeMap;

/// Calls a function for every shape of the last frame, with the rectangle to which it is clipped.
pub(super) fn each_shape(harness: &Harness<'_, App>, mut see: impl FnMut(&Shape, Rect)) {
    fn inside(shape: &Shape, clip: Rect, see: &mut dyn FnMut(&Shape, Rect)) {
        match shape {
            Shape::Vec(all) => all.iter().for_each(|shape| inside(shape, clip, see)),
            one => see(one, clip),
        }
    }
    for of in &harness.output().shapes {
        inside(&of.shape, of.clip_rect, &mut see);
    }
}

/// Lists the texts of the last frame, with their smallest font size.
fn texts_drawn(harness: &Harness<'_, App>) -> Vec<(String, f32)> {
    let mut all = Vec::new();
    each_shape(harness, |shape, _| {
        if let Shape::Text(text) = shape {
            let job = &text.galley.job;
            let smallest = job.sections.iter().map(|of| of.format.font_id.size).fold(f32::INFINITY, f32::min);
            all.push((job.text.clone(), smallest));
        }
    });
    all
}

#[track_caller]
fn check_letters(harness: &Harness<'_, App>, view: &str) {
    let all = texts_drawn(harness);
    assert!(all.len() > 30, "{view}: {} texts", all.len());
    for (text, size) in all.iter().filter(|(text, _)| !text.trim().is_empty()) {
        assert!(*size >= 11.0, "{view}: {text:?} has {size} px");
    }
}

/// A damper over a current, with a valve.
const FAMILY: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\nsetting = [0.0, 1.0]\nsetting_name = \"current\"\nsetting_unit = \"A\"\n\
     setting_time_up = 0.008\nsetting_time_down = 0.02\nfv_velocity = [-1.0, 0.0, 1.0]\n\
     fv_force = [[-800.0, 0.0, 1200.0], [-2400.0, 0.0, 3600.0]]\n";
const DRAWING: &str = "design = \"monotube\"\nbore_mm = 40\nrod_mm = 12\nrebound_chamber_mm = 130\n";

/// Opens an adjustable damper with its dimensions and tests with steps of the current.
fn adjustable(folder: &Path) -> Harness<'static, App> {
    campaign_of_family(FAMILY, folder);
    let models = folder.join("models");
    std::fs::create_dir(&models).unwrap();
    let (file, drawing) = (models.join("family.toml"), models.join("dimensions.toml"));
    std::fs::write(&file, FAMILY).unwrap();
    std::fs::write(&drawing, DRAWING).unwrap();
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[folder.to_owned(), file, drawing]);
    until(&mut harness, "the responses", |app| app.session.responses.of_force.len() == 2);
    until(&mut harness, "forces", |app| app.session.simulated.as_ref().is_some_and(|s| !s.quick));
    harness
}

const SIDES: [Side; 6] = [Side::Tune, Side::Result, Side::Records, Side::Study, Side::Valve, Side::Drawing];
const CORNERS: [Corner; 6] =
    [Corner::Matrix, Corner::Time, Corner::GasAndDrag, Corner::Tables, Corner::Temperature, Corner::Study];

/// Adds a channel of temperature to every record of a folder.
fn add_temperature(folder: &Path) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "csv") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let with = text.lines().enumerate().map(|(k, line)| match k {
            0 => format!("{line},temperature [°C]\n"),
            _ => format!("{line},{}\n", 25.0 + 1e-3 * k as f64),
        });
        std::fs::write(&path, with.collect::<String>()).unwrap();
    }
}

#[test]
fn no_letter_of_any_view_is_smaller_than_eleven() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), 12);
    add_temperature(folder.path());
    let models = folder.path().join("models");
    std::fs::create_dir(&models).unwrap();
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[folder.path().to_owned(), model(&models)]);
    until(&mut harness, "forces", |app| app.session.simulated.as_ref().is_some_and(|s| !s.quick));
    press(&mut harness, "Study");
    press(&mut harness, "Compute");
    until(&mut harness, "the study", |app| app.session.study.is_some() && app.session.task.is_none());
    for key in [Key::F7, Key::F6, Key::F5] {
        harness.key_press(key);
        harness.step();
        until(&mut harness, "the result", |app| app.session.task.is_none());
    }
    let results = &harness.state().session.results;
    assert!(results.fit.is_some() && results.validation.is_some() && results.diagnosis.is_some());
    press(&mut harness, "Study");
    press(&mut harness, "Compute");
    until(&mut harness, "the study", |app| app.session.study.is_some() && app.session.task.is_none());
    let elsewhere = tempfile::tempdir().unwrap();
    let mut adjustable = adjustable(elsewhere.path());
    let mut empty = window(vec![]);
    for (_, language) in Language::ALL {
        let w = crate::words::texts(language);
        for harness in [&mut harness, &mut adjustable, &mut empty] {
            harness.state_mut().view.language = language;
            for side in SIDES {
                harness.state_mut().view.side = side;
                harness.run_steps(2);
                if harness.state().session.has_records() {
                    check_letters(harness, &format!("{language:?} {side:?}"));
                }
            }
            for corner in CORNERS {
                harness.state_mut().view.corner = corner;
                harness.run_steps(2);
                if harness.state().session.has_records() {
                    check_letters(harness, &format!("{language:?} {corner:?}"));
                }
            }
            press(harness, w.file);
            assert!(has(harness, Role::Button, w.open_dimensions), "{language:?}: the menu is open");
            for (text, size) in texts_drawn(harness) {
                assert!(size >= 11.0, "{language:?}: {text:?} has {size} px");
            }
            harness.key_press(Key::Escape);
            harness.step();
        }
    }
    // The text at the pointer, and the remark that a dragged point has stopped, are drawn into the plot.
    harness.state_mut().view.language = Language::English;
    harness.state_mut().view.stopped = Some(Stop::Force);
    let plot = harness.query_all(by().role(Role::Figure)).next().unwrap().rect();
    harness.hover_at(plot.center());
    harness.run_steps(3);
    check_letters(&harness, "pointer");
    assert!(texts_drawn(&harness).iter().any(|(text, _)| text.starts_with("The point stops")));
}

/// The lines of one plot in the last frame.
#[derive(Default)]
struct OfPlot {
    /// Colors of the solid lines.
    solid: Vec<Color32>,
    /// Whether a line is dashed.
    has_dashes: bool,
}

/// Returns the lines of every plot, by the left and upper edge of its area, px.
fn plots(harness: &Harness<'_, App>) -> BTreeMap<(i32, i32), (Rect, OfPlot)> {
    let mut all: BTreeMap<(i32, i32), (Rect, OfPlot)> = BTreeMap::new();
    each_shape(harness, |shape, clip| {
        let colour = match shape {
            // Icons have fewer points than lines.
            Shape::Path(path) if path.points.len() >= 8 && !path.closed => match path.stroke.color {
                ColorMode::Solid(colour) => Some(colour),
                ColorMode::UV(_) => None,
            },
            // A line whose horizontal positions increase is drawn as a band.
            Shape::Band(band) if band.points.len() >= 8 => Some(band.fill),
            // Lines of the grid are parallel to an axis. Dashes of a curve are not.
            Shape::LineSegment { points: [a, b], .. } if (a.x - b.x).abs() > 0.3 && (a.y - b.y).abs() > 0.3 => None,
            _ => return,
        };
        let place = (clip.left() as i32, clip.top() as i32);
        let (_, of) = all.entry(place).or_insert_with(|| (clip, OfPlot::default()));
        match colour {
            Some(colour) if !of.solid.contains(&colour) => of.solid.push(colour),
            Some(_) => {}
            None => of.has_dashes = true,
        }
    });
    all
}

/// Returns the colors of the legend of a plot, and whether an entry is dashed. The legend is above the plot or within it.
fn legend_of(harness: &Harness<'_, App>, plot: Rect) -> (Vec<Color32>, bool) {
    // A legend of two lines and the title of the plot fit into this height.
    const ABOVE: f32 = 70.0;
    let area = Rect::from_min_max(plot.left_top() - egui::vec2(70.0, ABOVE), plot.right_bottom());
    let (mut colours, mut is_dashed) = (Vec::new(), false);
    let mut last: Option<Pos2> = None;
    each_shape(harness, |shape, _| match shape {
        Shape::LineSegment { points: [a, b], stroke } if a.y == b.y && area.contains(*a) && a.y < plot.top() => {
            colours.push(stroke.color);
            // The first dash ends before the length of a solid entry, 16 px.
            is_dashed |= (b.x - a.x).abs() < 8.0 && last.is_some_and(|at| at.y == a.y);
            last = Some(*a);
        }
        Shape::Circle(circle) if plot.contains(circle.center) => colours.push(circle.fill),
        _ => {}
    });
    (colours, is_dashed)
}

/// Checks that each plot with several lines has a legend. Returns the number of such plots.
#[track_caller]
fn check_legends(harness: &Harness<'_, App>, view: &str) -> usize {
    let mut several = 0;
    for (place, (rect, of)) in plots(harness) {
        if of.solid.len() + usize::from(of.has_dashes) < 2 {
            continue;
        }
        several += 1;
        let (colours, is_dashed) = legend_of(harness, rect);
        for colour in &of.solid {
            // The legend shows the reference once, in the dimmed hue of the first test.
            let is_named = |of: &Color32| of == colour || of.gamma_multiply(0.55) == *colour;
            assert!(
                colours.iter().any(is_named),
                "{view}: the plot at {place:?} has a line in {colour:?}; its legend {colours:?}"
            );
        }
        assert!(is_dashed || !of.has_dashes, "{view}: the plot at {place:?} has a dashed line, and its legend none");
    }
    several
}

#[test]
fn every_plot_with_several_lines_has_a_legend() {
    let folder = tempfile::tempdir().unwrap();
    let other = tempfile::tempdir().unwrap();
    campaign(folder.path(), 9);
    campaign(other.path(), 9);
    add_temperature(folder.path());
    let models = folder.path().join("models");
    std::fs::create_dir(&models).unwrap();
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[folder.path().to_owned(), model(&models)]);
    until(&mut harness, "forces", |app| app.session.simulated.as_ref().is_some_and(|s| !s.quick));
    harness.state_mut().session.open_reference(vec![other.path().to_owned()]);
    until(&mut harness, "the other campaign", |app| app.session.reference.is_some());
    harness.state_mut().session.selected = [0, 1].into();
    press(&mut harness, "Study");
    press(&mut harness, "Compute");
    until(&mut harness, "the study", |app| app.session.study.is_some() && app.session.task.is_none());
    harness.state_mut().session.tune(|m| m.set(number!("series_stiffness").row(), 0, 2.5e6));
    until(&mut harness, "forces of both models", |app| app.session.identified.is_some());
    harness.state_mut().view.effect = Some((element!("gas_spring"), 2.0));
    for (corner, wanted) in
        [(Corner::Matrix, 3), (Corner::Time, 4), (Corner::GasAndDrag, 4), (Corner::Temperature, 4), (Corner::Study, 4)]
    {
        harness.state_mut().view.corner = corner;
        harness.run_steps(3);
        let several = check_legends(&harness, &format!("{corner:?}"));
        assert_eq!(several, wanted, "{corner:?}");
    }
    for entry in ["model", "model as opened", "with the effect", "to compare with", "a08_002"] {
        assert!(has(&harness, Role::Label, entry), "{entry}");
    }
    // Peak forces of tests with their own settings have a curve for each setting, and the valve has two responses.
    let elsewhere = tempfile::tempdir().unwrap();
    let mut harness = adjustable(elsewhere.path());
    harness.state_mut().session.selected = [0, 1].into();
    harness.state_mut().view.side = Side::Valve;
    harness.run_steps(3);
    assert_eq!(check_legends(&harness, "an adjustable damper"), 5, "two loops, peak forces, two responses");
    for setting in ["0 A", "1 A"] {
        assert!(has(&harness, Role::Label, setting), "{setting}");
    }
}

#[test]
fn a_legend_shows_points_as_points() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    harness.run_steps(2);
    let w = crate::words::texts(Language::English);
    // Returns the fillings of the circles in an entry of the legend, and the number of its lines.
    let marks = |entry: &str| {
        let rect = widget(&harness, Role::Label, entry).rect();
        let (mut circles, mut lines) = (Vec::new(), 0);
        each_shape(&harness, |shape, _| match shape {
            Shape::Circle(circle) if rect.contains(circle.center) => circles.push(circle.fill != Color32::TRANSPARENT),
            Shape::LineSegment { points, .. } if rect.contains(points[0]) => lines += 1,
            _ => {}
        });
        (circles, lines)
    };
    assert_eq!(marks(w.measured), (vec![true], 0), "measured peaks are dots");
    assert_eq!(marks(w.fv_points), (vec![false], 0), "points to drag are rings");
    assert_eq!(marks(w.steady_force), (vec![], 1), "the curve is a line");
}

/// Returns the names of the sliders with a mark of an identified value.
fn marked(harness: &Harness<'_, App>) -> Vec<String> {
    let mut marks = Vec::new();
    each_shape(harness, |shape, _| {
        if let Shape::Rect(rect) = shape
            && rect.fill == IDENTIFIED
        {
            marks.push(rect.rect.center());
        }
    });
    let sliders = harness.query_all(by().role(Role::Slider));
    let names = sliders.filter(|slider| marks.iter().any(|mark| slider.rect().expand(1.0).contains(*mark)));
    names.map(|slider| slider.accesskit_node().label().unwrap_or_default()).collect()
}

#[test]
fn the_mark_of_an_identified_value_is_under_identified_numbers_alone() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 12, vec![]);
    // In a window of this height, the panel shows every number without scrolling.
    harness.set_size(egui::vec2(1280.0, 6000.0));
    harness.run_steps(3);
    assert!(has(&harness, Role::Label, "▬\u{a0}as\u{a0}opened"), "no fit has identified these values");
    press(&mut harness, "Fit");
    until(&mut harness, "the fit", |app| app.session.results.fit.is_some() && app.session.task.is_none());
    press(&mut harness, "Tune");
    assert!(has(&harness, Role::Label, "▬\u{a0}identified"));
    let points = language_name("fv_force");
    let count = harness.state().session.model.as_ref().unwrap().params().list(list!("fv_force")).len();
    widget(&harness, Role::DisclosureTriangle, &format!("{points} ({count})")).click();
    harness.run_steps(30);
    let marks = marked(&harness);
    let (mut identified, mut open) = (0, 0);
    for e in harness.state().session.estimates() {
        let name = e.index.map_or_else(|| language_name(e.name), |k| format!("{} {}", language_name(e.name), k + 1));
        let unit = Units::default().shown(dashpot_core::parameter::find(e.name).unwrap().parameter.unit).symbol;
        let name = format!("{name} {unit}");
        if !has(&harness, Role::Slider, &name) {
            continue;
        }
        let wanted = e.standing == dashpot_identification::Standing::Identified && e.low.is_some();
        if wanted {
            identified += 1;
        } else {
            open += 1;
        }
        assert_eq!(marks.contains(&name), wanted, "{name}: {:?} {:?}", e.standing, e.low);
    }
    assert!(identified > 5 && open > 0, "{identified} {open}");
}

fn language_name(identifier: &str) -> String {
    crate::views::translate_name(identifier, Language::English.words())
}

#[test]
fn a_point_dragged_with_the_mouse_moves_and_says_in_every_language_why_it_stops() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    harness.run_steps(3);
    let forces = |harness: &Harness<'_, App>| {
        harness.state().session.model.as_ref().unwrap().params().list(list!("fv_force")).to_vec()
    };
    let before = forces(&harness);
    // The points of the curve are circles without filling.
    let handles = |harness: &Harness<'_, App>| {
        let mut all = Vec::new();
        each_shape(harness, |shape, _| match shape {
            Shape::Circle(circle) if circle.radius > 4.0 && circle.fill == Color32::TRANSPARENT => {
                all.push(circle.center)
            }
            _ => {}
        });
        all.sort_by(|a: &Pos2, b| a.x.total_cmp(&b.x));
        all
    };
    let at = handles(&harness);
    assert_eq!(at.len(), before.len(), "{at:?}");
    let last = at.len() - 1;
    harness.drag_at(at[last]);
    harness.step();
    harness.hover_at(at[last] - egui::vec2(0.0, 3.0));
    harness.run_steps(2);
    let moved = forces(&harness);
    assert!(moved[last] > before[last] && moved[..last] == before[..last], "{before:?} {moved:?}");
    assert!(harness.state().view.stopped.is_none());
    // At a position far below, the force of the point would pass the force of its neighbor, so the point stops.
    harness.hover_at(at[last] + egui::vec2(0.0, 150.0));
    harness.run_steps(2);
    assert_eq!(forces(&harness)[last], before[last - 1]);
    for (_, language) in Language::ALL {
        harness.state_mut().view.language = language;
        harness.run_steps(2);
        let why = crate::words::texts(language).stop_force;
        assert!(texts_drawn(&harness).iter().any(|(text, _)| text == why), "{language:?}: {why}");
        assert!(holds(&harness, why), "a screen reader says it, too");
    }
    harness.drop_at(at[last] + egui::vec2(0.0, 150.0));
    harness.run_steps(2);
    let why = crate::words::texts(Language::Chinese).stop_force;
    assert!(!texts_drawn(&harness).iter().any(|(text, _)| text == why), "the remark ends with the drag");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.step();
    assert_eq!(forces(&harness), before, "the drag is one step");
}

#[test]
fn units_are_chosen_in_the_bar_and_apply_to_axes_tables_and_sliders() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = opened(folder.path(), 6, vec![]);
    harness.state_mut().view.corner = Corner::Tables;
    let w = crate::words::texts(Language::English);
    let choose = |harness: &mut Harness<'_, App>, list: &str, unit: &str| {
        widget(harness, Role::ComboBox, list).click();
        harness.run_steps(3);
        press(harness, unit);
        harness.run_steps(2);
    };
    for (velocity, force, per_length, of) in [
        ("mm/s", "kN", "kN/mm", Units { velocity: Velocity::MillimetersPerSecond, force: Force::Kilonewtons }),
        ("in/s", "lbf", "lbf/in", Units { velocity: Velocity::InchesPerSecond, force: Force::Pounds }),
        ("m/s", "N", "N/mm", Units::default()),
    ] {
        choose(&mut harness, w.unit_of_velocity, velocity);
        choose(&mut harness, w.unit_of_force, force);
        assert_eq!(harness.state().view.units, of);
        let all = texts_drawn(&harness);
        for text in [format!("Velocity [{velocity}]"), format!("Force [{force}]"), format!("measured [{force}]")] {
            assert!(all.iter().any(|(drawn, _)| drawn.ends_with(&text)), "{text}: {all:?}");
        }
        assert!(has(&harness, Role::Slider, &format!("series stiffness {per_length}")), "{per_length}");
    }
}
