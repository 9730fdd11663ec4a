//! Colors of the figures.
//!
//! Deuteranopes and protanopes can distinguish the three hues of the forces: blue, vermilion and bluish green. The hues follow Okabe & Ito,
//! *Color Universal Design*, 2008. The green line is also dashed, so that it stays distinct in a gray print.

use std::fmt::Write as _;

/// Role of a mark in a figure, such as the source of a plotted force. It selects color, line width and dashes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// The rig's measurement.
    Measured,
    /// The full model.
    Model,
    /// The force–velocity curve alone.
    FvOnly,
    /// The model before its improvement.
    Before,
    /// Projections and other background marks.
    Shadow,
    /// Limits of a specification.
    Limit,
    /// One of many dampers, by its index. The eight hues repeat from index 8 on.
    Group(u8),
}

/// Colors of up to eight dampers, on light and on dark background. The first five hues follow Okabe & Ito; violet, olive and brown are
/// additions.
const GROUPS: [[&str; 2]; 8] = [
    ["#d43d0f", "#ff7f52"],
    ["#0067a5", "#5cb8f2"],
    ["#009e73", "#2fd3a3"],
    ["#b3508a", "#e39ac4"],
    ["#b07c00", "#f0b93a"],
    ["#6a3d9a", "#c3a5e8"],
    ["#4f6b00", "#b5cf5a"],
    ["#7a5230", "#d3a57e"],
];
/// CSS classes of the hues of many dampers.
const GROUP_CLASSES: [&str; 8] = ["g0", "g1", "g2", "g3", "g4", "g5", "g6", "g7"];

/// All roles except `Group`, for the page's style sheet.
const ROLES: [Role; 6] = [Role::Measured, Role::Model, Role::FvOnly, Role::Before, Role::Shadow, Role::Limit];

impl Role {
    /// Returns the CSS class of the role in SVG and page.
    pub fn class(self) -> &'static str {
        match self {
            Self::Measured => "measured",
            Self::Model => "model",
            Self::FvOnly => "fv-only",
            Self::Before => "before",
            Self::Shadow => "shadow",
            Self::Limit => "limit",
            Self::Group(k) => GROUP_CLASSES[usize::from(k) % GROUP_CLASSES.len()],
        }
    }

    /// Returns the color on a light background.
    pub fn light(self) -> &'static str {
        match self {
            Self::Measured => "#0067a5",
            Self::Model => "#d43d0f",
            Self::FvOnly => "#009e73",
            Self::Before => "#767b80",
            Self::Shadow => "#c3c9cf",
            Self::Limit => "#6a3d9a",
            Self::Group(k) => GROUPS[usize::from(k) % GROUPS.len()][0],
        }
    }

    /// Returns the color on a dark background.
    fn dark(self) -> &'static str {
        match self {
            Self::Measured => "#5cb8f2",
            Self::Model => "#ff7f52",
            Self::FvOnly => "#2fd3a3",
            Self::Before => "#a9b0b6",
            Self::Shadow => "#4b535b",
            Self::Limit => "#c3a5e8",
            Self::Group(k) => GROUPS[usize::from(k) % GROUPS.len()][1],
        }
    }

    /// Returns the line width, px.
    pub fn width(self) -> f64 {
        match self {
            // The line of the measurement is wide, so that both its edges stay visible if the model's line coincides with it.
            Self::Measured => 2.8,
            Self::Model => 1.1,
            Self::FvOnly | Self::Before => 1.3,
            Self::Shadow => 0.8,
            Self::Limit => 1.6,
            Self::Group(_) => 1.5,
        }
    }

    /// Returns the dash pattern of the role's lines, or `None` for solid lines.
    pub fn dash(self) -> Option<&'static str> {
        matches!(self, Self::FvOnly | Self::Before).then_some("5 2.5")
    }
}

/// Text on a light background.
pub const INK: &str = "#22272c";
/// Secondary text and frame.
pub const FAINT_INK: &str = "#5d666e";
/// Grid lines.
pub const GRID: &str = "#e3e6e9";
/// Background of a figure.
pub const PAPER: &str = "#ffffff";

/// Returns style rules that recolor inline figures if the reader prefers a dark page. Printed figures stay light.
pub fn page_css() -> String {
    let mut css = String::from("@media screen and (prefers-color-scheme: dark) {\n");
    for role in ROLES.into_iter().chain((0..GROUPS.len() as u8).map(Role::Group)) {
        let (class, colour) = (role.class(), role.dark());
        let _ = writeln!(css, "  svg .l.{class} {{ stroke: {colour}; }}\n  svg .p.{class} {{ fill: {colour}; }}");
    }
    css.push_str(concat!(
        "  svg .paper { fill: #1b1f23; }\n",
        "  svg text.ink { fill: #e6e9ec; }\n",
        "  svg .faint { fill: #a4adb5; }\n",
        "  svg .l.grid { stroke: #2e343a; }\n",
        "  svg .l.frame { stroke: #7d868e; }\n",
        "}\n",
    ));
    css
}

/// Returns the fill of a heat-map cell for an error in percent, and whether the text in the cell is black (`true`) or white. The color has
/// one hue and becomes deeper with the logarithm of the error from 0.5 % to 50 %.
pub fn heat(percent: f64) -> (String, bool) {
    const PALE: [f64; 3] = [253.0, 244.0, 232.0];
    const MIDDLE: [f64; 3] = [240.0, 140.0, 70.0];
    const DEEP: [f64; 3] = [120.0, 24.0, 30.0];
    let place = (libm::log10(percent.max(1e-9) / 0.5) / 2.0).clamp(0.0, 1.0);
    let (from, to, part) = if place < 0.5 { (PALE, MIDDLE, 2.0 * place) } else { (MIDDLE, DEEP, 2.0 * place - 1.0) };
    let mix = |i: usize| (from[i] + part * (to[i] - from[i])).round() as u8;
    (format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2)), place < 0.72)
}

/// Returns the fill of a map cell for a signed value between −1 and 1, the ends of the color scale. Positive values are orange, negative
/// values purple, zero is near white. No plotted force has one of these two hues, and color-blind readers can distinguish them.
pub fn signed(place: f64) -> String {
    const ZERO: [f64; 3] = [247.0, 247.0, 247.0];
    const ABOVE: [[f64; 3]; 2] = [[244.0, 165.0, 85.0], [166.0, 76.0, 4.0]];
    const BELOW: [[f64; 3]; 2] = [[167.0, 155.0, 205.0], [71.0, 34.0, 128.0]];
    let [near, far] = if place >= 0.0 { ABOVE } else { BELOW };
    let size = place.abs().min(1.0);
    let (from, to, part) = if size < 0.5 { (ZERO, near, 2.0 * size) } else { (near, far, 2.0 * size - 1.0) };
    let mix = |i: usize| (from[i] + part * (to[i] - from[i])).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Converts a `#rrggbb` color to linear-light RGB.
    fn linear(colour: &str) -> [f64; 3] {
        [1, 3, 5].map(|at| {
            let value = f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap()) / 255.0;
            if value <= 0.04045 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
        })
    }

    /// Converts linear-light RGB to CIE Lab, D65.
    fn lab(rgb: [f64; 3]) -> [f64; 3] {
        let dot = |row: [f64; 3]| row.iter().zip(rgb).map(|(a, b)| a * b).sum::<f64>();
        let f = |t: f64| {
            if t > 0.008856 { libm::cbrt(t) } else { 7.787 * t + 16.0 / 116.0 }
        };
        let x = f(dot([0.4124, 0.3576, 0.1805]) / 0.95047);
        let y = f(dot([0.2126, 0.7152, 0.0722]));
        let z = f(dot([0.0193, 0.1192, 0.9505]) / 1.08883);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    #[test]
    fn the_forces_stay_apart_without_red_or_green_cones() {
        // Matrices from linear RGB to the perceived linear RGB (Machado, Oliveira & Fernandes 2009, severity 1): normal vision, protanopia,
        // deuteranopia.
        let sights = [
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
            [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
        ];
        // No figure contains both the FV curve alone and a model before its improvement, so these two colors are not compared.
        let figures = [[Role::Measured, Role::Model, Role::FvOnly], [Role::Measured, Role::Model, Role::Before]];
        for sight in sights {
            let seen = |colour: &str| {
                let rgb = linear(colour);
                lab(sight.map(|row| row.iter().zip(rgb).map(|(a, b)| a * b).sum::<f64>().clamp(0.0, 1.0)))
            };
            for (shade, roles) in [Role::light, Role::dark].into_iter().flat_map(|s| figures.map(|roles| (s, roles))) {
                for (i, a) in roles.iter().enumerate() {
                    for b in &roles[i + 1..] {
                        let (p, q) = (seen(shade(*a)), seen(shade(*b)));
                        let distance = p.iter().zip(q).map(|(p, q)| (p - q).powi(2)).sum::<f64>().sqrt();
                        assert!(distance > 20.0, "{a:?} {b:?}: {distance}");
                    }
                }
            }
        }
    }

    #[test]
    fn every_heat_colour_carries_readable_text() {
        for step in 0..=60 {
            let (fill, dark_text) = heat(0.3 * libm::pow(10f64, f64::from(step) / 25.0));
            let [r, g, b] = linear(&fill);
            let luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
            let ink = if dark_text { 0.0 } else { 1.0 };
            let contrast = (luminance.max(ink) + 0.05) / (luminance.min(ink) + 0.05);
            assert!(contrast > 4.5, "{fill} {dark_text}: {contrast}");
        }
    }
}
