//! Finds tests whose mean force of rebound and compression deviates from that of other tests at similar velocities.
//!
//! A deviation means that motion and force are both reversed, or that the zero of the load cell has changed.
//!
//! The energy does not reveal a test with both signs reversed, because the damper still dissipates. But the gas then
//! seems to pull the rod in, and rebound and compression are exchanged. Both effects change the mean force.
//!
//! A test with both signs reversed is sought in the middle of the strokes, where the damper is fast. At the ends of a
//! long stroke, the force of a stop may be opposite to the gas force. A changed zero must appear in the middle and at
//! the ends. The forces of both halves of a stroke count, so that hysteresis cancels.

use super::force_levels::{Levels, is_in_the_middle, levels};
use crate::data::record::{Note, Record};
use crate::messages::phrases;
use crate::numbers::median;
use crate::quantities::load_cell;
use crate::tuning::force_offset::{CONSTANT, FEW, FEWEST, OF_SCATTER, STRONG, TWO, VELOCITIES};
use dashpot_messages::Sentence;
use std::collections::BTreeMap;

/// Index of each test and its mean force of the two directions, N, by velocity level.
type Others = BTreeMap<i32, Vec<(usize, f64)>>;

/// Deviation of the mean force of a test from that of the others.
struct Deviation {
    /// Median over the velocity levels of the difference, N, between the mean forces of the test and of the others. A
    /// mean force is that of rebound and compression. `scatter` is the median absolute deviation of the differences
    /// from this median, N.
    offset: f64,
    scatter: f64,
    /// Number of velocity levels common to the test and the others.
    velocities: usize,
    /// The smallest and the largest absolute deviation over the velocities, N.
    nearest: f64,
    farthest: f64,
    /// Largest acceptable deviation, N.
    allowed: f64,
    /// Mean force of the two directions at the middle one of the common velocity levels, N: of the test, and of the
    /// others.
    forces: (f64, f64),
}

/// Adds notes about tests whose mean force of rebound and compression deviates from that of the others. `as_read`
/// contains the force levels of each test in the middle of its strokes.
pub(crate) fn report(records: &[Record], as_read: &[Levels], notes: &mut Vec<Note>) {
    let towards_ends: Vec<Levels> =
        records.iter().map(|record| levels(record, |i| !is_in_the_middle(record, i))).collect();
    let (at, at_ends) = (by_velocity(as_read), by_velocity(&towards_ends));
    let offset = load_cell::offset(records.iter().flat_map(|r| &r.force).fold(0.0, |most: f64, f| most.max(f.abs())));
    let (mut turned, mut moved) = (Vec::new(), Vec::new());
    for (i, record) in records.iter().enumerate() {
        // The force depends on the setting of the damper, so only tests at one setting are compared.
        let is_alike = |other: usize| is_at_one_setting(record, &records[other]);
        let from_others = |levels: &Levels, turn: f64, at: &Others| deviation((i, &is_alike), levels, turn, at, offset);
        let Some(own) = from_others(&as_read[i], 1.0, &at) else { continue };
        // The deviation must be large at every velocity common to the test and the others, at least at two. A
        // triangular motion has many samples at a single velocity and few at all others, so one velocity is no proof.
        let is_off = own.velocities >= TWO && own.nearest > STRONG * own.allowed;
        if is_off && from_others(&as_read[i], -1.0, &at).is_some_and(|other| other.farthest <= other.allowed) {
            turned.push((record, own));
            continue;
        }
        // A changed zero causes the same deviation at every velocity. Effects of stroke and position cause deviations
        // that depend on velocity.
        let constant = |seen: &Deviation| seen.velocities >= VELOCITIES && seen.scatter < CONSTANT * seen.offset.abs();
        let at_the_ends = from_others(&towards_ends[i], 1.0, &at_ends).filter(constant);
        let same = at_the_ends.is_some_and(|ends| (ends.offset - own.offset).abs() < CONSTANT * own.offset.abs());
        if own.offset.abs() > own.allowed && constant(&own) && same {
            moved.push((record, own));
        }
    }
    let few = FEW * records.len() as f64;
    let names = |tests: &[(&Record, Deviation)]| tests.iter().map(|(r, _)| r.name.clone()).collect::<Vec<_>>();
    if let Some((first, own)) = turned.first()
        && turned.len() as f64 <= few
    {
        let text = Sentence::from(phrases::TURNED_ROUND)
            .with_names("tests", names(&turned), phrases::COMMA)
            .with("test", &first.name)
            .with("own", format!("{:+.0}", own.forces.0))
            .with("usual", format!("{:+.0}", own.forces.1));
        notes.push(Note { kind: "sign", text });
    }
    if !moved.is_empty() && moved.len() as f64 <= few {
        let offsets = moved.iter().map(|(_, own)| own.offset);
        let (low, high) = offsets.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), o| (l.min(o), h.max(o)));
        let text = Sentence::from(phrases::ZERO_OFF)
            .with_names("tests", names(&moved), phrases::COMMA)
            .with("low", format!("{low:+.0}"))
            .with("high", format!("{high:+.0}"));
        notes.push(Note { kind: "zero", text });
    }
}

/// Returns whether two tests were measured at one constant setting of the damper, or both without a stated setting.
fn is_at_one_setting(a: &Record, b: &Record) -> bool {
    let changes = a.setting_signal.is_some() || b.setting_signal.is_some();
    !changes
        && match (&a.setting, &b.setting) {
            (Some(a), Some(b)) => a.is_same(b),
            (None, None) => true,
            _ => false,
        }
}

/// Collects the mean force of the two directions of all tests, by velocity level.
fn by_velocity(seen: &[Levels]) -> Others {
    let mut at = Others::new();
    for (i, levels) in seen.iter().enumerate() {
        levels.iter().for_each(|(k, level)| at.entry(*k).or_default().push((i, level.between)));
    }
    at
}

/// Computes the deviation of a test from the others, with the forces of the test multiplied by `turn`. `offset` is the
/// expected zero offset of the load cell, N. Returns `None` if there is no velocity level at which at least [`FEWEST`]
/// other tests have a force.
fn deviation(
    (own, is_alike): (usize, &dyn Fn(usize) -> bool),
    seen: &Levels,
    turn: f64,
    at: &Others,
    offset: f64,
) -> Option<Deviation> {
    let (mut off, mut allowed, mut forces) = (Vec::new(), Vec::new(), Vec::new());
    for (k, level) in seen {
        let others = at.get(k).into_iter().flatten().filter(|(i, _)| *i != own && is_alike(*i));
        let mut others: Vec<f64> = others.map(|(_, force)| *force).collect();
        if others.len() < FEWEST {
            continue;
        }
        let usual = median(&mut others);
        let scatter = median(&mut others.iter().map(|o| (o - usual).abs()).collect::<Vec<_>>());
        off.push(turn * level.between - usual);
        allowed.push(offset + OF_SCATTER * scatter);
        forces.push((turn * level.between, usual));
    }
    if off.is_empty() {
        return None;
    }
    let offset = median(&mut off.clone());
    Some(Deviation {
        offset,
        velocities: off.len(),
        scatter: median(&mut off.iter().map(|o| (o - offset).abs()).collect::<Vec<_>>()),
        nearest: off.iter().fold(f64::INFINITY, |least, o| least.min(o.abs())),
        farthest: off.iter().fold(0.0, |most, o| most.max(o.abs())),
        allowed: median(&mut allowed),
        forces: forces[forces.len() / 2],
    })
}

#[cfg(test)]
mod tests {
    use super::super::force_levels::in_the_middle;
    use super::*;
    use crate::fixtures::sine_record;
    use crate::quantities::setting_value::Setting;

    /// Makes sine tests of (amplitude, m, peak velocity, m/s). The damper has the gas force `gas`, N, and a rebound
    /// stop that begins at 45 mm.
    fn campaign(tests: &[(f64, f64)], gas: f64) -> Vec<Record> {
        let test = |(k, &(amplitude, speed)): (usize, &(f64, f64))| {
            sine_record(k, amplitude, speed, |x, v| {
                let damping = if v > 0.0 { 1600.0 } else { 1000.0 };
                let stop = 4e5 * (x - 0.045).max(0.0);
                damping * v + 20.0 * libm::tanh(v / 0.002) - gas + 300.0 * x + stop + 2.0 * libm::sin(k as f64)
            })
        };
        tests.iter().enumerate().map(test).collect()
    }

    const PLAN: [(f64, f64); 12] = [
        (0.05, 0.05),
        (0.05, 0.13),
        (0.05, 0.26),
        (0.05, 0.52),
        (0.025, 0.13),
        (0.025, 0.26),
        (0.025, 0.52),
        (0.01, 0.05),
        (0.01, 0.13),
        (0.01, 0.26),
        (0.01, 0.52),
        (0.005, 0.13),
    ];

    fn said(records: &[Record]) -> String {
        let mut notes = Vec::new();
        report(records, &in_the_middle(records), &mut notes);
        notes.iter().map(|n| format!("[{}] {}\n", n.kind, n.text)).collect()
    }

    #[test]
    fn a_stop_at_the_end_of_long_strokes_is_no_turned_sign() {
        for gas in [0.0, 200.0] {
            assert_eq!(said(&campaign(&PLAN, gas)), "");
        }
        assert_eq!(said(&campaign(&PLAN[..3], 200.0)), "", "too few to tell");
    }

    #[test]
    fn two_settings_of_a_damper_are_no_zero_that_moved() {
        let at = |current: f64, gas: f64| {
            let setting = Setting { name: "current".into(), unit: "A".into(), value: current };
            let mut records = campaign(&PLAN, gas);
            records.iter_mut().for_each(|record| record.setting = Some(setting.clone()));
            records
        };
        // The mean force of both directions differs at the harder setting, as for a damper with unequal rebound and
        // compression.
        let mut both = at(0.0, 50.0);
        both.extend(at(0.8, -150.0).into_iter().skip(4).take(3));
        assert_eq!(said(&both), "");
        both.iter_mut().for_each(|record| record.setting = None);
        assert_ne!(said(&both), "");
    }

    #[test]
    fn a_test_that_is_turned_round_and_a_zero_that_moved_are_told() {
        for at in [1, 4, 8] {
            let mut records = campaign(&PLAN, 200.0);
            let turned = &mut records[at];
            for values in [&mut turned.force, &mut turned.velocity, &mut turned.displacement] {
                values.iter_mut().for_each(|v| *v = -*v);
            }
            let text = said(&records);
            assert!(
                text.starts_with("[sign] ") && text.contains(&format!("t{at}")) && !text.contains("[zero]"),
                "{text}"
            );
        }
        for at in [4, 8, 11] {
            let mut records = campaign(&PLAN, 200.0);
            records[at].force.iter_mut().for_each(|f| *f += 40.0);
            let text = said(&records);
            assert!(text.starts_with("[zero] ") && text.contains(&format!("t{at}")) && text.contains(" +"), "{text}");
        }
    }

    #[test]
    fn a_small_mean_force_proves_no_turned_test() {
        // A test with both signs reversed deviates by twice the mean force, which is the gas force less up to 39 N of
        // asymmetric damping. The acceptable deviation is about 20 N.
        let is_told = |gas: f64| {
            let mut records = campaign(&PLAN, gas);
            let turned = &mut records[4];
            for values in [&mut turned.force, &mut turned.velocity, &mut turned.displacement] {
                values.iter_mut().for_each(|v| *v = -*v);
            }
            said(&records).contains("[sign]")
        };
        assert!(is_told(72.0) && !is_told(53.0));
    }
}
