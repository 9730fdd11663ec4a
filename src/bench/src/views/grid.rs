//! Where the lines and numbers of a plot's axes stand: at 1, 2 or 5 times a power of ten, so that a plot of any width has numbers to read.
//!
//! Steps of ten alone leave a narrow plot of ±25 mm with nothing but its zero.

use crate::words::Words;
use egui_plot::{AxisHints, GridInput, GridMark};

/// Distance of two numbers along the lower axis, in the least distance of two grid lines (8 px in egui_plot): seven letters have room.
pub const ACROSS: f64 = 7.0;
/// Distances, px, between which the numbers of the lower axis come up; egui_plot's own 60 to 80 leave a window of 1280 px with zeros alone.
const COME_UP: std::ops::RangeInclusive<f32> = 44.0..=55.0;
/// The same up the other axis, where a number needs a line's height alone: below 30 px they fade.
pub const UPWARDS: f64 = 4.0;

/// The lower axis with its label.
pub fn lower(label: String, w: &'static Words) -> AxisHints<'static> {
    AxisHints::new_x().label(label).label_spacing(COME_UP).formatter(move |mark, _| number(mark, w))
}

/// A number on an axis, with the decimals that its step needs.
pub fn number(mark: GridMark, w: &Words) -> String {
    w.fixed(mark.value, (-libm::log10(mark.step_size).round()).max(0.0) as usize)
}

/// The lines of an axis whose numbers lie at least `apart` of the least distance from each other.
pub fn marks(input: GridInput, apart: f64) -> Vec<GridMark> {
    let base = input.base_step_size;
    if !(base.is_normal() && input.bounds.0.is_finite() && input.bounds.1.is_finite()) {
        return Vec::new();
    }
    egui_plot::uniform_grid_spacer(|input| steps(input.base_step_size * apart))(input)
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
        let shown = |bounds, pixels| numbers(bounds, pixels, ACROSS, 55.0);
        assert_eq!(shown((-26.0, 26.0), 320.0), [-20.0, -10.0, 0.0, 10.0, 20.0]);
        assert_eq!(shown((0.0, 100.0), 800.0)[..4], [0.0, 10.0, 20.0, 30.0]);
        // Peak velocities in a window of 1280 px.
        assert_eq!(shown((-1.9, 1.9), 277.0), [-1.0, 0.0, 1.0]);
    }

    #[test]
    fn a_plot_without_extent_has_no_lines() {
        for base in [0.0, f64::NAN, f64::INFINITY] {
            assert!(marks(GridInput { bounds: (0.0, 0.0), base_step_size: base }, ACROSS).is_empty());
        }
    }
}
