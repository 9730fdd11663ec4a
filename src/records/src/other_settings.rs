//! Tests of one motion with another force: several dampers in one folder, or one damper at several settings (clicks of an adjuster, current
//! of a valve). One model cannot hold them, and of a fit to all of them nothing is true of any.

use super::at_speed::Levels;
use super::phrases;
use super::record::{Note, Record};
use super::samples::median;
use super::sentence::Sentence;

/// Share by which stroke and peak velocity of the same motion may differ, and by which part of its stroke its middle: drives keep them better.
const SAME: f64 = 0.1;
/// How many times the one's force against the motion must be the other's. Warm oil, a break-in and the rig's own scatter make a quarter.
const TIMES: f64 = 1.5;
/// Difference of side force, N, and of temperature, K, from which two tests of one damper may differ so much.
const SIDE_FORCE: f64 = 20.0;
const WARMER: f64 = 40.0;
/// Names that a sentence holds of each side.
const NAMES: usize = 6;

/// Notes tests that are the same motion as others and have another force; `seen` are their levels in the middle of the strokes.
pub(crate) fn tell(records: &[Record], seen: &[Levels], notes: &mut Vec<Note>) {
    let motions: Vec<Motion> = records.iter().map(Motion::of).collect();
    let (mut pairs, mut hard, mut soft) = (Vec::new(), Vec::new(), Vec::new());
    for (i, a) in motions.iter().enumerate() {
        for (j, b) in motions.iter().enumerate() {
            let Some(times) = a.is_like(b).then(|| times(&seen[i], &seen[j])).flatten() else { continue };
            if times > TIMES {
                pairs.push((times, i, j));
                hard.push(i);
                soft.push(j);
            }
        }
    }
    let Some((most, i, j)) = pairs.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)) else { return };
    for list in [&mut hard, &mut soft] {
        list.sort_unstable();
        list.dedup();
    }
    let names = |list: &[usize]| {
        let quoted = |i: &usize| Sentence::from(phrases::QUOTED).with("test", &records[*i].name);
        let named = Sentence::list(list.iter().take(NAMES).map(quoted).collect(), phrases::COMMA);
        match list.len().saturating_sub(NAMES) {
            0 => named,
            more => Sentence::from(phrases::AND_MORE).with_said("names", named).with("count", more),
        }
    };
    let text = Sentence::from(phrases::OTHER_SETTINGS)
        .with("first", &records[i].name)
        .with("second", &records[j].name)
        .with("times", format!("{most:.1}"))
        .with_said("hard", names(&hard))
        .with_said("soft", names(&soft));
    notes.push(Note { kind: "consistency", text });
}

/// How a test moves, where, under which load and how warm: in the mean.
struct Motion {
    amplitude: f64,
    peak_velocity: f64,
    is_periodic: bool,
    place: f64,
    side_force: Option<f64>,
    temperature: Option<f64>,
}

impl Motion {
    fn of(record: &Record) -> Motion {
        let mean = |values: &[f64]| values.iter().filter(|v| v.is_finite()).sum::<f64>() / values.len().max(1) as f64;
        Motion {
            amplitude: record.amplitude,
            peak_velocity: record.peak_velocity,
            is_periodic: record.frequency > 0.0,
            place: mean(&record.displacement),
            side_force: record.side_force.as_deref().map(mean),
            temperature: record.temperature.as_deref().map(mean),
        }
    }

    /// Whether another test moves alike, at the same place, under the same load and about as warm.
    fn is_like(&self, other: &Motion) -> bool {
        let alike = |a: f64, b: f64| a > 0.0 && b > 0.0 && (a - b).abs() <= SAME * a.max(b);
        let near = |a: Option<f64>, b: Option<f64>, within: f64| match (a, b) {
            (Some(a), Some(b)) => (a - b).abs() <= within,
            (None, None) => true,
            _ => false,
        };
        alike(self.amplitude, other.amplitude)
            && alike(self.peak_velocity, other.peak_velocity)
            && self.is_periodic == other.is_periodic
            && (self.place - other.place).abs() <= SAME * self.amplitude
            && near(self.side_force, other.side_force, SIDE_FORCE)
            && near(self.temperature, other.temperature, WARMER)
    }
}

/// How many times the one's force against the motion is the other's at their velocities; nothing where they share none.
fn times(a: &Levels, b: &Levels) -> Option<f64> {
    let both = a.iter().filter_map(|(level, a)| Some((a.against, b.get(level)?.against)));
    let mut ratios: Vec<f64> = both.filter(|(a, b)| *a > 0.0 && *b > 0.0).map(|(a, b)| a / b).collect();
    (!ratios.is_empty()).then(|| median(&mut ratios))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::at_speed::in_the_middle;
    use crate::fixtures::sine_record;

    /// The same sines with a damper of each of these strengths.
    fn campaign(strengths: &[f64]) -> Vec<Record> {
        let plan = [(0.02, 0.05), (0.02, 0.2), (0.005, 0.2), (0.02, 0.5)];
        let all = strengths.iter().flat_map(|strength| plan.map(|(amplitude, speed)| (*strength, amplitude, speed)));
        let test = |(k, (strength, amplitude, speed)): (usize, (f64, f64, f64))| {
            sine_record(k, amplitude, speed, |_, v| strength * 1500.0 * v + 20.0 * (v / 0.002).tanh() - 150.0)
        };
        all.enumerate().map(test).collect()
    }

    fn said(records: &[Record]) -> String {
        let mut notes = Vec::new();
        tell(records, &in_the_middle(records), &mut notes);
        notes.iter().map(|n| format!("[{}] {}\n", n.kind, n.text)).collect()
    }

    #[test]
    fn two_settings_in_one_folder_are_told_with_their_tests() {
        let text = said(&campaign(&[1.0, 4.0]));
        assert!(text.starts_with("[consistency] ") && text.contains("times"), "{text}");
        // The hard ones and the soft ones.
        for k in 0..8 {
            assert!(text.contains(&format!("t{k}")), "{k}: {text}");
        }
        // One odd test among many.
        let mut odd = campaign(&[1.0, 1.05, 0.95]);
        odd.push(campaign(&[1.0, 3.0]).pop().unwrap());
        assert!(said(&odd).contains("t7"), "{}", said(&odd));
    }

    #[test]
    fn one_damper_that_scatters_or_is_loaded_from_the_side_is_one() {
        assert_eq!(said(&campaign(&[1.0, 1.2, 0.9])), "");
        let mut loaded = campaign(&[1.0, 2.0]);
        for (k, record) in loaded.iter_mut().enumerate() {
            record.side_force = Some(vec![if k < 4 { 0.0 } else { 800.0 }; record.time.len()]);
        }
        assert_eq!(said(&loaded), "");
    }
}
