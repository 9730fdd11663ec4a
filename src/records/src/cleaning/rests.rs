//! Splits a record of several consecutive tests without a column that separates them. Rigs that run a list of tests
//! write such records.
//!
//! A standstill separates two tests if the motions before and after it differ. A pause between equal cycles does not
//! separate tests.

use super::cycles::{self, turning_points};
use crate::data::cycle::Cycle;
use crate::data::record::Note;
use crate::data::samples::Samples;
use crate::messages::phrases;
use crate::numbers::{median, quantile, quantum, range, sample_time};
use crate::signal::noise::difference_noise;
use crate::tuning::cleaning::FEWEST;
use crate::tuning::rests::{MARGIN, PIECES, REST, SAME_ENDS, SAME_SPEED, SPIKES, STILL, STILL_OF_RANGE, STROKE, TURN};
use dashpot_messages::Sentence;
use std::f64::consts::PI;
use std::ops::Range;

/// A motion between two standstills.
#[derive(Debug, Clone)]
struct Moves {
    samples: Range<usize>,
    low: f64,
    high: f64,
    /// Sum of the distances between turning points divided by the time between the first and the last, m/s.
    speed: f64,
    returns: bool,
    /// Whether the motion consists of strokes in one direction with standstills between the strokes.
    in_strokes: bool,
}

/// Splits a record into its tests and inserts a note about them before the other notes.
pub(crate) fn split(mut samples: Samples) -> Vec<Samples> {
    let Some(x) = samples.displacement.as_deref().filter(|x| x.iter().all(|x| x.is_finite())) else {
        return vec![samples];
    };
    // A channel that repeats its last value at standstill shows no noise. Its last digit and a fraction of its range
    // are therefore lower limits of the range that counts as standstill.
    let still = (STILL * difference_noise(x)).max(quantum(x)).max(STILL_OF_RANGE * range(x));
    let moving = between(&rests(&samples.time, x, still), x.len());
    if moving.len() < 2 {
        return vec![samples];
    }
    let (tests, found) = tests(&samples.time, x, moving, still);
    // If no motion is periodic, such as a road with stops, no criterion separates the tests, so the record stays one
    // test.
    if tests.len() < 2 || found.iter().all(Vec::is_empty) {
        return vec![samples];
    }
    let of = tests.len();
    samples.notes.insert(0, Note { kind: "rests", text: Sentence::from(phrases::AT_RESTS).with("count", of) });
    // A test without cycles keeps half of the standstill on either side, for the force at standstill. A test with
    // cycles keeps only its motion, because a later step would remove its standstill.
    let middle = |k: usize| match k {
        0 => 0,
        k if k == of => samples.len(),
        k => (tests[k - 1].samples.end + tests[k].samples.start) / 2,
    };
    (0..of)
        .map(|k| {
            let whole = middle(k)..middle(k + 1);
            let span = if found[k].is_empty() { whole } else { tests[k].samples.clone() };
            part(&samples, span, (k, of), &found[k], tests[k].high - tests[k].low)
        })
        .collect()
}

/// Makes a record of one test from a range of samples.
///
/// `place` is the index of the test, from 0, and `of` the number of tests. The name of the test contains the amplitude,
/// mm, and frequency, Hz, of its cycles, or half of `stroke` if the test has no cycles.
pub(super) fn part(
    samples: &Samples,
    span: Range<usize>,
    (place, of): (usize, usize),
    cycles: &[Cycle],
    stroke: f64,
) -> Samples {
    let (from, to) = (span.start, span.end);
    let mut piece = samples.piece(span);
    let mut strokes: Vec<f64> = cycles.iter().map(Cycle::stroke).collect();
    let stroke = if strokes.is_empty() { stroke } else { median(&mut strokes) };
    let (digits, amplitude) = (of.to_string().len(), 1e3 * 0.5 * stroke);
    piece.name = format!("{} {:0digits$} {}mm", samples.name, place + 1, figures(amplitude));
    let seconds: f64 = cycles.iter().map(Cycle::period).sum();
    if seconds > 0.0 {
        piece.name += &format!(" {}Hz", figures(cycles.len() as f64 / seconds));
    }
    let (begin, end) = (samples.time[from], samples.time[to - 1]);
    let part = format!("{} of {of}, {begin:.1} to {end:.1} s", place + 1);
    piece.at.part = Some(samples.at.part.as_ref().map_or(part.clone(), |p| format!("{p}, {part}")));
    piece
}

/// Formats a number to two significant digits for a name, or to a whole number if that has more digits.
fn figures(value: f64) -> String {
    let digits = (1.0 - libm::log10(value.abs().max(1e-6)).floor()).clamp(0.0, 6.0) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// Finds the ranges in which the damper stands still for about [`REST`] or longer. `still` is the largest range of a
/// standstill, m.
fn rests(time: &[f64], x: &[f64], still: f64) -> Vec<Range<usize>> {
    let length = ((REST / PIECES as f64 / sample_time(time).max(1e-9)).ceil() as usize).max(5);
    let mut rests: Vec<Range<usize>> = Vec::new();
    let mut run: Option<(Range<usize>, f64, f64)> = None;
    let end = |run: &mut Option<(Range<usize>, f64, f64)>, rests: &mut Vec<Range<usize>>| {
        if let Some((span, ..)) = run.take()
            && span.len() >= PIECES * length
        {
            rests.push(span);
        }
    };
    for from in (0..x.len() / length).map(|k| k * length) {
        let mut piece = x[from..from + length].to_vec();
        let (low, high) = (quantile(&mut piece, SPIKES), quantile(&mut piece, 1.0 - SPIKES));
        if let Some((span, lowest, highest)) = &mut run
            && high.max(*highest) - low.min(*lowest) <= still
        {
            (span.end, *lowest, *highest) = (from + length, low.min(*lowest), high.max(*highest));
            continue;
        }
        end(&mut run, &mut rests);
        run = (high - low <= still).then_some((from..from + length, low, high));
    }
    end(&mut run, &mut rests);
    rests
}

/// Returns the ranges between the standstills.
fn between(rests: &[Range<usize>], samples: usize) -> Vec<Range<usize>> {
    let ends = rests.iter().map(|r| r.start).chain([samples]);
    let starts = std::iter::once(0).chain(rests.iter().map(|r| r.end));
    starts.zip(ends).filter(|(from, to)| to > from).map(|(from, to)| from..to).collect()
}

/// Measures the motion in a range of samples. Returns `None` if the range of the motion is at most `still`, m, the
/// largest range of a standstill.
fn moves(time: &[f64], x: &[f64], span: Range<usize>, still: f64) -> Option<Moves> {
    // The search for standstills divides the record into blocks, so a range of motion may begin and end with still
    // samples. These are removed, except for a margin.
    let stands = |at: f64| move |i: &usize| (x[*i] - at).abs() <= still;
    let from = span.clone().find(|i| !stands(x[span.start])(i))?;
    let to = span.clone().rev().find(|i| !stands(x[span.end - 1])(i))? + 1;
    if to <= from {
        return None;
    }
    let span = from.saturating_sub(MARGIN).max(span.start)..(to + MARGIN).min(span.end);
    let inside = &x[span.clone()];
    // Spikes have not been removed yet. They are few among hundreds of samples, so quantiles exclude them.
    let spikes = (5.0 / inside.len() as f64).min(0.002);
    let ends = |q: f64| quantile(&mut inside.to_vec(), q);
    let (low, high) = (ends(spikes), ends(1.0 - spikes));
    if high - low <= still {
        return None;
    }
    let turns = turning_points(inside, STROKE * (high - low));
    let way: f64 = turns.windows(2).map(|w| (inside[w[1]] - inside[w[0]]).abs()).sum();
    let [first, last] = [turns.first(), turns.last()].map(|turn| time[span.start + turn.copied().unwrap_or(0)]);
    let seconds = last - first;
    let speed = if seconds > 0.0 { way / seconds } else { 0.0 };
    let returns = turns.len() >= 3;
    Some(Moves { samples: span, low, high, speed, returns, in_strokes: !returns })
}

impl Moves {
    fn is_like(&self, other: &Moves, still: f64) -> bool {
        let near = SAME_ENDS * (self.high - self.low).max(other.high - other.low) + still;
        let same_ends = (self.low - other.low).abs() <= near && (self.high - other.high).abs() <= near;
        // Strokes of one test may be fast in one direction and slow in the other.
        same_ends && (self.in_strokes && other.in_strokes || self.is_as_fast_as(other))
    }

    /// Returns whether a standstill of `rest` seconds is as short as the apparent standstill of this motion at its
    /// turning points.
    ///
    /// A sine of amplitude a and frequency f stays within the distance d of its turning point for the time sqrt(2 d /
    /// a) / (π f). Here d is `still`, m.
    fn only_turns(&self, rest: f64, still: f64) -> bool {
        let amplitude = 0.5 * (self.high - self.low);
        let frequency = self.speed / (4.0 * amplitude);
        rest * PI * frequency < TURN * (2.0 * still / amplitude).sqrt()
    }

    fn is_as_fast_as(&self, other: &Moves) -> bool {
        (self.speed - other.speed).abs() <= SAME_SPEED * self.speed.max(other.speed)
    }

    /// Returns whether a stroke lies within the range of this motion and has its speed.
    fn takes(&self, stroke: &Moves, still: f64) -> bool {
        let near = SAME_ENDS * (self.high - self.low) + still;
        stroke.low >= self.low - near && stroke.high <= self.high + near && self.is_as_fast_as(stroke)
    }
}

/// Returns the tests among the motions, and the whole cycles of each.
fn tests(time: &[f64], x: &[f64], moving: Vec<Range<usize>>, still: f64) -> (Vec<Moves>, Vec<Vec<Cycle>>) {
    let whole = |a: &Moves, b: &Moves| moves(time, x, a.samples.start..b.samples.end, still);
    // Join a motion that repeats the previous one. Strokes in one direction with a hold at each end thus become one
    // test. A slow motion with apparent standstills at its turning points also becomes one test.
    let mut runs: Vec<Moves> = Vec::new();
    for next in moving.into_iter().filter_map(|span| moves(time, x, span, still)) {
        let goes_on = |last: &&Moves| {
            let rest = last.samples.end..next.samples.start;
            let seconds = time[rest.end] - time[rest.start - 1];
            last.is_like(&next, still) || last.only_turns(seconds, still) || next.only_turns(seconds, still)
        };
        let joined = runs.last().filter(goes_on);
        match joined.and_then(|last| whole(last, &next)) {
            // The speed excludes the duration of the standstill between the two motions.
            Some(both) => {
                let last = runs.pop().unwrap_or_else(|| next.clone());
                let speed = 0.5 * (last.speed + next.speed);
                runs.push(Moves { speed, in_strokes: last.in_strokes && next.in_strokes, ..both });
            }
            None => runs.push(next),
        }
    }
    // A stroke in one direction moves the damper to the start of a test or away from its end, so it joins that test.
    let mut groups: Vec<Moves> = Vec::new();
    let mut way_in: Option<Moves> = None;
    for run in runs {
        let few = run.samples.len() < FEWEST;
        match groups.last_mut() {
            Some(last) if few || !run.returns && last.takes(&run, still) => last.samples.end = run.samples.end,
            _ if few || !run.returns => way_in = Some(way_in.take().unwrap_or(run)),
            _ => {
                let start = way_in.take().map_or(run.samples.start, |way| way.samples.start);
                groups.push(Moves { samples: start..run.samples.end, ..run });
            }
        }
    }
    if let (Some(way), Some(last)) = (way_in, groups.last_mut()) {
        last.samples.end = way.samples.end;
    }
    let mut found: Vec<Vec<Cycle>> = Vec::new();
    let mut tests: Vec<Moves> = Vec::new();
    for group in groups {
        let cycles = cycles::find(&time[group.samples.clone()], &x[group.samples.clone()]);
        match tests.last_mut() {
            // Two consecutive motions without cycles may be one test, so join them.
            Some(last) if cycles.is_empty() && found.last().is_some_and(Vec::is_empty) => {
                last.samples.end = group.samples.end;
                (last.low, last.high) = (last.low.min(group.low), last.high.max(group.high));
            }
            _ => {
                tests.push(group);
                found.push(cycles);
            }
        }
    }
    (tests, found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::{Random, moving};
    use std::f64::consts::TAU;

    /// A displacement, mm, that consists of pieces: standstills, sines (amplitude in mm, frequency in Hz, number of
    /// cycles) and moves to another position (mm, mm/s).
    struct Course {
        x: Vec<f64>,
        at: f64,
        rate: f64,
    }

    impl Course {
        fn new() -> Course {
            Course { x: Vec::new(), at: 0.0, rate: 500.0 }
        }

        fn rest(mut self, seconds: f64) -> Self {
            self.x.extend(std::iter::repeat_n(self.at, (seconds * self.rate) as usize));
            self
        }

        fn sine(mut self, amplitude: f64, frequency: f64, cycles: f64) -> Self {
            let n = (cycles / frequency * self.rate) as usize;
            self.x.extend((0..n).map(|i| self.at + amplitude * libm::sin(TAU * frequency * i as f64 / self.rate)));
            self
        }

        fn to(mut self, place: f64, speed: f64) -> Self {
            let n = ((place - self.at).abs() / speed * self.rate) as usize;
            self.x.extend((0..n).map(|i| self.at + (place - self.at) * i as f64 / n as f64));
            self.at = place;
            self
        }

        fn parts(self) -> Vec<Samples> {
            let mut random = Random::new(3);
            split(moving(self.rate, self.x.iter().map(|x| 1e-3 * x + 3e-6 * random.normal()).collect()))
        }

        fn names(self) -> Vec<String> {
            self.parts().into_iter().map(|part| part.name).collect()
        }
    }

    #[test]
    fn tests_one_after_the_other_are_told_apart_and_named() {
        let course = Course::new()
            .rest(3.0)
            .sine(25.0, 1.0, 5.0)
            .rest(3.0)
            .sine(25.0, 2.0, 6.0)
            .rest(2.0)
            // The repeated motion belongs to the same test.
            .sine(25.0, 2.0, 6.0)
            .rest(3.0)
            .sine(2.0, 8.0, 20.0)
            .rest(1.5)
            // The next motion begins after a move to another position. It is slow enough for apparent standstills at
            // its turning points.
            .to(20.0, 5.0)
            .rest(2.0)
            .sine(8.0, 0.02, 3.0)
            .rest(2.0);
        let n = course.x.len() - (18.0 * course.rate) as usize;
        let parts = course.parts();
        let names: Vec<&str> = parts.iter().map(|p| p.name.as_str()).collect();
        assert_eq!(names, ["long 1 25mm 1Hz", "long 2 25mm 2Hz", "long 3 2mm 8Hz", "long 4 8mm 0.02Hz"]);
        assert!(parts.iter().map(Samples::len).sum::<usize>() > n * 9 / 10);
        assert!(parts.windows(2).all(|w| w[0].time.last() < w[1].time.first()), "one clock goes on");
        assert!(parts[1].at.to_string().starts_with("long.txt (2 of 4, 1"), "{}", parts[1].at);
        assert!(parts.iter().all(|p| p.notes[0].kind == "rests"));
    }

    #[test]
    fn a_channel_that_holds_its_value_at_rest_is_split_too() {
        let course =
            Course::new().rest(2.0).sine(50.0, 0.5, 3.0).rest(2.0).sine(10.0, 2.0, 5.0).rest(2.0).sine(1.0, 5.0, 9.0);
        let mut random = Random::new(9);
        let mut held = 0.0;
        let x = course.rest(2.0).x;
        // Noise of some micrometers. At standstill, the value of the channel changes only every quarter of a second.
        let mut out = Vec::new();
        for (i, x) in x.iter().enumerate() {
            if *x != 0.0 || i % 125 == 0 {
                held = (1e3 * (x + 3e-3 * random.normal())).round() / 1e3;
            }
            out.push(1e-3 * held);
        }
        let parts = split(moving(500.0, out));
        let names: Vec<&str> = parts.iter().map(|p| p.name.as_str()).collect();
        assert_eq!(names, ["long 1 50mm 0.5Hz", "long 2 10mm 2Hz", "long 3 1mm 5Hz"]);
    }

    #[test]
    fn pauses_between_equal_cycles_part_nothing() {
        let mut dwell = Course::new();
        let mut strokes = Course::new();
        let mut stairs = Course::new();
        for k in 0..6 {
            dwell = dwell.rest(2.0).sine(10.0, 1.0, 1.0);
            strokes = strokes.to(10.0, 50.0).rest(2.0).to(-10.0, 5.0).rest(2.0);
            stairs = stairs.to(5.0 * f64::from(k), 20.0).rest(3.0);
        }
        for course in [dwell, strokes, stairs, Course::new().rest(5.0).sine(10.0, 1.0, 5.0).rest(5.0)] {
            assert_eq!(course.names(), ["long"]);
        }
        // The turning points of a slow sine are not standstills, even if the sine ends at one of them.
        for (frequency, cycles) in [(0.01, 2.0), (0.0146, 3.0), (0.0096, 2.3), (0.004, 1.6), (0.02, 4.75)] {
            for amplitude in [10.0, 60.0] {
                let course = Course::new().rest(2.0).sine(amplitude, frequency, cycles).rest(2.0);
                assert_eq!(course.names(), ["long"], "{amplitude} mm, {frequency} Hz, {cycles}");
            }
        }
    }

    #[test]
    fn a_road_with_stops_is_one_test() {
        let mut random = Random::new(5);
        let mut course = Course::new();
        for _ in 0..3 {
            course = course.rest(2.0);
            let waves: Vec<[f64; 3]> =
                (0..20).map(|k| [0.5 * 1.2_f64.powi(k), random.uniform(), random.uniform()]).collect();
            let n = (5.0 * course.rate) as usize;
            course.x.extend((0..n).map(|i| {
                let t = i as f64 / 500.0;
                let swing =
                    |w: &[f64; 3]| 5.0 * w[2] / w[0] * (libm::sin(TAU * (w[0] * t + w[1])) - libm::sin(TAU * w[1]));
                (t * (5.0 - t)).min(1.0) * waves.iter().map(swing).sum::<f64>()
            }));
        }
        assert_eq!(course.rest(2.0).names(), ["long"]);
    }

    /// Returns the range of the only standstill in a motion at 1000 samples per second, s, if it is found. `spikes` of
    /// its samples in each quarter of a second deviate.
    fn finds_rest(from: f64, to: f64, spikes: usize) -> bool {
        let time: Vec<f64> = (0..3000).map(|i| f64::from(i) / 1000.0).collect();
        let x: Vec<f64> = time
            .iter()
            .enumerate()
            .map(|(i, t)| match (from..to).contains(t) {
                true => {
                    if i % 250 < spikes {
                        5.0
                    } else {
                        0.0
                    }
                }
                false => 10.0 + libm::sin(TAU * 8.0 * t),
            })
            .collect();
        !rests(&time, &x, 0.01).is_empty()
    }

    #[test]
    fn a_standstill_longer_by_a_quarter_is_found_at_every_place() {
        assert!((0..10).all(|k| finds_rest(0.03 * f64::from(k), 1.251 + 0.03 * f64::from(k), 0)));
        assert!((0..10).any(|k| !finds_rest(0.03 * f64::from(k), 1.15 + 0.03 * f64::from(k), 0)));
    }

    #[test]
    fn a_few_spikes_are_no_motion() {
        assert!(finds_rest(0.5, 2.5, 3) && !finds_rest(0.5, 2.5, 8));
    }

    #[test]
    fn a_motion_keeps_two_still_samples_on_either_side() {
        let place = |i: usize| [0.0, 0.1, 0.2][usize::from(i >= 100) + usize::from(i >= 200)];
        let x: Vec<f64> = (0..300).map(place).collect();
        let time: Vec<f64> = (0..300).map(f64::from).collect();
        assert_eq!(moves(&time, &x, 0..300, 0.01).unwrap().samples, 98..202);
    }

    #[test]
    fn equal_motions_have_the_same_ends_within_a_tenth() {
        let to = |high: f64| Moves { samples: 0..9, low: 0.0, high, speed: 1.0, returns: true, in_strokes: false };
        assert!(to(0.1).is_like(&to(0.108), 0.0) && !to(0.1).is_like(&to(0.115), 0.0));
    }
}
