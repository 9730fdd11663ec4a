//! Where the lines and numbers of a plot's axes stand.
//!
//! At 1, 2 or 5 times a power of ten, so that a plot of any width has numbers to read.
//!
//! Steps of ten alone leave a narrow plot of ±25 mm with nothing but its zero.

use crate::words::Words;
use egui_plot::{AxisHints, GridInput, GridMark, Plot};
use std::cell::Cell;
use std::rc::Rc;

/// Distance of two numbers along the lower axis, in the least distance of two grid lines (8 px in egui_plot).
///
/// Five letters have room, and longer numbers get more.
const ACROSS: f64 = 5.5;
/// Distances, px, between which the numbers of the lower axis come up.
///
/// Egui_plot's own 60 to 80 leave a window of 1280 px with zeros alone.
const COME_UP: std::ops::RangeInclusive<f32> = 34.0..=43.0;
/// Distances of the numbers of the upright axis, where a number needs a line's height alone: below 30 px they fade.
const UPWARDS: f64 = 4.0;

/// Width of a digit in the font of the axes, px; a little more than the widest one has.
const DIGIT: f64 = 7.5;
/// Most decimals of a label: a double has no more of a number of size one.
const MOST_DECIMALS: usize = 15;

/// Gives a plot its two axes: their labels, and grid lines whose numbers all have the decimals that their step needs.
pub fn with_axes<'a>(plot: Plot<'a>, lower: String, left: String, w: &'static Words) -> Plot<'a> {
    let steps = [Rc::new(Cell::new(0.0)), Rc::new(Cell::new(0.0))];
    let [x, y] = steps.clone();
    let [x_step, y_step] = steps;
    // The plot asks for the lines before it writes their numbers.
    let lower = AxisHints::new_x().label(lower).label_spacing(COME_UP);
    plot.custom_x_axes(vec![lower.formatter(move |mark, _| label(&mark, x_step.get(), w))])
        .y_axis_label(left)
        .y_axis_formatter(move |mark, _| label(&mark, y_step.get(), w))
        .y_axis_min_width(54.0)
        .x_grid_spacer(move |input| {
            let apart = room_for_numbers(&input, ACROSS);
            x.set(step_of(&input, apart));
            marks(input, apart)
        })
        .y_grid_spacer(move |input| {
            y.set(step_of(&input, UPWARDS));
            marks(input, UPWARDS)
        })
}

/// The number of a grid line, where it has one: lines between the numbers have none, however far apart they are.
fn label(mark: &GridMark, step: f64, w: &Words) -> String {
    // A hair of slack for a step that was computed in another way.
    if mark.step_size < 0.99 * step { String::new() } else { number(mark.value, decimals_of(step), w) }
}

/// A number on an axis; zero has no sign.
fn number(value: f64, decimals: usize, w: &Words) -> String {
    w.fixed(if value == 0.0 { 0.0 } else { value }, decimals)
}

/// Decimals that tell two neighbors apart whose distance is `step`.
fn decimals_of(step: f64) -> usize {
    if !(step.is_finite() && step > 0.0) {
        return 0;
    }
    // Rounded upwards, since 0.05 has two decimals; the logarithm of an exact power of ten may come out a hair beside it.
    ((-libm::log10(step) - 1e-9).ceil().max(0.0) as usize).min(MOST_DECIMALS)
}

/// Distance of two numbers, in the least distance of two grid lines, at which the longest of them has room.
fn room_for_numbers(input: &GridInput, least: f64) -> f64 {
    let largest = input.bounds.0.abs().max(input.bounds.1.abs()).max(1.0);
    let digits = 2.0 + libm::log10(largest).floor().max(0.0);
    let mut apart = least;
    // A longer distance never needs more decimals, so this ends where the number fits.
    for _ in 0..4 {
        let decimals = decimals_of(step_of(input, apart)) as f64;
        let letters = digits + if decimals > 0.0 { decimals + 0.5 } else { 0.0 };
        apart = apart.max(letters * DIGIT / 8.0);
    }
    apart
}

/// Distance of two numbers of an axis.
fn step_of(input: &GridInput, apart: f64) -> f64 {
    steps(input.base_step_size * apart)[1]
}

/// The lines of an axis whose numbers lie at least `apart` of the least distance from each other.
fn marks(input: GridInput, apart: f64) -> Vec<GridMark> {
    let base = input.base_step_size;
    if !(base.is_normal() && input.bounds.0.is_finite() && input.bounds.1.is_finite()) {
        return Vec::new();
    }
    egui_plot::uniform_grid_spacer(move |input| steps(input.base_step_size * apart))(input)
}

/// Steps of the fine lines, of those with numbers, and of every tenth of these.
fn steps(least: f64) -> [f64; 3] {
    let decade = libm::pow(10f64, libm::log10(least.abs()).floor());
    // A hair of slack: the logarithm of an exact power of ten may come out below it.
    let (step, parts) = [(1.0, 5.0), (2.0, 4.0), (5.0, 5.0), (10.0, 5.0)]
        .map(|(of, parts)| (of * decade, parts))
        .into_iter()
        .find(|(step, _)| *step >= least.abs() * (1.0 - 1e-9))
        .unwrap_or((10.0 * decade, 5.0));
    [step / parts, step, 10.0 * step]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{Language, texts};

    /// Numbers that an axis shows: those whose step is wide enough on the screen.
    fn numbers(bounds: (f64, f64), pixels: f64, apart: f64, fades: f64) -> Vec<f64> {
        let per_pixel = (bounds.1 - bounds.0) / pixels;
        let all = marks(GridInput { bounds, base_step_size: 8.0 * per_pixel }, apart);
        all.iter().filter(|m| m.step_size / per_pixel >= fades).map(|m| m.value).collect()
    }

    #[test]
    fn a_plot_of_any_width_and_range_has_numbers_and_not_too_many() {
        for pixels in [240.0, 320.0, 517.0, 900.0] {
            for range in [0.004, 0.05, 0.7, 1.3, 6.0, 52.0, 3.1e4] {
                for middle in [0.0, 0.3 * range] {
                    let fades = f64::from(*COME_UP.end());
                    let shown = numbers((middle - 0.5 * range, middle + 0.5 * range), pixels, ACROSS, fades);
                    assert!(shown.len() >= 2, "{range} over {pixels} px: {shown:?}");
                    assert!(shown.len() as f64 <= pixels / fades + 1.0, "{range} over {pixels} px: {shown:?}");
                }
            }
        }
    }

    #[test]
    fn fifty_millimetres_in_a_narrow_plot() {
        let shown = |bounds, pixels| numbers(bounds, pixels, ACROSS, 43.0);
        assert_eq!(shown((-26.0, 26.0), 320.0), [-20.0, -10.0, 0.0, 10.0, 20.0]);
        assert_eq!(shown((0.0, 100.0), 800.0)[..4], [0.0, 10.0, 20.0, 30.0]);
        // Peak velocities in a window of 1280 px.
        assert_eq!(shown((-1.9, 1.9), 277.0), [-1.0, 0.0, 1.0]);
    }

    /// What an axis writes at its numbers, by the functions that the plot calls, and the values there.
    fn labels(bounds: (f64, f64), pixels: f64, least: f64, fades: f64) -> Vec<(f64, String)> {
        let per_pixel = (bounds.1 - bounds.0) / pixels;
        let input = || GridInput { bounds, base_step_size: 8.0 * per_pixel };
        let apart = if least == ACROSS { room_for_numbers(&input(), least) } else { least };
        let step = step_of(&input(), apart);
        let shown = marks(input(), apart).into_iter().filter(|m| m.step_size / per_pixel >= fades);
        let all = shown.map(|m| (m.value, label(&m, step, texts(Language::English))));
        all.filter(|(_, label)| !label.is_empty()).collect()
    }

    #[test]
    fn every_label_of_every_step_at_every_zoom_says_where_it_stands() {
        for exponent in -9..8 {
            for part in 1..100 {
                let range = f64::from(part) * libm::pow(10.0, f64::from(exponent)) / 7.3;
                for middle in [0.0, 0.3 * range, -17.0 * range] {
                    for (pixels, least, fades) in [(240.0, ACROSS, 43.0), (700.0, ACROSS, 43.0), (300.0, UPWARDS, 30.0)]
                    {
                        let shown = labels((middle - 0.5 * range, middle + 0.5 * range), pixels, least, fades);
                        let case = format!("{range} around {middle} over {pixels} px: {shown:?}");
                        assert!(!shown.is_empty(), "{case}");
                        let step = shown.windows(2).map(|w| w[1].0 - w[0].0).fold(range, f64::min);
                        for (value, label) in &shown {
                            let read: f64 = label.replace('\u{2212}', "-").parse().unwrap();
                            assert!((read - value).abs() <= 1e-6 * step, "{label} at {value}; {case}");
                            assert!(!(*value == 0.0 && label.starts_with(['-', '\u{2212}'])), "{case}");
                        }
                        let decimals = |label: &str| label.split_once('.').map_or(0, |(_, d)| d.len());
                        assert!(shown.iter().all(|(_, l)| decimals(l) == decimals(&shown[0].1)), "{case}");
                    }
                }
            }
        }
    }

    #[test]
    fn steps_of_one_two_and_five_have_their_decimals() {
        for (step, decimals) in
            [(0.05, 2), (0.5, 1), (0.2, 1), (0.1, 1), (0.02, 2), (0.01, 2), (0.005, 3), (0.001, 3), (1.0, 0), (50.0, 0)]
        {
            assert_eq!(decimals_of(step), decimals, "{step}");
        }
        let shown = labels((-2.4, 2.4), 600.0, ACROSS, 43.0);
        let text: Vec<&str> = shown.iter().map(|(_, label)| label.as_str()).collect();
        let minus = |t: &str| t.replace('\u{2212}', "-");
        let text: Vec<String> = text.into_iter().map(minus).collect();
        assert_eq!(text, ["-2.0", "-1.5", "-1.0", "-0.5", "0.0", "0.5", "1.0", "1.5", "2.0"]);
    }

    #[test]
    fn a_plot_without_extent_has_no_lines() {
        for base in [0.0, f64::NAN, f64::INFINITY] {
            assert!(marks(GridInput { bounds: (0.0, 0.0), base_step_size: base }, ACROSS).is_empty());
        }
    }
}
