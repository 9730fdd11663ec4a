//! Finds labels that count the settings from the other end. All tests of one motion are judged together.
//!
//! The tests of one motion at several settings show how the force depends on the setting. Two motions with common
//! velocities have the same dependence, because they are of one damper. If the labels of one motion count from the
//! other end, the dependence is the same after these labels are mirrored. A constant factor between the motions, such
//! as that of heat or of free play, does not matter.

use super::Seen;
use crate::numbers::median;
use crate::quantities::setting_value::{SAME, Setting};
use crate::tuning::deviating_tests::{LEAST_CONTRAST, OF_OWN, REPEATED};
use std::collections::BTreeMap;

/// Tests with about the same motion: equal amplitude and peak velocity.
struct MotionTests {
    /// Index of the setting and index of the test within the setting.
    tests: Vec<(usize, usize)>,
    /// Natural logarithms of the forces against the motion, N. The key consists of the velocity level and the index of
    /// the setting. Each test at a setting adds one value.
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
/// Each test is stated by the index of its setting and its index within the setting. If half of the tests count from
/// each end, the half without the first motion is returned.
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
    // Process the clearest pairs first. Each pair joins two groups of motions, or is ignored if both motions are
    // already in one group.
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
    // At most half of the tests in a group are assumed to be wrong. So far, the first motion of each group counts as
    // right. If the turned motions have more tests, the other motions are turned instead.
    for of in 0..count {
        let tests = |turned: bool| -> usize {
            let own = (0..count).filter(|motion| group[*motion] == of && is_turned[*motion] == turned);
            own.map(|motion| motions[motion].tests.len()).sum()
        };
        if tests(true) > tests(false) {
            (0..count).filter(|motion| group[*motion] == of).for_each(|motion| is_turned[motion] ^= true);
        }
    }
    // A motion is returned only if mirroring its labels clearly reduces its disagreement with the other motions.
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
fn motions(settings: &[Vec<Seen<'_>>]) -> Vec<MotionTests> {
    let mut motions: Vec<MotionTests> = Vec::new();
    for (setting, tests) in settings.iter().enumerate() {
        for (place, test) in tests.iter().enumerate().filter(|(_, test)| test.record.setting.is_some()) {
            let is_same = |motion: &&mut MotionTests| {
                let (setting, place) = motion.tests[0];
                settings[setting][place].has_motion_of(test)
            };
            match motions.iter_mut().find(is_same) {
                Some(motion) => motion.tests.push((setting, place)),
                None => motions.push(MotionTests { tests: vec![(setting, place)], forces: BTreeMap::new() }),
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

/// Returns the disagreement of two motions in the dependence of the force on the setting, with the labels as stated and
/// mirrored.
///
/// The natural logarithm of the force ratio of the two motions would be equal at all settings without a disagreement.
/// The disagreement is its mean absolute deviation from its median at each velocity level. The second value is that
/// with the labels of one motion mirrored. Both values are computed from the same tests, because a mean over fewer
/// tests may be smaller by chance. Returns `None` if no velocity level has two or more ratios.
fn disagreements(one: &MotionTests, other: &MotionTests, mirror: &[Option<usize>]) -> Option<[f64; 2]> {
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
