//! Maps of the residual over velocity and displacement, before and after the improvement, with one color scale.

use super::axes::{Axis, LABEL, Scale, TICK, TITLE};
use super::palette::signed;
use super::residual::{Sample, velocity_axis};
use super::svg::{Anchor, Svg, TextStyle};
use super::ticks::number;
use crate::words::Words;

/// Number of cells along velocity and along displacement.
const CELLS: [usize; 2] = [36, 24];
/// Size of one map, px.
const MAP: [f64; 2] = [396.0, 288.0];
/// Smallest fraction of the cells of the map before the improvement whose residual lies within the color scale.
const WITHIN: f64 = 0.97;

/// Draws the maps of the mean residual before and after the improvement side by side. Returns `None` without samples.
pub fn maps(samples: &[Sample], words: &Words) -> Option<String> {
    if samples.is_empty() {
        return None;
    }
    let axes = [velocity_axis(samples, words), displacement_axis(samples, words)];
    let (before, after) = (means(samples, &axes, |s| s.before), means(samples, &axes, |s| s.after));
    let mut sizes: Vec<f64> = before.iter().flatten().map(|v| v.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let end =
        round_up(sizes.get(((sizes.len() as f64 * WITHIN) as usize).min(sizes.len().saturating_sub(1))).copied()?);
    let title = words.plot_left_map;
    let (left, top, between) = (66.0, 56.0, 70.0);
    let right = left + 2.0 * MAP[0] + between;
    let mut svg = Svg::new(right + 84.0, top + MAP[1] + 48.0, title);
    svg.text([left, 17.0], title, TextStyle { bold: true, ..TextStyle::plain(TITLE, Anchor::Start) });
    for (k, (name, cells)) in [(words.before, &before), (words.after, &after)].into_iter().enumerate() {
        map(&mut svg, [left + k as f64 * (MAP[0] + between), top], name, &axes, cells, end, words);
    }
    bar(&mut svg, [right + 18.0, top], end, words);
    Some(svg.finish())
}

fn displacement_axis(samples: &[Sample], words: &Words) -> Axis {
    let top = samples.iter().map(|s| 1e3 * s.displacement.abs()).fold(1e-3, f64::max);
    Axis { scale: Scale::Root, ..Axis::exactly(words.axis_displacement, -top, top) }
}

/// Averages the quantity `of` a sample in every cell of velocity and displacement, row by row from the lowest
/// displacement. Cells without samples are `None`.
fn means(samples: &[Sample], axes: &[Axis; 2], of: impl Fn(&Sample) -> f64) -> Vec<Option<f64>> {
    let mut sums = vec![(0.0, 0usize); CELLS[0] * CELLS[1]];
    for sample in samples {
        let places = [axes[0].place(1e3 * sample.velocity), axes[1].place(1e3 * sample.displacement)];
        let [column, row] = [0, 1].map(|k| ((places[k] * CELLS[k] as f64).max(0.0) as usize).min(CELLS[k] - 1));
        let cell = &mut sums[row * CELLS[0] + column];
        cell.0 += of(sample);
        cell.1 += 1;
    }
    sums.iter().map(|(sum, count)| (*count > 0).then(|| sum / *count as f64)).collect()
}

/// Rounds a positive value up to 1, 2 or 5 times a power of ten, at least 0.001.
fn round_up(value: f64) -> f64 {
    let decade = libm::pow(10f64, libm::log10(value.max(1e-3)).floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|f| f * decade).find(|v| *v >= 0.999 * value).unwrap_or(value)
}

fn map(svg: &mut Svg, corner: [f64; 2], name: &str, axes: &[Axis; 2], cells: &[Option<f64>], end: f64, words: &Words) {
    let [left, top] = corner;
    let (right, bottom) = (left + MAP[0], top + MAP[1]);
    svg.text([left, top - 10.0], name, TextStyle { bold: true, ..TextStyle::plain(LABEL, Anchor::Start) });
    let size = [MAP[0] / CELLS[0] as f64, MAP[1] / CELLS[1] as f64];
    for (k, value) in cells.iter().enumerate() {
        if let Some(value) = value {
            let (column, row) = (k % CELLS[0], k / CELLS[0]);
            let at = [left + column as f64 * size[0], bottom - (row + 1) as f64 * size[1]];
            svg.tile(at, size, &signed(value / end));
        }
    }
    let (x_ticks, y_ticks) = (axes[0].ticks(9, words), axes[1].ticks(8, words));
    svg.frame(&[[[left, bottom], [right, bottom]], [[left, top], [left, bottom]]], 1.0);
    let marks: Vec<_> = x_ticks
        .at
        .iter()
        .map(|(value, _)| left + axes[0].place(*value) * MAP[0])
        .map(|x| [[x, bottom], [x, bottom + 4.0]])
        .chain(
            y_ticks
                .at
                .iter()
                .map(|(value, _)| bottom - axes[1].place(*value) * MAP[1])
                .map(|y| [[left - 4.0, y], [left, y]]),
        )
        .collect();
    svg.frame(&marks, 1.0);
    for (value, label) in &x_ticks.at {
        let x = left + axes[0].place(*value) * MAP[0];
        svg.text([x, bottom + 16.0], label, TextStyle::faint(TICK, Anchor::Middle));
    }
    for (value, label) in &y_ticks.at {
        let y = bottom - axes[1].place(*value) * MAP[1];
        svg.text([left - 7.0, y + 4.0], label, TextStyle::faint(TICK, Anchor::End));
    }
    svg.text([0.5 * (left + right), bottom + 34.0], &axes[0].label, TextStyle::plain(LABEL, Anchor::Middle));
    let turned = TextStyle { turn: -90.0, ..TextStyle::plain(LABEL, Anchor::Middle) };
    svg.text([left - 42.0, 0.5 * (top + bottom)], &axes[1].label, turned);
}

/// Draws the color scale with its upper left corner at `corner`, px, and its ends at −`end` and `end`, N.
fn bar(svg: &mut Svg, corner: [f64; 2], end: f64, words: &Words) {
    const STEPS: usize = 48;
    let tall = MAP[1] / STEPS as f64;
    for k in 0..STEPS {
        let place = 1.0 - 2.0 * (k as f64 + 0.5) / STEPS as f64;
        svg.tile([corner[0], corner[1] + k as f64 * tall], [14.0, tall], &signed(place));
    }
    let decimals = (1.0 - libm::log10(end).floor()).clamp(0.0, 6.0) as usize;
    for part in [-1.0, -0.5, 0.0, 0.5, 1.0] {
        let y = corner[1] + 0.5 * (1.0 - part) * MAP[1];
        let label =
            number(part * end, if part == 0.0 { 0 } else { decimals.saturating_sub(1).max(usize::from(end < 20.0)) });
        svg.text([corner[0] + 19.0, y + 4.0], &words.number(&label), TextStyle::faint(TICK, Anchor::Start));
    }
    let turned = TextStyle { turn: -90.0, ..TextStyle::plain(LABEL, Anchor::Middle) };
    svg.text([corner[0] + 60.0, corner[1] + 0.5 * MAP[1]], words.axis_residual, turned);
}

#[cfg(test)]
mod tests {
    use super::super::before_after::tests::outcome;
    use super::super::residual::samples;
    use super::*;
    use crate::words::EN;

    #[test]
    fn both_maps_share_one_scale_and_the_smaller_rest_is_paler() {
        let all = samples(&[outcome("a", false)]);
        let text = maps(&all, &EN).unwrap();
        // The largest residual before the improvement, 20 N, is the end of the color scale. The residual after it, 1 N,
        // is a twentieth of the scale.
        let count = |place: f64| text.matches(&signed(place)).count();
        assert!(count(1.0) > 10 && count(-1.0) > 10, "{} {}", count(1.0), count(-1.0));
        assert!(count(0.05) > 10 && count(-0.05) > 10);
        assert!(text.contains(">20<") && text.contains(">−20<"));
    }

    #[test]
    fn the_scale_ends_at_a_round_number() {
        assert_eq!([0.0, 0.7, 1.0, 1.2, 37.0, 60.0].map(round_up), [0.001, 1.0, 1.0, 2.0, 50.0, 100.0]);
    }

    #[test]
    fn nothing_gives_no_map() {
        assert!(maps(&[], &EN).is_none());
    }
}
