//! A plane figure: two axes with ticks and units, a legend above, and lines or dots.

use super::palette::Role;
use super::svg::{Anchor, Svg, TextStyle};
use super::ticks::Ticks;
use crate::words::Words;

/// Default width and height of a plane figure, px.
pub const SIZE: [f64; 2] = [460.0, 330.0];
/// Largest number of points of all lines of a series. With 260, a report of 55 tests stays below 3 MB. With 450, the report has 3.8 MB
/// without visible improvement.
pub const LINE_LIMIT: usize = 260;

/// Font size of the title, px.
pub const TITLE: f64 = 13.0;
/// Font size of axis titles and legend, px.
pub const LABEL: f64 = 12.0;
/// Font size of tick labels, px.
pub const TICK: f64 = 11.0;

/// One axis: its title with unit, and its visible range.
#[derive(Debug, Clone)]
pub struct Axis {
    /// Title with unit.
    pub label: String,
    /// Smallest visible value.
    pub low: f64,
    /// Largest visible value.
    pub high: f64,
    /// Scale of the values.
    pub scale: Scale,
}

/// Scale of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Linear.
    Linear,
    /// Logarithmic, for positive values.
    Logarithmic,
    /// Signed square root: magnifies the neighborhood of zero and keeps the sign.
    Root,
}

impl Scale {
    /// Returns the name of the scale for the script of the HTML page. The script applies this scale to the ticks when a reader zooms.
    fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Logarithmic => "log",
            Self::Root => "root",
        }
    }

    /// Transforms a value in the unit of the axis to its position on the scale, before normalization to the length of the axis.
    pub fn position(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Logarithmic => libm::log(value),
            Self::Root => value.signum() * value.abs().sqrt(),
        }
    }

    /// Transforms a position on the scale back to the value.
    pub fn back(self, place: f64) -> f64 {
        match self {
            Self::Linear => place,
            Self::Logarithmic => libm::exp(place),
            Self::Root => place * place.abs(),
        }
    }
}

impl Axis {
    /// Makes an axis that shows all values with a margin. If all values are equal, the margin is half their magnitude, or 1 if they are
    /// zero. Without values, the range is about −1 to 1.
    pub fn around(label: impl Into<String>, values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = values.into_iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
        let (low, high) = if low > high { (-1.0, 1.0) } else { (low, high) };
        let size = low.abs().max(high.abs());
        let span = high - low;
        let margin = match () {
            () if span > 1e-9 * size => 0.04 * span,
            () if size > 0.0 => (0.5 * size).max(1e-6),
            // If all values are zero, a range of one unit has readable ticks.
            () => 1.0,
        };
        Self { label: label.into(), low: low - margin, high: high + margin, scale: Scale::Linear }
    }

    /// Makes an axis that ends exactly at `low` and `high`, such as a time axis. If `high` is not above `low`, makes an axis around `low`
    /// with a margin.
    pub fn exactly(label: impl Into<String>, low: f64, high: f64) -> Self {
        if high > low {
            Self { label: label.into(), low, high, scale: Scale::Linear }
        } else {
            Self::around(label, [low])
        }
    }

    /// Returns the position of a value along the axis: 0 at the low end, 1 at the high end.
    pub fn place(&self, value: f64) -> f64 {
        let [low, value, high] = [self.low, value, self.high].map(|v| self.scale.position(v));
        (value - low) / (high - low)
    }

    /// Returns about `wanted` ticks. On a logarithmic axis, the number depends on the range alone.
    pub fn ticks(&self, wanted: usize, words: &Words) -> Ticks {
        let ticks = match self.scale {
            Scale::Linear => Ticks::linear(self.low, self.high, wanted),
            Scale::Logarithmic => Ticks::logarithmic(self.low, self.high),
            Scale::Root => Ticks::root(self.low, self.high, wanted),
        };
        ticks.localized(words)
    }
}

/// Lines of one role, in the units of the axes.
#[derive(Debug, Clone)]
pub struct Series {
    /// What the series shows, such as the measurement. It selects color, line width and dashes.
    pub role: Role,
    /// Name in the legend.
    pub label: &'static str,
    /// Unbroken lines; each inner list contains the points of one line.
    pub lines: Vec<Vec<[f64; 2]>>,
    /// Display of the points.
    pub marks: Marks,
}

/// Display style of the points of a series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marks {
    /// Points joined by a line.
    Line,
    /// Points joined and marked individually, for a curve of few points.
    Both,
    /// Marks only, because each point is a separate result.
    Dots,
    /// Larger dots, which stay visible under dots on top.
    LargeDots,
}

/// A plane figure.
#[derive(Debug, Clone)]
pub struct Plane {
    /// Title of the figure.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Lines in drawing order. The legend has the same order.
    pub series: Vec<Series>,
}

/// Method of drawing the lines of a figure.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Drawn {
    /// Lines, thinned to at most this number of points for each series.
    Lines(usize),
    /// The area that the lines cover.
    Traces,
}

impl Plane {
    /// Draws the figure in the default size.
    pub fn draw(&self, words: &Words) -> String {
        self.drawn(Drawn::Lines(LINE_LIMIT), SIZE, words, &[])
    }

    /// Draws long oscillating lines with six times the default limit of points.
    pub fn draw_long(&self, words: &Words) -> String {
        self.drawn(Drawn::Lines(6 * LINE_LIMIT), SIZE, words, &[])
    }

    /// Draws lines with many self-intersections as the area that they cover.
    pub fn draw_traces(&self, words: &Words) -> String {
        self.drawn(Drawn::Traces, SIZE, words, &[])
    }

    /// Draws the figure with the width and height `size`, px.
    pub fn draw_sized(&self, size: [f64; 2], words: &Words) -> String {
        self.drawn(Drawn::Lines(LINE_LIMIT), size, words, &[])
    }

    /// Draws the figure with the width and height `size`, px. `names` replace the labels of the series in the legend.
    pub fn draw_named(&self, names: &[String], size: [f64; 2], words: &Words) -> String {
        self.drawn(Drawn::Lines(LINE_LIMIT), size, words, names)
    }

    fn drawn(&self, how: Drawn, size: [f64; 2], words: &Words, names: &[String]) -> String {
        let [width, height] = size;
        let wanted = |length: f64| (6.0 * length / SIZE[0]).round() as usize;
        let (x_ticks, y_ticks) = (self.x.ticks(wanted(width), words), self.y.ticks(6, words));
        let widest = y_ticks.at.iter().map(|(_, label)| text_width(label, TICK)).fold(0.0, f64::max);
        let (left, right, top, bottom) = ((28.0 + widest).max(66.0), width - 14.0, 50.0, height - 44.0);
        let mut svg = Svg::new(width, height, &self.title);
        let at_x = |value: f64| left + self.x.place(value) * (right - left);
        let at_y = |value: f64| bottom - self.y.place(value) * (bottom - top);
        let ends = |axis: &Axis| format!("{:.6e} {:.6e} {}", axis.low, axis.high, axis.scale.name());
        svg.data("plane", &format!("{left:.1} {top:.1} {right:.1} {bottom:.1} {} {}", ends(&self.x), ends(&self.y)));
        svg.data("x", &self.x.label);
        svg.data("y", &self.y.label);

        let mark = |s: &Series| if matches!(s.marks, Marks::Dots | Marks::LargeDots) { Mark::Dot } else { Mark::Line };
        let label = |k: usize, series: &Series| names.get(k).map_or(series.label, String::as_str).to_owned();
        let labels: Vec<String> = self.series.iter().enumerate().map(|(k, series)| label(k, series)).collect();
        // A series with an empty name shares the legend entry of another series, so it gets no separate entry.
        let named = self.series.iter().zip(&labels).filter(|(_, label)| names.is_empty() || !label.is_empty());
        let legend: Vec<_> = named.map(|(series, label)| (series.role, label.as_str(), mark(series))).collect();
        heading(&mut svg, &self.title, left, &legend);

        let vertical = |value: f64| [[at_x(value), top], [at_x(value), bottom]];
        let horizontal = |value: f64| [[left, at_y(value)], [right, at_y(value)]];
        svg.open_group("grid-x");
        svg.grid(&x_ticks.at.iter().map(|(value, _)| vertical(*value)).collect::<Vec<_>>());
        svg.close_group();
        svg.open_group("grid-y");
        svg.grid(&y_ticks.at.iter().map(|(value, _)| horizontal(*value)).collect::<Vec<_>>());
        svg.close_group();
        let below = x_ticks.at.iter().map(|(value, label)| {
            let last = width - 0.5 * text_width(label, TICK) - 1.0;
            ([at_x(*value).min(last), bottom + 15.0], label.as_str())
        });
        svg.labels("ticks-x", TICK, Anchor::Middle, below);
        let beside = y_ticks.at.iter().map(|(value, label)| ([left - 6.0, at_y(*value) + 4.0], label.as_str()));
        svg.labels("ticks-y", TICK, Anchor::End, beside);
        svg.text([0.5 * (left + right), height - 10.0], &self.x.label, TextStyle::plain(LABEL, Anchor::Middle));
        let turned = TextStyle { turn: -90.0, ..TextStyle::plain(LABEL, Anchor::Middle) };
        svg.text([15.0, 0.5 * (top + bottom)], &self.y.label, turned);

        svg.open_area([left, top, right, bottom]);
        let mut zero = Vec::new();
        if self.x.low < 0.0 && self.x.high > 0.0 {
            zero.push(vertical(0.0));
        }
        if self.y.low < 0.0 && self.y.high > 0.0 {
            zero.push(horizontal(0.0));
        }
        svg.frame(&zero, 0.8);
        for series in &self.series {
            let lines: Vec<Vec<_>> =
                series.lines.iter().map(|line| line.iter().map(|[x, y]| [at_x(*x), at_y(*y)]).collect()).collect();
            match (how, series.marks) {
                (_, Marks::Dots) => lines.iter().for_each(|points| svg.points(series.role, points, 2.2)),
                (_, Marks::LargeDots) => lines.iter().for_each(|points| svg.points(series.role, points, 4.4)),
                (Drawn::Traces, _) => svg.trace(series.role, &lines, 1.2),
                (Drawn::Lines(limit), marks) => {
                    for points in &lines {
                        svg.path(series.role, points, limit / lines.len().max(1));
                        if marks == Marks::Both {
                            svg.points(series.role, points, 2.3);
                        }
                    }
                }
            }
        }
        svg.close_area();
        svg.frame(&[[[left, bottom], [right, bottom]], [[left, top], [left, bottom]]], 1.0);
        svg.finish()
    }
}

/// Mark of a series in the figure and in the legend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// A line.
    Line,
    /// Separate dots.
    Dot,
}

/// Distance of two lines of a legend, px.
const ROW: f64 = 16.0;

/// Draws the title and, below the title, the legend: a mark and a name for each series, all in one font size.
///
/// A legend that is too wide for one line is divided into several lines, and the figure becomes higher at its top. The last line is at the
/// same coordinates in all figures. A title that is too wide gets a smaller font.
pub fn heading(svg: &mut Svg, title: &str, left: f64, legend: &[(Role, &str, Mark)]) {
    let room = svg.width() - left - 4.0;
    let wide = |label: &str, size: f64| 25.0 + text_width(label, size);
    // The legend has a smaller font only if a single name is wider than the figure. All names then have the same smaller font.
    let longest = legend.iter().map(|(_, label, _)| text_width(label, LABEL)).fold(0.0, f64::max);
    let size = LABEL * ((room - 25.0) / longest).min(1.0);
    let mut rows: Vec<Vec<(f64, &(Role, &str, Mark))>> = vec![Vec::new()];
    let mut x = left;
    for entry in legend {
        let is_full = x > left && x + wide(entry.1, size) > left + room;
        if is_full {
            rows.push(Vec::new());
            x = left;
        }
        if let Some(row) = rows.last_mut() {
            row.push((x, entry));
        }
        x += wide(entry.1, size) + 16.0;
    }
    let above = ROW * (rows.len() - 1) as f64;
    svg.extend_above(above);
    let of_title = TITLE * (room / (BOLD * text_width(title, TITLE))).min(1.0);
    svg.text([left, 17.0 - above], title, TextStyle { bold: true, ..TextStyle::plain(of_title, Anchor::Start) });
    for (k, row) in rows.iter().enumerate() {
        let below = ROW * k as f64 - above;
        for (x, (role, label, mark)) in row {
            match mark {
                Mark::Line => svg.path(*role, &[[*x, 33.0 + below], [x + 20.0, 33.0 + below]], 2),
                Mark::Dot => svg.dot(*role, [x + 14.0, 33.0 + below], 3.4),
            }
            svg.text([x + 25.0, 37.0 + below], label, TextStyle::plain(size, Anchor::Start));
        }
    }
}

/// Ratio of the widths of bold and regular letters.
const BOLD: f64 = 1.08;

/// Estimates the width of a text of the font size `size`, px, in the widest common fonts (Verdana and DejaVu Sans). Chinese characters are
/// as wide as high. If the page has a narrower font, a small gap remains. An estimate from a narrow font would truncate labels.
pub fn text_width(text: &str, size: f64) -> f64 {
    let letter = |c: char| if ('\u{2e80}'..='\u{ffef}').contains(&c) { 1.02 } else { 0.64 };
    size * text.chars().map(letter).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::EN;

    #[test]
    fn an_axis_shows_all_values_and_never_collapses() {
        let axis = Axis::around("N", [-3.0, 9.0]);
        assert!(axis.place(-3.0) > 0.0 && axis.place(9.0) < 1.0);
        for values in [vec![], vec![0.0, 0.0], vec![1e6], vec![-1e-12]] {
            let axis = Axis::around("N", values.clone());
            assert!(axis.high > axis.low && !axis.ticks(5, &EN).at.is_empty(), "{values:?} {axis:?}");
        }
        let still = Axis::exactly("s", 2.0, 2.0);
        assert!(still.high > still.low);
    }

    #[test]
    fn a_long_legend_has_several_lines_of_one_size() {
        let drawn = |count: usize| {
            let names: Vec<String> = (0..count).map(|k| format!("{}00 mm/s", k + 1)).collect();
            let series = |_| Series { role: Role::Model, label: "", lines: vec![vec![[0.0, 1.0]]], marks: Marks::Line };
            let plane = Plane {
                title: "t".into(),
                x: Axis::around("x", [0.0, 1.0]),
                y: Axis::around("y", [0.0, 1.0]),
                series: (0..count).map(series).collect(),
            };
            plane.draw_named(&names, SIZE, &EN)
        };
        let attribute = |element: &str, name: &str| -> f64 {
            element.split(&format!(" {name}=\"")).nth(1).and_then(|rest| rest.split('"').next()?.parse().ok()).unwrap()
        };
        for (count, rows) in [(2, 1), (6, 2), (14, 5)] {
            let text = drawn(count);
            let names: Vec<&str> = text.split("<text").filter(|text| text.contains(" mm/s</text>")).collect();
            assert_eq!(names.len(), count);
            assert!(names.iter().all(|name| attribute(name, "font-size") == LABEL), "{names:?}");
            let lines: std::collections::BTreeSet<i64> = names.iter().map(|name| attribute(name, "y") as i64).collect();
            assert_eq!(lines.len(), rows, "{lines:?}");
            // The document contains the highest line, and the last line is above the plotted area.
            let height = ROW * (rows - 1) as f64;
            assert!(text.contains(&format!("viewBox=\"0 {} ", if rows == 1 { 0.0 } else { -height })), "{text}");
            assert_eq!(attribute(&text, "height"), SIZE[1] + height);
            for name in names {
                let label = name.split('>').nth(1).and_then(|rest| rest.split('<').next()).unwrap();
                assert!(attribute(name, "x") + text_width(label, LABEL) <= SIZE[0]);
            }
        }
    }

    #[test]
    fn the_larger_value_is_drawn_further_up_and_right() {
        let series =
            Series { role: Role::Model, label: "model", lines: vec![vec![[0.0, 0.0], [1.0, 1.0]]], marks: Marks::Dots };
        let text = Plane {
            title: "t".into(),
            x: Axis::around("x", [0.0, 1.0]),
            y: Axis::around("y", [0.0, 1.0]),
            series: vec![series],
        }
        .draw(&EN);
        let dots = text.rsplit("stroke-linecap=\"round\" d=\"").next().unwrap().split('"').next().unwrap();
        let dots: Vec<f64> =
            dots.split(['M', ' ', 'h']).filter(|p| !p.is_empty()).map(|p| p.parse().unwrap()).collect();
        let [x0, y0, _, x1, y1, _] = dots[..] else { panic!("{dots:?}") };
        assert!(x1 > x0 && y1 < y0, "{dots:?}");
    }
}
