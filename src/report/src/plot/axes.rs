//! A plane figure: two axes with marks and units, a legend above, lines or dots inside.

use super::palette::Role;
use super::svg::{Anchor, Svg, TextStyle};
use super::ticks::Ticks;

/// Size of a plane figure, px.
pub const SIZE: [f64; 2] = [460.0, 330.0];
/// Points a single line may keep; three noisy lines then stay near ten kilobytes.
pub const LINE_LIMIT: usize = 450;

/// Text sizes, px.
pub const TITLE: f64 = 13.0;
/// Axis titles and legend.
pub const LABEL: f64 = 12.0;
/// Tick labels.
pub const TICK: f64 = 11.0;

/// One axis: its title with unit, and the range shown.
#[derive(Debug, Clone)]
pub struct Axis {
    /// Title with unit.
    pub label: String,
    /// Smallest value shown.
    pub low: f64,
    /// Largest value shown.
    pub high: f64,
    /// How values are spread over it.
    pub scale: Scale,
}

/// How an axis spreads its values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithm; all are positive.
    Logarithmic,
    /// By the root of their magnitude: what happens near zero gets room, and the sign stays.
    Root,
}

impl Scale {
    /// A value on the evenly spread scale.
    pub fn of(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Logarithmic => value.ln(),
            Self::Root => value.signum() * value.abs().sqrt(),
        }
    }

    /// The value at a place of the evenly spread scale.
    pub fn back(self, place: f64) -> f64 {
        match self {
            Self::Linear => place,
            Self::Logarithmic => place.exp(),
            Self::Root => place * place.abs(),
        }
    }
}

impl Axis {
    /// An axis that shows all values with a margin. Constant or missing values get a range of their own size.
    pub fn around(label: impl Into<String>, values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = values.into_iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
        let (low, high) = if low > high { (-1.0, 1.0) } else { (low, high) };
        let size = low.abs().max(high.abs());
        let span = high - low;
        let margin = if span > 1e-9 * size { 0.04 * span } else { (0.5 * size).max(1e-6) };
        Self { label: label.into(), low: low - margin, high: high + margin, scale: Scale::Linear }
    }

    /// An axis that ends exactly where the values do (time).
    pub fn exactly(label: impl Into<String>, low: f64, high: f64) -> Self {
        if high > low {
            Self { label: label.into(), low, high, scale: Scale::Linear }
        } else {
            Self::around(label, [low])
        }
    }

    /// Place of a value between 0 (low end) and 1 (high end).
    pub fn place(&self, value: f64) -> f64 {
        let [low, value, high] = [self.low, value, self.high].map(|v| self.scale.of(v));
        (value - low) / (high - low)
    }

    /// Marks, about `wanted` of them.
    pub fn ticks(&self, wanted: usize) -> Ticks {
        match self.scale {
            Scale::Linear => Ticks::linear(self.low, self.high, wanted),
            Scale::Logarithmic => Ticks::logarithmic(self.low, self.high),
            Scale::Root => Ticks::root(self.low, self.high, wanted),
        }
    }
}

/// Lines of one role in data units; each inner list is one unbroken line.
#[derive(Debug, Clone)]
pub struct Series {
    /// Whose force.
    pub role: Role,
    /// Name in the legend.
    pub label: &'static str,
    /// Unbroken lines.
    pub lines: Vec<Vec<[f64; 2]>>,
    /// Whether to mark every point, as for a curve of few points.
    pub dotted: bool,
}

/// A plane figure.
#[derive(Debug, Clone)]
pub struct Plane {
    /// What is shown.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Lines in drawing order; the legend follows it.
    pub series: Vec<Series>,
}

/// How the lines of a figure are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Drawn {
    /// As lines of at most so many points.
    Lines(usize),
    /// As the places that they pass.
    Traces,
}

impl Plane {
    /// Draws the figure.
    pub fn draw(&self) -> String {
        self.drawn(Drawn::Lines(LINE_LIMIT))
    }

    /// Draws lines that swing for a long time, with as many points as that takes.
    pub fn draw_long(&self) -> String {
        self.drawn(Drawn::Lines(6 * LINE_LIMIT))
    }

    /// Draws the figure of lines that cross themselves many times, as the places that they pass.
    pub fn draw_traces(&self) -> String {
        self.drawn(Drawn::Traces)
    }

    fn drawn(&self, how: Drawn) -> String {
        let [width, height] = SIZE;
        let (left, right, top, bottom) = (66.0, width - 14.0, 50.0, height - 44.0);
        let mut svg = Svg::new(width, height, &self.title);
        let at_x = |value: f64| left + self.x.place(value) * (right - left);
        let at_y = |value: f64| bottom - self.y.place(value) * (bottom - top);

        let legend: Vec<_> = self.series.iter().map(|series| (series.role, series.label)).collect();
        heading(&mut svg, &self.title, left, Mark::Line, &legend);

        let (x_ticks, y_ticks) = (self.x.ticks(6), self.y.ticks(6));
        let vertical = |value: f64| [[at_x(value), top], [at_x(value), bottom]];
        let horizontal = |value: f64| [[left, at_y(value)], [right, at_y(value)]];
        let mut grid: Vec<_> = x_ticks.at.iter().map(|(value, _)| vertical(*value)).collect();
        grid.extend(y_ticks.at.iter().map(|(value, _)| horizontal(*value)));
        svg.grid(&grid);
        let mut zero = Vec::new();
        if self.x.low < 0.0 && self.x.high > 0.0 {
            zero.push(vertical(0.0));
        }
        if self.y.low < 0.0 && self.y.high > 0.0 {
            zero.push(horizontal(0.0));
        }
        svg.frame(&zero, 0.8);
        svg.frame(&[[[left, bottom], [right, bottom]], [[left, top], [left, bottom]]], 1.0);
        for (value, label) in &x_ticks.at {
            let last = width - 0.5 * text_width(label, TICK) - 1.0;
            svg.text([at_x(*value).min(last), bottom + 15.0], label, TextStyle::faint(TICK, Anchor::Middle));
        }
        for (value, label) in &y_ticks.at {
            svg.text([left - 6.0, at_y(*value) + 4.0], label, TextStyle::faint(TICK, Anchor::End));
        }
        svg.text([0.5 * (left + right), height - 10.0], &self.x.label, TextStyle::plain(LABEL, Anchor::Middle));
        let turned = TextStyle { turn: -90.0, ..TextStyle::plain(LABEL, Anchor::Middle) };
        svg.text([15.0, 0.5 * (top + bottom)], &self.y.label, turned);

        for series in &self.series {
            let lines: Vec<Vec<_>> =
                series.lines.iter().map(|line| line.iter().map(|[x, y]| [at_x(*x), at_y(*y)]).collect()).collect();
            match how {
                Drawn::Traces => svg.trace(series.role, &lines, 1.2),
                Drawn::Lines(limit) => {
                    for points in &lines {
                        svg.path(series.role, points, limit / lines.len().max(1));
                        if series.dotted {
                            points.iter().for_each(|point| svg.dot(series.role, *point, 2.3));
                        }
                    }
                }
            }
        }
        svg.finish()
    }
}

/// How a series is marked, in the figure and in its legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// A line.
    Line,
    /// Separate dots.
    Dot,
}

/// Title and, below it, the legend: a mark and a name for each series.
pub fn heading(svg: &mut Svg, title: &str, left: f64, mark: Mark, legend: &[(Role, &str)]) {
    svg.text([left, 17.0], title, TextStyle { bold: true, ..TextStyle::plain(TITLE, Anchor::Start) });
    let mut x = left;
    for (role, label) in legend {
        match mark {
            Mark::Line => svg.path(*role, &[[x, 33.0], [x + 20.0, 33.0]], 2),
            Mark::Dot => svg.dot(*role, [x + 14.0, 33.0], 3.4),
        }
        svg.text([x + 25.0, 37.0], label, TextStyle::plain(LABEL, Anchor::Start));
        x += 25.0 + text_width(label, LABEL) + 16.0;
    }
}

/// Rough width of a text, px: sans-serif letters are a little over half as wide as high.
pub fn text_width(text: &str, size: f64) -> f64 {
    0.56 * size * text.chars().count() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_shows_all_values_and_never_collapses() {
        let axis = Axis::around("N", [-3.0, 9.0]);
        assert!(axis.place(-3.0) > 0.0 && axis.place(9.0) < 1.0);
        for values in [vec![], vec![0.0, 0.0], vec![1e6], vec![-1e-12]] {
            let axis = Axis::around("N", values.clone());
            assert!(axis.high > axis.low && !axis.ticks(5).at.is_empty(), "{values:?} {axis:?}");
        }
        let still = Axis::exactly("s", 2.0, 2.0);
        assert!(still.high > still.low);
    }

    #[test]
    fn the_larger_value_is_drawn_further_up_and_right() {
        let series =
            Series { role: Role::Model, label: "model", lines: vec![vec![[0.0, 0.0], [1.0, 1.0]]], dotted: true };
        let text = Plane {
            title: "t".into(),
            x: Axis::around("x", [0.0, 1.0]),
            y: Axis::around("y", [0.0, 1.0]),
            series: vec![series],
        }
        .draw();
        let read = |name: &str| -> Vec<f64> {
            text.split(&format!(" {name}=\"")).skip(1).map(|s| s.split('"').next().unwrap().parse().unwrap()).collect()
        };
        let (x, y) = (read("cx"), read("cy"));
        assert!(x[1] > x[0] && y[1] < y[0], "{x:?} {y:?}");
    }
}
