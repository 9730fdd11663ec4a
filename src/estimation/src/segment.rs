//! The stretches of record that a fit works on: clean motion, averaged force, a weight.

use crate::samples::road;
use dashpot_core::Input;
use dashpot_records::Record;
use dashpot_records::smoothing;
use rayon::prelude::*;

/// Samples that a cycle is thinned to.
const PER_CYCLE: usize = 160;
/// Windows per cycle over which the force is averaged, where the record is that dense. A wider window would blur the
/// knee of the FV curve by more than the noise that it removes.
const WINDOWS: usize = 400;
/// Samples of one test that a fit uses: as many whole cycles as fit.
const PER_TEST: usize = 400;
/// Share of a cycle that runs ahead of the first scored sample, so that the settled start is forgotten.
const LEAD_IN: f64 = 0.1;
/// Share of a test's largest force below which no model is expected to be right; it keeps clean tests from
/// outweighing all others.
const MODEL_FLOOR: f64 = 0.01;

/// One test, ready for a fit.
#[derive(Debug, Clone)]
pub struct Segment {
    /// Name of the test.
    pub name: String,
    /// Time from one sample to the next, s; the first is 0.
    pub dt: Vec<f64>,
    /// The motion, side force and temperature at the samples.
    pub input: Vec<Input>,
    /// Measured force, N.
    pub force: Vec<f64>,
    /// First sample whose force counts.
    pub from: usize,
    /// Force that one unit of weighted residual stands for, N.
    pub scale: f64,
    /// Largest measured force, N.
    pub top: f64,
    /// Peak velocity of the test, m/s.
    pub peak_velocity: f64,
    /// Amplitude, m.
    pub amplitude: f64,
}

/// Makes the segments of all records, in their order.
pub fn segments(records: &[&Record]) -> Vec<Segment> {
    records.par_iter().map(|r| segment(r)).collect()
}

fn segment(record: &Record) -> Segment {
    let n = record.time.len();
    let clean = smoothing::smooth(record);
    let (first, last, cycle) = match (record.cycles.first(), record.cycles.len()) {
        (None, _) => (0, n, n),
        (Some(first), count) => {
            let cycle = first.len().max(1);
            let thinned = cycle.div_ceil(stride_of(cycle));
            let wanted = (PER_TEST / thinned).clamp(1, count);
            // From the middle: the first cycles may still settle, the last may already stop.
            let skip = (count - wanted).div_ceil(2);
            (record.cycles[skip].start, record.cycles[skip + wanted - 1].end.min(n), cycle)
        }
    };
    let stride = if record.cycles.is_empty() { road::stride(record) } else { stride_of(cycle) };
    let lead = ((LEAD_IN * cycle as f64) as usize).max(2 * stride).min(first);
    let begin = first - lead / stride * stride;
    let picks: Vec<usize> = (begin..last).step_by(stride).collect();
    let mut from = picks.iter().position(|i| *i >= first).unwrap_or(0);
    if from * stride < (LEAD_IN * cycle as f64) as usize / 2 {
        from = (picks.len() / 20).max(1);
    }
    // Centred on the sample, with half weight at both ends where the count is even: any other window would shift the
    // force in time against the motion.
    let window = if record.cycles.is_empty() { 1 } else { (cycle / WINDOWS).max(1) };
    let average = |i: usize| {
        let half = (window / 2).min(i).min(n - 1 - i);
        if window % 2 == 1 || half == 0 {
            let around = &record.force[i - half..=i + half];
            return around.iter().sum::<f64>() / around.len() as f64;
        }
        let inner: f64 = record.force[i + 1 - half..i + half].iter().sum();
        (inner + 0.5 * (record.force[i - half] + record.force[i + half])) / (2 * half) as f64
    };
    let force: Vec<f64> = picks.iter().map(|i| average(*i)).collect();
    let at = |channel: &Option<Vec<f64>>, i: usize, or: f64| channel.as_ref().map_or(or, |c| c[i]);
    let top = force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
    let noise = record.noise.force_rms / (window as f64).sqrt();
    // The model goes through a road at the record's own rate; many samples of one record count like those of a test.
    let crowd = if record.cycles.is_empty() { (picks.len() as f64 / PER_TEST as f64).max(1.0).sqrt() } else { 1.0 };
    let dt: Vec<f64> =
        std::iter::once(0.0).chain(picks.windows(2).map(|w| record.time[w[1]] - record.time[w[0]])).collect();
    Segment {
        name: record.name.clone(),
        input: picks
            .iter()
            .map(|i| Input {
                displacement: Some(clean.displacement[*i]),
                velocity: clean.velocity[*i],
                side_force: at(&record.side_force, *i, 0.0),
                temperature: at(&record.temperature, *i, 20.0),
            })
            .collect(),
        dt,
        force,
        from,
        scale: crowd * (noise * noise + (MODEL_FLOOR * top).powi(2)).sqrt().max(1e-6),
        top,
        peak_velocity: record.peak_velocity,
        amplitude: record.amplitude,
    }
}

/// How many samples become one.
fn stride_of(cycle: usize) -> usize {
    (cycle / PER_CYCLE).max(1)
}
