//! Grid lines of a plot's axes, and the numbers at these lines.
//!
//! The numbers are multiples of 1, 2 or 5 times a power of ten, so that a plot of any width has readable numbers. With powers of ten alone,
//! a narrow plot of ±25 mm would have only the number zero.

use crate::words::Words;
use egui_plot::{AxisHints, GridInput, GridMark, Plot};
use std::cell::Cell;
use std::rc::Rc;

/// Smallest distance of two numbers along the lower axis, in units of the smallest distance of two grid lines (8 px in egui_plot). It
/// suffices for five characters. Longer numbers have a larger distance.
const ACROSS: f64 = 5.5;
/// Distances of neighboring numbers, px, over which the numbers of the lower axis fade in. With the default of `egui_plot`, 60 to 80 px,
/// the plots in a window of 1280 px would show only the number zero.
const COME_UP: std::ops::RangeInclusive<f32> = 34.0..=43.0;
/// Smallest distance of two numbers along the vertical axis, in units of 8 px. At less than 30 px, the numbers would fade.
const UPWARDS: f64 = 4.0;

/// Width of a digit in the font of the axes, px, slightly above the width of the widest digit.
const DIGIT: f64 = 7.5;
/// Largest number of decimals of a label, because an `f64` of magnitude one has no more significant decimals.
const MOST_DECIMALS: usize = 15;

/// Gives a plot its two axes, with labels and grid lines. Every number has the decimals that the distance of two numbers on its axis
/// requires.
pub fn with_axes<'a>(plot: Plot<'a>, lower: String, left: String, w: &'static Words) -> Plot<'a> {
    let steps = [Rc::new(Cell::new(0.0)), Rc::new(Cell::new(0.0))];
    let [x, y] = steps.clone();
    let [x_step, y_step] = steps;
    // The plot computes the grid lines of an axis before their labels, so the labels can use the step.
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

/// Formats the number at a grid line. Lines between two numbers get an empty text, regardless of their distance.
fn label(mark: &GridMark, step: f64, w: &Words) -> String {
    // The factor 0.99 compensates rounding errors of the step.
    if mark.step_size < 0.99 * step { String::new() } else { number(mark.value, decimals_of(step), w) }
}

/// Formats a number on an axis; zero has no sign.
fn number(value: f64, decimals: usize, w: &Words) -> String {
    w.fixed(if value == 0.0 { 0.0 } else { value }, decimals)
}

/// Returns the number of decimals that distinguishes two numbers at a distance of `step`.
fn decimals_of(step: f64) -> usize {
    if !(step.is_finite() && step > 0.0) {
        return 0;
    }
    // The result is rounded up, because 0.05 has two decimals. The offset compensates rounding errors at exact powers of ten.
    ((-libm::log10(step) - 1e-9).ceil().max(0.0) as usize).min(MOST_DECIMALS)
}

/// Returns a distance of two numbers into which the longest number fits, in units of the smallest distance of two grid lines.
fn room_for_numbers(input: &GridInput, least: f64) -> f64 {
    let largest = input.bounds.0.abs().max(input.bounds.1.abs()).max(1.0);
    let digits = 2.0 + libm::log10(largest).floor().max(0.0);
    let mut apart = least;
    // A larger distance never needs more decimals, so the distance stays constant once the longest number fits into it.
    for _ in 0..4 {
        let decimals = decimals_of(step_of(input, apart)) as f64;
        let letters = digits + if decimals > 0.0 { decimals + 0.5 } else { 0.0 };
        apart = apart.max(letters * DIGIT / 8.0);
    }
    apart
}

/// Returns the distance of two numbers of an axis, in units of the axis.
fn step_of(input: &GridInput, apart: f64) -> f64 {
    steps(input.base_step_size * apart)[1]
}

/// Returns the grid lines of an axis. The distance of two numbers is at least `apart` times the smallest distance of grid lines.
fn marks(input: GridInput, apart: f64) -> Vec<GridMark> {
    let base = input.base_step_size;
    if !(base.is_normal() && input.bounds.0.is_finite() && input.bounds.1.is_finite()) {
        return Vec::new();
    }
    egui_plot::uniform_grid_spacer(move |input| steps(input.base_step_size * apart))(input)
}

/// Returns the distances of the fine lines, of the numbered lines, and of every tenth numbered line. Numbered lines have at least the
/// distance `least`.
fn steps(least: f64) -> [f64; 3] {
    let decade = libm::pow(10f64, libm::log10(least.abs()).floor());
    // The tolerance compensates rounding errors in the logarithm of an exact power of ten.
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

    /// Returns the visible numbers of an axis: those whose distance on the screen is large enough.
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
        // The axis of peak velocities, m/s, in a window of 1280 px.
        assert_eq!(shown((-1.9, 1.9), 277.0), [-1.0, 0.0, 1.0]);
    }

    /// Returns the labels of an axis with their values, from the functions that the plot calls.
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
