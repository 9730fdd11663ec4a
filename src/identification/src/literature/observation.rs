//! Tests in the format of the models of the literature: motion, force, and the scale of the residual.
//!
//! Of the modules for models of the literature, only this one depends on the preparation of records. The others use the types of this
//! module.

use dashpot_estimation::segment::Segment;
use dashpot_records::Record;
use dashpot_records::smoothing::smooth;

/// Motion of the rig at the samples of a test.
#[derive(Debug, Clone, PartialEq)]
pub struct SampledMotion {
    /// Time from the preceding sample to each sample, s. The first value is 0.
    pub dt: Vec<f64>,
    /// Displacement, m.
    pub displacement: Vec<f64>,
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Index of a sample that lies one or more whole cycles after the first sample, if the motion is periodic. In the steady state, the
    /// internal state of a model is equal at both samples.
    pub returns: Option<usize>,
}

/// Test from which a model is identified.
#[derive(Debug, Clone)]
pub struct Observation {
    /// Name of the test.
    pub name: String,
    /// Motion of the rig.
    pub motion: SampledMotion,
    /// Measured force, N.
    pub force: Vec<f64>,
    /// Index of the first scored sample. The transient of a model decays during the samples before it.
    pub from: usize,
    /// Force error, N, that gives a weighted residual of 1.
    pub scale: f64,
}

/// Largest difference of two samples whole cycles apart at which a motion counts as periodic, as a fraction of the range of the motion.
const SAME: f64 = 0.05;

impl SampledMotion {
    /// Makes the smoothed motion of a record at its own samples.
    pub fn from_record(record: &Record) -> SampledMotion {
        let smoothed = smooth(record);
        let dt = std::iter::once(0.0).chain(record.time.windows(2).map(|w| w[1] - w[0])).collect();
        let returns = record.cycles.first().filter(|c| c.start == 0 && c.end < record.time.len()).map(|c| c.end);
        SampledMotion { dt, displacement: smoothed.displacement, velocity: smoothed.velocity, returns }
    }

    /// Simulates a model with internal state along the motion.
    ///
    /// A periodic motion first runs for one or more whole cycles from the state `rest`, so that the scored samples begin in the steady
    /// state. `step` advances the state from the preceding sample to a sample, and returns the force at that sample.
    pub(super) fn run<M: Clone>(&self, rest: M, step: impl Fn(&mut M, usize) -> f64) -> Vec<f64> {
        let mut memory = rest;
        if let Some(end) = self.returns {
            for i in 1..=end {
                step(&mut memory, i);
            }
        }
        (0..self.dt.len()).map(|i| step(&mut memory, i)).collect()
    }

    /// Returns the middle of the displacements, m: the mean of their 10 % and 90 % quantiles. The quantiles exclude the approach of the rig
    /// to its motion and its return.
    pub(super) fn middle(&self) -> f64 {
        let mut sorted = self.displacement.clone();
        sorted.sort_by(f64::total_cmp);
        let at = |share: f64| sorted[(share * (sorted.len() - 1) as f64) as usize];
        0.5 * (at(0.1) + at(0.9))
    }
}

/// Returns the lowest and the highest value.
pub(super) fn range(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)))
}

/// Makes the observations of a fit from records.
pub fn of_records(records: &[&Record]) -> Vec<Observation> {
    observations(&dashpot_estimation::samples::segments(records))
}

/// Makes the observations of a fit from segments.
pub fn observations(segments: &[Segment]) -> Vec<Observation> {
    segments.iter().map(observation).collect()
}

fn observation(segment: &Segment) -> Observation {
    let displacement: Vec<f64> = segment.input.iter().map(|i| i.displacement.unwrap_or(0.0)).collect();
    let velocity: Vec<f64> = segment.input.iter().map(|i| i.velocity).collect();
    // The scored samples, (length − `from`) in number, are whole cycles if the motion has any. So the sample with the index (length −
    // `from`) lies one or more whole cycles after the first sample.
    let returns = (displacement.len() - segment.from).min(displacement.len() - 1);
    let near = |values: &[f64]| {
        let (low, high) = range(values);
        (values[returns] - values[0]).abs() <= SAME * (high - low)
    };
    let periodic = returns > 0 && near(&displacement) && near(&velocity);
    Observation {
        name: segment.name.clone(),
        motion: SampledMotion { dt: segment.dt.clone(), displacement, velocity, returns: periodic.then_some(returns) },
        force: segment.force.clone(),
        from: segment.from,
        scale: segment.scale,
    }
}

/// Scales of forces and motions. The parameters of every model are identified relative to them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scales {
    /// Largest |force|, N.
    pub force: f64,
    /// Half the range of the displacements, m.
    pub displacement: f64,
    /// Middle of the range of the displacements, m.
    pub middle: f64,
    /// Largest |velocity|, m/s.
    pub velocity: f64,
}

impl Scales {
    /// Determines the scales from the scored samples of all tests.
    pub fn from_tests(tests: &[Observation]) -> Scales {
        let largest = |of: &dyn Fn(&Observation, usize) -> f64| {
            let all = tests.iter().flat_map(|t| (t.from..t.force.len()).map(move |i| (t, i)));
            all.fold(0.0f64, |m, (t, i)| m.max(of(t, i).abs()))
        };
        let all: Vec<f64> = tests.iter().flat_map(|t| t.motion.displacement[t.from..].iter().copied()).collect();
        let (low, high) = range(&all);
        Scales {
            force: largest(&|t, i| t.force[i]).max(1e-3),
            displacement: (0.5 * (high - low)).max(1e-6),
            middle: 0.5 * (low + high),
            velocity: largest(&|t, i| t.motion.velocity[i]).max(1e-6),
        }
    }
}
