//! Figures before and after a diagnosis: the error of every test, and the loops of one test.

use super::axes::{Axis, LABEL, Mark, Marks, Plane, Series, TICK, heading, text_width};
use super::overview::shorten;
use super::palette::Role;
use super::svg::{Anchor, Svg, TextStyle};
use super::ticks::Ticks;
use crate::words::Words;
use dashpot_diagnosis::TestOutcome;

/// Smallest error on the logarithmic axis, N. Smaller errors are drawn at this value.
const FLOOR: f64 = 0.01;

/// Returns the name of every test. If several outcomes belong to one test, as segments of a long record, the names contain their numbers.
pub fn names(tests: &[TestOutcome], words: &Words) -> Vec<String> {
    let same = |a: &TestOutcome, b: &TestOutcome| a.test == b.test && a.left_out == b.left_out;
    tests
        .iter()
        .enumerate()
        .map(|(k, test)| {
            let count = tests.iter().filter(|other| same(other, test)).count();
            if count == 1 {
                return test.test.clone();
            }
            let place = tests[..k].iter().filter(|other| same(other, test)).count();
            let (place, count) = ((place + 1).to_string(), count.to_string());
            // The test name is inserted last, because it may contain braces, which look like placeholders.
            words.fill(words.stretch, &[("place", &place), ("count", &count), ("test", &test.test)])
        })
        .collect()
}

/// Draws the root mean square error of every test before and after the diagnosis, with the noise. Fitted tests are on the left, left-out
/// tests on the right.
pub fn errors(tests: &[TestOutcome], words: &Words) -> String {
    let fitted = tests.iter().filter(|t| !t.left_out).count();
    let groups = usize::from(fitted > 0) + usize::from(fitted < tests.len());
    let pitch = (900.0 / tests.len().max(1) as f64).clamp(13.0, 60.0);
    let gap = if groups == 2 { pitch } else { 0.0 };
    let names: Vec<String> = names(tests, words).iter().map(|name| shorten(name)).collect();
    let longest = names.iter().map(|name| text_width(name, TICK)).fold(0.0, f64::max);
    let (left, top, tall) = (66.0, 68.0, 250.0);
    let right = left + pitch * tests.len() as f64 + gap;
    let bottom = top + tall;
    let title = words.plot_error_rms;
    let mut svg = Svg::new(right.max(470.0) + 14.0, bottom + longest + 20.0, title);
    let legend = [(Role::Before, words.before, Mark::Dot), (Role::Model, words.after, Mark::Dot)];
    heading(&mut svg, title, left, &legend);
    // The legend entry for the noise is to the right of the other entries. Its position follows from their text widths, which depend on the
    // language.
    let wide: f64 = legend.iter().map(|(_, label, _)| 41.0 + text_width(label, LABEL)).sum();
    let noise = left + wide.max(175.0);
    svg.frame(&[[[noise, 33.0], [noise + 12.0, 33.0]]], 1.6);
    svg.text([noise + 18.0, 37.0], words.noise_alone, TextStyle::plain(LABEL, Anchor::Start));

    let values = tests.iter().flat_map(|t| [t.before_rmse_n, t.after_rmse_n, t.noise_n]);
    let known = values.filter(|v| v.is_finite()).map(|v| v.max(FLOOR));
    let (low, high) = known.fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
    let (low, high) = if low > high { (0.1, 10.0) } else { (low / 1.25, high * 1.25) };
    let at_y = |value: f64| bottom - libm::log(value.max(FLOOR) / low) / libm::log(high / low) * tall;
    let ticks = Ticks::logarithmic(low, high).localized(words);
    svg.grid(&ticks.at.iter().map(|(value, _)| [[left, at_y(*value)], [right, at_y(*value)]]).collect::<Vec<_>>());
    svg.frame(&[[[left, bottom], [right, bottom]], [[left, top], [left, bottom]]], 1.0);
    for (value, label) in &ticks.at {
        svg.text([left - 6.0, at_y(*value) + 4.0], label, TextStyle::faint(TICK, Anchor::End));
    }
    let turned = TextStyle { turn: -90.0, ..TextStyle::plain(LABEL, Anchor::Middle) };
    svg.text([15.0, 0.5 * (top + bottom)], words.axis_error_rms, turned);
    let label = |svg: &mut Svg, x: f64, text: &str| {
        svg.text([x, top - 8.0], text, TextStyle { bold: true, ..TextStyle::faint(TICK, Anchor::Start) });
    };
    if fitted > 0 {
        label(&mut svg, left + 6.0, words.fitted_tests);
    }
    if fitted < tests.len() {
        let x = left + pitch * fitted as f64 + 0.5 * gap;
        if groups == 2 {
            svg.frame(&[[[x, top - 20.0], [x, bottom]]], 1.0);
        }
        label(&mut svg, x + 6.0, words.left_out);
    }
    for (i, (test, name)) in tests.iter().zip(&names).enumerate() {
        let x = left + (i as f64 + 0.5) * pitch + if test.left_out { gap } else { 0.0 };
        svg.text([x + 4.0, bottom + 8.0], name, TextStyle { turn: -90.0, ..TextStyle::faint(TICK, Anchor::End) });
        let known = [test.before_rmse_n, test.after_rmse_n, test.noise_n].iter().all(|v| v.is_finite());
        if !known {
            continue;
        }
        let (before, after, noise) = (at_y(test.before_rmse_n), at_y(test.after_rmse_n), at_y(test.noise_n));
        svg.grid(&[[[x, before], [x, after]]]);
        svg.frame(&[[[x - 4.0, noise], [x + 4.0, noise]]], 1.6);
        svg.dot(Role::Before, [x, before], 3.4);
        svg.dot(Role::Model, [x, after], 3.4);
    }
    svg.finish()
}

/// Draws force over velocity: the measurement, and the model before and after the diagnosis.
pub fn force_velocity(test: &TestOutcome, words: &Words) -> String {
    let velocity = &test.curves.velocity;
    let series = forces(test, words, |i| 1e3 * velocity[i]);
    plane([words.plot_force_velocity, words.axis_velocity, words.axis_force], series, words)
}

/// Draws force over displacement: the measurement, and the model before and after the diagnosis.
pub fn force_displacement(test: &TestOutcome, words: &Words) -> String {
    let displacement = &test.curves.displacement;
    let series = forces(test, words, |i| 1e3 * displacement[i]);
    plane([words.plot_force_displacement, words.axis_displacement, words.axis_force], series, words)
}

/// Draws the residual over velocity, before and after the diagnosis.
pub fn residual_velocity(test: &TestOutcome, words: &Words) -> String {
    let curves = &test.curves;
    let line = |role, label, force: &[f64]| {
        let points = |i: usize| [1e3 * curves.velocity[i], curves.measured[i] - force[i]];
        Series { role, label, lines: vec![closed(test).map(points).collect()], marks: Marks::Line }
    };
    let series = vec![line(Role::Before, words.before, &curves.before), line(Role::Model, words.after, &curves.after)];
    plane([words.plot_left_velocity, words.axis_velocity, words.axis_residual], series, words)
}

/// Returns the sample indices along the curves of a test. For a test with cycles, the first index also follows the last, so that the drawn
/// loop closes.
fn closed(test: &TestOutcome) -> impl Iterator<Item = usize> {
    let count = test.curves.measured.len();
    (0..count).chain((test.curves.frequency > 0.0 && count > 0).then_some(0))
}

fn forces(test: &TestOutcome, words: &Words, over: impl Fn(usize) -> f64) -> Vec<Series> {
    let curves = &test.curves;
    [
        (Role::Measured, words.measured, &curves.measured),
        (Role::Before, words.before, &curves.before),
        (Role::Model, words.after, &curves.after),
    ]
    .into_iter()
    .map(|(role, label, force)| Series {
        role,
        label,
        lines: vec![closed(test).map(|i| [over(i), force[i]]).collect()],
        marks: Marks::Line,
    })
    .collect()
}

/// Draws a figure whose axes cover all series.
fn plane([title, x, y]: [&str; 3], series: Vec<Series>, words: &Words) -> String {
    let values = |which: usize| series.iter().flat_map(|s| s.lines.iter().flatten()).map(move |point| point[which]);
    Plane { title: title.into(), x: Axis::around(x, values(0)), y: Axis::around(y, values(1)), series }.draw(words)
}

#[cfg(test)]
/// Tests, and test data that other figures use too.
pub mod tests {
    use super::*;
    use crate::words::EN;
    use dashpot_diagnosis::Curves;

    /// Makes a sine test of 1 Hz. Its model lacks 20 N of friction before the diagnosis and 1 N after it.
    pub fn outcome(name: &str, held_out: bool) -> TestOutcome {
        let phase = |i: usize| std::f64::consts::TAU * (i as f64 + 0.5) / 100.0;
        let over = |f: &dyn Fn(f64) -> f64| (0..100).map(|i| f(phase(i))).collect::<Vec<f64>>();
        let force = |friction: f64| move |p: f64| 900.0 * libm::cos(p) + friction * libm::cos(p).signum();
        TestOutcome {
            test: name.into(),
            left_out: held_out,
            before_rmse_n: 20.0,
            after_rmse_n: 1.0,
            noise_n: 0.5,
            allowed_n: 0.5,
            curves: Curves {
                displacement: over(&|p| 0.05 * libm::sin(p)),
                velocity: over(&|p| 0.314 * libm::cos(p)),
                measured: over(&force(20.0)),
                before: over(&force(0.0)),
                after: over(&force(19.0)),
                frequency: 1.0,
            },
        }
    }

    #[test]
    fn every_test_has_both_dots_and_its_noise() {
        let tests = [outcome("a <1>", false), outcome("b", false), outcome("c", true)];
        let text = errors(&tests, &EN);
        assert_eq!(text.matches("<circle").count(), 2 + 2 * tests.len(), "legend and tests");
        assert!(text.contains("left out") && text.contains("a &lt;1&gt;"));
        let all_fitted = errors(&tests[..2], &EN);
        assert!(!all_fitted.contains("left out"));
    }

    #[test]
    fn a_test_without_an_answer_keeps_its_place_and_breaks_nothing() {
        let mut lost = outcome("b", true);
        lost.after_rmse_n = f64::NAN;
        let text = errors(&[outcome("a", false), lost], &EN);
        assert!(!text.contains("NaN") && text.contains(">b<"));
        assert!(!errors(&[], &EN).contains("NaN"));
    }

    #[test]
    fn stretches_of_one_test_are_numbered() {
        let tests = [outcome("long", false), outcome("long", false), outcome("short", false), outcome("long", true)];
        assert_eq!(names(&tests, &EN), ["long (1 of 2)", "long (2 of 2)", "short", "long"]);
    }
}
