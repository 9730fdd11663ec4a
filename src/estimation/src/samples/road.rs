//! A test without cycles: a road signal.
//!
//! Parts of a long road are similar, and each of its steps costs as much as a step of a mean cycle. In a campaign of
//! many tests, the model therefore simulates only a few stretches of a road. Together, they cover its displacements and
//! velocities, beginning with the rare values.

use super::Test;
use super::sampling::Sampling;
use dashpot_records::Record;
use dashpot_records::smoothing::Motion;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Largest step of the model, s. A longer step would not resolve changes of the internal state between two scored
/// samples.
const STEP: f64 = 2e-3;
/// Largest number of steps of a road that is simulated whole. A record with more samples has longer steps.
const MOST: usize = 40_000;
/// Smallest number of scored samples of a road that is simulated whole, if it has enough samples.
const SCORED: usize = 1000;
/// Number of scored samples of a stretch: at least as many as a mean cycle has.
const STRETCH: usize = 150;
/// Number of samples of the lead-in of a stretch. An internal state with a time constant above 0.2 s keeps its initial
/// error. Such slow states belong to the temperature, which is an input, and to the gas.
const LEAD: usize = 100;
/// Numbers of cells of displacement and of velocity over the range of the road. With this number, the displacements at
/// an end stop have separate cells.
const CELLS: f64 = 10.0;
/// Number of tests that a record without cycles represents, because it has the amplitudes and speeds of several sines.
pub const ROAD: f64 = 4.0;

/// Cell in the grid of displacement and velocity.
type Cell = (i64, i64);

/// Extent of a road that is simulated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// The whole road, as one test.
    Whole,
    /// At most the given number of stretches.
    Stretches(usize),
    /// Every stretch from which [`Extent::Stretches`] chooses, each as a test.
    Every,
}

impl Extent {
    /// Target for the total number of stretches of all tests of a campaign. A single road is simulated whole, and each
    /// of many roads is simulated in a few stretches.
    const ENOUGH: usize = 60;
    /// Smallest number of stretches of a road.
    const FEWEST: usize = 4;

    /// Returns the extent of each road in a campaign of `records` records.
    pub fn in_campaign(records: usize) -> Extent {
        Extent::Stretches(Self::ENOUGH.div_ceil(records.max(1)).max(Self::FEWEST))
    }
}

/// Summary of the roads of a campaign that are simulated in stretches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shortened {
    /// Number of roads that are not simulated whole.
    pub roads: usize,
    /// Number of stretches of each road that is not simulated whole.
    pub stretches: usize,
    /// Length of a stretch without its lead-in, s.
    pub seconds: f64,
}

/// Summarizes the roads that are simulated in stretches. Returns `None` if there are no such roads.
pub fn shortened(tests: &[Test]) -> Option<Shortened> {
    let mut counts: BTreeMap<usize, (usize, f64)> = BTreeMap::new();
    for test in tests.iter().filter(|t| t.frequency == 0.0 && t.weight < ROAD) {
        let seconds = test.segment.dt[test.segment.from..].iter().sum();
        let (count, _) = counts.entry(test.record).or_insert((0, seconds));
        *count += 1;
    }
    let cut: Vec<(usize, f64)> = counts.into_values().filter(|(count, _)| *count > 1).collect();
    let (stretches, seconds) = *cut.first()?;
    Some(Shortened { roads: cut.len(), stretches, seconds })
}

/// Record without cycles, sampled at the steps of the model.
struct Road<'a> {
    place: usize,
    record: &'a Record,
    motion: &'a Motion,
    /// Sample indices of the record.
    picks: Vec<usize>,
    stride: usize,
}

/// Makes the tests of a record without cycles.
pub fn tests(place: usize, record: &Record, motion: &Motion, extent: Extent) -> Vec<Test> {
    let n = record.time.len();
    let step = (record.time[n - 1] - record.time[0]) / (n - 1).max(1) as f64;
    // Two steps of 1 ms count as 2 ms, despite the rounding of the clock.
    let stride = ((STEP / step.max(1e-9) + 1e-6) as usize).max(1);
    let road = |stride| Road { place, record, motion, picks: (0..n).step_by(stride).collect(), stride };
    if let Extent::Every = extent {
        let road = road(stride);
        return road.stretches().into_iter().map(|range| road.test(range, LEAD, 1, ROAD)).collect();
    }
    if let Extent::Stretches(most) = extent {
        let road = road(stride);
        let all = road.stretches();
        if most < all.len() {
            let chosen = choose(&road.cells(&all), most);
            let weight = ROAD / chosen.len() as f64;
            return chosen.into_iter().map(|k| road.test(all[k].clone(), LEAD, 1, weight)).collect();
        }
    }
    let road = road(stride.max(n.div_ceil(MOST)));
    let count = road.picks.len();
    let lead = (count / 20).max(1);
    vec![road.test(lead..count, lead, (count / SCORED).max(1), ROAD)]
}

impl Road<'_> {
    /// Returns adjacent stretches of the road. Before each stretch, there are enough steps for its lead-in.
    fn stretches(&self) -> Vec<Range<usize>> {
        let count = self.picks.len().saturating_sub(LEAD) / STRETCH;
        (0..count).map(|k| LEAD + k * STRETCH..LEAD + (k + 1) * STRETCH).collect()
    }

    /// Returns the cells of displacement and velocity in each stretch.
    fn cells(&self, stretches: &[Range<usize>]) -> Vec<BTreeSet<Cell>> {
        let (x, v) = (&self.motion.displacement, &self.motion.velocity);
        let (low, high) = x.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
        let top = v.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let cell = |value: f64, low: f64, high: f64| (CELLS * (value - low) / (high - low).max(1e-12)) as i64;
        let visited = |i: &usize| (cell(x[*i], low, high), cell(v[*i], -top, top));
        stretches.iter().map(|range| self.picks[range.clone()].iter().map(visited).collect()).collect()
    }

    /// Makes the test of a range of steps after `lead` steps of lead-in. One of `every` steps is scored.
    fn test(&self, range: Range<usize>, lead: usize, every: usize, weight: f64) -> Test {
        let picks = &self.picks[range.start - lead..range.end];
        let time = &self.record.time;
        let clock = self.record.clock_s + 0.5 * (time[picks[lead]] + time[picks[picks.len() - 1]]);
        let sampling = Sampling { picks, lead, apart: self.stride * every, clock, weight };
        sampling.test(self.place, self.record, self.motion, None, |k| k % every == 0)
    }
}

/// Chooses the stretches that cover the most cells, and returns their indices in increasing order. A cell counts more
/// if fewer stretches contain it.
fn choose(cells: &[BTreeSet<Cell>], most: usize) -> Vec<usize> {
    let mut visits: BTreeMap<Cell, f64> = BTreeMap::new();
    for cell in cells.iter().flatten() {
        *visits.entry(*cell).or_default() += 1.0;
    }
    let values: Vec<Vec<(Cell, f64)>> =
        cells.iter().map(|own| own.iter().map(|cell| (*cell, 1.0 / visits[cell])).collect()).collect();
    let (mut chosen, mut covered) = (BTreeSet::new(), BTreeSet::new());
    while chosen.len() < most {
        let gain =
            |k: &usize| values[*k].iter().filter(|(cell, _)| !covered.contains(cell)).map(|(_, v)| v).sum::<f64>();
        let left = || (0..cells.len()).filter(|k| !chosen.contains(k));
        let Some(best) = left().max_by(|a, b| gain(a).total_cmp(&gain(b)).then(b.cmp(a))) else { break };
        if gain(&best) == 0.0 && !covered.is_empty() {
            // When every cell is covered once, the next stretches cover the cells again.
            covered.clear();
            continue;
        }
        covered.extend(cells[best].iter().copied());
        chosen.insert(best);
    }
    chosen.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensitivity::forces;
    use dashpot_core::{Input, Model, Params};
    use dashpot_records::smoothing::smooth;

    /// Checks a record of a simulation of the kernel, sampled at 1 kHz for half a minute. With steps above [`STEP`], the
    /// model would not reproduce these forces.
    #[test]
    fn a_long_road_is_gone_through_at_its_own_rate() {
        let model = Model::new(&Params::new()).unwrap();
        let n = 30_000;
        let time: Vec<f64> = (0..n).map(|k| 1e-3 * k as f64).collect();
        let parts = [(0.02, 1.3, 0.1), (0.004, 6.1, 1.0), (0.0015, 13.7, 2.0)];
        let sum = |t: f64, of: fn(f64, f64, f64) -> f64| -> f64 {
            parts
                .iter()
                .map(|(a, f, phase)| of(*a, std::f64::consts::TAU * f, std::f64::consts::TAU * f * t + phase))
                .sum()
        };
        let displacement: Vec<f64> = time.iter().map(|t| sum(*t, |a, _, angle| a * libm::sin(angle))).collect();
        let velocity: Vec<f64> = time.iter().map(|t| sum(*t, |a, w, angle| a * w * libm::cos(angle))).collect();
        let mut record = Record {
            time,
            displacement,
            velocity,
            force: vec![0.0; n],
            amplitude: 0.02,
            peak_velocity: 0.4,
            ..Record::default()
        };
        let whole: Vec<Input> =
            record.displacement.iter().zip(&record.velocity).map(|(x, v)| Input::motion(*x, *v)).collect();
        let all = crate::segment::Segment {
            name: String::new(),
            dt: (0..n).map(|k| if k == 0 { 0.0 } else { 1e-3 }).collect(),
            input: whole,
            setting: None,
            force: vec![0.0; n],
            from: 0,
            scale: 1.0,
            top: 1.0,
            peak_velocity: 0.4,
            amplitude: 0.02,
            clock: 0.0,
        };
        record.force = forces(&model, &all);
        let test = &tests(0, &record, &smooth(&record), Extent::Whole)[0];
        let computed = forces(&model, &test.segment);
        let top = record.force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        let (mut sum, mut count) = (0.0, 0.0);
        for (k, _) in test.allowed.iter().enumerate().filter(|(_, a)| a.is_finite()) {
            let at = test.segment.from + k;
            sum += (computed[at] - test.segment.force[at]).powi(2);
            count += 1.0;
        }
        assert!(
            count > 0.9 * SCORED as f64 && f64::sqrt(sum / count) < 0.002 * top,
            "{} of {top}",
            f64::sqrt(sum / count)
        );
    }

    #[test]
    fn a_road_in_stretches_says_how_many_and_how_long() {
        let time: Vec<f64> = (0..30_000).map(|k| 1e-3 * f64::from(k)).collect();
        let phase = |t: &f64| 8.0 * t + 3.0 * libm::sin(0.7 * t);
        let displacement: Vec<f64> = time.iter().map(|t| 0.02 * libm::sin(phase(t))).collect();
        let velocity: Vec<f64> =
            time.iter().map(|t| 0.02 * (8.0 + 2.1 * libm::cos(0.7 * t)) * libm::cos(phase(t))).collect();
        let force: Vec<f64> = velocity.iter().map(|v| 2000.0 * v).collect();
        let (amplitude, peak_velocity) = (0.02, 0.2);
        let record = Record { time, displacement, velocity, force, amplitude, peak_velocity, ..Record::default() };
        let motion = smooth(&record);
        let both =
            [tests(0, &record, &motion, Extent::Stretches(4)), tests(1, &record, &motion, Extent::Whole)].concat();
        let cut = shortened(&both).unwrap();
        assert_eq!((cut.roads, cut.stretches), (1, 4));
        assert!((cut.seconds - 0.3).abs() < 0.01, "{cut:?}");
        assert_eq!(shortened(&both[4..]), None);
    }

    #[test]
    fn few_stretches_of_a_road_visit_its_rarest_cells_first() {
        let rare = BTreeSet::from([(9, 5)]);
        let common = || BTreeSet::from([(4, 5), (5, 5)]);
        let wide = BTreeSet::from([(4, 5), (5, 5), (6, 5), (3, 5)]);
        let cells = vec![common(), common(), rare, common(), wide, common()];
        assert_eq!(choose(&cells, 2), [2, 4]);
        assert_eq!(choose(&cells, 3), [0, 2, 4]);
        assert_eq!(choose(&cells, 9).len(), cells.len());
    }

    #[test]
    fn every_choice_of_stretches_is_among_all_stretches() {
        let n = 20_000;
        let time: Vec<f64> = (0..n).map(|k| 1e-3 * k as f64).collect();
        let displacement = time.iter().map(|t| 0.02 * libm::sin(7.0 * t) * libm::sin(0.31 * t)).collect();
        let velocity = vec![0.1; n];
        let record = Record { time, displacement, velocity, force: vec![1.0; n], amplitude: 0.02, ..Record::default() };
        let of = |extent| tests(0, &record, &smooth(&record), extent);
        let clocks: Vec<f64> = of(Extent::Every).iter().map(|test| test.segment.clock).collect();
        assert_eq!(clocks.len(), (n / 2 - LEAD) / STRETCH);
        let chosen = of(Extent::Stretches(4));
        assert!(chosen.len() == 4 && chosen.iter().all(|test| clocks.contains(&test.segment.clock)), "{clocks:?}");
    }

    #[test]
    fn a_road_among_many_tests_is_run_in_stretches_and_alone_whole() {
        let n = 16_000;
        let time: Vec<f64> = (0..n).map(|k| 1e-3 * k as f64).collect();
        // One peak of the largest displacement, in the fifteenth second.
        let bump = |t: f64| 0.03 * libm::exp(-((t - 15.2) / 0.05).powi(2));
        let displacement: Vec<f64> = time.iter().map(|t| 0.01 * libm::sin(11.0 * t) + bump(*t)).collect();
        let mut velocity: Vec<f64> = displacement.windows(2).map(|w| 1e3 * (w[1] - w[0])).collect();
        velocity.push(velocity[n - 2]);
        let (force, amplitude, peak_velocity) = (vec![0.0; n], 0.03, 0.5);
        let record = Record { time, displacement, velocity, force, amplitude, peak_velocity, ..Record::default() };
        let motion = smooth(&record);
        let highest = record.displacement.iter().copied().fold(0.0, f64::max);
        let few = tests(0, &record, &motion, Extent::in_campaign(40));
        assert_eq!(few.len(), Extent::FEWEST);
        assert!((few.iter().map(|t| t.weight).sum::<f64>() - ROAD).abs() < 1e-12);
        let top = |test: &Test| test.inputs().iter().filter_map(|i| i.displacement).fold(0.0, f64::max);
        // The comparison has a tolerance of the width of a cell.
        assert!(few.iter().map(top).fold(0.0, f64::max) > (1.0 - 1.0 / CELLS) * highest);
        assert!(few.iter().all(|t| t.count() == STRETCH && t.segment.from == LEAD));
        let steps = |tests: &[Test]| tests.iter().map(|t| t.segment.force.len()).sum::<usize>();
        let alone = tests(0, &record, &motion, Extent::in_campaign(1));
        assert!(steps(&few) < 1100 && steps(&alone) == n / 2 && alone.len() == 1, "{} {}", steps(&few), steps(&alone));
    }
}
