//! Stacked force of each effect in an inventory, by bands of amplitude and of peak velocity.

use super::axes::{Axis, LABEL, TICK, TITLE, text_width};
use super::palette::Role;
use super::svg::{Anchor, Svg, TextStyle};
use crate::numbers::{digits, error};
use crate::words::Words;
use dashpot_diagnosis::{InventoryItem, Status, TestOutcome};

/// Number of effects with a separate layer in the figure. One further layer combines all smaller effects, if there are several.
const SHOWN: usize = 7;
/// Largest number of bands of amplitude, and of peak velocity. With this number, the figure fits on half a printed page.
const BANDS: usize = 6;
/// Smallest ratio of neighboring values that may separate two bands. Rigs control an amplitude within 5 %, and test matrices step by 20 %
/// or more.
const APART: f64 = 1.15;
/// Width of the figure, px, which fills a printed page.
const WIDTH: f64 = 880.0;
const ROW: f64 = 24.0;
const BAR: f64 = 16.0;

/// Tests of similar amplitude, m, or of similar peak velocity, m/s, between `low` and `high`.
#[derive(Debug, PartialEq)]
struct Band {
    low: f64,
    high: f64,
    /// Indices of the tests in the band.
    tests: Vec<usize>,
}

/// Divides the values of tests into at most [`BANDS`] bands, at the largest ratios of neighboring values above [`APART`]. Values that are
/// not positive and finite are in no band.
fn bands(values: &[f64]) -> Vec<Band> {
    let mut order: Vec<usize> = (0..values.len()).filter(|k| values[*k].is_finite() && values[*k] > 0.0).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]).then(a.cmp(b)));
    let ratio = |k: usize| values[order[k]] / values[order[k - 1]];
    let mut cuts: Vec<usize> = (1..order.len()).filter(|k| ratio(*k) > APART).collect();
    cuts.sort_by(|a, b| ratio(*b).total_cmp(&ratio(*a)).then(a.cmp(b)));
    cuts.truncate(BANDS - 1);
    cuts.extend([0, order.len()]);
    cuts.sort_unstable();
    cuts.dedup();
    let band = |ends: &[usize]| {
        let tests: Vec<usize> = order[ends[0]..ends[1]].to_vec();
        Band { low: values[tests[0]], high: values[tests[tests.len() - 1]], tests }
    };
    cuts.windows(2).map(band).collect()
}

impl Band {
    /// Formats the values of the band in mm or mm/s: their geometric mean if they are close together, otherwise a range.
    fn label(&self, words: &Words) -> String {
        let text = |si: f64| digits(1e3 * si, 2);
        if self.high < APART * self.low {
            return words.number(&text((self.low * self.high).sqrt()));
        }
        words.number(&words.fill_as_is(words.range, &[("low", &text(self.low)), ("high", &text(self.high))]))
    }

    /// Computes the root mean square of the forces `by_test`, N, over the tests of the band.
    fn rms(&self, by_test: &[f64]) -> f64 {
        let sum: f64 = self.tests.iter().map(|k| by_test[*k] * by_test[*k]).sum();
        (sum / self.tests.len() as f64).sqrt()
    }
}

/// An effect with its color role and its force in each fitted test, N.
struct Layer {
    role: Role,
    name: String,
    by_test: Vec<f64>,
}

/// Returns one layer for each effect of the most probable model, the largest force first. The last layer combines all effects without a
/// separate layer. Its force is the root of their summed squares, N.
fn layers(items: &[InventoryItem], tests: usize, words: &Words) -> Vec<Layer> {
    let is_drawn = |item: &&InventoryItem| {
        matches!(item.status, Status::Kept | Status::Added)
            && item.test_forces_n.len() == tests
            && item.test_forces_n.iter().all(|force| force.is_finite())
    };
    let mut drawn: Vec<&InventoryItem> = items.iter().filter(is_drawn).collect();
    drawn.sort_by(|a, b| b.force_n_rms.total_cmp(&a.force_n_rms));
    let own = if drawn.len() == SHOWN + 1 { drawn.len() } else { drawn.len().min(SHOWN) };
    let rest = drawn.split_off(own);
    let mut all: Vec<Layer> = (0u8..)
        .zip(&drawn)
        .map(|(k, item)| Layer {
            role: Role::Group(k),
            name: words.name_of(item.effect).unwrap_or(item.effect).to_owned(),
            by_test: item.test_forces_n.clone(),
        })
        .collect();
    if !rest.is_empty() {
        let sum = |k: usize| rest.iter().map(|item| item.test_forces_n[k].powi(2)).sum::<f64>().sqrt();
        let by_test = (0..tests).map(sum).collect();
        all.push(Layer { role: Role::Shadow, name: words.other_effects.to_owned(), by_test });
    }
    all
}

/// Draws the stacked rms forces of the effects by band. Returns `None` if no effect has a force in a fitted test.
pub fn stacked(items: &[InventoryItem], tests: &[TestOutcome], words: &Words) -> Option<String> {
    let fitted: Vec<&TestOutcome> = tests.iter().filter(|test| !test.left_out).collect();
    let layers = layers(items, fitted.len(), words);
    let amplitude = |test: &&TestOutcome| {
        let x = &test.curves.displacement;
        let (low, high) = x.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(*x), h.max(*x)));
        0.5 * (high - low)
    };
    let speed = |test: &&TestOutcome| test.curves.velocity.iter().fold(0.0f64, |top, v| top.max(v.abs()));
    let groups: Vec<(&str, Vec<Band>)> = [
        (words.axis_amplitude, bands(&fitted.iter().map(amplitude).collect::<Vec<_>>())),
        (words.axis_peak_velocity, bands(&fitted.iter().map(speed).collect::<Vec<_>>())),
    ]
    .into_iter()
    .filter(|(_, bands)| !bands.is_empty())
    .collect();
    let whole = |band: &Band| layers.iter().map(|layer| band.rms(&layer.by_test)).sum::<f64>();
    let most = groups.iter().flat_map(|(_, bands)| bands).map(whole).fold(0.0, f64::max);
    if most <= 0.0 {
        return None;
    }
    let labels: Vec<Vec<String>> =
        groups.iter().map(|(_, bands)| bands.iter().map(|band| band.label(words)).collect()).collect();
    let widest = labels.iter().flatten().map(|label| text_width(label, TICK)).fold(0.0, f64::max);
    let left = (widest + 24.0).max(66.0);
    let right = WIDTH - 24.0;
    let (marks, below_legend) = legend(&layers, left, right);
    let rows: usize = groups.iter().map(|(_, bands)| bands.len()).sum();
    let top = below_legend + 8.0;
    let bottom = top + groups.len() as f64 * 24.0 + rows as f64 * ROW;
    let title = words.plot_inventory;
    let mut svg = Svg::new(WIDTH, bottom + 44.0, title);
    svg.text([left, 17.0], title, TextStyle { bold: true, ..TextStyle::plain(TITLE, Anchor::Start) });
    for (layer, [x, y]) in layers.iter().zip(marks) {
        svg.bar(layer.role, [x, y - 9.0], [12.0, 10.0], "");
        svg.text([x + 18.0, y], &layer.name, TextStyle::plain(LABEL, Anchor::Start));
    }
    let axis = Axis::exactly(words.axis_effect_force, 0.0, 1.04 * most);
    let at = |force: f64| left + axis.place(force) * (right - left);
    let ticks = axis.ticks(8, words);
    svg.grid(&ticks.at.iter().map(|(value, _)| [[at(*value), top], [at(*value), bottom]]).collect::<Vec<_>>());
    let mut y = top;
    for ((heading, bands), labels) in groups.iter().zip(&labels) {
        svg.text([left + 4.0, y + 15.0], heading, TextStyle { bold: true, ..TextStyle::faint(TICK, Anchor::Start) });
        y += 24.0;
        for (band, label) in bands.iter().zip(labels) {
            let middle = y + 0.5 * ROW;
            svg.text([left - 8.0, middle + 4.0], label, TextStyle::faint(TICK, Anchor::End));
            let mut from = 0.0;
            for layer in &layers {
                let force = band.rms(&layer.by_test);
                let (x, width) = (at(from), at(from + force) - at(from));
                let value = format!("{}: {} N", layer.name, words.number(&error(force)));
                svg.bar(layer.role, [x, middle - 0.5 * BAR], [width, BAR], &value);
                from += force;
            }
            y += ROW;
        }
    }
    svg.frame(&[[[left, bottom], [right, bottom]], [[left, top], [left, bottom]]], 1.0);
    for (value, label) in &ticks.at {
        svg.text([at(*value), bottom + 16.0], label, TextStyle::faint(TICK, Anchor::Middle));
    }
    svg.text([0.5 * (left + right), bottom + 35.0], &axis.label, TextStyle::plain(LABEL, Anchor::Middle));
    Some(svg.finish())
}

/// Positions the legend names between `left` and `right` in as few lines as possible. Returns the positions and the lower edge of the last
/// line, px.
fn legend(layers: &[Layer], left: f64, right: f64) -> (Vec<[f64; 2]>, f64) {
    let [mut x, mut y] = [left, 37.0];
    let mut all = Vec::new();
    for layer in layers {
        let wide = 18.0 + text_width(&layer.name, LABEL);
        if x > left && x + wide > right {
            (x, y) = (left, y + 18.0);
        }
        all.push([x, y]);
        x += wide + 18.0;
    }
    (all, y + 4.0)
}

#[cfg(test)]
mod tests {
    use super::super::before_after::tests::outcome;
    use super::*;
    use crate::words::{DE, EN};

    fn item(effect: &'static str, force: f64, status: Status, by_test: &[f64]) -> InventoryItem {
        InventoryItem {
            effect,
            form: "",
            force_n_rms: force,
            fraction: 0.1,
            test_forces_n: by_test.to_vec(),
            probability: 1.0,
            status,
            replaces: None,
            or_instead: None,
        }
    }

    #[test]
    fn tests_of_one_nominal_value_stay_together_and_the_largest_gaps_divide() {
        let found = bands(&[0.0102, 0.0099, 0.05, 0.001, 0.00101, f64::NAN]);
        let tests: Vec<&[usize]> = found.iter().map(|band| &band.tests[..]).collect();
        assert_eq!(tests, [&[3, 4][..], &[1, 0], &[2]]);
        assert_eq!(found.iter().map(|band| band.label(&EN)).collect::<Vec<_>>(), ["1.0", "10", "50"]);
        let sweep: Vec<f64> = (0..40).map(|k| 0.001 * libm::pow(1.2, f64::from(k))).collect();
        let found = bands(&sweep);
        assert_eq!(found.len(), BANDS);
        assert_eq!(found.iter().map(|band| band.tests.len()).sum::<usize>(), 40);
        assert!(found[BANDS - 1].label(&DE).contains(" bis "), "{}", found[BANDS - 1].label(&DE));
        assert!(bands(&[]).is_empty() && bands(&[0.0]).is_empty());
    }

    #[test]
    fn every_effect_of_the_best_model_has_a_bar_in_every_band() {
        let tests = [outcome("a", false), outcome("b", false), outcome("c", true)];
        let items = [
            item("coulomb_friction", 20.0, Status::Kept, &[20.0, 20.0]),
            item("aeration", 30.0, Status::Added, &[40.0, 0.0]),
            item("bushing", 9.0, Status::Replaced, &[9.0, 9.0]),
            item("gas_spring", f64::INFINITY, Status::Kept, &[]),
        ];
        let text = stacked(&items, &tests, &EN).unwrap();
        assert!(!text.contains("NaN") && !text.contains("inf"));
        // There is one band of amplitude and one of velocity, because both tests have the same motion. The rms of the forces 40 N and 0 N
        // of the two tests is 28.3 N.
        assert_eq!(text.matches("<title>air in the oil: 28.3 N</title>").count(), 2, "{text}");
        assert_eq!(text.matches("<title>dry friction: 20.0 N</title>").count(), 2);
        assert!(!text.contains("rubber bush") && !text.contains("gas spring"));
        assert!(stacked(&items[2..], &tests, &EN).is_none());
        assert!(stacked(&items, &tests[..1], &EN).is_none(), "forces of other tests");
    }

    #[test]
    fn small_effects_share_one_layer() {
        let names = dashpot_diagnosis::EFFECTS;
        let items: Vec<_> =
            (0..10).map(|k| item(names[k], 100.0 - k as f64, Status::Kept, &[100.0 - k as f64])).collect();
        let all = layers(&items, 1, &EN);
        assert_eq!(all.len(), SHOWN + 1);
        let rest = (93.0f64.powi(2) + 92.0f64.powi(2) + 91.0f64.powi(2)).sqrt();
        assert!((all[SHOWN].by_test[0] - rest).abs() < 1e-9);
        assert_eq!(layers(&items[..8], 1, &EN).len(), 8);
        assert!(layers(&items[..8], 1, &EN).iter().all(|layer| layer.name != EN.other_effects));
    }
}
