//! Labels that count from the other end of the settings, judged for all tests of a motion together.
//!
//! The tests of one motion at several settings show how the force depends on the setting. Two motions with common
//! velocities have the same dependence, because they are of one damper. If the labels of one motion count from the
//! other end, the dependence is the same after these labels are mirrored. A constant factor between the motions, such
//! as that of heat or of free play, does not matter.

use super::Seen;
use crate::numbers::median;
use crate::quantities::setting_value::{SAME, Setting};
use crate::tuning::deviating_tests::{LEAST_CONTRAST, OF_OWN, REPEATED, SAME_MOTION};
use std::collections::BTreeMap;

/// Tests of one motion.
struct Motion {
    /// Index of the setting and index of the test within the setting.
    tests: Vec<(usize, usize)>,
    /// Natural logarithms of the forces against the motion, N, of the tests at a setting, by velocity level and index
    /// of the setting. A repeated test adds a force.
    forces: BTreeMap<(i32, usize), Vec<f64>>,
}

/// Returns, for each setting, the index of the setting with the same distance from the other end. The values of the
/// settings are in ascending order.
///
/// An entry is `None` if no test has that setting, or if the settings of the campaign have several names.
pub(super) fn mirror(settings: &[Vec<Seen<'_>>]) -> Vec<Option<usize>> {
    let stated = |tests: &Vec<Seen<'_>>| tests[0].record.setting.clone();
    let all: Vec<Setting> = settings.iter().filter_map(stated).collect();
    let ends = all.first().zip(all.last()).filter(|(first, _)| all.iter().all(|of| of.name == first.name));
    let Some((first, last)) = ends else { return vec![None; settings.len()] };
    let is_at = |tests: &Vec<Seen<'_>>, value: f64| stated(tests).is_some_and(|of| (of.value - value).abs() < SAME);
    let partner = |own: Setting| settings.iter().position(|tests| is_at(tests, first.value + last.value - own.value));
    settings.iter().map(|tests| partner(stated(tests)?)).collect()
}

/// Returns the tests whose labels count from another end than those of most tests.
///
/// Each test is given by the index of its setting and its index within the setting. If half of the tests count from each end, the half without the first motion is returned.
pub(super) fn mirrored_tests(settings: &[Vec<Seen<'_>>], mirror: &[Option<usize>]) -> Vec<(usize, usize)> {
    let motions = motions(settings);
    let count = motions.len();
    // Disagreement of each pair of motions: with the labels as stated, and with those of one motion mirrored.
    let mut pairs: Vec<(usize, usize, [f64; 2])> = Vec::new();
    for a in 0..count {
        for b in a + 1..count {
            if let Some(of) = disagreements(&motions[a], &motions[b], mirror)
                && of[0].max(of[1]) > LEAST_CONTRAST
            {
                pairs.push((a, b, of));
            }
        }
    }
    let clear = |[as_stated, otherwise]: &[f64; 2]| libm::log((otherwise + REPEATED) / (as_stated + REPEATED));
    // Directions are assigned along the clearest pairs first. Each pair then joins two groups of motions or is ignored.
    pairs.sort_by(|x, y| clear(&y.2).abs().total_cmp(&clear(&x.2).abs()).then((x.0, x.1).cmp(&(y.0, y.1))));
    let mut group: Vec<usize> = (0..count).collect();
    let mut is_turned = vec![false; count];
    for (a, b, of) in &pairs {
        let (kept, joined) = (group[*a].min(group[*b]), group[*a].max(group[*b]));
        if kept == joined {
            continue;
        }
        let turns = (clear(of) < 0.0) != (is_turned[*a] != is_turned[*b]);
        for motion in (0..count).filter(|motion| group[*motion] == joined) {
            is_turned[motion] ^= turns;
        }
        group.iter_mut().filter(|of| **of == joined).for_each(|of| *of = kept);
    }
    // In each group, fewer tests are wrong than right. The first motion of a group is never turned up to here.
    for of in 0..count {
        let tests = |turned: bool| -> usize {
            let own = (0..count).filter(|motion| group[*motion] == of && is_turned[*motion] == turned);
            own.map(|motion| motions[motion].tests.len()).sum()
        };
        if tests(true) > tests(false) {
            (0..count).filter(|motion| group[*motion] == of).for_each(|motion| is_turned[motion] ^= true);
        }
    }
    // A motion is mirrored if that clearly lowers its disagreement with the others.
    let is_clear = |motion: usize| {
        let own = pairs.iter().filter(|(a, b, _)| *a == motion || *b == motion);
        let (mut now, mut before) = (0.0, 0.0);
        for (a, b, of) in own {
            let turned = usize::from(is_turned[*a] != is_turned[*b]);
            (now, before) = (now + of[turned], before + of[1 - turned]);
        }
        now < OF_OWN * before
    };
    let wrong = (0..count).filter(|motion| is_turned[*motion] && is_clear(*motion));
    let tests = wrong.flat_map(|motion| motions[motion].tests.iter().copied());
    tests.filter(|(setting, _)| mirror[*setting].is_some()).collect()
}

/// Groups the tests that state a setting by amplitude and peak velocity.
fn motions(settings: &[Vec<Seen<'_>>]) -> Vec<Motion> {
    let near = |a: f64, b: f64| (a - b).abs() <= SAME_MOTION * a.abs();
    let mut motions: Vec<Motion> = Vec::new();
    for (setting, tests) in settings.iter().enumerate() {
        for (place, test) in tests.iter().enumerate().filter(|(_, test)| test.record.setting.is_some()) {
            let is_same = |motion: &&mut Motion| {
                let (setting, place) = motion.tests[0];
                let first = settings[setting][place].record;
                near(first.amplitude, test.record.amplitude) && near(first.peak_velocity, test.record.peak_velocity)
            };
            match motions.iter_mut().find(is_same) {
                Some(motion) => motion.tests.push((setting, place)),
                None => motions.push(Motion { tests: vec![(setting, place)], forces: BTreeMap::new() }),
            }
        }
    }
    for motion in &mut motions {
        for (setting, place) in &motion.tests {
            for (level, of) in &settings[*setting][*place].levels {
                motion.forces.entry((*level, *setting)).or_default().push(libm::log(of.against));
            }
        }
    }
    motions
}

/// Returns the mean differences of the force ratios between settings of two motions, as natural logarithms.
///
/// The first value is that with the labels as stated, the second that with the labels of one motion mirrored. Both are of the same tests, because a mean over fewer tests may be smaller by chance. Returns `None` if the motions
/// share no velocity at two settings or more.
fn disagreements(one: &Motion, other: &Motion, mirror: &[Option<usize>]) -> Option<[f64; 2]> {
    // Differences of each velocity level, with the labels as stated and mirrored.
    let mut by_level: BTreeMap<i32, Vec<[f64; 2]>> = BTreeMap::new();
    for ((level, setting), forces) in &one.forces {
        let against = |place: usize| Some(median(&mut other.forces.get(&(*level, place))?.clone()));
        if let (Some(stated), Some(mirrored)) = (against(*setting), mirror[*setting].and_then(against)) {
            let differences = forces.iter().map(|force| [force - stated, force - mirrored]);
            by_level.entry(*level).or_default().extend(differences);
        }
    }
    by_level.retain(|_, of| of.len() >= 2);
    let count: usize = by_level.values().map(Vec::len).sum();
    let mean = |which: usize| -> f64 {
        let scatter = |of: &Vec<[f64; 2]>| -> f64 {
            let middle = median(&mut of.iter().map(|d| d[which]).collect::<Vec<_>>());
            of.iter().map(|d| (d[which] - middle).abs()).sum()
        };
        by_level.values().map(scatter).sum::<f64>() / count as f64
    };
    (count > 0).then(|| [mean(0), mean(1)])
}
