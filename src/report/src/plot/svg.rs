//! The SVG writer. Each mark has a class, by which the page recolors it, and a color for a light background in all other viewers.

use super::palette::{FAINT_INK, GRID, INK, PAPER, Role};
use super::simplify::{Point, Thinned, simplify};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Largest stroke width, px, of a noisy line (a line with [`Thinned::rough`] set).
const NOISY: f64 = 0.6;

/// Alignment of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// The text starts at its reference point.
    Start,
    /// The text is centered on its reference point.
    Middle,
    /// The text ends at its reference point.
    End,
}

/// Style of a text.
#[derive(Debug, Clone, Copy)]
pub struct TextStyle {
    /// Font size, px.
    pub size: f64,
    /// Alignment of the text at its point.
    pub anchor: Anchor,
    /// Rotation of the text about its reference point, degrees clockwise.
    pub turn: f64,
    /// Whether the text is bold.
    pub bold: bool,
    /// Whether the text is secondary, such as a tick label, and drawn in a paler color.
    pub faint: bool,
}

impl TextStyle {
    /// Returns the style of primary text.
    pub fn plain(size: f64, anchor: Anchor) -> Self {
        Self { size, anchor, turn: 0.0, bold: false, faint: false }
    }

    /// Returns the style of secondary text: tick labels, remarks.
    pub fn faint(size: f64, anchor: Anchor) -> Self {
        Self { faint: true, ..Self::plain(size, anchor) }
    }
}

/// An SVG document under construction.
#[derive(Debug)]
pub struct Svg {
    body: String,
    /// Attributes of the `svg` element in addition to its size.
    about: String,
    width: f64,
    height: f64,
    /// Height of the part above the coordinate zero, px.
    above: f64,
    title: String,
}

impl Svg {
    /// Starts a document of a size in px. Screen readers read `title`.
    pub fn new(width: f64, height: f64, title: &str) -> Self {
        Self { body: String::new(), about: String::new(), width, height, above: 0.0, title: title.to_owned() }
    }

    /// Returns the complete document.
    pub fn finish(self) -> String {
        let (top, width, height) = (px(-self.above), px(self.width), px(self.height + self.above));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 {top} {width} {height}\" width=\"{width}\" \
             height=\"{height}\"{} role=\"img\" font-family=\"system-ui, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, \
             sans-serif\"><title>{}</title><rect class=\"paper\" y=\"{top}\" width=\"{width}\" height=\"{height}\" \
             fill=\"{PAPER}\"/>{}</svg>",
            self.about,
            escape(&self.title),
            self.body,
        )
    }

    /// Extends the document at its top. The marks keep their coordinates, so the new part has negative ones.
    pub fn extend_above(&mut self, by: f64) {
        self.above += by;
    }

    /// Returns the width of the document, px.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Adds an attribute of the whole document for the page's script.
    pub fn data(&mut self, name: &str, value: &str) {
        let _ = write!(self.about, " data-{name}=\"{}\"", escape(value));
    }

    /// Begins an area (left, top, right, bottom) that clips its marks at its edges. The page can zoom in the area.
    pub fn open_area(&mut self, edges: [f64; 4]) {
        let [left, top, right, bottom] = edges;
        let [x, y, width, height] = [left, top, right - left, bottom - top].map(px);
        let _ = write!(
            self.body,
            "<svg class=\"area\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" viewBox=\"{x} {y} {width} \
             {height}\" preserveAspectRatio=\"none\">"
        );
    }

    /// Ends the area begun by [`Svg::open_area`].
    pub fn close_area(&mut self) {
        self.body.push_str("</svg>");
    }

    /// Begins a group that the page's script finds by its class.
    pub fn open_group(&mut self, class: &str) {
        let _ = write!(self.body, "<g class=\"{class}\">");
    }

    /// Ends the group begun by [`Svg::open_group`].
    pub fn close_group(&mut self) {
        self.body.push_str("</g>");
    }

    /// Draws round points of a role with a radius in px. They are zero-length lines with round ends, which keep their size when the reader
    /// zooms.
    pub fn points(&mut self, role: Role, at: &[Point], radius: f64) {
        if at.is_empty() {
            return;
        }
        let data: String = at.iter().map(|[x, y]| format!("M{} {}h0", px(*x), px(*y))).collect();
        let _ = write!(
            self.body,
            "<path class=\"l {}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" d=\"{data}\"/>",
            role.class(),
            role.light(),
            px(2.0 * radius),
        );
    }

    /// Draws a line of a role through points, thinned to at most `limit` points. A noisy line is thin, so that other lines inside it stay
    /// visible.
    pub fn path(&mut self, role: Role, points: &[Point], limit: usize) {
        let Thinned { points, rough } = simplify(points, limit);
        if points.len() < 2 {
            return;
        }
        let _ = write!(
            self.body,
            "<path class=\"l {}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
            role.class(),
            role.light(),
            px(if rough { role.width().min(NOISY) } else { role.width() }),
        );
        if let Some(dash) = role.dash().filter(|_| !rough) {
            let _ = write!(self.body, " stroke-dasharray=\"{dash}\"");
        }
        let _ = write!(self.body, " d=\"{}\"/>", path_data(&points));
    }

    /// Draws the area that lines of a role cover, as small squares of the edge length `square`, px. For lines with hundreds of
    /// self-intersections, the file size then depends only on this area, and thinning is not needed.
    pub fn trace(&mut self, role: Role, lines: &[Vec<Point>], square: f64) {
        let bars = bars(lines, square);
        if bars.is_empty() {
            return;
        }
        let _ = write!(
            self.body,
            "<path class=\"l t {}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" d=\"",
            role.class(),
            role.light(),
            px(square),
        );
        for (row, from, to) in bars {
            let [x, y] = [from as f64 * square, (row as f64 + 0.5) * square].map(px);
            let _ = write!(self.body, "M{x} {y}h{}", px((to - from) as f64 * square));
        }
        self.body.push_str("\"/>");
    }

    /// Draws several straight lines of the grid.
    pub fn grid(&mut self, lines: &[[Point; 2]]) {
        self.lines("grid", GRID, 1.0, lines);
    }

    /// Draws several straight lines of the frame or an axis.
    pub fn frame(&mut self, lines: &[[Point; 2]], width: f64) {
        self.lines("frame", FAINT_INK, width, lines);
    }

    fn lines(&mut self, class: &str, colour: &str, width: f64, lines: &[[Point; 2]]) {
        if lines.is_empty() {
            return;
        }
        let data: String = lines.iter().map(|line| path_data(line)).collect();
        let width = px(width);
        let _ = write!(
            self.body,
            "<path class=\"l {class}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" d=\"{data}\"/>"
        );
    }

    /// Draws a filled dot of a role.
    pub fn dot(&mut self, role: Role, at: Point, radius: f64) {
        self.dot_saying(role, at, radius, "");
    }

    /// Draws a filled dot that shows the text `value` under the cursor.
    pub fn dot_saying(&mut self, role: Role, at: Point, radius: f64, value: &str) {
        let (class, colour) = (role.class(), role.light());
        let _ = write!(
            self.body,
            "<circle class=\"p {class}\" fill=\"{colour}\" cx=\"{}\" cy=\"{}\" r=\"{}\"",
            px(at[0]),
            px(at[1]),
            px(radius),
        );
        if value.is_empty() {
            self.body.push_str("/>");
        } else {
            let _ = write!(self.body, "><title>{}</title></circle>", escape(value));
        }
    }

    /// Draws a filled rectangle of a role that shows the text `value` under the cursor.
    pub fn bar(&mut self, role: Role, corner: Point, size: Point, value: &str) {
        let (class, color) = (role.class(), role.light());
        let ([x, y], [width, height]) = (corner.map(px), size.map(px));
        let _ = write!(
            self.body,
            "<rect class=\"p {class}\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"{color}\""
        );
        if value.is_empty() {
            self.body.push_str("/>");
        } else {
            let _ = write!(self.body, "><title>{}</title></rect>", escape(value));
        }
    }

    /// Draws a filled rectangle of a heat map. Its color stays the same on a dark page.
    pub fn cell(&mut self, corner: Point, size: Point, fill: &str) {
        let [x, y] = corner.map(px);
        let [width, height] = size.map(px);
        let _ = write!(
            self.body,
            "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" rx=\"2\" fill=\"{fill}\"/>"
        );
    }

    /// Draws one of many seamless cells of a map. Its color stays the same on a dark page.
    pub fn tile(&mut self, corner: Point, size: Point, fill: &str) {
        let [x, y] = corner.map(px);
        // The tile is slightly larger than the cell, so that rounding leaves no gap.
        let [width, height] = size.map(|s| px(s + 0.3));
        let _ = write!(self.body, "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"{fill}\"/>");
    }

    /// Embeds another complete SVG document with its upper left corner at `corner`.
    pub fn inside(&mut self, corner: Point, document: &str) {
        let place = format!("<svg x=\"{}\" y=\"{}\" ", px(corner[0]), px(corner[1]));
        self.body.push_str(&document.replacen("<svg ", &place, 1));
    }

    /// Draws a text.
    pub fn text(&mut self, at: Point, text: &str, style: TextStyle) {
        let (class, colour) = if style.faint { ("faint", FAINT_INK) } else { ("ink", INK) };
        self.text_in(at, text, style, class, colour);
    }

    /// Draws many secondary texts of one kind in a group with a class for the page's script. The group contains their common attributes.
    pub fn labels<'t>(
        &mut self,
        class: &str,
        size: f64,
        anchor: Anchor,
        labels: impl Iterator<Item = (Point, &'t str)>,
    ) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let _ = write!(
            self.body,
            "<g class=\"{class} faint\" font-size=\"{}\" fill=\"{FAINT_INK}\" text-anchor=\"{anchor}\">",
            px(size)
        );
        for (at, label) in labels {
            let [x, y] = at.map(px);
            let _ = write!(self.body, "<text x=\"{x}\" y=\"{y}\">{}</text>", escape(label));
        }
        self.body.push_str("</g>");
    }

    /// Draws a text on a [`Svg::cell`]. The text is black or white to match the fill, and stays so on a dark page.
    pub fn cell_text(&mut self, at: Point, text: &str, style: TextStyle, dark: bool) {
        self.text_in(at, text, style, "fixed", if dark { "#000000" } else { "#ffffff" });
    }

    fn text_in(&mut self, at: Point, text: &str, style: TextStyle, class: &str, colour: &str) {
        let [x, y] = at.map(px);
        let _ = write!(
            self.body,
            "<text class=\"{class}\" x=\"{x}\" y=\"{y}\" font-size=\"{}\" fill=\"{colour}\"",
            px(style.size)
        );
        match style.anchor {
            Anchor::Start => {}
            Anchor::Middle => self.body.push_str(" text-anchor=\"middle\""),
            Anchor::End => self.body.push_str(" text-anchor=\"end\""),
        }
        if style.bold {
            self.body.push_str(" font-weight=\"600\"");
        }
        if style.turn != 0.0 {
            let _ = write!(self.body, " transform=\"rotate({} {x} {y})\"", px(style.turn));
        }
        let _ = write!(self.body, ">{}</text>", escape(text));
    }
}

/// Returns the squares of the edge length `square`, px, that lines cross. Adjacent squares of a row are merged to a bar: row, first column,
/// column after the last.
fn bars(lines: &[Vec<Point>], square: f64) -> Vec<(i64, i64, i64)> {
    let mut passed = BTreeSet::new();
    for line in lines {
        let mut last: Option<Point> = None;
        for point in line {
            let [x, y] = point.map(|p| p / square);
            let [from_x, from_y] = last.unwrap_or([x, y]);
            // Points at most half a square apart on the segment leave no gap between the marked squares.
            let parts = (2.0 * (x - from_x).abs().max((y - from_y).abs())).ceil().max(1.0);
            for k in 0..=parts as u32 {
                let part = f64::from(k) / parts;
                let at = [from_x + part * (x - from_x), from_y + part * (y - from_y)];
                passed.insert((at[1].floor() as i64, at[0].floor() as i64));
            }
            last = Some([x, y]);
        }
    }
    let mut bars: Vec<(i64, i64, i64)> = Vec::new();
    for (row, column) in passed {
        match bars.last_mut() {
            Some(bar) if (bar.0, bar.2) == (row, column) => bar.2 += 1,
            _ => bars.push((row, column, column + 1)),
        }
    }
    bars
}

/// Formats SVG path data through points, rounded to a tenth of a pixel. Relative steps make the data shorter. Each step starts from the
/// rounded position, so that rounding errors do not accumulate.
fn path_data(points: &[Point]) -> String {
    let tenths = |value: f64| (value * 10.0).round() as i64;
    let mut data = String::with_capacity(8 * points.len());
    let mut last = [0, 0];
    for (i, point) in points.iter().enumerate() {
        let here = point.map(tenths);
        let step = [here[0] - last[0], here[1] - last[1]];
        if i > 0 && step == [0, 0] {
            continue;
        }
        data.push_str(match i {
            0 => "M",
            1 => "l",
            _ if step[0] >= 0 => " ",
            _ => "",
        });
        push_tenths(&mut data, step[0]);
        if step[1] >= 0 {
            data.push(' ');
        }
        push_tenths(&mut data, step[1]);
        last = here;
    }
    data
}

/// Writes an integer number of tenths as the shortest decimal.
fn push_tenths(into: &mut String, tenths: i64) {
    let sign = if tenths < 0 { "-" } else { "" };
    let (whole, part) = (tenths.abs() / 10, tenths.abs() % 10);
    let _ = match (whole, part) {
        (whole, 0) => write!(into, "{sign}{whole}"),
        (0, part) => write!(into, "{sign}.{part}"),
        (whole, part) => write!(into, "{sign}{whole}.{part}"),
    };
}

/// Formats a coordinate to a tenth of a pixel.
fn px(value: f64) -> String {
    let mut text = String::new();
    push_tenths(&mut text, (value * 10.0).round() as i64);
    text
}

/// Escapes text for XML and HTML, including attributes. Removes control characters, which XML forbids.
pub fn escape(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            '\n' | '\t' => safe.push(character),
            other if other.is_control() => {}
            other => safe.push(other),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trace_is_every_square_that_a_line_passes_once() {
        let line = vec![[0.5, 0.5], [8.5, 0.5], [0.5, 0.5], [0.5, 4.5]];
        assert_eq!(bars(&[line], 2.0), [(0, 0, 5), (1, 0, 1), (2, 0, 1)]);
        assert_eq!(bars(&[vec![[3.0, 3.0]]], 2.0), [(1, 1, 2)]);
        assert!(bars(&[], 2.0).is_empty());
    }

    #[test]
    fn path_data_reads_back_to_a_tenth_of_a_pixel() {
        let points = [[10.04, 20.0], [10.31, 19.5], [9.0, 19.54], [9.0, 19.54], [400.26, 0.0]];
        let data = path_data(&points);
        assert_eq!(data, "M10 20l.3-.5-1.3 0 391.3-19.5");
    }

    #[test]
    fn names_cannot_break_out_of_the_document() {
        let mut svg = Svg::new(10.0, 10.0, "</title><script>");
        svg.text([0.0, 0.0], "a<b & \"c\"\u{1}", TextStyle::plain(10.0, Anchor::End));
        let text = svg.finish();
        assert!(text.contains("&lt;/title&gt;&lt;script&gt;") && !text.contains("<script>"));
        assert!(text.contains(">a&lt;b &amp; &quot;c&quot;</text>"));
    }

    #[test]
    fn a_path_of_one_place_is_not_drawn() {
        let mut svg = Svg::new(10.0, 10.0, "");
        svg.path(Role::Model, &[[1.0, 1.0]], 10);
        assert!(!svg.finish().contains("<path"));
    }
}
