//! The open campaign: records from files, and prepared data of each test for the views.

use crate::session::progress::Report;
use dashpot_records::smoothing::{Motion, smooth};
use dashpot_records::{Campaign, Note, Options, Record, RecordError, load};
use dashpot_simulation::warm_starts::WarmStarts;
use rayon::prelude::*;
use std::ops::Range;
use std::path::PathBuf;

/// A campaign that was read from files, with prepared data of each test.
pub struct Loaded {
    /// Files and folders that the user opened.
    pub paths: Vec<PathBuf>,
    /// The common folder of the records, or `None` if they lie in several folders. It is determined during reading, because the folder
    /// may disappear later.
    pub folder: Option<PathBuf>,
    /// Options of reading, in addition to those of `campaign.toml`.
    pub options: Options,
    /// The records, with the measurement corrections if there are any.
    pub campaign: Campaign,
    /// Prepared data of each test, in the order of the records.
    pub tests: Vec<Seen>,
    /// Temperature, K, of the oil above the surroundings at the start of each test.
    pub warm: WarmStarts,
    /// The campaign before the measurement corrections, if corrections were applied.
    original: Option<Box<Campaign>>,
}

/// Prepared data of a test.
pub struct Seen {
    /// Smoothed motion, the input of the model.
    pub motion: Motion,
    /// Range of the plotted samples: one whole cycle, or all samples if the record has no cycles.
    pub shown: Range<usize>,
    /// The shown cycle as a thinned record, for a fast simulation while a slider moves.
    pub cycle: Record,
    /// Number of samples of `cycle` that belong to the shown cycle. One further sample follows if the record continues after the cycle.
    pub cycle_samples: usize,
    /// Decimation factor: `cycle` contains every `stride`-th sample of the record.
    pub stride: usize,
    /// Smoothed motion of `cycle`.
    pub cycle_motion: Motion,
    /// Largest measured force, N.
    pub max_force: f64,
    /// Velocity, m/s, and force, N, at the peak velocities in rebound and in compression.
    pub peaks: [[f64; 2]; 2],
}

impl Seen {
    fn new(record: &Record) -> Seen {
        let motion = smooth(record);
        let n = record.time.len();
        let shown = record.cycles.get(record.cycles.len() / 2).cloned().unwrap_or(0..n);
        // The sample after the cycle lets the simulation run the cycle once before it computes the shown forces. So the model reaches
        // steady state, as on whole records. A motion without cycles, such as a road, is not thinned, because its direction may change at
        // any sample.
        let stride = if record.cycles.is_empty() { 1 } else { shown.len().div_ceil(QUICK).max(1) };
        let mut taken: Vec<usize> = shown.clone().step_by(stride).collect();
        let cycle_samples = taken.len();
        taken.extend((shown.end < n).then_some(shown.end));
        let (cycle, cycle_motion) = part(record, &motion, &taken, cycle_samples);
        Seen {
            cycle,
            cycle_samples,
            stride,
            cycle_motion,
            max_force: record.force.iter().fold(0.0, |m, f| f.abs().max(m)),
            peaks: peaks(record, &motion),
            shown,
            motion,
        }
    }
}

/// Largest number of samples of a thinned cycle. More samples do not change the drawn loop visibly, and slow tests have thousands.
const QUICK: usize = 300;

/// Cuts a record and its motion to the samples `taken`. The first `cycle` of these samples are one cycle.
fn part(record: &Record, motion: &Motion, taken: &[usize], cycle: usize) -> (Record, Motion) {
    let cut = |values: &[f64]| taken.iter().map(|i| values[*i]).collect();
    #[expect(clippy::single_range_in_vec_init, reason = "one cycle is one range")]
    let cycles = if record.cycles.is_empty() { Vec::new() } else { vec![0..cycle] };
    let short = Record {
        time: cut(&record.time),
        displacement: cut(&record.displacement),
        velocity: cut(&record.velocity),
        force: cut(&record.force),
        side_force: record.side_force.as_deref().map(cut),
        temperature: record.temperature.as_deref().map(cut),
        setting_signal: record.setting_signal.as_ref().map(|of| of.select(taken.iter().copied())),
        cycles,
        amplitude: record.amplitude,
        frequency: record.frequency,
        peak_velocity: record.peak_velocity,
        mean_displacement: record.mean_displacement,
        ..Record::default()
    };
    let motion = Motion {
        displacement: cut(&motion.displacement),
        velocity: cut(&motion.velocity),
        acceleration: cut(&motion.acceleration),
        displacement_noise: motion.displacement_noise,
        velocity_noise: motion.velocity_noise,
    };
    (short, motion)
}

/// Fraction of the peak velocity above which [`peaks`] averages samples. For a sine, these are 3 % of the cycle at each velocity peak.
const FASTEST: f64 = 0.995;

/// Averages velocity, m/s, and force, N, of the fastest samples in rebound and in compression. A direction without motion gives NaN.
fn peaks(record: &Record, motion: &Motion) -> [[f64; 2]; 2] {
    let whole = match (record.cycles.first(), record.cycles.last()) {
        (Some(first), Some(last)) => first.start..last.end,
        _ => 0..record.time.len(),
    };
    [1.0, -1.0].map(|side| {
        let fastest = whole.clone().map(|i| side * motion.velocity[i]).fold(0.0, f64::max);
        let (mut count, mut sum) = (0.0, [0.0, 0.0]);
        for i in whole.clone().filter(|i| fastest > 0.0 && side * motion.velocity[*i] >= FASTEST * fastest) {
            count += 1.0;
            sum = [sum[0] + motion.velocity[i], sum[1] + record.force[i]];
        }
        if count > 0.0 { sum.map(|s| s / count) } else { [f64::NAN; 2] }
    })
}

impl Loaded {
    /// Reads files and folders.
    ///
    /// # Errors
    /// Returns the errors of [`load`].
    pub fn read(paths: Vec<PathBuf>, options: Options, progress: Report<'_>) -> Result<Loaded, RecordError> {
        let campaign = load(&paths, &options, &|p| progress(p.done as f64 / p.total.max(1) as f64, None))?;
        let tests = campaign.records.par_iter().map(Seen::new).collect();
        let mut folders: Vec<PathBuf> = paths.iter().map(|p| dashpot_records::profile::folder_of(p)).collect();
        folders.dedup();
        let folder = folders.pop().filter(|_| folders.is_empty());
        let warm = WarmStarts::new(&campaign.records.iter().collect::<Vec<_>>());
        Ok(Loaded { paths, folder, options, campaign, tests, warm, original: None })
    }

    /// Returns the campaign as read, without measurement corrections. A fit starts from these records.
    pub fn original(&self) -> &Campaign {
        self.original.as_deref().unwrap_or(&self.campaign)
    }

    /// Returns the campaign with other `records`: the corrected ones with the note on the corrections, or the original ones without a note.
    pub fn seen_as(&self, records: Vec<Record>, note: Option<Note>) -> Loaded {
        let mut campaign = self.original().clone();
        let original = note.is_some().then(|| Box::new(campaign.clone()));
        campaign.records = records;
        campaign.notes.extend(note);
        let tests = campaign.records.par_iter().map(Seen::new).collect();
        let (paths, folder, options) = (self.paths.clone(), self.folder.clone(), self.options.clone());
        let warm = WarmStarts::new(&campaign.records.iter().collect::<Vec<_>>());
        Loaded { paths, folder, options, campaign, tests, warm, original }
    }

    /// Returns whether another reading gave the same tests with the same samples. Settings and notes may differ.
    pub fn has_same_samples(&self, other: &Loaded) -> bool {
        let (own, others) = (&self.original().records, &other.original().records);
        let is_same = |(a, b): (&Record, &Record)| {
            a.name == b.name
                && a.time == b.time
                && a.displacement == b.displacement
                && a.velocity == b.velocity
                && a.force == b.force
                && a.side_force == b.side_force
                && a.temperature == b.temperature
        };
        own.len() == others.len() && own.iter().zip(others).all(is_same)
    }

    /// Formats the paths of the campaign as a list.
    pub fn named(&self) -> String {
        self.paths.iter().map(|p| p.display().to_string()).collect::<Vec<_>>().join(", ")
    }

    /// Finds the test whose amplitude, frequency and mean displacement are those of a test of another campaign. The mean displacements may
    /// differ by a tenth of the amplitude. Returns `None` if there is no such test.
    pub fn like(&self, wanted: &Record) -> Option<usize> {
        /// Largest relative difference of amplitude, and of frequency, between equal tests of two campaigns. The diagnosis against a
        /// reference uses the same value.
        const SAME: f64 = 0.05;
        let near = |a: f64, b: f64, scale: f64| (a - b).abs() <= SAME * scale.max(1e-9);
        self.campaign.records.iter().position(|r| {
            near(r.amplitude, wanted.amplitude, wanted.amplitude)
                && near(r.frequency, wanted.frequency, wanted.frequency)
                && near(r.mean_displacement, wanted.mean_displacement, wanted.amplitude.max(0.001) / SAME * 0.1)
        })
    }
}
