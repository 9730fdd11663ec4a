//! Checks the unit of single files by comparison with the other tests of the campaign at similar velocities.
//!
//! The tests of a campaign are of one damper, so they have similar forces at equal velocities, regardless of their
//! strokes. Heat, mounts, stops and free play change the force by tens of percent. A wrong unit changes it by the ratio
//! of two units.
//!
//! The largest set of tests that agree is the reference. A test may deviate from the reference by the ratio of two
//! units of force, displacement, velocity or time. If another unit makes the test agree at all its velocities, the file
//! likely uses that unit.

use super::force_levels::{Level, Levels, apart, levels, velocity};
use super::plausibility::shows_noise_alone;
use crate::data::record::Record;
use crate::error::{FilesUnit, RecordError};
use crate::numbers::{median, sample_time};
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use crate::tuning::file_units::{
    AGREE, AS_LIKELY, AS_LONG, BEYOND_DAMPERS, CELL_OFFSET, CLOSE, CLOSE_BEYOND, FEWEST, LARGEST_AMPLITUDE, OF_SCATTER,
    OFF,
};
use std::collections::{BTreeMap, HashMap};

/// Units and options with which a test was read.
#[derive(Debug)]
pub(crate) struct Reading<'a> {
    /// Units in which the channels of the test were read.
    pub units: Vec<(Channel, Unit)>,
    /// The user's options for the file of the test.
    pub options: &'a Options,
}

/// A test with its force levels.
struct Seen<'a> {
    record: &'a Record,
    reading: &'a Reading<'a>,
    levels: Levels,
}

impl Seen<'_> {
    fn unit(&self, channel: Channel) -> Option<Unit> {
        self.reading.units.iter().find(|(c, _)| *c == channel).map(|(_, unit)| *unit)
    }

    fn step(&self) -> f64 {
        sample_time(&self.record.time).max(1e-12)
    }
}

/// Another unit that the file of a test may use.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
struct Slip {
    /// Root mean square residual with the unit `likely`, as a natural logarithm of the force ratio.
    left: f64,
    channel: Channel,
    written: Unit,
    likely: Unit,
}

/// Rejects a campaign if some of its files likely use another unit than they state. A unit given by the user counts as
/// correct.
pub(crate) fn refuse(records: &[Record], readings: &HashMap<String, Reading<'_>>) -> Result<(), RecordError> {
    let seen: Vec<Seen<'_>> = records
        .iter()
        // No change of unit explains a force that consists of noise. The plausibility check reports that case.
        .filter(|record| !shows_noise_alone(record))
        .filter_map(|record| {
            let levels: Levels = levels(record, |_| true).into_iter().filter(|(_, l)| l.against > 0.0).collect();
            Some(Seen { record, reading: readings.get(&record.source)?, levels })
        })
        .filter(|seen| !seen.levels.is_empty())
        .collect();
    by_setting(seen).into_iter().try_for_each(|of_one| refuse_alike(&of_one, records.len()))
}

/// Groups the tests by the setting of an adjustable damper. Leaves out tests whose setting changes.
///
/// Tests at different settings are not compared, because their forces may differ by the ratio of two units.
fn by_setting(seen: Vec<Seen<'_>>) -> Vec<Vec<Seen<'_>>> {
    let mut groups: Vec<Vec<Seen<'_>>> = Vec::new();
    for test in seen.into_iter().filter(|test| test.record.setting_signal.is_none()) {
        let is_own = |group: &&mut Vec<Seen<'_>>| match (&group[0].record.setting, &test.record.setting) {
            (Some(a), Some(b)) => a.is_same(b),
            (None, None) => true,
            _ => false,
        };
        match groups.iter_mut().find(is_own) {
            Some(group) => group.push(test),
            None => groups.push(vec![test]),
        }
    }
    groups
}

/// Rejects tests of one damper at one setting if some likely use another unit. `all` is the number of tests read.
fn refuse_alike(seen: &[Seen<'_>], all: usize) -> Result<(), RecordError> {
    let agreeing = largest_agreeing(seen);
    if agreeing.len() < 2 {
        return Ok(());
    }
    let others = Others::new(agreeing.iter().map(|&i| &seen[i]).collect());
    let mut found: BTreeMap<(Channel, Unit, Vec<Unit>), Vec<&Seen<'_>>> = BTreeMap::new();
    for (i, test) in seen.iter().enumerate() {
        if agreeing.binary_search(&i).is_err()
            && let Some((channel, written, likely)) = slip(test, &others)
        {
            found.entry((channel, written, likely)).or_default().push(test);
        }
    }
    let Some(((channel, written, likely), tests)) = found.into_iter().max_by_key(|(_, tests)| tests.len()) else {
        return Ok(());
    };
    // The error reports the values of the deviating test with the largest force.
    let most = |test: &Seen<'_>| test.levels.values().map(|l| l.against).fold(0.0, f64::max);
    let Some(shown) = tests.iter().max_by(|a, b| most(a).total_cmp(&most(b))) else { return Ok(()) };
    let Some((level, beside)) = others.closest_levels(shown) else { return Ok(()) };
    Err(RecordError::FilesUnit(Box::new(FilesUnit {
        tests: tests.iter().map(|t| t.record.source.clone()).collect(),
        others: others.tests.iter().map(|t| t.record.source.clone()).collect(),
        all,
        shown: shown.record.name.clone(),
        at: (velocity(level), shown.levels[&level].against),
        expected: (velocity(beside), libm::exp(others.curve[&beside])),
        channel,
        written,
        likely,
    })))
}

/// Returns the indices of the largest set of tests that are connected by agreement of pairs. A set may have only one
/// test. The order is that of `seen`.
fn largest_agreeing(seen: &[Seen<'_>]) -> Vec<usize> {
    let mut set: Vec<usize> = (0..seen.len()).collect();
    fn root(set: &mut [usize], mut i: usize) -> usize {
        while set[i] != i {
            set[i] = set[set[i]];
            i = set[i];
        }
        i
    }
    for i in 0..seen.len() {
        for j in 0..i {
            let (a, b) = (root(&mut set, i), root(&mut set, j));
            if a != b && agree(&seen[i].levels, &seen[j].levels) {
                set[a.max(b)] = a.min(b);
            }
        }
    }
    let mut members: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for i in 0..seen.len() {
        members.entry(root(&mut set, i)).or_default().push(i);
    }
    // Of sets of equal size, use the set with the earliest test.
    members.into_values().rev().max_by_key(Vec::len).unwrap_or_default()
}

fn agree(one: &Levels, other: &Levels) -> bool {
    let mut ratios: Vec<f64> =
        one.iter().filter_map(|(k, l)| Some(libm::log(l.against / other.get(k)?.against))).collect();
    !ratios.is_empty() && median(&mut ratios).abs() < AGREE
}

/// The reference: tests that agree with each other, and their forces at each velocity.
struct Others<'a> {
    tests: Vec<&'a Seen<'a>>,
    /// Natural logarithm of the median force, N, against the motion, by velocity level.
    curve: BTreeMap<i32, f64>,
    /// Mean of the forces in rebound and compression, N, by velocity level: its median and its median absolute
    /// deviation between tests.
    between: BTreeMap<i32, (f64, f64)>,
}

impl<'a> Others<'a> {
    fn new(tests: Vec<&'a Seen<'a>>) -> Self {
        let mut at: BTreeMap<i32, [Vec<f64>; 2]> = BTreeMap::new();
        for (k, Level { against, between }) in tests.iter().flat_map(|test| &test.levels) {
            let [forces, middles] = at.entry(*k).or_default();
            forces.push(libm::log(*against));
            middles.push(*between);
        }
        let (mut curve, mut between) = (BTreeMap::new(), BTreeMap::new());
        for (k, [mut forces, mut middles]) in at {
            curve.insert(k, median(&mut forces));
            let middle = median(&mut middles);
            let scatter = median(&mut middles.iter().map(|m| (m - middle).abs()).collect::<Vec<_>>());
            between.insert(k, (middle, scatter));
        }
        Others { tests, curve, between }
    }

    /// Returns the logarithm of the typical force, interpolated between velocity levels. Returns `None` outside the
    /// levels of the reference.
    fn usual(&self, level: f64) -> Option<f64> {
        let (below, part) = (level.floor(), level - level.floor());
        // The level of every positive double is within the range of an i32.
        let low = self.curve.get(&(below as i32))?;
        if part < 1e-9 {
            return Some(*low);
        }
        Some(low + part * (self.curve.get(&(below as i32 + 1))? - low))
    }

    /// Returns the highest velocity level common to a test and the others, as a pair of equal levels. If there is no
    /// common level, returns the two closest levels.
    fn closest_levels(&self, test: &Seen<'_>) -> Option<(i32, i32)> {
        let pairs = test.levels.keys().flat_map(|k| self.curve.keys().map(move |other| (*k, *other)));
        pairs.min_by_key(|(k, other)| ((k - other).abs(), -k))
    }

    /// Returns the deviations of a test from the others at their common velocities, as logarithms of the force ratio.
    /// The test's forces and velocities are first scaled by the given factors.
    fn off(&self, test: &Seen<'_>, of_force: f64, of_velocity: f64) -> Vec<f64> {
        let shift = apart(of_velocity);
        let at = |(k, l): (&i32, &Level)| Some(libm::log(of_force * l.against) - self.usual(f64::from(*k) + shift)?);
        test.levels.iter().filter_map(at).collect()
    }

    /// Returns whether some other test at a common velocity has at most about the given amplitude, m. [`AS_LONG`] is
    /// the tolerance.
    fn are_as_short(&self, test: &Seen<'_>, amplitude: f64) -> bool {
        let with = |other: &&&Seen<'_>| test.levels.keys().any(|k| other.levels.contains_key(k));
        self.tests.iter().filter(with).any(|other| other.record.amplitude * AS_LONG <= amplitude)
    }

    /// Returns whether the mean force of the two directions contradicts a factor on the force. It does if the factor
    /// increases its deviation from the other tests beyond the acceptable one.
    fn gas_speaks_against(&self, test: &Seen<'_>, factor: f64) -> bool {
        let (mut as_read, mut otherwise, mut allowed) = (Vec::new(), Vec::new(), Vec::new());
        for (k, level) in &test.levels {
            let Some((middle, scatter)) = self.between.get(k) else { continue };
            as_read.push((level.between - middle).abs());
            otherwise.push((factor * level.between - middle).abs());
            allowed.push(CELL_OFFSET + OF_SCATTER * scatter);
        }
        let otherwise = median(&mut otherwise);
        otherwise > median(&mut as_read) && otherwise > median(&mut allowed)
    }
}

/// Returns the channel with a likely wrong unit, the unit as read, and the likely units. Returns `None` if no other
/// unit makes the test agree with the others.
fn slip(test: &Seen<'_>, others: &Others<'_>) -> Option<(Channel, Unit, Vec<Unit>)> {
    let mut as_read: Vec<f64> = others.off(test, 1.0, 1.0).iter().map(|off| off.abs()).collect();
    if as_read.len() >= FEWEST && median(&mut as_read) < OFF {
        return None;
    }
    let motion = if test.unit(Channel::Displacement).is_some() { Channel::Displacement } else { Channel::Velocity };
    let mut slips: Vec<Slip> = Vec::new();
    for channel in [Channel::Force, motion, Channel::Time] {
        let Some(written) = test.unit(channel).filter(|_| !test.reading.options.units.contains_key(&channel)) else {
            continue;
        };
        let units = Unit::ALL.into_iter().filter(|u| u.dimension() == written.dimension() && *u != written);
        slips.extend(units.filter_map(|likely| judged(test, others, channel, written, likely)));
    }
    let best = slips.iter().copied().min_by(|a, b| a.left.total_cmp(&b.left))?;
    let as_likely = slips.iter().filter(|s| s.channel == best.channel && s.left < best.left + AS_LIKELY);
    let mut likely: Vec<Unit> = as_likely.map(|s| s.likely).collect();
    likely.sort();
    Some((best.channel, best.written, likely))
}

/// Evaluates another unit of a channel. Returns `None` unless the test agrees with the others in that unit and the unit
/// is plausible.
fn judged(test: &Seen<'_>, others: &Others<'_>, channel: Channel, written: Unit, likely: Unit) -> Option<Slip> {
    let factor = likely.to_si(1.0) / written.to_si(1.0);
    let (of_force, of_velocity) = match channel {
        Channel::Force => (factor, 1.0),
        Channel::Time => (1.0, 1.0 / factor),
        _ => (1.0, factor),
    };
    let off = others.off(test, of_force, of_velocity);
    // The other tests must cover most velocities of the rescaled test, because only common velocities allow a
    // comparison.
    if off.len() < FEWEST || 2 * off.len() < test.levels.len() {
        return None;
    }
    let left = (off.iter().map(|o| o * o).sum::<f64>() / off.len() as f64).sqrt();
    let beyond = factor.max(1.0 / factor) >= BEYOND_DAMPERS;
    let amplitude =
        if channel == Channel::Displacement { factor * test.record.amplitude } else { test.record.amplitude };
    let steps = others.tests.iter().map(|t| libm::log(t.step()));
    let usual_step = median(&mut steps.collect::<Vec<_>>());
    let step = libm::log(test.step());
    let fits = match channel {
        Channel::Force => !others.gas_speaks_against(test, factor),
        // A wrong unit of time also changes the sampling, so the right unit moves the time step toward that of the
        // other tests. A wrong unit of displacement does not change the time step.
        Channel::Time => (step + libm::log(factor) - usual_step).abs() < (step - usual_step).abs(),
        _ => amplitude < LARGEST_AMPLITUDE,
    };
    let close = if beyond { CLOSE_BEYOND } else { CLOSE };
    (left < close && fits && (beyond || others.are_as_short(test, amplitude))).then_some(Slip {
        left,
        channel,
        written,
        likely,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::{Random, sine_record};

    /// Makes sines of (amplitude, peak velocity) on a damper with gas, friction and a mount that reduces the force of
    /// short strokes.
    fn campaign(strength: f64, tests: &[(f64, f64)]) -> Vec<Record> {
        let mut random = Random::new(7);
        let test = |(k, &(amplitude, speed)): (usize, &(f64, f64))| {
            // The damper is up to 30 % softer with warm oil, and softer in short strokes.
            let warm = 1.0 - 0.3 * random.uniform();
            let share = amplitude / (amplitude + 3e-4);
            let law = |v: f64| strength * if v > 0.0 { 1.6 * libm::pow(v, 0.8) } else { -0.8 * libm::pow(-v, 0.8) };
            sine_record(k, amplitude, speed, |_, v| warm * share * law(v) + 25.0 * libm::tanh(v / 0.002) - 180.0)
        };
        tests.iter().enumerate().map(test).collect()
    }

    const PLAN: [(f64, f64); 9] = [
        (0.025, 0.052),
        (0.025, 0.131),
        (0.025, 0.262),
        (0.025, 0.524),
        (0.01, 0.002),
        (0.01, 0.131),
        (0.01, 0.262),
        (0.002, 0.052),
        (0.0005, 0.131),
    ];

    fn times(record: &mut Record, channel: Channel, factor: f64) {
        let scale = |values: &mut Vec<f64>, by: f64| values.iter_mut().for_each(|v| *v *= by);
        match channel {
            Channel::Force => scale(&mut record.force, factor),
            Channel::Time => {
                scale(&mut record.time, factor);
                scale(&mut record.velocity, 1.0 / factor);
                record.peak_velocity /= factor;
            }
            _ => {
                scale(&mut record.displacement, factor);
                scale(&mut record.velocity, factor);
                record.amplitude *= factor;
                record.peak_velocity *= factor;
            }
        }
    }

    fn said(records: &[Record], options: &Options) -> String {
        let units = vec![
            (Channel::Time, Unit::Second),
            (Channel::Displacement, Unit::Millimetre),
            (Channel::Force, Unit::Newton),
        ];
        let readings = records.iter().map(|r| (r.source.clone(), Reading { units: units.clone(), options })).collect();
        refuse(records, &readings).map_or_else(|e| e.to_string(), |()| String::new())
    }

    #[test]
    fn tests_of_one_damper_pass_whatever_their_strokes_and_heat() {
        for strength in [100.0, 1000.0, 10_000.0] {
            assert_eq!(said(&campaign(strength, &PLAN), &Options::default()), "");
        }
        // The settings differ by a factor of four and a half in force. The gas force is the same.
        let mut records = campaign(2000.0, &PLAN);
        for record in campaign(450.0, &PLAN) {
            records.push(Record {
                name: format!("soft {}", record.name),
                source: format!("soft {}", record.source),
                ..record
            });
        }
        assert_eq!(said(&records, &Options::default()), "");
    }

    /// A semi-active damper without gas, whose settings differ in force by a typical ratio of two units. A file in kN
    /// is found by comparison with the tests at its own setting.
    #[test]
    fn settings_are_told_by_their_own_tests() {
        let at = |value: f64| {
            let setting = crate::quantities::setting_value::Setting { name: "current".into(), unit: "A".into(), value };
            campaign(450.0 * libm::pow(4.45, value), &PLAN[..6]).into_iter().map(move |mut record| {
                record.force.iter_mut().for_each(|f| *f += 180.0);
                let name = format!("{value} {}", record.name);
                Record { source: name.clone(), name, setting: Some(setting.clone()), ..record }
            })
        };
        let mut records: Vec<Record> = [0.0, 0.5, 1.0].into_iter().flat_map(at).collect();
        assert_eq!(said(&records, &Options::default()), "");
        times(&mut records[8], Channel::Force, 1e-3);
        let found = said(&records, &Options::default());
        assert!(found.contains("0.5 t2") && found.contains("speaks for kN written as N"), "{found}");
    }

    #[test]
    fn a_file_in_another_unit_is_named_with_the_unit() {
        for (channel, factor, likely) in [
            (Channel::Force, 1e-3, "speaks for kN written as N"),
            (Channel::Force, 0.1, "speaks for daN or kgf written as N"),
            (Channel::Force, 1.0 / 4.448, "speaks for lbf written as N"),
            (Channel::Displacement, 1.0 / 25.4, "speaks for in written as mm"),
            (Channel::Displacement, 0.1, "speaks for cm written as mm"),
            (Channel::Time, 1e3, "speaks for ms written as s"),
        ] {
            for at in [2, 3, 6] {
                let mut records = campaign(1500.0, &PLAN);
                times(&mut records[at], channel, factor);
                let message = said(&records, &Options::default());
                assert!(
                    message.contains(likely) && message.contains(&format!("t{at}.csv")),
                    "{channel} {factor} {at}: {message}"
                );
                assert!(message.contains(&format!("--unit {channel}=")), "{message}");
                let mut insisted = Options::default();
                insisted.units.insert(channel, if channel == Channel::Force { Unit::Newton } else { Unit::Millimetre });
                if channel == Channel::Force {
                    assert_eq!(said(&records, &insisted), "", "{factor}");
                }
            }
        }
    }

    #[test]
    fn where_half_of_them_are_off_both_are_named() {
        for from in [0, 4, 5] {
            let mut records = campaign(1500.0, &PLAN);
            records[from..].iter_mut().for_each(|r| times(r, Channel::Force, 1e-3));
            let message = said(&records, &Options::default());
            if from == 0 {
                // The plausibility check finds a unit that is wrong in all files.
                assert_eq!(message, "");
            } else {
                assert!(message.contains("t1.csv") && message.contains("t6.csv"), "{message}");
            }
        }
    }
}
