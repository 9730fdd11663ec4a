//! Plane figures of the measured and computed forces of one test.
//!
//! Loops show the last two whole cycles, where the model is in steady state. Figures of a test without cycles show the whole test.
//! Displacement is in mm, velocity in mm/s, force in N.

use super::axes::{Axis, Marks, Plane, Series};
use super::palette::Role;
use crate::words::Words;
use dashpot_identification::validation::{Compared, Hysteresis};
use std::ops::Range;

/// Number of whole cycles that the figures of loops show.
pub const CYCLES_SHOWN: usize = 2;

/// Draws the measured force, and the forces of model and FV curve, over velocity.
pub fn force_velocity(compared: &Compared<'_>, words: &Words) -> String {
    let velocity = &compared.record.velocity;
    let shown = shown(compared);
    let mut series = forces(compared, words, &shown, |i| 1e3 * velocity[i]);
    // The FV curve has no loop, so one line runs from the lowest to the highest velocity.
    for curve in series.iter_mut().filter(|one| one.role == Role::FvOnly) {
        let mut line = curve.lines.concat();
        line.sort_by(|a, b| a[0].total_cmp(&b[0]));
        curve.lines = vec![line];
    }
    plane([words.plot_force_velocity, words.axis_velocity, words.axis_force], series, words)
}

/// Draws three forces over velocity: measured, of the model, and `force`, N, of the model `name` from the literature.
pub fn force_velocity_against(compared: &Compared<'_>, name: &'static str, force: &[f64], words: &Words) -> String {
    let velocity = &compared.record.velocity;
    let shown = shown(compared);
    let mut series = forces(compared, words, &shown, |i| 1e3 * velocity[i]);
    series.retain(|one| one.role != Role::FvOnly);
    let lines = shown.iter().map(|r| r.clone().map(|i| [1e3 * velocity[i], force[i]]).collect()).collect();
    series.insert(1, Series { role: Role::Before, label: name, lines, marks: Marks::Line });
    plane([name, words.axis_velocity, words.axis_force], series, words)
}

/// Draws the measured force, and the forces of model and FV curve, over displacement.
pub fn force_displacement(compared: &Compared<'_>, words: &Words) -> String {
    let displacement = &compared.record.displacement;
    let series = forces(compared, words, &shown(compared), |i| 1e3 * displacement[i]);
    plane([words.plot_force_displacement, words.axis_displacement, words.axis_force], series, words)
}

/// Draws the measured force, and the forces of model and FV curve, over the time since the start of the visible cycles.
pub fn force_time(compared: &Compared<'_>, words: &Words) -> String {
    let time = &compared.record.time;
    let shown = shown(compared);
    let start = shown.first().map_or(0.0, |range| time[range.start]);
    let series = forces(compared, words, &shown, |i| time[i] - start);
    let end = shown.last().map_or(1.0, |range| time[range.end - 1] - start);
    let mut plane = prepare(words.plot_force_time, words.axis_time, words.axis_force, series);
    plane.x = Axis::exactly(words.axis_time, 0.0, end);
    plane.draw(words)
}

/// Draws the errors, computed minus measured force, of model and FV curve over velocity.
pub fn error_velocity(compared: &Compared<'_>, words: &Words) -> String {
    let velocity = &compared.record.velocity;
    plane(
        [words.plot_error_velocity, words.axis_velocity, words.axis_error],
        errors(compared, words, |i| 1e3 * velocity[i]),
        words,
    )
}

/// Draws the errors, computed minus measured force, of model and FV curve over displacement.
pub fn error_displacement(compared: &Compared<'_>, words: &Words) -> String {
    let displacement = &compared.record.displacement;
    plane(
        [words.plot_error_displacement, words.axis_displacement, words.axis_error],
        errors(compared, words, |i| 1e3 * displacement[i]),
        words,
    )
}

/// Draws the gap of the hysteresis loop (the force difference between its two branches) over velocity, averaged over all whole cycles.
pub fn hysteresis_gap(hysteresis: &Hysteresis, words: &Words) -> String {
    let line = |role, label, gap: fn(&dashpot_identification::validation::OfEach) -> f64| Series {
        role,
        label,
        lines: vec![hysteresis.gap.iter().map(|bin| [1e3 * bin.velocity_m_s, gap(&bin.gap_n)]).collect()],
        marks: Marks::Both,
    };
    let series = vec![
        line(Role::Measured, words.measured, |gap| gap.measured),
        line(Role::FvOnly, words.fv_curve, |gap| gap.fv_only),
        line(Role::Model, words.model, |gap| gap.model),
    ];
    plane([words.plot_gap, words.axis_velocity, words.axis_gap], series, words)
}

/// Returns the non-empty ranges of samples that a figure shows: the last cycles, or the whole test without cycles. The range of a cycle
/// includes the first sample of the next cycle, so that loops close.
pub fn shown(compared: &Compared<'_>) -> Vec<Range<usize>> {
    let cycles = &compared.record.cycles;
    let samples = compared.record.force.len();
    let closed = |cycle: &Range<usize>| cycle.start..(cycle.end + 1).min(samples);
    let last: Vec<_> = cycles[cycles.len().saturating_sub(CYCLES_SHOWN)..].iter().map(closed).collect();
    let ranges = if last.is_empty() { std::iter::once(0..samples).collect() } else { last };
    ranges.into_iter().filter(|range| !range.is_empty()).collect()
}

/// Returns the forces of measurement, FV curve and model over the quantity `over` of a sample, in drawing order. The model is on top.
fn forces(compared: &Compared<'_>, words: &Words, shown: &[Range<usize>], over: impl Fn(usize) -> f64) -> Vec<Series> {
    [
        (Role::Measured, words.measured, &compared.record.force),
        (Role::FvOnly, words.fv_curve, &compared.fv_only),
        (Role::Model, words.model, &compared.model),
    ]
    .into_iter()
    .map(|(role, label, force)| Series {
        role,
        label,
        lines: shown.iter().map(|range| range.clone().map(|i| [over(i), force[i]]).collect()).collect(),
        marks: Marks::Line,
    })
    .collect()
}

/// Returns the errors of FV curve and model, N, over the quantity `over` of a sample.
fn errors(compared: &Compared<'_>, words: &Words, over: impl Fn(usize) -> f64) -> Vec<Series> {
    let measured = &compared.record.force;
    let shown = shown(compared);
    [(Role::FvOnly, words.fv_curve, &compared.fv_only), (Role::Model, words.model, &compared.model)]
        .into_iter()
        .map(|(role, label, force)| Series {
            role,
            label,
            lines: shown.iter().map(|r| r.clone().map(|i| [over(i), force[i] - measured[i]]).collect()).collect(),
            marks: Marks::Line,
        })
        .collect()
}

/// Makes a figure whose axes cover all series.
fn prepare(title: &str, x: &str, y: &str, series: Vec<Series>) -> Plane {
    let values = |which: usize| series.iter().flat_map(|s| s.lines.iter().flatten()).map(move |point| point[which]);
    Plane { title: title.into(), x: Axis::around(x, values(0)), y: Axis::around(y, values(1)), series }
}

fn plane([title, x, y]: [&str; 3], series: Vec<Series>, words: &Words) -> String {
    prepare(title, x, y, series).draw(words)
}

#[cfg(test)]
/// Tests, and test data that other figures use too.
pub mod tests {
    use super::*;
    use crate::words::EN;
    use dashpot_records::Record;

    /// Makes a sine test of `cycles` cycles with 400 samples each. If `marked` is set, the record contains the ranges of the cycles.
    pub fn record(cycles: usize, marked: bool) -> Record {
        let mut record = Record {
            name: "50 mm <5 Hz>".into(),
            amplitude: 0.05,
            frequency: 1.0,
            peak_velocity: 0.314,
            ..Record::default()
        };
        if marked {
            record.cycles = (0..cycles).map(|c| 400 * c..400 * (c + 1)).collect();
        }
        for i in 0..400 * cycles {
            let phase = std::f64::consts::TAU * i as f64 / 400.0;
            record.time.push(i as f64 / 400.0);
            record.displacement.push(0.05 * libm::sin(phase));
            record.velocity.push(0.314 * libm::cos(phase));
            record.force.push(900.0 * libm::cos(phase) + 80.0 * libm::sin(phase) + 10.0);
        }
        record
    }

    /// Compares the record with a model whose force is 5 N too high, and with a linear FV curve without the loop of the record.
    pub fn compared(record: &Record) -> Compared<'_> {
        Compared {
            record,
            model: record.force.iter().map(|force| force + 5.0).collect(),
            fv_only: record.velocity.iter().map(|v| 900.0 / 0.314 * v).collect(),
            used_in_fit: false,
        }
    }

    #[test]
    fn loops_show_the_last_whole_cycles() {
        let record = record(5, true);
        assert_eq!(shown(&compared(&record)), [1200..1601, 1600..2000]);
    }

    #[test]
    #[expect(clippy::single_range_in_vec_init, reason = "one range is expected")]
    fn a_test_without_cycles_is_shown_whole() {
        let record = record(3, false);
        assert_eq!(shown(&compared(&record)), [0..1200]);
    }

    #[test]
    fn the_axis_of_the_error_holds_the_offset_alone() {
        let record = record(2, true);
        let only_model: Vec<Series> = errors(&compared(&record), &EN, |i| i as f64).split_off(1);
        for point in only_model.iter().flat_map(|series| series.lines.iter().flatten()) {
            assert!((point[1] - 5.0).abs() < 1e-9);
        }
    }

    #[test]
    fn figures_of_a_long_noisy_test_stay_small() {
        let mut record = record(40, true);
        let mut seed = 7u32;
        for force in &mut record.force {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            *force += f64::from(seed >> 16) / 600.0;
        }
        let compared = compared(&record);
        for figure in [force_velocity, force_displacement, force_time, error_velocity, error_displacement] {
            let text = figure(&compared, &EN);
            assert!(text.len() < 16_000, "{}", text.len());
            assert!(!text.contains("NaN") && !text.contains("inf"));
        }
    }
}
