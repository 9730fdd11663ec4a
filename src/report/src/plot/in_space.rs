//! Three-dimensional plots: the force and its error over velocity and displacement of one test, and the force of an adjustable damper over
//! velocity and setting.
//!
//! The projection is parallel (axonometric), so that equal lengths along an axis stay equal. The projections of the
//! measured loop on the back walls are the force–velocity and force–displacement plots.

use super::axes::{Axis, LABEL, LINE_LIMIT, Mark, SIZE, TICK, heading};
use super::of_test::shown;
use super::palette::Role;
use super::simplify::Point;
use super::svg::{Anchor, Svg, TextStyle};
use crate::words::Words;
use dashpot_identification::validation::Compared;

/// Rotation about the vertical axis of the box that contains the plot, degrees.
const TURN: f64 = 36.0;
/// Elevation of the line of sight, degrees.
const ELEVATION: f64 = 20.0;
/// Edge lengths of the box: velocity, displacement, force, px.
const BOX: [f64; 3] = [225.0, 185.0, 150.0];
/// Center of the box in the figure, px.
const MIDDLE: Point = [242.0, 168.0];

/// Draws the measured and the computed forces over velocity and displacement.
pub fn force(compared: &Compared<'_>, words: &Words) -> String {
    let series = [
        (Role::Measured, words.measured, compared.record.force.clone()),
        (Role::FvOnly, words.fv_curve, compared.fv_only.clone()),
        (Role::Model, words.model, compared.model.clone()),
    ];
    draw([words.plot_force_space, words.axis_force], compared, &series, words)
}

/// Draws the errors, computed minus measured force, of model and FV curve over velocity and displacement.
pub fn error(compared: &Compared<'_>, words: &Words) -> String {
    let minus = |force: &[f64]| force.iter().zip(&compared.record.force).map(|(f, measured)| f - measured).collect();
    let series =
        [(Role::FvOnly, words.fv_curve, minus(&compared.fv_only)), (Role::Model, words.model, minus(&compared.model))];
    draw([words.plot_error_space, words.axis_error], compared, &series, words)
}

/// Lines and dots of one color in a three-dimensional figure. The coordinates are in the units of the axes.
#[derive(Debug, Clone)]
pub struct SpaceSeries {
    /// Color.
    pub role: Role,
    /// Name in the legend; empty for none.
    pub name: String,
    /// Lines through points.
    pub lines: Vec<Vec<[f64; 3]>>,
    /// Separate points.
    pub dots: Vec<[f64; 3]>,
}

/// Draws lines and dots over the first two axes, with the third axis pointing up. Later series are drawn over earlier ones.
pub fn surface(title: &str, axes: &[Axis; 3], series: &[SpaceSeries], words: &Words) -> String {
    let mut svg = Svg::new(SIZE[0], SIZE[1], title);
    let named = series.iter().filter(|of| !of.name.is_empty());
    let legend: Vec<_> = named.map(|of| (of.role, of.name.as_str(), Mark::Line)).collect();
    heading(&mut svg, title, 20.0, &legend);
    draw_box(&mut svg, axes, words);
    let place = |at: &[f64; 3]| project([0, 1, 2].map(|axis| axes[axis].place(at[axis])));
    for of in series {
        for line in &of.lines {
            let line: Vec<Point> = line.iter().map(place).collect();
            svg.path(of.role, &line, LINE_LIMIT / 4);
        }
        for at in &of.dots {
            svg.dot(of.role, place(at), 2.2);
        }
    }
    svg.finish()
}

/// Projects a point of the box into the figure. Each coordinate of the point is from 0 to 1. Velocity points right and toward the reader,
/// displacement points right and away, force points up.
fn project(at: [f64; 3]) -> Point {
    let (turn, elevation) = (TURN.to_radians(), ELEVATION.to_radians());
    let [u, w, z] = [0, 1, 2].map(|i| (at[i] - 0.5) * BOX[i]);
    let away = w * libm::cos(turn) - u * libm::sin(turn);
    [
        MIDDLE[0] + u * libm::cos(turn) + w * libm::sin(turn),
        MIDDLE[1] - z * libm::cos(elevation) - away * libm::sin(elevation),
    ]
}

fn draw(
    [title, quantity]: [&str; 2],
    compared: &Compared<'_>,
    series: &[(Role, &'static str, Vec<f64>)],
    words: &Words,
) -> String {
    let record = compared.record;
    let ranges = shown(compared);
    let samples = || ranges.iter().cloned().flatten();
    let axes = [
        Axis::around(words.axis_velocity, samples().map(|i| 1e3 * record.velocity[i])),
        Axis::around(words.axis_displacement, samples().map(|i| 1e3 * record.displacement[i])),
        Axis::around(quantity, series.iter().flat_map(|(_, _, values)| samples().map(|i| values[i]))),
    ];
    let mut svg = Svg::new(SIZE[0], SIZE[1], title);
    let legend: Vec<_> = series.iter().map(|(role, label, _)| (*role, *label, Mark::Line)).collect();
    heading(&mut svg, title, 20.0, &legend);
    draw_box(&mut svg, &axes, words);

    let place = |values: &[f64], i: usize| {
        let at = [1e3 * record.velocity[i], 1e3 * record.displacement[i], values[i]];
        [0, 1, 2].map(|axis| axes[axis].place(at[axis]))
    };
    let mut lines = |role: Role, values: &[f64], limit: usize, onto: fn([f64; 3]) -> [f64; 3]| {
        for range in &ranges {
            let line: Vec<Point> = range.clone().map(|i| project(onto(place(values, i)))).collect();
            svg.path(role, &line, limit / ranges.len());
        }
    };
    if let Some((_, _, first)) = series.iter().find(|(role, ..)| *role == Role::Measured) {
        lines(Role::Shadow, first, LINE_LIMIT / 4, |at| [at[0], 1.0, at[2]]);
        lines(Role::Shadow, first, LINE_LIMIT / 4, |at| [0.0, at[1], at[2]]);
    }
    for (role, _, values) in series {
        lines(*role, values, LINE_LIMIT / 2, |at| at);
    }
    svg.finish()
}

/// Draws the floor and the two back walls of the box, with grid, frame, tick labels and axis titles along the outer edges.
fn draw_box(svg: &mut Svg, axes: &[Axis; 3], words: &Words) {
    let ticks = [(0, 5), (1, 4), (2, 5)].map(|(axis, wanted)| axes[axis].ticks(wanted, words));
    let places = |axis: usize| ticks[axis].at.iter().map(move |(value, _)| axes[axis].place(*value));
    let line = |a: [f64; 3], b: [f64; 3]| [project(a), project(b)];
    let mut grid = Vec::new();
    for u in places(0) {
        grid.extend([line([u, 0.0, 0.0], [u, 1.0, 0.0]), line([u, 1.0, 0.0], [u, 1.0, 1.0])]);
    }
    for w in places(1) {
        grid.extend([line([0.0, w, 0.0], [1.0, w, 0.0]), line([0.0, w, 0.0], [0.0, w, 1.0])]);
    }
    for z in places(2) {
        grid.extend([line([0.0, 0.0, z], [0.0, 1.0, z]), line([0.0, 1.0, z], [1.0, 1.0, z])]);
    }
    svg.grid(&grid);
    let corner = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let mut frame: Vec<_> = (0..4)
        .map(|i| {
            let ([u, w], [next_u, next_w]) = (corner[i], corner[(i + 1) % 4]);
            line([u, w, 0.0], [next_u, next_w, 0.0])
        })
        .collect();
    frame.extend([
        line([0.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        line([0.0, 1.0, 0.0], [0.0, 1.0, 1.0]),
        line([1.0, 1.0, 0.0], [1.0, 1.0, 1.0]),
        line([0.0, 0.0, 1.0], [0.0, 1.0, 1.0]),
        line([0.0, 1.0, 1.0], [1.0, 1.0, 1.0]),
    ]);
    svg.frame(&frame, 0.8);
    // Draw the line of zero force, or zero error, on both back walls.
    let zero = axes[2].place(0.0);
    if (0.0..=1.0).contains(&zero) {
        svg.frame(&[line([0.0, 0.0, zero], [0.0, 1.0, zero]), line([0.0, 1.0, zero], [1.0, 1.0, zero])], 0.6);
    }

    let beside = |point: Point, dx: f64, dy: f64| [point[0] + dx, point[1] + dy];
    for (value, label) in &ticks[0].at {
        let at = project([axes[0].place(*value), 0.0, 0.0]);
        svg.text(beside(at, -5.0, 14.0), label, TextStyle::faint(TICK, Anchor::End));
    }
    for (value, label) in &ticks[1].at {
        let at = project([1.0, axes[1].place(*value), 0.0]);
        svg.text(beside(at, 6.0, 13.0), label, TextStyle::faint(TICK, Anchor::Start));
    }
    for (value, label) in &ticks[2].at {
        let at = project([0.0, 0.0, axes[2].place(*value)]);
        svg.text(beside(at, -6.0, 4.0), label, TextStyle::faint(TICK, Anchor::End));
    }
    let mut along = |a: [f64; 3], b: [f64; 3], away: f64, label: &str| {
        let (from, to) = (project(a), project(b));
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let length = libm::hypot(dx, dy);
        let at = [0.5 * (from[0] + to[0]) - away * dy / length, 0.5 * (from[1] + to[1]) + away * dx / length];
        let turn = libm::atan2(dy, dx).to_degrees();
        svg.text(at, label, TextStyle { turn, ..TextStyle::plain(LABEL, Anchor::Middle) });
    };
    along([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], 44.0, &axes[0].label);
    along([1.0, 0.0, 0.0], [1.0, 1.0, 0.0], 44.0, &axes[1].label);
    along([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], -46.0, &axes[2].label);
}

#[cfg(test)]
mod tests {
    use super::super::of_test::tests::{compared, record};
    use super::*;
    use crate::words::EN;

    #[test]
    fn the_box_and_its_labels_fit_the_figure() {
        for corner in 0..8 {
            let [x, y] = project([0, 1, 2].map(|axis| f64::from(corner >> axis & 1)));
            assert!((60.0..=SIZE[0] - 20.0).contains(&x) && (40.0..=SIZE[1] - 30.0).contains(&y), "{x} {y}");
        }
    }

    #[test]
    fn the_back_walls_are_behind_the_box() {
        // The depth is the distance away from the reader. It must be larger at the center of each drawn wall than at the center of the
        // opposite wall.
        let depth = |at: [f64; 3]| {
            let turn = TURN.to_radians();
            (at[1] - 0.5) * BOX[1] * libm::cos(turn) - (at[0] - 0.5) * BOX[0] * libm::sin(turn)
        };
        assert!(depth([0.5, 1.0, 0.5]) > depth([0.5, 0.0, 0.5]) && depth([0.0, 0.5, 0.5]) > depth([1.0, 0.5, 0.5]));
    }

    #[test]
    fn both_figures_are_finite_and_small() {
        let record = record(3, true);
        for text in [force(&compared(&record), &EN), error(&compared(&record), &EN)] {
            assert!(!text.contains("NaN") && !text.contains("inf") && text.len() < 16_000, "{}", text.len());
        }
    }
}
